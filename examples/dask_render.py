#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders one picture on the workers of a Dask cluster, in parts that are joined at the end.

    dask_render.py -o castle.png castle.json -s 1920x1080 --aa 4
    dask_render.py --scheduler tcp://head:8786 --parts 64 -o castle.png castle.json

Without --scheduler it starts worker processes on this machine. All workers need the scene and the folder of the parts
under the same names, as on a shared file system. If a worker dies, Dask gives its part to another one, which goes on
where the first one was. Debian: apt-get install python3-distributed.
"""
import argparse
import pathlib
import subprocess
import sys
import time

from dask.distributed import Client, LocalCluster, as_completed


def render_part(glint, number, parts, arguments, folder, threads):
    """Renders a part on a worker; returns its file."""
    tiles = f"{folder}/{number}-of-{parts}.tiles"
    command = [glint, "render", *arguments, "--part", f"{number}/{parts}", "-o", tiles, "--resume", "-q", "-t", str(threads)]
    while True:
        run = subprocess.run(command, stderr=subprocess.PIPE, text=True)
        # A worker that was killed may have left its glint, which will finish the part.
        if run.returncode == 0 or "in use by another process" not in run.stderr:
            break
        time.sleep(0.5)
    if run.returncode != 0:
        raise RuntimeError(f"part {number}/{parts}: {run.stderr.strip() or run.returncode}")
    return tiles


def main():
    parser = argparse.ArgumentParser(usage="%(prog)s [options] -o OUT SCENE... [options of glint render]")
    parser.add_argument("-o", "--output", required=True, help="the picture")
    parser.add_argument("--parts", type=int, help="default: 4 for each worker")
    parser.add_argument("--scheduler", help="address of a Dask scheduler; default: workers on this machine")
    parser.add_argument("--workers", type=int, default=2, help="worker processes on this machine; default: 2")
    parser.add_argument("--threads", type=int, default=1, help="threads of each glint; default: 1")
    parser.add_argument("--glint", default="glint", help="the command; default: glint")
    options, arguments = parser.parse_known_args()

    output = pathlib.Path(options.output).absolute()
    folder = output.parent / (output.name + ".parts")
    folder.mkdir(exist_ok=True)
    if options.scheduler:
        client = Client(options.scheduler)
    else:
        client = Client(LocalCluster(n_workers=options.workers, threads_per_worker=1, dashboard_address=None))
    workers = max(1, len(client.scheduler_info()["workers"]))
    parts = options.parts or 4 * workers
    # A part that fails is tried again: its machine may be at fault.
    futures = [
        client.submit(render_part, options.glint, number, parts, arguments, str(folder), options.threads,
                      retries=2, pure=False)
        for number in range(1, parts + 1)
    ]
    try:
        for done, future in enumerate(as_completed(futures), 1):
            future.result()
            print(f"{done} of {parts} parts", file=sys.stderr)
    except Exception as error:
        sys.exit(f"dask_render.py: {error}; the same command goes on with the parts in {folder}")
    tiles = [future.result() for future in futures]
    subprocess.run([options.glint, "join", *tiles, "-o", str(output)], check=True)
    for name in tiles:
        pathlib.Path(name).unlink()
    folder.rmdir()
    client.close()


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders all scenes of a folder with POV-Ray and with glint, and says of each how glint's picture stands.

    tests/peers/examples.py GLINT [--folder DIR] [--size 160x120] [--limit SECONDS] [--nice] [NAME...]

DIR is that of Debian's package povray-examples by default; a NAME is a part of a scene's path. Each scene is

    right    at least 99% of the pixels are within 2 of 255, and the mean difference is below 0.3
    warned   glint has warned that the picture differs; the columns say by how much
    refused  glint has named what it does not render, with line and column
    silent   the picture differs, and no warning says so
    broken   a crash, no answer within the limit, or a message without a place
    peer     POV-Ray itself has refused the scene, or took longer than the limit

No anti-aliasing. Both programs see a copy of the folder in build/examples; POV-Ray's pictures are kept there for the next run.
The table is written to build/examples/table.md. Exit code 1 if a scene is silent or broken."""
import argparse
import collections
import pathlib
import re
import shutil
import subprocess
import sys
import time

from run import read_ppm

FOLDER = "/usr/share/doc/povray/examples"
PLACE = re.compile(r":\d+:\d+: (error|warning): ")
DIFFERS = re.compile(r"warning: .*(the picture (will|may) differ|glint does not)")


def call(command, folder, limit):
    """Exit code (None after the limit) and what was printed."""
    try:
        done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=limit, check=False)
        return done.returncode, done.stdout.decode(errors="replace")
    except subprocess.TimeoutExpired:
        return None, ""


def difference(first, second):
    """The share of pixels within 2, and the mean difference; None if the sizes differ."""
    width, height, a = first
    if (width, height) != second[:2]:
        return None
    b = second[2]
    by_byte = [abs(x - y) for x, y in zip(a, b)]
    by_pixel = [max(by_byte[i:i + 3]) for i in range(0, len(by_byte), 3)]
    return sum(d <= 2 for d in by_pixel) / len(by_pixel), sum(by_byte) / len(by_byte)


class Examples:
    def __init__(self, options, top):
        self.options, self.top = options, top
        self.glint = pathlib.Path(options.glint).resolve()
        self.width, self.height = options.size.split("x")
        self.low = ["nice", "-n", "19"] if options.nice else []

    def peer_picture(self, scene):
        """The path of POV-Ray's picture, or what it has said instead."""
        picture = scene.with_suffix(f".{self.options.size}.peer.ppm")
        if picture.exists():
            return picture, ""
        code, text = call(self.low + ["povray", "+I" + scene.name, "+O" + picture.name, "+FP", "+W" + self.width,
                                      "+H" + self.height, "-A", "-D", "-P", "+WT1"], scene.parent, self.options.limit)
        if code == 0 and picture.exists():
            return picture, ""
        picture.unlink(missing_ok=True)
        if code is None:
            return None, f"no picture in {self.options.limit} s"
        lines = [line for line in text.splitlines() if "rror" in line]
        return None, lines[-1].strip() if lines else f"exit code {code}"

    def judge(self, scene):
        """The verdict, share and mean difference (or None), and what has been said."""
        own = scene.with_suffix(".own.ppm")
        own.unlink(missing_ok=True)
        code, text = call(self.low + [str(self.glint), "render", scene.name, "--format", "povray", "-s", self.options.size,
                                      "-o", own.name], scene.parent, self.options.limit)
        lines = text.splitlines()
        if code is None:
            return "broken", None, f"no answer in {self.options.limit} s"
        errors = [line for line in lines if "error: " in line]
        if code != 0:
            good = code > 0 and errors and all(PLACE.search(line) for line in errors)
            return "refused" if good else "broken", None, errors[0] if errors else f"exit code {code}"
        picture, why = self.peer_picture(scene)
        if picture is None:
            return "peer", None, why
        values = difference(read_ppm(picture), read_ppm(own))
        if values is None:
            return "broken", None, "pictures of different sizes"
        warnings = [line for line in lines if DIFFERS.search(line)]
        if values[0] >= 0.99 and values[1] < 0.3:
            return "right", values, warnings[0] if warnings else ""
        return "warned" if warnings else "silent", values, "; ".join(w.split(": ", 2)[-1] for w in warnings)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("glint")
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--folder", default=FOLDER, type=pathlib.Path)
    parser.add_argument("--size", default="160x120")
    parser.add_argument("--limit", default=20, type=float)
    parser.add_argument("--nice", action="store_true", help="at the lowest priority")
    options = parser.parse_intermixed_args()
    if shutil.which("povray") is None or not options.folder.is_dir():
        print(f"there is no povray, or no {options.folder} (Skipped)")
        return 0
    top = pathlib.Path(__file__).resolve().parents[2] / "build" / "examples"
    shutil.copytree(options.folder, top, dirs_exist_ok=True, copy_function=shutil.copyfile)
    examples = Examples(options, top)
    scenes = sorted(path.relative_to(top) for path in top.rglob("*.pov"))
    scenes = [s for s in scenes if not options.names or any(name in str(s) for name in options.names)]
    counts, rows = collections.Counter(), []
    for scene in scenes:
        start = time.monotonic()
        verdict, values, said = examples.judge(top / scene)
        counts[verdict] += 1
        figures = f"{100 * values[0]:.2f}% | {values[1]:.3f}" if values else " | "
        rows.append(f"| {scene} | {verdict} | {figures} | {said.replace('|', chr(92) + '|')} |")
        print(f"{verdict:8} {scene} {figures.replace(' |', '')} {said[:200]} ({time.monotonic() - start:.1f} s)", flush=True)
    head = ["| scene | | within 2 of 255 | mean difference | |", "|---|---|---|---|---|"]
    if not options.names:
        (top / "table.md").write_text("\n".join(head + rows) + "\n")
    print(", ".join(f"{n} {verdict}" for verdict, n in sorted(counts.items())) + f" of {len(scenes)}")
    return 1 if counts["silent"] or counts["broken"] else 0


if __name__ == "__main__":
    sys.exit(main())

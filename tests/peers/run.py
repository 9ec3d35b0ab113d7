#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders one small scene for each rule with POV-Ray or Tachyon and with glint, and compares the pixels.

    tests/peers/run.py GLINT [RULE...]

At least 99% of the pixels must differ by at most 1 of 255 in every channel. No anti-aliasing. The scenes of a failed rule and
the pictures stay in build/peers."""
import pathlib
import shutil
import subprocess
import sys

import lights

SHARE = 0.99
LISTS = [lights.RULES]


def read_ppm(path):
    """Width, height and the bytes of a binary PPM file with 8 bits a channel."""
    data = path.read_bytes()
    fields, at = [], 0
    while len(fields) < 4:
        end = at
        while not data[end:end + 1].isspace():
            end += 1
        if data[at:at + 1] == b"#":
            at = data.index(b"\n", at) + 1
            continue
        if end > at:
            fields.append(data[at:end])
        at = end + 1
    if fields[0] != b"P6" or fields[3] != b"255":
        raise ValueError(f"{path}: not a PPM file with 8 bits a channel")
    width, height = int(fields[1]), int(fields[2])
    return width, height, data[at:at + 3 * width * height]


def run(folder, *command):
    """Runs a program in the folder; its output goes to NAME.log there."""
    log = folder / (pathlib.Path(command[0]).name + ".log")
    with open(log, "wb") as out:
        code = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
                              timeout=120).returncode
    if code != 0:
        raise RuntimeError(f"{' '.join(command)}: exit code {code}\n{log.read_text(errors='replace')[-2000:]}")


def render_peer(folder, rule):
    width, height = str(rule.width), str(rule.height)
    if rule.program == "povray":
        (folder / "peer.pov").write_text(rule.peer)
        run(folder, "povray", "+Ipeer.pov", "+Opeer.ppm", "+FP", "+W" + width, "+H" + height, "-A", "-D", "-P")
    else:
        (folder / "peer.dat").write_text(rule.peer)
        run(folder, "tachyon", "peer.dat", "-fullshade", "-numthreads", "1", "-format", "PPM", "-o", "peer.ppm")
    return read_ppm(folder / "peer.ppm")


def render_glint(folder, rule, glint):
    (folder / "own.glint").write_text(rule.own)
    run(folder, str(glint), "render", "own.glint", "-s", f"{rule.width}x{rule.height}", "-o", "own.ppm", "--quiet")
    return read_ppm(folder / "own.ppm")


def compare(folder, rule, glint):
    """The share of pixels that agree, and the greatest difference."""
    width, height, peer = render_peer(folder, rule)
    own_width, own_height, own = render_glint(folder, rule, glint)
    if (width, height) != (own_width, own_height):
        raise ValueError(f"{width}x{height} and {own_width}x{own_height} pixels")
    if len(set(peer)) < 16:
        raise ValueError("the peer's picture has fewer than 16 different bytes")
    differences = [max(abs(peer[i + c] - own[i + c]) for c in range(3)) for i in range(0, len(peer), 3)]
    return sum(d <= 1 for d in differences) / len(differences), max(differences)


def main():
    glint = pathlib.Path(sys.argv[1]).resolve()
    wanted = sys.argv[2:]
    rules = [rule for rules in LISTS for rule in rules if not wanted or rule.name in wanted]
    top = pathlib.Path(__file__).resolve().parents[2] / "build" / "peers"
    failed = 0
    for rule in rules:
        if shutil.which(rule.program) is None:
            print(f"{rule.name}: there is no {rule.program} (Skipped)")
            continue
        folder = top / rule.name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        try:
            share, most = compare(folder, rule, glint)
            good = share >= SHARE
            print(f"{rule.name}: {'ok' if good else 'FAILED'}: {100 * share:.2f}% of the pixels within 1, at most {most}")
        except (OSError, RuntimeError, ValueError, subprocess.TimeoutExpired) as error:
            good = False
            print(f"{rule.name}: FAILED: {error}")
        failed += not good
        sys.stdout.flush()
    print(f"{100 * (len(rules) - failed) // max(1, len(rules))}% tests passed, {failed} tests failed out of {len(rules)}")
    return 1 if failed or not rules else 0


if __name__ == "__main__":
    sys.exit(main())

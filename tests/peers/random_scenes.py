#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders random scenes of what glint reads with POV-Ray or Tachyon and with glint, and compares the pixels.

    tests/peers/random_scenes.py GLINT [--count N] [--seed S] [--program povray|tachyon] [--language] [--within D]

The same seed gives the same scenes. A scene of which less than 99% of the pixels are within D (2) of 255 is printed, with
glint's warnings; one without a warning is a failure. The failed scenes and their pictures stay in build/peers/random."""
import argparse
import pathlib
import random
import shutil
import subprocess
import sys

import random_povray
import random_povray_language
import random_tachyon
import random_tachyon_language
import run

SIZE = random_tachyon.SIZE
SHARE = 0.99


def render(folder, scene, glint):
    """The pictures of both programs, and glint's messages."""
    width, height = map(str, SIZE)
    if scene.program == "povray":
        run.run(folder, "povray", "+Ipeer.pov", "+Opeer.ppm", "+FP", "+W" + width, "+H" + height, "-A", "-D", "-P")
    else:
        run.run(folder, "tachyon", "peer.dat", "-numthreads", "1", "-format", "PPM", "-o", "peer.ppm")
    command = [str(glint), "render", scene.name, "--format", scene.program, "-s", f"{width}x{height}", "-o", "own.ppm"]
    own = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120)
    if own.returncode != 0:
        raise RuntimeError(own.stderr)
    warnings = [line for line in own.stderr.splitlines() if "warning: " in line]
    return run.read_ppm(folder / "peer.ppm")[2], run.read_ppm(folder / "own.ppm")[2], warnings


def compare(peer, own, within):
    differences = [max(abs(peer[i + c] - own[i + c]) for c in range(3)) for i in range(0, len(peer), 3)]
    return sum(d <= within for d in differences) / len(differences), max(differences)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("glint", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--program", choices=("povray", "tachyon"))
    parser.add_argument("--language", action="store_true", help="scenes that use more of the language than shapes in a row")
    parser.add_argument("--within", type=int, default=2)
    arguments = parser.parse_args()
    glint = arguments.glint.resolve()
    top = pathlib.Path(__file__).resolve().parents[2] / "build" / "peers" / "random"
    counts = {"alike": 0, "warned of": 0, "different": 0, "failed": 0}
    written = (random_povray.Pov, random_tachyon.Dat)
    if arguments.language:
        written = (random_povray_language.PovLanguage, random_tachyon_language.DatLanguage)
    kinds = [kind for kind in written if arguments.program in (None, kind.program) and shutil.which(kind.program)]
    for number in range(arguments.count if kinds else 0):
        seed = arguments.seed * 100000 + number
        scene = kinds[number % len(kinds)](random.Random(seed))
        name = f"{scene.program}_{seed}"
        folder = top / name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        (folder / scene.name).write_text(scene.text())
        try:
            peer, own, warnings = render(folder, scene, glint)
            share, most = compare(peer, own, arguments.within)
        except (OSError, RuntimeError, ValueError, subprocess.TimeoutExpired) as error:
            counts["failed"] += 1
            print(f"{name}: FAILED: {error}", flush=True)
            continue
        if share >= SHARE:
            counts["alike"] += 1
            shutil.rmtree(folder)
            continue
        counts["warned of" if warnings else "different"] += 1
        print(f"{name}: {100 * share:.2f}% within {arguments.within}, at most {most}; {' '.join(warnings) or 'no warning'}", flush=True)
    print(", ".join(f"{count} {kind}" for kind, count in counts.items()))
    return 1 if counts["different"] or counts["failed"] or not kinds else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders one small scene for each rule with POV-Ray or Tachyon and with glint, and compares the pixels.

    tests/peers/run.py GLINT [RULE...]

At least 99% of the pixels, or Rule.share, must differ by at most 1 of 255 in every channel. No anti-aliasing. The scenes of a failed rule and
the pictures stay in build/peers."""
import pathlib
import shutil
import subprocess
import sys
import zlib

import alpha
import averages
import dat
import fading
import finish
import fog
import height_fields
import images
import layers
import lights
import mesh_solids
import output
import patterns
import pov
import quadrics
import quartics
import refraction
import sky
import solids
import sweeps
import tachyon_textures
import texts
import tori
import transparency

LISTS = [lights.RULES, fog.RULES, alpha.RULES, finish.RULES, transparency.RULES, sky.RULES, output.RULES, dat.RULES, pov.RULES,
         images.RULES, layers.RULES, averages.RULES, patterns.RULES, quadrics.RULES, quartics.RULES, refraction.RULES, fading.RULES, solids.RULES, mesh_solids.RULES, sweeps.RULES,
         height_fields.RULES, tori.RULES, texts.RULES, tachyon_textures.RULES]


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


def read_png(path):
    """Width, height and the bytes of a PNG file with 8 bits a channel and alpha, the colors multiplied by alpha."""
    data = path.read_bytes()
    at, packed, width, height = 8, b"", 0, 0
    while at < len(data):
        length, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        content = data[at + 8:at + 8 + length]
        at += length + 12
        if kind == b"IHDR":
            width, height = (int.from_bytes(content[i:i + 4], "big") for i in (0, 4))
            if content[8:13] != bytes((8, 6, 0, 0, 0)):
                raise ValueError(f"{path}: not a PNG file with 8 bits a channel and alpha")
        elif kind == b"IDAT":
            packed += content
    rows, size, above, pixels = zlib.decompress(packed), 4 * width, bytes(4 * width), bytearray()
    for y in range(height):
        kind, row = rows[y * (size + 1)], bytearray(rows[y * (size + 1) + 1:(y + 1) * (size + 1)])
        for i in range(size):
            left, corner = (row[i - 4], above[i - 4]) if i >= 4 else (0, 0)
            up = above[i]
            distance = [abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)]
            paeth = (left, up, corner)[distance.index(min(distance))]
            row[i] = (row[i] + (0, left, up, (left + up) // 2, paeth)[kind]) & 255
        above = row
        for i in range(0, size, 4):
            pixels += bytes((c * row[i + 3] + 127) // 255 for c in row[i:i + 3]) + row[i + 3:i + 4]
    return width, height, bytes(pixels)


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
        output = ("+Opeer.png", "+FN", "+UA") if rule.alpha else ("+Opeer.ppm", "+FP")
        run(folder, "povray", "+Ipeer.pov", *output, "+W" + width, "+H" + height, "-A", "-D", "-P")
        if rule.alpha:
            return read_png(folder / "peer.png")
    else:
        (folder / "peer.dat").write_text(rule.peer)
        run(folder, "tachyon", "peer.dat", "-numthreads", "1", "-format", "PPM", "-o", "peer.ppm", *rule.flags)
    return read_ppm(folder / "peer.ppm")


def render_glint(folder, rule, glint):
    own, of_peer = "own.glint", ()
    if rule.own:
        (folder / own).write_text(rule.own)
    else:  # glint reads the peer's own file
        own = "peer.pov" if rule.program == "povray" else "peer.dat"
        of_peer = ("--format", rule.program)
    output = ("-o", "own.png", "--alpha") if rule.alpha else ("-o", "own.ppm")
    run(folder, str(glint), "render", own, "-s", f"{rule.width}x{rule.height}", *output, "--quiet",
        *of_peer, *rule.args)
    return read_png(folder / "own.png") if rule.alpha else read_ppm(folder / "own.ppm")


def compare(folder, rule, glint):
    """The share of pixels that agree, and the greatest difference."""
    width, height, peer = render_peer(folder, rule)
    own_width, own_height, own = render_glint(folder, rule, glint)
    if (width, height) != (own_width, own_height):
        raise ValueError(f"{width}x{height} and {own_width}x{own_height} pixels")
    if len(set(peer)) < 16:
        raise ValueError("the peer's picture has fewer than 16 different bytes")
    channels = 4 if rule.alpha else 3
    differences = [max(abs(peer[i + c] - own[i + c]) for c in range(channels)) for i in range(0, len(peer), channels)]
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
        for name, data in rule.files.items():
            (folder / name).write_bytes(data)
        try:
            share, most = compare(folder, rule, glint)
            good = share >= rule.share
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

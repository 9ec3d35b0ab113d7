#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks mistakes.json against the tracers beside it: each mistake of a tracer is listed, changes the picture, and the first line
of the log that differs from the log without the mistake has a key that mistakes.json names, in at least one pixel.

    check_fixtures.py [TRACER...]        prints, for each mistake, the pixels that differ, by how much, and the first keys
"""
import collections
import json
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
SIZES = {"tracer.py": (60, 60), "tracer.c": (120, 90), "tracer.mjs": (120, 90)}


def command_of(tracer, folder):
    source = os.path.join(HERE, tracer)
    if tracer.endswith(".py"):
        return [sys.executable, source]
    if tracer.endswith(".mjs"):
        return ["node", source]
    program = os.path.join(folder, "tracer")
    subprocess.run(["cc", "-std=c99", "-O1", "-ffp-contract=off", "-Wall", "-Wextra", "-o", program, source, "-lm"], check=True)
    return [program]


def run(command, size, mistake, entry, pixels, log):
    environment = dict(os.environ, MISTAKE=mistake, GLINT_LOG=log, GLINT_PIXELS=";".join(f"{x},{y}" for x, y in pixels))
    environment["SHADING"] = entry.get("shading", "")
    scene = [os.path.join(HERE, "../..", entry["scene"])] if "scene" in entry else []
    ppm = subprocess.run(command + [str(n) for n in size] + scene, env=environment, stdout=subprocess.PIPE, check=True).stdout
    return ppm.split(b"\n", 3)[3]


def logs_of(path):
    with open(path, encoding="utf-8") as text:
        parts = re.split(r"(?m)^pixel ", text.read())
    return {tuple(int(n) for n in part.split("\n", 1)[0].split()): part.split("\n")[1:] for part in parts[1:]}


def first_key(right, wrong):
    """The key of the first line that differs, and `ray KIND` before it."""
    ray = ""
    for a, b in zip(right, wrong):
        if a != b:
            key, other = a.split()[0], b.split()[0]
            return (key if key == other else f"{other} for {key}") + (f" ({ray})" if ray not in ("", "camera") and key != "bytes" else "")
        if b.startswith("ray ") and b != "ray shadow":
            ray = b.split()[1]
    return "nothing"


def check(tracer, listed, folder):
    failures, size, command = 0, SIZES[tracer], command_of(tracer, folder)
    log = os.path.join(folder, "log")
    names = subprocess.run(command + ["--list"], stdout=subprocess.PIPE, check=True, text=True).stdout.split()
    pictures = {}
    for name in sorted(set(names) | set(listed)):
        if name not in names:
            print(f"FAILED {tracer} {name}: the tracer does not have it")
            failures += 1
            continue
        entry = listed.get(name, {})
        variant = entry.get("scene"), entry.get("shading")
        if variant not in pictures:
            pictures[variant] = run(command, size, "", entry, [], log)
        right, wrong = pictures[variant], run(command, size, name, entry, [], log)
        worst = [max(abs(right[i + c] - wrong[i + c]) for c in range(3)) for i in range(0, len(right), 3)]
        order = sorted((i for i, v in enumerate(worst) if v), key=lambda i: -worst[i])
        chosen = order[:: max(1, len(order) // 24)][:24]
        pixels = [(i % size[0], i // size[0]) for i in chosen]
        keys = collections.Counter()
        if pixels:
            run(command, size, "", entry, pixels, log)
            with_right = logs_of(log)
            run(command, size, name, entry, pixels, log)
            with_wrong = logs_of(log)
            keys.update(first_key(with_right[p], with_wrong[p]) for p in pixels)
        found = ", ".join(f"{key} {n}" for key, n in keys.most_common(4))
        print(f"{tracer} {name}: {len(order)} pixels, by at most {max(worst)}; first: {found}")
        expected = {entry.get("first"), *entry.get("or", [])}
        if not order or not any(expected & set(key.split()) for key in keys):
            print(f"FAILED {tracer} {name}: mistakes.json: {entry}")
            failures += 1
    return failures


def main():
    with open(os.path.join(HERE, "mistakes.json"), encoding="utf-8") as text:
        mistakes = json.load(text)
    with tempfile.TemporaryDirectory() as folder:
        failures = sum(check(tracer, mistakes.get(tracer, {}), folder) for tracer in sys.argv[1:] or sorted(SIZES))
    sys.exit(1 if failures else 0)


main()

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds the mistakes of mistakes.json by the logs of the tracers beside it.

    find_mistakes.py GLINT [TRACER...]      of each mistake: the quantity that differs first, and its cause

`first` and `or` are the quantities that may be named as the first one. `id` is the cause: it must be found as sure if it is
there, and no other one may be sure. A tracer without a mistake has no finding."""
import concurrent.futures
import json
import os
import random
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
SCENES = {"tracer.c": HERE + "/room.glint", "tracer.py": HERE + "/../../scenes/cgfs/three_mirrors.cgfs", "tracer.mjs": HERE + "/../../scenes/epfl/three_lights.json"}
SIZES = {"tracer.py": (60, 60), "tracer.c": (120, 90), "tracer.mjs": (120, 90)}


def command_of(tracer, folder):
    source = os.path.join(HERE, tracer)
    if tracer == "tracer.py":
        return [sys.executable, source]
    if tracer == "tracer.mjs":
        return ["node", source]
    program = os.path.join(folder, "tracer")
    subprocess.run(["cc", "-std=c99", "-O1", "-ffp-contract=off", "-o", program, source, "-lm"], check=True)
    return [program]


def random_pixels(count, size):
    chosen = random.Random(1)
    return ";".join(f"{chosen.randrange(size[0])},{chosen.randrange(size[1])}" for _ in range(count))


def diagnosis(glint, tracer, command, name, entry, folder):
    """The answer of glint for a mistake: logged at the pixels that glint proposes, and at twelve others."""
    size = SIZES[tracer]
    scene = os.path.join(HERE, "../..", entry["scene"]) if "scene" in entry else SCENES[tracer]
    arguments = command + [str(n) for n in size] + ([scene] if "scene" in entry else [])
    options = ["--shading", entry["shading"]] if "shading" in entry else []
    environment = dict(os.environ, MISTAKE=name, SHADING=entry.get("shading", ""))
    environment.pop("GLINT_PIXELS", None)
    picture, log = os.path.join(folder, f"{tracer}-{name}.ppm"), os.path.join(folder, f"{tracer}-{name}.log")
    with open(picture, "wb") as output:
        subprocess.run(arguments, env=environment, stdout=output, check=True)
    pixels = subprocess.run([glint, "pixels", scene, picture, "-q"] + options, stdout=subprocess.PIPE, check=True, text=True).stdout.strip()
    environment.update(GLINT_LOG=log, GLINT_PIXELS=";".join(filter(None, [pixels, random_pixels(12, size)])))
    subprocess.run(arguments, env=environment, stdout=subprocess.DEVNULL, check=True)
    answer = subprocess.run([glint, "diagnose", scene, log, "--json", "--size", f"{size[0]}x{size[1]}"] + options, stdout=subprocess.PIPE, text=True, check=False)
    return json.loads(answer.stdout)["findings"]


def what_is_wrong(findings, entry):
    if not entry:
        return "" if not findings else f"a finding without a mistake: {findings[0]['quantity']}"
    if not findings:  # null: rows may count from the bottom, which is a convention
        return "" if None in entry.get("or", []) else "no finding"
    first = findings[0]
    if first["quantity"] not in [entry["first"]] + entry.get("or", []):
        return f"the first quantity is {first['quantity']}, not {entry['first']}"
    sure = [finding["causes"][0]["id"] for finding in findings if finding["sure"] and finding["first_pixels"] > 0]
    wrong = [cause for cause in sure if cause not in [entry.get("id")] + entry.get("also", [])]
    if wrong:
        return f"{wrong[0]} is sure, and wrong"
    return f"{entry['id']} is not found" if "id" in entry and entry["id"] not in sure else ""


def main():
    glint, tracers = sys.argv[1], sys.argv[2:] or list(SCENES)
    with open(os.path.join(HERE, "mistakes.json"), encoding="utf-8") as text:
        listed = json.load(text)
    failures = count = sure = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for tracer in tracers:
            command = command_of(tracer, folder)
            entries = {"": {}, **listed[tracer]}
            found = pool.map(lambda item: diagnosis(glint, tracer, command, item[0], item[1], folder), entries.items())
            for (name, entry), findings in zip(entries.items(), found):
                wrong = what_is_wrong(findings, entry)
                count, sure, failures = count + 1, sure + ("id" in entry), failures + (wrong != "")
                if wrong:
                    print(f"{tracer} {name or 'without a mistake'}: {wrong}")
    print(f"{count - failures} of {count} as listed; the cause is known of {sure}")
    return failures != 0


if __name__ == "__main__":
    sys.exit(main())

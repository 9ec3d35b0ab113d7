#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""All tests of the add-on: blender/tests/run.py [PATTERN]. Those of the pure parts run in this Python; the others inside
`blender -b` and, for the interface, under xvfb, with folders of their own for Blender's settings and add-ons. Without
blender these are skipped. GLINT: the glint command; default build/release/glint. GLINT_MODULE: the extension module of glint's
Python package; default that of build/release. The last line is ctest's."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path[:0] = [str(HERE.parent), str(HERE)]

import counting  # noqa: E402  pylint: disable=wrong-import-position


def run_plain(pattern):
    return counting.run(unittest.defaultTestLoader.discover(HERE / "plain", pattern=f"test_*{pattern}*.py",
                                                            top_level_dir=HERE / "plain"))


def make_package(folder, environment):
    """glint's Python package as it is installed; without the extension module, the tests of viewports fail."""
    found = environment.get("GLINT_MODULE") or next(ROOT.glob("build/release/python/glint/_glint.*"), None)
    shutil.copytree(ROOT / "python/glint", f"{folder}/modules/glint")
    if found:
        shutil.copy(found, f"{folder}/modules/glint")
    return f"{folder}/modules"


def run_in_blender(command, script, pattern, environment):
    """Runs a script in Blender that writes its counts to $GLINT_TEST_COUNTS."""
    with tempfile.TemporaryDirectory(prefix="glint-blender-") as folder:
        counts = os.path.join(folder, "counts.json")
        environment = dict(environment, BLENDER_USER_SCRIPTS=f"{folder}/scripts", BLENDER_USER_CONFIG=f"{folder}/config",
                           GLINT_TEST_COUNTS=counts, GLINT_TEST_PATTERN=pattern, GLINT_TEST_FOLDER=folder,
                           GLINT_TEST_MODULES=make_package(folder, environment))
        os.makedirs(f"{folder}/scripts/addons")
        try:
            run = subprocess.run([*command, "--factory-startup", "--python-exit-code", "3", "--python", str(HERE / script)],
                                 env=environment, timeout=900, check=False)
        except subprocess.TimeoutExpired:
            print(f"{script}: not finished within 15 minutes")
            return counting.Counts(1, 1, 0)
        try:
            result = counting.Counts(*json.loads(pathlib.Path(counts).read_text(encoding="utf-8")))
        except (OSError, ValueError):
            print(f"{script}: Blender ended with {run.returncode} before the tests did")
            return counting.Counts(1, 1, 0)
        return result


def main():
    pattern = sys.argv[1] if len(sys.argv) > 1 else ""
    total = run_plain(pattern)
    environment = dict(os.environ)
    # Blender takes the modules of the python3 that it finds in PATH: that of the system, not the one that runs this.
    environment["PATH"] = os.pathsep.join(p for p in os.environ["PATH"].split(os.pathsep)
                                          if sys.prefix in ("/usr", "/usr/local") or not p.startswith(sys.prefix))
    environment["GLINT"] = environment.get("GLINT") or str(ROOT / "build/release/glint")
    blender, xvfb = shutil.which("blender"), shutil.which("xvfb-run")
    for wanted, name, command, script in (
            (blender, "blender", ["blender", "-b"], "run_inside.py"),
            (blender and xvfb, "xvfb-run and blender", ["xvfb-run", "-a", "blender", "--window-geometry", "0", "0", "1280", "800"],
             "run_interface.py"),
            (blender and xvfb, "xvfb-run and blender",
             ["xvfb-run", "-a", "blender", "--window-geometry", "0", "0", "640", "480"], "run_viewport_speed.py")):
        if script == "run_viewport_speed.py" and pattern not in script:  # the others choose among their files
            continue
        if wanted:
            total += run_in_blender(command, script, pattern, environment)
        else:
            print(f"{script}: {name}: not installed (Skipped)")
    passed = total.run - total.failed
    if total.skipped:
        print(f"{total.skipped} tests (Skipped)")
    print(f"{100 * passed // max(total.run, 1)}% tests passed, {total.failed} tests failed out of {total.run}")
    return 1 if total.failed or not total.run else 0


if __name__ == "__main__":
    sys.exit(main())

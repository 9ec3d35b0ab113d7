# SPDX-License-Identifier: Apache-2.0
"""The zips with the command of a platform: what they take of a release's files, and their manifests."""
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest
import zipfile

import package
from io_glint import command

LINUX = ("bin/glint", "bin/glint-povray", "lib/glint/libtbb.so.12", "lib/glint/libpng16.so.16", "lib/libglint.so",
         "include/glint/glint.h", "share/doc/glint/LICENSE", "share/doc/glint/NOTICE", "share/doc/glint/README.md",
         "share/doc/glint/libraries/libtbb12")
WINDOWS = ("glint.exe", "glint-povray.exe", "other.dll", "LICENSE", "NOTICE", "licences/libopenexr-dev", "scenes/a.json")
WHEEL = ("glint/__init__.py", "glint/_glint.cpython-311-x86_64-linux-gnu.so", "glint/libs/libtbb.so.12", "glint/py.typed",
         "glint/__pycache__/__init__.cpython-311.pyc", "glint-0.3.0.dist-info/LICENSE", "glint-0.3.0.dist-info/LICENSE.libtbb12",
         "glint-0.3.0.dist-info/RECORD")


class Program(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def unpacked(self, name, files):
        for file in files:
            path = self.folder / name / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f"{file}\n", encoding="utf-8")
        return self.folder / name

    def contents(self, path):
        """name below io_glint -> content, of what is not in the zip without the command"""
        plain = {name for name, _ in package.addon_files()}
        with zipfile.ZipFile(path) as made:
            return {name.removeprefix("io_glint/"): made.read(name).decode() for name in made.namelist() if name not in plain}

    def test_linux(self):
        linux, wheel = self.unpacked("linux", LINUX), self.unpacked("wheel", WHEEL)
        path = package.make(self.folder, "linux-x86_64", linux, wheel)
        self.assertEqual(path.name, f"io_glint-{package.version()}-linux-x86_64.zip")
        program = ("bin/glint", "lib/glint/libtbb.so.12", "lib/glint/libpng16.so.16", "share/doc/glint/LICENSE",
                   "share/doc/glint/NOTICE", "share/doc/glint/libraries/libtbb12")
        modules = WHEEL[:4] + WHEEL[5:7]
        self.assertEqual(self.contents(path), {f"program/{name}": f"{name}\n" for name in program}
                         | {f"modules/{name}": f"{name}\n" for name in modules})
        with zipfile.ZipFile(path) as made:
            modes = {info.filename: info.external_attr >> 16 for info in made.infolist()}
        self.assertEqual([name for name, mode in modes.items() if mode != 0o644], ["io_glint/program/bin/glint"])

    def test_windows(self):
        path = package.make(self.folder, "windows-x86_64", self.unpacked("windows", WINDOWS))
        self.assertEqual(path.name, f"io_glint-{package.version()}-windows-x86_64.zip")
        program = ("glint.exe", "other.dll", "LICENSE", "NOTICE", "licences/libopenexr-dev")
        self.assertEqual(self.contents(path), {f"program/{name}": f"{name}\n" for name in program})

    def test_the_same_inputs_give_the_same_bytes(self):
        first, second = self.unpacked("first", LINUX), self.unpacked("second", reversed(LINUX))
        (second / "bin/glint").chmod(0o755)
        bytes_of = [package.make(self.folder / name, "linux-x86_64", name).read_bytes() for name in (first, second)]
        self.assertEqual(bytes_of[0], bytes_of[1])

    def test_the_manifest_names_the_platform(self):
        for platform, files, name in (("linux-x86_64", LINUX, "linux-x64"), ("windows-x86_64", WINDOWS, "windows-x64")):
            with zipfile.ZipFile(package.make(self.folder, platform, self.unpacked(platform, files))) as made:
                manifest = tomllib.loads(made.read("io_glint/blender_manifest.toml").decode())
            self.assertEqual(manifest["platforms"], [name])
            self.assertIn("files", manifest["permissions"])

    def test_the_add_on_looks_where_the_zip_has_the_program(self):
        first = {f"program/{patterns[0]}" for patterns in package.PROGRAM.values()}
        self.assertEqual(set(command.PROGRAMS.values()), first)

    def test_the_command_line(self):
        linux, windows = self.unpacked("linux", LINUX), self.unpacked("windows", WINDOWS)

        def run(*more):
            return subprocess.run([sys.executable, package.__file__, self.folder, *more], capture_output=True, text=True,
                                  check=False)
        made = run("--platform", "windows-x86_64", "--command", windows)
        self.assertEqual((made.returncode, pathlib.Path(made.stdout.strip()).parent), (0, self.folder), made.stderr)
        self.assertEqual(run().stdout.strip(), str(self.folder / f"io_glint-{package.version()}.zip"))
        for more, text in ((("--platform", "windows-x86_64", "--command", linux), "has no glint.exe"),
                           (("--command", linux), "belong together"), (("--modules", linux), "belong together")):
            failed = run(*more)
            self.assertNotEqual(failed.returncode, 0)
            self.assertIn(text, failed.stderr)

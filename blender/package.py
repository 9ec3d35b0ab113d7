#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the add-on's zip, for Blender 3.3 and later, and prints its path. The same inputs give the same bytes.

    blender/package.py [FOLDER]                                                  io_glint-VERSION.zip, without the command
    blender/package.py [FOLDER] --platform linux-x86_64 --command UNPACKED [--modules WHEEL]
    blender/package.py [FOLDER] --platform windows-x86_64 --command UNPACKED     io_glint-VERSION-PLATFORM.zip, with it
"""
import argparse
import pathlib
import re
import zipfile

import documentation

HERE = pathlib.Path(__file__).resolve().parent
ADDON = HERE / "io_glint"
# What the zip takes of glint-VERSION-PLATFORM, in its places: the program first, its libraries, and the licences of both.
PROGRAM = {
    "linux-x86_64": ("bin/glint", "lib/glint/*.so*", "share/doc/glint/LICENSE", "share/doc/glint/NOTICE",
                     "share/doc/glint/libraries/*"),
    "windows-x86_64": ("glint.exe", "*.dll", "LICENSE", "NOTICE", "licences/*"),
}
# Of a wheel of the Python package.
MODULES = ("glint/**/*", "*.dist-info/LICENSE*", "*.dist-info/NOTICE*", "*.dist-info/licenses/*")
# In Blender's words, for the manifest: 4.2 and later refuse the zip elsewhere.
BLENDERS_PLATFORM = {"linux-x86_64": "linux-x64", "windows-x86_64": "windows-x64"}


def version():
    return re.search(r'^version = "([^"]+)"', (ADDON / "blender_manifest.toml").read_text(), re.M)[1]


def addon_files(platform=None):
    """(name in the zip, its content)"""
    for path in ADDON.rglob("*"):
        if path.is_file() and path.suffix in (".py", ".toml"):
            content = path.read_bytes()
            if platform and path.name == "blender_manifest.toml":
                line = f'platforms = ["{BLENDERS_PLATFORM[platform]}"]\n'.encode()
                content = re.sub(rb"^license = .*\n", lambda found: found[0] + line, content, flags=re.M)
            yield f"io_glint/{path.relative_to(ADDON).as_posix()}", content
    yield "io_glint/LICENSE", (HERE.parent / "LICENSE").read_bytes()
    markdown = (HERE.parent / "docs" / "blender.md").read_text(encoding="utf-8")
    yield "io_glint/documentation.html", documentation.page(markdown).encode()


def taken(folder, patterns, below):
    """(name in the zip, content) of the folder's files that match. SystemExit if the first pattern matches none."""
    folder = pathlib.Path(folder)
    found = [[path for path in folder.glob(pattern) if path.is_file() and path.suffix != ".pyc"] for pattern in patterns]
    if not found[0]:
        raise SystemExit(f"{folder} has no {patterns[0]}")
    for path in sum(found, []):
        yield f"io_glint/{below}/{path.relative_to(folder).as_posix()}", path.read_bytes()


def make(folder, platform=None, command=None, modules=None):
    """Writes the zip into the folder and returns its path.

    platform: one of PROGRAM; command: the unpacked archive of a release for it; modules: an unpacked wheel, or None."""
    contents = dict(addon_files(platform))
    if platform:
        contents.update(taken(command, PROGRAM[platform], "program"))
    if modules:
        contents.update(taken(modules, MODULES, "modules"))
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"io_glint-{version()}{f'-{platform}' if platform else ''}.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as zip_file:
        for name, content in sorted(contents.items()):
            info = zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0))
            info.create_system = 3  # Unix: what external_attr is of
            info.external_attr = (0o755 if name == "io_glint/program/bin/glint" else 0o644) << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            zip_file.writestr(info, content)
    return path


def main():
    parser = argparse.ArgumentParser(description="Makes the add-on's zip and prints its path.")
    parser.add_argument("folder", nargs="?", default=HERE.parent / "build" / "blender", help="where; default: build/blender")
    parser.add_argument("--platform", choices=PROGRAM, help="whose command is in the zip; default: none")
    parser.add_argument("--command", metavar="FOLDER", help="the unpacked glint-VERSION-PLATFORM of a release")
    parser.add_argument("--modules", metavar="FOLDER", help="an unpacked wheel of the Python package")
    arguments = parser.parse_args()
    if bool(arguments.platform) != bool(arguments.command) or (arguments.modules and not arguments.platform):
        parser.error("--platform and --command belong together, and --modules needs both")
    print(make(**vars(arguments)))


if __name__ == "__main__":
    main()

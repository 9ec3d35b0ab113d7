#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the add-on's zip, for Blender 3.3 and later: blender/package.py [FOLDER], default build/blender. Prints its path.
The same sources give the same bytes."""
import pathlib
import re
import sys
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ADDON = HERE / "io_glint"


def version():
    return re.search(r'^version = "([^"]+)"', (ADDON / "blender_manifest.toml").read_text(), re.M)[1]


def files():
    """(path, name in the zip), sorted."""
    found = [p for p in ADDON.rglob("*") if p.is_file() and p.suffix in (".py", ".toml")]
    pairs = [(p, f"io_glint/{p.relative_to(ADDON).as_posix()}") for p in found]
    return sorted([*pairs, (HERE.parent / "LICENSE", "io_glint/LICENSE")], key=lambda pair: pair[1])


def make(folder):
    """Writes io_glint-VERSION.zip into the folder and returns its path."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"io_glint-{version()}.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as zip_file:
        for source, name in files():
            info = zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0))
            info.external_attr = 0o644 << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            zip_file.writestr(info, source.read_bytes())
    return path


if __name__ == "__main__":
    print(make(sys.argv[1] if len(sys.argv) > 1 else HERE.parent / "build" / "blender"))

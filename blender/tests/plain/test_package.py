# SPDX-License-Identifier: Apache-2.0
"""The zip: what is in it, and the manifest by the schema that Blender's manual documents. Blender 4.2 itself is not run."""
import ast
import pathlib
import re
import tempfile
import tomllib
import unittest
import zipfile

import package

ADDON = package.ADDON
# docs.blender.org/manual/en/latest/advanced/extensions/getting_started.html and .../tags.html
REQUIRED = {"schema_version": str, "id": str, "version": str, "name": str, "tagline": str, "maintainer": str, "type": str,
            "blender_version_min": str, "license": list}
OPTIONAL = {"blender_version_max": str, "website": str, "copyright": list, "tags": list, "platforms": list, "wheels": list,
            "permissions": dict, "build": dict}
TAGS = {"3D View", "Add Curve", "Add Mesh", "Animation", "Bake", "Camera", "Compositing", "Development", "Game Engine",
        "Geometry Nodes", "Grease Pencil", "Import-Export", "Lighting", "Material", "Modeling", "Mesh", "Node", "Object",
        "Paint", "Pipeline", "Physics", "Render", "Rigging", "Scene", "Sculpt", "Sequencer", "System", "Text Editor",
        "Tracking", "User Interface", "UV"}
PERMISSIONS = {"files", "network", "clipboard", "camera", "microphone"}
SEMANTIC = r"\d+\.\d+\.\d+([-+][0-9A-Za-z.+-]+)?"


def mistakes(manifest):
    """What the schema refuses in a manifest."""
    for key, kind in REQUIRED.items():
        if not isinstance(manifest.get(key), kind):
            yield f"{key} is missing or no {kind.__name__}"
            return
    for key, value in manifest.items():
        if key not in REQUIRED and not isinstance(value, OPTIONAL.get(key, ())):
            yield f"{key} is unknown or of another type"
    if manifest["schema_version"] != "1.0.0":
        yield "schema_version is not 1.0.0"
    if not manifest["id"].isidentifier() or manifest["id"].startswith("_") or "__" in manifest["id"]:
        yield "id is no identifier"
    if manifest["type"] not in ("add-on", "theme"):
        yield "type is neither add-on nor theme"
    for key in ("version", "blender_version_min", "blender_version_max"):
        if key in manifest and not re.fullmatch(SEMANTIC, manifest[key]):
            yield f"{key} is no semantic version"
    if tuple(map(int, manifest["blender_version_min"].split("."))) < (4, 2, 0):
        yield "blender_version_min is below 4.2.0"
    tagline = manifest["tagline"]
    if not tagline or len(tagline) > 64 or not (tagline[-1].isalnum() or tagline[-1] in ")]}"):
        yield "tagline is empty, longer than 64 characters or ends with punctuation"
    if not manifest["license"] or not all(re.fullmatch(r"SPDX:[A-Za-z0-9.+-]+", v) for v in manifest["license"]):
        yield "license is no list of SPDX identifiers"
    if set(manifest.get("tags", ())) - TAGS:
        yield "an unknown tag"
    for key, reason in manifest.get("permissions", {}).items():
        if key not in PERMISSIONS or not reason or len(reason) > 64 or not reason[-1].isalnum():
            yield f"permission {key} is unknown, or its reason is too long or ends with punctuation"


class Manifest(unittest.TestCase):
    def setUp(self):
        self.manifest = tomllib.loads((ADDON / "blender_manifest.toml").read_text(encoding="utf-8"))

    def test_it_follows_the_schema(self):
        self.assertEqual(list(mistakes(self.manifest)), [])

    def test_the_check_finds_mistakes(self):
        for key, value in (("tagline", "x" * 65), ("tagline", "Ends."), ("version", "1"), ("id", "a b"), ("type", "addon"),
                           ("license", ["Apache-2.0"]), ("tags", ["Raytracing"]), ("permissions", {"files": "Why."}),
                           ("colour", "red"), ("blender_version_min", "4.1.0"), ("schema_version", "2.0.0")):
            self.assertEqual(len(list(mistakes(self.manifest | {key: value}))), 1, (key, value))
        self.assertEqual(len(list(mistakes({k: v for k, v in self.manifest.items() if k != "name"}))), 1)

    def test_it_agrees_with_bl_info(self):
        tree = ast.parse((ADDON / "__init__.py").read_text(encoding="utf-8"))
        info = next(ast.literal_eval(node.value) for node in tree.body
                    if isinstance(node, ast.Assign) and node.targets[0].id == "bl_info")
        self.assertEqual(".".join(map(str, info["version"])), self.manifest["version"])
        self.assertEqual(info["name"], self.manifest["name"])
        self.assertEqual(info["blender"][:2], (3, 3))

    def test_it_has_glints_version(self):
        header = (ADDON.parent.parent / "include/glint/version.h").read_text(encoding="utf-8")
        self.assertEqual(re.search(r'GLINT_VERSION "?(\d+\.\d+\.\d+)', header)[1], self.manifest["version"])


class Package(unittest.TestCase):
    def test_the_zip(self):
        with tempfile.TemporaryDirectory() as folder:
            first = package.make(folder)
            content = first.read_bytes()
            self.assertEqual(package.make(folder).read_bytes(), content)
            with zipfile.ZipFile(first) as made:
                names = set(made.namelist())
        self.assertTrue(all(name.startswith("io_glint/") for name in names))
        for name in ("__init__.py", "blender_manifest.toml", "LICENSE", "export/scene.py"):
            self.assertIn(f"io_glint/{name}", names)
        self.assertFalse([name for name in names if "__pycache__" in name or "test" in name])

    def test_pure_parts_do_not_import_bpy(self):
        pure = [*(ADDON / "export").glob("*.py"), ADDON / "command.py", ADDON / "exr.py", ADDON / "passes.py"]
        self.assertGreater(len(pure), 15)
        for path in pure:
            self.assertEqual(self.imports(path) & {"bpy", "mathutils", "bpy_extras"}, set(), path)

    def test_no_module_needs_numpy_or_its_own_name(self):
        for path in ADDON.rglob("*.py"):
            if path.name in ("mesh_file.py", "png.py"):
                self.assertIn("try:\n    import numpy as np\nexcept ImportError:", path.read_text(encoding="utf-8"))
            elif path.name != "progressive_renderer.py":  # it has glint's Python package, which needs numpy
                self.assertNotIn("numpy", self.imports(path), path)
            if path.name != "package.py":
                self.assertNotIn('"io_glint"', path.read_text(encoding="utf-8"), path)

    def imports(self, path: pathlib.Path):
        found = set()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                found |= {alias.name.split(".")[0] for alias in node.names}
            elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                found.add(node.module.split(".")[0])
        return found

# SPDX-License-Identifier: Apache-2.0
"""What the tests inside Blender share: small scenes, exports, glint's answers, and Blender's own."""
import json
import math
import os
import subprocess
import tempfile
import unittest

import bpy
from io_glint import exr
from mathutils import Vector

GLINT = os.environ["GLINT"]


class SceneTest(unittest.TestCase):
    """Starts every test with an empty scene and a folder of its own."""

    def setUp(self):
        bpy.ops.wm.read_homefile(use_empty=True)
        self.scene = bpy.context.scene
        render = self.scene.render
        render.resolution_x, render.resolution_y, render.resolution_percentage = 96, 64, 100
        self.scene.view_settings.view_transform = "Standard"
        self.scene.world = None
        folder = tempfile.TemporaryDirectory(prefix="glint-test-")
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    # Scenes.

    def link(self, ob):
        self.scene.collection.objects.link(ob)
        return ob

    def camera(self, location=(3, -8, 4), target=(0, 0, 0.5), **settings):
        data = bpy.data.cameras.new("Camera")
        for key, value in settings.items():
            setattr(data, key, value)
        ob = self.link(bpy.data.objects.new("Camera", data))
        ob.location = location
        ob.rotation_euler = (Vector(target) - Vector(location)).to_track_quat("-Z", "Y").to_euler()
        self.scene.camera = ob
        return ob

    def lamp(self, kind="POINT", energy=500.0, location=(2, -3, 5), color=(1, 1, 1), name="Key", rotation=(0, 0, 0), **settings):
        data = bpy.data.lights.new(name, kind)
        data.energy, data.color = energy, color
        if kind == "POINT":
            data.shadow_soft_size = 0
        for key, value in settings.items():
            setattr(data, key, value)
        ob = self.link(bpy.data.objects.new(name, data))
        ob.location, ob.rotation_euler = location, rotation
        return ob

    def mesh(self, name, vertices, faces, smooth=False):
        data = bpy.data.meshes.new(name)
        data.from_pydata(vertices, [], faces)
        for polygon in data.polygons:
            polygon.use_smooth = smooth
        return self.link(bpy.data.objects.new(name, data))

    def add(self, kind, name=None, smooth=False, material=None, scale=None, rotation=None, **settings):
        """A mesh of Blender's own operators: kind is that of bpy.ops.mesh.primitive_KIND_add."""
        getattr(bpy.ops.mesh, f"primitive_{kind}_add")(**settings)
        ob = bpy.context.object
        if name:
            ob.name = name
        if smooth:
            ob.data.polygons.foreach_set("use_smooth", [True] * len(ob.data.polygons))
        if scale:
            ob.scale = scale
        if rotation:
            ob.rotation_euler = rotation
        if material:
            ob.data.materials.append(material)
        return ob

    def material(self, name="paint", color=(0.8, 0.2, 0.1), **sockets):
        made = bpy.data.materials.new(name)
        made.use_nodes = True
        node = made.node_tree.nodes["Principled BSDF"]
        node.inputs["Base Color"].default_value = (*color, 1)
        for key, value in sockets.items():
            node.inputs[key.replace("_", " ")].default_value = value
        return made

    def shader(self, node_type, name="made", **sockets):
        material = bpy.data.materials.new(name)
        material.use_nodes = True
        tree = material.node_tree
        tree.nodes.clear()
        node, output = tree.nodes.new(node_type), tree.nodes.new("ShaderNodeOutputMaterial")
        for key, value in sockets.items():
            node.inputs[key].default_value = (*value, 1) if isinstance(value, tuple) else value
        tree.links.new(node.outputs[0], output.inputs["Surface"])
        return material

    def world(self, color, strength=1.0):
        made = bpy.data.worlds.new("World")
        made.use_nodes = True
        node = made.node_tree.nodes["Background"]
        node.inputs[0].default_value, node.inputs[1].default_value = (*color, 1), strength
        self.scene.world = made
        return made

    # F12.

    def use_engine(self):
        """glint renders, and pictures are written as they are."""
        self.scene.render.engine = "GLINT"
        settings = self.scene.render.image_settings
        settings.file_format, settings.color_depth, settings.exr_codec, settings.color_mode = "OPEN_EXR", "32", "ZIP", "RGB"

    def picture(self, name="f12"):
        """F12's picture as an exr.Part."""
        self.scene.render.filepath = self.path(f"{name}.exr")
        bpy.ops.render.render(write_still=True)
        return exr.read(self.scene.render.filepath)[0]

    # Exports.

    def path(self, name):
        return os.path.join(self.folder, name)

    def export(self, name="scene.glint", **settings):
        """The text of the exported file; its warnings are self.warnings."""
        path = self.path(name)
        self.assertEqual(bpy.ops.export_scene.glint(filepath=path, **settings), {"FINISHED"})
        with open(path, encoding="utf-8") as file:
            text = file.read()
        self.warnings = [line[2:] for line in text.splitlines() if line.startswith("# ")][1:]
        return text

    def keys(self, name):
        """The keys of an exported material."""
        text = self.export()
        line = next(line for line in text.splitlines() if line.startswith(f'material "{name}"'))
        entries = line.split("{ ", 1)[1].removesuffix(" }").split("  ")
        return dict(entry.split(" = ", 1) for entry in entries)

    def export_rt2(self, name="scene.json", **settings):
        path = self.path(name)
        self.assertEqual(bpy.ops.export_scene.rt2(filepath=path, **settings), {"FINISHED"})
        with open(path, encoding="utf-8") as file:
            return json.load(file)

    def glint(self, *arguments):
        """Runs glint, which must succeed without warnings of its reader; returns what it prints."""
        run = subprocess.run([GLINT, *arguments], capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def info(self, name="scene.glint"):
        return json.loads(self.glint("info", self.path(name), "--json"))

    def layers(self, *names, scene="scene.glint", more=(), aa=1):
        """glint's layers of an exported scene, aa x aa samples a pixel: name -> exr.Part."""
        out = self.path("layers.exr")
        self.glint("render", self.path(scene), "-o", out, "--aov", ",".join(names), "--aa", str(aa), "-q", *more)
        return {part.name: part for part in exr.read(out)}

    # Blender's answers.

    def rays(self, step=5):
        """(x, y, origin, direction) through pixel centres, computed from Blender's view_frame."""
        render, camera = self.scene.render, self.scene.camera
        width = render.resolution_x * render.resolution_percentage // 100
        height = render.resolution_y * render.resolution_percentage // 100
        matrix = camera.matrix_world.normalized()
        right_top, _, left_bottom, left_top = camera.data.view_frame(scene=self.scene)
        for y in range(2, height, step):
            for x in range(2, width, step):
                at = left_top + (right_top - left_top) * (x + 0.5) / width + (left_bottom - left_top) * (y + 0.5) / height
                if camera.data.type == "ORTHO":
                    origin = matrix @ Vector((at.x, at.y, 0))
                    yield x, y, origin, matrix.to_3x3() @ Vector((0, 0, -1))
                else:
                    yield x, y, matrix.translation, (matrix.to_3x3() @ at).normalized()

    def check_hits(self, tolerance=1e-4, step=5, least=20):
        """Every ray hits or misses in glint as in Blender, at the same point. Returns the number of hits."""
        bpy.context.view_layer.update()
        depsgraph = bpy.context.evaluated_depsgraph_get()
        self.export()
        part = self.layers("position", "object")
        hits = 0
        for x, y, origin, direction in self.rays(step):
            found, point, *_ = self.scene.ray_cast(depsgraph, origin, direction)
            i = y * part["position"].width + x
            self.assertEqual(bool(part["object"].channels["I"][i]), found, f"pixel {x},{y}")
            if found:
                hits += 1
                there = [part["position"].channels[c][i] for c in "XYZ"]
                self.assertLess(math.dist(point, there), tolerance, f"pixel {x},{y}: {tuple(point)}, {there}")
        self.assertGreaterEqual(hits, least)
        return hits

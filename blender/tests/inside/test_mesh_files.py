# SPDX-License-Identifier: Apache-2.0
"""Large meshes as .ply files: the same surfaces, normals, materials and places as triangles in the text."""
import math
import os
import random
import re

import bpy
from io_glint.export import mesh_file
from support import SceneTest


class MeshFiles(SceneTest):
    def setUp(self):
        super().setUp()
        self.camera()
        self.lamp()
        self.world((0.2, 0.2, 0.3))

    def monkey(self, levels=2, smooth=True, **settings):
        ob = self.add("monkey", smooth=smooth, material=self.material(), **settings)
        modifier = ob.modifiers.new("subdivision", "SUBSURF")
        modifier.levels = modifier.render_levels = levels
        return ob

    def files(self, name="scene_meshes"):
        return sorted(os.listdir(self.path(name))) if os.path.isdir(self.path(name)) else []

    def check_same_picture(self, expected_files, of_normals=2e-3):
        text = self.export()
        self.assertEqual(text.count("\nmesh "), text.count(".ply"))
        self.assertEqual(len(self.files()), expected_files)
        with_files = self.layers("normal", "position", "material", aa=2)
        self.assertNotIn("\nmesh ", self.export("plain.glint", mesh_files=False))
        plain = self.layers("normal", "position", "material", scene="plain.glint", aa=2)
        for layer, tolerance in (("beauty", 2e-3), ("normal", of_normals), ("position", 1e-4), ("material", 0)):
            for channel, values in plain[layer].channels.items():
                others = with_files[layer].channels[channel]
                wrong = sum(abs(a - b) > tolerance for a, b in zip(values, others) if a != b)
                self.assertLessEqual(wrong, 0.003 * len(values), f"{layer} {channel}")

    def test_smooth_and_flat(self):
        self.monkey()
        self.monkey(smooth=False, location=(-2, 1, 0.5))
        self.check_same_picture(2)
        self.check_hits()

    def test_smooth_and_flat_faces_of_one_mesh(self):
        ob = self.monkey()
        for polygon in ob.data.polygons:
            polygon.use_smooth = polygon.index % 2 == 0
        self.check_same_picture(1)

    def count_vertices(self):
        """Those of the only file."""
        (name,) = self.files()
        with open(os.path.join(self.path("scene_meshes"), name), "rb") as file:
            return int(re.search(rb"element vertex (\d+)", file.read(1000))[1])

    def test_own_normals(self):
        """More at one vertex than are compared there."""
        count = 1500
        ring = [(math.cos(2 * math.pi * i / count), math.sin(2 * math.pi * i / count), 0.5) for i in range(count)]
        data = self.mesh("fan", [(0, 0, 0), *ring], [(0, 1 + i, 1 + (i + 1) % count) for i in range(count)]).data
        numbers = random.Random(1)
        for polygon in data.polygons:
            polygon.use_smooth = True
        if hasattr(data, "use_auto_smooth"):  # to 4.0
            data.use_auto_smooth, data.auto_smooth_angle = True, math.pi
            data.calc_normals_split()
        normals = [(numbers.uniform(-1, 1), numbers.uniform(-1, 1), 2) for _ in data.polygons]
        data.normals_split_custom_set([n for n, polygon in zip(normals, data.polygons) for _ in polygon.loop_indices])
        data.update()
        self.check_same_picture(1)
        self.assertGreater(self.count_vertices(), 2 * len(data.vertices))

    def test_sharp_edges_share_vertices(self):
        """Two normals at each vertex of a fold: two vertices."""
        n = 600
        points = [(x / n, y, z) for y, z in ((-1, 0.5), (0, 0), (1, 0.5)) for x in range(n)]
        faces = [(row * n + i, row * n + i + 1, row * n + n + i + 1, row * n + n + i) for row in (0, 1) for i in range(n - 1)]
        ob = self.mesh("fold", points, faces, smooth=True)
        if hasattr(ob.data, "use_auto_smooth"):
            ob.data.use_auto_smooth, ob.data.auto_smooth_angle = True, 0.1
        ob.data.vertices[0].co.z += 0.01  # not flat everywhere
        self.export()
        self.assertLess(self.count_vertices(), 4 * n + 4)

    def test_materials_of_faces(self):
        ob = self.monkey()
        ob.data.materials.append(self.material("blue", (0.1, 0.2, 0.9)))
        for polygon in ob.data.polygons:
            polygon.material_index = int(polygon.center.x > 0)
        self.check_same_picture(2)

    def test_instances_share_a_file(self):
        ob = self.monkey()
        for i, scale in enumerate(((1, 1, 1), (0.5, 1, 2), (-1, 1, 1))):
            other = self.link(ob.copy())
            other.location, other.scale, other.rotation_euler = (1.5 * i - 2, 2, 1), scale, (0.2, 0.1 * i, 0.5)
        # Normals are interpolated before the transform, as in Cycles, and not after it.
        self.check_same_picture(1, of_normals=0.1)
        self.check_hits()

    def test_what_stays_in_the_text(self):
        self.add("monkey", smooth=True)  # small
        parent = self.link(bpy.data.objects.new("rig", None))
        parent.scale.z = 1e-8  # glint refuses such a shear of a mesh
        self.monkey(rotation=(0.7, 0.2, 0)).parent = parent
        self.assertNotIn(".ply", self.export())
        self.assertEqual(self.files(), [])

    def test_shapes_are_still_recognised(self):
        self.add("uv_sphere", smooth=True, segments=64, ring_count=32)
        self.add("cylinder", smooth=True, vertices=600, location=(0, 3, 0))
        text = self.export()
        self.assertIn("\nsphere ", text)
        self.assertEqual(self.files(), [])

    def test_an_animation_writes_a_resting_mesh_once(self):
        ob = self.monkey()
        self.scene.frame_start, self.scene.frame_end = 1, 3
        for frame in (1, 3):
            ob.location.x = frame
            ob.keyframe_insert("location", frame=frame)
        bpy.ops.export_scene.glint(filepath=self.path("film.glint"), animation=True)
        self.assertEqual(len(self.files("film_meshes")), 1)
        self.glint("render", self.path("film.0002.glint"), "-o", self.path("a.png"), "--strict")

    def test_without_numpy_all_is_text(self):
        self.monkey()
        np, mesh_file.np = mesh_file.np, None
        self.addCleanup(setattr, mesh_file, "np", np)
        self.assertNotIn(".ply", self.export())

    def test_f12_uses_the_files(self):
        self.monkey()
        self.scene.render.engine = "GLINT"
        self.scene.render.filepath = self.path("f12.png")
        bpy.ops.render.render(write_still=True)
        self.assertTrue(os.path.exists(self.path("f12.png")))

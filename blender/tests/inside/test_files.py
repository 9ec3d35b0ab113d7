# SPDX-License-Identifier: Apache-2.0
"""What is written: animations, names of every kind, damaged meshes, large meshes, and what stays as it was."""
import glob
import os
import subprocess
import time

import bpy
from support import GLINT, SceneTest


class Files(SceneTest):
    def setUp(self):
        super().setUp()
        self.camera()
        self.lamp()

    def test_an_animation(self):
        ball = self.add("uv_sphere", name="ball", smooth=True)
        self.scene.frame_start, self.scene.frame_end, self.scene.frame_step = 3, 26, 1
        for frame, x in ((3, -2), (26, 2)):
            ball.location.x = x
            ball.keyframe_insert("location", frame=frame)
        self.scene.frame_set(7, subframe=0.5)
        before = ball.matrix_world.copy()
        self.assertEqual(bpy.ops.export_scene.glint(filepath=self.path("it's moving.glint"), animation=True), {"FINISHED"})
        self.assertEqual((self.scene.frame_current, self.scene.frame_subframe), (7, 0.5))
        self.assertEqual(ball.matrix_world, before)
        names = sorted(name for name in os.listdir(self.folder) if name.endswith(".glint"))
        self.assertEqual(names, [f"it's moving.{f:04d}.glint" for f in range(3, 27)])
        texts = [open(self.path(name), encoding="utf-8").read() for name in names]
        self.assertEqual(len(set(texts)), 24)
        self.assertTrue(all('sphere "ball"' in text for text in texts))
        run = subprocess.run([self.path("it's moving.sh"), "-s", "24x16", "-q"], env=dict(os.environ, GLINT=GLINT),
                             capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(sum(name.endswith(".png") for name in os.listdir(self.folder)), 24)

    def test_names_of_every_kind(self):
        for name in ('quote " and \\ backslash', "new\nline", "tab\there", "Ünïcödé ☃ 球", "}", "# not a comment", "a\x01b"):
            self.add("cube", name=name, material=self.material(name))
        self.scene.name = "scene\n} light { }"
        self.export()
        self.glint("render", self.path("scene.glint"), "-o", self.path("a.png"), "--strict")

    def test_equal_names_of_materials_of_libraries(self):
        library = self.path("library.blend")
        shared = self.material("paint", (0, 1, 0))
        cube = self.add("cube", name="linked", material=shared)
        bpy.data.libraries.write(library, {cube})
        bpy.data.objects.remove(cube)
        bpy.data.materials.remove(shared)
        self.add("cube", name="own", material=self.material("paint", (1, 0, 0)))
        with bpy.data.libraries.load(library, link=True) as (_, data):
            data.objects = ["linked"]
        self.link(data.objects[0])
        text = self.export()
        self.assertIn('material "paint" { color = (1, 0, 0)', text)
        self.assertIn('material "paint 2" { color = (0, 1, 0)', text)
        self.assertRegex(text, 'box "linked" .* material = "paint 2"')

    def test_damaged_meshes(self):
        nan, inf = float("nan"), float("inf")
        self.mesh("broken", [(0, 0, 0), (1, 0, 0), (0, 1, 0), (nan, 0, 0), (0, inf, 0), (1e20, 0, 0)],
                  [(0, 1, 2), (0, 1, 3), (0, 1, 4), (0, 2, 5)])
        self.mesh("lines", [(0, 0, 0), (1, 1, 1), (2, 2, 2), (0, 1, 0)], [(0, 1, 2), (0, 1, 1)])
        self.mesh("nothing", [], [])
        self.mesh("points", [(0, 0, 0)], [])
        text = self.export()
        self.assertEqual(text.count("triangle{"), 1)
        self.assertEqual(sum("3 triangles are left out" in w for w in self.warnings), 1, self.warnings)
        self.info()

    def test_transforms_without_an_inverse(self):
        self.add("cube", name="flat", scale=(1, 1, 0))
        self.add("uv_sphere", name="line", smooth=True, scale=(1, 0, 0))
        self.add("cube", name="huge").location.x = 1e13
        self.add("cube", name="nan").location.x = float("nan")
        text = self.export()
        self.assertIn('group "flat"', text)
        self.assertNotIn('"line"', text)
        for name in ("huge", "nan"):
            self.assertEqual(sum(f"'{name}'" in w for w in self.warnings), 1, self.warnings)
        self.glint("render", self.path("scene.glint"), "-o", self.path("a.png"))

    def test_an_empty_scene(self):
        for ob in list(self.scene.objects):
            if ob.type != "CAMERA":
                bpy.data.objects.remove(ob)
        self.export()
        self.info()
        self.assertEqual(self.export_rt2()["spheres"], [])

    def test_other_kinds_of_objects_are_named(self):
        self.link(bpy.data.objects.new("Smoke", bpy.data.volumes.new("Smoke")))
        self.add("cube", name="Furry")
        bpy.ops.object.particle_system_add()
        bpy.context.object.particle_systems[0].settings.type = "HAIR"
        self.export()
        for name in ("Smoke", "Furry"):
            self.assertEqual(sum(f"'{name}'" in w for w in self.warnings), 1, self.warnings)

    def test_without_a_file_name(self):
        for path in ("", self.folder + "/"):
            with self.assertRaisesRegex(RuntimeError, "No file: give a file name"):
                bpy.ops.export_scene.glint(filepath=path)

    def test_nothing_of_the_scene_is_changed(self):
        self.add("cube")
        render = self.scene.render
        render.engine, render.use_compositing, render.use_border = "BLENDER_WORKBENCH", True, True
        self.export()
        with self.assertRaises(RuntimeError):
            bpy.ops.export_scene.glint(filepath="/nowhere/at/all.glint")
        self.assertEqual((render.engine, render.use_compositing, render.use_border), ("BLENDER_WORKBENCH", True, True))
        self.assertIsNone(bpy.types.RenderEngine.bl_rna_get_subclass_py("GLINT_EXPORT"))

    def test_a_failed_export_keeps_the_older_file(self):
        self.add("cube")
        before = self.export()
        self.scene.camera.data.type = "PANO"
        with self.assertRaises(RuntimeError):
            bpy.ops.export_scene.glint(filepath=self.path("scene.glint"))
        with open(self.path("scene.glint"), encoding="utf-8") as file:
            self.assertEqual(file.read(), before)
        self.assertEqual(os.listdir(self.folder), ["scene.glint"])

    def test_in_edit_mode(self):
        cube = self.add("cube")
        bpy.context.view_layer.objects.active = cube
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.mesh.subdivide()
        self.assertEqual(self.export().count("triangle{"), 48)
        bpy.ops.object.mode_set(mode="OBJECT")

    def test_an_extension_is_added(self):
        bpy.ops.export_scene.glint(filepath=self.path("plain"))
        bpy.ops.export_scene.rt2(filepath=self.path("plain"))
        self.assertEqual(sorted(os.listdir(self.folder)), ["plain.glint", "plain.json"])

    def test_large_meshes(self):
        """327,680 triangles, smooth and flat."""
        for smooth in (False, True):
            with self.subTest(smooth=smooth):
                ball = self.add("ico_sphere", name="large", subdivisions=8, smooth=smooth)
                ball.glint_shape = "MESH"
                for mesh_files in (False, True):
                    start, cpu = time.perf_counter(), time.process_time()
                    bpy.ops.export_scene.glint(filepath=self.path("large.glint"), mesh_files=mesh_files)
                    seconds, cpu = time.perf_counter() - start, time.process_time() - cpu
                    with open(self.path("large.glint"), encoding="utf-8") as file:
                        text = file.read()
                    size = len(text) + sum(os.path.getsize(path) for path in glob.glob(self.path("large_meshes/*.ply")))
                    print(f"\n327,680 triangles, smooth {smooth}, files {mesh_files}: {seconds:.2f} s ({cpu:.2f} s of the "
                          f"processor), {size / 1e6:.1f} MB")
                    self.assertEqual(text.count("triangle{"), 0 if mesh_files else 327680)
                    self.assertLess(cpu, 4 if mesh_files else 8)
                bpy.data.objects.remove(ball)

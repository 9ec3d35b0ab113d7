# SPDX-License-Identifier: Apache-2.0
"""RT2's JSON: what the course's script writes, and what it should have written."""
import math

import bpy
from support import SceneTest


def course_script(collection):
    """What the course's script writes of a collection's spheres, planes, cylinders, camera and lights; after its text."""
    out = {"lights": [], "spheres": [], "planes": [], "cylinders": []}
    for ob in collection.all_objects:
        location, rotation, scale = ob.matrix_world.decompose()
        axis = rotation @ type(location)((0, 0, 1))
        name, material = ob.name.lower(), ob.get("material", "default")
        if "sphere" in name:
            out["spheres"].append({"center": list(location), "radius": abs(scale.x), "material": material})
        elif "plane" in name:
            out["planes"].append({"center": list(location), "normal": list(axis), "material": material})
        elif "cylinder" in name:
            out["cylinders"].append({"center": list(location), "axis": list(axis), "height": abs(2 * scale.z),
                                     "radius": abs(scale.x), "material": material})
        elif "camera" in name:
            out["camera"] = {"position": list(location), "up": list(rotation @ type(location)((0, 1, 0))),
                             "target": list(location - 10 * axis), "fov": round(ob.data.angle * 180 / 3.145)}
        elif "light" in name:
            out["lights"].append({"position": list(location), "color": list(ob.data.color)})
    return out


class RT2(SceneTest):
    def setUp(self):
        super().setUp()
        self.collection = bpy.data.collections.new("scene_custom")
        self.scene.collection.children.link(self.collection)

    def into(self, ob, material=None):
        for collection in list(ob.users_collection):
            collection.objects.unlink(ob)
        self.collection.objects.link(ob)
        if material:
            ob["material"] = material
        return ob

    def course_scene(self):
        self.scene.render.resolution_x = self.scene.render.resolution_y = 64
        self.into(self.add("plane", name="Plane", scale=(6, 6, 6)), "grass")
        self.into(self.add("uv_sphere", name="Sphere", location=(0, 0, 1.2), scale=(0.7, 0.7, 0.7)), "white_shiny")
        self.into(self.add("ico_sphere", name="big sphere", subdivisions=3, smooth=True, location=(2, 1, 1), scale=(-0.5, 0.5, 0.5)))
        self.into(self.add("cylinder", name="Cylinder.001", end_fill_type="NOTHING", rotation=(0.4, 0.2, 0), location=(-2, 0, 1),
                           scale=(0.4, 0.4, 0.9)), "fuzzy")
        self.into(self.lamp(name="Light", color=(1, 0.5, 0.25)))
        self.into(self.lamp(name="backlight", location=(-3, 3, 3)))
        self.into(self.camera(lens_unit="FOV", angle=math.radians(50)))
        bpy.context.view_layer.update()

    def assert_close(self, ours, theirs, where=""):
        if isinstance(theirs, dict):
            self.assertEqual(set(ours), set(theirs), where)
            for key in theirs:
                self.assert_close(ours[key], theirs[key], f"{where}/{key}")
        elif isinstance(theirs, list):
            self.assertEqual(len(ours), len(theirs), where)
            for i, (a, b) in enumerate(zip(ours, theirs)):
                self.assert_close(a, b, f"{where}[{i}]")
        elif isinstance(theirs, (int, float)):
            self.assertAlmostEqual(ours, theirs, delta=2e-3, msg=where)
        else:
            self.assertEqual(ours, theirs, where)

    def test_agrees_with_the_course_script(self):
        self.course_scene()
        ours = self.export_rt2()
        for key, value in course_script(self.collection).items():
            self.assert_close(ours[key], value, key)
        self.assertEqual(ours["name"], "scene_custom")
        self.assertEqual([m["name"] for m in ours["materials"]], ["default", "grass", "fuzzy", "white_shiny"])
        self.glint("render", self.path("scene.json"), "-o", self.path("a.png"), "--strict")

    def test_the_glint_operator_writes_it_too(self):
        self.course_scene()
        ours = self.export_rt2()
        bpy.ops.export_scene.glint(filepath=self.path("other.json"))
        bpy.ops.export_scene.glint(filepath=self.path("other.txt"), format="RT2")
        for name in ("other.json", "other.txt"):
            self.assertEqual(open(self.path(name), encoding="utf-8").read(), open(self.path("scene.json"), encoding="utf-8").read())
        self.assertEqual(len(ours["spheres"]), 2)

    def test_sizes_are_measured(self):
        self.course_scene()
        self.into(self.add("uv_sphere", name="Ball", radius=0.5, scale=(0.9, 0.9, 0.9), location=(1, -2, 1)))
        self.into(self.add("cylinder", name="tube", radius=0.5, depth=4, smooth=True, scale=(0.5, 0.5, 0.5)))
        ours = self.export_rt2()
        self.assertAlmostEqual(ours["spheres"][-1]["radius"], 0.45, places=5)
        self.assertAlmostEqual(ours["cylinders"][-1]["radius"], 0.25, places=5)
        self.assertAlmostEqual(ours["cylinders"][-1]["height"], 2, places=5)

    def test_only_the_collection_is_exported(self):
        self.course_scene()
        self.add("uv_sphere", name="outside")
        self.add("cube", name="invisible outside").visible_camera = False
        self.assertEqual(len(self.export_rt2()["spheres"]), 2)
        for name in ("outside", "invisible outside"):
            self.assertEqual(sum(f"object '{name}': left out: it is not in the collection" in w for w in self.report_of()), 1)
        other = bpy.data.collections.new("other")
        self.scene.collection.children.link(other)
        self.assertEqual(self.export_rt2(collection="other")["spheres"], [])
        self.collection.name = "renamed"
        self.assertEqual(len(self.export_rt2()["spheres"]), 3)
        with self.assertRaisesRegex(RuntimeError, "no collection 'missing'"):
            self.export_rt2(collection="missing")

    def test_empties_that_instance_a_collection(self):
        """The primitives of the course's older template."""
        self.course_scene()
        source = bpy.data.collections.new("primitive")
        ball = self.add("uv_sphere", name="mesh")
        self.scene.collection.objects.unlink(ball) if ball.name in self.scene.collection.objects else None
        for collection in list(ball.users_collection):
            collection.objects.unlink(ball)
        source.objects.link(ball)
        empty = bpy.data.objects.new("Sphere.empty", None)
        empty.instance_type, empty.instance_collection = "COLLECTION", source
        empty.location, empty.scale = (1, 2, 3), (0.3, 0.3, 0.3)
        self.into(self.link(empty), "black")
        bpy.context.view_layer.update()
        last = self.export_rt2()["spheres"][-1]
        self.assert_close(last, {"center": [1, 2, 3], "radius": 0.3, "material": "black"})

    def test_what_it_cannot_say_is_named_once(self):
        self.course_scene()
        self.into(self.add("monkey", name="Ape"))
        self.into(self.add("cube", name="Crate"))
        self.into(self.lamp("SUN", name="Sunlight", angle=0))
        self.into(self.lamp("AREA", name="Panel light"))
        self.scene.camera.data.shift_x = 0.2
        self.into(self.add("uv_sphere", name="hidden sphere")).hide_render = True
        report = self.report_of()
        for name in ("Ape", "Crate", "Sunlight", "Panel light", "Camera", "hidden sphere"):
            self.assertEqual(sum(f"'{name}'" in w for w in report), 1, report)
        ours = self.export_rt2()
        self.assertEqual((len(ours["spheres"]), len(ours["lights"])), (2, 4))
        self.assertGreater(math.hypot(*ours["lights"][2]["position"]), 9e3)

    def report_of(self, **settings):
        from io_glint import export_files
        options = self.scene.glint.options(**settings)
        return export_files.export_file(bpy.context, self.path("r.json"), options, as_rt2=True).warnings

    def test_a_name_is_enough_for_what_is_nearly_the_shape(self):
        self.course_scene()
        self.into(self.add("uv_sphere", name="Low sphere", segments=6, ring_count=4, location=(0, 0, 3), radius=2, scale=(0.5, 0.5, 0.5)))
        self.assertTrue(any("'Low sphere'" in w for w in self.report_of()))
        self.assert_close(self.export_rt2()["spheres"][-1]["radius"], 1.0)

    def test_a_flat_text_is_no_plane(self):
        self.course_scene()
        curve = bpy.data.curves.new("Text", "FONT")
        curve.body = "flat"
        self.into(self.link(bpy.data.objects.new("Text", curve)))
        self.assertEqual(len(self.export_rt2()["planes"]), 1)

    def test_classical_light(self):
        self.course_scene()
        lamp = bpy.data.objects["Light"]
        target = self.export_rt2()["camera"]["target"]
        expected = 500 / (4 * math.pi ** 2) / math.dist(lamp.location, target) ** 2
        ours = self.export_rt2(light_color="classical")["lights"][0]["color"]
        for a, b in zip(ours, (1, 0.5, 0.25)):
            self.assertAlmostEqual(a, expected * b, places=4)

    def test_own_materials(self):
        self.course_scene()
        gold = self.material("gold", (0.8, 0.6, 0.2), Specular=0.0)
        gold["glint_ambient"], gold["glint_diffuse"], gold["glint_specular"] = 0.1, 0.9, 0.5
        gold["glint_shininess"], gold["glint_mirror"] = 16.0, 0.25
        bpy.data.objects["Sphere"]["material"] = "gold"
        made = next(m for m in self.export_rt2()["materials"] if m["name"] == "gold")
        self.assert_close(made, {"name": "gold", "color": [0.8, 0.6, 0.2], "ambient": 0.1, "diffuse": 0.9, "specular": 0.5,
                                 "shininess": 16.0, "mirror": 0.25})

    def test_the_camera_of_the_collection(self):
        self.course_scene()
        self.scene.camera = None
        self.assertIn("fov", self.export_rt2()["camera"])
        self.assertIsNone(self.scene.camera)
        self.scene.render.resolution_x = 32  # upright: Blender's angle is across the height, RT2's across the width
        fov = self.export_rt2()["camera"]["fov"]
        self.assertAlmostEqual(fov, math.degrees(2 * math.atan(math.tan(math.radians(25)) / 2)), places=3)

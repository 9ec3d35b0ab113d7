# SPDX-License-Identifier: Apache-2.0
"""RT2's exercise as docs/blender.md leads through it, and Add > Mesh > glint."""
import json
import subprocess

import bpy
from support import GLINT, SceneTest


class Exercise(SceneTest):
    def setUp(self):
        super().setUp()
        self.assertEqual(bpy.ops.glint.rt2_exercise(), {"FINISHED"})
        self.scene = bpy.context.scene
        self.collection = bpy.data.collections["scene_custom"]

    def test_it_is_exported_and_drawn_without_a_warning(self):
        made = self.export_rt2()
        self.assertEqual([len(made[k]) for k in ("lights", "spheres", "planes", "cylinders")], [2, 3, 1, 2])
        self.assertEqual(made["lights"][0], {"position": [4, -3, 5], "color": [1, 1, 1]})
        self.assertEqual(made["camera"]["fov"], 45)
        self.assertEqual({m["name"] for m in made["materials"]}, {"grass", "fuzzy", "white_shiny", "black"})
        self.glint("render", self.path("scene.json"), "-o", self.path("a.png"), "--strict")
        self.export()
        self.assertEqual(self.warnings, [])

    def test_f12_is_the_homeworks_picture(self):
        render = self.scene.render
        render.resolution_x, render.resolution_y = 96, 64
        settings = render.image_settings
        settings.file_format, settings.color_mode = "PNG", "RGB"
        render.filepath, render.dither_intensity = self.path("f12.png"), 0
        bpy.ops.render.render(write_still=True)
        self.export_rt2()
        self.glint("render", self.path("scene.json"), "-s", "96x64", "-o", self.path("own.png"))
        answer = subprocess.run([GLINT, "compare", self.path("f12.png"), self.path("own.png"), "--json"],
                                stdout=subprocess.PIPE, check=False)
        self.assertLessEqual(json.loads(answer.stdout)["largest"]["value"], 1)

    def test_a_new_light_lands_in_the_collection(self):
        bpy.ops.object.light_add(type="POINT", location=(0, -5, 2))
        lamp = bpy.context.object
        self.assertEqual(lamp.users_collection, (self.collection,))
        lamp.name = "Lamp"
        made = self.export_rt2()
        self.assertEqual(len(made["lights"]), 3)
        self.assertIn("light 'Lamp': the course's script leaves it out: its name has no \"light\"", self.messages())

    def messages(self):
        from io_glint import course_scene
        return [": ".join(m) for m in course_scene.messages(self.scene, course_scene.collection_of(self.scene))]

    def test_what_is_outside_is_named(self):
        self.assertEqual(self.messages(), [])
        self.scene.collection.objects.link(bpy.data.objects.new("Light9", bpy.data.lights.new("Light9", "POINT")))
        self.add("cube", name="Box")
        for ob in list(bpy.context.object.users_collection):
            ob.objects.unlink(bpy.context.object)
        self.scene.collection.objects.link(bpy.data.objects["Box"])
        self.assertEqual(self.messages(),
                         ["light 'Light9': left out: it is not in the collection 'scene_custom' (M moves it there)",
                          "object 'Box': left out: it is not in the collection 'scene_custom' (M moves it there)"])

    def test_a_second_exercise(self):
        bpy.ops.glint.rt2_exercise()
        self.scene = bpy.context.scene
        self.assertEqual(self.messages(), ["collection 'scene_custom.001': the course's script exports 'scene_custom' alone"])
        self.assertEqual(len(self.export_rt2()["spheres"]), 3)

    def test_moving_a_light_moves_the_shadows(self):
        def part():
            return self.layers("shadow", scene="scene.json", more=("-s", "64x64"))["shadow"].channels["Y"]

        self.export_rt2()
        before = part()
        bpy.data.objects["Light1"].location.x -= 4
        self.export_rt2()
        self.assertNotEqual(before, part())

    def test_a_light_is_added_by_the_naming_rule(self):
        data = bpy.data.lights.new("my light", "POINT")
        ob = bpy.data.objects.new("my light", data)
        ob.location, data.color = (0, -5, 2), (0.2, 0.2, 1)
        self.collection.objects.link(ob)
        light = self.export_rt2()["lights"][-1]
        self.assertEqual(light["position"], [0, -5, 2])
        self.assertAlmostEqual(light["color"][0], 0.2, places=5)

    def test_materials_by_the_property(self):
        bpy.data.objects["Sphere"]["material"] = "mirror"
        gold = bpy.data.materials.new("gold")
        gold["glint_color"], gold["glint_ambient"], gold["glint_diffuse"] = (0.8, 0.6, 0.2), 0.1, 0.6
        gold["glint_specular"], gold["glint_shininess"], gold["glint_mirror"] = 0.6, 20.0, 0.2
        bpy.data.objects["Cylinder"]["material"] = "gold"
        made = self.export_rt2()
        self.assertEqual(made["spheres"][0]["material"], "mirror")
        self.assertEqual(made["cylinders"][0]["material"], "gold")
        self.assertEqual(next(m for m in made["materials"] if m["name"] == "gold")["shininess"], 20)


class AddShapes(SceneTest):
    def test_every_kind_is_exported_as_itself(self):
        self.camera()
        for kind in ("SPHERE", "CYLINDER", "CONE", "PLANE", "DISC", "BOX"):
            self.assertEqual(bpy.ops.mesh.glint_shape_add(kind=kind), {"FINISHED"})
            self.assertEqual(bpy.context.object.glint_shape, kind)
        text = self.export()
        for word in ("sphere", "cylinder", "cone", "plane", "disc", "box"):
            self.assertIn(f'\n{word} "{word.capitalize()}"', text)
        self.glint("render", self.path("scene.glint"), "-o", self.path("a.png"))

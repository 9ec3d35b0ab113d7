# SPDX-License-Identifier: Apache-2.0
"""Color attributes of meshes: their values, where they are interpolated, and which of them a material shows."""
import random

import bpy
from against_cycles import CyclesTest

KINDS = (("POINT", "FLOAT_COLOR"), ("POINT", "BYTE_COLOR"), ("CORNER", "FLOAT_COLOR"), ("CORNER", "BYTE_COLOR"))


class VertexColors(CyclesTest):
    def setUp(self):
        super().setUp()
        self.scene.render.resolution_x = self.scene.render.resolution_y = 60
        self.camera(location=(0, -6, 5), target=(0, 0, 0.5))
        self.lamp("POINT", 400, (2, -3, 4))

    def paint(self, ob, domain="CORNER", kind="BYTE_COLOR", name="Col"):
        """Colors without a pattern."""
        layer, values = ob.data.color_attributes.new(name, kind, domain), random.Random(3)
        for color in layer.data:
            color.color = (values.random(), values.random(), values.random(), 1)
        return ob.data.color_attributes[name]

    def painted(self, name="paint", layer="", node_type="ShaderNodeVertexColor"):
        """A material of the mesh's colors; self.node has their name."""
        material = self.material(name, Specular=0.0)
        self.tree = material.node_tree
        self.node, self.shader_node = self.tree.nodes.new(node_type), self.tree.nodes["Principled BSDF"]
        setattr(self.node, "layer_name" if node_type == "ShaderNodeVertexColor" else "attribute_name", layer)
        self.tree.links.new(self.node.outputs["Color"], self.shader_node.inputs["Base Color"])
        return material

    def colors(self, text):
        """The numbers of the first mesh's colors."""
        line = next(line for line in text.splitlines() if line.startswith("mesh "))
        inside = line.split("colors = ((")[1].split("))")[0]
        return [tuple(map(float, one.split(","))) for one in inside.split("),(")]

    def test_small_and_large_meshes_look_as_in_cycles(self):
        floor = self.add("plane", size=12, material=self.lambert("floor", (0.5, 0.5, 0.5)))
        for domain, kind in KINDS:
            with self.subTest(domain=domain, kind=kind):
                material = self.painted()
                mix = self.tree.nodes.new("ShaderNodeMixRGB")  # a tint
                mix.blend_type, mix.inputs[0].default_value, mix.inputs[2].default_value = "MULTIPLY", 1, (1, 0.7, 0.4, 1)
                self.tree.links.new(self.node.outputs["Color"], mix.inputs[1])
                self.tree.links.new(mix.outputs[0], self.shader_node.inputs["Base Color"])
                for x, subdivisions in ((-1.3, 1), (1.3, 4)):
                    self.paint(self.add("ico_sphere", subdivisions=subdivisions, smooth=x > 0, location=(x, 0, 1), material=material),
                               domain, kind)
                rms, _ = self.differences(256, aa=8)
                self.assertEqual(self.warnings, [])
                self.assertLess(rms, 0.008)
                for ob in list(self.scene.objects):
                    if ob.type == "MESH" and ob != floor:
                        bpy.data.objects.remove(ob)

    def test_bytes_are_decoded_and_floats_taken_as_they_are(self):
        for domain, kind in KINDS:
            plane = self.add("plane", material=self.painted())
            layer = plane.data.color_attributes.new("Col", kind, domain)
            for color in layer.data:
                color.color = (0.5, 0.2140411, -0.5, 1)
            self.assertAlmostEqual(self.colors(self.export())[0][1], 0.2140411, delta=2e-3)
            self.assertAlmostEqual(self.colors(self.export())[0][2], 0)
            bpy.data.objects.remove(plane)

    def test_corners_of_a_vertex_may_differ(self):
        cube = self.add("cube", material=self.painted())
        self.paint(cube, "CORNER")
        self.assertEqual(len(self.colors(self.export())), 24)
        cube.data.color_attributes.remove(cube.data.color_attributes[0])
        self.paint(cube, "POINT")
        self.assertEqual(len(self.colors(self.export())), 8)

    def test_the_colors_of_a_name_and_those_of_renders(self):
        plane = self.add("plane", material=self.painted())
        self.paint(plane, "POINT", "FLOAT_COLOR", "A")
        for color in self.paint(plane, "POINT", "FLOAT_COLOR", "B").data:
            color.color = (0.5, 0.25, 0.125, 1)
        attributes, wanted = plane.data.color_attributes, [(0.5, 0.25, 0.125)]
        attributes.render_color_index = 1
        self.assertEqual(set(self.colors(self.export())), set(wanted))
        attributes.render_color_index = 0
        self.assertNotEqual(set(self.colors(self.export())), set(wanted))
        self.node.layer_name = "B"
        self.assertEqual(set(self.colors(self.export())), set(wanted))
        plane.data.materials[0] = self.painted("other", "B", "ShaderNodeAttribute")
        self.assertEqual(set(self.colors(self.export())), set(wanted))
        self.node.attribute_name = "missing"  # black, as in Cycles
        self.assertEqual(set(self.colors(self.export())), {(0, 0, 0)})
        self.assertEqual(self.warnings, [])

    def test_other_attributes(self):
        plane = self.add("plane", material=self.painted("m", "size", "ShaderNodeAttribute"))
        size = plane.data.attributes.new("size", "FLOAT", "POINT")
        for i, value in enumerate(size.data):
            value.value = 0.25 * i
        self.assertEqual(sorted(self.colors(self.export())), [(0, 0, 0), (0.25,) * 3, (0.5,) * 3, (0.75,) * 3])
        place = plane.data.attributes.new("place", "FLOAT_VECTOR", "FACE")
        place.data[0].vector = (0.1, 0.2, 0.3)
        self.node.attribute_name = "place"
        self.assertEqual(set(self.colors(self.export())), {(0.1, 0.2, 0.3)})
        plane.data.attributes.new("number", "INT", "POINT")
        self.node.attribute_name = "number"
        self.assertEqual(set(self.colors(self.export())), {(0, 0, 0)})
        self.assertEqual(sum("'number'" in w and "counts as 0" in w for w in self.warnings), 1, self.warnings)

    def test_colors_times_an_image(self):
        image = bpy.data.images.new("grey", 2, 2)
        image.colorspace_settings.name = "Non-Color"
        image.pixels[:] = [0.5, 0.5, 0.5, 1] * 4
        plane = self.add("plane", size=4, material=self.painted())
        self.paint(plane)
        mix, texture = self.tree.nodes.new("ShaderNodeMixRGB"), self.tree.nodes.new("ShaderNodeTexImage")
        mix.blend_type, mix.inputs[0].default_value, texture.image = "MULTIPLY", 1, image
        for output, into in ((self.node.outputs["Color"], mix.inputs[1]), (texture.outputs["Color"], mix.inputs[2]),
                             (mix.outputs[0], self.shader_node.inputs["Base Color"])):
            self.tree.links.new(output, into)
        rms, _ = self.differences(256, aa=8)
        self.assertLess(rms, 0.004)
        self.assertIn("texture", self.keys("paint"))

    def test_what_glows(self):
        material = self.shader("ShaderNodeEmission", "screen", Strength=0.7)
        tree = material.node_tree
        node = tree.nodes.new("ShaderNodeVertexColor")
        tree.links.new(node.outputs["Color"], tree.nodes["Emission"].inputs["Color"])
        self.paint(self.add("plane", size=4, material=material))
        rms, _ = self.differences(256, aa=8)
        self.assertLess(rms, 0.005)
        self.assertEqual((self.keys("screen")["ambient"], self.warnings), ("0.7", []))
        self.world((0.1, 0.2, 0.3))
        self.assertIn("type = ambient  color = (1, 1, 1)", self.export())
        self.assertEqual(sum("its light has the tint" in w for w in self.warnings), 1)

    def test_the_worlds_light(self):
        plane = self.add("plane", size=4, material=self.painted(), location=(0, 0, 0))
        self.paint(plane)
        self.world((0.4, 0.4, 0.4))
        keys = self.keys("paint")
        self.assertEqual((keys["color"], keys["ambient"], keys["diffuse"]), ("(1, 1, 1)", "0.4", "1"))
        self.assertEqual(self.warnings, [])
        self.assertIn("type = ambient  color = (1, 1, 1)", self.export())

    def test_a_worlds_light_with_a_tint(self):
        """It is in the ambient light, and the other materials look as before."""
        self.paint(self.add("plane", size=4, material=self.painted(), location=(-2, 0, 0)))
        image = bpy.data.images.new("grey", 2, 2)
        image.pixels[:] = [0.5, 0.6, 0.7, 1] * 4
        others = [self.material("green", (0.2, 0.8, 0.1)), self.shader("ShaderNodeEmission", "lamp", Color=(1, 0.5, 0), Strength=0.3),
                  self.material("picture")]
        tree = others[2].node_tree
        node = tree.nodes.new("ShaderNodeTexImage")
        node.image = image
        tree.links.new(node.outputs["Color"], tree.nodes["Principled BSDF"].inputs["Base Color"])
        for i, material in enumerate(others):
            self.add("plane", size=1, location=(1, i - 1, 0.1), material=material)
        grass = self.add("plane", size=1, location=(2, 0, 0.1))
        grass["material"] = "grass"
        self.world((0.2, 0, 0.6))
        self.assertIn("type = ambient  color = (0.3333333, 0, 1)", self.export())
        self.assertEqual(self.warnings, [])
        tinted = self.layers("background")["beauty"].channels
        self.objects_of_colors_hidden(True)
        self.assertIn("type = ambient  color = (1, 1, 1)", self.export())
        plain = self.layers("background")["beauty"].channels
        width = self.scene.render.resolution_x
        for channel in "RGB":
            right = [(a, b) for i, (a, b) in enumerate(zip(tinted[channel], plain[channel])) if i % width > 0.55 * width]
            self.assertLess(max(abs(a - b) for a, b in right), 1e-5)
            self.assertGreater(max(b for _, b in right), 0.1)
        self.objects_of_colors_hidden(False)
        self.scene.objects["Key"].hide_render = True
        self.export()
        ours = self.layers("background", aa=8)["beauty"]
        self.scene.cycles.max_bounces = 0
        theirs = self.cycles(256)
        left = [i for i in range(len(ours.channels["R"])) if i % width < 0.4 * width]
        for channel in "RGB":
            self.assertLess(sum((ours.channels[channel][i] - theirs.channels[channel][i])**2 for i in left) / len(left), 0.01**2)

    def objects_of_colors_hidden(self, is_hidden):
        for ob in self.scene.objects:
            if ob.type == "MESH" and ob.data.color_attributes:
                ob.hide_render = is_hidden

    def test_rt2_has_one_color(self):
        self.paint(self.add("plane", name="plane", material=self.painted()))
        self.assertEqual(len(self.export_rt2()["materials"]), 1)

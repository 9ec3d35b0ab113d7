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

    def test_the_worlds_light(self):
        plane = self.add("plane", size=4, material=self.painted(), location=(0, 0, 0))
        self.paint(plane)
        self.world((0.4, 0.4, 0.4))
        keys = self.keys("paint")
        self.assertEqual((keys["color"], keys["ambient"], keys["diffuse"]), ("(1, 1, 1)", "0.4", "1"))
        self.assertEqual(self.warnings, [])
        self.world((0.2, 0.4, 0.6))
        self.assertEqual(self.keys("paint")["ambient"], "0.4")
        self.assertEqual(sum("without its tint" in w for w in self.warnings), 1)

    def test_rt2_has_one_color(self):
        self.paint(self.add("plane", name="plane", material=self.painted()))
        self.assertEqual(len(self.export_rt2()["materials"]), 1)

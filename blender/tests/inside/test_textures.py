# SPDX-License-Identifier: Apache-2.0
"""Image textures: the same places, edges, colors and transparency as in Cycles; and what has none."""
import math
import os
import re
import struct

import bpy
from textured import Textured


class AgainstCycles(Textured):
    def check(self, most, samples=256):
        rms, _ = self.differences(samples, aa=8)
        self.assertEqual(self.warnings, [])
        self.assertLess(rms, most)

    def test_mappings(self):
        self.lamp("SUN", 3, angle=0)
        plane = self.add("plane", size=5, material=self.textured(self.image()))
        for extension in ("REPEAT", "EXTEND", "CLIP"):
            for kind, scale in (("POINT", (1.5, 2.5, 1)), ("TEXTURE", (0.6, 0.4, 2)), ("VECTOR", (1.5, -0.7, 1))):
                with self.subTest(extension=extension, kind=kind):
                    plane.data.materials[0] = self.textured(self.image(), extension=extension)
                    self.mapping(kind, (0.3, -0.2, 0.1), (0.2, 0.3, 0.5), scale)
                    self.check(0.006)

    def test_between_texels(self):
        self.lamp("SUN", 3, angle=0)
        plane = self.add("plane", size=5)
        plane.data.materials.append(None)
        for extension in ("REPEAT", "EXTEND", "CLIP"):
            with self.subTest(extension=extension):
                plane.data.materials[0] = self.textured(self.image(), interpolation="Linear", extension=extension)
                self.mapping("POINT", (-0.3, -0.2, 0), scale=(1.6, 1.4, 1))
                self.check(0.001)

    def test_encoded_colors(self):
        self.lamp("POINT", 300, (1, -1, 3))
        self.add("plane", size=5, material=self.textured(self.image(space="sRGB")))
        self.add("uv_sphere", smooth=True, location=(0.5, 0, 1), material=self.textured(self.image("sky", 16, space="sRGB")))
        self.add("ico_sphere", subdivisions=5, smooth=True, location=(-1.2, 0.3, 0.5), radius=0.6,
                 material=self.textured(self.image("sea", 4, space="sRGB")))
        self.check(0.012)

    def test_transparency(self):
        """Where an image's alpha is used, also by older materials, and where it is not."""
        self.lamp("POINT", 300, (1, -1, 4))
        self.add("plane", size=8, material=self.lambert("floor", (0.5, 0.5, 0.5)))
        leaf = self.add("plane", size=2, location=(0, 0, 1))
        leaf.data.materials.append(None)
        for space in ("Non-Color", "sRGB"):
            for use in ("unused", "alpha", "alpha only", "mix shader"):
                with self.subTest(space=space, use=use):
                    leaf.data.materials[0] = self.textured(self.image(alpha=True, space=space))
                    nodes, inputs = self.tree.nodes, self.shader_node.inputs
                    if use.startswith("alpha"):
                        self.tree.links.new(self.node.outputs["Alpha"], inputs["Alpha"])
                    if use == "alpha only":
                        self.tree.links.remove(inputs["Base Color"].links[0])
                    if use == "mix shader":
                        mix, clear = nodes.new("ShaderNodeMixShader"), nodes.new("ShaderNodeBsdfTransparent")
                        for output, into in ((self.node.outputs["Alpha"], mix.inputs[0]), (clear.outputs[0], mix.inputs[1]),
                                             (self.shader_node.outputs[0], mix.inputs[2]),
                                             (mix.outputs[0], nodes["Material Output"].inputs["Surface"])):
                            self.tree.links.new(output, into)
                    self.check(0.006)

    def test_a_generated_image_has_alpha_whatever_its_depth(self):
        self.lamp("SUN", 3, angle=0)
        image = self.image(space="sRGB")
        self.assertEqual(image.depth, 24)
        pixels = list(image.pixels)
        pixels[3::4] = [0.5] * 64
        image.pixels[:] = pixels
        self.add("plane", size=5, material=self.textured(image))
        self.check(0.006)

    def test_what_glows_and_what_is_tinted(self):
        material = self.shader("ShaderNodeEmission", "screen", Strength=0.7)
        tree = material.node_tree
        image, mix = tree.nodes.new("ShaderNodeTexImage"), tree.nodes.new("ShaderNodeMixRGB")
        image.image, image.interpolation, mix.blend_type = self.image(), "Closest", "MULTIPLY"
        mix.inputs[0].default_value, mix.inputs[1].default_value = 1, (1, 0.6, 0.3, 1)
        tree.links.new(image.outputs["Color"], mix.inputs[2])
        tree.links.new(mix.outputs[0], tree.nodes["Emission"].inputs["Color"])
        self.add("plane", size=4, material=material)
        self.check(0.004)

    def test_numbers_above_1(self):
        image = bpy.data.images.new("bright", 2, 2, float_buffer=True)
        image.colorspace_settings.name = "Non-Color"
        image.pixels[:] = [4, 2, 0.5, 1] * 2 + [0.001, 0.002, 0.1, 1] * 2
        self.lamp("SUN", 0.5, angle=0)
        self.add("plane", size=4, material=self.textured(image))
        self.check(0.01)


class Keys(Textured):
    def setUp(self):
        super().setUp()
        self.lamp()

    def test_clip_without_mixing_needs_no_other_image(self):
        self.add("plane", material=self.textured(self.image(), extension="CLIP"))
        sizes = {}
        for interpolation in ("Closest", "Linear"):
            self.node.interpolation = interpolation
            block = self.block("texture", self.export())
            self.assertIn('wrap_u = clip' if interpolation == "Closest" else 'wrap_u = clamp', block)
            with open(self.path(re.search(r'file = "([^"]*)"', block)[1]), "rb") as file:
                sizes[interpolation] = struct.unpack(">II", file.read(24)[16:])
        self.assertEqual(sizes, {"Closest": (8, 8), "Linear": (10, 10)})

    def test_the_uv_map_of_a_name_and_that_of_renders(self):
        self.add("plane", material=self.textured(self.image()))
        mesh = bpy.context.object.data
        other = mesh.uv_layers.new(name="Other")
        for i, corner in enumerate(other.data):
            corner.uv = (0.25 * i, 0.5)
        mesh.uv_layers["UVMap"].active_render = True
        first = self.block("mesh", self.export())
        self.assertIn("texture_coordinates = ((0,0),(1,0),(1,1),(0,1))", first)
        other.active_render = True
        second = self.block("mesh", self.export())
        self.assertIn("(0.25,0.5)", second)
        _, uv = self.mapping("POINT")
        for name, wanted in (("UVMap", first), ("Other", second), ("", second)):
            uv.uv_map = name
            self.assertEqual(self.block("mesh", self.export()), wanted, name)
        uv.uv_map = "missing"  # Cycles takes (0, 0)
        self.assertIn("texture_coordinates = ((0,0),(0,0),(0,0),(0,0))", self.block("mesh", self.export()))

    def test_materials_with_and_without_an_image_on_one_mesh(self):
        for levels, count in ((0, 1), (5, 0)):
            cube = self.add("cube", material=self.textured(self.image()))
            cube.data.materials.append(self.material("plain"))
            for polygon in cube.data.polygons:
                polygon.material_index = polygon.index % 2
            modifier = cube.modifiers.new("s", "SUBSURF")
            modifier.render_levels, modifier.subdivision_type = levels, "SIMPLE"
            text = self.export()
            self.assertEqual(text.count("\nmesh "), 1 if count else 2)
            self.assertEqual(text.count("triangle{"), 6 * count)
            self.glint("render", self.path("scene.glint"), "-o", self.path("a.png"), "--strict")
            bpy.data.objects.remove(cube)

    def test_alpha_that_is_clipped(self):
        material = self.textured(self.image(alpha=True))
        self.tree.links.new(self.node.outputs["Alpha"], self.shader_node.inputs["Alpha"])
        material.blend_method, material.alpha_threshold = "CLIP", 0.3
        self.add("plane", material=material)
        self.assertIn("alpha = mask  alpha_cutoff = 0.3", self.block("texture", self.export()))
        material.blend_method = "BLEND"
        self.assertNotIn("mask", self.block("texture", self.export()))
        self.node.image.alpha_mode = "NONE"
        self.assertIn("alpha = ignore", self.block("texture", self.export()))

    def test_shapes_of_their_own_have_the_mean(self):
        ball = self.add("uv_sphere", name="Ball", smooth=True, material=self.textured(self.image()))
        self.assertIn("\nmesh ", self.export())  # else it would be a sphere
        ball["glint_shape"] = "SPHERE"
        text = self.export()
        self.assertIn("texture", text)
        self.assertIn('material = "paint 2"', self.block("sphere", text))
        self.assertEqual(self.warnings, ["material 'paint': the image at 'Base Color' is exported as its mean color"])

    def test_equal_meshes_with_other_maps(self):
        """They share their triangles, but not their places in the image."""
        material = self.textured(self.image())
        for i in range(2):
            self.add("ico_sphere", subdivisions=5, location=(2 * i, 0, 0), material=material)
        bpy.context.object.data.uv_layers[0].data[0].uv = (0.77, 0.33)
        self.export()
        self.assertEqual(len(os.listdir(self.path("scene_meshes"))), 2)

    def test_metals_are_named(self):
        self.add("plane", material=self.textured(self.image()))
        self.shader_node.inputs["Metallic"].default_value = 1
        text = self.export()
        self.assertEqual(sum("highlights, reflections and glass have the mean color" in w for w in self.warnings), 1)
        self.assertIn("texture", text)

    def test_glow_beside_an_image_stays_as_it_is(self):
        self.add("plane", material=self.textured(self.image()))
        for name, value in (("Emission", (1, 0.5, 0, 1)), ("Emission Strength", 2)):
            self.shader_node.inputs[name].default_value = value
        keys = self.keys("paint")
        self.assertEqual((keys["emission_color"], keys["ambient_color"]), ("(2, 1, 0)", "(0, 0, 0)"))

    def test_what_has_no_texture_is_the_mean_and_says_why(self):
        reasons = {
            "its projection is 'box'": lambda: setattr(self.node, "projection", "BOX"),
            "images of the source 'tiled' have no texture": lambda: setattr(self.node.image, "source", "TILED"),
            "its color space is XYZ": lambda: setattr(self.node.image.colorspace_settings, "name", "XYZ"),
            "it has a mapping of its own": lambda: setattr(self.node.texture_mapping, "scale", (2, 1, 1)),
            "the type of its Mapping node is 'normal'": lambda: self.mapping("NORMAL"),
            "the output 'Generated' of its Texture Coordinate node gives no coordinates that glint has": lambda: self.tree.links.new(
                self.tree.nodes.new("ShaderNodeTexCoord").outputs["Generated"], self.node.inputs["Vector"]),
            "the scale of its Mapping node is not the same everywhere": lambda: self.tree.links.new(
                self.tree.nodes.new("ShaderNodeTexNoise").outputs["Color"], self.mapping("POINT")[0].inputs["Scale"]),
        }
        plane = self.add("plane", material=self.material())
        for reason, change in reasons.items():
            with self.subTest(reason=reason):
                image = self.save_small(reason)
                plane.data.materials[0] = self.textured(image)
                change()
                text = self.export()
                self.assertNotIn("texture", text.replace(reason, ""))
                self.assertTrue(any("exported as its mean color: " + reason in w for w in self.warnings), self.warnings)

    def save_small(self, name):
        image = self.image(name[:8])
        image.filepath_raw, image.file_format = self.path("small.png"), "PNG"
        image.save()
        return bpy.data.images.load(self.path("small.png"))

    def test_smoothed_texels_are_named(self):
        self.add("plane", material=self.textured(self.image(), interpolation="Cubic"))
        self.export()
        self.assertEqual(sum("interpolation" in w for w in self.warnings), 1, self.warnings)

    def test_two_images(self):
        """Alpha of another image is its mean; two textured shaders that are mixed are their means."""
        self.add("plane", material=self.textured(self.image()))
        other = self.tree.nodes.new("ShaderNodeTexImage")
        other.image = self.image("other", alpha=True)
        self.tree.links.new(other.outputs["Alpha"], self.shader_node.inputs["Alpha"])
        self.export()
        self.assertTrue(any("mean alpha: the base color has another image" in w for w in self.warnings), self.warnings)
        mix, second = self.tree.nodes.new("ShaderNodeMixShader"), self.tree.nodes.new("ShaderNodeBsdfDiffuse")
        for output, into in ((other.outputs["Color"], second.inputs["Color"]), (self.shader_node.outputs[0], mix.inputs[1]),
                             (second.outputs[0], mix.inputs[2]), (mix.outputs[0], self.tree.nodes["Material Output"].inputs[0])):
            self.tree.links.new(output, into)
        self.tree.links.remove(self.shader_node.inputs["Alpha"].links[0])
        keys = self.keys("paint")
        self.assertTrue(any("two of its shaders have colors" in w for w in self.warnings), self.warnings)
        mean = 0.1 + 0.8 * 3.5 / 8
        self.assertTrue(math.isclose(float(keys["diffuse_color"][1:].split(",")[0]), mean, abs_tol=0.02), keys)

# SPDX-License-Identifier: Apache-2.0
"""Materials: the order of what decides, node types, linked sockets, and glint's own keys."""
import bpy
from support import SceneTest


class Materials(SceneTest):
    def setUp(self):
        super().setUp()
        self.camera()
        self.lamp()

    def test_none(self):
        self.add("cube")
        self.assertEqual(self.keys("no material")["diffuse_color"], "(0.8, 0.8, 0.8)")

    def test_principled(self):
        self.add("cube", material=self.material("p", (0.5, 0.25, 0.1), Roughness=0.5, Specular=0.0))
        self.assertEqual(self.keys("p"), {"color": "(0.5, 0.25, 0.1)", "ambient_color": "(0, 0, 0)",
                                          "diffuse_color": "(0.5, 0.25, 0.1)", "specular_color": "(0, 0, 0)",
                                          "shininess": "30"})

    def test_metal_and_glass(self):
        self.add("cube", material=self.material("metal", (0.9, 0.6, 0.3), Metallic=1.0, Roughness=0.15))
        metal = self.keys("metal")
        self.assertAlmostEqual(float(metal["mirror"]), 0.45, places=4)
        self.assertEqual(metal["mirror_color"], "(1, 0.6666667, 0.3333334)")
        self.add("cube", name="pane", material=self.shader("ShaderNodeBsdfGlass", "glass", Color=(1, 0.5, 1), IOR=1.5))
        glass = self.keys("glass")
        self.assertEqual((glass["transmission"], glass["ior"], glass["transmission_color"]), ("1", "1.5", "(1, 0.25, 1)"))

    def test_emission_is_ambient(self):
        self.add("cube", material=self.shader("ShaderNodeEmission", "lamp", Color=(1, 0.5, 0.25), Strength=3.0))
        self.assertEqual(self.keys("lamp")["ambient_color"], "(3, 1.5, 0.75)")
        self.assertIn("light { type = ambient  color = (1, 1, 1) }", self.export())

    def test_mix_and_transparency(self):
        material = self.shader("ShaderNodeBsdfDiffuse", "both", Color=(1, 0, 0))
        tree = material.node_tree
        mix, second = tree.nodes.new("ShaderNodeMixShader"), tree.nodes.new("ShaderNodeBsdfTransparent")
        first = tree.nodes["Diffuse BSDF"]
        mix.inputs[0].default_value = 0.25
        tree.links.new(first.outputs[0], mix.inputs[1])
        tree.links.new(second.outputs[0], mix.inputs[2])
        tree.links.new(mix.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
        self.add("cube", material=material)
        keys = self.keys("both")
        self.assertEqual((keys["diffuse_color"], keys["transmission"], keys["ior"]), ("(0.75, 0, 0)", "0.25", "1"))

    def test_linked_sockets(self):
        material = self.material("linked")
        tree = material.node_tree
        node = tree.nodes["Principled BSDF"]
        rgb, reroute = tree.nodes.new("ShaderNodeRGB"), tree.nodes.new("NodeReroute")
        rgb.outputs[0].default_value = (0.1, 0.2, 0.3, 1)
        tree.links.new(rgb.outputs[0], reroute.inputs[0])
        tree.links.new(reroute.outputs[0], node.inputs["Base Color"])
        self.add("cube", material=material)
        self.assertEqual(self.keys("linked")["color"], "(0.1, 0.2, 0.3)")
        noise = tree.nodes.new("ShaderNodeTexNoise")
        tree.links.new(noise.outputs[0], node.inputs["Roughness"])
        self.export()
        self.assertEqual(sum("'linked'" in w and "Noise" in w and "'Roughness'" in w for w in self.warnings), 1, self.warnings)

    def test_the_alpha_of_an_image_is_its_mean_alpha(self):
        for pixels, transmission in (([1, 1, 1, 1, 1, 1, 1, 0.5], 0.25), ([0, 0, 0, 1] * 2, None)):
            image = bpy.data.images.new("leaf", 2, 1, alpha=True, float_buffer=True)
            image.pixels[:] = pixels
            material = self.material(f"leaf {transmission}")
            texture = material.node_tree.nodes.new("ShaderNodeTexImage")
            texture.image, texture.projection = image, "BOX"
            material.node_tree.links.new(texture.outputs["Alpha"], material.node_tree.nodes["Principled BSDF"].inputs["Alpha"])
            self.add("cube", material=material)
            found = self.keys(material.name).get("transmission")
            self.assertEqual(found and float(found), transmission)
            self.assertTrue(any("mean alpha" in w for w in self.warnings))

    def test_an_image_in_a_projection_is_its_mean(self):
        image = bpy.data.images.new("picture", 2, 2, float_buffer=True)
        image.pixels[:] = [1, 0, 0, 1, 0, 1, 0, 1, 1, 1, 0, 1, 0, 0, 0, 1]
        material = self.material("textured")
        texture = material.node_tree.nodes.new("ShaderNodeTexImage")
        texture.image, texture.projection = image, "SPHERE"
        material.node_tree.links.new(texture.outputs["Color"], material.node_tree.nodes["Principled BSDF"].inputs["Base Color"])
        self.add("cube", material=material)
        self.assertEqual(self.keys("textured")["color"], "(0.5, 0.5, 0)")
        self.assertTrue(any("mean color" in w for w in self.warnings))

    def test_unknown_shaders_are_named(self):
        material = self.shader("ShaderNodeBsdfToon", "toon")
        material.diffuse_color = (0.1, 0.6, 0.1, 1)
        self.add("cube", material=material)
        self.assertEqual(self.keys("toon")["color"], "(0.1, 0.6, 0.1)")
        self.assertTrue(any("'toon'" in w and "Toon" in w for w in self.warnings))

    def test_without_nodes(self):
        material = bpy.data.materials.new("plain")
        material.diffuse_color, material.roughness = (0.3, 0.3, 0.9, 1), 1.0
        self.add("cube", material=material)
        self.assertEqual(self.keys("plain")["color"], "(0.3, 0.3, 0.9)")

    def test_the_keys_of_glint_replace_those_of_nodes(self):
        material = self.material("mine", (0.5, 0.5, 0.5), Specular=0.0)
        material["glint_specular"], material["glint_shininess"] = 0.7, 12
        material["glint_color"] = (1.0, 0.5, 0.0)
        material["glint_ambient"] = 0.25
        self.add("cube", material=material)
        keys = self.keys("mine")
        self.assertEqual((keys["color"], keys["ambient"], keys["specular"], keys["shininess"], keys["diffuse_color"]),
                         ("(1, 0.5, 0)", "0.25", "0.7", "12", "(0.5, 0.5, 0.5)"))
        self.assertNotIn("specular_color", keys)
        material["glint_specular"], material["glint_mirror"] = "much", 3.0
        self.assertIn("specular_color", self.keys("mine"))
        self.assertEqual(sum("glint does not take" in w for w in self.warnings), 2)

    def test_the_panel_adds_and_removes_keys(self):
        material = self.material("mine")
        self.add("cube", material=material)
        with bpy.context.temp_override(material=material):
            for name in ("color", "shininess"):
                bpy.ops.glint.material_key(key=name)
                self.assertIn(f"glint_{name}", material)
            bpy.ops.glint.material_key(key="color")
        self.assertNotIn("glint_color", material)
        self.assertEqual(self.keys("mine")["shininess"], "32")

    def test_the_property_of_rt2(self):
        for name, wanted in (("a", "grass"), ("b", "own"), ("c", "no such")):
            self.add("cube", name=name)["material"] = wanted
        self.material("own", (0.1, 0.1, 0.9))
        text = self.export()
        for name, used in (("a", "grass"), ("b", "own"), ("c", "no material")):
            line = next(line for line in text.splitlines() if line.startswith(f'box "{name}"'))
            self.assertIn(f'material = "{used}"', line)
        self.assertIn('material "grass" { color = (0.1, 0.7, 0.01)  ambient = 0.2', text)
        self.assertEqual(sum("'no such'" in w for w in self.warnings), 1)

    def test_numbers_beyond_glints_ranges_are_cut_off(self):
        self.add("cube", material=self.material("nan", (float("nan"), -1, 5), Emission_Strength=1e9, IOR=0.0, Transmission=1.0))
        self.add("cube", name="b", material=self.shader("ShaderNodeEmission", "bright", Color=(1, 1, 1), Strength=1e9))
        self.world((1e9, 0, float("inf")))
        self.export()
        for name in ("material 'nan'", "material 'bright'", "world 'World'"):
            self.assertTrue(any(name in w for w in self.warnings), (name, self.warnings))
        self.glint("render", self.path("scene.glint"), "-o", self.path("a.png"))

    def test_all_node_types_are_accepted_by_glint(self):
        for node in ("Diffuse", "Glossy", "Glass", "Transparent", "Principled"):
            self.add("cube", name=node, material=self.shader(f"ShaderNodeBsdf{node}", node))
        self.world((0.1, 0.2, 0.3))
        self.export()
        self.glint("render", self.path("scene.glint"), "-o", self.path("a.png"), "--strict")

# SPDX-License-Identifier: Apache-2.0
"""Links of shader nodes: groups within groups, muted nodes, mixed colors; the view layer's material override."""
import bpy
from support import SceneTest

RED, BLUE = (1.0, 0.0, 0.0, 1.0), (0.0, 0.0, 1.0, 1.0)


class Links(SceneTest):
    def setUp(self):
        super().setUp()
        self.camera()
        self.lamp()
        self.made = self.material("made", Specular=0.0)
        self.tree = self.made.node_tree
        self.principled = self.tree.nodes["Principled BSDF"]
        self.add("cube", material=self.made)

    def color(self):
        return tuple(float(v) for v in self.keys("made")["color"].strip("()").split(", "))

    def assert_color(self, wanted):
        for a, b in zip(self.color(), wanted):
            self.assertAlmostEqual(a, b, places=5)
        self.assertEqual(self.warnings, [])

    def connect(self, output, into):
        return self.tree.links.new(output, into)

    def group(self, name, fill):
        """A node group with the input and output "Color"; fill(tree, its input node, its output node) links them."""
        tree = bpy.data.node_groups.new(name, "ShaderNodeTree")
        if hasattr(tree, "interface"):
            for side in ("INPUT", "OUTPUT"):
                tree.interface.new_socket("Color", in_out=side, socket_type="NodeSocketColor")
        else:
            tree.inputs.new("NodeSocketColor", "Color")
            tree.outputs.new("NodeSocketColor", "Color")
        fill(tree, tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput"))
        return tree

    def add_group(self, inner, tree=None):
        node = (tree or self.tree).nodes.new("ShaderNodeGroup")
        node.node_tree = inner
        return node

    def test_long_chains_with_common_inputs(self):
        """Each node is read once: 2^28 times would not end."""
        last = self.tree.nodes.new("ShaderNodeRGB").outputs[0]
        last.default_value = (0.5, 0.25, 0.125, 1)
        for _ in range(28):
            mix = self.tree.nodes.new("ShaderNodeMixRGB")
            for i in (1, 2):
                self.connect(last, mix.inputs[i])
            last = mix.outputs[0]
        self.connect(last, self.principled.inputs["Base Color"])
        self.assert_color((0.5, 0.25, 0.125))
        shader = self.principled.outputs[0]
        for _ in range(28):
            mix = self.tree.nodes.new("ShaderNodeMixShader")
            for i in (1, 2):
                self.connect(shader, mix.inputs[i])
            shader = mix.outputs[0]
        self.connect(shader, self.tree.nodes["Material Output"].inputs["Surface"])
        self.assert_color((0.5, 0.25, 0.125))

    def test_links_in_a_circle(self):
        one, other = (self.tree.nodes.new("ShaderNodeMixRGB") for _ in range(2))
        for i in (1, 2):
            self.connect(one.outputs[0], other.inputs[i])
            self.connect(other.outputs[0], one.inputs[i])
        self.connect(one.outputs[0], self.principled.inputs["Base Color"])
        self.assertIn('material "made"', self.export())

    def test_groups_within_groups(self):
        def pass_on(tree, start, end):
            tree.links.new(start.outputs[0], end.inputs[0])

        def pass_through_a_group(tree, start, end):
            node, reroute = self.add_group(inner, tree), tree.nodes.new("NodeReroute")
            tree.links.new(start.outputs[0], reroute.inputs[0])
            tree.links.new(reroute.outputs[0], node.inputs[0])
            tree.links.new(node.outputs[0], end.inputs[0])

        inner = self.group("inner", pass_on)
        outer = self.add_group(self.group("outer", pass_through_a_group))
        outer.inputs[0].default_value = BLUE
        self.connect(outer.outputs[0], self.principled.inputs["Base Color"])
        self.assert_color(BLUE[:3])
        rgb = self.tree.nodes.new("ShaderNodeRGB")
        rgb.outputs[0].default_value = RED
        self.connect(rgb.outputs[0], outer.inputs[0])
        self.assert_color(RED[:3])

    def test_a_group_that_makes_its_color(self):
        def make(tree, _, end):
            rgb = tree.nodes.new("ShaderNodeRGB")
            rgb.outputs[0].default_value = BLUE
            tree.links.new(rgb.outputs[0], end.inputs[0])

        self.connect(self.add_group(self.group("blue", make)).outputs[0], self.principled.inputs["Base Color"])
        self.assert_color(BLUE[:3])
        unlinked = self.add_group(self.group("unlinked", lambda *_: None))
        unlinked.node_tree.nodes["Group Output"].inputs[0].default_value = RED
        self.connect(unlinked.outputs[0], self.principled.inputs["Base Color"])
        self.assert_color(RED[:3])

    def test_a_shader_in_a_group(self):
        tree = bpy.data.node_groups.new("shader", "ShaderNodeTree")
        if hasattr(tree, "interface"):
            tree.interface.new_socket("Color", in_out="INPUT", socket_type="NodeSocketColor")
            tree.interface.new_socket("Shader", in_out="OUTPUT", socket_type="NodeSocketShader")
        else:
            tree.inputs.new("NodeSocketColor", "Color")
            tree.outputs.new("NodeSocketShader", "Shader")
        start, end = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
        mix, diffuse = tree.nodes.new("ShaderNodeMixShader"), tree.nodes.new("ShaderNodeBsdfDiffuse")
        mix.inputs[0].default_value = 0.25
        tree.links.new(start.outputs[0], diffuse.inputs["Color"])
        tree.links.new(diffuse.outputs[0], mix.inputs[1])
        tree.links.new(mix.outputs[0], end.inputs[0])
        node = self.add_group(tree)
        node.inputs[0].default_value = RED
        self.connect(node.outputs[0], self.tree.nodes["Material Output"].inputs["Surface"])
        self.assertEqual(self.keys("made")["diffuse_color"], "(0.75, 0, 0)")
        node.mute = True
        self.assertEqual(self.keys("made")["diffuse_color"], "(0, 0, 0)")

    def test_muted_nodes(self):
        mix, rgb = self.tree.nodes.new("ShaderNodeMixRGB"), self.tree.nodes.new("ShaderNodeRGB")
        rgb.outputs[0].default_value = BLUE
        self.connect(rgb.outputs[0], mix.inputs["Color1"])
        self.connect(mix.outputs[0], self.principled.inputs["Base Color"])
        mix.inputs["Color2"].default_value = RED
        self.assert_color((0.5, 0, 0.5))
        mix.mute = True
        self.assert_color(BLUE[:3])
        mix.mute, rgb.mute = False, True
        mix.inputs["Color1"].default_value = (0, 1, 0, 1)
        self.assert_color((0.5, 0.5, 0))

    def mixes(self):
        """(node, factor, a, b, output) of the nodes for colors that this Blender has."""
        old = self.tree.nodes.new("ShaderNodeMixRGB")
        if old.bl_idname == "ShaderNodeMixRGB":
            yield (old, *old.inputs[:3], old.outputs[0])
        if hasattr(bpy.types, "ShaderNodeMix"):
            new = self.tree.nodes.new("ShaderNodeMix")
            new.data_type = "RGBA"
            by_identifier = {socket.identifier: socket for socket in (*new.inputs, *new.outputs)}
            yield new, *(by_identifier[name] for name in ("Factor_Float", "A_Color", "B_Color", "Result_Color"))

    def test_mixed_colors(self):
        # a = (0.5, 0.25, 0.8), b = (0.2, 0.5, 0.4), factor 0.5
        wanted = {"MIX": (0.35, 0.375, 0.6), "ADD": (0.6, 0.5, 1.0), "SUBTRACT": (0.4, 0.0, 0.6),
                  "MULTIPLY": (0.3, 0.1875, 0.56), "SCREEN": (0.55, 0.4375, 0.84), "DIFFERENCE": (0.4, 0.25, 0.6),
                  "DARKEN": (0.35, 0.25, 0.6), "LIGHTEN": (0.5, 0.375, 0.8), "DIVIDE": (1.5, 0.375, 1.4)}
        for node, factor, a, b, output in self.mixes():
            factor.default_value, a.default_value, b.default_value = 0.5, (0.5, 0.25, 0.8, 1), (0.2, 0.5, 0.4, 1)
            self.connect(output, self.principled.inputs["Base Color"])
            for kind, color in wanted.items():
                with self.subTest(node=node.bl_idname, kind=kind):
                    node.blend_type = kind
                    self.assert_color(color)
            clamps = "use_clamp" if hasattr(node, "use_clamp") else "clamp_result"
            setattr(node, clamps, True)
            self.assert_color((1, 0.375, 1))
            setattr(node, clamps, False)
            node.blend_type, factor.default_value = "MIX", 3
            self.assert_color((0.2, 0.5, 0.4))
            node.blend_type = "HUE"
            self.export()
            self.assertEqual(sum("'made'" in w and node.bl_label in w and "'Base Color'" in w for w in self.warnings), 1)

    def test_a_number_that_is_mixed(self):
        if not hasattr(bpy.types, "ShaderNodeMix"):
            self.skipTest("3.3 has none")
        node = self.tree.nodes.new("ShaderNodeMix")
        by_identifier = {socket.identifier: socket for socket in (*node.inputs, *node.outputs)}
        for name, value in (("Factor_Float", 0.25), ("A_Float", 1), ("B_Float", 0)):
            by_identifier[name].default_value = value
        self.connect(by_identifier["Result_Float"], self.principled.inputs["Alpha"])
        self.assertEqual(self.keys("made")["transmission"], "0.25")

    def test_an_image_that_is_mixed(self):
        image = bpy.data.images.new("white", 2, 2, float_buffer=True)
        image.pixels[:] = [1.0] * 16
        mix, texture = self.tree.nodes.new("ShaderNodeMixRGB"), self.tree.nodes.new("ShaderNodeTexImage")
        texture.image = image
        mix.blend_type, mix.inputs[0].default_value, mix.inputs[2].default_value = "DARKEN", 1, RED
        self.connect(texture.outputs["Color"], mix.inputs[1])
        self.connect(mix.outputs[0], self.principled.inputs["Base Color"])
        self.assertEqual(self.color(), RED[:3])
        self.assertEqual(sum("mean color" in w for w in self.warnings), 1)


class Override(SceneTest):
    def test_the_view_layers_material_replaces_all(self):
        self.camera()
        self.lamp()
        ball = self.add("cube", name="two", material=self.material("own"))
        ball.data.materials.append(self.material("other"))
        ball.data.polygons[0].material_index = 1
        self.add("cube", name="none")
        self.add("cube", name="grass")["material"] = "grass"
        bpy.context.view_layer.material_override = self.material("clay", (0.2, 0.3, 0.4))
        for evaluation in ("RENDER", "VIEWPORT"):
            text = self.export(evaluation=evaluation)
            self.assertEqual([line.split('"')[1] for line in text.splitlines() if line.startswith("material ")], ["clay"])
            self.assertIn("color = (0.2, 0.3, 0.4)", text)
            self.assertEqual(self.warnings, [])
        self.add("plane", name="plane", size=5)
        self.assertEqual([m["name"] for m in self.export_rt2()["materials"]], ["clay"])

# SPDX-License-Identifier: Apache-2.0
"""What the tests of image textures share: images without a pattern, and materials that show them."""
import os

import bpy
from against_cycles import CyclesTest


class Textured(CyclesTest):
    def setUp(self):
        super().setUp()
        self.scene.render.resolution_x = self.scene.render.resolution_y = 60
        self.camera(location=(0, -0.01, 6), target=(0, 0, 0))

    def image(self, name="picture", size=8, alpha=False, space="Non-Color"):
        """Every texel has another color; some are transparent."""
        image = bpy.data.images.new(name, size, size, alpha=alpha)
        image.colorspace_settings.name = space
        image.pixels[:] = [v for y in range(size) for x in range(size) for v in (
            0.1 + 0.8 * x / size, 0.1 + 0.8 * y / size, 0.2 + 0.6 * ((x + y) % 2), 0.25 if alpha and (x // 2 + y // 2) % 2 else 1)]
        return image

    def textured(self, image, name="paint", interpolation="Closest", extension="REPEAT", input_name="Base Color"):
        """A material whose color is an image; self.node is its node."""
        material = self.material(name, Specular=0.0)
        self.tree = material.node_tree
        self.shader_node = self.tree.nodes["Principled BSDF"]
        self.node = self.tree.nodes.new("ShaderNodeTexImage")
        self.node.image, self.node.interpolation, self.node.extension = image, interpolation, extension
        self.tree.links.new(self.node.outputs["Color"], self.shader_node.inputs[input_name])
        return material

    def mapping(self, kind, location=(0, 0, 0), rotation=(0, 0, 0), scale=(1, 1, 1)):
        mapping, uv = self.tree.nodes.new("ShaderNodeMapping"), self.tree.nodes.new("ShaderNodeUVMap")
        mapping.vector_type = kind
        for name, value in (("Location", location), ("Rotation", rotation), ("Scale", scale)):
            if mapping.inputs[name].enabled:
                mapping.inputs[name].default_value = value
        self.tree.links.new(uv.outputs[0], mapping.inputs["Vector"])
        self.tree.links.new(mapping.outputs[0], self.node.inputs["Vector"])
        return mapping, uv

    def textures(self, folder="scene_textures"):
        return sorted(os.listdir(self.path(folder))) if os.path.isdir(self.path(folder)) else []

    def block(self, word, text):
        return next(line for line in text.splitlines() if line.startswith(word + " "))

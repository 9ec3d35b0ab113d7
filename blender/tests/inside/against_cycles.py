# SPDX-License-Identifier: Apache-2.0
"""Pictures of Cycles by direct light alone, which is what glint computes, and how far glint's are from them."""
import math

import bpy
from io_glint import exr
from support import SceneTest


class CyclesTest(SceneTest):
    def lambert(self, name, color):
        material = bpy.data.materials.new(name)
        material.use_nodes = True
        tree = material.node_tree
        tree.nodes.clear()
        node, output = tree.nodes.new("ShaderNodeBsdfDiffuse"), tree.nodes.new("ShaderNodeOutputMaterial")
        node.inputs["Color"].default_value = (*color, 1)
        tree.links.new(node.outputs[0], output.inputs["Surface"])
        return material

    def cycles(self, samples):
        render = self.scene.render
        render.engine = "CYCLES"
        cycles = self.scene.cycles
        cycles.device, cycles.samples, cycles.use_denoising, cycles.max_bounces = "CPU", samples, False, 0
        cycles.pixel_filter_type = "BOX"
        settings = render.image_settings
        settings.file_format, settings.color_depth, settings.exr_codec, settings.color_mode = "OPEN_EXR", "32", "ZIP", "RGB"
        render.filepath = self.path("cycles.exr")
        bpy.ops.render.render(write_still=True)
        return exr.read(render.filepath)[0]

    def differences(self, samples=64, aa=3):
        """(root mean square, largest) over the picture, which has parts without light."""
        self.export()
        ours = self.layers("background", aa=aa)["beauty"]
        theirs = self.cycles(samples)
        all_of_them = [abs(x - y) for channel in "RGB" for x, y in zip(ours.channels[channel], theirs.channels[channel])]
        self.assertGreater(max(theirs.channels["R"]), 0.1)
        return math.sqrt(sum(d * d for d in all_of_them) / len(all_of_them)), max(all_of_them)

# SPDX-License-Identifier: Apache-2.0
"""The world's radiance: glint's background and, times k_d, its ambient term."""
from . import ignored, keys, nodes
from .phong import BLACK
from .text import block, number, vector

OCCLUSION_SAMPLES = 16  # for each sample of a pixel


def radiance(world, report, images=None):
    """Three floats, linear; black without a world."""
    if world is None:
        return BLACK
    item = f"world '{world.name}'"
    ignored.report(world, item, report)
    if not world.use_nodes or world.node_tree is None:
        return tuple(world.color)
    node, reader = nodes.surface_node(world.node_tree, report, item, images)
    if node is None:
        return BLACK
    if node.type in ("BACKGROUND", "EMISSION"):
        reader.check(node)
        color, strength = reader.emission(node)
        return keys.bounded_color(tuple(c * strength for c in color), report, item)
    report.warn(item, f"its shader ({node.bl_label}) cannot be exported; its viewport color is used")
    return tuple(world.color)


def fog_blocks(world, color, is_wanted, report):
    """The world's mist as fog of the background's color: nothing before its start, all beyond start + depth."""
    mist = world.mist_settings
    if not is_wanted:
        if mist.use_mist:
            report.warn(f"world '{world.name}'", "its mist is left out: tick 'Mist as fog'")
        return
    if mist.falloff != "LINEAR":
        report.warn(f"world '{world.name}'", f"its mist's falloff ({mist.falloff.lower()}) is taken as linear")
    if mist.intensity > 0:
        report.warn(f"world '{world.name}'", "its mist's minimum is ignored")
    yield block("fog", None, [("type", "linear"), ("color", vector(color)), ("start", number(mist.start)),
                              ("end", number(mist.start + mist.depth))])


def occlusion_block(radiance):
    """The world's light, which shapes block."""
    return block("occlusion", None, [("samples", str(OCCLUSION_SAMPLES)), ("color", vector(radiance))])

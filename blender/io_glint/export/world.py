# SPDX-License-Identifier: Apache-2.0
"""The world's radiance: glint's background and, times k_d, its ambient term."""
from . import keys, nodes
from .phong import BLACK


def radiance(world, report):
    """Three floats, linear; black without a world."""
    if world is None:
        return BLACK
    if not world.use_nodes or world.node_tree is None:
        return tuple(world.color)
    item = f"world '{world.name}'"
    node = nodes.surface_node(world.node_tree)
    if node is None:
        return BLACK
    if node.type in ("BACKGROUND", "EMISSION"):
        color, strength = nodes.NodeReader(report, item).emission(node)
        return keys.bounded_color(tuple(c * strength for c in color), report, item)
    report.warn(item, f"its shader ({node.bl_label}) cannot be exported; its viewport color is used")
    return tuple(world.color)

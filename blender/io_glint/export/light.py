# SPDX-License-Identifier: Apache-2.0
"""Blender's lights as glint's: the classic intensity I_l of k_d (N.L) I_l, measured against Cycles."""
import math

from . import nodes
from .text import block, number, vector

MAX_PRODUCT = 1e6  # what glint takes as intensity times color
MAX_SCALE = 1e4
SOFT = 0.05


def describe(ob):
    return f"light '{ob.name}'"


def power(data, report, item):
    """(color, energy): the light's, times its Emission node if it has nodes."""
    color, energy = tuple(data.color), data.energy
    if hasattr(data, "exposure"):  # from 4.5
        energy *= 2.0 ** data.exposure
    if getattr(data, "use_temperature", False):
        color = tuple(c * t for c, t in zip(color, data.temperature_color))
    if data.use_nodes and data.node_tree:
        node = nodes.surface_node(data.node_tree)
        if node is not None and node.type == "EMISSION":
            tint, strength = nodes.NodeReader(report, item).emission(node)
            color, energy = tuple(a * b for a, b in zip(color, tint)), energy * strength
        else:
            report.warn(item, "its nodes cannot be exported; its own color and power are used")
    return color, energy


def classical(kind, color, energy):
    """I_l at distance 1 (SUN: anywhere): three floats. POINT and SPOT are in watts, SUN in W/m^2, AREA on its axis."""
    factor = {"SUN": 1 / math.pi, "AREA": 1 / (4 * math.pi)}.get(kind, 1 / (4 * math.pi**2))
    return tuple(c * energy * factor for c in color)


def _intensity(light):
    """(intensity, color of 0 to 1) of a color of any size and sign."""
    top = max((abs(c) for c in light), default=0.0)
    return (top, tuple(c / top for c in light)) if top else (0.0, (1.0, 1.0, 1.0))


def point_block(name, position, light):
    """light: I_l at distance 1. glint's attenuation is min(1/(c2 d^2), 1): the common factor K moves its limit to
    d = 1/sqrt(K), a centimetre."""
    intensity, color = _intensity(light)
    k = min(MAX_SCALE, MAX_PRODUCT / intensity) if intensity else 1.0
    return block("light", name, [("position", vector(position)), ("intensity", number(k * intensity)),
                                 ("color", vector(color)), ("attenuation", vector((0, 0, k)))])


def sun_block(name, to_light, light):
    intensity, color = _intensity(light)
    return block("light", name, [("type", "directional"), ("to_light", vector(to_light)),
                                 ("intensity", number(intensity)), ("color", vector(color))])


def ambient_block(radiance=(1.0, 1.0, 1.0)):
    return block("light", None, [("type", "ambient"), ("color", vector(radiance))])


def light_text(ob, matrix, scale, focus, report):
    """The block of a light under a world matrix; None, with a report, for what glint has not.

    scale: what all powers are multiplied by. focus: a point of interest, by which a radius is called large."""
    data, item = ob.data, describe(ob)
    values = [v for row in matrix for v in row]
    color, energy = power(data, report, item)
    if not all(math.isfinite(v) for v in (*values, *color, energy)):
        report.warn(item, "left out: it has numbers that are not finite")
        return None
    if data.type in ("SPOT", "AREA"):
        report.warn(item, f"left out: glint has no {data.type.lower()} lights")
        return None
    if not getattr(data, "use_shadow", True) or not getattr(getattr(data, "cycles", None), "cast_shadow", True):
        report.warn(item, "it has no shadows in Blender; in glint every light has")
    if any(getattr(data, f"{part}_factor", 1.0) != 1.0 for part in ("diffuse", "specular")):
        report.warn(item, "its diffuse and specular factors are ignored, as in Cycles")
    light = tuple(c * scale for c in classical(data.type, color, energy))
    if max(abs(c) for c in light) > MAX_PRODUCT:
        report.warn(item, "left out: it is brighter than glint takes (1e6)")
        return None
    if data.type == "SUN":
        if data.angle > SOFT:
            report.warn(item, f"its angle of {math.degrees(data.angle):.3g} degrees is ignored: shadows are hard")
        axis = matrix.to_3x3().col[2]
        if axis.length == 0:
            report.warn(item, "left out: its scale of 0 leaves it no direction")
            return None
        return sun_block(ob.name, tuple(axis.normalized()), light)
    position = tuple(matrix.translation)
    if data.shadow_soft_size > SOFT * math.dist(position, focus):
        report.warn(item, f"its radius of {data.shadow_soft_size:.3g} is ignored: shadows are hard")
    return point_block(ob.name, position, light)

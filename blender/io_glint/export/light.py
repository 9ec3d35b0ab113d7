# SPDX-License-Identifier: Apache-2.0
"""Blender's lights as glint's: the classic intensity I_l of k_d (N.L) I_l, measured against Cycles."""
import math

from . import ignored, nodes
from .text import block, number, vector

MAX_PRODUCT = 1e6  # what glint takes as intensity times color
SUN_ANGLE = math.radians(0.6)  # a little more than a new sun has, and than the sun
ROUND = 1.02  # an ellipse with axes of this ratio is taken as a disc


def describe(ob):
    return f"light '{ob.name}'"


def power(data, report, item, images=None):
    """(color, energy): the light's, times its Emission node if it has nodes."""
    color, energy = tuple(data.color), data.energy
    if hasattr(data, "exposure"):  # from 4.5
        energy *= 2.0 ** data.exposure
    if getattr(data, "use_temperature", False):
        color = tuple(c * t for c, t in zip(color, data.temperature_color))
    if data.use_nodes and data.node_tree:
        node, reader = nodes.surface_node(data.node_tree, report, item, images)
        if node is not None and node.type == "EMISSION":
            tint, strength = reader.emission(node)
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


def _entries(light, data):
    """What lights at a place have in common; light: I_l at distance 1. The convention clamp_attenuation is false."""
    intensity, color = _intensity(light)
    entries = [("intensity", number(intensity)), ("color", vector(color)), ("attenuation", vector((0, 0, 1)))]
    return entries + _shadows(data)


def _shadows(data):
    cycles = getattr(getattr(data, "cycles", None), "cast_shadow", True)
    return [] if getattr(data, "use_shadow", True) and cycles else [("casts_shadows", "false")]


def _samples(count):
    return [("samples_u", str(count)), ("samples_v", str(count)), ("jitter", "true")]


def point_block(name, position, light, data, samples):
    """A point, or a sphere of its radius."""
    entries = [("position", vector(position)), *_entries(light, data)]
    if data.shadow_soft_size > 0:
        entries = [("type", "sphere"), *entries, ("radius", number(data.shadow_soft_size)), *_samples(samples)]
    return block("light", name, entries)


def spot_angles(size, blend):
    """(inner, outer) half angles in degrees of Blender's full angle and blend: both programs have a cubic step in the cosine."""
    outer = math.cos(size / 2)
    inner = outer + (1 - outer) * blend
    return math.degrees(math.acos(min(1.0, inner))), math.degrees(size / 2)


def spot_block(name, position, axis, light, data):
    """Cycles multiplies by the cosine off the axis: tightness 1."""
    inner, outer = spot_angles(data.spot_size, data.spot_blend)
    return block("light", name, [("type", "spot"), ("position", vector(position)), ("axis", vector(axis)),
                                 ("inner_angle", number(inner)), ("outer_angle", number(outer)), ("tightness", "1"),
                                 *_entries(light, data)])


def area_block(name, matrix, light, data, samples, report, item):
    """A one-sided rectangle or disc that shines along the object's -z axis."""
    x, y, z = (matrix.to_3x3().col[i] for i in range(3))
    size_x = data.size
    size_y = data.size_y if data.shape in ("RECTANGLE", "ELLIPSE") else data.size
    side_x, side_y = tuple(c * size_x for c in x), tuple(c * size_y for c in y)
    half_x, half_y = math.hypot(*side_x) / 2, math.hypot(*side_y) / 2
    if not (half_x > 0 and half_y > 0 and z.length > 0):
        report.warn(item, "left out: its size or scale of 0 leaves it no area")
        return None
    if data.shape in ("DISK", "ELLIPSE"):
        if max(half_x, half_y) < ROUND * min(half_x, half_y):
            extent = [("type", "disc"), ("axis", vector(tuple(-c for c in z.normalized()))),
                      ("radius", number(math.sqrt(half_x * half_y)))]
            return block("light", name, [extent[0], ("position", vector(matrix.translation)), *extent[1:], ("one_sided", "true"),
                                         *_samples(samples), *_entries(light, data)])
        report.warn(item, "its ellipse is exported as a rectangle of the same area")
        side_x, side_y = (tuple(c * math.sqrt(math.pi) / 2 for c in side) for side in (side_x, side_y))
    # The front is that of side_u x side_v.
    return block("light", name, [("type", "parallelogram"), ("position", vector(matrix.translation)), ("side_u", vector(side_y)),
                                 ("side_v", vector(side_x)), ("one_sided", "true"), *_samples(samples), *_entries(light, data)])


def sun_block(name, to_light, light, data):
    intensity, color = _intensity(light)
    return block("light", name, [("type", "directional"), ("to_light", vector(to_light)),
                                 ("intensity", number(intensity)), ("color", vector(color)), *_shadows(data)])


def ambient_block(radiance=(1.0, 1.0, 1.0)):
    return block("light", None, [("type", "ambient"), ("color", vector(radiance))])


def light_text(ob, matrix, scale, samples, report, images=None):
    """The block of a light under a world matrix; None, with a report, for what glint has not.

    scale: what all powers are multiplied by. samples: n x n of a light with an extent."""
    data, item = ob.data, describe(ob)
    values = [v for row in matrix for v in row]
    color, energy = power(data, report, item, images)
    if not all(math.isfinite(v) for v in (*values, *color, energy)):
        report.warn(item, "left out: it has numbers that are not finite")
        return None
    if data.type == "AREA" and getattr(getattr(data, "cycles", None), "is_portal", False):
        report.warn(item, "left out: it is a portal, which gives no light of its own")
        return None
    ignored.report(data, item, report)
    light = tuple(c * scale for c in classical(data.type, color, energy))
    if max(abs(c) for c in light) > MAX_PRODUCT:
        report.warn(item, "left out: it is brighter than glint takes (1e6)")
        return None
    if data.type == "AREA":
        return area_block(ob.name, matrix, light, data, samples, report, item)
    position, axis = tuple(matrix.translation), matrix.to_3x3().col[2]
    if data.type == "POINT":
        return point_block(ob.name, position, light, data, samples)
    if axis.length == 0:
        report.warn(item, "left out: its scale of 0 leaves it no direction")
        return None
    to_light = tuple(axis.normalized())
    if data.type == "SUN":
        if data.angle > SUN_ANGLE:
            report.warn(item, f"its angle of {math.degrees(data.angle):.3g} degrees is ignored: shadows are hard")
        return sun_block(ob.name, to_light, light, data)
    if data.shadow_soft_size > 0:
        report.warn(item, f"its radius of {data.shadow_soft_size:.3g} is ignored: shadows are hard")
    return spot_block(ob.name, position, tuple(-c for c in to_light), light, data)

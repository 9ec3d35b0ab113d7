# SPDX-License-Identifier: Apache-2.0
"""Nodes of colors that differ from place to place: images on UV maps, color attributes, and their products."""
import math

from . import blend, links
from .texture import IDENTITY, WHITE, WRAPS, ImageUse, Pattern, product

MAX_DEPTH = 32
GREY = (0.5, 0.5, 0.5)  # instead of a color attribute, where one color has to do


def mean(pattern, images):
    """The mean color of a Pattern."""
    found = pattern.tint
    if pattern.image is not None and pattern.image.color:
        found = tuple(c * m for c, m in zip(found, images.mean(pattern.image.image) or WHITE))
    return tuple(c * g for c, g in zip(found, GREY)) if pattern.layer is not None else found


def pattern(reader, socket, depth=0):
    """The Pattern of a color input; None if it cannot be said. reader: a nodes.NodeReader."""
    end, path = links.origin(socket, reader.path)
    inner, node = reader.at(path), end.node
    if end.is_output and node.type == "TEX_IMAGE" and end.name == "Color":
        use = _image_use(inner, node, "Color")
        return Pattern(image=use) if use else None
    if end.is_output and depth < MAX_DEPTH and (sockets := blend.multiplied(node, inner.constant)):
        found = [pattern(inner, one, depth + 1) for one in sockets]
        return None if None in found else product(*found)
    layer = _layer(end) if end.is_output else None
    if layer is not None:
        return Pattern(layer=layer)
    color = reader.constant(socket)
    return None if color is None else Pattern(color if isinstance(color, tuple) else (color,) * 3)


def _layer(end):
    """The name of the color attribute that an output gives; None if it gives none."""
    node = end.node
    if node.type == "VERTEX_COLOR":
        return node.layer_name if end.name == "Color" else None
    if node.type == "ATTRIBUTE" and node.attribute_type == "GEOMETRY" and end.name in ("Color", "Vector"):
        return node.attribute_name or None
    return None


def with_alpha(reader, found, socket):
    """(a Pattern with the alpha that an input has, whether it has one that is an image's)."""
    end, path = links.origin(socket, reader.path) if reader.draws_patterns and socket is not None else (None, ())
    if end is None or not end.is_output or end.node.type != "TEX_IMAGE" or end.name != "Alpha":
        return found, False
    node = end.node
    if node.image is not None and node.image.alpha_mode == "NONE":
        return found, False
    use = _image_use(reader.at(path), node, "Alpha")
    if use is None:
        return found, False
    if found.image is None:
        return found._replace(image=_changed(use, color=False, alpha=True)), True
    if found.image != use:
        reader.reasons[node.as_pointer(), "Alpha"] = "the base color has another image"
        return found, False
    fault = _fault_of_file(reader, _changed(use, alpha=True))
    if fault:
        reader.reasons[node.as_pointer(), "Alpha"] = fault
        return found, False
    return found._replace(image=_changed(use, alpha=True)), True


def _changed(use, **values):
    return ImageUse(**{**use.__dict__, **values})


def _fault_of_file(reader, use):
    written = reader.images.file(use.image, use.variant)
    return written if isinstance(written, str) else None


def _image_use(reader, node, output):
    """The ImageUse of an Image Texture node; None, with a reason in the reader, if it cannot be said."""
    use = _read(reader, node)
    fault = use if isinstance(use, str) else _fault_of_file(reader, use if output == "Color" else _changed(use, color=False, alpha=True))
    if fault:
        reader.reasons[node.as_pointer(), output] = fault
        return None
    if node.interpolation not in ("Linear", "Closest"):
        reader.report.warn(reader.item, f"the interpolation '{node.interpolation}' of its image is that of Linear")
    return use


def _read(reader, node):
    """An ImageUse or why there is none."""
    image = node.image
    if image is None:
        return "it has no image"
    if image.source not in ("FILE", "GENERATED") or image.type == "RENDER_RESULT":
        return f"images of the source '{image.source.lower()}' have no texture"
    if node.projection != "FLAT":
        return f"its projection is '{node.projection.lower()}'"
    if node.extension not in WRAPS:
        return f"its extension is '{node.extension.lower()}'"
    if not _is_plain(node.texture_mapping) or not _is_plain(node.color_mapping):
        return "it has a mapping of its own"
    found = _coordinates(reader, node.inputs["Vector"])
    if isinstance(found, str):
        return found
    uv, rows = found
    return ImageUse(image, image.name_full, uv, node.extension, node.interpolation != "Closest", rows)


# What Blender gives these at first, which their RNA does not say.
_PLAIN = {"translation": (0, 0, 0), "rotation": (0, 0, 0), "scale": (1, 1, 1), "mapping_x": "X", "mapping_y": "Y", "mapping_z": "Z",
          "use_min": False, "use_max": False, "use_color_ramp": False, "brightness": 1, "contrast": 1, "saturation": 1,
          "blend_factor": 0}


def _is_plain(mapping):
    """Whether a node's TexMapping or ColorMapping, which only scripts set, does nothing."""
    for name, plain in _PLAIN.items():
        value = getattr(mapping, name, plain)
        if (tuple(value) if isinstance(plain, tuple) else value) != plain:
            return False
    return True


def _coordinates(reader, socket, depth=0):
    """(the name of the UV map, empty for the one for renders; two rows that map it), or why there is none."""
    end, path = links.origin(socket, reader.path)
    if not end.is_output:
        if depth:
            return "its Mapping node has no coordinates"
        return "", IDENTITY
    node, inner = end.node, reader.at(path)
    if getattr(node, "from_instancer", False):
        return "its coordinates are those of the instancer"
    if node.type == "UVMAP":
        return node.uv_map, IDENTITY
    if node.type == "TEX_COORD" and end.name == "UV":
        return "", IDENTITY
    if node.type == "ATTRIBUTE" and node.attribute_type == "GEOMETRY" and node.attribute_name and end.name in ("Vector", "Color"):
        return node.attribute_name, IDENTITY
    if node.type == "MAPPING" and depth < MAX_DEPTH:
        return _mapped(inner, node, depth)
    what = f"the output '{end.name}' of its {node.bl_label} node" if node.type == "TEX_COORD" else f"its {node.bl_label} node"
    return f"{what} gives no coordinates that glint has"


def _mapped(reader, node, depth):
    inside = _coordinates(reader, node.inputs["Vector"], depth + 1)
    if isinstance(inside, str):
        return inside
    if node.vector_type not in ("POINT", "TEXTURE", "VECTOR"):
        return f"the type of its Mapping node is '{node.vector_type.lower()}'"
    values = []
    for name in ("Location", "Rotation", "Scale"):
        value = (0.0,) * 3 if name == "Location" and node.vector_type == "VECTOR" else reader.constant(node.inputs[name])
        if value is None:
            return f"the {name.lower()} of its Mapping node is not the same everywhere"
        values.append(value)
    location, rotation, scale = values
    turn = _rotation(rotation)
    if node.vector_type == "TEXTURE":  # the inverse; Blender divides by 0 as if that gave 0
        turn = list(zip(*turn))
        turn = [[v * (1 / s if s else 0.0) for v in row] for row, s in zip(turn, scale)]
        move = [-sum(v * t for v, t in zip(row, location)) for row in turn]
    else:
        turn, move = [[v * s for v, s in zip(row, scale)] for row in turn], location
    uv, ((a, b, c), (d, e, f)) = inside
    return uv, tuple((x * a + y * d, x * b + y * e, x * c + y * f + t) for (x, y, _), t in zip(turn[:2], move))


def _rotation(angles):
    """The matrix of Euler angles: about x first, then y, then z."""
    (sx, cx), (sy, cy), (sz, cz) = ((math.sin(a), math.cos(a)) for a in angles)
    return [[cy * cz, sx * sy * cz - cx * sz, cx * sy * cz + sx * sz],
            [cy * sz, sx * sy * sz + cx * cz, cx * sy * sz - sx * cz],
            [-sy, sx * cy, cx * cy]]

# SPDX-License-Identifier: Apache-2.0
"""UV maps and colors of meshes, as numbers for each corner of a face. What a mesh has not is 0, as in Cycles."""
from array import array
from typing import NamedTuple

from .png import np

_WIDTHS = {"FLOAT_COLOR": ("color", 4), "BYTE_COLOR": ("color", 4), "FLOAT_VECTOR": ("vector", 3), "FLOAT2": ("vector", 2),
           "FLOAT": ("value", 1)}


class Layers(NamedTuple):
    """Arrays of floats; None where a Look asks for none. fault: what could not be read, or empty."""

    uv: array | None  # u and v of each corner
    colors: array | None  # red, green and blue of each corner, linear, times the tint
    fault: str = ""


def read(mesh, look):
    """The Layers of an evaluated mesh for a Look."""
    uv = colors = None
    faults = []
    if look.uv is not None:
        uv = _columns(*_found(mesh, look.uv, _uv_layer, faults), 2)
    if look.layer is not None:
        colors = _tinted(_columns(*_found(mesh, look.layer, _color_layer, faults), 3), look.tint)
    return Layers(uv, colors, "; ".join(faults))


def _uv_layer(mesh, name):
    """A UV map; for an empty name, that of renders."""
    if name:
        return mesh.uv_layers.get(name)
    return next((layer for layer in mesh.uv_layers if layer.active_render), None)


def _color_layer(mesh, name):
    if name:
        return mesh.color_attributes.get(name)
    index = mesh.color_attributes.render_color_index
    return mesh.color_attributes[index] if 0 <= index < len(mesh.color_attributes) else None


def _found(mesh, name, layer_of, faults):
    """(floats for each corner, how many each has) of a layer, or of another attribute of that name."""
    zeros = array("f", bytes(4 * 3 * len(mesh.loops))), 3
    layer = layer_of(mesh, name)
    if layer is not None and layer_of is _uv_layer:
        return _read(layer.data, "uv", 2), 2
    if layer is None:
        layer = mesh.attributes.get(name) if name else None
    if layer is None:
        return zeros
    key, width = _WIDTHS.get(layer.data_type, (None, 0))
    at = _places(mesh, layer.domain) if key else None
    if at is None:
        faults.append(f"its attribute '{name}' is neither of colors nor of vectors at its corners: it counts as 0")
        return zeros
    values = _read(layer.data, key, width)
    if layer.domain == "CORNER":
        return values, width
    if np is not None:
        spread = np.frombuffer(values, np.float32).reshape(-1, width)[np.frombuffer(at, np.int32)]
        return array("f", spread.tobytes()), width
    return array("f", (values[width * i + j] for i in at for j in range(width))), width


def _places(mesh, domain):
    """For each corner, the number of its point, corner or face; None for another domain."""
    if domain == "CORNER":
        return ()
    if domain == "POINT":
        return _read(mesh.loops, "vertex_index", 1, "i")
    if domain == "FACE":
        totals = _read(mesh.polygons, "loop_total", 1, "i")
        return array("i", (i for i, total in enumerate(totals) for _ in range(total)))
    return None


def _read(collection, attribute, width, kind="f"):
    values = array(kind, bytes(array(kind).itemsize * width * len(collection)))
    if values:
        collection.foreach_get(attribute, values)
    return values


def _columns(values, width, wanted):
    """The first `wanted` of each corner's floats; one float is grey, and a missing one 0."""
    if width == wanted:
        return values
    out = array("f", bytes(4 * wanted * (len(values) // width)))
    for i in range(wanted):
        if width == 1 or i < width:
            out[i::wanted] = values[0 if width == 1 else i::width]
    return out


def _tinted(colors, tint):
    """glint's colors are at least 0."""
    if np is not None:
        return array("f", np.maximum(np.frombuffer(colors, np.float32).reshape(-1, 3) * np.float32(tint), 0).astype(np.float32).tobytes())
    return array("f", (max(0.0, c * tint[i % 3]) for i, c in enumerate(colors)))

# SPDX-License-Identifier: Apache-2.0
"""Shader nodes read by their type and by their sockets' names (3.4's first, 4.x's second)."""
import array

from . import blend, ignored, ignored_nodes, links, phong
from .report import Report

MEAN_SAMPLES = 65536
MAX_DEPTH = 32


def surface_node(tree, report, item, outputs=("CYCLES", "ALL", "EEVEE")):
    """(node, NodeReader) of the surface of the material's (or world's, or light's) active output; the node is None without
    one. What else is linked to the output is reported."""
    output = None
    for target in outputs:
        output = output or tree.get_output_node(target)
    reader = NodeReader(report, item)
    if output is None:
        return None, reader
    reader.check(output)
    return reader.linked(output.inputs["Surface"])


def _socket(node, *names):
    for name in names:
        socket = node.inputs.get(name)
        if socket is not None:
            return socket
    return None


class NodeReader:
    """Reads the nodes of one item; what it cannot follow goes to the report. path: the group nodes around the nodes.

    known: what has been read already, and None for what is being read. Without it, chains of nodes whose inputs have a node in
    common would take 2^n steps."""

    def __init__(self, report, item, path=(), known=None):
        self.report, self.item, self.path = report, item, path
        self.known = {} if known is None else known

    def _at(self, path):
        return NodeReader(self.report, self.item, path, self.known)

    def _once(self, thing, kind, read):
        """What read() returns for a node or a socket, remembered; None where it asks for itself."""
        key = kind, thing.as_pointer(), tuple(node.as_pointer() for node in self.path)
        if key not in self.known:
            self.known[key] = None
            self.known[key] = read()
        return self.known[key]

    def linked(self, socket):
        """(node, its NodeReader) of what an input is linked to; the node is None without a link."""
        end, path = links.origin(socket, self.path)
        return end.node if end.is_output else None, self._at(path)

    def value(self, node, default, *names):
        """A number or a color (three floats) of the first of these sockets."""
        socket = _socket(node, *names)
        return default if socket is None else self._value(socket, _plain(socket.default_value))

    def _value(self, socket, like, depth=0):
        """The value of an input as a number or a color like `like`."""
        found = self._once(socket, isinstance(like, tuple), lambda: self._read(socket, like, depth))
        return _fit(_plain(socket.default_value), like) if found is None else found

    def _read(self, socket, like, depth):
        end, path = links.origin(socket, self.path)
        if not end.is_output:
            return _fit(_plain(end.default_value), like)
        node, made = end.node, None
        if node.type in ("RGB", "VALUE"):
            made = _plain(end.default_value)
        elif node.type in ("MIX", "MIX_RGB") and depth < MAX_DEPTH:
            inner = self._at(path)
            made = blend.mixed(node, lambda *one: inner._value(*one, depth + 1))
        elif node.type in ("TEX_IMAGE", "TEX_ENVIRONMENT"):
            means = mean_pixel(node.image)
            if means is not None:
                made, what = (means[3], "alpha") if end.name == "Alpha" else (means[:3], "color")
                self.report.warn(self.item, f"the image at '{socket.name}' is exported as its mean {what}")
        if made is None:
            self.report.warn(self.item, f"the {node.bl_label} node at '{socket.name}' cannot be exported; "
                                        "the socket's own value is used")
            made = _plain(socket.default_value)
        return _fit(made, like)

    def check(self, node):
        """Reports what has no effect of a node's properties and sockets."""
        ignored.report(node, self.item, self.report)
        known = ignored_nodes.SOCKETS.get(node.bl_idname)
        for name, (text, idle) in known.warned.items() if known else ():
            socket = node.inputs.get(name)
            if socket is None or not socket.enabled or not self._has_effect(socket, idle):
                continue
            needed = _socket(node, *known.needs.get(name, ()))
            if needed is None or self._has_effect(needed, (0.0,)):
                self.report.warn(self.item, text.format(node=links.origin(socket, self.path)[0].node.bl_label))

    def _has_effect(self, socket, idle):
        """Whether an input is linked or, if it has idle values, has another one."""
        if not idle:
            return links.origin(socket, self.path)[0].is_output
        unknown = Report()
        value = NodeReader(unknown, self.item, self.path)._value(socket, _plain(socket.default_value))
        return bool(unknown.warnings) or value not in idle

    def material(self, node, depth=0):
        """The node as Phong; None if it cannot be said."""
        convert = _CONVERTERS.get(node.type) if node is not None and depth < MAX_DEPTH else None
        if convert is None:
            return None

        def read():
            self.check(node)
            return convert(self, node, depth)

        return self._once(node, "material", read)

    def emission(self, node):
        """(color, strength) of an Emission or Background node."""
        return self.value(node, phong.WHITE, "Color"), self.value(node, 1.0, "Strength")


def _plain(value):
    return tuple(value)[:3] if hasattr(value, "__len__") else float(value)


def _fit(value, like):
    """A color where a color is wanted, a number (the luminance, as Blender converts) where a number is."""
    if isinstance(like, tuple):
        return value if isinstance(value, tuple) else (float(value),) * 3
    return 0.2126 * value[0] + 0.7152 * value[1] + 0.0722 * value[2] if isinstance(value, tuple) else float(value)


def _linear(c):
    return c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4


def mean_pixel(image):
    """The mean linear color and the mean alpha of an image, four numbers, from evenly spaced pixels; None if it has none."""
    if image is None or not image.has_data and not image.size[0]:
        return None
    count = image.size[0] * image.size[1]
    if not count or not image.channels:
        return None
    pixels = array.array("f", bytes(4 * len(image.pixels)))
    if not pixels:
        return None
    image.pixels.foreach_get(pixels)
    step, n = max(1, count // MEAN_SAMPLES), image.channels
    mean = []
    for channel in range(min(n, 4)):
        values = pixels[channel::n * step]
        if channel < 3 and not image.is_float and image.colorspace_settings.name == "sRGB":
            values = [_linear(v) for v in values]
        mean.append(sum(values) / len(values))
    if len(mean) < 3:
        mean = [mean[0]] * 3
    return (*mean[:3], mean[3] if len(mean) > 3 else 1.0)


def _principled(r, node, _):
    emission = phong.BLACK
    strength = r.value(node, 1.0, "Emission Strength")
    if strength:
        color = r.value(node, phong.BLACK, "Emission", "Emission Color")
        emission = tuple(c * strength for c in color)
    metallic, roughness = r.value(node, 0.0, "Metallic"), r.value(node, 0.5, "Roughness")
    transmission = r.value(node, 0.0, "Transmission", "Transmission Weight")
    if roughness and transmission * (1 - metallic):
        r.report.warn(r.item, "its roughness blurs nothing behind it: the glass is clear")
    material = phong.principled(
        r.value(node, (0.8,) * 3, "Base Color"), metallic, roughness, r.value(node, 0.5, "Specular", "Specular IOR Level"),
        transmission, r.value(node, 1.45, "IOR"), emission)
    return phong.with_alpha(material, r.value(node, 1.0, "Alpha"))


def _diffuse(r, node, _):
    return phong.diffuse(r.value(node, (0.8,) * 3, "Color"))


def _glossy(r, node, _):
    roughness = 0.0 if getattr(node, "distribution", "") == "SHARP" else r.value(node, 0.5, "Roughness")
    return phong.glossy(r.value(node, (0.8,) * 3, "Color"), roughness)


def _glass(r, node, _):
    return phong.glass(r.value(node, phong.WHITE, "Color"), r.value(node, 1.45, "IOR"))


def _transparent(r, node, _):
    return phong.transparent(r.value(node, phong.WHITE, "Color"))


def _emission(r, node, _):
    return phong.emission(*r.emission(node))


def _part(r, socket, depth):
    """A shader socket: nothing linked is black; None if it cannot be said."""
    node, reader = r.linked(socket)
    return phong.Phong(color=phong.BLACK) if node is None else reader.material(node, depth + 1)


def _mix(r, node, depth):
    a, b = (_part(r, socket, depth) for socket in list(node.inputs)[1:3])
    return None if a is None or b is None else phong.mix(a, b, r.value(node, 0.5, "Fac", "Factor"))


def _add(r, node, depth):
    a, b = (_part(r, socket, depth) for socket in list(node.inputs)[:2])
    return None if a is None or b is None else phong.add(a, b)


_CONVERTERS = {
    "BSDF_PRINCIPLED": _principled,
    "BSDF_DIFFUSE": _diffuse,
    "BSDF_GLOSSY": _glossy,
    "BSDF_ANISOTROPIC": _glossy,
    "BSDF_GLASS": _glass,
    "BSDF_TRANSPARENT": _transparent,
    "EMISSION": _emission,
    "MIX_SHADER": _mix,
    "ADD_SHADER": _add,
}

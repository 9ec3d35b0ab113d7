# SPDX-License-Identifier: Apache-2.0
"""Shader nodes read by their type and by their sockets' names (3.4's first, 4.x's second)."""
import dataclasses

from . import blend, ignored, ignored_nodes, links, phong, texture_nodes
from .images import Images
from .report import Report

MAX_DEPTH = 32


def surface_node(tree, report, item, images=None, draws_patterns=False):
    """(node, NodeReader) of the surface of the material's (or world's, or light's) active output; the node is None without
    one. What else is linked to the output is reported. draws_patterns: whether colors may differ from place to place."""
    output = None
    for target in ("CYCLES", "ALL", "EEVEE"):
        output = output or tree.get_output_node(target)
    reader = NodeReader(report, item, images=images or Images(), draws_patterns=draws_patterns)
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
    common would take 2^n steps. reasons: why an image is its mean, by its node."""

    def __init__(self, report, item, path=(), known=None, images=None, draws_patterns=False, reasons=None):
        self.report, self.item, self.path, self.images, self.draws_patterns = report, item, path, images, draws_patterns
        self.known = {} if known is None else known
        self.reasons = {} if reasons is None else reasons

    def at(self, path):
        """A reader of nodes within other groups."""
        return NodeReader(self.report, self.item, path, self.known, self.images, self.draws_patterns, self.reasons)

    def in_silence(self):
        """A reader whose report nobody reads, and that report."""
        unknown = Report()
        return NodeReader(unknown, self.item, self.path, None, self.images), unknown

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
        return end.node if end.is_output else None, self.at(path)

    def pattern(self, node, default, *names):
        """The texture.Pattern of the first of these sockets, a color; without tint if it is the same everywhere."""
        socket = _socket(node, *names)
        found = texture_nodes.pattern(self, socket) if socket is not None and self.draws_patterns else None
        return found if found is not None else phong.Pattern(self.value(node, default, *names))

    def colored(self, pattern, make):
        """make(color), a material whose diffuse part is a multiple of the color, for the color of a pattern."""
        if not pattern.varies:
            return make(pattern.tint)
        made = phong.patterned(pattern, texture_nodes.mean(pattern, self.images), make)
        if made.mirror or made.transmission or make(phong.WHITE).specular != make(phong.BLACK).specular:
            self.report.warn(self.item, "what varies in its base color colors its diffuse light only: highlights, reflections and "
                                        "glass have the mean color")
        return made

    def plain(self, material):
        """A material without its pattern, whose mean color it has; reported."""
        pattern = material.pattern
        if pattern is None:
            return material
        self.report.warn(self.item, "what varies in its color is exported as its mean: two of its shaders have colors")
        mean = texture_nodes.mean(pattern._replace(tint=phong.WHITE), self.images)
        alpha = self.images.mean(pattern.image.image)[3] if pattern.image and pattern.image.alpha else 1.0
        plain = dataclasses.replace(
            material, pattern=None, glows=False, diffuse=tuple(d * m for d, m in zip(material.diffuse, mean)),
            emission=tuple(e * m for e, m in zip(material.emission, mean)) if material.glows else material.emission,
            color=tuple(c * m for c, m in zip(material.color, mean)))
        return phong.with_alpha(plain, alpha)

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
            inner = self.at(path)
            made = blend.mixed(node, lambda *one: inner._value(*one, depth + 1))
        elif node.type in ("TEX_IMAGE", "TEX_ENVIRONMENT"):
            means = self.images.mean(node.image)
            if means is not None:
                made, what = (means[3], "alpha") if end.name == "Alpha" else (means[:3], "color")
                reason = self.reasons.get((node.as_pointer(), end.name))
                self.report.warn(self.item, f"the image at '{socket.name}' is exported as its mean {what}" +
                                 (f": {reason}" if reason else ""))
        if made is None:
            reason = self.reasons.get((node.as_pointer(), end.name))
            self.report.warn(self.item, f"the {node.bl_label} node at '{socket.name}' cannot be exported; "
                                        "the socket's own value is used" + (f": {reason}" if reason else ""))
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
        value = self.constant(socket)
        return value is None or value not in idle

    def constant(self, socket):
        """The value of an input; None if it cannot be said."""
        reader, unknown = self.in_silence()
        value = reader._value(socket, _plain(socket.default_value))
        return None if unknown.warnings else value

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
    specular, ior = r.value(node, 0.5, "Specular", "Specular IOR Level"), r.value(node, 1.45, "IOR")
    pattern, has_alpha = texture_nodes.with_alpha(r, r.pattern(node, (0.8,) * 3, "Base Color"), _socket(node, "Alpha"))
    material = r.colored(pattern, lambda color: phong.principled(color, metallic, roughness, specular, transmission, ior, emission))
    return material if has_alpha else phong.with_alpha(material, r.value(node, 1.0, "Alpha"))


def _diffuse(r, node, _):
    return r.colored(r.pattern(node, (0.8,) * 3, "Color"), phong.diffuse)


def _glossy(r, node, _):
    roughness = 0.0 if getattr(node, "distribution", "") == "SHARP" else r.value(node, 0.5, "Roughness")
    return phong.glossy(r.value(node, (0.8,) * 3, "Color"), roughness)


def _glass(r, node, _):
    return phong.glass(r.value(node, phong.WHITE, "Color"), r.value(node, 1.45, "IOR"))


def _transparent(r, node, _):
    return phong.transparent(r.value(node, phong.WHITE, "Color"))


def _emission(r, node, _):
    pattern, strength = r.pattern(node, phong.WHITE, "Color"), r.value(node, 1.0, "Strength")
    made = phong.emission(pattern.tint, strength)
    return dataclasses.replace(made, pattern=pattern, glows=True) if pattern.varies else made


def _part(r, socket, depth):
    """A shader socket: nothing linked is black; None if it cannot be said."""
    node, reader = r.linked(socket)
    return phong.Phong(color=phong.BLACK) if node is None else reader.material(node, depth + 1)


def _mix(r, node, depth):
    a, b = (_part(r, socket, depth) for socket in list(node.inputs)[1:3])
    if a is None or b is None:
        return None
    if a == phong.transparent(phong.WHITE):  # as an image's alpha is drawn in older materials
        pattern, has_alpha = texture_nodes.with_alpha(r, b.pattern or phong.Pattern(), _socket(node, "Fac", "Factor"))
        if has_alpha:
            return dataclasses.replace(b, pattern=pattern)
    factor = r.value(node, 0.5, "Fac", "Factor")
    return phong.mix(*_alike(r, a, b), factor)


def _add(r, node, depth):
    a, b = (_part(r, socket, depth) for socket in list(node.inputs)[:2])
    return None if a is None or b is None else phong.add(*_alike(r, a, b))


def _alike(r, a, b):
    """Two materials of which numbers can be mixed."""
    return (a, b) if phong.shares_pattern(a, b) else (r.plain(a), r.plain(b))


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

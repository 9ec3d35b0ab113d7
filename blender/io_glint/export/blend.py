# SPDX-License-Identifier: Apache-2.0
"""The nodes Mix and MixRGB for values that are the same everywhere: formulas of Cycles' svm_mix, channel by channel."""

# blend type -> what the factor 1 makes of the channels a and b; the factor 0 leaves a
BLENDS = {
    "MIX": lambda a, b: b,
    "ADD": lambda a, b: a + b,
    "SUBTRACT": lambda a, b: a - b,
    "MULTIPLY": lambda a, b: a * b,
    "SCREEN": lambda a, b: 1 - (1 - a) * (1 - b),
    "DIVIDE": lambda a, b: a / b if b else a,
    "DIFFERENCE": lambda a, b: abs(a - b),
    "DARKEN": min,
    "LIGHTEN": max,
}


def _clamped(value):
    return min(max(value, 0.0), 1.0)


def mixed(node, value):
    """What a Mix or MixRGB node makes; None if glint has no formula for it.

    value: reads the socket that it is given, as a color or a number like its second argument."""
    color = (0.0, 0.0, 0.0)
    if node.type == "MIX_RGB":
        sockets, like, kind, clamps_factor, clamps = node.inputs[:3], color, node.blend_type, True, node.use_clamp
    elif node.data_type in ("RGBA", "FLOAT"):
        ends = ("Factor_Float", *(("A_Color", "B_Color") if node.data_type == "RGBA" else ("A_Float", "B_Float")))
        by_identifier = {socket.identifier: socket for socket in node.inputs}
        sockets, clamps_factor = [by_identifier[end] for end in ends], node.clamp_factor
        like, kind, clamps = (color, node.blend_type, node.clamp_result) if node.data_type == "RGBA" else (0.0, "MIX", False)
    else:
        return None
    if kind not in BLENDS:
        return None
    factor, a, b = value(sockets[0], 0.0), value(sockets[1], like), value(sockets[2], like)
    if clamps_factor:
        factor = _clamped(factor)
    made = [x + (BLENDS[kind](x, y) - x) * factor for x, y in (zip(a, b) if like else [(a, b)])]
    if clamps:
        made = [_clamped(v) for v in made]
    return tuple(made) if like else made[0]


def multiplied(node, constant):
    """The two inputs whose product a Mix or MixRGB node makes; None if it makes something else.

    constant: the value of a socket, or None where it differs from place to place."""
    if node.type == "MIX_RGB":
        factor, ends = node.inputs[0], node.inputs[1:3]
    elif node.type == "MIX" and node.data_type == "RGBA":
        by_identifier = {socket.identifier: socket for socket in node.inputs}
        factor, ends = by_identifier["Factor_Float"], [by_identifier["A_Color"], by_identifier["B_Color"]]
    else:
        return None
    return list(ends) if node.blend_type == "MULTIPLY" and constant(factor) == 1 else None

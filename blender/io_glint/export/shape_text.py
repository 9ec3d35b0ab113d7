# SPDX-License-Identifier: Apache-2.0
"""Shapes as blocks of the .glint language."""
from .text import block, matrix as matrix_text, number, vector


def compose(a, b):
    """The 3x4 matrix of a after b."""
    full = (*b[:3], (0.0, 0.0, 0.0, 1.0))
    return tuple(tuple(sum(row[k] * full[k][j] for k in range(4)) for j in range(4)) for row in a[:3])


def _value(v):
    if isinstance(v, bool):
        return "true" if v else "false"
    return vector(v) if isinstance(v, tuple) else number(v)


def shape_block(shape, name, material, world, indent=""):
    """A block of the .glint language: the shape under a 3x4 matrix."""
    entries = [(key, _value(value)) for key, value in shape.entries]
    return block(shape.word, name, [*entries, ("material", material), ("matrix", matrix_text(world))], indent)

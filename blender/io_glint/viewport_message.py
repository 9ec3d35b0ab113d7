# SPDX-License-Identifier: Apache-2.0
"""A sentence in a viewport that cannot show its picture. Blender's own line for engines is cut off at the region's border."""
import textwrap

import blf
import bpy
import gpu
from gpu_extras.batch import batch_for_shader

SIZE, MARGIN = 13, 40  # pixels, at the interface's scale 1
CHARACTER = 0.55  # of the size, on average
BACKGROUND, COLOR = (0.12, 0.12, 0.12, 1.0), (1.0, 0.85, 0.4, 1.0)


def lines_of(text, width, scale=1.0):
    """The text in lines for a region of so many pixels."""
    return textwrap.wrap(text, max(16, int((width - 2 * MARGIN * scale) / (CHARACTER * SIZE * scale))))


def draw(text, region):
    """Draws a text in the middle of a region, instead of a picture."""
    scale = bpy.context.preferences.system.ui_scale
    lines = lines_of(text, region.width, scale)
    _fill(region.width, region.height)
    font, step = 0, 1.6 * SIZE * scale
    if bpy.app.version < (4, 0):
        blf.size(font, SIZE * scale, 72)
    else:
        blf.size(font, SIZE * scale)
    blf.color(font, *COLOR)
    for i, line in enumerate(lines):
        blf.position(font, MARGIN * scale, region.height / 2 + step * (len(lines) / 2 - i), 0)
        blf.draw(font, line)


def _fill(width, height):
    shader = gpu.shader.from_builtin("2D_UNIFORM_COLOR" if bpy.app.version < (4, 0) else "UNIFORM_COLOR")
    corners = ((0, 0), (width, 0), (0, height), (width, height))
    batch = batch_for_shader(shader, "TRIS", {"pos": corners}, indices=((0, 1, 2), (2, 1, 3)))
    shader.uniform_float("color", BACKGROUND)
    batch.draw(shader)

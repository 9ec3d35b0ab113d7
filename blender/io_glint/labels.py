# SPDX-License-Identifier: Apache-2.0
"""Sentences in panels, which may be narrow: Blender cuts off a label that is longer than its line."""
import textwrap

import bpy

CHARACTER = 6.5  # pixels, on average, at the interface's scale 1
MARGINS = 60  # pixels: those of the panel, and the icon


def draw_sentence(layout, text, icon="NONE"):
    """A label of as many lines as the region's width asks for."""
    region = bpy.context.region
    width = region.width / bpy.context.preferences.system.ui_scale if region else 300
    column = layout.column(align=True)
    for line in textwrap.wrap(text, max(16, int((width - MARGINS) / CHARACTER))):
        column.label(text=line, icon=icon)
        icon = "NONE" if icon == "NONE" else "BLANK1"

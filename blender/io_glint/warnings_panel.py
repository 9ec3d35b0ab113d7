# SPDX-License-Identifier: Apache-2.0
"""Render Properties > glint: warnings: those of the last F12 or export, each with what it is about."""
import re

import bpy
from bpy.props import StringProperty

from .labels import draw_sentence

MAX_ROWS = 100  # the others are copied only
_kept = []  # (item, text)


def keep(report):
    """The Report of the last F12 or export replaces what is shown."""
    _kept[:] = report.entries


def kept():
    """(item, text) of each warning that is shown."""
    return list(_kept)


def object_name(item, objects):
    """The name of the object that an item as "light 'Key'" is about, among a view layer's; None if it is about none."""
    found = re.fullmatch(r"(?:object|light|camera) '(.*)'", item, re.DOTALL)
    # An instance is named HOLDER/OBJECT.
    return next((name for name in (found[1], found[1].partition("/")[0]) if name in objects), None) if found else None


class RENDER_PT_glint_warnings(bpy.types.Panel):
    bl_label, bl_context = "glint: warnings", "render"
    bl_space_type, bl_region_type, bl_options = "PROPERTIES", "WINDOW", {"DEFAULT_CLOSED"}
    COMPAT_ENGINES = {"GLINT"}

    @classmethod
    def poll(cls, context):
        return context.engine in cls.COMPAT_ENGINES or bool(_kept)  # an export has no need of the engine

    def draw_header(self, _context):
        self.layout.label(text=str(len(_kept)), icon="ERROR" if _kept else "CHECKMARK")

    def draw(self, context):
        layout = self.layout
        if not _kept:
            layout.label(text="The last render and export had none")
            return
        layout.operator(GLINT_OT_copy_warnings.bl_idname, icon="COPYDOWN")
        for item, text in _kept[:MAX_ROWS]:
            column = layout.box().column(align=True)
            row = column.row()
            row.label(text=item)
            name = object_name(item, context.view_layer.objects)
            if name is not None:
                row.operator(GLINT_OT_select_item.bl_idname, text="", icon="RESTRICT_SELECT_OFF").name = name
            draw_sentence(column, text)
        if len(_kept) > MAX_ROWS:
            layout.label(text=f"and {len(_kept) - MAX_ROWS} more: copy them")


class GLINT_OT_select_item(bpy.types.Operator):
    bl_idname = "glint.select_item"
    bl_label = "Select"
    bl_description = "Select the object that the warning is about, and no other"
    bl_options = {"UNDO"}

    name: StringProperty()

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT"

    def execute(self, context):
        objects = context.view_layer.objects
        ob = objects.get(self.name)
        if ob is None:
            self.report({"ERROR"}, f"The view layer has no object '{self.name}'")
            return {"CANCELLED"}
        for other in objects:
            other.select_set(other == ob)
        objects.active = ob
        return {"FINISHED"}


class GLINT_OT_copy_warnings(bpy.types.Operator):
    bl_idname = "glint.copy_warnings"
    bl_label = "Copy All"
    bl_description = "Copy all warnings to the clipboard, one a line"

    def execute(self, context):
        context.window_manager.clipboard = "\n".join(f"{item}: {text}" for item, text in _kept)
        return {"FINISHED"}


_drawn = []


def _redraw():
    """F12 runs in a thread of its own, which must not touch the interface; a timer looks whether it has left something."""
    if _drawn != _kept:
        _drawn[:] = _kept
        for window in bpy.context.window_manager.windows:
            for area in window.screen.areas:
                if area.type == "PROPERTIES":
                    area.tag_redraw()
    return 0.5


classes = (GLINT_OT_copy_warnings, GLINT_OT_select_item, RENDER_PT_glint_warnings)


def register():
    if not bpy.app.background:
        bpy.app.timers.register(_redraw, persistent=True)


def unregister():
    if bpy.app.timers.is_registered(_redraw):
        bpy.app.timers.unregister(_redraw)

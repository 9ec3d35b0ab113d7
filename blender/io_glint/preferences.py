# SPDX-License-Identifier: Apache-2.0
"""The add-on's preferences: where the glint command is, whether viewports can be drawn, and the documentation."""
import os
import pathlib

import bpy
from bpy.props import StringProperty

from . import command, python_module
from .labels import draw_sentence


def wanted_path():
    """The path in the preferences; may be empty."""
    addon = bpy.context.preferences.addons.get(__package__)
    return bpy.path.abspath(addon.preferences.glint_path) if addon else ""


def glint_path():
    """The command's path, or None."""
    return command.find(wanted_path())


class GlintPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    glint_path: StringProperty(name="glint", subtype="FILE_PATH",
                               description="The glint command; empty: the add-on's own, else the one in PATH, else in the "
                               "variable GLINT")

    def draw(self, _context):
        self.layout.prop(self, "glint_path")
        path = glint_path()
        draw_sentence(self.layout, f"Used: {path}" if path else "No glint: set its path, or install the zip that has it",
                      icon="CHECKMARK" if path else "ERROR")
        _, fault = python_module.find()
        draw_sentence(self.layout, f"Rendered viewports: {fault or 'by the Python package, which was found'}",
                      icon="ERROR" if fault else "CHECKMARK")
        row = self.layout.row()
        row.operator("glint.find")
        row.operator("glint.documentation", icon="HELP")


DOCUMENTATION = os.path.join(os.path.dirname(os.path.abspath(__file__)), "documentation.html")


class GLINT_OT_documentation(bpy.types.Operator):
    bl_idname = "glint.documentation"
    bl_label = "Documentation"
    bl_description = "Show what the add-on does, in the web browser"

    def execute(self, _context):
        if not os.path.exists(DOCUMENTATION):
            self.report({"ERROR"}, "Only the add-on's zip has its documentation: here it is docs/blender.md of glint's sources")
            return {"CANCELLED"}
        return bpy.ops.wm.url_open(url=pathlib.Path(DOCUMENTATION).as_uri())


class GLINT_OT_find(bpy.types.Operator):
    bl_idname = "glint.find"
    bl_label = "Find glint"
    bl_description = "Look for the glint command and show its version"

    def execute(self, _context):
        path = glint_path()
        if path is None:
            self.report({"ERROR"}, command.not_found_text(wanted_path()))
            return {"CANCELLED"}
        try:
            self.report({"INFO"}, f"{command.version(path)}: {path}")
        except OSError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


classes = (GlintPreferences, GLINT_OT_documentation, GLINT_OT_find)

# SPDX-License-Identifier: Apache-2.0
"""The add-on's preferences: where the glint command is."""
import bpy
from bpy.props import StringProperty

from . import command
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
        self.layout.operator("glint.find")


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


classes = (GlintPreferences, GLINT_OT_find)

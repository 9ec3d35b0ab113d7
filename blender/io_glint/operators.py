# SPDX-License-Identifier: Apache-2.0
"""File > Export > glint (.glint) and > RT2 (.json)."""
import os
from dataclasses import replace

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from . import warnings_panel
from .export.camera import CameraError
from .export_files import export_animation, export_file, selection_of
from .properties import draw_settings

EVALUATIONS = (
    ("RENDER", "As rendered", "Modifiers and visibility as in a render; replaces the Render Result"),
    ("VIEWPORT", "As in the viewport", "Modifiers and visibility as in the viewport"),
)


class _Export(ExportHelper):
    """What both operators do: exports, and reports each warning."""

    bl_options = {"PRESET"}
    check_extension = None  # a path is taken as it is given

    evaluation: EnumProperty(name="Evaluate", items=EVALUATIONS, default="RENDER")
    use_selection: BoolProperty(name="Selected Objects", default=False,
                                description="Export the selected shapes and lights only, with the scene's camera")
    animation: BoolProperty(name="Animation", default=False,
                            description="One file for each frame, NAME.0001.glint, and a script that renders them")

    def export(self, context, options, as_rt2):
        if not os.path.basename(self.filepath):
            self.report({"ERROR"}, "No file: give a file name")
            return {"CANCELLED"}
        path = bpy.path.abspath(self.filepath)
        if not os.path.splitext(path)[1]:
            path += self.filename_ext
        if context.mode != "OBJECT" and context.object is not None:
            context.object.update_from_editmode()
        try:
            if self.use_selection:
                options = replace(options, selection=selection_of(context))
            arguments = (context, path, options, self.evaluation, as_rt2, getattr(self, "mesh_files", False))
            if self.animation:
                report, paths = export_animation(*arguments)
                done = f"{len(paths)} frames, {paths[0]} and so on" if paths else "no frames"
            else:
                report, done = export_file(*arguments), path
        except (CameraError, ValueError, RuntimeError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        warnings_panel.keep(report)
        for warning in report.warnings:
            self.report({"WARNING"}, warning)
        self.report({"INFO"}, f"Exported {done}")
        return {"FINISHED"}


class EXPORT_SCENE_OT_glint(bpy.types.Operator, _Export):
    bl_idname = "export_scene.glint"
    bl_label = "Export glint"
    bl_description = "Write the scene as glint's own language, or as RT2's JSON"

    filename_ext = ".glint"
    filter_glob: StringProperty(default="*.glint;*.json", options={"HIDDEN"})
    format: EnumProperty(name="Format", default="AUTO", items=(
        ("AUTO", "By extension", ".json: RT2; else glint's own language"),
        ("GLINT", "glint", "glint's own language"),
        ("RT2", "RT2", "The JSON of RT2's homework")))
    mesh_files: BoolProperty(name="Meshes in files", default=True,
                             description="Write meshes of 1,000 triangles or more as .ply into the folder NAME_meshes; else all "
                             "meshes are in the text")

    def execute(self, context):
        as_rt2 = self.format == "RT2" or (self.format == "AUTO" and self.filepath.lower().endswith(".json"))
        return self.export(context, context.scene.glint.options(), as_rt2)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        for name in ("format", "use_selection", "evaluation", "animation", "mesh_files"):
            layout.prop(self, name)
        draw_settings(layout, context.scene)


class EXPORT_SCENE_OT_rt2(bpy.types.Operator, _Export):
    bl_idname = "export_scene.rt2"
    bl_label = "Export RT2"
    bl_description = "Write the scene as the JSON of RT2's homework"

    filename_ext = ".json"
    filter_glob: StringProperty(default="*.json", options={"HIDDEN"})
    collection: StringProperty(name="Collection", default="",
                               description="What is exported; empty: scene_custom if there is one, else everything")
    light_color: EnumProperty(name="Light", default="color", items=(
        ("color", "Color", "The light's color, as the course's script writes it"),
        ("classical", "Intensity", "The light's intensity at the camera's target")))

    def execute(self, context):
        options = context.scene.glint.options(collection=self.collection, light_color=self.light_color)
        return self.export(context, options, True)


def _menu(self, _context):
    self.layout.operator(EXPORT_SCENE_OT_glint.bl_idname, text="glint (.glint)")
    self.layout.operator(EXPORT_SCENE_OT_rt2.bl_idname, text="RT2 (.json)")


classes = (EXPORT_SCENE_OT_glint, EXPORT_SCENE_OT_rt2)


def register():
    bpy.types.TOPBAR_MT_file_export.append(_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(_menu)

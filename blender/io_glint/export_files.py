# SPDX-License-Identifier: Apache-2.0
"""Exports of the context's scene into files: one, or one for each frame."""
import dataclasses
import os
import shlex

import bpy

from .course_scene import collection_of, messages
from .evaluate import with_depsgraph
from .export import camera
from .export.files import write_text
from .export.images import Images
from .export.mesh_file import MeshFiles
from .export.report import Report
from .export.rt2 import RT2Scene, rt2_text
from .export.scene import glint_text, report_color_management, report_settings
from .properties import SCENE_SETTINGS


def export_text(context, options, evaluation, as_rt2, report, mesh_files=None, images=None):
    """The scene's text. mesh_files: a MeshFiles; None: meshes are in the text. images: an Images. Raises CameraError, ValueError or RuntimeError, whose text is for the user."""
    scene = context.scene
    collection = collection_of(scene, options.collection) if as_rt2 else None
    chosen = scene.camera
    if chosen is None and as_rt2:
        members = collection.all_objects if collection else scene.objects
        scene.camera = next((ob for ob in members if ob.type == "CAMERA"), None)
    try:
        if scene.camera is None:
            camera.read(None, scene, report)
        report_settings(scene, context.view_layer, report)  # the render below has some of them off
        report_color_management(scene, report)
        crop = camera.border(scene.render)
        if crop:
            report.warn(f"scene '{scene.name}'", "a scene's text has no render region; its part is --crop {}x{}+{}+{}"
                        .format(*crop))
        if as_rt2:
            for item, text in messages(scene, collection, options.selection):
                report.warn(item, text)
            return with_depsgraph(context, evaluation, lambda depsgraph: rt2_text(RT2Scene(
                depsgraph, options, report, bpy.data.materials.get, collection)))
        return with_depsgraph(context, evaluation, lambda depsgraph: glint_text(
            depsgraph, options, report, bpy.data.materials.get, mesh_files, images))
    finally:
        if scene.camera != chosen:
            scene.camera = chosen


def selection_of(context):
    """The selected objects, as Options.selection has them. Raises ValueError if there are none."""
    layer = context.view_layer
    pointers = frozenset(ob.as_pointer() for ob in layer.objects if ob.select_get(view_layer=layer))
    if not pointers:
        raise ValueError("No object is selected: select what to export, or turn Selected Objects off")
    return pointers


def mesh_files_of(path):
    """The files of large meshes: in the folder NAME_meshes beside NAME.glint."""
    folder = os.path.splitext(path)[0] + "_meshes"
    return MeshFiles(folder, os.path.basename(folder))


def images_of(path):
    """The files of textures: in the folder NAME_textures beside NAME.glint."""
    folder = os.path.splitext(path)[0] + "_textures"
    return Images(folder, os.path.basename(folder))


def export_file(context, path, options, evaluation="RENDER", as_rt2=False, has_mesh_files=False):
    """Writes one file, and with has_mesh_files those of its large meshes, and returns the Report."""
    report = Report()
    mesh_files = mesh_files_of(path) if has_mesh_files else None
    write_text(path, export_text(context, options, evaluation, as_rt2, report, mesh_files, images_of(path)))
    return report


def frame_path(path, frame):
    """NAME.0001.glint for NAME.glint."""
    base, extension = os.path.splitext(path)
    return f"{base}.{frame:04d}{extension}"


def export_animation(context, path, options, evaluation="RENDER", as_rt2=False, has_mesh_files=False):
    """Writes NAME.0001.glint, ... for the scene's frames and NAME.sh, which renders them. Returns (Report, the paths)."""
    scene, report, paths = context.scene, Report(), []
    mesh_files = mesh_files_of(path) if has_mesh_files else None  # of all frames: a mesh that rests is written once
    images = images_of(path)
    frame, subframe = scene.frame_current, scene.frame_subframe
    frames = range(scene.frame_start, scene.frame_end + 1, max(1, scene.frame_step))
    try:
        for f in frames:
            scene.frame_set(f)
            options = dataclasses.replace(options, **{name: getattr(scene.glint, name) for name in SCENE_SETTINGS})  # animated
            paths.append(frame_path(path, f))
            write_text(paths[-1], export_text(context, options, evaluation, as_rt2, report, mesh_files, images))
    finally:
        scene.frame_set(frame, subframe=subframe)
    script = os.path.splitext(path)[0] + ".sh"
    write_text(script, render_script(scene, paths))
    os.chmod(script, 0o755)
    return report, paths


def render_script(scene, paths):
    """A shell script that renders the files beside it, with GLINT or glint."""
    crop = camera.border(scene.render)
    more = " --crop {}x{}+{}+{}".format(*crop) if crop else ""
    lines = ["#!/bin/sh", "# Renders every frame. GLINT: the command, if it is not in PATH.", "set -e",
             'cd "$(dirname "$0")"']
    for path in paths:
        name = os.path.basename(path)
        picture = os.path.splitext(name)[0] + ".png"
        lines.append(f'"${{GLINT:-glint}}" render ./{shlex.quote(name)} --transfer srgb{more} '
                     f'-o {shlex.quote(picture)} "$@"')
    return "\n".join(lines) + "\n"

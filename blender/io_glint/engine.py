# SPDX-License-Identifier: Apache-2.0
"""The render engine "glint": F12 and animations by the glint command, viewports by glint's Python package."""
import os
import shutil
import tempfile

import bpy

from . import command, exr, passes, python_module, viewport_message, warnings_panel
from .course_scene import collection_of, messages
from .export import camera
from .export.files import write_text
from .export.images import Images
from .export.report import Report
from .export.mesh_file import MeshFiles
from .export.rt2 import RT2Scene, rt2_text
from .export.scene import SceneText, Stopped, write
from .preferences import glint_path, wanted_path
from .render_settings import extra_arguments, kept_name
from .viewport import Viewport, viewports

POLL = 0.02  # seconds


class RenderFailed(Exception):
    """The text is for the user."""


class GlintRenderEngine(bpy.types.RenderEngine):
    bl_idname = "GLINT"
    bl_label = "glint"
    bl_use_preview = True
    bl_use_postprocess = True
    bl_use_eevee_viewport = True  # the viewport shading Material Preview is Eevee's
    _viewport, _fault = None, ""  # of a viewport: what draws it, or why nothing does

    def __init__(self, *args, **kwargs):
        super().__init__(*args, **kwargs)  # needed from 4.4

    def __del__(self):
        if self._viewport is not None:
            self._viewport.close()

    def view_update(self, context, depsgraph):
        module, self._fault = python_module.find()
        if module is None:
            self.update_stats("glint", self._fault)
            return
        if self._viewport is None:
            self._viewport = Viewport(self, module)
        self._viewport.update(context, depsgraph)

    def view_draw(self, context, depsgraph):
        if self._viewport is not None:
            self._viewport.draw(context, depsgraph)
        else:
            viewport_message.draw(self._fault, context.region)

    def update_render_passes(self, scene=None, renderlayer=None):
        self.register_pass(scene, renderlayer, "Combined", 4, "RGBA", "COLOR")
        for layer in passes.wanted(renderlayer):
            name, channels, _, kind = passes.PASSES[layer]
            self.register_pass(scene, renderlayer, name, len(channels), channels, kind)

    def render(self, depsgraph):
        report = Report()
        try:
            with tempfile.TemporaryDirectory(prefix="glint-") as folder:
                self._render(depsgraph, folder, report)
        except Stopped:
            pass
        except (RenderFailed, camera.CameraError, OSError, exr.ExrError, RuntimeError) as error:
            self._say_error(f"glint: {error}")
        if self.is_preview:  # of a material or a world; its lights and its floor are Blender's
            return
        warnings_panel.keep(report)
        for warning in report.warnings:
            self.report({"WARNING"}, warning if warning.startswith("glint: ") else f"glint: {warning}")

    def _say_error(self, text):
        if not self.is_preview:
            self.error_set(text)  # stops an animation
            self.report({"ERROR"}, text)

    def _render(self, depsgraph, folder, report):
        path = glint_path()
        if path is None:
            raise RenderFailed(command.not_found_text(wanted_path()))
        if fault := command.version_fault(path):
            raise RenderFailed(fault)
        self.update_stats("", "glint: writing the scene")
        scene = depsgraph.scene_eval
        more = extra_arguments(scene.glint.extra_arguments)
        written, file, options = self._write(depsgraph, folder, report)
        layers = passes.wanted(depsgraph.view_layer_eval)
        crop = camera.border(scene.render)
        combined = picture = os.path.join(folder, "picture.exr")
        arguments = [path, "render", file, "-o", picture, *options]
        if crop:
            arguments += ["--crop", "{}x{}+{}+{}".format(*crop)]
        if layers:
            arguments += ["--aov", ",".join(layers)]
        if scene.render.threads_mode == "FIXED":
            arguments += ["--threads", str(scene.render.threads)]
        if not self._run([*arguments, *more], file, report, is_kept=bool(scene.glint.keep_folder)):
            return
        found = {}
        if layers:
            combined = os.path.join(folder, "combined.exr")
            exr.write_first_part(picture, combined)  # Blender loads plain files only
            found = {part.name: passes.pixels(passes.converted(part, part.name, written, crop), part.name)
                     for part in exr.read(picture, layers)}
        width, height = crop[:2] if crop else camera.picture_size(scene.render)
        result = self.begin_result(0, 0, width, height, layer=depsgraph.view_layer_eval.name)
        try:  # Blender crashes if a result is not ended
            first = exr.read(combined)[0] if scene.render.film_transparent else None
            if first is not None and "A" in first.channels:
                # load_from_file() multiplies by alpha what is multiplied already.
                result.layers[0].passes["Combined"].rect = passes.pixels(first, passes.COMBINED)
            else:
                result.layers[0].load_from_file(combined)
            for layer, pixels in found.items():
                target = result.layers[0].passes.get(passes.PASSES[layer][0])
                if target is not None:
                    target.rect = pixels
        finally:
            self.end_result(result)

    def _write(self, depsgraph, folder, report):
        """Writes the scene. (what was written, its file, options of `glint render`)"""
        scene = depsgraph.scene_eval
        settings, name = scene.glint, "scene"
        if settings.keep_folder:
            folder, name = bpy.path.abspath(settings.keep_folder), kept_name(scene, depsgraph.view_layer_eval)
            os.makedirs(folder, exist_ok=True)
        if settings.picture == "BLENDER":
            written = SceneText(depsgraph, settings.options(), report, bpy.data.materials.get, self._is_stopped,
                                MeshFiles(os.path.join(folder, "meshes"), "meshes"),
                                images=Images(os.path.join(folder, "textures"), "textures"))
            file = os.path.join(folder, f"{name}.glint")
            write_text(file, write(written))
            return written, file, []
        original = depsgraph.scene
        collection = collection_of(original)
        for item, text in messages(original, collection):
            report.warn(item, text)
        written = RT2Scene(depsgraph, settings.options(), report, bpy.data.materials.get, collection)
        file = os.path.join(folder, f"{name}.json")
        write_text(file, rt2_text(written))
        options = ["--size", "{}x{}".format(*camera.picture_size(scene.render))]
        for key, value in settings.rt2_settings().items():
            options += [f"--{key}", str(value)]
        return written, file, options

    def _is_stopped(self):
        """Whether the user pressed Esc."""
        return self.test_break()

    def _run(self, arguments, file, report, is_kept):
        """Runs glint to its end; false if the user stopped it."""
        try:
            run = command.Run(arguments)
        except OSError as error:
            raise RenderFailed(f"{arguments[0]} cannot be run: {error}") from None
        shown = None
        while (code := run.poll(POLL)) is None:
            if self._is_stopped():
                run.stop()
                return False
            if run.progress != shown:
                shown = run.progress
                self.update_progress(shown)
                self.update_stats("", f"glint: {100 * shown:.0f}%")
        # The folder is gone when the user reads this.
        lines = [line.replace(os.path.dirname(file) + os.sep, "") for line in run.messages()]
        errors, warnings = command.diagnostics(lines)
        for warning in warnings:
            report.warn("glint", warning.rpartition("warning: ")[2])
        if code:
            raise RenderFailed(f"{errors[0] if errors else ': '.join([command.exit_text(code), *lines[-3:]])}. The "
                               f"scene is kept in {file if is_kept else self._keep(file)}")
        return True

    @staticmethod
    def _keep(file):
        """Copies the scene's file, and those of its meshes and textures, to where they stay."""
        folder = tempfile.mkdtemp(prefix="glint-failed-")
        for name in ("meshes", "textures"):
            part = os.path.join(os.path.dirname(file), name)
            if os.path.isdir(part):
                shutil.copytree(part, os.path.join(folder, name))
        return shutil.copy(file, folder)


classes = (GlintRenderEngine,)


def unregister():
    for viewport in viewports():
        viewport.close()

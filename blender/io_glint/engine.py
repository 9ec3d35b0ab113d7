# SPDX-License-Identifier: Apache-2.0
"""The render engine "glint": F12 and animations by the glint command."""
import os
import shutil
import tempfile

import bpy

from . import command, exr, passes
from .export import camera
from .export.files import write_text
from .export.report import Report
from .export.scene import SceneText, Stopped, write
from .preferences import glint_path, wanted_path

POLL = 0.02  # seconds


class RenderFailed(Exception):
    """The text is for the user."""


class GlintRenderEngine(bpy.types.RenderEngine):
    bl_idname = "GLINT"
    bl_label = "glint"
    bl_use_preview = False
    bl_use_postprocess = True
    bl_use_eevee_viewport = True

    def __init__(self, *args, **kwargs):
        super().__init__(*args, **kwargs)  # needed from 4.4

    def update_render_passes(self, scene=None, renderlayer=None):
        self.register_pass(scene, renderlayer, "Combined", 4, "RGBA", "COLOR")
        for layer in passes.wanted(renderlayer):
            name, channels, _, kind = passes.PASSES[layer]
            self.register_pass(scene, renderlayer, name, len(channels), channels, kind)

    def render(self, depsgraph):
        if self.is_preview:
            return
        report = Report()
        try:
            with tempfile.TemporaryDirectory(prefix="glint-") as folder:
                self._render(depsgraph, folder, report)
        except Stopped:
            pass
        except (RenderFailed, camera.CameraError, OSError, exr.ExrError, RuntimeError) as error:
            self.error_set(f"glint: {error}")  # stops an animation
            self.report({"ERROR"}, f"glint: {error}")
        for warning in report.warnings:
            self.report({"WARNING"}, warning if warning.startswith("glint: ") else f"glint: {warning}")

    def _render(self, depsgraph, folder, report):
        path = glint_path()
        if path is None:
            raise RenderFailed(command.not_found_text(wanted_path()))
        if fault := command.version_fault(path):
            raise RenderFailed(fault)
        self.update_stats("", "glint: writing the scene")
        scene = depsgraph.scene_eval
        written = SceneText(depsgraph, scene.glint.options(), report, bpy.data.materials.get, self._is_stopped)
        file = os.path.join(folder, "scene.glint")
        write_text(file, write(written))
        layers = passes.wanted(depsgraph.view_layer_eval)
        crop = camera.border(scene.render)
        combined = picture = os.path.join(folder, "picture.exr")
        arguments = [path, "render", file, "-o", picture]
        if crop:
            arguments += ["--crop", "{}x{}+{}+{}".format(*crop)]
        if layers:
            arguments += ["--aov", ",".join(layers)]
        if scene.render.threads_mode == "FIXED":
            arguments += ["--threads", str(scene.render.threads)]
        if not self._run(arguments, folder, report):
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
            if scene.render.film_transparent:
                # load_from_file() multiplies by alpha what is multiplied already.
                first = exr.read(combined)[0]
                result.layers[0].passes["Combined"].rect = passes.pixels(first, passes.COMBINED)
            else:
                result.layers[0].load_from_file(combined)
            for layer, pixels in found.items():
                target = result.layers[0].passes.get(passes.PASSES[layer][0])
                if target is not None:
                    target.rect = pixels
        finally:
            self.end_result(result)

    def _is_stopped(self):
        """Whether the user pressed Esc."""
        return self.test_break()

    def _run(self, arguments, folder, report):
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
        messages = [message.replace(folder + os.sep, "") for message in run.messages()]
        errors, warnings = command.diagnostics(messages)
        for warning in warnings:
            report.warn("glint", warning.rpartition("warning: ")[2])
        if code:
            raise RenderFailed(f"{errors[0] if errors else ': '.join([command.exit_text(code), *messages[-3:]])}. The "
                               f"scene is kept in {self._keep(folder)}")
        return True

    @staticmethod
    def _keep(folder):
        """Moves the scene's file to where it stays."""
        kept, name = tempfile.mkstemp(prefix="glint-failed-", suffix=".glint")
        os.close(kept)
        shutil.copyfile(os.path.join(folder, "scene.glint"), name)
        return name


classes = (GlintRenderEngine,)

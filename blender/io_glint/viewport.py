# SPDX-License-Identifier: Apache-2.0
"""A 3D viewport in rendered mode: what changes in Blender is asked of a renderer, and its picture is drawn."""
import os
import re
import tempfile
import time
import weakref

import bpy
import gpu
from gpu_extras.presets import draw_texture_2d

from . import viewport_message
from .course_scene import collection_of
from .export import camera, mesh
from .export.images import Images
from .export.mesh_file import MeshFiles
from .export.report import Report
from .export.rt2 import RT2Scene, rt2_text
from .export.scene import SceneText, write_parts
from .progressive_renderer import ProgressiveRenderer, ViewRequest, SceneParts

REST = 0.002  # seconds between two steps, for the user's events
CALM_SECONDS = 0.1  # without a new view, until its picture is refined: an orbit's pictures are followed by others
LONGEST_PAUSE = 0.4  # between two views of an orbit
SHOWN_SECONDS = 0.2  # between two states of a picture that are drawn: Blender itself may need as long as several steps
_open = weakref.WeakSet()


class Viewport:
    """The picture of one viewport; the engine owns it, and closes it."""

    def __init__(self, engine, glint):
        self._engine, self.renderer, self._timer = weakref.ref(engine), ProgressiveRenderer(glint), self._refine
        self._folder = tempfile.TemporaryDirectory(prefix="glint-viewport-")  # pylint: disable=consider-using-with
        self._meshes, self._written, self._wanted = mesh.MeshCache(), None, None
        self._images = Images(os.path.join(self._folder.name, "textures"), "textures")
        self._texture, self._is_changed = None, True  # is_changed: the renderer has more than the texture
        self._drawn_at, self._fault, self._settings = 0.0, "", None
        self._asked_at = self._calm_at = 0.0
        _open.add(self)

    def close(self):
        """May be called twice."""
        if self._timer is None:
            return
        _open.discard(self)
        if bpy.app.timers.is_registered(self._timer):
            bpy.app.timers.unregister(self._timer)
        # Python's collector of cycles must not find the texture: it may run in a thread without the window's OpenGL.
        self._timer = self._texture = self._written = self._wanted = None
        self._folder.cleanup()

    def update(self, context, depsgraph):
        """Blender's data have changed; it draws afterwards."""
        try:
            self._write(context, depsgraph)
            self._fault = ""
        except Exception as error:  # pylint: disable=broad-except
            self._fault = str(error) or type(error).__name__  # draw() shows it: Blender would print a traceback only

    def _write(self, context, depsgraph):
        has_new_meshes = any(update.is_updated_geometry for update in depsgraph.updates)
        if has_new_meshes:
            self._meshes.clear()
        for update in depsgraph.updates:
            if isinstance(update.id, bpy.types.Image):
                self._images.forget(update.id.name_full)
        # Not of the evaluated scene: Blender does not evaluate it again when these change.
        settings = depsgraph.scene.glint
        self._settings = _values_of(settings)
        name = os.path.join(self._folder.name, "viewport")
        if settings.picture == "RT2":
            written = RT2Scene(depsgraph, settings.options(), Report(), bpy.data.materials.get, collection_of(depsgraph.scene),
                               self._images)
            self._written = SceneParts(rt2_text(written), None, "epfl", name + ".json", settings.rt2_settings())
        else:
            space = context.space_data
            written = SceneText(depsgraph, settings.options(), Report(), bpy.data.materials.get,
                                mesh_files=MeshFiles(os.path.join(self._folder.name, "meshes"), "meshes"), view=_view_of(context),
                                meshes=self._meshes, wanted=lambda item: _is_shown(item, space), images=self._images)
            head, shapes = write_parts(written)
            self._written = SceneParts(head, shapes, "glint", name + ".glint")
            if has_new_meshes:  # else the cache has meshes that are hidden now, and their files
                self._remove_files(shapes)

    def draw(self, context, depsgraph):
        """Blender draws the viewport: when its view has changed, too."""
        scene, region = depsgraph.scene, context.region
        if self._settings != _values_of(scene.glint):
            self.update(context, depsgraph)
        renderer, engine = self.renderer, self._engine()
        if self._fault or self._written is None:
            engine.update_stats("glint", self._fault)
            viewport_message.draw(self._fault, region)
            return
        if self._ask(_view_of(context), (region.width, region.height), scene):
            renderer.step()
            self._is_changed = True
        engine.update_stats("glint", renderer.fault or ("" if renderer.is_final else "rendering"))
        if renderer.fault:
            viewport_message.draw(renderer.fault, region)
        if renderer.picture is None or renderer.fault:
            return
        if self._is_changed:
            self._texture, self._is_changed = _texture_of(renderer.picture), False
        gpu.state.blend_set("ALPHA_PREMULT")
        engine.bind_display_space_shader(depsgraph.scene)
        draw_texture_2d(self._texture, (0, 0), region.width, region.height)
        engine.unbind_display_space_shader()
        gpu.state.blend_set("NONE")
        self._drawn_at = time.monotonic()

    def _ask(self, view, size, scene):
        """Whether something new is to be shown."""
        settings = scene.glint
        is_rt2 = settings.picture == "RT2"
        aa = settings.rt2_settings()["aa"] if is_rt2 else settings.options().samples
        wanted = ViewRequest(self._written, camera.camera_block(view), size, aa, scene.render.film_transparent and not is_rt2)
        if wanted == self._wanted:
            return False
        self._wanted = wanted
        self.renderer.ask(wanted)
        now = time.monotonic()
        pause, self._asked_at = now - self._asked_at, now
        self._calm_at = now + max(CALM_SECONDS, 1.5 * pause if pause < LONGEST_PAUSE else 0)
        if not bpy.app.timers.is_registered(self._timer):
            bpy.app.timers.register(self._timer, first_interval=REST)
        return True

    def _refine(self):
        """The next step of the picture; Blender's timer calls it, between the user's events."""
        engine = self._engine()
        if engine is None or self._timer is None:
            return None
        wait = self._calm_at - time.monotonic()
        if wait > 0 and not self.renderer.is_final:
            return wait
        self.renderer.step()
        self._is_changed = True
        try:
            if self.renderer.is_final or time.monotonic() - self._drawn_at > SHOWN_SECONDS:
                engine.tag_redraw()
        except ReferenceError:  # Blender has freed it
            return None
        return None if self.renderer.is_final else REST

    def _remove_files(self, shapes):
        """Removes files of meshes that are no longer there."""
        folder = os.path.join(self._folder.name, "meshes")
        used = set(re.findall(r'file = "meshes/([^"]*)"', shapes))
        for file in set(os.listdir(folder)) - used if os.path.isdir(folder) else ():
            os.remove(os.path.join(folder, file))


def _view_of(context):
    region, data = context.region, context.region_data
    return camera.of_viewport(data.view_matrix, data.window_matrix, (region.width, region.height))


def _values_of(settings):
    """All settings that decide what is drawn."""
    return settings.picture, settings.options(), tuple(settings.rt2_settings().items())


def _is_shown(item, space):
    """Whether this viewport shows an item: it may be in local view, or hide types of objects."""
    return (item.holder or item.ob).original.visible_in_viewport_get(space)


def _texture_of(rgba):
    height, width, _ = rgba.shape
    return gpu.types.GPUTexture((width, height), format="RGBA16F", data=gpu.types.Buffer("FLOAT", rgba.size, rgba.reshape(-1)))


def viewports():
    """Those that are open."""
    return list(_open)

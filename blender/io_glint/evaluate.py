# SPDX-License-Identifier: Apache-2.0
"""A depsgraph as a render sees it. Blender gives one only to a render engine, so a private engine asks for it."""
from contextlib import contextmanager

import bpy

_OFF = ("use_compositing", "use_sequencer", "use_multiview", "use_border", "use_freestyle")


@contextmanager
def _changed(holder, values):
    old = {key: getattr(holder, key) for key in values if hasattr(holder, key)}
    try:
        for key in old:
            setattr(holder, key, values[key])
        yield
    finally:
        for key, value in old.items():
            setattr(holder, key, value)


def with_render_depsgraph(context, function):
    """Calls function(depsgraph) within a render of the context's view layer and returns what it returns; passes its
    exception on. Replaces the Render Result and runs render handlers, as every render does. Raises RuntimeError if
    Blender does not start the render (without a camera, for example)."""
    outcome = {}

    class Capture(bpy.types.RenderEngine):
        bl_idname, bl_label = "GLINT_EXPORT", "glint export"

        def render(self, depsgraph):
            try:
                outcome["value"] = function(depsgraph)
            except Exception as error:  # pylint: disable=broad-except
                outcome["error"] = error

    if bpy.app.is_job_running("RENDER"):
        raise RuntimeError("Blender is rendering: export when it has finished")
    scene = context.scene
    bpy.utils.register_class(Capture)
    try:
        with _changed(scene.render, {key: False for key in _OFF} | {"engine": "GLINT_EXPORT"}):
            bpy.ops.render.render(layer=context.view_layer.name, scene=scene.name)
    finally:
        bpy.utils.unregister_class(Capture)
    if "error" in outcome:
        raise outcome["error"]
    if "value" not in outcome:
        raise RuntimeError("Blender did not render the scene")
    return outcome["value"]


def with_depsgraph(context, evaluation, function):
    """evaluation: RENDER or VIEWPORT."""
    if evaluation == "VIEWPORT":
        return function(context.evaluated_depsgraph_get())
    return with_render_depsgraph(context, function)

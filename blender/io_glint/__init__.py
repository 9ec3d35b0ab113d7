# SPDX-License-Identifier: Apache-2.0
"""glint for Blender: exports scenes as .glint and RT2's .json, and renders them by the glint command."""
bl_info = {
    "name": "glint",
    "author": "The glint authors",
    "version": (0, 3, 0),
    "blender": (3, 3, 0),
    "location": "File > Export > glint (.glint), RT2 (.json); render engine glint",
    "description": "Export scenes to glint and to RT2's JSON, and render them by glint",
    "doc_url": "",  # no site is published yet: the button Documentation shows the copy in the zip (preferences.py)
    "category": "Import-Export",
}


def _modules():
    from . import engine, exercise, operators, preferences, primitives, properties, ui, warnings_panel  # bpy is there only now
    return properties, preferences, operators, primitives, exercise, ui, warnings_panel, engine


def register():
    import bpy
    for module in _modules():
        for cls in getattr(module, "classes", ()):
            bpy.utils.register_class(cls)
        if hasattr(module, "register"):
            module.register()


def unregister():
    import bpy
    for module in reversed(_modules()):
        if hasattr(module, "unregister"):
            module.unregister()
        for cls in reversed(getattr(module, "classes", ())):
            bpy.utils.unregister_class(cls)

# SPDX-License-Identifier: Apache-2.0
"""A zip with the command, as somebody without glint would use it: installed, it renders, and has what viewports need. Needs
empty folders for Blender's settings:
    BLENDER_USER_SCRIPTS=A BLENDER_USER_CONFIG=B blender -b --factory-startup --python-exit-code 3 --python blender/tests/try_zip.py -- ZIP PICTURE.png
The command is in neither PATH nor GLINT."""
import os
import sys

import addon_utils
import bpy

zip_path, picture = sys.argv[sys.argv.index("--") + 1:]
os.environ["PATH"], os.environ["GLINT"] = os.defpath, ""
os.makedirs(os.path.join(os.environ["BLENDER_USER_SCRIPTS"], "addons"), exist_ok=True)
bpy.ops.preferences.addon_install(filepath=zip_path, overwrite=True)
bpy.ops.preferences.addon_enable(module="io_glint")

scene = bpy.context.scene  # a cube, a light and a camera
scene.render.engine = "GLINT"
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 96, 64, 100
scene.render.image_settings.file_format = "PNG"
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)

from io_glint import command, python_module  # noqa: E402  pylint: disable=wrong-import-position,import-error

addon = os.path.dirname(next(m.__file__ for m in addon_utils.modules() if m.__name__ == "io_glint"))
assert command.find().startswith(os.path.join(addon, "program")), command.find()
module, fault = python_module.find()
assert module is not None and module.__file__.startswith(addon), fault or module.__file__
pixels = bpy.data.images.load(picture).pixels[:]
levels = {round(v, 2) for v in pixels[0::4]}
assert len(levels) > 3, f"the picture has {len(levels)} gray levels: no cube is seen"
print(f"{command.version(command.find())} of the zip has drawn {picture}")

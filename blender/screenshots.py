# SPDX-License-Identifier: Apache-2.0
"""Makes the pictures of docs/blender.md. The paths of the user's folder are seen in them, so HOME should be one for this:
    export HOME=/home/student GLINT=/home/student/glint/build/release/glint
    blender -b --python blender/screenshots.py
    xvfb-run -a -s "-screen 0 1280x1024x24" blender --window-geometry 0 0 1200 900 --python blender/screenshots.py
The first command installs the add-on and turns the splash screen off; the second takes the pictures."""
import os
import pathlib
import sys
import tempfile
import traceback

import addon_utils
import bpy

HERE = pathlib.Path(__file__).resolve().parent
IMAGES = HERE.parent / "docs" / "images"
sys.path.insert(0, str(HERE))
import package  # noqa: E402  pylint: disable=wrong-import-position


def image(name):
    return str(IMAGES / f"blender_{name}.png")


def main_window():
    return bpy.context.window_manager.windows[0]


def area_of(kind, window=None):
    return next(a for a in (window or main_window()).screen.areas if a.type == kind)


def override(kind, window=None):
    window = window or main_window()
    area = area_of(kind, window)
    return bpy.context.temp_override(window=window, area=area, region=next(r for r in area.regions if r.type == "WINDOW"))


def preferences():
    return bpy.context.preferences.addons["io_glint"].preferences


def install():
    with tempfile.TemporaryDirectory() as folder:
        bpy.ops.preferences.addon_install(filepath=str(package.make(folder)), overwrite=True)
    sys.path.remove(str(HERE))
    bpy.ops.preferences.addon_enable(module="io_glint")
    preferences().glint_path = os.environ["GLINT"]
    bpy.context.preferences.view.show_splash = False
    bpy.ops.wm.save_userpref()


def open_preferences():
    bpy.ops.screen.userpref_show()
    bpy.context.preferences.active_section = "ADDONS"
    bpy.context.window_manager.addon_search = "glint"
    for module in addon_utils.modules():
        if module.__name__ == "io_glint":
            addon_utils.module_bl_info(module)["show_expanded"] = True


def take_preferences():
    window = bpy.context.window_manager.windows[-1]
    with override("PREFERENCES", window):
        bpy.ops.screen.screenshot_area(filepath=image("preferences"))
    with bpy.context.temp_override(window=window):
        bpy.ops.wm.window_close()


def start_exercise():
    with bpy.context.temp_override(window=main_window()):
        bpy.ops.glint.rt2_exercise()
    space = area_of("VIEW_3D").spaces[0]
    space.region_3d.view_perspective = "CAMERA"
    space.shading.type = "SOLID"
    select("Light1")
    area_of("PROPERTIES").spaces[0].context = "DATA"


def select(name):
    layer = main_window().view_layer
    for ob in layer.objects:
        ob.select_set(ob.name == name)
    layer.objects.active = layer.objects[name]


def take_scene():
    with bpy.context.temp_override(window=main_window()):
        bpy.ops.screen.screenshot(filepath=image("scene"))


def split_off_properties():
    """A wide properties editor, with the panel of custom properties open."""
    panel = bpy.types.OBJECT_PT_custom_props
    bpy.utils.unregister_class(panel)
    panel.bl_options = set()
    bpy.utils.register_class(panel)
    view = area_of("VIEW_3D")
    with override("VIEW_3D"):
        bpy.ops.screen.area_split(direction="VERTICAL", factor=0.55)
    new = next(a for a in main_window().screen.areas if a.type == "VIEW_3D" and a != view)
    new.type = "PROPERTIES"
    select("Sphere")


def show_property():
    wide_properties().spaces[0].context = "OBJECT"


def wide_properties():
    areas = [a for a in main_window().screen.areas if a.type == "PROPERTIES"]
    return max(areas, key=lambda a: a.width)


def take_properties(name):
    area = wide_properties()
    with bpy.context.temp_override(window=main_window(), area=area, region=area.regions[-1]):
        bpy.ops.screen.screenshot_area(filepath=image(name))


def take_property():
    take_properties("property")


def show_material():
    material = bpy.data.materials.new("gold")
    bpy.data.objects["Sphere"].data.materials.append(material)
    wide_properties().spaces[0].context = "MATERIAL"
    for name, value in (("color", (0.8, 0.55, 0.15)), ("ambient", 0.1), ("diffuse", 0.6), ("specular", 0.6),
                        ("shininess", 20.0), ("mirror", 0.2)):
        with bpy.context.temp_override(material=material):
            bpy.ops.glint.material_key(key=name)
        material[f"glint_{name}"] = value


def take_material():
    take_properties("material")
    bpy.data.objects["Sphere"].data.materials.clear()


def render(name, width=320):
    scene = bpy.data.scenes["RT2 exercise"]
    scene.render.resolution_x = scene.render.resolution_y = width
    scene.render.filepath = image(name)
    bpy.ops.render.render(write_still=True, scene=scene.name)


def render_pictures():
    render("before")
    bpy.data.objects["Light1"].location = (-1, -5, 5)
    render("after")
    bpy.data.objects["Light1"].location = (4, -3, 5)
    bpy.data.objects["Sphere"]["material"] = "mirror"
    bpy.data.objects["Cylinder"]["material"] = "gold"
    render("materials")


def show_export():
    with override("VIEW_3D"):
        bpy.ops.export_scene.glint("INVOKE_DEFAULT", filepath="exercise.glint")


def take_export():
    window = bpy.context.window_manager.windows[-1]
    with bpy.context.temp_override(window=window):
        bpy.ops.screen.screenshot(filepath=image("export"))


steps = [open_preferences, take_preferences, start_exercise, take_scene, split_off_properties, show_property, take_property, show_material,
         take_material, render_pictures, show_export, take_export]


def step():
    try:
        steps.pop(0)()
        if steps:
            return 2.0
    except Exception:  # Blender must not stay open
        traceback.print_exc()
    bpy.ops.wm.quit_blender()
    return None


if bpy.app.background:
    install()
else:
    bpy.app.timers.register(step, first_interval=1.0)

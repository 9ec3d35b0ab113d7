# SPDX-License-Identifier: Apache-2.0
"""In a window of Blender, under xvfb: how soon rendered viewports show a picture, and how many of an orbit they show in a second. The
figures are printed; the bounds are generous, because other work on the machine counts. Blender's own event loop runs: between the
orbit's pictures, it calls the timer that refines them."""
import math
import os
import pathlib
import sys
import time
import traceback

import bpy
from mathutils import Quaternion

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [os.environ["GLINT_TEST_MODULES"], str(HERE), str(HERE.parent)]

import counting  # noqa: E402  pylint: disable=wrong-import-position
import package  # noqa: E402  pylint: disable=wrong-import-position

ORBIT_SECONDS = 4.0
LONGEST_FIRST, LEAST_RATE = 8.0, 0.5  # seconds, pictures a second: asked are 0.2 and 15 on two idle processors


def install():
    zip_path = package.make(os.environ["GLINT_TEST_FOLDER"])
    sys.path.remove(str(HERE.parent))
    bpy.ops.preferences.addon_install(filepath=str(zip_path), overwrite=True)
    bpy.ops.preferences.addon_enable(module="io_glint")


class Drawn:
    """When the viewport was drawn with a picture."""

    def __init__(self):
        from io_glint.viewport import Viewport  # pylint: disable=import-outside-toplevel
        self.count, real = 0, Viewport.draw

        def draw(viewport, context, depsgraph):
            real(viewport, context, depsgraph)
            self.count += viewport.renderer.picture is not None

        Viewport.draw = draw


def area():
    return next(a for a in bpy.context.window_manager.windows[0].screen.areas if a.type == "VIEW_3D")


def space():
    return area().spaces[0]


def fill_window():
    """The 3D view without anything beside it."""
    found = area()
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[0], area=found, region=found.regions[-1]):
        bpy.ops.screen.screen_full_area(use_hide_panels=True)
    shown = space()
    for name in ("show_region_header", "show_region_tool_header", "show_region_toolbar", "show_region_hud", "show_gizmo"):
        setattr(shown, name, False)
    shown.overlay.show_overlays = False


def clear():
    scene = bpy.context.scene
    scene.render.engine, scene.glint.aa = "GLINT", 3
    scene.view_settings.view_transform = "Standard"  # Blender computes Filmic in 0.1 s if there is no graphics card
    for ob in list(scene.objects):
        if ob.type == "MESH":
            bpy.data.objects.remove(ob)
    view = space().region_3d
    view.view_perspective, view.view_distance, view.view_location = "PERSP", 22, (0, 0, 0)


def material(name, color):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    made.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (*color, 1)
    return made


def smooth(ob):
    ob.data.polygons.foreach_set("use_smooth", [True] * len(ob.data.polygons))
    return ob


def make_spheres_and_cylinders():
    """As many shapes as scenes/epfl/castle.json has: 75 spheres, 42 cylinders, 2 planes, 12 materials."""
    clear()
    materials = [material(f"m{i}", (0.3 + 0.05 * i, 0.5, 0.9 - 0.05 * i)) for i in range(12)]
    models = {}
    for kind in ("uv_sphere", "cylinder"):
        getattr(bpy.ops.mesh, f"primitive_{kind}_add")()
        models[kind] = smooth(bpy.context.object).data
        bpy.data.objects.remove(bpy.context.object)
    for i in range(117):
        data = models["uv_sphere" if i < 75 else "cylinder"].copy()
        data.materials.append(materials[i % 12])
        ob = bpy.data.objects.new(f"shape {i}", data)
        ob.location, ob.scale = (1.6 * (i % 11) - 8, 1.6 * (i // 11) - 8, 0.3 * (i % 5)), (0.6, 0.6, 0.8)
        bpy.context.scene.collection.objects.link(ob)
    for height in (-0.8, -1):
        bpy.ops.mesh.primitive_plane_add(size=40, location=(0, 0, height))


def make_torus():
    """100,000 smooth triangles."""
    clear()
    bpy.ops.mesh.primitive_torus_add(major_segments=250, minor_segments=200, major_radius=6, minor_radius=2.5)
    smooth(bpy.context.object)


def make_heads():
    """Seven of 15,744 smooth triangles, over a plane."""
    clear()
    bpy.ops.mesh.primitive_plane_add(size=40, location=(0, 0, -1.5))
    for i in range(7):
        bpy.ops.mesh.primitive_monkey_add(size=4, location=(5 * math.cos(0.9 * i), 5 * math.sin(0.9 * i), 0), rotation=(0, 0, 0.9 * i))
        ob = smooth(bpy.context.object)
        modifier = ob.modifiers.new("subdivision", "SUBSURF")
        modifier.levels = modifier.render_levels = 2


def first_picture(drawn):
    """Yields until the viewport shows a picture; returns the seconds. The last step is Blender's after it has swapped the window."""
    before, start = drawn.count, time.perf_counter()
    space().shading.type = "RENDERED"
    while drawn.count == before and time.perf_counter() - start < 20:
        yield
    yield
    return time.perf_counter() - start


def orbit(drawn):
    """Turns the view whenever Blender lets a timer; returns the pictures that were drawn in a second."""
    view, before, start = space().region_3d, drawn.count, time.perf_counter()
    while (seconds := time.perf_counter() - start) < ORBIT_SECONDS:
        view.view_rotation = Quaternion((0, 0, 1), 0.02) @ view.view_rotation
        yield
    return (drawn.count - before) / seconds


def measure():
    """A generator, which Blender's timer goes through; returns the Counts."""
    install()
    drawn = Drawn()
    fill_window()
    yield
    counts = counting.Counts(0, 0, 0)
    for make, what in ((make_spheres_and_cylinders, "119 shapes"), (make_torus, "torus, 100,000 triangles"),
                       (make_heads, "7 heads, 110,208 triangles")):
        space().shading.type = "SOLID"
        make()
        for _ in range(20):  # Blender evaluates and draws it
            yield
        seconds = yield from first_picture(drawn)
        region = next(r for r in area().regions if r.type == "WINDOW")
        rate = yield from orbit(drawn)
        is_good = seconds <= LONGEST_FIRST and rate >= LEAST_RATE
        print(f"viewport, {region.width} x {region.height}, {what}: first picture {seconds:.2f} s, orbit {rate:.1f} pictures/s"
              f"{'' if is_good else ': FAILED'}", flush=True)
        counts += counting.Counts(1, int(not is_good), 0)
    return counts


def make_step():
    steps = measure()

    def step():
        try:
            next(steps)
            return 0.0
        except StopIteration as end:
            counting.write(os.environ["GLINT_TEST_COUNTS"], end.value)
        except BaseException:  # whatever happens, Blender must not stay open
            traceback.print_exc()
        bpy.ops.wm.quit_blender()
        return None

    return step


bpy.context.preferences.view.show_splash = False
bpy.app.timers.register(make_step(), first_interval=1.0)

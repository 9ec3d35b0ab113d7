# SPDX-License-Identifier: Apache-2.0
"""Add > RT2 exercise: a scene to start from, with the names and properties that RT2's export goes by."""
import math

import bpy
from mathutils import Vector

from .course_scene import COURSE_COLLECTION
from .primitives import make_object

# name, kind, location, rotation in degrees, scale, RT2's material
OBJECTS = (
    ("Plane", "PLANE", (0, 0, 0), (0, 0, 0), (8, 8, 8), "grass"),
    ("Sphere", "SPHERE", (0, 0, 2.2), (0, 0, 0), (0.8, 0.8, 0.8), "white_shiny"),
    ("Sphere.001", "SPHERE", (1.9, -1.2, 0.6), (0, 0, 0), (0.6, 0.6, 0.6), "black"),
    ("Sphere.002", "SPHERE", (-1.7, -1.0, 0.5), (0, 0, 0), (0.5, 0.5, 0.5), "fuzzy"),
    ("Cylinder", "CYLINDER", (0, 0, 0.7), (0, 0, 0), (0.8, 0.8, 0.7), "fuzzy"),
    ("Cylinder.001", "CYLINDER", (-1.4, 1.4, 0.8), (25, -20, 0), (0.3, 0.3, 1), "white_shiny"),
)
LIGHTS = (("Light1", (4, -3, 5), 900, (1, 1, 1)), ("Light2", (-4, -3, 4), 350, (1, 0.85, 0.7)))
CAMERA, TARGET, ANGLE = (4.5, -6.5, 3.4), (0, 0, 1.1), 45


def make_scene():
    """A new scene "RT2 exercise" with the collection scene_custom."""
    scene = bpy.data.scenes.new("RT2 exercise")
    collection = bpy.data.collections.new(COURSE_COLLECTION)
    scene.collection.children.link(collection)
    for name, kind, location, rotation, scale, material in OBJECTS:
        ob = make_object(kind, name, collection)
        ob.location, ob.scale = location, scale
        ob.rotation_euler = [math.radians(a) for a in rotation]
        ob["material"] = material
    for name, location, watts, color in LIGHTS:
        data = bpy.data.lights.new(name, "POINT")
        data.energy, data.color, data.shadow_soft_size = watts, color, 0
        ob = bpy.data.objects.new(name, data)
        ob.location = location
        collection.objects.link(ob)
    data = bpy.data.cameras.new("Camera")
    data.lens_unit, data.angle = "FOV", math.radians(ANGLE)
    camera = bpy.data.objects.new("Camera", data)
    camera.location = CAMERA
    camera.rotation_euler = (Vector(TARGET) - Vector(CAMERA)).to_track_quat("-Z", "Y").to_euler()
    collection.objects.link(camera)
    scene.camera = camera
    scene.render.engine = "GLINT"
    scene.render.resolution_x = scene.render.resolution_y = 640
    scene.glint.picture = "RT2"
    return scene


class GLINT_OT_rt2_exercise(bpy.types.Operator):
    bl_idname = "glint.rt2_exercise"
    bl_label = "RT2 exercise"
    bl_description = "Make a new scene to start RT2's Blender exercise from"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        scene = context.window.scene = make_scene()
        # A new light is put into the active collection.
        layer = scene.view_layers[0]
        layer.active_layer_collection = layer.layer_collection.children[0]
        return {"FINISHED"}


def _menu(self, _context):
    self.layout.operator("glint.rt2_exercise", icon="SCENE_DATA")


classes = (GLINT_OT_rt2_exercise,)


def register():
    bpy.types.VIEW3D_MT_add.append(_menu)


def unregister():
    bpy.types.VIEW3D_MT_add.remove(_menu)

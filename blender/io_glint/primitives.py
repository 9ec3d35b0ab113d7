# SPDX-License-Identifier: Apache-2.0
"""Meshes for glint's shapes: radius 1, half height 1, along z; and Add > Mesh > glint, which makes objects of them."""
import bmesh
import bpy
from bpy.props import EnumProperty

from .properties import SHAPE_ITEMS

KINDS = tuple(item for item in SHAPE_ITEMS if item[0] not in ("AUTO", "MESH"))
SEGMENTS = 48


def make_mesh(kind, name):
    """A mesh of one of KINDS; balls and tubes are smooth, tubes are open."""
    made = bmesh.new()
    if kind == "SPHERE":
        bmesh.ops.create_uvsphere(made, u_segments=SEGMENTS, v_segments=SEGMENTS // 2, radius=1)
    elif kind in ("CYLINDER", "CONE"):
        bmesh.ops.create_cone(made, segments=SEGMENTS, radius1=1, radius2=0 if kind == "CONE" else 1, depth=2)
    elif kind == "DISC":
        bmesh.ops.create_circle(made, cap_ends=True, segments=SEGMENTS, radius=1)
    elif kind == "BOX":
        bmesh.ops.create_cube(made, size=2)
    else:
        bmesh.ops.create_grid(made, x_segments=1, y_segments=1, size=1)
    for face in made.faces:
        face.smooth = kind in ("SPHERE", "CYLINDER", "CONE")
    mesh = bpy.data.meshes.new(name)
    made.to_mesh(mesh)
    made.free()
    return mesh


def make_object(kind, name, collection):
    ob = bpy.data.objects.new(name, make_mesh(kind, name))
    collection.objects.link(ob)
    return ob


class MESH_OT_glint_shape_add(bpy.types.Operator):
    bl_idname = "mesh.glint_shape_add"
    bl_label = "Add glint shape"
    bl_description = "Add a mesh that is exported as one of glint's shapes, whatever is done to it"
    bl_options = {"REGISTER", "UNDO"}

    kind: EnumProperty(name="Shape", items=KINDS)

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT"

    def execute(self, context):
        ob = make_object(self.kind, self.kind.capitalize(), context.collection)
        ob.location = context.scene.cursor.location
        ob.glint_shape = self.kind
        for other in context.selected_objects:
            other.select_set(False)
        ob.select_set(True)
        context.view_layer.objects.active = ob
        return {"FINISHED"}


class VIEW3D_MT_glint_mesh_add(bpy.types.Menu):
    bl_label = "glint"

    def draw(self, _context):
        for kind, name, _ in KINDS:
            self.layout.operator("mesh.glint_shape_add", text=name).kind = kind


def _menu(self, _context):
    self.layout.menu("VIEW3D_MT_glint_mesh_add")


classes = (MESH_OT_glint_shape_add, VIEW3D_MT_glint_mesh_add)


def register():
    bpy.types.VIEW3D_MT_mesh_add.append(_menu)


def unregister():
    bpy.types.VIEW3D_MT_mesh_add.remove(_menu)

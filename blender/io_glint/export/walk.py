# SPDX-License-Identifier: Apache-2.0
"""Everything that a render shows, one after the other: a walk over depsgraph.object_instances."""
from dataclasses import dataclass

from . import ignored

GEOMETRY = ("MESH", "CURVE", "SURFACE", "FONT", "META")
UNSEEN = ("EMPTY", "CAMERA", "ARMATURE", "LATTICE", "SPEAKER", "LIGHT_PROBE")
DEFORMING = frozenset((
    "ARMATURE", "BUILD", "CAST", "CLOTH", "COLLISION", "CORRECTIVE_SMOOTH", "CURVE", "DISPLACE", "DYNAMIC_PAINT",
    "EXPLODE", "FLUID", "HOOK", "LAPLACIANDEFORM", "LAPLACIANSMOOTH", "LATTICE", "MESH_CACHE", "MESH_DEFORM",
    "MESH_SEQUENCE_CACHE", "NODES", "OCEAN", "SHRINKWRAP", "SIMPLE_DEFORM", "SMOOTH", "SOFT_BODY", "SURFACE_DEFORM",
    "VOLUME_DISPLACE", "WARP", "WAVE"))


@dataclass
class Item:
    """Valid only until the walk goes on: Blender reuses the object of an instance."""

    ob: object  # evaluated
    matrix: object  # a copy: world from object
    holder: object  # what instances it; None for an object that stands for itself

    @property
    def name(self):
        if self.holder is None or self.holder.name == self.ob.name:
            return self.ob.name
        return f"{self.holder.name}/{self.ob.name}"

    @property
    def described(self):
        return f"object '{self.name}'"


def _own_meshes(depsgraph):
    """Curves, texts, surfaces and metaballs that also come as an instance of type MESH whose parent they are."""
    return {inst.parent.original.as_pointer() for inst in depsgraph.object_instances
            if inst.is_instance and inst.object.type == "MESH" and inst.parent and inst.parent.type in GEOMETRY[1:]}


def deforms(ob):
    """Whether the object's form comes from shape keys or deforming modifiers, so that it may differ in other frames."""
    original = ob.original
    if getattr(original.data, "shape_keys", None):
        return True
    return any(m.type in DEFORMING and (m.show_render or m.show_viewport) for m in original.modifiers)


def is_in(selection):
    """What items() may want: an object whose original is one of these pointers, or what it instances; None: everything."""
    if selection is None:
        return lambda item: True
    return lambda item: (item.holder or item.ob).original.as_pointer() in selection


def items(depsgraph, report, wanted=lambda item: True):
    """Yields the Items of all lights and of all surfaces that the camera sees; reports what glint cannot show.

    wanted: whether an Item is asked for; the others are neither yielded nor reported."""
    have_mesh, seen = _own_meshes(depsgraph), set()
    for inst in depsgraph.object_instances:
        ob = inst.object
        if ob.type in UNSEEN or (ob.type in GEOMETRY[1:] and ob.original.as_pointer() in have_mesh):
            continue
        item = Item(ob, inst.matrix_world.copy(), inst.parent if inst.is_instance else None)
        if not wanted(item):
            continue
        _report_hair(ob, report)
        if not inst.show_self:
            continue
        if ob.original.as_pointer() not in seen:  # instances share its properties
            seen.add(ob.original.as_pointer())
            ignored.report(ob, f"object '{ob.name}'", report)
        if ob.type == "LIGHT":
            yield item
            continue
        if ob.type not in GEOMETRY:
            report.warn(item.described, f"left out: glint has nothing for objects of type {ob.type}")
            continue
        reason = _not_for_the_camera(ob, depsgraph)
        if reason:
            report.warn(item.described, f"left out: {reason}")
            continue
        yield item


def _not_for_the_camera(ob, depsgraph):
    original = ob.original
    if not getattr(ob, "visible_camera", True):
        return "it is invisible to the camera, and glint has no ray visibility"
    layer = depsgraph.view_layer
    if getattr(ob, "is_holdout", False) or _layer_says(original, "holdout_get", layer):
        return "it is a holdout"
    if getattr(ob, "is_shadow_catcher", False):
        return "it is a shadow catcher"
    if _layer_says(original, "indirect_only_get", layer):
        return "its collection is for indirect light only"
    return None


def _layer_says(ob, function, layer):
    try:
        return getattr(ob, function)(view_layer=layer)
    except (AttributeError, RuntimeError, TypeError):
        return False


def _report_hair(ob, report):
    for system in getattr(ob, "particle_systems", ()):
        if system.settings.type == "HAIR" and system.settings.render_type == "PATH":
            report.warn(f"object '{ob.name}'", f"its hair '{system.name}' is left out")

# SPDX-License-Identifier: Apache-2.0
"""A depsgraph as a scene of RT2 (docs/formats/epfl.md), as the course's export script writes it; measured where that
assumes, and reported where RT2 has no words."""
import json
import math

from . import camera, light, measure, mesh, rt2_material, shapes, walk, world
from .images import Images
from .material import MaterialTable
from .scene import override_of, report_no_lights, report_settings, shape_of, shape_setting
from .shape_text import compose
from .vectors import cross, unit

DIGITS = 6
FOV_DIGITS = 4  # Blender's angle, made from the lens, has no more
SUN_DISTANCE = 1e4
TARGET_DISTANCE = 10


def type_by_name(name):
    """The type that the course's naming rule gives: sphere, plane, cylinder, or None."""
    lower = name.lower()
    return next((word for word in ("sphere", "plane", "cylinder") if word in lower), None)


def _rounded(value):
    if isinstance(value, (tuple, list)):
        return [_rounded(v) for v in value]
    return round(float(value), DIGITS) + 0.0


def _point(rows, p):
    return tuple(r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3] for r in rows)


def _direction(rows, d):
    return tuple(r[0] * d[0] + r[1] * d[1] + r[2] * d[2] for r in rows)


def _columns(rows):
    return [tuple(r[i] for r in rows) for i in range(3)]


def is_similarity(rows):
    """Whether a 3x4 matrix only turns, mirrors, moves and scales evenly."""
    a, b, c = _columns(rows)
    size = math.hypot(*a)
    return size > 0 and all(abs(math.hypot(*v) - size) <= 1e-4 * size for v in (b, c)) and all(
        abs(sum(x * y for x, y in zip(u, v))) <= 1e-4 * size * size for u, v in ((a, b), (b, c), (a, c)))


def world_shape(shape, rows):
    """(list, entry) of RT2 for a shape under a 3x4 matrix; None where RT2 cannot say it."""
    if shape.word == "sphere" and is_similarity(rows):
        radius = shape.get("radius") * math.hypot(*_columns(rows)[0])
        return "spheres", {"center": _point(rows, shape.get("center")), "radius": radius}
    if shape.word == "plane":
        cofactors, det = mesh.cofactors(rows)
        n = [math.copysign(1, det) * sum(c * v for c, v in zip(r, shape.get("normal"))) for r in cofactors]
        length = math.hypot(*n)
        if not length:
            return None
        return "planes", {"center": _point(rows, shape.get("point")), "normal": tuple(v / length for v in n)}
    if shape.word == "cylinder":
        from_, to = _point(rows, shape.get("from")), _point(rows, shape.get("to"))
        axis = tuple(b - a for a, b in zip(from_, to))
        height = math.hypot(*axis)
        local = tuple(b - a for a, b in zip(shape.get("from"), shape.get("to")))
        radius = _radius_across(rows, local, axis, shape.get("radius"))
        if radius is None or not height:
            return None
        return "cylinders", {"center": tuple((a + b) / 2 for a, b in zip(from_, to)),
                             "axis": tuple(v / height for v in axis), "height": height, "radius": radius}
    return None


def _radius_across(rows, local_axis, axis, radius):
    """The radius of a circle across the axis after the map; None if it becomes an ellipse or leans."""
    least = min(range(3), key=lambda i: abs(local_axis[i]))
    helper = tuple(float(i == least) for i in range(3))
    u = unit(cross(local_axis, helper))
    v = unit(cross(local_axis, u))
    u, v = _direction(rows, u), _direction(rows, v)
    lu, lv, la = math.hypot(*u), math.hypot(*v), math.hypot(*axis)
    dots = (sum(a * b for a, b in zip(u, v)) / (lu * lv or 1), sum(a * b for a, b in zip(u, axis)) / (lu * la or 1),
            sum(a * b for a, b in zip(v, axis)) / (lv * la or 1))
    if abs(lu - lv) > 1e-4 * max(lu, lv) or any(abs(d) > 1e-4 for d in dots):
        return None
    return radius * (lu + lv) / 2


def by_course_rule(word, matrix):
    """What the course's script writes for an object of that type: it assumes Blender's primitives of radius 1."""
    location, rotation, scale = matrix.decompose()
    axis = tuple(rotation @ _vector_like(location, (0, 0, 1)))
    center = tuple(location)
    if word == "sphere":
        return "spheres", {"center": center, "radius": abs(scale[0])}
    if word == "plane":
        return "planes", {"center": center, "normal": axis}
    return "cylinders", {"center": center, "axis": axis, "height": abs(2 * scale[2]), "radius": abs(scale[0])}


def _vector_like(vector, values):
    made = vector.copy()
    made[:] = values
    return made


class RT2Scene:
    """Collects one RT2 scene. collection: what is exported; None: everything that the render shows.

    Raises camera.CameraError without a camera that glint could take."""

    object_indices, material_indices = (), ()  # Blender's pass indices: the passes have glint's own numbers

    def __init__(self, depsgraph, options, report, find_material, collection=None, images=None):
        self.depsgraph, self.options, self.report = depsgraph, options, report
        self.collection = collection
        self.order = {ob.as_pointer(): i for i, ob in enumerate(collection.all_objects)} if collection else None
        self.scene = depsgraph.scene_eval
        self.camera_object = self._camera()
        self.view = camera.read(self.camera_object, self.scene, report)
        self.target = tuple(p + TARGET_DISTANCE * f for p, f in zip(self.view.position, self.view.forward))
        self.images = images or Images()  # of which RT2 has the means
        table = MaterialTable(report, world.radiance(self.scene.world, report, self.images), find_material,
                              override=override_of(depsgraph), images=self.images)
        self.materials = rt2_material.Materials(table, report)
        self.meshes = mesh.MeshCache()
        self.found = {"lights": [], "spheres": [], "planes": [], "cylinders": []}

    def _camera(self):
        chosen = self.depsgraph.scene.camera
        if self.collection is not None:
            cameras = [ob for ob in self.collection.all_objects if ob.type == "CAMERA"]
            if cameras and chosen not in cameras:
                chosen = cameras[0]
        return chosen.evaluated_get(self.depsgraph) if chosen is not None else None

    def _place(self, item):
        """The item's place in the collection's order; None if it is not in it."""
        if self.order is None:
            return 0
        for ob in (item.ob, item.holder):
            if ob is not None and ob.original.as_pointer() in self.order:
                return self.order[ob.original.as_pointer()]
        return None

    def json(self):
        seen, is_selected = set(), walk.is_in(self.options.selection)
        for item in walk.items(self.depsgraph, self.report, lambda item: self._place(item) is not None and is_selected(item)):
            place = self._place(item)
            seen.update(ob.original.as_pointer() for ob in (item.ob, item.holder) if ob is not None)
            if not all(abs(v) <= mesh.MAX_COORDINATE for row in item.matrix for v in row):
                self.report.warn(item.described, "left out: its transform has numbers that glint does not take")
            elif item.ob.type == "LIGHT":
                self._add_light(item, place)
            else:
                self._add_object(item, place)
        self._report_hidden(seen)
        report_settings(self.scene, self.depsgraph.view_layer, self.report)
        if self.options.selection is not None and not self.found["lights"]:
            report_no_lights(self.scene, self.report)
        lists = {name: [entry for _, entry in sorted(entries, key=lambda e: e[0])]
                 for name, entries in self.found.items()}
        return {"name": (self.collection or self.depsgraph.scene).name, "camera": self._camera_entry(),
                "materials": self.materials.used(), **lists}

    def _report_hidden(self, seen):
        for ob in self.collection.all_objects if self.collection else ():
            if self.options.selection is not None and ob.as_pointer() not in self.options.selection:
                continue
            if ob.as_pointer() not in seen and ob.type in (*walk.GEOMETRY, "LIGHT"):
                self.report.warn(f"object '{ob.name}'", "left out: a render does not show it")

    def _camera_entry(self):
        view, item = self.view, f"camera '{self.view.name}'"
        fov = view.fov_x
        if not view.is_perspective:
            self.report.warn(item, "RT2 has no orthographic cameras: it is exported as a perspective one")
            fov = math.degrees(self.camera_object.data.angle)
        elif not view.is_centred:
            self.report.warn(item, "RT2 has no shifted pictures and no oblong pixels: these are ignored")
        return {"position": _rounded(view.position), "up": _rounded(view.up), "target": _rounded(self.target),
                "fov": round(fov, FOV_DIGITS)}

    def _add_light(self, item, place):
        data, described = item.ob.data, light.describe(item.ob)
        position, color = tuple(item.matrix.translation), tuple(data.color)
        if data.type == "SUN":
            to_light = unit(tuple(item.matrix.to_3x3().col[2]))
            position = tuple(t + SUN_DISTANCE * v for t, v in zip(self.target, to_light))
            self.report.warn(described, "RT2 has point lights only: the sun is exported as one far away")
        elif data.type != "POINT":
            self.report.warn(described, f"RT2 has point lights only: its {data.type.lower()} is exported as one")
        elif data.shadow_soft_size > 0:
            self.report.warn(described, "RT2's lights are points: its radius is ignored")
        if self.options.light_color == "classical":
            power = light.power(data, self.report, described, self.images)
            squared = 1.0 if data.type == "SUN" else max(math.dist(position, self.target) ** 2, 1e-12)
            color = tuple(c * self.options.light_scale / squared for c in light.classical(data.type, *power))
            self.report.warn(described, "RT2's lights do not fall off: its intensity is that at the camera's target")
        if not all(abs(c) <= light.MAX_PRODUCT for c in color):
            self.report.warn(described, "left out: its color has numbers that glint does not take")
            return
        self.found["lights"].append((place, {"position": _rounded(position), "color": _rounded(color)}))

    def _add_object(self, item, place):
        data = self.meshes.of(item.ob)
        holder_name = item.holder.name if item.holder is not None else item.ob.name
        word = type_by_name(holder_name) or type_by_name(item.ob.name)
        found = self._by_geometry(item, data) if data else None
        if not found and word and shape_setting(item.ob) in ("AUTO", word.upper()):
            found = self._by_name(item, data, word)
        if not found:
            if data:
                self.report.warn(item.described, "left out: RT2 has spheres, planes and cylinders only")
            return
        name, entry = found
        self.found[name].append((place, {**{k: _rounded(v) for k, v in entry.items()},
                                         "material": self.materials.name_for(item)}))

    def _by_geometry(self, item, data):
        rows = [tuple(row) for row in item.matrix][:3]
        if not data.is_finite or mesh.cofactors(rows)[1] == 0:
            return None
        setting = shape_setting(item.ob)
        found = shape_of(item.ob, data, self.report, item.described, any_shading=True)
        if found:
            shape, inner = found
            result = world_shape(shape, compose(rows, inner) if inner else rows)
            if result and result[0] == "cylinders" and shape.get("caps"):
                self.report.warn(item.described, "RT2's cylinders are open: its caps are left out")
            return result
        if setting == "AUTO":
            outline = data.outline()
            flat = measure.flat_extent(outline) if [len(face) for face in outline.faces] == [4] else None
            if flat:
                return world_shape(shapes.Shape("plane", (("point", flat[0]), ("normal", flat[1]))), rows)
        return None

    def _by_name(self, item, data, word):
        """The naming rule, for a mesh that is not quite the shape; its size is measured if it can be."""
        rows = [tuple(row) for row in item.matrix][:3]
        measured = measure.measure(word.upper(), data.outline()) if data and data.is_finite else None
        found = world_shape(measured, rows) if measured and mesh.cofactors(rows)[1] != 0 else None
        self.report.warn(item.described, f"its mesh is no {word}, as its name says; it is exported as one"
                         + ("" if found else " by the course's rule, which reads its scale alone"))
        return found or by_course_rule(word, item.matrix)


def rt2_text(scene):
    """The text of a .json scene: of an RT2Scene."""
    return json.dumps(scene.json(), indent=1, ensure_ascii=False) + "\n"

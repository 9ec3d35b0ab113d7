# SPDX-License-Identifier: Apache-2.0
"""A depsgraph as the text of a .glint scene."""
import gc

from . import camera, ignored, light, material, measure, mesh, mesh_file, mesh_text, phong, shape_text, shapes, text, walk, world
from .images import Images

MAX_REFLECTIONS = 12


def shape_setting(ob):
    """The object's glint_shape: AUTO or one of shapes.KINDS, from the panel's property or a plain text property."""
    value = ob.get("glint_shape")
    if not isinstance(value, str):
        value = getattr(ob, "glint_shape", "AUTO")
    value = value.upper()
    return value if value in shapes.KINDS else "AUTO"


def shape_of(ob, data, report, item, recognise=True, any_shading=False):
    """(Shape, its 3x4 matrix or None) or None: what the object is exported as, if not as triangles."""
    kind = shape_setting(ob)
    if kind == "MESH" or not data.is_finite or not len(data):
        return None
    if kind != "AUTO":
        measured = measure.measure(kind, data.outline())
        if measured is None:
            report.warn(item, f"its mesh has no extent as a {kind.lower()}; it is exported as triangles")
        return (measured, None) if measured else None
    if not recognise or len(data.used_slots()) > 1:
        return None
    return data.recognise(any_shading)


class Stopped(Exception):
    """The user stopped the export."""


class SceneText:
    """Writes one depsgraph. is_stopped: asked before each object. mesh_files: a MeshFiles; None: all meshes are in the text.
    images: an Images; None: images are their mean colors.
    view: a View in place of the scene's camera; meshes: a MeshCache that is kept; wanted: whether an Item is asked for, in place
    of options.selection.

    When parts() has returned, object_indices has, for each of the scene's shapes, (its number of shapes, Blender's pass_index),
    and material_indices the pass_index of each of the scene's materials."""

    def __init__(self, depsgraph, options, report, find_material, is_stopped=lambda: False, mesh_files=None,
                 view=None, meshes=None, wanted=None, images=None):
        self.is_stopped, self.object_indices, self.mesh_files = is_stopped, [], mesh_files
        self._wanted = wanted or walk.is_in(options.selection)
        self.depsgraph, self.options, self.report = depsgraph, options, report
        self.scene = depsgraph.scene_eval if hasattr(depsgraph, "scene_eval") else depsgraph.scene
        self.view = view or camera.read(_evaluated(depsgraph.scene.camera, depsgraph), self.scene, report)
        self.images = images or Images()
        self.background = world.radiance(self.scene.world, report, self.images)
        # The world lights surfaces by k_a, or by the block occlusion.
        ambient = phong.BLACK if options.occlusion else self.background
        self.table = material.MaterialTable(report, ambient, find_material, options.shading, override_of(depsgraph), self.images)
        self._meshes, self._lights, self._chunks = meshes or mesh.MeshCache(), [], []

    def parts(self):
        """(all but the shapes, the shapes): two texts that make the scene's."""
        for item in walk.items(self.depsgraph, self.report, self._wanted):
            if self.is_stopped():
                raise Stopped
            if item.ob.type == "LIGHT":
                block = light.light_text(item.ob, item.matrix, self.options.light_scale, self.options.light_samples,
                                         self.report, self.images)
                if block:
                    self._lights.append(block)
            else:
                self._add_object(item)
        report_settings(self.scene, self.depsgraph.view_layer, self.report)
        if self.options.selection is not None and not self._lights:
            report_no_lights(self.scene, self.report)
        sky = list(self._sky())
        if self.table.has_ambient:
            self._lights.insert(0, light.ambient_block(self.table.ambient_light))
        head = [*self._head(), *sky, *self._lights, "", *self.table.blocks(), ""]
        return "\n".join(head) + "\n", "\n".join(self._chunks) + "\n"

    def _head(self):
        options, (width, height) = self.options, self.view.size
        yield text.comment(f"{self.scene.name}, frame {self.scene.frame_current}: exported from Blender")
        for warning in self.report.warnings:
            yield text.comment(warning)
        transparency = "  transparency = blend" if self.table.has_transparent_texture else ""
        yield (f"conventions {{ facing = {options.facing}  fresnel = {options.fresnel}  "
               f"glass_shadow = {options.glass_shadow}  clamp_attenuation = false{transparency} }}")
        aa = options.samples if options.samples.isdigit() else text.string(options.samples)
        alpha = "  alpha = true" if self.scene.render.film_transparent else ""
        yield (f"render {{ size = {width} x {height}  shading = {options.shading}  "
               f"reflections = {self._reflections()}  aa = {aa}{alpha} }}")
        yield f"background = {text.vector(self.background)}"
        yield camera.camera_block(self.view)

    def _sky(self):
        if self.scene.world is not None:
            yield from world.fog_blocks(self.scene.world, self.background, self.options.mist, self.report)
        if self.options.occlusion and any(self.background):
            yield world.occlusion_block(self.background)

    def _reflections(self):
        if self.options.reflections >= 0:
            return self.options.reflections
        cycles = getattr(self.scene, "cycles", None)
        least = int(self.table.has_transparent_texture)  # with 0, glint shows nothing behind them
        return max(least, min(MAX_REFLECTIONS, getattr(cycles, "max_bounces", MAX_REFLECTIONS)))

    def _add_object(self, item):
        data = self._meshes.of(item.ob)
        if data is None:
            return
        rows = [tuple(row) for row in item.matrix][:3]
        if not all(abs(v) <= mesh.MAX_COORDINATE for row in rows for v in row):
            self.report.warn(item.described, "left out: its transform has numbers that glint does not take")
            return
        if self._is_clipped(data, rows):
            self.report.warn(item.described, "a part that the camera's clipping cuts off in Blender is visible in glint")
        names = material.slot_names(self.table, item.ob, item.holder, item.described)
        looks = {slot: look for slot in data.used_slots() if (look := self.table.look_of(material.name_of(names, slot)))}
        if looks and shape_setting(item.ob) in ("AUTO", "MESH"):
            self._add_mesh(item, data, rows, names, self._layers(item, looks))
            return
        if looks:
            names = material.slot_names(self.table, item.ob, item.holder, item.described, is_plain=True)
        recognise = self.options.recognise and not walk.deforms(item.ob)
        has_inverse = mesh.cofactors(rows)[1] != 0
        found = shape_of(item.ob, data, self.report, item.described, recognise) if has_inverse else None
        if found:
            shape, inner = found
            name = material.name_of(names, data.slots[0])
            full = shape_text.compose(rows, inner) if inner else rows
            self._add_shapes(item, shape_text.shape_block(shape, item.name, text.string(name), full), 1)
            return
        self._add_mesh(item, data, rows, names, {})

    def _layers(self, item, looks):
        """slot -> Layers"""
        found = {slot: self._meshes.layers_of(item.ob, look) for slot, look in looks.items()}
        for layers in found.values():
            if layers.fault:
                self.report.warn(item.described, layers.fault)
        return found

    def _is_clipped(self, data, rows):
        if not data.is_finite:
            return False
        near, far = self.view.clip
        depths = [self.view.depth(p) for p in mesh.transformed(rows, data.corners_of_bounds())]
        if near <= min(depths) and max(depths) <= far:
            return False
        if mesh_file.np is not None:
            return bool(mesh_file.np.any(self.view.clips(mesh_file.points(data, rows))))
        return any(map(self.view.clips, mesh.transformed(rows, data.vertices)))

    def _add_mesh(self, item, data, rows, names, layers):
        corners = mesh.polygon_vertices(data, rows) if not layers else None
        if corners:
            name = material.name_of(names, data.slots[0])
            entries = [("vertices", f"({', '.join(corners)})"), ("material", text.string(name))]
            self._add_shapes(item, text.block("polygon", item.name, entries), 1)
            return
        files = self.mesh_files.blocks_of(data, rows, layers) if self.mesh_files is not None else None
        if files is not None:
            for slot, file in files:
                entries = [("file", text.string(file)), ("material", text.string(material.name_of(names, slot))),
                           ("matrix", text.matrix(rows))]
                self._add_shapes(item, text.block("mesh", item.name, entries), 1)
            return
        blocks, dropped = [], 0
        if layers:
            named = {slot: (material.name_of(names, slot), one) for slot, one in layers.items()}
            blocks, dropped = mesh_text.mesh_blocks(data, rows, named, item.name)
            for block in blocks:
                self._add_shapes(item, block, 1)
        lines, more = mesh.triangle_lines(data, rows, frozenset(layers)) if len(layers) < len(data.used_slots()) else ({}, 0)
        dropped += more
        if dropped:
            self.report.warn(item.described, f"{dropped} triangles are left out: their coordinates are not finite or "
                                             "beyond 1e12")
        by_name = {}
        for slot, some in sorted(lines.items()):
            by_name.setdefault(material.name_of(names, slot), []).extend(some)
        for name, some in by_name.items():
            head = f"group {text.string(item.name)} {{ material = {text.string(name)}\n"
            self._add_shapes(item, head + "\n".join(some) + "\n}", len(some))

    def _add_shapes(self, item, chunk, count):
        self._chunks.append(chunk)
        self.object_indices.append((count, item.ob.pass_index))

    @property
    def material_indices(self):
        return self.table.pass_indices()


def _evaluated(ob, depsgraph):
    return ob.evaluated_get(depsgraph) if ob is not None else None


def override_of(depsgraph):
    """The material that replaces all others in the view layer, evaluated; None without one."""
    return _evaluated(depsgraph.view_layer.material_override, depsgraph)


def report_settings(scene, view_layer, report):
    """Reports what has no effect of the scene's settings and the view layer."""
    ignored.report(scene, f"scene '{scene.name}'", report)
    ignored.report(view_layer, f"view layer '{view_layer.name}'", report)


def report_color_management(scene, report):
    """Reports what Blender does to F12's picture, but nobody to that of a text."""
    for struct in (scene.view_settings, scene.display_settings):
        ignored.report(struct, f"scene '{scene.name}'", report)


def report_no_lights(scene, report):
    report.warn(f"scene '{scene.name}'", "no light is selected, so none is exported")


def write(scene_text):
    """The text of a SceneText."""
    return "".join(write_parts(scene_text))


def write_parts(scene_text):
    """SceneText.parts(), faster."""
    collecting = gc.isenabled()
    gc.disable()  # millions of tuples without cycles: collections would take as long as the export
    try:
        return scene_text.parts()
    finally:
        if collecting:
            gc.enable()


def glint_text(depsgraph, options, report, find_material, mesh_files=None, images=None):
    """The scene's text. Raises camera.CameraError without a camera that glint could take."""
    return write(SceneText(depsgraph, options, report, find_material, mesh_files=mesh_files, images=images))

# SPDX-License-Identifier: Apache-2.0
"""Blender's materials as glint's keys. What decides: properties glint_..., RT2's property `material`, the nodes."""
from . import course, ignored, keys, nodes, phong
from .text import UniqueNames, block, number, vector

NO_MATERIAL = "no material"


def describe(material):
    return f"material '{material.name}'"


def phong_of(material, report):
    """A Blender material by its surface node; without nodes, by its viewport settings."""
    ignored.report(material, describe(material), report)
    viewport = phong.principled(tuple(material.diffuse_color)[:3], material.metallic, material.roughness,
                                material.specular_intensity)
    if not material.use_nodes or material.node_tree is None:
        return viewport
    node, reader = nodes.surface_node(material.node_tree, report, describe(material))
    if node is None:
        report.warn(describe(material), "no shader is linked to its surface; it is black")
        return phong.Phong(color=phong.BLACK)
    found = reader.material(node)
    if found is None:
        report.warn(describe(material), f"its shader ({node.bl_label}) cannot be exported; its viewport color is used")
        return viewport
    return found


class MaterialTable:
    """The materials of one export, each under a name of its own, in the order of first use."""

    def __init__(self, report, world, find_material, shading="blinn-phong", override=None):
        """world: its radiance, three floats. find_material: name -> Blender material or None. override: the view layer's
        Blender material that replaces all others; None: there is none."""
        self.report, self.world, self.find_material = report, world, find_material
        self.shading, self.override = shading, override
        self._names, self._keys, self._pass_indices = UniqueNames(), {}, {}

    def of_slot(self, material):
        """The name under which a Blender material (None: no material) is exported."""
        if material is None:
            return self._add((NO_MATERIAL, None), NO_MATERIAL,
                             lambda: keys.of_phong(phong.diffuse((0.8,) * 3), self.world))
        library = material.original.library
        key = (material.name, library.filepath if library else None)
        return self._add(key, material.name, lambda: self._of_blender(material), material.pass_index)

    def of_property(self, name, item):
        """RT2's property `material`: a name of the course's list, or of a Blender material. None if it is neither."""
        if name in course.MATERIALS:
            return self.of_course(name)
        found = self.find_material(name)
        if found is not None:
            return self.of_slot(found)
        self.report.warn(item, f"its property `material` names '{name}', which is neither in RT2's list nor a material")
        return None

    def of_course(self, name):
        """A material of RT2's list."""
        return self._add(("course", name), name, lambda: keys.of_course(course.MATERIALS[name]))

    def _of_blender(self, material):
        made = keys.of_phong(phong_of(material, self.report), self.world)
        if self.shading == "phong":  # R.V falls off four times as fast as N.H
            made["shininess"] = made["shininess"] / 4
        made = keys.bounded(made, self.report, describe(material))
        return keys.replaced(made, material, self.report, describe(material))

    def _add(self, key, wanted, make, pass_index=0):
        name = self._names.name(key, wanted)
        if name not in self._keys:
            self._keys[name] = make()
            self._pass_indices[name] = pass_index
        return name

    def pass_indices(self):
        """Blender's pass_index of each material, in the order of blocks()."""
        return [self._pass_indices[name] for name in self._keys]

    def keys_of(self, name):
        return self._keys[name]

    @property
    def has_ambient(self):
        return any(keys.has_ambient(k) for k in self._keys.values())

    def blocks(self):
        for name, values in self._keys.items():
            yield block("material", name, [(key, vector(v) if isinstance(v, tuple) else number(v))
                                           for key, v in values.items()])


def slot_names(table, ob, property_holder, item):
    """The exported material of each of an object's slots; one entry for an object without slots.

    property_holder: the object whose property `material` counts: the object itself, or what instances it."""
    slots = [table.override] if table.override else [slot.material for slot in ob.material_slots]
    if any(slots):
        return [table.of_slot(m) for m in slots]
    for holder in (ob, property_holder):
        wanted = holder.get("material") if holder is not None else None
        if isinstance(wanted, str) and wanted:
            name = table.of_property(wanted, item)
            if name is not None:
                return [name]
    return [table.of_slot(None)]


def name_of(names, slot):
    """The material of a face, of those of slot_names(); faces of slots that are not there have the last one, as in Blender."""
    return names[min(max(slot, 0), len(names) - 1)]

# SPDX-License-Identifier: Apache-2.0
"""Blender's materials as glint's keys. What decides: properties glint_..., RT2's property `material`, the nodes."""
from . import course, ignored, keys, nodes, phong
from .images import Images
from .text import UniqueNames, block, number, string, vector
from .texture import Look, texture_block

NO_MATERIAL = "no material"


def describe(material):
    return f"material '{material.name}'"


def phong_of(material, report, images, draws_patterns=False):
    """A Blender material by its surface node; without nodes, by its viewport settings. draws_patterns: whether its color may differ
    from place to place."""
    ignored.report(material, describe(material), report)
    viewport = phong.principled(tuple(material.diffuse_color)[:3], material.metallic, material.roughness,
                                material.specular_intensity)
    if not material.use_nodes or material.node_tree is None:
        return viewport
    node, reader = nodes.surface_node(material.node_tree, report, describe(material), images, draws_patterns)
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

    def __init__(self, report, world, find_material, shading="blinn-phong", override=None, images=None):
        """world: its radiance, three floats. find_material: name -> Blender material or None. override: the view layer's
        Blender material that replaces all others; None: there is none. images: an Images; without a folder
        for textures, the colors of all materials are the same everywhere."""
        self.report, self.world, self.find_material = report, world, find_material
        self.shading, self.override = shading, override
        self.images, self._draws_patterns = images or Images(), images is not None and images.folder is not None
        self._names, self._keys, self._pass_indices = UniqueNames(), {}, {}
        self._looks, self._textures, self._texture_names = {}, {}, UniqueNames()
        self.ambient_light = phong.WHITE  # that of the scene, after all materials are known

    def of_slot(self, material, is_plain=False):
        """The name under which a Blender material (None: no material) is exported. is_plain: for a shape that has no UV map and no
        colors of its own."""
        if material is None:
            return self._add((NO_MATERIAL, None), NO_MATERIAL,
                             lambda: keys.of_phong(phong.diffuse((0.8,) * 3), self.world))
        library = material.original.library
        key = (material.name, library.filepath if library else None)
        name = self._add(key, material.name, lambda: self._of_blender(key, material, self._draws_patterns), material.pass_index)
        if not is_plain or name not in self._looks:
            return name
        return self._add((*key, "plain"), material.name, lambda: self._of_blender((*key, "plain"), material, False),
                         material.pass_index)

    def look_of(self, name):
        """The texture.Look of the triangles of a material; None if its color is the same everywhere."""
        return self._looks.get(name)

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

    def _of_blender(self, key, material, draws_patterns):
        found = phong_of(material, self.report, self.images, draws_patterns)
        made = keys.of_phong(found, self.world)
        texture = self._draw_pattern(key, material, found, made) if found.pattern is not None else None
        if self.shading == "phong":  # R.V falls off four times as fast as N.H
            made["shininess"] = made["shininess"] / 4
        made = keys.bounded(made, self.report, describe(material))
        made = keys.replaced(made, material, self.report, describe(material))
        return made if texture is None else {**made, "texture": texture}

    def _draw_pattern(self, key, material, found, made):
        """Notes what a material's triangles need; the name of its texture, or None."""
        pattern = found.pattern
        use, has_layer = pattern.image, pattern.layer is not None
        self._looks[self._names.name(key, material.name)] = Look(use.uv if use else None, pattern.layer, pattern.tint if has_layer else phong.WHITE)
        if has_layer and made.get("ambient") and max(self.world) - min(self.world) > 1e-3 * max(self.world):
            if found.glows:  # glint's k_e has not the colors of meshes
                self.report.warn(describe(material), "beside other meshes with colors, its light has the tint of the world's")
            else:
                self.ambient_light = tuple(c / max(self.world) for c in self.world)
        if use is None:
            return None
        file, encoding, factor = self.images.file(use.image, use.variant)
        if factor != 1:  # texels are at most 1
            for name in ("ambient_color", "diffuse_color", "ambient", "diffuse"):
                if name in made:
                    made[name] = tuple(v * factor for v in made[name]) if isinstance(made[name], tuple) else made[name] * factor
        cutoff = material.alpha_threshold if getattr(material, "blend_method", "") == "CLIP" else None
        entries = (use, file, encoding, cutoff if use.alpha else None)
        name = self._texture_names.name(entries, use.image.name)
        self._textures[name] = entries
        return name

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

    @property
    def has_transparent_texture(self):
        return any(use.alpha for use, *_ in self._textures.values())

    def blocks(self):
        for name, entries in self._textures.items():
            yield texture_block(name, *entries)
        for name, values in self._keys.items():
            look = self._looks.get(name)
            if self.ambient_light != phong.WHITE and (look is None or look.layer is None):
                values = keys.under_light(values, self.ambient_light)
            yield block("material", name, [(key, _value(v)) for key, v in values.items()])


def _value(v):
    if isinstance(v, str):
        return string(v)
    return vector(v) if isinstance(v, tuple) else number(v)


def slot_names(table, ob, property_holder, item, is_plain=False):
    """The exported material of each of an object's slots; one entry for an object without slots.

    property_holder: the object whose property `material` counts: the object itself, or what instances it. is_plain: as for
    MaterialTable.of_slot()."""
    slots = [table.override] if table.override else [slot.material for slot in ob.material_slots]
    if any(slots):
        return [table.of_slot(m, is_plain) for m in slots]
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

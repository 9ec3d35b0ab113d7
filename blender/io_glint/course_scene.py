# SPDX-License-Identifier: Apache-2.0
"""The collection that RT2's export is of, and what in the scene breaks the rules of the course's script."""
import re

from .export.light import describe

COURSE_COLLECTION = "scene_custom"


def collection_of(scene, wanted=""):
    """The collection that an RT2 export is of; None: everything. Raises ValueError for an unknown name."""
    known = {c.name: c for c in scene.collection.children_recursive}
    if wanted:
        if wanted not in known:
            raise ValueError(f"the scene has no collection '{wanted}'")
        return known[wanted]
    # Blender names the one of a second exercise scene scene_custom.001.
    copies = sorted(name for name in known if re.fullmatch(COURSE_COLLECTION + r"\.\d+", name))
    return known.get(COURSE_COLLECTION) or (known[copies[0]] if copies else None)


def messages(scene, collection, selection=None):
    """(item, text) of each thing that the course's script or page would take otherwise. selection: as in Options."""
    if collection is None:
        return []
    found = []
    if collection.name != COURSE_COLLECTION:
        found.append((f"collection '{collection.name}'", f"the course's script exports '{COURSE_COLLECTION}' alone"))
    inside = set(collection.all_objects)
    for ob in scene.objects:
        if ob.type not in ("LIGHT", "MESH", "CURVE", "SURFACE", "META", "FONT") or ob.hide_render:
            continue
        if selection is not None and ob.as_pointer() not in selection:
            continue
        item = describe(ob) if ob.type == "LIGHT" else f"object '{ob.name}'"
        if ob not in inside:
            found.append((item, f"left out: it is not in the collection '{collection.name}' (M moves it there)"))
        elif ob.type == "LIGHT" and "light" not in ob.name.lower():
            found.append((item, 'the course\'s script leaves it out: its name has no "light"'))
    return found

# SPDX-License-Identifier: Apache-2.0
"""Nothing in silence: the properties that have no effect in glint are reported where they are not at their defaults."""
from .ignored_nodes import NODE_TABLES
from .ignored_scene import SCENE_TABLES
from .ignored_table import TABLES

ALL_TABLES = {**TABLES, **SCENE_TABLES, **NODE_TABLES}


def tables_of(bl_rna):
    """The Tables of a struct and of those that it is derived from."""
    while bl_rna is not None:
        if bl_rna.identifier in ALL_TABLES:
            yield ALL_TABLES[bl_rna.identifier]
        bl_rna = bl_rna.base


def nested(struct):
    """The structs within a struct that are looked at too."""
    for table in tables_of(struct.bl_rna):
        for name in table.nested.split():
            inner = getattr(struct, name, None)  # Cycles may be disabled
            if inner is not None:
                yield inner


def is_default(struct, name, table):
    """Whether a property of a struct, one of the Table's, has the value that Blender gives it at first."""
    value, prop = getattr(struct, name), struct.bl_rna.properties[name]
    if name in table.initially_on.split():
        return value
    if name in table.initially:
        return value == table.initially[name]
    if prop.type == "POINTER":
        return value is None
    if prop.type == "COLLECTION":
        return not len(value)
    if getattr(prop, "is_array", False):
        return tuple(value) == tuple(prop.default_array)
    return value == prop.default


def report(struct, item, to):
    """Warns in the Report `to` of all that is set in a struct, called item there, and has no effect in glint."""
    properties = struct.bl_rna.properties
    for table in tables_of(struct.bl_rna):
        for text, names in table.warned.items():
            for name in names.split():
                if name in properties and not is_default(struct, name, table):
                    to.warn(item, text.format(label=properties[name].name))
    for inner in nested(struct):
        report(inner, item, to)

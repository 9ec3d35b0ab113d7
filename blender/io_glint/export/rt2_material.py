# SPDX-License-Identifier: Apache-2.0
"""RT2's materials: those of the course's list where they are named, others from Blender's materials."""
from . import course


def of_keys(name, keys, report, item):
    """An RT2 material, a color and coefficients, of .glint keys. What that loses is reported."""
    color = tuple(keys.get("color", (0.8, 0.8, 0.8)))
    top = max(color) or 1.0
    out = {"name": name, "color": [round(c, 6) for c in color]}
    hues = []
    for key in ("ambient", "diffuse", "specular"):
        absolute = keys.get(key + "_color")
        if absolute is None:
            out[key] = keys.get(key, 0.0)
            continue
        out[key] = round(max(absolute) / top, 6)
        if any(abs(a - out[key] * c) > 0.02 for a, c in zip(absolute, color)):
            hues.append(key)
    if hues:
        report.warn(item, f"RT2 has one color a material: its {' and '.join(hues)} color is that of the surface")
    out["specular"] = min(out["specular"], 1.0)
    out["shininess"] = round(keys.get("shininess", 1.0), 6)
    out["mirror"] = round(keys.get("mirror", 0.0), 6)
    if keys.get("transmission"):
        report.warn(item, "RT2 has no glass: it is exported as opaque")
    return out


class Materials:
    """The materials of one scene: written once, only those that are used; the course's first, in the course's order."""

    def __init__(self, table, report):
        self.table, self.report, self._used = table, report, {}

    def name_for(self, item):
        """The material of a walk's Item: the view layer's override, else its property `material`, else its first slot, else
        `default`."""
        override = self.table.override
        for ob in (item.holder, item.ob) if override is None else ():
            wanted = ob.get("material") if ob is not None else None
            if isinstance(wanted, str) and wanted:
                name = self.table.of_property(wanted, item.described)
                if name is not None:
                    return self._use(name, wanted)
        slot = override or next((s.material for s in item.ob.material_slots if s.material), None)
        if slot is not None:
            return self._use(self.table.of_slot(slot), slot.name)
        return self._use(self.table.of_course("default"), "default")

    def _use(self, name, wanted):
        if name not in self._used:
            self._used[name] = of_keys(name, self.table.keys_of(name), self.report, f"material '{wanted}'")
        return name

    def used(self):
        order = list(course.MATERIALS)
        rank = {name: order.index(name) if name in order else len(order) for name in self._used}
        return [self._used[name] for name in sorted(self._used, key=rank.get)]

# SPDX-License-Identifier: Apache-2.0
"""glint's material keys as entries of a .glint file, and the properties glint_... that replace them."""
from dataclasses import replace

from . import phong

PREFIX = "glint_"
MAX_CHANNEL = 1e6
COLORS = ("color", "ambient_color", "diffuse_color", "specular_color", "mirror_color", "transmission_color", "emission_color")
NUMBERS = {  # least, greatest, default
    "ambient": (0.0, 1e6, 0.1),
    "diffuse": (0.0, 1e6, 0.8),
    "specular": (0.0, 1.0, 0.3),
    "shininess": (0.0, 1e9, 32.0),
    "mirror": (0.0, 1.0, 0.2),
    "transmission": (0.0, 1.0, 0.5),
    "ior": (1e-3, 1e3, 1.5),
}
NAMES = ("color", "ambient", "diffuse", "specular", "shininess", "mirror", "transmission", "ior",
         "ambient_color", "diffuse_color", "specular_color", "mirror_color", "transmission_color")
_ORDER = (*NAMES, "emission_color")  # the last is none of the panel's


def of_phong(material, world):
    """The keys of a Phong material under a world of that radiance: a dictionary in the order of NAMES."""
    own = material
    if material.pattern is not None and not material.glows:  # a texture multiplies k_a, not k_e
        own = replace(material, emission=phong.BLACK)
    keys = {
        "color": material.color,
        "ambient_color": phong.ambient(own, world),
        "diffuse_color": material.diffuse,
        "specular_color": material.specular,
        "shininess": material.shininess,
    }
    if any(material.emission) and own is not material:
        keys["emission_color"] = material.emission
    if material.pattern is not None and material.pattern.layer is not None:
        _make_multiples(keys, material.pattern.tint)
    if material.mirror:
        keys["mirror"], keys["mirror_color"] = material.mirror, material.mirror_color
    if material.transmission:
        keys["transmission"], keys["ior"] = material.transmission, material.ior
        keys["transmission_color"] = material.transmission_color
    return keys


def _make_multiples(keys, tint):
    """The colors of a mesh replace the material's: what they shall color must be multiples of it. The tint is in them. That of the
    world's light must be in the ambient light: under_light()."""
    keys["color"] = phong.WHITE
    for name in ("ambient", "diffuse"):
        keys[name] = max((k / t for k, t in zip(keys.pop(name + "_color"), tint) if t > 0), default=0.0)


def under_light(keys, light):
    """The same appearance under an ambient light of another color than white, for keys whose color is not that of a mesh's corners.

    Where a texture multiplies k_a, k_a is divided by the light; else the light that k_a gives is emitted."""
    out = dict(keys)
    factor = out.pop("ambient", 0.1)
    ambient = out.pop("ambient_color", tuple(factor * c for c in out.get("color", (0.8, 0.8, 0.8))))
    if "texture" in out:
        return {**out, "ambient_color": tuple(a / i if i > 0 else 0.0 for a, i in zip(ambient, light))}
    emission = out.pop("emission_color", phong.BLACK)
    return {**out, "ambient_color": phong.BLACK, "emission_color": tuple(a + e for a, e in zip(ambient, emission))}


def of_course(material):
    """The keys of a material of RT2's list: coefficients of its color."""
    return {key: value for key, value in material.items() if key != "name"}


def bounded(keys, report, item):
    """keys with every number within what glint takes; what had to be changed is reported."""
    out = {name: _bounded_color(name, value) if name in COLORS else _bounded(value, *NUMBERS[name][:2])
           for name, value in keys.items()}
    for name, value in keys.items():
        if out[name] != value:
            report.warn(item, f"its {name.replace('_', ' ')} is beyond what glint takes; it is cut off")
    return out


def bounded_color(color, report, item):
    """A color within what glint takes."""
    return bounded({"color": color}, report, item)["color"]


def _bounded(value, least, greatest):
    return min(max(value, least), greatest) if value == value else least  # NaN is unlike itself


def _bounded_color(name, color):
    least = 0.0 if name.startswith(("mirror", "transmission")) else -MAX_CHANNEL
    return tuple(_bounded(c, least, MAX_CHANNEL) if c == c else 0.0 for c in color)


def replaced(keys, properties, report, item):
    """keys, with the values that properties (glint_color, ...) give. Values that glint refuses are reported and left out."""
    given = {}
    for name in NAMES:
        value = properties.get(PREFIX + name)
        if value is not None:
            value = _checked(name, value)
            if value is None:
                report.warn(item, f"the property {PREFIX}{name} has a value that glint does not take; it is ignored")
            else:
                given[name] = value
    out = dict(keys)
    for name in ("ambient", "diffuse", "specular"):
        if name in given:
            out.pop(name + "_color", None)
        if name + "_color" in given:
            out.pop(name, None)
    out.update(given)
    return {name: out[name] for name in _ORDER if name in out}


def _checked(name, value):
    try:
        if name in COLORS:
            color = tuple(float(v) for v in value)[:3]
            return color if len(color) == 3 and color == _bounded_color(name, color) else None
        least, greatest, _ = NUMBERS[name]
        return float(value) if least <= float(value) <= greatest else None
    except (TypeError, ValueError):
        return None


def has_ambient(keys):
    """Whether k_a is not 0: then the scene needs its ambient light."""
    return any(keys.get("ambient_color", ())) or bool(keys.get("ambient"))

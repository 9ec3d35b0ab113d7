# SPDX-License-Identifier: Apache-2.0
"""The materials that RT2's export script defines, by name. `default` is used where an object names none."""


def _material(name, color, ambient, diffuse, specular, shininess, mirror):
    return {"name": name, "color": color, "ambient": ambient, "diffuse": diffuse, "specular": specular,
            "shininess": shininess, "mirror": mirror}


MATERIALS = {
    m["name"]: m
    for m in (
        _material("default", (0.6, 0.6, 0.6), 0.2, 0.8, 0.4, 2.0, 0.02),
        _material("grass", (0.1, 0.7, 0.01), 0.2, 0.9, 0.3, 2.0, 0.02),
        _material("fuzzy", (0.3, 0.4, 0.6), 0.2, 0.9, 0.1, 2.0, 0.02),
        _material("white_shiny", (0.9, 0.9, 0.9), 0.2, 0.9, 0.8, 8.0, 0.3),
        _material("black", (0.1, 0.1, 0.1), 0.1, 0.5, 0.8, 1.0, 0.5),
        _material("mirror", (0.9, 0.9, 0.9), 0.0, 0.0, 1.0, 8.0, 0.9),
    )
}

# SPDX-License-Identifier: Apache-2.0
"""Tachyon's patterns of colors: TexFunc 1 to 4. Grit and marble have another grain in glint: their averages are in
tests/formats/tachyon_textures_test.cpp."""
from dat import CAMERA, COLORED, LIGHTS
from lights import Rule


def texture(function, center="0 0 0", color="0.8 0.4 0.2", ambient=0.2, diffuse=0.7, specular=0, opacity=1, phong="Plastic 0.3",
            rest="Rotate 0 0 0 Scale 1 1 1"):
    return (f"Texture Ambient {ambient} Diffuse {diffuse} Specular {specular} Opacity {opacity} Phong {phong} Phong_size 15 "
            f"Color {color} TexFunc {function} Center {center} {rest}\n")


def rule(name, objects, mode="", projection="", zoom=1.5, camera="", share=0.999):
    camera = camera or CAMERA.format(projection=projection and f"Projection {projection} ", zoom=zoom, aspect=1, depth=6, frustum="")
    return Rule("dat_" + name, "tachyon",
                f"Begin_Scene\nResolution 160 120\n{mode}\n{camera}Background 0.1 0.2 0.4\n{LIGHTS}{objects}End_Scene\n", "", share=share)


def objects(function, **changes):
    """On each kind of shape, around places with negative coordinates, too."""
    return ("Plane Center 0 -0.1 0 Normal 0 1 0 " + texture(function, **changes) +
            "Sphere Center -1.2 0.8 0 Rad 0.8 " + texture(function, center="0.1 0.2 0.05", **changes) +
            "Box Min 0.6 0.15 -1.2 Max 1.6 1.15 -0.2 " + texture(function, center="0.3 0.2 0.1", **changes) +
            "FCylinder Base -1 0.2 -2 Apex 0.4 0.5 -2.5 Rad 0.2 " + texture(function, center="-7 20 3.03", **changes) +
            "Tri V0 -0.3 0.2 1 V1 1 2.6 0.5 V2 1.5 0.2 1 " + texture(function, **changes) +
            "Ring Center -2.2 1.6 -1 Normal 0.3 0.5 -1 Inner 0.1 Outer 0.5 " + texture(function, **changes))


# Faces on the borders of cells, on both sides of the pattern's center. Tachyon rounds some of the points to the other side.
BORDERS = "".join(f"Box Min {x - 0.5} {y - 0.5} -0.5 Max {x + 0.5} {y + 0.5} 0.5 " + texture(1, center=f"{x} {y} 0", color=color, phong="Plastic 0")
                  for x, y, color in ((-1.5, 1.7, "1 1 1"), (0, 0.5, "0 0 0"), (1.5, 1, "0.2 0.2 0.2")))
ARRAY = ("VertexArray Numverts 4 Coords -2 0.5 0  0 0.3 -1  -2 2 0.5  0 2 0\nNormals 0 0 -1 0 0 -1 0 0 -1 0 0 -1\n")
# From afar: many rings of wood.
FAR = ("Camera Projection Orthographic Zoom 0.001 Aspectratio 1 Antialiasing 0 Raydepth 3\n"
       "  Center 0 5000 0 Viewdir 0 -1 0 Updir 0 0 1 End_Camera\n")
RULES = [
    rule("checker", objects(1)),
    rule("checker_orthographic", objects(1), projection="Orthographic", zoom=0.2),
    rule("checker_rotated_scaled", objects(1, rest="Rotate 30 40 50 Scale 2 0.5 0")),
    rule("checker_metal", objects(1, phong="Metal 0.7")),
    rule("checker_mirrors", objects(1, specular=0.4)),
    rule("checker_transparent", objects(1, opacity=0.6), mode="Shader_Mode Medium Trans_VMD End_Shader_Mode"),
    rule("checker_shadows", objects(1, opacity=0.6)),
    rule("checker_low", objects(1) + COLORED.replace("{phong}", "Plastic"), mode="Shader_Mode Low End_Shader_Mode"),
    rule("checker_in_fog", "Fog Exp Start 3 End 20 Density 0.12 Color 0.9 0.3 0.2\n" + objects(1)),
    rule("checker_borders", BORDERS, share=0.99),
    rule("checker_vertex_array", ARRAY + texture(1) + "TriStrip 4 0 2 1 3 End_VertexArray\n"),
    rule("checker_vertex_colors", ARRAY + "Colors 1 0 0 0 1 0 0 0 1 1 1 1\n" + texture(1) + "TriStrip 4 0 2 1 3 End_VertexArray\n"),
    # The rings have waves in Tachyon.
    rule("wood", objects(4), share=0.99),
    rule("wood_rings", "Plane Center 0 0 0 Normal 0 1 0 " + texture(4, center="9 4 -3"), camera=FAR, share=0.93),
]

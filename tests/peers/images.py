# SPDX-License-Identifier: Apache-2.0
"""image_map of POV-Ray's scenes, which glint reads as they are."""
import struct
import zlib

from lights import Rule

FINISH = "finish { ambient 0.4 diffuse 0.6 phong 0.3 phong_size 20 }"
LIGHT = "light_source { <2, 3, -5>, rgb 1 }\n"
CAMERA = "camera { location <0.6, 1, -4> look_at <0, 0.3, 0> angle 50 }\n"
NEW = "#version 3.7; global_settings { assumed_gamma 1 }\n"


def png(rows, kind=2, gamma=None):
    """A PNG file of 8 bits a channel; kind: 0 grey, 2 RGB, 6 RGBA. gamma: of the chunk gAMA."""
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    data = b"".join(b"\0" + b"".join(bytes(pixel) for pixel in row) for row in rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, kind, 0, 0, 0)) +
            (chunk(b"gAMA", struct.pack(">I", gamma)) if gamma else b"") + chunk(b"IDAT", zlib.compress(data)) +
            chunk(b"IEND", b""))


def picture(alpha=False):
    """Bands that tell left from right and up from down."""
    return [[(40 + 25 * i, 250 - 30 * j, 60 + 20 * ((i + j) % 7)) + ((255 - 30 * (i % 5),) if alpha else ())
             for i in range(8)] for j in range(6)]


FILES = {"map.png": png(picture()), "alpha.png": png(picture(True), 6),
         "gamma.png": png(picture(), gamma=45455), "linear.png": png(picture(), gamma=100000),
         "grey.png": png([[(25 * i + 10 * j,) for i in range(8)] for j in range(6)], 0)}
BALL = "sphere { 0, 1 %s }\n"
MESH = ("mesh2 { vertex_vectors { 4, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0.4>, <-1, 1, 0.4> }\n"
        "uv_vectors { 4, <0, 0>, <2, 0>, <2, 1>, <-0.2, 1> } %s face_indices { 2, <0, 1, 2>%s, <0, 2, 3>%s } %s }\n")


def rule(name, objects, head=NEW):
    return Rule("image_" + name, "povray", head + CAMERA + LIGHT + objects, "", files=FILES)


def pigment(items='png "map.png"', after="", before=""):
    return f"pigment {{ {before} image_map {{ {items} }} {after} }} {FINISH}"


SMALL = "scale 0.7 translate <0.2, 0.1, 0.3>"
RULES = [
    rule("planar", BALL % pigment()),
    rule("planar_bilinear", BALL % pigment('png "map.png" interpolate 2', SMALL)),
    rule("planar_turned", "box { -1, <1, 0.6, 1> %s rotate y*30 }\n" % pigment(after="rotate <20, 0, 40> " + SMALL)),
    rule("spherical", BALL % pigment('png "map.png" map_type 1', "rotate <20, 70, 0>")),
    rule("planar_distance", BALL % pigment('png "map.png" interpolate 4', SMALL)),
    rule("once_distance",
         "box { -1, <1, 1, 0> %s }\n" % pigment('png "map.png" once interpolate 4', "translate <-0.5, -0.5, 0> scale 1.6")),
    rule("spherical_bilinear", BALL % pigment('png "map.png" map_type 1 interpolate 2')),
    rule("cylindrical", "cylinder { -y, y, 0.8 %s }\n" % pigment('png "map.png" map_type 2', "translate -0.5*y scale 2")),
    rule("once", "plane { y, -1 pigment { rgb <0.2, 0.4, 0.6> } }\n" + BALL % pigment('png "map.png" once', "translate -0.5")),
    rule("once_bilinear", "plane { y, -1 pigment { rgb 0.5 } }\n" +
         "box { -1, <1, 1, 0> %s }\n" % pigment('png "map.png" once interpolate 2', "translate <-0.5, -0.5, 0> scale 1.6")),
    rule("alpha", "plane { y, -1 pigment { rgb <0.2, 0.4, 0.6> } }\n" + BALL % pigment('png "alpha.png"')),
    rule("transmit", "plane { y, -1 pigment { rgb <0.2, 0.4, 0.6> } }\n" + BALL % pigment('png "map.png" transmit all 0.4')),
    rule("filter", "plane { y, -1 pigment { rgb <0.2, 0.4, 0.6> } }\n" + BALL % pigment('png "map.png" filter all 0.6')),
    # POV-Ray cuts greys off to 8 bits after it has decoded them, so that those of version 3.7 differ where they are dark.
    rule("grey", BALL % pigment('png "grey.png"'), head="#version 3.6;\n"),
    rule("metallic", BALL % ("pigment { image_map { png \"map.png\" } } finish { ambient 0.2 diffuse 0.4 specular 0.6 metallic }")),
    rule("emission", BALL % "pigment { image_map { png \"map.png\" } } finish { ambient 0.1 emission 0.3 diffuse 0.4 }"),
    # Encodings.
    rule("gamma_of_file", BALL % pigment('png "gamma.png"')),
    rule("gamma_linear_file", BALL % pigment('png "linear.png"')),
    rule("gamma_word", BALL % pigment('png "map.png" gamma 1.8')),
    rule("gamma_srgb_word", BALL % pigment('png "linear.png" gamma srgb')),
    rule("gamma_3_6", BALL % pigment('png "map.png"'), head="#version 3.6;\n"),
    rule("gamma_3_6_file", BALL % pigment('png "linear.png"'), head="#version 3.6;\n"),
    rule("gamma_3_6_assumed", BALL % pigment('png "map.png"'), head="#version 3.6; global_settings { assumed_gamma 1 }\n"),
    rule("gamma_assumed_2.2", BALL % pigment('png "map.png"'), head="#version 3.7; global_settings { assumed_gamma 2.2 }\n"),
    rule("gamma_assumed_srgb", BALL % pigment('png "gamma.png"'), head="#version 3.7; global_settings { assumed_gamma srgb }\n"),
    # Transforms, groups and declared textures.
    rule("moved_before", "sphere { 0, 2 scale 0.5 rotate z*30 %s }\n" % pigment()),
    rule("moved_after", "sphere { 0, 2 %s scale 0.5 rotate z*30 }\n" % pigment()),
    rule("moved_texture", BALL % f"texture {{ {pigment()} {SMALL} }} rotate y*20"),
    rule("moved_material", BALL % f"material {{ texture {{ {pigment()} }} {SMALL} }}"),
    rule("moved_union", "union { sphere { 0, 1 } box { <1, -1, -1>, <2, 1, 0> } %s scale 0.5 rotate z*20 }\n" % pigment()),
    rule("moved_part", "union { sphere { 0, 1 %s } translate <0.3, 0.2, 0> scale 0.8 }\n" % pigment()),
    rule("declared", f"#declare T = texture {{ {pigment()} scale 0.5 }}\n" +
         "sphere { -0.6*x, 0.6 texture { T } } sphere { 0.6*x, 0.6 texture { T scale 0.5 rotate z*45 } }\n"),
    rule("declared_object", "#declare S = sphere { 0, 1 %s }\n" % pigment() + "object { S scale 0.5 rotate z*30 translate 0.5*x }\n"),
    rule("default", "#default { %s }\n" % pigment() + "sphere { 0, 2 scale 0.5 rotate z*30 }\n"),
    # uv_mapping.
    rule("uv_mesh", MESH % ("", "", "", pigment(before="uv_mapping"))),
    rule("uv_mesh_bilinear", MESH % ("", "", "", pigment('png "map.png" interpolate 2', before="uv_mapping") + " rotate y*30")),
    rule("uv_mesh_once", "plane { z, 2 pigment { rgb 0.5 } }\n" +
         MESH % ("", "", "", pigment('png "map.png" once', before="uv_mapping"))),
    rule("uv_mesh_scaled", MESH % ("", "", "", pigment(after="scale <0.5, 0.7, 1> rotate z*30 translate 0.1*x", before="uv_mapping"))),
    rule("uv_mesh_list", MESH % ("texture_list { 2, texture { " + pigment(before="uv_mapping") + " } texture { " +
                                 pigment('png "alpha.png"') + " } }", ", 0", ", 1", "scale 0.9 translate 0.2*x")),
    rule("uv_mesh_indices", MESH % ("", "", "", "uv_indices { 2, <1, 2, 3>, <0, 3, 1> } uv_mapping " + pigment())),
    rule("uv_mesh_texture", MESH % ("", "", "", f"texture {{ uv_mapping {pigment()} scale 0.5 }} rotate y*20")),
    rule("uv_mesh_declared", "#declare P = pigment { uv_mapping image_map { png \"map.png\" } }\n" +
         MESH % ("", "", "", f"pigment {{ P scale 0.5 }} {FINISH}")),
    rule("uv_mesh_in_union", "union { " + MESH % ("", "", "", "") + "uv_mapping " + pigment() + " rotate y*20 }\n"),
    rule("uv_triangles", f"#declare T = texture {{ uv_mapping {pigment()} }}\n"
         "mesh { triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> uv_vectors <0, 0>, <1, 0>, <0.5, 1> texture { T } } rotate y*20 }\n"),
    rule("uv_sphere", "sphere { <0.3, 0.2, 0>, 0.8 %s rotate y*40 }\n" % pigment(before="uv_mapping")),
    rule("uv_disc", "disc { 0, -z, 1.5 %s scale 0.7 }\n" % pigment(before="uv_mapping")),
]

# SPDX-License-Identifier: Apache-2.0
"""Scenes of Tachyon's own, which glint reads as they are."""
from lights import Rule

CAMERA = ("Camera {projection}Zoom {zoom} Aspectratio {aspect} Antialiasing 0 Raydepth {depth}\n"
          "  Center 0.2 3 -8 Viewdir 0 -0.35 1 Updir 0.1 1 0\n{frustum}End_Camera\n")
LIGHTS = ("Light Center -4 6 -5 Rad 0.3 Color 0.7 0.6 0.6\n"
          "Directional_Light Direction -1 -2 1.5 Color 0.3 0.4 0.5\n")


def texture(color, specular=0, opacity=1, phong="Plastic 0.4", size=25, ambient=0.1, diffuse=0.7, outline=""):
    return (f"Texture Ambient {ambient} Diffuse {diffuse} Specular {specular} Opacity {opacity} {outline} "
            f"Phong {phong} Phong_size {size} Color {color} TexFunc 0\n")


FLOOR = "Plane Center 0 0 0 Normal 0 1 0 " + texture("0.8 0.8 0.7", phong="Plastic 0")
BALL = "Sphere Center -1.2 0.8 0 Rad 0.8 " + texture("0.9 0.5 0.2")


def rule(name, objects, projection="", zoom=1.5, aspect=1, depth=6, mode="", head=LIGHTS + FLOOR, frustum=""):
    camera = CAMERA.format(projection=projection and f"Projection {projection} ", zoom=zoom, aspect=aspect, depth=depth,
                           frustum=frustum and f"Frustum {frustum}\n")
    return Rule("dat_" + name, "tachyon",
                f"Begin_Scene\nResolution 160 120\n{mode}\n{camera}Background 0.1 0.2 0.4\n{head}{objects}End_Scene\n", "")


GLASS = ("Sphere Center 0 1 -2 Rad 0.7 " + texture("0.3 0.8 0.5", opacity=0.4) +
         "Sphere Center 0.5 1 -3 Rad 0.3 " + texture("0.8 0.3 0.5", opacity=0.7, specular=0.3))
ARRAY = ("VertexArray Numverts 4 Coords -2 0.5 0  0 0.3 -1  -2 2 0.5  0 2 0\n"
         "Normals -0.19518 0.09759 -0.9759  0.287348 0 -0.957826  -0.268328 0.357771 -0.894427  0.0953463 0.286039 -0.953463\n" + texture("0.4 0.7 0.9") +
         "TriStrip 4 0 2 1 3 End_VertexArray\n")
# Patches of each winding, with normals to the viewer and away from him, and a bent one whose normals are partly away from him.
# The normals have one length: glint mixes unit vectors.
FACES = [("-2.2 0.2 0 V1 -1.2 0.2 0 V2 -1.7 1.2 0.3", (-0.4, 0, -1), (0.4, 0, -1), (0, 0.6, -1)),
         ("-1 0.2 0 V1 -0.5 1.2 0.3 V2 0 0.2 0", (-0.4, 0, -1), (0, 0.6, -1), (0.4, 0, -1)),
         ("0.2 0.2 0 V1 1.2 0.2 0 V2 0.7 1.2 0.3", (-0.4, 0, 1), (0.4, 0, 1), (0, 0.6, 1)),
         ("1.4 0.2 0 V1 1.9 1.2 0.3 V2 2.4 0.2 0", (-0.4, 0, 1), (0, 0.6, 1), (0.4, 0, 1)),
         ("-1 1.4 0 V1 0 2.4 0.3 V2 1 1.4 0", (-1, 0, -0.3), (0, 1, 0.2), (0.95, 0.3, 0.07))]


def unit(v):
    size = sum(x * x for x in v) ** 0.5
    return " ".join(f"{x / size:.9g}" for x in v)


WINDING = "".join(f"STri V0 {v} N0 {unit(n)} N1 {unit(m)} N2 {unit(k)} " + texture("0.9 0.5 0.2")
                  for v, n, m, k in FACES)
# Faces that are lit from behind, with normals to the light.
# In the same places, with a color at each vertex.
COLORED = "".join(f"VCSTri V0 {v} N0 {unit(n)} N1 {unit(m)} N2 {unit(k)} C0 0.9 0.2 0.1 C1 0.1 0.8 0.2 C2 {blue} 0.3 0.9 "
                  "Ambient 0.2 Diffuse 0.6 Specular 0 Opacity 1 Phong {phong} 0.6 Phong_size 12 VCST\n"
                  for (v, n, m, k), blue in zip(FACES, ("0.1", "0.9", "0.5", "0", "1")))
BEHIND = "".join(f"STri V0 {x} 0.2 -1.5 V1 {x + 0.8} 2.4 -0.7 V2 {x + 1.8} 0.2 0.3 N0 {n} N1 {n} N2 {n} " + texture("0.3 0.8 0.5")
                 for x, n in ((-1.8, "-0.8 0 -0.6"), (0.3, "-0.6 0 -0.8")))
FOGGED = "Fog Exp Start 3 End 20 Density 0.12 Color 0.9 0.3 0.2\n"
RULES = [
    rule("sphere", BALL),
    rule("orthographic", BALL, projection="Orthographic", zoom=0.2),
    rule("aspect", BALL, aspect=1.5),
    rule("frustum", BALL, frustum="-0.6 0.4 -0.3 0.35"),
    rule("frustum_orthographic", BALL, projection="Orthographic", frustum="-3 2 -1.5 2"),
    rule("cylinders", "FCylinder Base -1 0.2 0 Apex 1 1.5 -1 Rad 0.4 " + texture("0.9 0.5 0.2") +
         "PolyCylinder Points 3 -2 1 1 0 2 1 2 1 0 Rad 0.2 " + texture("0.2 0.5 0.9")),
    rule("rings", "Ring Center -1 1 0 Normal 0.3 0.5 -1 Inner 0 Outer 0.8 " + texture("0.9 0.5 0.2") +
         "Ring Center 1 1 0 Normal -0.3 1 -1 Inner 0.4 Outer 1 " + texture("0.2 0.5 0.9")),
    rule("box", "Box Min -0.7 0.2 -1 Max 0.5 1.4 0.2 " + texture("0.9 0.5 0.2")),
    rule("triangles", "Tri V0 -2 0.2 0 V1 0 2 0.5 V2 -0.5 0.2 -1 " + texture("0.9 0.5 0.2") +
         "STri V0 0.2 0.2 0 V1 0.5 2 0.5 V2 2 0.2 -1 N0 -0.5 0 -1 N1 0 0.5 -1 N2 0.5 0 -1 " + texture("0.2 0.5 0.9")),
    rule("winding", WINDING),
    rule("light_behind_faces", BEHIND + BALL, head="Directional_Light Direction 1 -0.2 0.1 Color 1 0.9 0.8\n" + FLOOR),
    rule("vertex_array", ARRAY),
    rule("vertex_array_colors", ARRAY.replace("TriStrip", "Colors 1 0 0 0 1 0 0 0 1 1 1 1\nTriStrip")),
    rule("vertex_array_textures", ARRAY.replace("TriStrip 4 0 2 1 3", "TriMesh 1 0 2 1 " + texture("0.9 0.5 0.2") + "TriMesh 1 2 3 1")),
    rule("vertex_colors", COLORED.replace("{phong}", "Plastic")),
    rule("vertex_colors_metal", COLORED.replace("{phong}", "Metal")),
    rule("vertex_colors_low", COLORED.replace("{phong}", "Plastic"), mode="Shader_Mode Low End_Shader_Mode"),
    rule("vertex_colors_transparent", BALL + COLORED.replace("{phong}", "Plastic").replace("Opacity 1", "Opacity 0.6"),
         mode="Shader_Mode Medium End_Shader_Mode"),
    rule("mirrors", BALL + "Sphere Center 0.8 0.9 -0.6 Rad 0.9 " + texture("0.3 0.6 0.9", specular=0.6)),
    rule("trans_orig", BALL + GLASS, mode="Shader_Mode Medium End_Shader_Mode"),
    rule("trans_vmd", BALL + GLASS, mode="Shader_Mode Medium Trans_VMD End_Shader_Mode"),
    rule("raster3d", BALL + GLASS, mode="Shader_Mode Full Trans_Raster3D End_Shader_Mode"),
    rule("raster3d_vmd", BALL + GLASS, mode="Shader_Mode Full Trans_VMD Trans_Raster3D End_Shader_Mode"),
    rule("raster3d_texture", BALL + GLASS + "FCylinder Base -1 0.2 -2 Apex 1 0.5 -3 Rad 0.3 " +
         texture("0.9 0.5 0.2", opacity=0.3, outline="TransMode R3D")),
    rule("shadow_filter_off", BALL + GLASS, mode="Shader_Mode Full Shadow_Filter_Off End_Shader_Mode"),
    rule("limit_in_fog", FOGGED + GLASS + "Sphere Center -1.2 0.8 0 Rad 0.8 " + texture("0.3 0.6 0.9", specular=0.6), depth=2),
    rule("outlines", "Sphere Center -1.2 0.8 0 Rad 0.8 " + texture("0.9 0.5 0.2", outline="Outline 1 Outline_Width 0.4") +
         "Sphere Center 0.8 0.8 -1 Rad 0.8 " + texture("0.3 0.6 0.9", outline="Outline 0.6 Outline_Width 0.95", ambient=0.3) +
         "FCylinder Base -1 0.2 -2 Apex 1 0.5 -2.5 Rad 0.2 " + texture("0.9 0.5 0.2", outline="Outline 0.8 Outline_Width 1")),
    rule("outlines_in_mirrors", BALL + "Sphere Center 0.9 0.9 -0.6 Rad 0.9 " +
         texture("0.3 0.6 0.9", specular=0.4, outline="Outline 0.7 Outline_Width 0.9") +
         "Sphere Center -0.3 0.5 -2 Rad 0.5 " + texture("0.3 0.8 0.5", opacity=0.5, outline="Outline 0.8 Outline_Width 0.7")),
    rule("outlines_of_all_light", "Sphere Center -1.2 0.8 0 Rad 0.8 " + texture("0.9 0.5 0.2", outline="Outline 0.9 Outline_Width 0.8") +
         "Sphere Center 0.9 0.9 -0.6 Rad 0.9 " + texture("0.3 0.6 0.9", specular=0.4, outline="Outline 0.7 Outline_Width 0.9"),
         mode="Shader_Mode Full Ambient_Occlusion Ambient_Color 0.5 0.5 0.4 Rescale_Direct 0.6 Samples 12 End_Shader_Mode"),
    rule("texture_again",
         "TexDef t Ambient 0.1 Diffuse 0.7 Specular 0 Opacity 1 Color 0.9 0.5 0.2 TexFunc 0\n"
         "TexDef t Ambient 0.1 Diffuse 0.7 Specular 0.5 Opacity 1 Color 0.2 0.5 0.9 TexFunc 0\n"
         "Sphere Center -1.2 0.8 0 Rad 0.8 t Sphere Center 1 0.8 0 Rad 0 t\n"),
    rule("metal", "Sphere Center 0 1.2 -1 Rad 1 " + texture("0.9 0.6 0.2", phong="Metal 0.8", size=12),
         head="Directional_Light Direction -1 -2 1.5 Color 1 1 1\n" + FLOOR),
    rule("metal_rescaled", "Sphere Center 0 1.2 -1 Rad 1 " + texture("0.9 0.6 0.2", phong="Metal 0.8", size=12),
         mode="Shader_Mode Medium Ambient_Occlusion Ambient_Color 0.5 0.5 0.4 Rescale_Direct 0.6 Samples 12 End_Shader_Mode"),
] + [rule(f"ortho_plane_{name}", "Background_Gradient Sky_Ortho_Plane UpDir 0 1 0 TopVal 2 BottomVal -1 TopColor 0.1 0.2 0.9 "
          "BottomColor 0.9 0.8 0.3\n" + GLASS + "Sphere Center 1.3 0.9 -0.6 Rad 0.6 " + texture("0.3 0.6 0.9", specular=0.6),
          projection=projection, zoom=zoom, head=LIGHTS)
     for name, projection, zoom in (("perspective", "", 1.5), ("orthographic", "Orthographic", 0.2))] + [
    rule(f"limit_in_gradient_{kind}_{depth}", f"Background_Gradient {kind} UpDir 0 1 0 TopVal 2 BottomVal -1 TopColor 0.1 0.2 0.9 "
         "BottomColor 0.9 0.8 0.3\n" + GLASS + "Sphere Center 1.3 0.9 -0.6 Rad 0.6 " + texture("0.3 0.6 0.9", specular=0.6) +
         "Sphere Center -0.3 0.5 -1 Rad 0.7 " + texture("0.9 0.6 0.2", specular=0.7), head=LIGHTS, depth=depth)
    for kind in ("Sky_Sphere", "Sky_Ortho_Plane") for depth in (1, 2)]

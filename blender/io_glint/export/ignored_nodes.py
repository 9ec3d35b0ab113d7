# SPDX-License-Identifier: Apache-2.0
"""The shader nodes that are exported: which of their sockets and properties have an effect in glint, and which do not."""
from typing import NamedTuple

from .ignored_table import BOOKS, SHOWN, Table

WHITE = (1.0, 1.0, 1.0)


class Sockets(NamedTuple):
    """Names of all versions from 3.3 on. Every other socket is in `parts`; the test checks it."""

    read: tuple
    warned: dict = {}  # name -> (text, values without an effect); without values: any link counts. {node}: the linked node
    needs: dict = {}  # name of a warned socket -> sockets without which it has no effect
    parts: dict = {}  # reason -> names


NORMAL = {"Normal": ("the {node} node at 'Normal' is ignored: the surface stays as it is", ())}
HIDDEN = {"Blender shows and reads no weight": ("Weight",)}
OFF = (0.0,)

SOCKETS = {
    "ShaderNodeBsdfPrincipled": Sockets(
        read=("Base Color", "Metallic", "Roughness", "Specular", "Specular IOR Level", "Transmission", "Transmission Weight",
              "IOR", "Emission", "Emission Color", "Emission Strength", "Alpha"),
        warned={
            **NORMAL,
            **dict.fromkeys(("Subsurface", "Subsurface Weight"), ("its subsurface scattering is ignored", OFF)),
            **dict.fromkeys(("Sheen", "Sheen Weight"), ("its sheen is ignored", OFF)),
            **dict.fromkeys(("Clearcoat", "Coat Weight"), ("its clearcoat is ignored", OFF)),
            "Specular Tint": ("its specular tint is ignored", (0.0, WHITE)),
            "Anisotropic": ("its anisotropy is ignored", OFF),
            "Transmission Roughness": ("its transmission roughness is ignored: the glass is clear", OFF),
            "Diffuse Roughness": ("its diffuse roughness is ignored", OFF),
            "Thin Film Thickness": ("its thin film is ignored", OFF)},
        needs={"Specular Tint": ("Specular", "Specular IOR Level"), "Transmission Roughness": ("Transmission",)},
        parts={
            "without subsurface scattering, which is warned of, it has no effect": (
                "Subsurface Radius", "Subsurface Color", "Subsurface IOR", "Subsurface Anisotropy", "Subsurface Scale"),
            "without anisotropy, which is warned of, it has no effect": ("Anisotropic Rotation", "Tangent"),
            "without sheen, which is warned of, it has no effect": ("Sheen Tint", "Sheen Roughness"),
            "without clearcoat, which is warned of, it has no effect": (
                "Clearcoat Roughness", "Clearcoat Normal", "Coat Roughness", "Coat IOR", "Coat Tint", "Coat Normal"),
            "without a thin film, which is warned of, it has no effect": ("Thin Film IOR",),
            **HIDDEN}),
    "ShaderNodeBsdfDiffuse": Sockets(
        ("Color",), {**NORMAL, "Roughness": ("its diffuse roughness is ignored", OFF)}, parts=HIDDEN),
    "ShaderNodeBsdfGlossy": Sockets(
        ("Color", "Roughness"), {**NORMAL, "Anisotropy": ("its anisotropy is ignored", OFF)},
        parts={"without anisotropy, which is warned of, it has no effect": ("Rotation", "Tangent"), **HIDDEN}),
    "ShaderNodeBsdfGlass": Sockets(
        ("Color", "IOR"), {**NORMAL, "Roughness": ("its roughness is ignored: the glass is clear", OFF),
                           "Thin Film Thickness": ("its thin film is ignored", OFF)},
        parts={"without a thin film, which is warned of, it has no effect": ("Thin Film IOR",), **HIDDEN}),
    "ShaderNodeBsdfTransparent": Sockets(("Color",), parts=HIDDEN),
    "ShaderNodeEmission": Sockets(("Color", "Strength"), parts=HIDDEN),
    "ShaderNodeBackground": Sockets(("Color", "Strength"), parts=HIDDEN),
    "ShaderNodeMixShader": Sockets(("Fac", "Factor", "Shader", "Shader_001")),
    "ShaderNodeAddShader": Sockets(("Shader", "Shader_001")),
    "ShaderNodeOutputMaterial": Sockets(
        ("Surface",), {"Volume": ("its volume is ignored", ()),
                       "Displacement": ("its displacement is ignored: the surface stays as it is", ())},
        parts={"Eevee's approximation of the way through glass": ("Thickness",)}),
    "ShaderNodeOutputWorld": Sockets(("Surface",), {"Volume": ("its volume is ignored", ())}),
    "ShaderNodeOutputLight": Sockets(("Surface",)),
}
SOCKETS["ShaderNodeBsdfAnisotropic"] = SOCKETS["ShaderNodeBsdfGlossy"]

ONE_LOBE = "one highlight stands for all"
NODE_TABLES = {
    "Node": Table(
        read="type inputs outputs internal_links mute",
        irrelevant={
            BOOKS: "name label bl_* parent dimensions is_registered_node_type debug_*",
            SHOWN: "location location_absolute width width_hidden height hide select show_* color color_tag use_custom_color "
                   "warning_propagation"}),
    "ShaderNodeBsdfPrincipled": Table(
        irrelevant={ONE_LOBE: "distribution", "subsurface scattering is warned of": "subsurface_method"}),
    "ShaderNodeBsdfGlossy": Table(read="distribution"),
    "ShaderNodeBsdfAnisotropic": Table(read="distribution"),
    "ShaderNodeBsdfGlass": Table(irrelevant={ONE_LOBE: "distribution"}),
    "ShaderNodeOutputMaterial": Table(read="is_active_output target"),
    "ShaderNodeOutputWorld": Table(read="is_active_output target"),
    "ShaderNodeOutputLight": Table(read="is_active_output target"),
    "ShaderNodeMixRGB": Table(
        read="blend_type use_clamp", irrelevant={"a shader's colors have no alpha": "use_alpha"}),
    "ShaderNodeMix": Table(read="blend_type data_type clamp_factor clamp_result factor_mode"),
    "ShaderNodeTexImage": Table(
        read="image projection extension interpolation texture_mapping color_mapping",
        irrelevant={"a part of box projection, for which the mean is exported": "projection_blend",
                    "which frame of a movie is shown, for which the mean is exported": "image_user"}),
    "ShaderNodeUVMap": Table(read="uv_map from_instancer"),
    "ShaderNodeTexCoord": Table(read="from_instancer", irrelevant={"of coordinates for which the mean is exported": "object"}),
    "ShaderNodeMapping": Table(read="vector_type"),
    "ShaderNodeVertexColor": Table(read="layer_name"),
    "ShaderNodeAttribute": Table(read="attribute_type attribute_name"),
}

# SPDX-License-Identifier: Apache-2.0
"""Panels: the render settings, an object's shape, a material's glint keys; and Blender's own panels for the engine."""
import bpy
from bpy.props import BoolProperty, StringProperty

from .export import keys
from .labels import draw_sentence
from .passes import BUILT_IN, OWN
from .properties import COMMAND_SETTINGS, draw_rt2_settings, draw_settings

# Panels of what glint has not, or has a panel of its own for.
EXCLUDED = {"DATA_PT_light", "DATA_PT_area", "VIEWLAYER_PT_filter", "VIEWLAYER_PT_layer_passes", "RENDER_PT_gpencil",
            "RENDER_PT_post_processing"}
# Panels that Blender offers to Eevee and Cycles, but whose settings the exporter reads.
SHARED = {"EEVEE_MATERIAL_PT_context_material", "EEVEE_MATERIAL_PT_surface", "EEVEE_WORLD_PT_surface",
          "DATA_PT_EEVEE_light", "WORLD_PT_context_world", "MATERIAL_PT_preview"}


class _Panel:
    bl_space_type, bl_region_type = "PROPERTIES", "WINDOW"
    COMPAT_ENGINES = {"GLINT"}


class RENDER_PT_glint(_Panel, bpy.types.Panel):
    bl_label, bl_context = "glint", "render"

    @classmethod
    def poll(cls, context):
        return context.engine in cls.COMPAT_ENGINES

    def draw_header_preset(self, _context):
        self.layout.operator("glint.documentation", text="", icon="HELP", emboss=False)

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.prop(context.scene.glint, "picture")
        draw = draw_rt2_settings if context.scene.glint.picture == "RT2" else draw_settings
        draw(self.layout, context.scene)
        if context.scene.glint.picture != "RT2":
            self.layout.prop(context.scene.render, "film_transparent", text="Transparent film")


class RENDER_PT_glint_command(_Panel, bpy.types.Panel):
    bl_label, bl_context, bl_parent_id, bl_options = "Command", "render", "RENDER_PT_glint", {"DEFAULT_CLOSED"}

    def draw(self, context):
        self.layout.use_property_split = True
        for name in COMMAND_SETTINGS:
            self.layout.prop(context.scene.glint, name)
        render = context.scene.render
        self.layout.prop(render, "threads_mode")
        if render.threads_mode == "FIXED":
            self.layout.prop(render, "threads")


class OBJECT_PT_glint(_Panel, bpy.types.Panel):
    bl_label, bl_context, bl_options = "glint", "object", {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type in ("MESH", "CURVE", "SURFACE", "FONT", "META")

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.prop(context.object, "glint_shape", text="Shape")


class DATA_PT_glint_light(_Panel, bpy.types.Panel):
    bl_label, bl_context = "glint", "data"

    @classmethod
    def poll(cls, context):
        return context.light is not None and context.engine in cls.COMPAT_ENGINES

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.prop(context.light, "use_shadow", text="Shadow")


class MATERIAL_PT_glint(_Panel, bpy.types.Panel):
    bl_label, bl_context = "glint", "material"

    @classmethod
    def poll(cls, context):
        return context.material is not None

    def draw(self, context):
        layout, material = self.layout, context.material
        layout.use_property_split = True
        draw_sentence(layout, "Each key replaces what the shader nodes say")
        for name in keys.NAMES:
            key = keys.PREFIX + name
            row = layout.row(align=True)
            if key in material:
                row.prop(material, f'["{key}"]', text=name)
                row.operator("glint.material_key", text="", icon="X").key = name
            else:
                row.operator("glint.material_key", text=name, icon="ADD").key = name


class GLINT_OT_material_key(bpy.types.Operator):
    bl_idname = "glint.material_key"
    bl_label = "glint material key"
    bl_description = "Add this key to the material, or remove it"
    bl_options = {"UNDO"}

    key: StringProperty()

    @classmethod
    def poll(cls, context):
        return getattr(context, "material", None) is not None

    def execute(self, context):
        material, key = context.material, keys.PREFIX + self.key
        if self.key not in keys.NAMES:
            self.report({"ERROR"}, f"glint has no material key '{self.key}'")
            return {"CANCELLED"}
        if key in material:
            del material[key]
        else:
            add_key(material, self.key)
        return {"FINISHED"}


def add_key(material, name):
    """Gives a material the property of a key, with its default and its limits."""
    key = keys.PREFIX + name
    if name in keys.COLORS:
        start = tuple(material.diffuse_color)[:3] if name == "color" else (1.0, 1.0, 1.0)
        material[key] = start
        material.id_properties_ui(key).update(subtype="COLOR", min=0.0, soft_max=1.0, default=(1.0, 1.0, 1.0))
    else:
        least, greatest, start = keys.NUMBERS[name]
        material[key] = start
        material.id_properties_ui(key).update(min=least, max=greatest, default=start)


def _update_passes(_settings, context):
    context.view_layer.update_render_passes()


class GlintLayerSettings(bpy.types.PropertyGroup):
    """view_layer.glint: glint's own passes."""

    __annotations__ = {}


for _layer in OWN:
    GlintLayerSettings.__annotations__[_layer] = BoolProperty(name=_layer.capitalize(), update=_update_passes)


class VIEWLAYER_PT_glint_passes(_Panel, bpy.types.Panel):
    bl_label, bl_context = "Passes", "view_layer"

    @classmethod
    def poll(cls, context):
        return context.engine in cls.COMPAT_ENGINES

    def draw(self, context):
        layout, layer = self.layout, context.view_layer
        layout.use_property_split = True
        for name in BUILT_IN.values():
            layout.prop(layer, name)
        for name in OWN:
            layout.prop(layer.glint, name)


class WORLD_PT_glint_mist(_Panel, bpy.types.Panel):
    bl_label, bl_context, bl_options = "Mist", "world", {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return context.world is not None and context.engine in cls.COMPAT_ENGINES

    def draw(self, context):
        layout, mist = self.layout, context.world.mist_settings
        layout.use_property_split = True
        layout.prop(context.scene.glint, "mist")
        layout.prop(mist, "start")
        layout.prop(mist, "depth")


class VIEWLAYER_PT_glint_override(_Panel, bpy.types.Panel):
    bl_label, bl_context, bl_options = "Override", "view_layer", {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return context.engine in cls.COMPAT_ENGINES

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.prop(context.view_layer, "material_override")


def _compatible_panels():
    for panel in bpy.types.Panel.__subclasses__():
        engines = getattr(panel, "COMPAT_ENGINES", None)
        name = panel.__name__.removeprefix("NODE_")  # the same panel in the node editor shares the set
        if engines is None or name in EXCLUDED or "freestyle" in name:
            continue
        if "BLENDER_RENDER" in engines or name in SHARED:
            yield panel


classes = (RENDER_PT_glint, RENDER_PT_glint_command, OBJECT_PT_glint, DATA_PT_glint_light, MATERIAL_PT_glint, GLINT_OT_material_key,
           GlintLayerSettings, VIEWLAYER_PT_glint_passes, VIEWLAYER_PT_glint_override, WORLD_PT_glint_mist)


def register():
    bpy.types.ViewLayer.glint = bpy.props.PointerProperty(type=GlintLayerSettings)
    for panel in _compatible_panels():
        panel.COMPAT_ENGINES.add("GLINT")


def unregister():
    for panel in _compatible_panels():
        panel.COMPAT_ENGINES.discard("GLINT")
    del bpy.types.ViewLayer.glint

# SPDX-License-Identifier: Apache-2.0
"""Settings that are kept in the .blend: the scene's conventions and an object's glint_shape."""
import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty, StringProperty

from .course_scene import collection_of, messages
from .export.options import Options
from .labels import draw_sentence

SHAPE_ITEMS = (
    ("AUTO", "Auto", "A sphere, cylinder, cone, disc or box if the mesh is one; else triangles"),
    ("MESH", "Mesh", "Triangles, always"),
    ("SPHERE", "Sphere", "A sphere around the mesh"),
    ("CYLINDER", "Cylinder", "A cylinder around the mesh, along the object's z axis"),
    ("CONE", "Cone", "A cone around the mesh, along the object's z axis"),
    ("PLANE", "Plane (infinite)", "The infinite plane in which the mesh lies"),
    ("DISC", "Disc", "A disc around the mesh, across the object's z axis"),
    ("BOX", "Box", "The mesh's bounding box in the object's space"),
)

# In the order of the panels.
COMMAND_SETTINGS = ("keep_folder", "extra_arguments")
SCENE_SETTINGS = ("shading", "reflections", "aa", "adaptive", "light_samples", "light_scale", "mist", "occlusion",
                  "facing", "fresnel", "glass_shadow", "recognise")


def _use_raw_colors(settings, _context):
    if settings.picture == "RT2":
        settings.id_data.view_settings.view_transform = "Raw"


class GlintSceneSettings(bpy.types.PropertyGroup):
    """scene.glint"""

    picture: EnumProperty(name="Picture", items=(
        ("BLENDER", "Blender's scene", "With Blender's lights and materials, as .glint exports it"),
        ("RT2", "RT2 homework", "What the exported RT2 scene looks like by the homework's rules; sets the view transform Raw, as "
         "the homework writes its numbers")), default="BLENDER", update=_use_raw_colors)
    rt2_aa: IntProperty(name="Samples n x n", default=1, min=1, max=64,
                        description="n: n x n regular samples for each pixel; the homework takes one")
    shading: EnumProperty(name="Shading", items=(
        ("blinn-phong", "Blinn-Phong", "Highlights by N.H"),
        ("phong", "Phong", "Highlights by R.V; exponents of shader nodes are divided by 4"),
        ("diffuse", "Diffuse", "No highlights"),
        ("color", "Color", "The surfaces' colors alone"),
        ("normals", "Normals", "0.5 (N + 1)")), default=Options.shading)
    facing: EnumProperty(name="Turned normals", items=(
        ("all", "All", "Both sides of every surface are lit, as in Blender"),
        ("open", "Open surfaces", "Both sides of planes and open cylinders"),
        ("none", "None", "Fronts alone")), default=Options.facing)
    fresnel: EnumProperty(name="Fresnel", items=(
        ("schlick", "Schlick", "Glass reflects more at grazing angles"),
        ("none", "None", "Glass transmits the same share at every angle")), default=Options.fresnel)
    glass_shadow: EnumProperty(name="Shadow of glass", items=(
        ("none", "None", "Light passes through glass"),
        ("opaque", "Opaque", "Glass blocks light")), default=Options.glass_shadow)
    reflections: IntProperty(name="Reflections", default=Options.reflections, min=-1, max=1000,
                             description="Most generations of mirror and glass rays; -1: Cycles' bounces, at most 12")
    aa: IntProperty(name="Samples n x n", default=Options.aa, min=1, max=64,
                    description="n: n x n regular samples for each pixel")
    adaptive: BoolProperty(name="Adaptive", default=Options.adaptive,
                           description="Take these samples only where pixels differ from their neighbors, and one elsewhere")
    light_samples: IntProperty(name="Lights n x n", default=Options.light_samples, min=1, max=64,
                               description="n: n x n samples of each area light, and of each point light with a radius")
    light_scale: FloatProperty(name="Light scale", default=Options.light_scale, min=0.0, soft_max=10.0,
                               description="All lights are multiplied by this")
    mist: BoolProperty(name="Mist as fog", default=Options.mist,
                       description="The world's mist, which Blender has as a pass only, hides what is far away")
    occlusion: BoolProperty(name="World light is blocked", default=Options.occlusion,
                            description="Shapes block the world's light (ambient occlusion); else it is the same everywhere")
    recognise: BoolProperty(name="Recognise shapes", default=Options.recognise,
                            description="Export smooth balls, tubes and boxes as glint's own shapes")

    # Of F12 alone.
    keep_folder: StringProperty(name="Keep scene in", subtype="DIR_PATH",
                                description="Folder in which each render leaves its scene, SCENE.0001.glint and so on; empty: "
                                "none is kept")
    extra_arguments: StringProperty(name="Arguments", description="More arguments of `glint render`, as --seed 3 --no-shadows; "
                                    "quoted as in a shell")

    def rt2_settings(self):
        """What an RT2 file does not say, by the names of options of `glint render`."""
        settings = {"aa": str(self.rt2_aa), "shading": self.shading}
        return settings if self.reflections < 0 else settings | {"reflections": self.reflections}

    def options(self, **more):
        return Options(**{name: getattr(self, name) for name in SCENE_SETTINGS}, **more)


def draw_rt2_settings(layout, scene):
    """Those of a picture by the homework's rules, and what the course's script would take otherwise."""
    for name in ("shading", "reflections", "rt2_aa"):
        layout.prop(scene.glint, name)
    if scene.view_settings.view_transform != "Raw":
        draw_sentence(layout, "View Transform: Raw shows the homework's numbers", icon="INFO")
    for item, text in messages(scene, collection_of(scene)):
        draw_sentence(layout, f"{item}: {text}", icon="ERROR")


def draw_settings(layout, scene):
    """The settings of .glint, in the panel of the engine and in the export's."""
    for name in SCENE_SETTINGS:
        layout.prop(scene.glint, name)
        if name == "mist" and scene.glint.mist and scene.world is not None:
            for part in ("start", "depth"):
                layout.prop(scene.world.mist_settings, part, text=f"Mist {part}")


def register():
    bpy.utils.register_class(GlintSceneSettings)
    bpy.types.Scene.glint = PointerProperty(type=GlintSceneSettings)
    bpy.types.Object.glint_shape = EnumProperty(name="glint shape", items=SHAPE_ITEMS, default="AUTO",
                                                description="What the object is exported to glint as")


def unregister():
    del bpy.types.Object.glint_shape
    del bpy.types.Scene.glint
    bpy.utils.unregister_class(GlintSceneSettings)

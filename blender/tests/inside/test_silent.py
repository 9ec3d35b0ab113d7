# SPDX-License-Identifier: Apache-2.0
"""Nothing in silence: every property of Blender is read, warned of or irrelevant for a reason; a fresh scene has no warnings."""
import fnmatch
import math
import unittest.mock

import bpy
from io_glint import engine, warnings_panel
from io_glint.export import ignored, ignored_nodes
from support import SceneTest

LIGHTS = ("POINT", "SUN", "SPOT", "AREA")


class Tables(SceneTest):
    def node(self, kind):
        tree = self.scene.world.node_tree if kind == "ShaderNodeOutputWorld" else bpy.data.materials["all nodes"].node_tree
        if kind == "ShaderNodeOutputLight":
            lamp = self.lamp().data
            lamp.use_nodes = True
            tree = lamp.node_tree
        return tree.nodes.new(kind)

    def nodes(self):
        """One of each node whose sockets or properties are in the tables, as far as this Blender has them."""
        self.world((0, 0, 0))
        bpy.data.materials.new("all nodes").use_nodes = True
        for kind in sorted({*ignored_nodes.SOCKETS, *ignored_nodes.NODE_TABLES} - {"Node"}):
            if hasattr(bpy.types, kind):
                yield self.node(kind)

    def structs(self):
        cube = self.add("cube")
        found = [self.scene, self.scene.view_settings, self.scene.display_settings, bpy.context.view_layer,
                 bpy.context.view_layer.layer_collection, bpy.data.collections.new("c"), bpy.data.images.new("i", 1, 1),
                 bpy.data.worlds.new("world"), bpy.data.materials.new("m"), cube, cube.data, self.camera().data]
        found += [self.lamp(kind).data for kind in LIGHTS]
        found += self.nodes()
        for struct in found:
            yield struct
            found.extend(ignored.nested(struct))

    def test_every_property_is_read_or_warned_of_or_irrelevant_for_a_reason(self):
        unknown, checked = [], set()
        for struct in self.structs():
            kind = struct.bl_rna.identifier
            if kind in checked:
                continue
            checked.add(kind)
            tables = list(ignored.tables_of(struct.bl_rna))
            known = {name for table in tables for names in (table.read, table.nested, *table.warned.values(),
                                                            *table.irrelevant.values()) for name in names.split()}
            unknown += [f"{kind}.{prop.identifier}" for prop in struct.bl_rna.properties if prop.identifier != "rna_type"
                        and not any(fnmatch.fnmatchcase(prop.identifier, name) for name in known)]
        self.assertGreater(len(checked), 45)
        self.assertLessEqual({"Scene", "SceneEEVEE", "RenderSettings", "CyclesRenderSettings", "Object", "Mesh", "Image", "Material",
                              "World", "Camera", "ViewLayer", "SunLight"}, checked)
        self.assertEqual(unknown, [])

    def test_every_socket_is_read_or_warned_of_or_irrelevant_for_a_reason(self):
        unknown = []
        for node in self.nodes():
            known = ignored_nodes.SOCKETS.get(node.bl_idname)
            if known is not None:
                names = {*known.read, *known.warned, *(name for part in known.parts.values() for name in part)}
                unknown += [f"{node.bl_idname}: {socket.name}" for socket in node.inputs
                            if not {socket.name, socket.identifier} & names]
        self.assertEqual(unknown, [])

    def test_nothing_is_in_two_places(self):
        for kind, table in ignored.ALL_TABLES.items():
            names = " ".join((table.read, table.nested, *table.warned.values(), *table.irrelevant.values())).split()
            plain = [name for name in names if "*" not in name]
            self.assertEqual(len(plain), len(set(plain)), kind)
            for name in " ".join((table.read, table.nested, *table.warned.values())).split():
                self.assertNotIn("*", name, kind)
                hidden = [other for other in names if "*" in other and fnmatch.fnmatchcase(name, other)]
                self.assertEqual(hidden, [], (kind, name))


class Fresh(SceneTest):
    def test_the_first_scene_has_no_warnings(self):
        bpy.ops.wm.read_homefile(use_empty=False)
        self.scene = bpy.context.scene
        self.assertIn("Cube", self.scene.objects)
        self.export()
        self.assertEqual(self.warnings, [])

    def test_new_things_have_no_warnings(self):
        bpy.ops.object.camera_add()
        self.scene.camera = bpy.context.object
        self.scene.camera.location.z = 12
        for kind in LIGHTS:
            bpy.ops.object.light_add(type=kind, location=(0, 0, 5))
            bpy.context.object.data.use_nodes = True
        for node in ("Principled", "Diffuse", "Glossy", "Glass", "Transparent"):
            self.add("cube", material=self.shader(f"ShaderNodeBsdf{node}", node))
        self.add("cube", material=self.shader("ShaderNodeEmission", "Emission"))
        self.add("cube", material=bpy.data.materials.new("without nodes"))
        self.world((0.1, 0.2, 0.3))
        self.scene.view_layers.new("second")
        self.export()
        # The one thing that Blender's new data have and glint has not.
        self.assertEqual(self.warnings, ["light 'Spot': its radius of 0.25 is ignored: shadows are hard"])


class Named(SceneTest):
    """What was ignored in silence is named, once, with the item that it is about."""

    def setUp(self):
        super().setUp()
        self.camera()
        self.ball = self.add("cube", name="Ball")

    def assert_named(self, *words, times=1):
        self.export()
        found = [w for w in self.warnings if all(word in w for word in words)]
        self.assertEqual(len(found), times, (words, self.warnings))

    def test_sockets_of_the_principled_node(self):
        for name, value, words in (
                ("Subsurface", 0.2, "subsurface scattering"), ("Specular Tint", 0.5, "specular tint"),
                ("Anisotropic", 0.5, "anisotropy"), ("Sheen", 0.5, "sheen"), ("Clearcoat", 1.0, "clearcoat")):
            material = self.material(name, **{name: value})
            self.add("cube", material=material)
            self.assert_named(f"material '{name}'", words)
        glass = self.material("glass", Transmission=1.0, Roughness=0.0)
        self.add("cube", material=glass)
        self.assert_named("material 'glass'", times=0)
        inputs = glass.node_tree.nodes["Principled BSDF"].inputs
        inputs["Transmission Roughness"].default_value, inputs["Roughness"].default_value = 0.3, 0.3
        self.assert_named("material 'glass'", "transmission roughness")
        self.assert_named("material 'glass'", "blurs nothing behind it")

    def test_sockets_without_an_effect_are_not_named(self):
        self.add("cube", material=self.material("m", Specular=0.0, Specular_Tint=1.0, Clearcoat_Roughness=0.5, Sheen_Tint=0.1,
                                                Anisotropic_Rotation=0.3, Subsurface_IOR=1.2, Transmission_Roughness=0.5))
        self.export()
        self.assertEqual(self.warnings, [])

    def test_links(self):
        material = self.material("rough")
        tree = material.node_tree
        node, output = tree.nodes["Principled BSDF"], tree.nodes["Material Output"]
        self.ball.data.materials.append(material)
        for kind, into, words in (
                ("ShaderNodeBump", node.inputs["Normal"], ("Bump node at 'Normal'",)),
                ("ShaderNodeNormalMap", node.inputs["Normal"], ("Normal Map node at 'Normal'",)),
                ("ShaderNodeDisplacement", output.inputs["Displacement"], ("displacement",)),
                ("ShaderNodeVolumePrincipled", output.inputs["Volume"], ("volume",)),
                ("ShaderNodeTexNoise", node.inputs["Clearcoat"], ("clearcoat",))):
            link = tree.links.new(tree.nodes.new(kind).outputs[0], into)
            self.assert_named("material 'rough'", *words)
            self.assertEqual(len(self.warnings), 1, self.warnings)
            link.is_muted = True
            self.assert_named("material 'rough'", times=0)
            tree.links.remove(link)
        zero = tree.nodes.new("ShaderNodeValue")
        zero.outputs[0].default_value = 0
        tree.links.new(zero.outputs[0], node.inputs["Clearcoat"])
        self.assert_named("material 'rough'", times=0)

    def test_other_shaders(self):
        for kind, name, value, words in (
                ("ShaderNodeBsdfGlass", "Roughness", 0.3, "the glass is clear"),
                ("ShaderNodeBsdfDiffuse", "Roughness", 0.3, "diffuse roughness"),
                ("ShaderNodeBsdfAnisotropic", "Anisotropy", 0.5, "anisotropy")):
            self.add("cube", material=self.shader(kind, kind, **{name: value}))
            self.assert_named(f"material '{kind}'", words)

    def test_materials(self):
        material = self.material("leaf")
        self.ball.data.materials.append(material)
        material.shadow_method, material.use_backface_culling = "NONE", True
        material.cycles.use_transparent_shadow = False
        for words in ("shadow mode", "backface culling is ignored, as in Cycles", "'Transparent Shadows'"):
            self.assert_named("material 'leaf'", words)

    def test_objects(self):
        self.ball.visible_shadow = self.ball.visible_glossy = self.ball.visible_diffuse = False
        self.ball.cycles.use_adaptive_subdivision = self.ball.cycles.is_caustics_caster = True
        for words in ("Shadow Visibility", "Glossy Visibility", "Diffuse Visibility", "adaptive subdivision", "caustics"):
            self.assert_named("object 'Ball'", words)

    def test_an_object_with_instances_is_named_once(self):
        collection = bpy.data.collections.new("balls")
        self.scene.collection.objects.unlink(self.ball)
        collection.objects.link(self.ball)
        self.ball.visible_shadow = False
        for i in range(3):
            holder = self.link(bpy.data.objects.new(f"holder {i}", None))
            holder.instance_type, holder.instance_collection = "COLLECTION", collection
        self.assert_named("Shadow Visibility")

    def test_lights(self):
        self.lamp("SPOT", name="Stage", shadow_soft_size=0.01)
        self.lamp("AREA", name="Disc", shape="DISK", size=1, spread=1)
        self.lamp("SUN", name="Sun", angle=math.radians(2))
        self.lamp("AREA", name="Portal").data.cycles.is_portal = True
        point = self.lamp(name="Bulb", shadow_soft_size=0.01, use_custom_distance=True, specular_factor=0.5)
        point.data.cycles.max_bounces, point.data.cycles.is_caustics_light, point.visible_diffuse = 3, True, False
        for name, words in (("Stage", "radius of 0.01"), ("Disc", "spread"), ("Sun", "angle of 2 degrees"), ("Portal", "portal"),
                            ("Bulb", "its 'Custom "), ("Bulb", "specular factor"), ("Bulb", "Max Bounces"),
                            ("Bulb", "caustics"), ("Bulb", "Diffuse Visibility")):
            self.assert_named(f"'{name}'", words)
        self.assert_named("'Bulb'", "radius", times=0)  # it is exported
        self.assertIn("radius = 0.01", self.export())

    def test_the_world(self):
        world = self.world((0.1, 0.1, 0.1))
        tree = world.node_tree
        tree.links.new(tree.nodes.new("ShaderNodeVolumeScatter").outputs[0], tree.nodes["World Output"].inputs["Volume"])
        world.light_settings.use_ambient_occlusion = world.mist_settings.use_mist = True
        world.cycles_visibility.camera = False
        for words in ("volume", "ambient occlusion", "mist is left out", "'Camera'"):
            self.assert_named("world 'World'", words)
        self.scene.glint.mist = True
        self.assert_named("mist is left out", times=0)

    def test_the_view_layer(self):
        layer = bpy.context.view_layer
        layer.use_sky, layer.use_pass_mist, layer.cycles.use_pass_shadow_catcher = False, True, True
        layer.use_pass_z = True
        layer.aovs.add()
        for words in ("'Sky'", "pass 'Mist'", "pass 'Shadow Catcher'", "AOVs"):
            self.assert_named("view layer", words)
        self.assert_named("view layer", times=4)

    def test_render_settings(self):
        render, cycles = self.scene.render, self.scene.cycles
        render.use_multiview = render.use_freestyle = render.use_motion_blur = cycles.film_transparent_glass = True
        render.filter_size, cycles.film_exposure = 3, 2
        for words in ("right eye", "Freestyle", "motion blur", "filter size", "'Exposure'", "'Transparent Glass'"):
            self.assert_named("scene 'Scene'", words)
        self.assert_named("scene 'Scene'", times=6)

    def test_settings_of_eevee(self):
        eevee = self.scene.eevee
        for name, words in (("use_bloom", "'Bloom'"), ("use_motion_blur", "'Motion Blur'"), ("use_gtao", "ambient occlusion")):
            if hasattr(eevee, name):  # to 4.1
                setattr(eevee, name, True)
                self.assert_named("scene 'Scene'", "Eevee's", words)

    def test_the_color_management_of_exports(self):
        """F12's picture has it, and its reports do not name it."""
        settings = self.scene.view_settings
        settings.exposure, settings.gamma, settings.use_curve_mapping = 1, 2, True
        settings.view_transform, settings.look = "Filmic", "High Contrast"
        for words in ("'Exposure'", "'Gamma'", "'Look'", "'Use Curves'"):
            self.assert_named("scene 'Scene'", words, "color management")
        self.use_engine()
        self.picture()
        self.assertEqual([text for _, text in warnings_panel.kept() if "color management" in text], [])

    def test_the_right_eye_of_a_render(self):
        render = self.scene.render
        render.engine, render.use_multiview, render.views_format = "GLINT", True, "STEREO_3D"
        render.filepath = self.path("eyes.png")
        bpy.ops.render.render(write_still=True)
        self.assertEqual(sum("right eye" in text for _, text in warnings_panel.kept()), 1)


class Animated(SceneTest):
    """Settings of glint have F-curves as any other."""

    def setUp(self):
        super().setUp()
        self.camera()
        self.add("cube")
        settings = self.scene.glint
        self.scene.frame_start, self.scene.frame_end = 1, 2
        for frame, aa, reflections in ((1, 1, 5), (2, 2, 7)):
            settings.aa, settings.reflections = aa, reflections
            for name in ("aa", "reflections"):
                settings.keyframe_insert(name, frame=frame)

    def check(self, texts):
        self.assertEqual(len(texts), 2)
        for text, words in zip(texts, ("reflections = 5  aa = 1 ", "reflections = 7  aa = 2 ")):
            self.assertIn(words, text)

    def test_by_f12(self):
        texts, write = [], engine.write_text
        self.scene.render.engine, self.scene.render.filepath = "GLINT", self.path("frame_")
        with unittest.mock.patch.object(engine, "write_text", lambda file, text: (texts.append(text), write(file, text))):
            bpy.ops.render.render(animation=True)
        self.check(texts)

    def test_by_the_export(self):
        for evaluation in ("RENDER", "VIEWPORT"):
            bpy.ops.export_scene.glint(filepath=self.path("a.glint"), animation=True, evaluation=evaluation)
            self.check([open(self.path(f"a.{i:04d}.glint"), encoding="utf-8").read() for i in (1, 2)])

# SPDX-License-Identifier: Apache-2.0
"""What a render shows is what glint hits: every kind of object, at the same points."""
import math

import bpy
from support import SceneTest


class Hits(SceneTest):
    def setUp(self):
        super().setUp()
        self.camera()
        self.lamp()

    def test_primitives_with_any_transform(self):
        self.add("plane", size=12)
        self.add("cube", location=(-1.5, 0, 0.6), scale=(0.6, 0.4, 0.8), rotation=(0.3, 0.2, 0.5))
        self.add("monkey", location=(1.5, 0, 0.8), scale=(-0.8, 0.8, 0.8), rotation=(0, 0, 0.4))
        self.add("torus", location=(0, 1.5, 1))
        self.add("uv_sphere", location=(0, -1.5, 0.6), scale=(0.5, 0.7, 0.5))  # flat: a mesh
        self.assertGreater(self.check_hits(step=3), 300)

    def test_smooth_meshes_too(self):
        self.add("monkey", smooth=True, location=(0, 0, 0.8), scale=(2, 2, 2))
        self.check_hits()
        self.assertIn("normals=", self.export())

    def test_modifiers_are_applied(self):
        cube = self.add("cube", location=(-1, 0, 0.5), scale=(0.3, 0.3, 0.3))
        array = cube.modifiers.new("Array", "ARRAY")
        array.count = 3
        plane = self.add("plane", location=(0, -1, 1), size=1, rotation=(1, 0, 0))
        plane.modifiers.new("Solidify", "SOLIDIFY").thickness = 0.3
        self.check_hits(step=3)

    def test_render_levels_of_modifiers_and_visibility(self):
        cube = self.add("cube")
        subdivision = cube.modifiers.new("Subdivision", "SUBSURF")
        subdivision.levels, subdivision.render_levels = 0, 2
        self.add("cube", name="not rendered").hide_render = True
        self.add("cube", name="not in the viewport").hide_viewport = True
        self.assertEqual(self.export().count("triangle{"), 6 * 4 ** 2 * 2)
        self.assertNotIn("not rendered", self.export())
        self.assertIn('"not in the viewport"', self.export())
        viewport = self.export(evaluation="VIEWPORT")
        self.assertNotIn("not in the viewport", viewport)
        self.assertIn('"not rendered"', viewport)
        self.assertNotIn("triangle{", viewport)  # two boxes

    def test_instances_nested_and_mirrored(self):
        inner, outer = bpy.data.collections.new("inner"), bpy.data.collections.new("outer")
        cone = self.add("cone", vertices=12, scale=(0.4, 0.4, 0.8))
        self.scene.collection.objects.unlink(cone)
        inner.objects.link(cone)

        def instance(name, collection, location, scale, into):
            ob = bpy.data.objects.new(name, None)
            ob.instance_type, ob.instance_collection = "COLLECTION", collection
            ob.location, ob.scale, ob.rotation_euler = location, scale, (0, 0, 0.5)
            into.objects.link(ob)

        instance("a", inner, (-0.5, 0, 0), (1, 1, 1), outer)
        instance("b", inner, (0.8, 0, 0), (-1, 1, 0.6), outer)
        instance("one", outer, (-1, 0, 0.5), (1, 1, 1), self.scene.collection)
        instance("two", outer, (1.2, 1, 0.5), (1, -1, 1.2), self.scene.collection)
        self.check_hits(step=3)
        self.assertEqual(self.export().count("group"), 4)

    def test_instances_on_vertices(self):
        emitter = self.add("plane", size=2)
        emitter.instance_type = "VERTS"
        cube = self.add("cube", scale=(0.2, 0.2, 0.2))
        cube.parent = emitter
        places = [line.split("matrix = ")[1] for line in self.export().splitlines() if line.startswith("box")]
        self.assertEqual(sorted(places), sorted(
            f"((0.2, 0, 0, {x}), (0, 0.2, 0, {y}), (0, 0, 0.2, 0)) }}" for x in (-1, 1) for y in (-1, 1)))
        self.assertIn('polygon "Plane"', self.export())
        emitter.show_instancer_for_render = False
        self.assertNotIn('polygon "Plane"', self.export())

    def test_particles_that_are_objects(self):
        cube = self.add("cube", name="leaf", scale=(0.1, 0.1, 0.1), location=(0, 0, -9))
        plane = self.add("plane", name="field", size=4)
        bpy.ops.object.particle_system_add()
        settings = plane.particle_systems[0].settings
        settings.count, settings.frame_start, settings.frame_end, settings.lifetime = 20, 1, 1, 100
        settings.physics_type, settings.render_type, settings.instance_object = "NO", "OBJECT", cube
        settings.particle_size = 1
        self.scene.frame_set(2)
        self.assertEqual(self.export().count('box "field/leaf"'), 20)

    def test_geometry_nodes(self):
        group = bpy.data.node_groups.new("Scatter", "GeometryNodeTree")
        group.inputs.new("NodeSocketGeometry", "Geometry")
        group.outputs.new("NodeSocketGeometry", "Geometry")
        nodes, links = group.nodes, group.links
        start, end = nodes.new("NodeGroupInput"), nodes.new("NodeGroupOutput")
        points, cube = nodes.new("GeometryNodeInstanceOnPoints"), nodes.new("GeometryNodeMeshCube")
        paint = nodes.new("GeometryNodeSetMaterial")
        paint.inputs["Material"].default_value = self.material("scattered")
        links.new(start.outputs[0], points.inputs["Points"])
        links.new(cube.outputs["Mesh"], paint.inputs["Geometry"])
        links.new(paint.outputs[0], points.inputs["Instance"])
        links.new(points.outputs[0], end.inputs[0])
        plane = self.add("plane", name="field", size=3)
        plane.modifiers.new("Nodes", "NODES").node_group = group
        text = self.export()
        self.assertEqual(text.count('material = "scattered"'), 4)
        self.assertNotIn("polygon", text)

    def test_curves_and_texts_once(self):
        curve = bpy.data.curves.new("Path", "CURVE")
        curve.dimensions, curve.bevel_depth = "3D", 0.2
        spline = curve.splines.new("POLY")
        spline.points.add(2)
        for point, at in zip(spline.points, ((-2, 0, 0, 1), (0, 0, 1.5, 1), (2, 0, 0, 1))):
            point.co = at
        self.link(bpy.data.objects.new("Path", curve))
        text = bpy.data.curves.new("Text", "FONT")
        text.body, text.extrude = "glint", 0.2
        self.link(bpy.data.objects.new("Text", text)).rotation_euler = (1.2, 0, 0)
        ball = bpy.data.metaballs.new("Meta")
        ball.resolution = ball.render_resolution = 0.2
        ball.elements.new().co = (1, -1, 1)
        self.link(bpy.data.objects.new("Meta", ball))
        self.check_hits(step=3)
        exported = self.export(mesh_files=False)
        for name in ("Path", "Text", "Meta"):
            self.assertEqual(exported.count(f'group "{name}"'), 1, name)

    def test_a_curve_without_a_surface_is_nothing(self):
        curve = bpy.data.curves.new("Wire", "CURVE")
        curve.splines.new("POLY").points.add(3)
        self.link(bpy.data.objects.new("Wire", curve))
        self.assertNotIn("Wire", self.export())

    def test_negative_scale_keeps_fronts_outside(self):
        self.add("ico_sphere", subdivisions=2, scale=(-1, 1, 1))
        text = self.export()
        for line in text.splitlines():
            if line.startswith("triangle{"):
                values = [float(v) for v in line.replace("(", " ").replace(")", " ").replace(",", " ")
                          .removeprefix("triangle{vertices=").rstrip("}").split()]
                a, b, c = values[0:3], values[3:6], values[6:9]
                u, v = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
                n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
                self.assertGreater(sum(x * y for x, y in zip(n, a)), 0, line)

    def test_materials_of_slots_and_of_objects(self):
        a, b = self.material("first"), self.material("second")
        cube = self.add("cube", material=a)
        cube.data.materials.append(b)
        cube.data.polygons[0].material_index = 1
        cube.data.polygons[1].material_index = 17  # there is no such slot: the last one counts
        other = bpy.data.objects.new("other", cube.data)
        self.link(other).location = (3, 0, 0)
        other.material_slots[0].link = "OBJECT"
        other.material_slots[0].material = b
        text = self.export()
        groups = [line for line in text.splitlines() if line.startswith("group")]
        self.assertEqual(groups, ['group "Cube" { material = "first"', 'group "Cube" { material = "second"',
                                  'group "other" { material = "second"'])

    def test_invisible_to_the_camera_is_reported_once(self):
        for name in ("a", "b"):
            self.add("cube", name=name).visible_camera = False
        self.add("cube", name="catcher").is_shadow_catcher = True
        self.add("cube", name="hole").is_holdout = True
        text = self.export()
        self.assertNotIn('box "', text)
        for name in ("a", "b", "catcher", "hole"):
            self.assertEqual(sum(f"'{name}'" in w for w in self.warnings), 1, self.warnings)

    def test_excluded_collections_are_left_out(self):
        collection = bpy.data.collections.new("off")
        self.scene.collection.children.link(collection)
        cube = self.add("cube", name="excluded")
        self.scene.collection.objects.unlink(cube)
        collection.objects.link(cube)
        bpy.context.view_layer.layer_collection.children["off"].exclude = True
        self.assertNotIn("excluded", self.export())


class Shapes(SceneTest):
    def setUp(self):
        super().setUp()
        self.camera()
        self.lamp()

    def shape_word(self, ob):
        lines = [line for line in self.export().splitlines() if f'"{ob.name}"' in line]
        self.assertEqual(len(lines), 1, lines)
        return lines[0].split()[0]

    def test_auto(self):
        cases = (
            ("uv_sphere", True, {}, "sphere"), ("uv_sphere", False, {}, "group"),
            ("ico_sphere", True, {"subdivisions": 3}, "sphere"), ("ico_sphere", True, {"subdivisions": 1}, "group"),
            ("cylinder", True, {}, "cylinder"), ("cylinder", False, {}, "group"),
            ("cylinder", True, {"vertices": 12}, "group"),
            ("cylinder", True, {"end_fill_type": "NOTHING"}, "cylinder"),
            ("cone", True, {}, "cone"), ("cone", True, {"radius2": 0.5}, "cone"),
            ("circle", False, {"fill_type": "NGON", "vertices": 64}, "disc"),
            ("circle", False, {"fill_type": "TRIFAN", "vertices": 64}, "disc"),
            ("cube", False, {}, "box"), ("cube", True, {}, "group"), ("plane", False, {}, "polygon"),
            ("torus", True, {}, "mesh"), ("monkey", True, {}, "group"), ("grid", False, {}, "group"))
        for kind, smooth, settings, word in cases:
            with self.subTest(kind=kind, smooth=smooth, **settings):
                ob = self.add(kind, name="thing", smooth=smooth, **settings)
                self.assertEqual(self.shape_word(ob), word)
                bpy.data.objects.remove(ob)

    def test_recognised_shapes_hit_where_their_meshes_do(self):
        self.add("uv_sphere", smooth=True, segments=96, ring_count=48, location=(-1.5, 0, 1), scale=(0.8, 1, 0.6), rotation=(1, 0, 1))
        self.add("cylinder", smooth=True, vertices=128, location=(1.5, 0, 1), rotation=(0.5, 0.5, 0), scale=(0.5, 0.5, 1))
        self.add("cone", smooth=True, vertices=128, location=(0, -1.5, 0.8), scale=(0.6, -0.6, 0.8))
        self.add("cube", location=(0, 1.5, 0.8), scale=(0.6, 0.3, 0.8), rotation=(0.2, 0.4, 0.6))
        self.add("circle", vertices=256, fill_type="NGON", location=(0, 0, 0.2), scale=(0.7, 0.7, 0.7))
        self.check_hits(tolerance=0.01, step=4)

    def test_the_property_decides(self):
        ob = self.add("cube", name="thing")
        for value, word in (("SPHERE", "sphere"), ("CYLINDER", "cylinder"), ("CONE", "cone"), ("PLANE", "plane"),
                            ("DISC", "disc"), ("BOX", "box"), ("MESH", "group")):
            ob.glint_shape = value
            self.assertEqual(self.shape_word(ob), word)
        del ob["glint_shape"]
        ob["glint_shape"] = "CYLINDER"  # a custom property, as scripts set it
        self.assertEqual(self.shape_word(ob), "cylinder")

    def test_a_plane_is_infinite_only_by_the_property(self):
        plane = self.add("plane", name="thing", location=(0, 0, 1), rotation=(0.5, 0, 0))
        plane.glint_shape = "PLANE"
        self.assertEqual(self.shape_word(plane), "plane")
        part = self.layers("object")["object"]
        self.assertGreater(sum(v > 0 for v in part.channels["I"]), 0.5 * part.width * part.height)

    def test_what_deforms_stays_a_mesh(self):
        ball = self.add("uv_sphere", name="thing", smooth=True)
        ball.shape_key_add(name="Basis")
        ball.shape_key_add(name="Key").data[0].co.z = 3
        self.assertEqual(self.shape_word(ball), "group")

    def test_the_background_set_is_rendered(self):
        other = bpy.data.scenes.new("set")
        self.add("cube", name="Prop")
        prop = bpy.context.object
        self.scene.collection.objects.unlink(prop)
        other.collection.objects.link(prop)
        self.assertNotIn('"Prop"', self.export())
        self.scene.background_set = other
        self.assertIn('box "Prop"', self.export())

    def test_auto_smooth_that_splits_normals_is_not_a_sphere(self):
        ball = self.add("uv_sphere", name="thing", smooth=True)
        ball.data.use_auto_smooth, ball.data.auto_smooth_angle = True, math.radians(1)
        self.assertEqual(self.shape_word(ball), "group")

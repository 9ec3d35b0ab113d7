# SPDX-License-Identifier: Apache-2.0
"""The recognition of shapes: what is one, and what only resembles one."""
import math
import unittest

from io_glint.export import measure, shapes
from io_glint.export.shapes import Outline


def tube(sides, r0, r1, caps=True, height=2.0):
    vertices, faces = [], []
    for i in range(sides):
        c, s = math.cos(2 * math.pi * i / sides), math.sin(2 * math.pi * i / sides)
        vertices += [(r0 * c, r0 * s, 0.0), (r1 * c, r1 * s, height)]
    for i in range(sides):
        j = (i + 1) % sides
        faces.append((2 * i, 2 * j, 2 * j + 1, 2 * i + 1))
    smooth = [True] * len(faces)
    if caps:
        faces += [tuple(range(0, 2 * sides, 2))[::-1], tuple(range(1, 2 * sides, 2))]
        smooth += [False, False]
    return Outline(vertices, faces, smooth)


def ball(rings=16, segments=32, stretch=1.0, smooth=True):
    vertices, faces = [(0.0, 0.0, 1.0)], []
    for i in range(1, rings):
        for j in range(segments):
            a, b = math.pi * i / rings, 2 * math.pi * j / segments
            vertices.append((math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), stretch * math.cos(a)))
    vertices.append((0.0, 0.0, -1.0))
    last = len(vertices) - 1
    for j in range(segments):
        k = (j + 1) % segments
        faces.append((0, 1 + j, 1 + k))
        for i in range(rings - 2):
            a, b = 1 + i * segments, 1 + (i + 1) * segments
            faces.append((a + j, b + j, b + k, a + k))
        b = 1 + (rings - 2) * segments
        faces.append((b + j, last, b + k))
    return Outline(vertices, faces, [smooth] * len(faces))


def box(edges, origin=(0.0, 0.0, 0.0)):
    def at(i, j, k):
        return tuple(o + i * a + j * b + k * c for o, a, b, c in zip(origin, *edges))
    corners = [at(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return Outline(corners, faces, [False] * 6)


class Recognise(unittest.TestCase):
    def word(self, outline, **settings):
        found = shapes.recognise(outline, **settings)
        return found[0].word if found else None

    def test_spheres(self):
        self.assertEqual(self.word(ball()), "sphere")
        self.assertEqual(self.word(ball(smooth=False), any_shading=True), "sphere")
        for other in (ball(smooth=False), ball(stretch=1.001), ball(rings=4, segments=6)):
            self.assertIsNone(self.word(other))

    def test_half_a_sphere_is_none(self):
        whole = ball()
        half = Outline(whole.vertices, whole.faces[:len(whole.faces) // 2], whole.smooth[:len(whole.faces) // 2])
        self.assertIsNone(self.word(half))

    def test_one_dent_is_enough(self):
        dented = ball()
        dented.vertices[40] = tuple(0.99 * v for v in dented.vertices[40])
        self.assertIsNone(self.word(dented))

    def test_cylinders_and_cones(self):
        shape, _ = shapes.recognise(tube(32, 0.5, 0.5))
        self.assertEqual((shape.word, shape.get("caps"), shape.get("from"), shape.get("to")),
                         ("cylinder", True, (0, 0, 0), (0, 0, 2)))
        self.assertAlmostEqual(shape.get("radius"), 0.5)
        self.assertFalse(shapes.recognise(tube(32, 0.5, 0.5, caps=False))[0].get("caps"))
        self.assertEqual(self.word(tube(32, 0.5, 0.25)), "cone")
        for other in (tube(12, 0.5, 0.5), tube(32, 0.5, 0.5, caps=True, height=0.0)):
            self.assertIsNone(self.word(other))

    def test_a_cone_with_an_apex(self):
        n = 32
        ring = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n), -1.0) for i in range(n)]
        faces = [(i, (i + 1) % n, n) for i in range(n)] + [tuple(range(n))[::-1]]
        outline = Outline([*ring, (0.0, 0.0, 1.0)], faces, [True] * n + [False])
        shape, _ = shapes.recognise(outline)
        self.assertEqual((shape.word, shape.get("caps")), ("cone", True))
        self.assertAlmostEqual(shape.get("radius")[0], 1)
        self.assertEqual(shape.get("radius")[1], 0)
        outline.vertices[-1] = (0.1, 0.0, 1.0)  # it leans
        self.assertIsNone(self.word(outline))

    def test_a_tube_closed_at_one_end_is_none(self):
        bucket = tube(32, 0.5, 0.5)
        bucket.faces.pop(), bucket.smooth.pop()
        self.assertIsNone(self.word(bucket))

    def test_a_tube_with_a_missing_side_is_none(self):
        gutter = tube(32, 0.5, 0.5)
        del gutter.faces[3], gutter.smooth[3]
        self.assertIsNone(self.word(gutter))

    def test_flat_sides_are_none(self):
        prism = tube(32, 0.5, 0.5)
        prism.smooth = [False] * len(prism.faces)
        self.assertIsNone(self.word(prism))
        self.assertEqual(self.word(prism, any_shading=True), "cylinder")

    def test_boxes(self):
        shape, inner = shapes.recognise(box(((2.0, 0, 0), (0, 1.0, 0), (0, 0, 0.5)), (1.0, 1.0, 1.0)))
        self.assertEqual((shape.get("min"), shape.get("max"), inner), ((1, 1, 1), (3, 2, 1.5), None))
        shape, inner = shapes.recognise(box(((1.0, 1.0, 0), (-1.0, 1.0, 0), (0, 0, 3.0))))
        self.assertEqual((shape.word, shape.get("max")), ("box", (1, 1, 1)))
        columns = {tuple(row[i] for row in inner) for i in range(3)}
        self.assertEqual({tuple(map(abs, c)) for c in columns}, {(1, 1, 0), (0, 0, 3)})

    def test_leaning_boxes_are_none(self):
        self.assertIsNone(self.word(box(((1.0, 0, 0), (0.2, 1.0, 0), (0, 0, 1.0)))))
        open_box = box(((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0)))
        open_box.faces.pop(), open_box.smooth.pop()
        self.assertIsNone(self.word(open_box))

    def test_discs(self):
        n = 64
        ring = [(3 * math.cos(2 * math.pi * i / n), 3 * math.sin(2 * math.pi * i / n), 1.0) for i in range(n)]
        shape, _ = shapes.recognise(Outline(ring, [tuple(range(n))], [False]))
        self.assertEqual(shape.word, "disc")
        self.assertAlmostEqual(shape.get("radius"), 3)
        fan = Outline([*ring, (0.0, 0.0, 1.0)], [(i, (i + 1) % n, n) for i in range(n)], [False] * n)
        self.assertEqual(self.word(fan), "disc")
        self.assertIsNone(self.word(Outline(ring[::4], [tuple(range(n // 4))], [False])))

    def test_nothing(self):
        for outline in (Outline([], [], []), Outline([(0.0, 0.0, 0.0)] * 50, [(0, 1, 2)] * 90, [True] * 90)):
            self.assertIsNone(self.word(outline))


class Measure(unittest.TestCase):
    def test_every_kind_of_a_cube(self):
        cube = box(((2.0, 0, 0), (0, 2.0, 0), (0, 0, 2.0)), (-1.0, -1.0, -1.0))
        self.assertAlmostEqual(measure.measure("SPHERE", cube).get("radius"), math.sqrt(3))
        self.assertAlmostEqual(measure.measure("CYLINDER", cube).get("radius"), math.sqrt(2))
        self.assertEqual(measure.measure("BOX", cube).get("max"), (1, 1, 1))
        self.assertEqual(measure.measure("CONE", cube).word, "cone")
        self.assertEqual(measure.measure("PLANE", cube).get("normal"), (0, 0, 1))

    def test_what_has_no_extent(self):
        for kind in ("SPHERE", "CYLINDER", "CONE", "DISC"):
            self.assertIsNone(measure.measure(kind, Outline([(1.0, 1.0, 1.0)], [], [])))
            self.assertIsNone(measure.measure(kind, Outline([], [], [])))

    def test_a_plane_by_its_faces(self):
        quad = Outline([(0.0, 0, 0), (0.0, 1, 0), (0.0, 1, 1), (0.0, 0, 1)], [(0, 1, 2, 3)], [False])
        self.assertEqual(measure.measure("PLANE", quad).get("normal"), (1, 0, 0))

# SPDX-License-Identifier: Apache-2.0
"""Shapes that are added and removed one by one: pictures have the bytes of a new scene."""

import pickle
import statistics
import threading
import time

import numpy as np

import glint


def pixels(scene):
    return scene.render().array.tobytes()


def new(scene):
    """An equal scene that has not been rendered."""
    return pickle.loads(pickle.dumps(scene))


def cloud(random, count):
    scene = glint.Scene(size=(40, 30))
    scene.add(glint.Light("point", position=(5, 9, 7)))
    scene.camera.position = (0, 0, 6)
    scene.spheres(random.uniform(-1.5, 1.5, (count, 3)), 0.15, random.random((count, 3)))
    return scene


def some_shape(random, step):
    center, size = random.uniform(-1.5, 1.5, 3), 0.2
    material = glint.Material(color=random.random(3)) if step % 3 == 0 else None
    kinds = [
        lambda: glint.Sphere(center, size, material=material),
        lambda: glint.Cylinder(center, center + size, 0.1, material=material, color="gold"),
        lambda: glint.Box(center, center + size, transform=[[1, 0, 0, 0.1], [0.5, 1, 0, 0], [0, 0, 1, 0]]),
        lambda: glint.Plane((0, -2 - size, 0), (0.1, 1, 0)),
        lambda: glint.Triangle(center + np.eye(3) * size),
        lambda: glint.Polygon([center, center + (size, 0, 0), center + (size, size, 0), center + (0, size, 0)]),
        lambda: glint.Mesh(center + np.eye(3) * size, [(0, 1, 2)]),
    ]
    return kinds[step % len(kinds)]()


def change(scene, random, step):
    count = len(scene.shapes)
    what = random.integers(7)
    if what == 0:
        del scene.shapes[int(random.integers(count))]
    elif what == 1:
        del scene.shapes[random.choice(count, 5, replace=False)]
    elif what == 2:
        scene.add(some_shape(random, step))
    elif what == 3:
        scene.spheres(random.uniform(-1.5, 1.5, (4, 3)), 0.1, "orange" if step % 2 else None)
    elif what == 4:
        scene.shapes[:5].colors = random.random((5, 3))
    elif what == 5:
        scene.shapes[int(random.integers(count))].transform = [[1, 0, 0, 0], [0, 1, 0, random.random()], [0, 0, 1, 0]]
    else:
        scene.shapes[count - 1].color = random.random(3)


def test_random_changes():
    random = np.random.default_rng(11)
    scene = cloud(random, 150)
    scene.render()
    for step in range(150):
        for _ in range(random.integers(1, 5)):
            change(scene, random, step)
        if step % 10 == 5:
            scene = scene.copy()  # which shares the geometry
        assert pixels(scene) == pixels(new(scene)), step


def test_objects_and_names_keep_their_shapes():
    random = np.random.default_rng(12)
    scene = cloud(random, 100)
    ball = scene.add(glint.Sphere((0, 0, 1), 0.3, name="ball"))
    last = scene.shapes[99]
    scene.render()
    del scene.shapes[[3, 50, 7]]
    assert scene.shapes[97] is ball is scene.shapes["ball"] and scene.shapes[96] is last
    ball.radius, last.color = 0.4, (1, 0, 0)
    del scene.shapes[0]
    scene.shapes[95:].radii = [0.2, 0.5]
    assert (last.radius, ball.radius) == (0.2, 0.5) and scene.shapes[-1].name == "ball"
    assert pixels(scene) == pixels(new(scene))
    del scene.shapes["ball"]
    scene.add(ball)
    del scene.shapes[-1]
    assert len(scene.shapes) == 96 and pixels(scene) == pixels(new(scene))


def test_another_thread_renders():
    random = np.random.default_rng(13)
    scene = cloud(random, 300)
    is_over = threading.Event()
    failures = []

    def render():
        while not is_over.is_set():
            try:
                scene.render()
            except Exception as error:
                failures.append(error)

    threads = [threading.Thread(target=render) for _ in range(2)]
    for thread in threads:
        thread.start()
    for step in range(200):
        change(scene, random, step)
    is_over.set()
    for thread in threads:
        thread.join()
    assert not failures and pixels(scene) == pixels(new(scene))


def test_one_of_many_is_not_a_new_hierarchy():
    random = np.random.default_rng(14)
    scene = cloud(random, 200_000)
    scene.settings["size"] = (1, 1)
    scene.render()

    def seconds(edit):
        times = []
        for _ in range(5):
            edit()
            start = time.perf_counter()
            scene.render()
            times.append(time.perf_counter() - start)
        return statistics.median(times)

    def remove():
        del scene.shapes[1000]

    white = np.full((1, 1, 3), 255, np.uint8)
    whole = seconds(lambda: scene.add(glint.Texture(white)))  # after which everything is prepared
    assert seconds(lambda: scene.add(glint.Sphere((0, 0, 0), 0.1))) < 0.5 * whole
    assert seconds(remove) < 0.5 * whole

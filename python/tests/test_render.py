# SPDX-License-Identifier: Apache-2.0
"""Pictures: the same as the command's, prepared anew only where something has changed."""

import os
import resource
import shutil
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import glint
from conftest import ROOT

# Without what is a part of others.
SCENES = sorted(
    (path.relative_to(ROOT / "scenes"), scene_name)
    for path in (ROOT / "scenes").rglob("*.*")
    if path.parent.name != "parts" and not path.stem.startswith("only_")
    for scene_name in (("snowman", "pipes") if path.name == "two_scenes.js" else ("",))
)
COMMAND = os.environ.get("GLINT") or shutil.which("glint") or str(ROOT / "build" / "release" / "glint")


@pytest.mark.filterwarnings("ignore::glint.GlintWarning")
@pytest.mark.parametrize("name, scene_name", SCENES, ids=lambda value: str(value))
def test_same_pixels_as_the_command(name, scene_name, tmp_path):
    path = ROOT / "scenes" / name
    options = ["--scene", scene_name] if scene_name else []
    out = tmp_path / "out.exr"
    subprocess.run([COMMAND, "render", path, *options, "-s", "40x30", "-q", "-o", out], check=True)
    image = glint.load(path, size=(40, 30), scene_name=scene_name).render()
    assert np.array_equal(image.array, glint.Image.open(out).array)
    # The same by render()'s keyword.
    assert glint.load(path, scene_name=scene_name).render(size=(40, 30)) == image


def test_array_is_a_view(scene):
    image = scene.render()
    assert image.array.shape == (48, 64, 3) and image.array.dtype == np.float32
    assert image.array.base is not None
    image.array[0, 0] = (9, 8, 7)
    assert image.array[0, 0, 0] == 9
    array = scene.render().array  # outlives the Image
    assert array.sum() > 0


def test_keywords_of_the_command(scene):
    assert scene.render(size=(20, 10)).size == (20, 10)
    assert scene.render(size="20x10") == scene.render(size=(20, 10))
    assert scene.settings["size"] == (64, 48)
    plain = scene.render()
    for options in (
        dict(shading="phong"),
        dict(shadows=False),
        dict(aa=2),
        dict(aa="2:jitter"),
        dict(shading="normals"),
    ):
        assert scene.render(**options) != plain
    assert scene.render(aa="2:jitter", seed=7) != scene.render(aa="2:jitter")
    assert scene.render(convention={"pixel_sample": "corner"}) != plain
    crop = scene.render(crop=(10, 8, 20, 16))
    assert np.array_equal(crop.array, plain.array[16:24, 20:30])
    assert scene.render(threads=1) == plain and scene.render(isa="scalar") == plain
    with pytest.raises(glint.GlintError, match="phong"):
        scene.render(shading="fong")
    with pytest.raises(ValueError, match="no layer 'norml'"):
        scene.render(aov=["norml"])


def test_alpha(scene):
    scene.background = (0.2, 0.4, 0.6)
    plain, image = scene.render(aov="background"), scene.render(alpha=True)
    alpha = image.layers["alpha"]
    assert list(image.layers) == ["alpha"] and alpha.min() == 0 and alpha.max() == 1
    # The background is left out, and nothing else.
    assert np.array_equal(image.array, plain.array * alpha) and image != plain
    assert np.array_equal(plain.layers["background"], plain.array * (1 - alpha))
    png = image.to_bytes()
    assert png[25] == 6 and plain.to_bytes()[25] == 2  # the header's color type: with and without alpha
    scene.settings["alpha"] = True
    assert scene.render() == image and scene.render(alpha=False) == plain
    with pytest.raises(glint.GlintError, match="alpha"):
        image.to_bytes("ppm")


def test_the_scene_says_how_numbers_become_bytes(scene):
    plain, srgb = scene.render(), scene.render(convention={"transfer": "srgb"})
    assert plain == srgb and plain.to_bytes() != srgb.to_bytes()
    assert srgb.to_bytes() == plain.to_bytes(transfer="srgb") and srgb.to_bytes(transfer="none") == plain.to_bytes()
    scene.conventions["rounding"] = "down"
    assert scene.render().to_bytes() != plain.to_bytes()
    assert "rounded down" in str(glint.explain(scene, 3, 3))


def test_layers(scene):
    image = scene.render(aov="all")
    names = list(image.layers)
    assert names[:6] == ["background", "ambient", "diffuse", "specular", "reflection", "transmission"]
    assert names[6:9] == ["emission", "sky", "fog"]
    total = sum(image.layers[name] for name in names[1:9])
    assert np.allclose(total + image.layers["background"], image.array)
    assert image.layers["depth"].shape == (48, 64, 1)
    assert image.viewable("normal").size == (64, 48)
    assert list(scene.render(aov="depth,normal").layers) == ["depth", "normal"]


def test_one_light_alone(scene):
    scene.lights[0].name = "lamp"
    aov = ["light:none", "light:lamp"] + [f"light:{i + 2}" for i in range(len(scene.lights) - 1)]
    image = scene.render(aov=aov)
    assert image == scene.render()
    names = list(image.layers)
    assert names == ["light:none"] + [f"light:{i + 1}" for i in range(len(scene.lights))]
    assert np.allclose(sum(image.layers[name] for name in names), image.array, atol=1e-5)
    assert np.array_equal(image.layers["light:lamp"], image.layers["light:1"])
    assert np.array_equal(image.viewable("light:lamp").array, image.layers["light:1"])
    with pytest.raises(ValueError, match=r"no light 'lam'; there are 1 \(lamp\)"):
        scene.render(aov="light:lam")


def test_files(scene, tmp_path):
    image = scene.render()
    image.save(tmp_path / "a.tga")
    tga = (tmp_path / "a.tga").read_bytes()
    red, green, blue = image.to_bytes("ppm")[-3:]
    assert tga[:18] == bytes([0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 48, 0, 24, 32])
    assert tga[18 + 3 * (64 * 48 - 1):][:3] == bytes([blue, green, red])
    for name in ("a.png", "a.ppm"):
        image.save(tmp_path / name)
        assert np.abs(glint.Image.open(tmp_path / name).array - np.clip(image.array, 0, 1)).max() < 0.51 / 255
    image.save(tmp_path / "a.bmp")
    bmp = (tmp_path / "a.bmp").read_bytes()
    assert bmp[:2] == b"BM" and bmp[54 + 3 * 63:][:3] == bytes([blue, green, red])
    image.save(tmp_path / "a.jpg")
    assert np.abs(glint.Image.open(tmp_path / "a.jpg").array - np.clip(image.array, 0, 1)).mean() < 3 / 255
    image.save(tmp_path / "a.exr")
    assert glint.Image.open(tmp_path / "a.exr") == image
    assert image._repr_png_() == (tmp_path / "a.png").read_bytes()
    assert scene._repr_png_()[:4] == b"\x89PNG"
    with pytest.raises(ValueError, match="glint writes .png"):
        image.save(tmp_path / "a.gif")


def change_light(scene):
    scene.lights["key"].position = (-4, 5, 3)


def change_camera(scene):
    scene.camera.position = (1, 1, 5)


def change_material(scene):
    scene.materials["red"].color = (0, 1, 0)


def change_background(scene):
    scene.background = (0, 0, 1)


def change_setting(scene):
    scene.settings["shading"] = "phong"


def change_shape(scene):
    scene.shapes["ball"].radius = 1.5


def change_kind(scene):
    scene.shapes[0] = glint.Box((-1, -1, -1), (1, 1, 1))


def change_material_of_shape(scene):
    scene.shapes["floor"].material = glint.Material(color=(0, 0, 1))


def add_shape(scene):
    scene.add(glint.Sphere((1, 1, 1), 0.5))


def add_light(scene):
    scene.add(glint.Light("ambient", color=(0.5, 0.5, 0.5)))


def remove_shape(scene):
    del scene.shapes[0]


@pytest.mark.parametrize(
    "change",
    [change_light, change_camera, change_material, change_background, change_setting, change_shape,
     change_kind, change_material_of_shape, add_shape, add_light, remove_shape],
)  # fmt: skip
def test_a_change_shows_in_the_next_picture(scene, change):
    before = scene.render()
    change(scene)
    after = scene.render()
    assert after != before
    fresh = scene.copy()
    fresh = glint.loads(scene.to_glint())
    assert fresh.render() == after


def test_changes_of_shading_rebuild_nothing():
    scene = glint.Scene(size=(8, 8))
    random = np.random.default_rng(1)
    scene.spheres(random.random((300_000, 3)), 0.001, (1, 0, 0))
    light = scene.add(glint.Light("point", position=(3, 3, 3)))
    start = time.perf_counter()
    scene.render()
    first = time.perf_counter() - start
    start = time.perf_counter()
    for i in range(5):
        light.position = (3, 3, i)
        scene.camera.position = (0, 0, 5 + i)
        scene.materials[0].color = (0, 1, 0.1 * i)
        scene.render()
    assert (time.perf_counter() - start) / 5 < first / 10


def test_progress_and_exceptions_in_it(scene):
    seen = []
    scene.render(size=(64, 48), progress=seen.append)
    assert seen[-1] == 1 and seen == sorted(seen)

    def fail(fraction):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        scene.render(size=(3000, 3000), aa=8, progress=fail)


@pytest.mark.parametrize("size, aa, after", [(2000, 32, 0.5), (4000, 64, 0.05)])
def test_ctrl_c_stops_within_a_second(size, aa, after):
    """Also while the memory of a large picture is claimed, and within a tile of many samples."""
    code = (
        "import glint, signal, time\n"
        f"scene = glint.load({str(ROOT / 'scenes/epfl/mirror_room.json')!r})\n"
        "print('ready', flush=True)\n"
        "try:\n"
        f"    scene.render(size=({size}, {size}), aa={aa})\n"
        "except KeyboardInterrupt:\n"
        "    print('stopped', flush=True)\n"
    )
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "ready\n"
    time.sleep(after)
    start = time.monotonic()
    process.send_signal(signal.SIGINT)
    assert process.stdout.readline() == "stopped\n"
    assert time.monotonic() - start < 1
    process.stdout.close()
    assert process.wait() == 0


def test_the_gil_is_released(scene):
    """Another thread counts while a picture is rendered."""
    counted = 0
    stop = threading.Event()

    def count():
        nonlocal counted
        while not stop.is_set():
            counted += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.monotonic()
    scene.render(size=(1500, 1500), aa=3)
    seconds = time.monotonic() - start
    stop.set()
    thread.join()
    assert counted > 20 * seconds


def test_edits_from_another_thread():
    scene = glint.load(ROOT / "scenes/cgfs/three_spheres.cgfs", size=(200, 200))
    errors = []

    def render():
        try:
            for _ in range(25):
                scene.render()
        except Exception as error:
            errors.append(error)

    threads = [threading.Thread(target=render) for _ in range(3)]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        scene.lights[0].intensity = 0.5
        scene.shapes[0].radius += 0.001
        scene.spheres(np.random.default_rng(1).random((10, 3)), 0.1, (1, 1, 0))
        scene.camera.position += (0.001, 0, 0)
        del scene.shapes[-1]
    for thread in threads:
        thread.join()
    assert not errors
    assert glint.loads(scene.to_glint()).render(size=(64, 64)) == scene.render(size=(64, 64))


def test_memory_does_not_grow(scene):
    def render(times):
        for i in range(times):
            scene.lights[0].position = (4, 5, i)
            scene.render(size=(16, 16)).array.sum()
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    before = render(500)
    assert render(1000) - before < 4096  # kilobytes

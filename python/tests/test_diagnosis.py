# SPDX-License-Identifier: Apache-2.0
"""Another ray tracer beside a scene: its log, and what is wrong with it."""

import math

import numpy as np
import pytest

import glint
from conftest import ROOT

SPHERE = ROOT / "examples" / "trace_log" / "diffuse_sphere.glint"
WIDTH, HEIGHT = 64, 48
PIXELS = [(20, 18), (40, 18), (28, 30), (2, 2)]


def unit(a):
    return a / np.sqrt((a * a).sum(-1, keepdims=True))


def camera_rays():
    """For all pixels at once: origin, and unit directions of height x width x 3."""
    y, x = np.mgrid[:HEIGHT, :WIDTH] + 0.5
    half = math.tan(math.radians(25))
    directions = np.stack([(x / WIDTH - 0.5) * 2 * half, (0.5 - y / HEIGHT) * 2 * half * HEIGHT / WIDTH, -np.ones_like(x)], -1)
    return np.array([0.0, 0, 4]), unit(directions)


def render_arrays(log, normal=1.0, compact=False):
    """One diffuse sphere with NumPy. compact: of the hits alone, as rows. normal: a factor of N, the mistake."""
    origin, direction = camera_rays()
    b = direction @ origin
    root = b * b - (origin @ origin - 1)
    hit = root >= 0
    t = -b - np.sqrt(np.where(hit, root, 0))
    color = np.zeros((HEIGHT, WIDTH, 3))
    if compact:
        rows = np.flatnonzero(hit)
        direction, t = direction[hit], t[hit]
        with log.ray("camera", where=~hit):
            log.value("miss")
        ray = log.ray("camera", rows=rows)
    else:
        ray = log.ray("camera")
        log.value("miss", where=~hit)
    with ray, log.where(True if compact else hit):
        log.value("origin", origin)
        log.value("direction", direction)
        log.value("shape", 1)
        log.value("t", t)
        p = origin + t[..., None] * direction
        n = normal * unit(p)
        to_light = unit(np.array([3.0, 4, 5]) - p)
        n_l = (n * to_light).sum(-1)
        log.value("N", n)
        log.light(1)
        log.value("L", to_light)
        log.value("N.L", n_l)
        diffuse = np.maximum(n_l, 0)[..., None] * np.array([0.9, 0.5 * 0.9, 0.2 * 0.8])
        log.value("diffuse", diffuse)
    if not compact:
        color[hit] = diffuse[hit]
    return color


@pytest.mark.parametrize("compact", [False, True])
def test_arrays_without_a_mistake(compact):
    with glint.TraceLog(PIXELS, (WIDTH, HEIGHT)) as log:
        render_arrays(log, compact=compact)
    answer = glint.diagnose(SPHERE, log)
    assert answer.findings == [] and answer.judged > 20 and answer.pixels == 4
    assert "Nothing differs" in str(answer)


@pytest.mark.parametrize("compact", [False, True])
def test_the_mistake_of_arrays_is_named(compact):
    with glint.TraceLog(PIXELS, (WIDTH, HEIGHT)) as log:
        render_arrays(log, normal=2.0, compact=compact)
    (finding,) = glint.diagnose(SPHERE, log).findings
    # A normal of another length shows in the cosine.
    assert finding.quantity == "N.L" and finding.sure and finding.pixels == 3
    assert [cause["id"] for cause in finding.causes] == ["normal-not-unit"]


def render_loop(log, wrong_sign=False):
    origin, directions = camera_rays()
    for y in range(HEIGHT):
        for x in range(WIDTH):
            log.pixel(x, y)
            with log.ray("camera"):
                d = directions[y, x]
                log.value("direction", d)
                b = d @ origin
                root = b * b - 15
                if root < 0:
                    log.value("miss")
                    continue
                t = -b + math.sqrt(root) if wrong_sign else -b - math.sqrt(root)
                log.value("t", t)
                log.value("P", origin + t * d)


def test_a_loop_over_pixels(tmp_path):
    path = tmp_path / "mine.log"
    with glint.TraceLog("20,18;40,18;28,30;2,2", size=(WIDTH, HEIGHT), path=path) as log:
        render_loop(log, wrong_sign=True)
    assert path.read_text() == log.text
    answer = glint.diagnose(SPHERE, path)
    assert answer.findings[0].quantity == "t" and answer.findings[0].causes[0]["id"] == "far-root"
    assert answer.findings[0].sure
    tree = answer.tree(40, 18)
    assert "! t " in tree and "camera ray" in tree
    with pytest.raises(KeyError):
        answer.tree(3, 3)


def test_pixels_are_proposed_and_logged():
    scene = glint.load(SPHERE)
    picture = np.array(scene.render())
    assert glint.propose_pixels(scene, picture) == []
    picture[10:30, 20:30] *= 0.5
    proposed = glint.propose_pixels(scene, picture)
    assert 2 < len(proposed) <= 12 and {p.kind for p in proposed} > {"equal"}
    assert all(p.difference <= 1 for p in proposed if p.kind == "equal")
    log = glint.TraceLog(proposed, (WIDTH, HEIGHT))
    log.ray("camera")
    log.value("t", 1.0)
    assert log.text.count("pixel ") == len(proposed)


def test_a_size_of_its_own():
    """The log is of another size than the scene."""
    log = glint.TraceLog([(0, 0)], (32, 24))
    log.pixel(0, 0)
    log.ray("camera")
    log.value("miss")
    assert glint.diagnose(SPHERE, log).outside == 0


def test_values_that_no_log_has():
    log = glint.TraceLog([(2, 1)], (4, 3))
    with pytest.raises(ValueError, match=r"shape \(5, 2\): expected 3 x 4 or 12 rows"):
        log.value("t", np.zeros((5, 2)))
    with pytest.raises(ValueError, match=r"end\(\) without ray"):
        log.end()
    with pytest.raises(ValueError, match="pixel 9,9 is not in a picture of 4x3"):
        glint.TraceLog([(9, 9)], (4, 3))
    with pytest.raises(ValueError, match="expected pairs"):
        glint.TraceLog("1;2", (4, 3))
    with log.ray("camera", rows=[6, 0, 1]), pytest.raises(ValueError, match=r"\(3, 1\)"):
        log.value("t", [1.0, 2, 3])


def test_the_log_of_arrays_has_the_pixels_entries():
    log = glint.TraceLog([(2, 1)], (4, 3))
    with log.ray("camera"):
        log.value("t", np.arange(12).reshape(3, 4) + 0.5)
        log.value("N", np.arange(36.0).reshape(12, 3))
        log.value("L", (0, 1, 0))
        with log.ray("mirror", rows=[3, 6]):
            log.value("t", np.array([8, 9], np.float32))
        with log.ray("mirror", where=np.zeros((3, 4), bool)):
            log.value("t", np.zeros((3, 4)))
    assert log.text.splitlines() == [
        "size 4 3", "pixel 2 1", "ray camera", "t 6.5", "N 18 19 20", "L 0 1 0", "ray mirror", "t 9", "end", "end",
    ]  # fmt: skip


def test_a_log_that_cannot_be_read(tmp_path):
    path = tmp_path / "bad.log"
    path.write_text("pixel 1 1\nray camera\nt 1 2 3 4\n")
    with pytest.raises(glint.GlintError, match=r"bad.log:3"):
        glint.diagnose(SPHERE, path)
    with pytest.raises(FileNotFoundError):
        glint.diagnose(SPHERE, tmp_path / "none.log")

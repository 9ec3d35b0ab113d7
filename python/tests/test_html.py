# SPDX-License-Identifier: Apache-2.0
"""What notebooks show: HTML of explanations, comparisons, gradings and scenes."""

import base64
import html.parser
import io
import pickle
import re

import numpy as np
import pytest

import glint

NASTY = "<script>alert(1)</script>\"' & </td> \x1b[31m\x00"


class Page(html.parser.HTMLParser):
    """Its text, pictures and widths of bars; refuses what a notebook's output must not have."""

    def __init__(self, content):
        super().__init__()
        self.open, self.text, self.pictures, self.bars = [], "", [], []
        self.feed(content)
        self.close()
        assert self.open == []
        assert not re.search("[\x00-\x08\x0b-\x1f]", content)

    def handle_starttag(self, tag, attributes):
        allowed = "div span b hr table thead tbody tr th td pre details summary img".split()
        assert tag in allowed, tag
        for name, value in attributes:
            assert name in ("style", "src", "width", "height", "alt"), name
            assert "url(" not in value or name == "alt"
            if name == "src":
                assert value.startswith("data:image/png;base64,")
                self.pictures.append(glint.Image.open(io.BytesIO(base64.b64decode(value.split(",")[1]))).to_uint8())
            if name == "style" and value.startswith("width:") and "%" in value:
                self.bars.append(float(re.match(r"width:([\d.]+)%", value)[1]))
        if tag not in ("img", "hr"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text += data + " "


@pytest.fixture
def named():
    scene = glint.Scene(size=(64, 48), background=(0, 0, 1))
    scene.add(glint.Sphere((0, 0, 0), 1, material=glint.Material(color=(0.8, 0.4, 0.2), name=NASTY), name=NASTY))
    scene.add(glint.Light("point", position=(3, 4, 5), name=NASTY))
    scene.add(glint.Light("point", position=(-3, -4, -5), name="behind"))
    scene.camera.position = (0, 0, 5)
    return scene


def test_explanation(named):
    explanation = glint.explain(named, 36, 20)
    page = Page(explanation._repr_html_())
    assert "<script>alert(1)</script>\"' & </td> \ufffd[31m\ufffd" in page.text
    assert "Pixel 36,20" in page.text and "bytes " + " ".join(map(str, explanation.bytes)) in page.text
    assert "behind the surface" in page.text and explanation.text.split("\n")[-3] in page.text
    overview, close = page.pictures
    assert overview.shape == (48 * 4, 64 * 4, 3) and close.shape == (25 * 8, 33 * 8, 3)
    # The pixel's own square, within a white frame and a black one; the part begins at 36 - 16, 20 - 12.
    top, left = 12 * 8, 16 * 8
    assert (close[top:top + 8, left:left + 8] == explanation.bytes).all()
    for side in (close[top - 1, left - 1:left + 9], close[top - 1:top + 9, left + 8]):
        assert (side == 255).all()
    assert (close[top - 2, left - 2:left + 10] == 0).all()
    assert (overview[20 * 4 + 2, 36 * 4 + 2] == named.render(aa=1).to_uint8()[20, 36]).all()
    assert (overview == 255).all(axis=2).sum() == 4 * 10


def test_bars_are_the_terms(named):
    named.lights.append(glint.Light("ambient", color=0.5))
    explanation = glint.explain(named, 36, 20)
    bars = Page(explanation._repr_html_()).bars
    layers = [explanation.layers["ambient"], explanation.layers["diffuse"], explanation.value]
    expected = 100 * np.array(layers) / max(explanation.value)
    assert np.array(bars[:9]) == pytest.approx(expected.ravel(), abs=0.01)
    # Below them the ambient term and the one light that adds, whose largest number is full.
    hit = explanation.rays[0].hit
    expected = 100 * np.array([hit.ambient, hit.lights[0].diffuse]) / hit.lights[0].diffuse[0]
    assert np.array(bars[9:]) == pytest.approx(expected.ravel(), abs=0.01)


def test_samples_of_lights_and_pixels(named):
    named.lights = [glint.Light("parallelogram", position=(-3, 4, 5), side_u=(1, 0, 0), side_v=(0, 1, 0), samples_u=3, samples_v=3)]
    page = Page(glint.explain(named, 36, 20, aa=2)._repr_html_())
    assert "the mean of 2 x 2 samples" in page.text and "sample 1,1" in page.text
    assert "9 of 9 samples add" in page.text and page.text.count("parallelogram light") >= 1
    assert "sample 1,0 hits" in Page(glint.explain(named, 36, 20, aa=2, sample=1)._repr_html_()).text
    named.lights = [glint.Light("directional", to_light=(0, 0, 1), color=0.01 * (i + 1)) for i in range(20)]
    page = Page(glint.explain(named, 32, 24)._repr_html_())
    assert "4 more lights" in page.text and "directional light 20" in page.text


def test_pixels_at_the_border_and_small_pictures(named):
    for x, y in ((0, 0), (63, 47), (63, 0)):
        page = Page(glint.explain(named, x, y)._repr_html_())
        assert len(page.pictures) == 2 and "hits nothing" in page.text
    page = Page(glint.explain(named, 0, 1, size="1x2")._repr_html_())
    assert [picture.shape[1] for picture in page.pictures] == [132, 132]


def test_a_scene_that_was_changed_has_no_picture(named):
    explanation = glint.explain(named, 36, 20, shading="diffuse", convention={"limit": "drop"})
    assert len(Page(explanation._repr_html_()).pictures) == 2
    unpickled = pickle.loads(pickle.dumps(explanation))
    page = Page(unpickled._repr_html_())
    assert page.pictures == [] and page.bars and unpickled.data == explanation.data
    named.lights[0].position = (-3, 4, 5)
    page = Page(explanation._repr_html_())
    assert page.pictures == [] and "the scene has been changed" in page.text and page.bars
    named.camera.look_at = named.camera.position
    assert "There is no picture: the camera is at the point" in Page(explanation._repr_html_()).text


def test_numbers_that_no_bar_shows():
    from glint import _html

    assert Page(_html.color_bars((float("nan"), float("inf"), -1), 1)).bars == [0, 0, 0]
    assert Page(_html.color_bars((2, 0.25, 0), 0.5)).bars == [100, 50, 0]
    assert _html.largest([(float("nan"), 0, -1)]) == 1
    assert "rgb(0,0,255)" in _html.swatch((float("nan"), -1, 7))


def test_comparison(scene):
    good = scene.render()
    comparison = glint.compare(scene.render(shadows=False), good, scene)
    page = Page(comparison._repr_html_())
    assert len(page.pictures) == 3 and (page.pictures[1] == good.to_uint8()).all()
    assert page.pictures[2].max() == 255 and "(reference)" in page.text
    assert comparison.causes[0].explanation in page.text
    assert page.bars[0] == pytest.approx(100 * comparison.data["all"]["within"] / (64 * 48), abs=0.01)
    assert pickle.loads(pickle.dumps(comparison))._repr_html_() == comparison._repr_html_()
    assert "The pictures are identical" in Page(glint.compare(good, good)._repr_html_()).text
    large = scene.render(size=(600, 30))
    assert Page(glint.compare(large, large)._repr_html_()).pictures[0].shape == (10, 200, 3)
    both = glint.versus(scene, {"shading": "phong"}, {"shading": "blinn-phong"})
    assert len(Page(both._repr_html_()).pictures) == 7


def test_gradings(scene, tmp_path):
    class_ = {NASTY: scene.render(), "bob": scene.render(shadows=False), "eve": tmp_path / "none.png"}
    graded = glint.grade(class_, scene)
    assert isinstance(graded, list) and isinstance(graded, glint.Grades)
    page = Page(graded._repr_html_())
    assert "<script>" in page.text and graded[1].parts[0].explanation in page.text and "none.png" in page.text
    assert page.bars == pytest.approx([100 * one.points for one in graded], abs=0.01)
    assert Page(graded[1]._repr_html_()).bars == pytest.approx([100 * graded[1].points], abs=0.01)
    rubric = tmp_path / "rubric"
    rubric.write_text("Shadows 4 *shadow*.png without shadows=false\nDiffuse 2 *diffuse*.png shading=diffuse\n")
    files = {"ada": {"shadow.png": scene.render(), "diffuse.png": scene.render(shading="diffuse")}, "bob": {}}
    graded = glint.grade(files, scene, rubric=rubric)
    page = Page(graded._repr_html_())
    assert page.bars == [100, 100, 100, 0, 0, 0] and "6 of 6" in page.text and "no file *diffuse*.png" in page.text
    assert pickle.loads(pickle.dumps(graded)) == graded
    assert "no submissions" in Page(glint.Grades()._repr_html_()).text


def test_scene(named):
    page = Page(named._repr_html_())
    assert (page.pictures[0] == named.render().to_uint8()).all()
    assert "<script>alert(1)</script>" in page.text and "sphere: 1" in page.text and "64 x 48" in page.text
    bundle = named._repr_mimebundle_()
    assert bundle["text/html"] == named._repr_html_() and bundle["image/png"] == named._repr_png_()
    named.spheres(np.zeros((3000, 3)), 0.1)
    named.settings["size"] = (1000, 500)
    page = Page(named._repr_html_())
    assert "3,001" in page.text and page.pictures[0].shape == (160, 320, 3)
    for i in range(20):
        named.add(glint.Light("ambient", name=f"light {i}"))
    assert "and 10 more" in Page(named._repr_html_()).text
    named.camera.look_at = named.camera.position
    assert "There is no picture: the camera" in Page(named._repr_html_()).text
    assert "image/png" not in named._repr_mimebundle_()

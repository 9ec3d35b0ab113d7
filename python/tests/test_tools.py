# SPDX-License-Identifier: Apache-2.0
"""Reading, explaining, checking, comparing and grading."""

import json
import subprocess
import sys
import warnings

import numpy as np
import pytest

import glint
from conftest import ROOT
from test_render import COMMAND

CASTLE = ROOT / "scenes" / "epfl" / "castle.json"


def test_errors_have_places(tmp_path):
    path = tmp_path / "bad.cgfs"
    path.write_text("sphere {\n  radius = 1\n  center = (0, oops, 3)\n}\n")
    with pytest.raises(glint.GlintError) as caught:
        glint.load(path)
    error = caught.value
    assert error.code == "parse"
    first = error.diagnostics[-1]
    assert (first.file, first.line, first.column) == (str(path), 3, 16)
    assert "found 'oops'" in first.message and "^~~~" in str(first)
    assert f"{path}:3:16" in str(error)
    with pytest.raises(FileNotFoundError):
        glint.load(tmp_path / "none.json")


def test_memory_errors_say_what_is_needed():
    with pytest.raises(MemoryError, match=r"a.pov:1:\d+: .* more than 4 MiB of memory"):
        glint.loads("union { #while(1) sphere { 0, 1 } #end }", "povray", name="a.pov", max_memory=4 << 20)
    # In a process of its own, whose memory is limited whatever the machine has.
    code = (
        "import resource, glint\n"
        "resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))\n"
        f"scene = glint.load({str(CASTLE)!r})\n"
        "try: scene.render(size=(65536, 65536))\n"
        "except MemoryError as error: print(error)"
    )
    said = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, check=True).stdout
    assert said == "out of memory: 65536x65536 pixels need 48 GiB\n"


def test_what_glint_does_not_render_is_left_out_if_asked_for(tmp_path):
    text = "blob { } blob { threshold .5 } sphere { 0, 1 }"
    with pytest.raises(glint.GlintError, match="does not render `blob`") as caught:
        glint.loads(text + " sphere { 0 }", "povray")
    assert [one.can_skip for one in caught.value.diagnostics] == [True, False]
    with pytest.warns(UserWarning, match="left out 2 objects that glint does not render: `blob`"):
        scene = glint.loads(text, "povray", skip_unsupported=True)
    assert len(scene.shapes) == 1
    (tmp_path / "a.pov").write_text(text)
    with pytest.warns(UserWarning, match="left out 2 objects"):
        assert glint.load(tmp_path / "a.pov", skip_unsupported=True) == scene


def test_errors_of_a_scene_made_in_code_name_the_item():
    scene = glint.Scene()
    scene.add(glint.Sphere((0, 0, 0), 1))
    scene.camera.look_at = scene.camera.position
    with pytest.raises(glint.GlintError) as caught:
        scene.render(size=(4, 4))
    assert caught.value.code == "invalid_scene"
    assert caught.value.diagnostics[0].item == "camera"


def test_a_failed_picture_can_be_mended(scene):
    good = scene.render()
    scene.camera.look_at = scene.camera.position
    with pytest.raises(glint.GlintError):
        scene.render()
    scene.camera.look_at = (0, 0, 0)
    assert scene.render() == good


def test_warnings_point_at_the_caller():
    scene = glint.Scene(size=(4, 4))
    scene.add(glint.Sphere((0, 0, -3), 1))
    with pytest.warns(glint.GlintWarning, match="light") as caught:
        scene.render()
    assert caught[0].filename == __file__
    assert caught[0].message.diagnostic.severity == "warning"
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        scene.render()  # each is issued once


def test_includes(tmp_path):
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "ball.glint").write_text("camera { position = (0, 0, 5)  look_at = (0, 0, 0)  fov_x = 50 }\nsphere { center = (0, 0, 0) radius = 1 }\n")
    main = tmp_path / "main.glint"
    main.write_text('include "parts/ball.glint"\nlight { type = ambient color = (1, 1, 1) }\n')
    assert len(glint.load(main).shapes) == 1
    main.write_text('include "parts/none.glint"\n')
    with pytest.raises(glint.GlintError, match="no such file"):
        glint.load(main)


POV = """#include "ball.inc"
camera { location <0, 0, -5> look_at 0 }
light_source { <4, 5, -3>, rgb 1 area_light <1, 0, 0>, <0, 1, 0>, 2, 2 }
object { Ball texture { pigment { rgbt <1, 0, 0, 0.25> } } }
fog { fog_type 1 distance 9 rgb 0.5 }
"""
DAT = """Begin_Scene
Resolution 40 30
Camera Zoom 1 Aspectratio 1 Antialiasing 0 Raydepth 5 Center 0 0 -5 Viewdir 0 0 1 Updir 0 1 0 End_Camera
Directional_Light Direction 0 0 1 Color 1 1 1
Background 0 0 0.5
Sphere Center 0 0 0 Rad 1 Texture Ambient 0.25 Diffuse 0.75 Specular 0 Opacity 0.5 Color 1 0.5 0 TexFunc 0
End_Scene
"""


@pytest.mark.filterwarnings("ignore::glint.GlintWarning")
def test_formats_of_other_ray_tracers(tmp_path):
    (tmp_path / "library").mkdir()
    main = tmp_path / "main.pov"
    main.write_text(POV)
    with pytest.raises(glint.GlintError, match="no such file"):
        glint.load(main, format="povray")
    (tmp_path / "library" / "ball.inc").write_text("#declare Ball = sphere { 0, 1 }\n")
    scene = glint.load(main, format="povray", size=(40, 30), include_path=tmp_path / "library")
    assert scene == glint.load(
        main, format="povray", size=(40, 30), include_path=[str(tmp_path / "none"), str(tmp_path / "library")]
    )
    assert scene.profile == "povray" and scene.fog.density == pytest.approx(1 / 9)
    assert scene.lights[0].kind == "parallelogram" and scene.lights[0].samples_u == 2
    assert scene.shapes[0].material.transmit == 0.25
    # A file beside the scene comes before the folders.
    (tmp_path / "ball.inc").write_text("#declare Ball = sphere { 0, 2 }\n")
    assert glint.load(main, format="povray", include_path=tmp_path / "library").shapes[0].radius == 2

    molecule = glint.loads(DAT, "tachyon")
    assert molecule.profile == "tachyon" and molecule.conventions["rounding"] == "down"
    assert molecule.shapes[0].kind == "sphere" and molecule.background == (0, 0, 0.5)
    (tmp_path / "molecule.dat").write_text(DAT)
    (tmp_path / "ball.inc").unlink()
    for file, options, read in (
        (main, ["--format", "povray", "-s", "40x30", "--include-path", "library"], scene),
        ("molecule.dat", [], molecule),
    ):
        subprocess.run([COMMAND, "render", file, *options, "-q", "-o", "c.tga"], check=True, cwd=tmp_path)
        assert read.render().to_bytes("tga") == (tmp_path / "c.tga").read_bytes()


@pytest.mark.parametrize("aa", ["3", "2:jitter", "adaptive:3:0.05", "9"])
def test_explains_samples_as_the_command_does(aa):
    scene = glint.load(CASTLE, size=(64, 64))
    for x, y in ((5, 5), (32, 40)):
        text = subprocess.run(
            [COMMAND, "explain", CASTLE, "-s", "64x64", "-p", f"{x},{y}", "--aa", aa, "--seed", "3"],
            check=True, stdout=subprocess.PIPE, text=True,
        ).stdout  # fmt: skip
        explanation = glint.explain(scene, x, y, aa=aa, seed=3)
        assert str(explanation) == text
    n = int(aa.replace("adaptive:", "")[0])
    assert len([ray for ray in explanation.rays if ray.kind == "camera"]) == n * n
    assert "sample 1,0" in glint.explain(scene, 32, 40, aa=2, sample=1).text
    with pytest.raises(IndexError):
        glint.explain(scene, 32, 40, aa=2, sample=4)


def test_explanations_fold_faint_rays():
    path = ROOT / "scenes" / "glint" / "glass.glint"
    scene = glint.load(path, size=(640, 480))
    for fold in (0.5, 0):
        text = subprocess.run(
            [COMMAND, "explain", path, "-s", "640x480", "-p", "320,240", "--fold", str(fold)],
            check=True, stdout=subprocess.PIPE, text=True,
        ).stdout  # fmt: skip
        assert glint.explain(scene, 320, 240, fold=fold).text == text
    folded, whole = glint.explain(scene, 320, 240), glint.explain(scene, 320, 240, fold=0)
    assert folded.data == whole.data and len(folded.text) < len(whole.text)
    with pytest.raises(ValueError, match="fold must be 0 or more"):
        glint.explain(scene, 320, 240, fold=-1)


def test_explains_as_the_command_does():
    scene = glint.load(CASTLE, size=(640, 640))
    explanation = glint.explain(scene, 320, 350)
    text = subprocess.run(
        [COMMAND, "explain", CASTLE, "-s", "640x640", "-p", "320,350"], check=True, stdout=subprocess.PIPE, text=True
    ).stdout
    assert str(explanation) == text
    ray = explanation.rays[0]
    assert ray.kind == "camera" and ray.hit.shape.kind == "cylinder"
    light = ray.hit.lights[0]
    assert light.reason == "adds" and isinstance(light.to_light, glint.Vec3)
    whole = ray.hit.ambient + sum((t.diffuse + t.specular for t in ray.hit.lights), glint.Color(0, 0, 0))
    assert np.allclose(whole, explanation.value, atol=1e-6)
    # The layers that add up to the picture.
    assert dict(explanation.layers).keys() == set(list(scene.render(size=(2, 2), aov="all").layers)[:9])
    with pytest.raises(AttributeError, match="there is no 'hits'"):
        ray.hits
    with pytest.raises(glint.GlintError):
        glint.explain(scene, 640, 0)


def test_explains_with_other_settings(scene):
    assert "N·H" in glint.explain(scene, 30, 20).text
    assert "R·V" in glint.explain(scene, 30, 20, shading="phong").text
    assert scene.settings["shading"] == "blinn-phong"


def test_checks():
    findings = glint.check(ROOT / "scenes" / "faults" / "black.glint")
    assert findings and findings[0].diagnostic.line > 0
    assert findings[0].remedy in str(findings[0])


def test_compares(scene):
    good = scene.render()
    scene.lights["key"].specular_color = 0
    bad = scene.render()
    scene.lights["key"].specular_color = 1
    comparison = glint.compare(bad, good, scene)
    assert not comparison.identical and comparison.all.pixels == 64 * 48
    assert comparison.causes[0].explained > 0.9
    assert comparison.difference.array.max() == 1
    assert "against" in str(comparison)
    assert glint.compare(good, good.array).identical
    with pytest.raises(glint.GlintError):
        glint.compare(good, scene.render(size=(4, 4)))


def test_view_of_a_mesh(tmp_path):
    path = tmp_path / "a.stl"
    path.write_text(
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex -1 0 0\nvertex 1 0 0\nvertex 0 0 2\nendloop\nendfacet\nendsolid a\n"
    )
    pictures = [glint.load(path, size=(20, 20), view=view).render() for view in (None, "iso", (2, 2.0, 2))]
    assert pictures[1] == pictures[2] != pictures[0]
    with pytest.raises(ValueError, match="expected front, iso or"):
        glint.load(path, view="back")
    with pytest.raises(glint.GlintError, match="only meshes without a camera have a view"):
        glint.load(CASTLE, view="front")


def test_versus_and_convert(scene, tmp_path):
    result = glint.versus(scene, {"shading": "phong"}, {"shading": "blinn-phong"})
    assert result.a == scene.render(shading="phong") and result.b == scene.render()
    assert "R·V" in result.explanations[0].text
    profiles = glint.versus(scene, {"profile": "cgfs"}, {"profile": "epfl"})
    assert profiles.a.size == scene.settings["size"]
    glint.convert(CASTLE, tmp_path / "castle.glint")
    size = (32, 32)
    assert glint.load(tmp_path / "castle.glint").render(size=size) == glint.load(CASTLE).render(size=size)
    with pytest.warns(glint.GlintWarning, match="glTF has no ambient light"):
        glint.convert(CASTLE, tmp_path / "castle.glb")
    assert len(glint.load(tmp_path / "castle.glb").shapes) > 10
    with pytest.warns(glint.GlintWarning):
        assert scene.to_bytes("gltf").startswith(b'{"asset":')
    with pytest.raises(ValueError, match="glint writes .glint, .glb, .gltf"):
        glint.convert(CASTLE, tmp_path / "castle.obj")
    with pytest.raises(glint.GlintError, match="expected one of the formats"):
        scene.to_bytes("obj")


def test_grades_pictures(scene, tmp_path):
    good, dark = scene.render(), scene.render(shadows=False)
    good.save(tmp_path / "ada.png")
    dark.save(tmp_path / "bob.png")
    (tmp_path / "eve.png").write_bytes(b"nothing")
    ada, bob, eve = glint.grade(tmp_path, scene)
    assert (ada.name, ada.points) == ("ada.png", 1)
    assert bob.points < 1 and bob.parts[0].cause == "shadows-missing"
    assert eve.points == 0 and eve.parts[0].error
    same = glint.grade({"ada": good, "bob": dark}, reference=good)
    assert [s.points == 1 for s in same] == [True, False]


def test_grades_by_a_rubric(scene, tmp_path):
    rubric = tmp_path / "rubric"
    rubric.write_text("Shadows 4 *shadow*.png without shadows=false\nDiffuse 2 *diffuse*.png shading=diffuse\n")
    class_ = {
        "ada": {"shadow.png": scene.render(), "diffuse.png": scene.render(shading="diffuse")},
        "bob": {"shadow.png": scene.render(shadows=False)},
    }
    ada, bob = glint.grade(class_, scene, rubric=rubric)
    assert ada.points == 6
    assert bob.points < 4 and bob.parts[1].error == "no file *diffuse*.png"
    assert bob.parts[0].cause == "shadows-missing"


def test_points_are_the_commands(tmp_path):
    """Of a class in which one program lacks the ambient term, and one picture is missing, is too small or not readable."""
    rubric, size = ROOT / "docs" / "rt2.rubric", (96, 72)
    scene, faulty = glint.load(CASTLE, size=size), glint.load(CASTLE, size=size)
    for material in faulty.materials:
        material.ambient = 0.0
    plain = {"shadows": False, "reflections": 0}
    parts = {
        "diffuse": {"shading": "diffuse", **plain},
        "phong": {"shading": "phong", **plain},
        "Blinn": plain,
        "shadows": {"reflections": 0},
        "reflections": {},
    }
    class_ = tmp_path / "class"
    for name, drawn in ("ada", scene), ("ben", faulty):
        (class_ / name).mkdir(parents=True)
        for part, settings in parts.items():
            drawn.render(**settings).save(class_ / name / f"castle_{part}.png")
    (class_ / "ada" / ".castle_ambient.png").write_bytes(b"hidden")
    (class_ / "ada" / "castle_ambient.png").write_bytes(b"nothing")
    scene.render(size=(20, 20)).save(class_ / "ben" / "castle_shadows.png")
    out = tmp_path / "grades.json"
    subprocess.run(
        [COMMAND, "grade", class_, "--scene", CASTLE, "--size", "96x72", "--rubric", rubric, "--json", out, "-q"],
        check=True,
        stdout=subprocess.PIPE,
    )
    expected = json.loads(out.read_text())
    graded = glint.grade(class_, scene, rubric=rubric)
    assert [s.name for s in graded] == [s["name"] for s in expected] == ["ada", "ben"]
    for ours, theirs in zip(graded, expected):
        assert ours.points == theirs["total"]
        for part, other in zip(ours.parts, theirs["parts"]):
            assert (part.name, part.points, part.most) == (other["part"], other["points"], other["of"])
            assert part.points_alone == other["points_alone"] and list(part.followed) == other["followed"]
            assert part.cause == (other["cause"]["name"] if other["cause"] else None)
            assert bool(part.error) == ("error" in other)
    ben = graded[1]
    assert ben.parts[6].followed == ("ambient-missing",) and ben.parts[6].points == 20 > ben.parts[6].points_alone
    assert graded[0].parts[1].points == 15 and graded[0].parts[0].points == 0
    files = {s.name: {p.name: p for p in (class_ / s.name).iterdir()} for s in graded}
    assert glint.grade(files, scene, rubric=rubric) == graded


def test_a_text_includes_only_files_of_its_folders(tmp_path):
    (tmp_path / "scene").mkdir()
    (tmp_path / "parts").mkdir()
    for name in ("scene/a.glint", "parts/b.glint"):
        (tmp_path / name).write_text(
            "camera { position = (0, 0, -4) look_at = (0, 0, 0) fov_x = 50 } light { type = ambient }\n"
            "sphere { center = (0, 0, 4) radius = 1 }"
        )
    name = str(tmp_path / "scene" / "s.glint")
    assert len(glint.loads('include "a.glint"', name=name).shapes) == 1
    for outside in ("../parts/b.glint", str(tmp_path / "parts" / "b.glint"), "../none.glint"):
        with pytest.raises(glint.GlintError, match="is outside the folders"):
            glint.loads(f'include "{outside}"', name=name)
    assert len(glint.loads('include "b.glint"', name=name, include_path=tmp_path / "parts").shapes) == 1
    with pytest.raises(glint.GlintError, match="no files are read here"):
        glint.loads('include "a.glint"', name=name, includes=False)


def test_messages_and_texts_do_not_control_a_terminal(tmp_path):
    with pytest.raises(glint.GlintError) as caught:
        glint.loads("sphere { }", name="a\x1b[31m.glint")
    assert "\x1b" not in str(caught.value)


def test_parts_of_answers_show_their_values(scene):
    terms = glint.explain(scene, 32, 24).rays[0].hit.lights[0]
    shown = repr(terms)
    assert f"reason={terms.reason!r}, " in shown and f"n_l={terms.n_l!r}" in shown and "light=..., " in shown
    assert f"diffuse={terms.diffuse!r}" in shown

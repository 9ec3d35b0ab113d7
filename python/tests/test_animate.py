# SPDX-License-Identifier: Apache-2.0
"""Films."""

import io
import os
import shutil
import struct
import subprocess
import sys

import numpy as np
import pytest

import glint
from glint._apng import _chunks


@pytest.fixture
def frames():
    """A white square that moves on a gradient; the last two are equal."""
    ground = np.zeros((20, 30, 3), np.uint8) + np.arange(0, 240, 8, dtype=np.uint8)[:, None]
    pictures = [ground.copy() for _ in range(5)]
    for i, picture in enumerate(pictures):
        picture[4:9, 3 * min(i, 3):3 * min(i, 3) + 5] = 255
    return pictures


def decoded(path):
    content = path if isinstance(path, io.BytesIO) else io.BytesIO(path.read_bytes())
    image = pytest.importorskip("PIL.Image").open(content)
    read, durations = [], []
    for i in range(image.n_frames):
        image.seek(i)
        read.append(np.asarray(image.convert("RGB")))
        durations.append(image.info["duration"])
    return image, read, durations


def test_png_has_the_pixels(frames, tmp_path):
    path = tmp_path / "film.png"
    glint.animate(frames, path, fps=20)
    image, read, durations = decoded(path)
    assert len(read) == 5 and all((a == b).all() for a, b in zip(read, frames))
    assert durations == [50.0] * 5 and image.info["loop"] == 0 and image.format == "PNG"
    # The second frame has only what differs from the first, and the first is a PNG of its own.
    content = path.read_bytes()
    at = content.index(b"fcTL", content.index(b"IDAT"))
    assert struct.unpack_from(">IIIII", content, at + 4) == (1, 8, 5, 0, 4)
    assert (glint.Image.open(path).to_uint8() == frames[0]).all()


@pytest.mark.parametrize("fps, delay", [(25, (1, 25)), (29.97, (100, 2997)), (0.01, (100, 1)), (1000, (1, 1000)), (0.3, (10, 3))])
def test_delays_of_png(frames, fps, delay):
    file = io.BytesIO()
    glint.animate(frames[:1], file, fps=fps, format="apng", loop=3)
    chunks = _chunks(file.getvalue())
    assert struct.unpack_from(">HH", chunks[b"fcTL"], 20) == delay
    assert struct.unpack(">II", chunks[b"acTL"]) == (1, 3)


def test_png_keeps_alpha(scene):
    file = io.BytesIO()
    rendered = [scene.render(alpha=True), scene.render(alpha=True, shading="phong")]
    glint.animate(rendered, file, format="apng")
    image, _, _ = decoded(file)
    image.seek(1)
    assert (np.asarray(image.convert("RGBA")) == np.asarray(rendered[1].to_pil())).all()
    with pytest.raises(ValueError, match=r"frames\[1\]: expected all frames with alpha, or none"):
        glint.animate([rendered[0], scene.render()], file, format="apng")


@pytest.mark.parametrize("loop, stored", [(True, 0), (False, None), (1, None), (4, 3)])
def test_gif(frames, tmp_path, loop, stored):
    path = tmp_path / "film.gif"
    glint.animate(frames[:4], path, fps=30, loop=loop)
    image, read, durations = decoded(path)
    assert len(read) == 4 and all(np.abs(a.astype(int) - b).max() <= 4 for a, b in zip(read, frames))
    # 30 frames a second: 0.03 s or 0.04 s each, and 0.13 s together.
    assert set(durations) == {30, 40} and sum(durations) == 130
    assert image.info.get("loop") == stored


def test_colors_of_gif(root):
    """Small golden roofs before a large blue sky stay golden: Pillow's own choice of 256 colors is wrong by 80."""
    picture = glint.load(root / "scenes" / "epfl" / "castle.json", size=(320, 240)).render().to_uint8()
    file = io.BytesIO()
    glint.animate([picture], file, format="gif")
    read = np.asarray(pytest.importorskip("PIL.Image").open(file).convert("RGB"))
    assert np.abs(read.astype(int) - picture).max() <= 16


def test_kinds_of_frames(frames, tmp_path):
    image = pytest.importorskip("PIL.Image")
    glint.Image(frames[2]).save(tmp_path / "frame.png")
    mixed = [glint.Image(frames[0]), image.fromarray(frames[1]), tmp_path / "frame.png", frames[3].astype(float) / 255]
    glint.animate(mixed, str(tmp_path / "film.apng"))
    _, read, _ = decoded(tmp_path / "film.apng")
    assert all((a == b).all() for a, b in zip(read, frames))
    glint.animate(np.array(frames), tmp_path / "array.png")
    assert (decoded(tmp_path / "array.png")[1][3] == frames[3]).all()


def test_turntables_and_progress(scene, frames, tmp_path):
    done = []
    glint.animate(scene.turntable(4, size=(20, 10)), tmp_path / "turn.png", progress=done.append)
    assert done == [0.25, 0.5, 0.75, 1.0]
    assert len(decoded(tmp_path / "turn.png")[1]) == 4
    # A generator does not tell its length.
    done.clear()
    glint.animate((frame for frame in frames), tmp_path / "turn.png", progress=done.append, total=5)
    assert done == [0.2, 0.4, 0.6, 0.8, 1.0]
    done.clear()
    glint.animate((frame for frame in frames), tmp_path / "turn.png", progress=done.append)
    assert done == [1.0]


def test_frames_are_asked_for_one_after_the_other(scene, tmp_path):
    rendered = []

    def film():
        for i in range(3):
            scene.lights["key"].position = (i, 5, 3)
            rendered.append(i)
            yield scene.render()

    glint.animate(film(), tmp_path / "film.png", progress=lambda fraction: rendered.append("done"), total=3)
    assert rendered == [0, "done", 1, "done", 2, "done"]


def test_the_old_file_stays(frames, tmp_path):
    path = tmp_path / "film.png"
    path.write_bytes(b"old")

    def broken():
        yield frames[0]
        raise RuntimeError("broken")

    with pytest.raises(RuntimeError, match="broken"):
        glint.animate(broken(), path)
    with pytest.raises(ValueError, match=r"^frames\[2\]: expected 30x20 pixels as the first, found 29x20$"):
        glint.animate([*frames[:2], frames[2][:, 1:]], path)
    assert path.read_bytes() == b"old" and os.listdir(tmp_path) == ["film.png"]


FAKE = """#!{python}
import sys
data = sys.stdin.buffer.read({limit})
if {status}:
    print("first", file=sys.stderr)
    print("no such encoder", file=sys.stderr)
    sys.exit({status})
open(sys.argv[-1], "wb").write(repr(sys.argv[1:]).encode() + b"|" + data)
"""


def make_ffmpeg(folder, monkeypatch, status=0, limit=-1):
    """A program in its place, which writes what it gets."""
    program = folder / "ffmpeg"
    program.write_text(FAKE.format(python=sys.executable, status=status, limit=limit))
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder}{os.pathsep}{os.environ['PATH']}")


def test_mp4_by_ffmpeg(frames, tmp_path, monkeypatch):
    make_ffmpeg(tmp_path, monkeypatch)
    glint.animate(frames, tmp_path / "film.mp4", fps=30)
    arguments, _, pixels = (tmp_path / "film.mp4").read_bytes().partition(b"|")
    assert pixels == np.array(frames).tobytes()
    for option in (b"'-s', '30x20'", b"'-framerate', '30.0'", b"'-pix_fmt', 'rgb24'", b"'-f', 'mp4'", b"'yuv420p'"):
        assert option in arguments
    file = io.BytesIO()
    glint.animate(frames, file, format="mp4")
    assert file.getvalue().endswith(pixels)


if shutil.which("ffmpeg"):  # which is none of the packages that the tests need

    def test_mp4_of_ffmpeg_itself(scene, tmp_path):
        """Of odd sides, the last lines are repeated."""
        pictures = [scene.render(size=(65, 49), shadows=on).to_uint8() for on in (True, False)]
        glint.animate(pictures, tmp_path / "film.mp4", fps=12)
        arguments = ["-v", "error", "-i", tmp_path / "film.mp4", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
        decoded = subprocess.run(["ffmpeg", *arguments], check=True, stdout=subprocess.PIPE).stdout
        shown = np.frombuffer(decoded, np.uint8).reshape(2, 50, 66, 3)
        wanted = np.pad(pictures, ((0, 0), (0, 1), (0, 1), (0, 0)), mode="edge")
        assert np.abs(shown - wanted.astype(float)).mean() < 3
        assert np.abs(shown - wanted[::-1].astype(float)).mean() > 3


@pytest.mark.parametrize("limit", [-1, 10])
def test_errors_of_ffmpeg(frames, tmp_path, monkeypatch, limit):
    make_ffmpeg(tmp_path, monkeypatch, status=3, limit=limit)
    large = np.zeros((300, 400, 3), np.uint8)
    with pytest.raises(glint.GlintError, match="^ffmpeg ended with status 3: no such encoder$") as caught:
        glint.animate([large] * 10, tmp_path / "film.mp4")
    assert caught.value.code == "io" and not (tmp_path / "film.mp4").exists()


def test_what_is_missing_is_said_before_a_frame_is_rendered(tmp_path, monkeypatch):
    def never():
        raise AssertionError("a frame was asked for")
        yield

    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(glint.GlintError, match="MP4 is written by the program ffmpeg, which is not in PATH"):
        glint.animate(never(), tmp_path / "a.mp4")
    monkeypatch.setitem(sys.modules, "PIL", None)
    monkeypatch.setitem(sys.modules, "PIL.Image", None)
    with pytest.raises(ImportError, match="GIF is written by Pillow, which is not installed"):
        glint.animate(never(), tmp_path / "a.gif")


@pytest.mark.parametrize(
    "arguments, options, error, message",
    [
        (([],), {}, ValueError, "frames: expected at least one picture, found none"),
        (("a.png",), {}, TypeError, "frames: expected several pictures, such as a list of images, found 'a.png'"),
        ((3,), {}, TypeError, "frames: expected several pictures"),
        ((glint.Scene(),), {}, TypeError, "frames: expected several pictures"),
        ((np.zeros((4, 4, 3)),), {}, TypeError, "frames: expected several pictures"),
        (([3],), {}, ValueError, "frames[0]: a picture is an array of height x width x 3 numbers, found one number"),
        (([np.zeros((2, 2, 3))],), dict(fps=0), ValueError, "fps: expected a number from 0.01 to 1000, found 0"),
        (([np.zeros((2, 2, 3))],), dict(fps=float("nan")), ValueError, "fps: expected a number from 0.01 to 1000, found nan"),
        (([np.zeros((2, 2, 3))],), dict(fps="25"), TypeError, "fps: expected a number, found '25'"),
        (([np.zeros((2, 2, 3))],), dict(loop=0), ValueError, "loop: expected True, False or a number from 1 to 65535, found 0"),
        (([np.zeros((2, 2, 3))],), dict(loop="no"), TypeError, "loop: expected True or False or a whole number, found 'no'"),
        (([np.zeros((2, 2, 3))],), dict(format="webm"), ValueError, "format: expected 'gif', 'apng' or 'mp4', found 'webm'"),
        (([np.zeros((2, 2, 3))], 3), {}, TypeError, "path: expected a string or a path, found 3"),
        (([np.zeros((2, 2, 3))], "a.avi"), {}, ValueError, "'a.avi': glint writes films as .gif, .png, .apng and .mp4"),
        (([np.zeros((2, 2, 3))], io.BytesIO()), {}, ValueError, "format: expected 'gif', 'apng' or 'mp4' for a file object"),
        (([np.zeros((2, 2, 3))], "a.gif"), dict(fps=60), ValueError, "fps: a GIF has at most 50, found 60"),
    ],
)
def test_refuses(arguments, options, error, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    frames, path = arguments if len(arguments) == 2 else (*arguments, "film.png")
    with pytest.raises(error) as raised:
        glint.animate(frames, path, **options)
    assert str(raised.value).startswith(message)
    assert os.listdir(tmp_path) == []

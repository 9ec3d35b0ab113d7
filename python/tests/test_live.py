# SPDX-License-Identifier: Apache-2.0
"""Live views, as their page asks them."""

import base64
import copy
import gc
import json
import os
import pickle
import re
import signal
import socket
import subprocess
import sys
import threading
import time
import webbrowser

import numpy as np
import pytest

import glint
from glint import _live_engine
from live_page import ask, picture


def test_pictures_are_those_of_render(view, scene, opened):
    assert opened == [view.url] and view.scene is scene
    scene.settings["aa"] = 3
    assert (picture(view) == scene.render().to_uint8()).all()
    assert (picture(view, moving=True) == scene.render(aa=1).to_uint8()).all()


def test_an_orbit_moves_the_camera(view, scene):
    wanted = scene.camera.__copy__().orbit(30, 10)
    shown = picture(view, right=30, up=10)
    assert scene.camera == wanted and (shown == scene.render().to_uint8()).all()
    before = np.linalg.norm(scene.camera.position)
    picture(view, nearer=0.5)
    assert np.linalg.norm(scene.camera.position) == pytest.approx(before * np.exp(-0.5))
    scene.camera.projection, scene.camera.width = "orthographic", 4
    picture(view, nearer=-0.5)
    assert scene.camera.width == pytest.approx(4 * np.exp(0.5))
    for nearer in [10] * 20 + [-10] * 20:
        picture(view, nearer=nearer)
    assert 1e-13 < scene.camera.width < 1e13


def test_the_camera_that_frames_a_scene_stays_where_it_was_moved(opened):
    scene = glint.Scene(glint.Sphere(), glint.Light("ambient"), size=(40, 30))
    view = scene.live(size=(60, 20))
    framed = scene.camera.__copy__()
    assert picture(view, right=20).shape == (20, 60, 3)
    scene.add(glint.Sphere((9, 0, 0), 3))
    assert scene.camera != framed and scene.render() and scene.camera == framed.orbit(20)
    view.close()


def test_a_click_explains_that_pixel(view, scene):
    status, headers, content = ask(view, "explain", x=36, y=20)
    assert (status, headers["Content-Type"]) == (200, "text/html; charset=utf-8")
    assert content.decode() == glint.explain(scene, 36, 20)._repr_html_() and "Pixel 36,20" in content.decode()
    status, _, content = ask(view, "explain", x=64, y=0)
    assert status == 422 and b"64" in content


@pytest.mark.parametrize(
    "request_, message",
    [
        ({"right": "1"}, "right: expected a number from -1e+06 to 1e+06, found '1'"),
        ({"up": float("nan")}, "up: expected a number"),
        ({"nearer": 1e9}, "nearer: expected a number from -10 to 10"),
        ({"values": [1]}, "values: expected numbers of sliders"),
        ({"values": {"1": 1}}, "values: expected numbers of sliders"),
        ({"values": {"0": True}}, "0: expected a number"),
        ({"page": -1}, "page: expected a number"),
    ],
)
def test_wrong_requests_of_a_page_change_nothing(view, scene, request_, message):
    camera = scene.camera.__copy__()
    status, _, content = ask(view, "picture", **request_)
    assert status == 400 and message in content.decode() and scene.camera == camera


def test_a_scene_that_cannot_be_rendered_says_so(view, scene):
    scene.camera.look_at = scene.camera.position
    status, _, content = ask(view, "picture")
    assert status == 422 and b"the camera" in content
    with pytest.raises(glint.GlintError, match="the camera"):
        scene.live()


def wait_for(is_true):
    end = time.monotonic() + 60
    while not is_true():
        assert time.monotonic() < end
        time.sleep(0.01)


@pytest.fixture
def slow(view, scene):
    """The answers to a picture that takes long, of page 1, which is being rendered."""
    scene.settings["size"] = (1500, 1500)
    scene.settings["aa"] = 16
    answers = []
    thread = threading.Thread(target=lambda: answers.append(ask(view, "picture", page=1)))
    thread.start()
    wait_for(lambda: view._engine._busy)
    yield lambda: thread.join() or answers[0][0]


def test_the_newest_picture_of_a_page_wins(view, slow):
    assert picture(view, page=1, moving=True).shape == (1500, 1500, 3)
    assert slow() == 204


def test_the_view_gives_way_to_the_user(view, scene, slow):
    def is_rendering():
        if scene._rendering.lock.acquire(blocking=False):
            scene._rendering.lock.release()
            return False
        return True

    wait_for(is_rendering)
    scene.render(size=(64, 48), aa=1)
    assert slow() == 503


def test_renders_of_the_view_and_of_the_user_take_turns(view, scene):
    """And both have the scene as it is."""
    wanted = [scene.render(reflections=n).to_uint8() for n in (0, 1)]
    shown = []

    def show(page):
        answer = (503,)
        while answer[0] == 503:  # as the page does
            answer = ask(view, "picture", page=page)
        shown.append(answer[2])

    threads = [threading.Thread(target=show, args=(page,)) for page in range(6)]
    for thread in threads:
        thread.start()
    for n in range(20):
        scene.lights[0].name = f"key {n}"
        assert (scene.render(reflections=n % 2).to_uint8() == wanted[n % 2]).all()
    for thread in threads:
        thread.join()
    assert shown == [scene.render().to_uint8().tobytes()] * 6


@pytest.mark.parametrize(
    "work",
    [
        lambda scene: scene.render(),
        lambda scene: scene.cast((0, 0, 5), (0, 0, -1)),
        lambda scene: glint.check(scene),
        lambda scene: glint.explain(scene, 1, 1),
        lambda scene: glint.propose_pixels(scene, np.zeros((48, 64, 3))),
    ],
    ids=["render", "cast", "check", "explain", "propose_pixels"],
)
def test_what_prepares_the_scene_waits_for_its_turn(view, scene, work):
    with scene._rendering:
        waiting = threading.Thread(target=work, args=(scene,))
        waiting.start()
        waiting.join(0.2)
        assert waiting.is_alive()
    waiting.join()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
@pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning")
def test_a_forked_process_renders_while_the_view_does(scene, opened):
    view = scene.live()
    wanted = scene.render()
    with scene._rendering, view._engine._changed:
        view._engine._busy += 1

        ended = []

        def fork():  # on a thread that does not have the turn
            child = os.fork()
            if child == 0:
                os._exit(7 if scene.render() == wanted and not _live_engine._engines else 1)
            ended.append(os.WEXITSTATUS(os.waitpid(child, 0)[1]))

        thread = threading.Thread(target=fork, daemon=True)
        thread.start()
        thread.join(60)
        view._engine._busy -= 1
    assert ended == [7]
    view.close()


def test_a_view_is_not_pickled(view, scene):
    for call in (pickle.dumps, copy.copy):
        with pytest.raises(TypeError, match="a live view cannot be copied or pickled"):
            call(view)
    assert pickle.loads(pickle.dumps(scene)).render() == scene.copy().render() == scene.render()


def test_refresh_and_close_reach_the_page(view):
    answers = []
    waiting = threading.Thread(target=lambda: answers.append(ask(view, "changes", version=0)))
    waiting.start()
    wait_for(lambda: view._engine._changed._waiters)
    assert answers == []
    view.refresh()
    waiting.join()
    assert json.loads(answers[0][2])["version"] == 1
    waiting = threading.Thread(target=lambda: answers.append(ask(view, "changes", version=1)))
    waiting.start()
    wait_for(lambda: view._engine._changed._waiters)
    view.close()
    waiting.join()
    assert answers[1][0] == 410


def port_is_free(url):
    port = int(re.search(r":(\d+)/", url)[1])
    with socket.socket() as probe:
        probe.settimeout(1)
        return probe.connect_ex(("127.0.0.1", port)) != 0


def test_closing_frees_the_port(scene, opened):
    view = scene.live()
    assert not port_is_free(view.url) and not view.closed and view.url in repr(view)
    view.close()
    view.close()
    view.wait()
    assert port_is_free(view.url) and view.closed and "closed" in repr(view)
    assert "The live view is closed." in view._repr_mimebundle_()["text/html"]


def test_garbage_collection_closes(scene, opened):
    url = scene.live().url
    gc.collect()
    end = time.monotonic() + 30
    while not port_is_free(url) and time.monotonic() < end:
        time.sleep(0.05)
    assert port_is_free(url)


def test_the_end_of_a_program_closes_while_it_renders():
    program = """
import glint, json, threading, time, urllib.request, webbrowser
webbrowser.open = lambda address: True
scene = glint.Scene(glint.Sphere(), size=(1500, 1500))
view = scene.live(size=(1500, 1500))
scene.settings["aa"] = 32
for page in range(3):
    body = json.dumps({"page": page}).encode()
    threading.Thread(target=urllib.request.urlopen, args=(view.url + "picture", body), daemon=True).start()
time.sleep(0.3)
"""
    ended = subprocess.run([sys.executable, "-W", "ignore", "-c", program], capture_output=True, text=True, timeout=60)
    assert (ended.returncode, ended.stderr) == (0, "")


@pytest.mark.skipif(sys.platform == "win32", reason="this system has no SIGINT for one process")
def test_a_program_waits_until_it_is_interrupted():
    program = """
import glint, webbrowser
webbrowser.open = lambda address: True
view = glint.Scene(glint.Sphere(), size=(8, 6)).live()
print(view.url, flush=True)
view.wait()
print(view.closed)
"""
    arguments = [sys.executable, "-W", "ignore", "-c", program]
    with subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline().startswith("http://127.0.0.1:")
        time.sleep(1)
        assert process.poll() is None
        process.send_signal(signal.SIGINT)
        assert process.communicate(timeout=60) == ("True\n", "") and process.returncode == 0


@pytest.mark.parametrize("works", [True, False])
def test_without_a_browser_the_address_is_named(scene, opened, monkeypatch, works):
    if works:
        for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER"):
            monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(webbrowser, "open", lambda address: False)
    with pytest.warns(glint.GlintWarning, match="its address is http://127.0.0.1:") as caught:
        view = scene.live()
    assert caught[0].filename == __file__ and view.url in str(caught[0].message)
    view.close()


def test_the_output_of_a_cell(view, scene):
    bundle = view._repr_mimebundle_()
    found = re.search(r'src="data:image/png;base64,([^"]+)"', bundle["text/html"])
    assert base64.b64decode(found[1]) == bundle["image/png"] == scene.render().to_bytes()
    assert "Python runs on another computer" in bundle["text/html"] and f"frame.src = '{view.url}'" in bundle["text/html"]
    assert bundle["text/plain"] == repr(view)
    scene.camera.look_at = scene.camera.position
    assert view._repr_mimebundle_()["image/png"] == bundle["image/png"]

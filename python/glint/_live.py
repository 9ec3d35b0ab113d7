# SPDX-License-Identifier: Apache-2.0
"""A live view of a scene: a page that asks Python for pictures."""

from __future__ import annotations

import contextlib
import secrets
import threading
import webbrowser
import weakref
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple

from . import _html
from ._errors import GlintError, warn_of
from ._expect import Closed, expect
from ._live_engine import LiveEngine
from ._live_server import LiveServer
from ._progress import _is_notebook
from ._sliders import Sliders, to_sliders
from ._turns import Turns
from ._window import _has_display

if TYPE_CHECKING:
    from ._scene import Scene


def _stop(engine: LiveEngine, server: LiveServer) -> None:
    server.stop()
    engine.close()


# Shows the frame once its page has said that it is there. A kernel on another computer, a closed view and an exported
# notebook keep the picture.
_SCRIPT = """
(() => {
    const [frame, still] = ['live', 'still'].map((part) => document.getElementById('glint-' + part + '-ID'));
    addEventListener('message', (event) => {
        if (!frame || event.source !== frame.contentWindow || !event.data || !(event.data.height > 0)) return;
        frame.style.display = 'block';
        frame.style.height = Math.min(event.data.height, 4000) + 'px';
        still.style.display = 'none';
    });
    if (frame) frame.src = 'URL';
})();
"""


class LiveView(Closed):
    """A live view, which Scene.live() makes. It is closed by close(), when nothing refers to it, and when Python ends."""

    def __init__(self, scene: Any, size: Optional[Tuple[int, int]], sliders: Optional[Sliders]) -> None:
        self._engine = LiveEngine(scene, size, to_sliders(sliders))
        if not isinstance(scene._rendering, Turns):
            scene._rendering = Turns()
        self._still = scene.render(size=size)  # what cannot be rendered is refused here
        actions = {name: getattr(self._engine, name) for name in ("picture", "explain", "changes")}
        self._server = LiveServer(actions)
        self._finalizer = weakref.finalize(self, _stop, self._engine, self._server)

    @property
    def scene(self) -> Scene:
        """The scene itself, not a copy: its camera is where the view has been moved to."""
        scene: Scene = self._engine.scene
        return scene

    @property
    def url(self) -> str:
        """The page's address. Whoever knows it, on this computer, can use the view."""
        return self._server.url

    @property
    def closed(self) -> bool:
        """Whether it is closed."""
        return self._engine.is_closed

    def refresh(self) -> None:
        """Has the page render the scene again, after a change from Python."""
        self._engine.refresh()

    def close(self) -> None:
        """Ends the server and frees its port. The page keeps its last picture."""
        self._finalizer()
        if threading.current_thread() is not self._server.thread:
            self._server.thread.join(10)

    def wait(self) -> None:
        """Waits until the view is closed, or Ctrl-C closes it: for programs, whose end would end the view."""
        try:
            while self._server.thread.is_alive():
                self._server.thread.join(0.5)
        except KeyboardInterrupt:
            self.close()

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> Dict[str, Any]:
        """The page in a frame, and a picture for where there is none."""
        still = self._still
        if not self.closed:
            with contextlib.suppress(GlintError, MemoryError):  # the page says what is wrong
                still = self.scene.render(size=self._engine.size)
        picture = _html.picture(still.to_uint8(), "the scene")
        if self.closed:
            content = _html.page(picture, "<div>The live view is closed.</div>")
        else:
            name, url = secrets.token_hex(8), self.url  # a view may be shown twice
            content = (
                f'<iframe id="glint-live-{name}" title="live view" style="display:none;width:100%;height:600px;border:0" '
                'sandbox="allow-scripts allow-same-origin"></iframe>'
                f'<div id="glint-still-{name}">{picture}<div>A still picture. The live view does not answer: it is closed, or Python '
                f'runs on another computer, which this browser cannot reach at <a href="{url}" target="_blank" '
                f'rel="noreferrer">{url}</a>.</div></div>'
                f"<script>{_SCRIPT.replace('ID', name).replace('URL', url)}</script>"
            )
        return {"text/plain": repr(self), "image/png": still.to_bytes(), "text/html": content}

    def __reduce__(self) -> Tuple[Any, ...]:
        raise TypeError("a live view cannot be copied or pickled; its scene can")

    def __repr__(self) -> str:
        return f"<glint.LiveView of {self.scene!r}, {'closed' if self.closed else self.url}>"


def live(scene: Any, size: Optional[Tuple[int, int]], sliders: Optional[Sliders]) -> LiveView:
    """Scene.live()."""
    expect("size", size, Optional[Tuple[int, int]])
    view = LiveView(scene, size, sliders)
    if _is_notebook():
        return view
    try:
        if not _has_display():
            warn_of(f"there is no display to show the live view on; its address is {view.url}")
        elif not webbrowser.open(view.url):
            warn_of(f"no browser could be started to show the live view; its address is {view.url}")
    except webbrowser.Error as error:
        warn_of(f"no browser could be started to show the live view ({error}); its address is {view.url}")
    return view

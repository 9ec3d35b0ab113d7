# SPDX-License-Identifier: Apache-2.0
"""How a scene is looked at."""

from __future__ import annotations

import contextlib
from typing import Any, ContextManager, Dict, Optional, Tuple

from ._errors import GlintError
from ._html_answers import scene_html
from ._image import Image
from ._live import LiveView, live
from ._sliders import Sliders


class ShownScene:
    """A part of Scene: what notebooks and windows show."""

    def show(self: Any, **options: Any) -> Image:
        """Renders the scene, shows the picture as Image.show() does, and returns it. options: those of render()."""
        image: Image = self.render(**options)
        image.show()
        return image

    # Held while a picture is rendered. With a live view these are Turns, so that one picture is rendered after the other: two at
    # once would each prepare the changed scene.
    _rendering: ContextManager[Any] = contextlib.nullcontext()

    def live(self, *, sliders: Optional[Sliders] = None, size: Optional[Tuple[int, int]] = None) -> LiveView:
        """A view that can be moved: at the end of a notebook's cell below it, elsewhere in the browser.

        Dragging and the arrow keys orbit the camera, the wheel moves it nearer and farther, and a click explains a pixel.
        sliders: by label (object, attribute, lowest, highest), such as {"brightness": (light, "intensity", 0, 2)}; one of three
        numbers is "position.x" or "color.r", a setting (scene.settings, "reflections", 0, 5), and a coefficient that is a factor of
        its material's color (material, "diffuse", 0, 1). size: (width, height) in pixels, by default the scene's. Pictures are
        rendered by this process, while the view moves without anti-aliasing; the browser must run on the same computer. The
        scene's own camera moves, so that render() then gives the view that was found.
        After changes from Python, view.refresh() has the page render again. A program that would end calls view.wait().
        Without a display, a GlintWarning has the address.
        GlintError if the scene cannot be rendered, OSError if the system gives no port.
        """
        return live(self, size, sliders)

    def _preview(self: Any) -> Image:
        """A picture of at most 320 pixels a side."""
        width, height = self.settings["size"]
        factor = min(1.0, 320 / max(width, height))
        size = max(1, round(factor * width)), max(1, round(factor * height))
        image: Image = self.render(size=size)
        return image

    def _repr_png_(self) -> bytes:
        return self._preview().to_bytes()

    def _repr_html_(self) -> str:
        try:
            return scene_html(self, self._preview())
        except (GlintError, MemoryError) as error:
            return scene_html(self, None, str(error))

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> Dict[str, Any]:
        """All of them, of one picture."""
        bundle: Dict[str, Any] = {"text/plain": repr(self)}
        try:
            image = self._preview()
        except (GlintError, MemoryError) as error:
            return {**bundle, "text/html": scene_html(self, None, str(error))}
        return {**bundle, "image/png": image.to_bytes(), "text/html": scene_html(self, image)}

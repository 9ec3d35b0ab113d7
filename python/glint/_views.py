# SPDX-License-Identifier: Apache-2.0
"""How a scene is looked at."""

from __future__ import annotations

from typing import Any, Dict

from ._errors import GlintError
from ._html_answers import scene_html
from ._image import Image


class ShownScene:
    """A part of Scene: what notebooks and windows show."""

    def show(self: Any, **options: Any) -> Image:
        """Renders the scene, shows the picture as Image.show() does, and returns it. options: those of render()."""
        image: Image = self.render(**options)
        image.show()
        return image

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

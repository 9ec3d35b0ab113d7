# SPDX-License-Identifier: Apache-2.0
"""What an export is asked for; plain values, filled from the scene's settings (properties.py) or by tests."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Options:
    shading: str = "blinn-phong"
    facing: str = "all"
    fresnel: str = "schlick"
    glass_shadow: str = "none"
    reflections: int = -1  # -1: Cycles' bounces, at most 12
    aa: int = 3
    adaptive: bool = False  # pixels that differ from their neighbours get aa x aa samples, the others one
    light_samples: int = 4  # n x n of a light with an extent
    mist: bool = False  # the world's mist is fog
    occlusion: bool = False  # the world's light is blocked by shapes
    light_scale: float = 1.0
    recognise: bool = True  # AUTO shapes; else all are meshes
    collection: str = ""  # RT2: its name; empty: scene_custom if there is one, else everything
    selection: frozenset | None = None  # pointers of the original objects that are exported; None: all
    light_color: str = "color"  # RT2: color (the course's rule) or classical

    @property
    def samples(self):
        """As `glint render --aa` takes it."""
        return f"adaptive:{self.aa}" if self.adaptive and self.aa > 1 else str(self.aa)

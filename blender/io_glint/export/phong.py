# SPDX-License-Identifier: Apache-2.0
"""Shader nodes as coefficients of the classic lighting equation: formulas only, without Blender.

Sources: the exponent of Blinn-Phong for a GGX or Beckmann width alpha is 2/alpha^2 - 2 (Walter et al. 2007, CSC 473);
(n + 2)/8 is the peak of the normalised Blinn-Phong lobe over Lambert's 1/pi. Roughness below 0.3 mirrors; glint's
mirrors are sharp, so w fades them out, and half of what is lost comes back as body color.
"""
from dataclasses import dataclass, fields, replace

from .texture import Pattern

WHITE, BLACK = (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)
MIN_MIRROR = 0.02


@dataclass(frozen=True)
class Phong:
    """Colors are linear. k_a is not here: it is k_d times the world's radiance, plus emission (ambient())."""

    diffuse: tuple = BLACK
    specular: tuple = BLACK
    emission: tuple = BLACK
    shininess: float = 32.0
    mirror: float = 0.0
    mirror_color: tuple = WHITE
    transmission: float = 0.0
    transmission_color: tuple = WHITE
    ior: float = 1.0
    color: tuple = (0.8, 0.8, 0.8)  # what it is called: the base color
    # What diffuse is to be multiplied by; its tint is in there already. glows: emission, too.
    pattern: Pattern | None = None
    glows: bool = False

    @property
    def is_black(self):
        """Whether a pattern could not be seen."""
        return not any(self.diffuse) and not any(self.emission)


def _scaled(color, factor):
    return tuple(c * factor for c in color)


def exponent(roughness):
    """The Blinn-Phong exponent for Blender's roughness, 0 to 1: 1 to 1e5."""
    alpha = max(roughness, 0.02) ** 2
    return min(max(2 / alpha**2 - 2, 1.0), 1e5)


def principled(color, metallic=0.0, roughness=0.5, specular=0.5, transmission=0.0, ior=1.45, emission=BLACK):
    """The Principled BSDF. color: linear; the others: 0 to 1, except ior and emission (color times strength)."""
    m, t, r = metallic, transmission, roughness
    f0 = tuple(0.08 * specular * (1 - m) + c * m for c in color)
    top = max(max(f0), 1e-9)
    n = exponent(r)
    w = max(0.0, 1 - r / 0.3)
    mirror = w * max(f0)
    has_mirror = mirror > MIN_MIRROR
    return Phong(
        diffuse=tuple(c * (1 - m) * (1 - t) + 0.5 * c * m * (1 - w) for c in color),
        specular=_scaled(f0, min((n + 2) / 8, 1 / top)),
        emission=tuple(emission),
        shininess=n,
        mirror=min(mirror, 1.0) if has_mirror else 0.0,
        mirror_color=_scaled(f0, 1 / top) if has_mirror else WHITE,
        transmission=t * (1 - m),
        transmission_color=tuple(c * c for c in color) if t > 0 else WHITE,
        ior=ior if t * (1 - m) > 0 else 1.0,
        color=tuple(color),
    )


def diffuse(color):
    return Phong(diffuse=tuple(color), color=tuple(color))


def glossy(color, roughness):
    return principled(color, metallic=1.0, roughness=roughness)


def glass(color, ior):
    """Tinted at both surfaces by Blender and once by glint: the square of the color."""
    return Phong(specular=(0.5, 0.5, 0.5), shininess=2000.0, transmission=1.0,
                 transmission_color=tuple(c * c for c in color), ior=ior, color=tuple(color))


def transparent(color):
    return Phong(transmission=1.0, transmission_color=tuple(color), ior=1.0, color=tuple(color))


def emission(color, strength):
    return Phong(emission=_scaled(color, strength), color=tuple(color))


def with_alpha(material, alpha):
    """A surface that lets 1 - alpha of the light pass straight on."""
    if alpha >= 1:
        return material
    return replace(mix(transparent(WHITE), material, max(alpha, 0.0)), color=material.color)


def _combine(a, b, number):
    """number: the function for two numbers, applied to every field and channel."""
    values = {}
    for field in fields(Phong):
        x, y = getattr(a, field.name), getattr(b, field.name)
        if field.name not in ("pattern", "glows"):
            values[field.name] = tuple(map(number, x, y)) if isinstance(x, tuple) else number(x, y)
    owner = a if a.pattern else b
    return Phong(**values, pattern=owner.pattern, glows=owner.glows)


def shares_pattern(a, b):
    """Whether mix() and add() of two materials keep what varies: one has a pattern, and the other nothing that it would color."""
    return not (a.pattern or b.pattern) or (a.pattern is None and a.is_black) or (b.pattern is None and b.is_black)


def patterned(pattern, mean, make):
    """make(color), a material whose diffuse part is a multiple of the color, with a pattern; all else has its mean color."""
    whole, white = make(mean), make(WHITE)
    return replace(whole, diffuse=tuple(d * t for d, t in zip(white.diffuse, pattern.tint)), pattern=pattern, color=pattern.tint)


def mix(a, b, factor):
    """The weighted mean of every number: factor 0 is a, 1 is b. A tint or exponent that only one of them uses is kept."""
    f = min(max(factor, 0.0), 1.0)
    if f in (0.0, 1.0):
        return b if f else a
    mixed = _combine(a, b, lambda x, y: (1 - f) * x + f * y)
    return _keep_unshared(mixed, a, b)


def add(a, b):
    """The sum of the light of both."""
    total = _combine(a, b, lambda x, y: x + y)
    mean = _keep_unshared(_combine(a, b, lambda x, y: (x + y) / 2), a, b)
    room = max(total.mirror + total.transmission, 1.0)
    return replace(total, mirror=total.mirror / room, transmission=total.transmission / room,
                   shininess=mean.shininess, mirror_color=mean.mirror_color,
                   transmission_color=mean.transmission_color, ior=mean.ior, color=mean.color)


def _keep_unshared(mixed, a, b):
    """A lobe that one side lacks says nothing of its tint, exponent or index."""
    for x, y in ((a, b), (b, a)):
        if not x.mirror and y.mirror:
            mixed = replace(mixed, mirror_color=y.mirror_color)
        if not x.transmission and y.transmission:
            mixed = replace(mixed, transmission_color=y.transmission_color, ior=y.ior)
        if not any(x.specular) and any(y.specular):
            mixed = replace(mixed, shininess=y.shininess)
    return mixed


def ambient(material, world):
    """k_a for an ambient light of (1, 1, 1): exact for a Lambert surface in a uniform world, and what it emits."""
    return tuple(d * w + e for d, w, e in zip(material.diffuse, world, material.emission))

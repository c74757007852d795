"""What a pixel is made of: the few classes that ink and light treat differently (notes: sets and light, section 2)."""

from __future__ import annotations

from enum import IntEnum


class Surface(IntEnum):
    """Class of a surface; 0 is left for the sky."""

    SET = 1
    PROP = 2
    SKIN = 3
    CLOTH = 4
    HAIR = 5
    EYE = 6
    FOLIAGE = 7
    EMISSIVE = 8
    CARD = 9
    WET = 10
    GLASS = 11
    NO_INK = 12
    SMOKE = 13
    """Drawn as air (``look/smoke.py``), never as a surface."""


SKY = 0
"""Class and id of the pixels that show no object."""
PERSON: tuple[int, ...] = (Surface.SKIN, Surface.CLOTH, Surface.HAIR, Surface.EYE)
"""The classes a person is made of."""
FLESH: tuple[int, ...] = (Surface.SKIN, Surface.EYE)
"""The classes of a face."""

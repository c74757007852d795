"""Light as a cinematographer notes it: the sky and sun of each hour, the weather over it, what each lamp gives.

Numbers are scene-linear and relative: the renderer scales the whole set to ``set_luminance`` and solves every face for
``face_luminance`` (notes: sets and light, 1.2). What matters here is the proportion of sun to sky to lamps.
"""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

import numpy as np

from storyblender.catalog.materials import hex_color
from storyblender.look.illumination import SKY_STOPS, sky_colors
from storyblender.look.raster import luminance
from storyblender.memory.base import Color, Vec3
from storyblender.memory.scene_context import Sky
from storyblender.memory.vocabulary import TimeOfDay, Weather

MOON: Color = (0.5, 0.66, 1.0)
FIRE: Color = (1.0, 0.52, 0.2)
CANDLE: Color = (1.0, 0.62, 0.28)
BULB: Color = (1.0, 0.74, 0.44)
TUBE: Color = (0.86, 0.94, 1.0)
FLASHLIGHT: Color = (1.0, 0.95, 0.84)
SODIUM: Color = (1.0, 0.70, 0.38)


class Hour(NamedTuple):
    """One time of day under a clear sky."""

    elevation: float
    """Of sun or moon, degrees."""
    sun: float
    """W/m2 on a surface that faces it."""
    sun_color: Color
    zenith: Color
    horizon: Color
    lamps: float
    """Share of the lamps that burn, and how strongly: 0 none, 1 as at night."""
    outside: float
    """``set_luminance`` under the sky."""
    inside: float
    """``set_luminance`` of a room with windows."""
    face: float
    """``face_luminance``."""
    ratio: float
    """Key to fill outdoors."""


HOURS: dict[TimeOfDay, Hour] = {
    "dawn": Hour(5, 1.3, (1.0, 0.62, 0.38), (0.26, 0.35, 0.56), (0.92, 0.70, 0.56), 0.5, 0.115, 0.06, 0.19, 2.5),
    "morning": Hour(22, 3.0, (1.0, 0.84, 0.62), (0.28, 0.46, 0.82), (0.84, 0.86, 0.88), 0.0, 0.15, 0.10, 0.22, 2.4),
    "day": Hour(44, 3.8, (1.0, 0.94, 0.84), (0.29, 0.45, 0.78), (0.72, 0.84, 1.00), 0.0, 0.17, 0.11, 0.23, 2.2),
    "noon": Hour(68, 4.4, (1.0, 0.97, 0.91), (0.27, 0.44, 0.80), (0.74, 0.86, 1.04), 0.0, 0.18, 0.115, 0.24, 2.0),
    "afternoon": Hour(32, 3.5, (1.0, 0.88, 0.68), (0.27, 0.46, 0.84), (0.86, 0.90, 0.92), 0.0, 0.16, 0.105, 0.23, 2.4),
    "sunset": Hour(6, 2.1, (1.0, 0.52, 0.22), (0.14, 0.18, 0.38), (0.95, 0.50, 0.24), 0.4, 0.105, 0.065, 0.20, 3.0),
    "dusk": Hour(3, 0.25, (1.0, 0.50, 0.30), (0.05, 0.075, 0.18), (0.40, 0.24, 0.20), 0.9, 0.076, 0.075, 0.19, 3.2),
    "evening": Hour(28, 0.10, MOON, (0.018, 0.030, 0.080), (0.075, 0.090, 0.160), 1.0, 0.085, 0.085, 0.19, 3.4),
    "night": Hour(38, 0.14, MOON, (0.006, 0.011, 0.026), (0.024, 0.034, 0.060), 1.0, 0.078, 0.082, 0.19, 3.6),
}
"""The director's table (notes: director, 4.5) as numbers; evening and night are lit by the moon."""


class Air(NamedTuple):
    """How a weather changes an hour."""

    sun: float
    """Share of the sun that comes through."""
    gray: float
    """How far the sky turns to an even grey."""
    dim: float
    """Brightness of what is left of the sky."""
    fog: float
    """Density per metre of the air."""
    fog_start: float
    fog_height: float
    rain: float
    level: float
    """Factor on ``set_luminance``."""


WEATHERS: dict[Weather, Air] = {
    "clear": Air(1.0, 0.0, 1.0, 0.0022, 14.0, 60.0, 0.0, 1.0),
    "cloudy": Air(0.16, 0.8, 0.85, 0.004, 12.0, 50.0, 0.0, 0.85),
    "fog": Air(0.08, 0.95, 0.8, 0.034, 4.0, 14.0, 0.0, 0.8),
    "rain": Air(0.05, 0.95, 0.55, 0.013, 6.0, 30.0, 0.6, 0.62),
    "storm": Air(0.02, 1.0, 0.3, 0.016, 5.0, 30.0, 1.0, 0.42),
    "snow": Air(0.12, 0.9, 0.9, 0.014, 6.0, 30.0, 0.0, 0.9),
}


class LampKind(NamedTuple):
    """What the light inside a prop is like."""

    watts: float
    color: Color
    kind: Literal["POINT", "SPOT", "AREA"] = "POINT"
    size: float = 0.06
    glow: float = 0.15
    offset: Vec3 = (0.0, 0.0, 0.0)
    """From the lamp's place in the prop, in the prop's frame: out of its shade."""
    cone: float = 140.0
    """Full angle of a SPOT in degrees."""
    off_by_default: bool = False
    """Whether it shines only in a hand, or where the story says that it is lit."""

    @property
    def without_mains(self) -> bool:
        """Whether it keeps shining when the power fails: a flame, or a lamp with a battery."""
        return self.off_by_default or self.color in (FIRE, CANDLE)


LAMPS: dict[str, LampKind] = {
    "pendant_lamp": LampKind(70, BULB, "SPOT", 0.1, 0.3, (0, 0, -0.06)),
    "chandelier": LampKind(80, BULB, size=0.4, glow=0.25, offset=(0, 0, -0.2)),
    "fluorescent_light": LampKind(30, TUBE, "AREA", 0.9, 0.0, (0, 0, -0.08)),
    "table_lamp": LampKind(7, BULB),
    "bankers_lamp": LampKind(9, BULB, offset=(0, -0.05, -0.1)),
    "floor_lamp": LampKind(18, BULB, glow=0.2),
    "wall_lamp": LampKind(9, BULB),
    "lantern": LampKind(12, CANDLE, glow=0.3),
    "candelabra": LampKind(8, CANDLE, glow=0.25),
    "candle_holder": LampKind(4, CANDLE, size=0.02, glow=0.2),
    "candle": LampKind(4, CANDLE, size=0.02, glow=0.2),
    "flashlight": LampKind(220, FLASHLIGHT, "SPOT", 0.03, 0.5, cone=34.0, off_by_default=True),
    "lighter": LampKind(2, CANDLE, size=0.02, glow=0.15, off_by_default=True),
    "paper_lantern": LampKind(9, CANDLE, size=0.15, glow=0.2),
    "brazier": LampKind(24, FIRE, size=0.2, glow=0.25, offset=(0, 0, 0.2)),
    "flames": LampKind(50, FIRE, size=0.3, glow=0.25),
    "lighthouse": LampKind(400, BULB, size=0.5, glow=0.6),
    "torch": LampKind(36, FIRE, size=0.12, glow=0.35),
    "fireplace": LampKind(34, FIRE, size=0.2, glow=0.12, offset=(0, -0.35, 0.1)),
    "campfire": LampKind(60, FIRE, size=0.25, glow=0.25, offset=(0, 0, 0.5)),
    "wood_stove": LampKind(8, FIRE, size=0.1, glow=0.1, offset=(0, -0.3, 0)),
    "television": LampKind(6, (0.6, 0.75, 1.0), "AREA", 0.4, 0.05, (0, -0.35, 0)),
    "lamppost": LampKind(150, SODIUM, size=0.18, glow=0.55),
    "neon_sign": LampKind(12, (1.0, 0.28, 0.22), size=0.3, glow=0.3),
    "control_console": LampKind(4, (0.5, 0.9, 0.7), size=0.4, glow=0.05),
}
"""Watts at night, by prop. Sizes and strengths of the prototype's cafe, office, street (notes: sets and light, 1.4)."""

DARKENED = 0.16
"""Share of the light that stays when the lamps go out: moon and street through the windows."""


def sky_of(hour: Hour, weather: Weather, ground: Color) -> Sky:
    """Return the dome of an hour under a weather.

    Args:
        hour: A row of ``HOURS``.
        weather: Turns it grey and dims it.
        ground: Mean colour of what lies below, for the lower half.
    """
    air = WEATHERS[weather]

    def under(color: Color) -> Color:
        gray = sum(color) / 3 * 0.95 + 0.05 * max(color)
        tones = (gray * 0.95, gray, gray * 1.06)
        red, green, blue = (air.dim * (c + (t - c) * air.gray) for c, t in zip(color, tones, strict=True))
        return (red, green, blue)

    horizon = under(hour.horizon)
    below = tuple(0.6 * h * g for h, g in zip(horizon, ground, strict=True))
    zenith = under(hour.zenith)
    if air.gray > 0.5:  # an overcast dome is brighter above than a blue one
        zenith = mix(zenith, horizon, 0.55)
    return Sky(zenith=zenith, horizon=horizon, ground=(below[0], below[1], below[2]))


def mix(a: Color, b: Color, share: float) -> Color:
    """Return a mixture of two scene-linear colours.

    Args:
        a: Colour at share 0.
        b: Colour at share 1.
        share: Part of the second colour, 0 to 1.
    """
    red, green, blue = (x + (y - x) * share for x, y in zip(a, b, strict=True))
    return (red, green, blue)


def mean_sky_luminance(sky: Sky) -> float:
    """Return the mean luminance of the whole dome, its ground included."""
    shares = np.diff(SKY_STOPS) / 2  # equal steps of height are equal areas of the sphere
    bright = luminance(sky_colors(sky))
    return float(((bright[:-1] + bright[1:]) / 2) @ shares)


def open_sky_light(sky: Sky) -> Color:
    """Return the light a level surface gets from the whole dome: irradiance / pi, what ``ambient`` means."""
    heights = (np.arange(100) + 0.5) / 100
    colors = sky_colors(sky)
    bands = [np.interp(heights, SKY_STOPS, colors[:, band]) for band in range(3)]
    red, green, blue = (float((band * 2 * heights).mean()) for band in bands)
    return (red, green, blue)


def sun_position(elevation: float, azimuth: float, distance: float = 50.0) -> Vec3:
    """Return where the sun stands.

    Args:
        elevation: Degrees over the horizon.
        azimuth: Degrees about the stage: 0 behind the audience, 90 at the left, 180 behind the stage.
        distance: Metres from the stage; only the direction matters.
    """
    up, round_ = math.radians(elevation), math.radians(azimuth)
    return (
        -distance * math.cos(up) * math.sin(round_),
        -distance * math.cos(up) * math.cos(round_),
        distance * math.sin(up),
    )


def area_watts(level: float, distance: float, diameter: float) -> float:
    """Return the watts of a disk AREA lamp that light a white surface on its axis (notes 1.1).

    Args:
        level: Scene-linear luminance wanted of the surface, which faces the lamp.
        distance: Metres from the lamp to the surface.
        diameter: Metres across the disk.
    """
    return level * math.pi**2 * (distance**2 + (diameter / 2) ** 2)


GROUNDS: dict[str, Color] = {
    "grass": hex_color("#56702f"),
    "sand": hex_color("#c4a878"),
    "snow": hex_color("#dfe5ea"),
    "stone": hex_color("#66645f"),
}
"""Mean colours of ground for the lower half of the sky."""

"""The Lighting Arranger: hour, weather and lamps of a place become the scene's light plan; changes become new plans.

Faces are not lit here: key, fill and rim of a shot are solved by the renderer for its camera (``look.face_light``).
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from storyblender.catalog.light_recipes import (
    DARKENED,
    GROUNDS,
    HOURS,
    LAMPS,
    MOON,
    WEATHERS,
    Hour,
    area_watts,
    mix,
    open_sky_light,
    sky_of,
    sun_position,
)
from storyblender.catalog.props import PROPS
from storyblender.catalog.set_plan import SetPlan, Wall
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Color, Vec3
from storyblender.memory.scene_context import Environment, Fog, Layout, Light, Lighting, SceneSetup
from storyblender.memory.vocabulary import TimeOfDay
from storyblender.reflection import Critique, Fault

MOST_LIGHTS = 20
"""Lamps a plan may have; every one costs time in every frame."""
_REACH = 26.0
"""Metres from the stage beyond which a lamp is scenery, not light."""


@dataclass(frozen=True)
class LightingView:
    """What the Lighting Arranger sees.

    Attributes:
        setup: Time, weather and the words on light.
        plan: The set with its windows and its own lamps.
        environment: Its seed decides which side the sun comes from.
        layout: Where lamp props stand; without it the plan's furnishings count.
        assets: To know which of the layout's objects are lamps.
    """

    setup: SceneSetup
    plan: SetPlan
    environment: Environment
    layout: Layout | None = None
    assets: tuple[Asset, ...] = ()


class RulesLightingArranger:
    """Lights by recipe (notes: sets and light, 1.4; director, 4.5)."""

    def propose(self, view: LightingView) -> Lighting:
        """Return the light plan of a scene."""
        lighting = _interior(view) if view.plan.indoor else _exterior(view)
        return _described(lighting, view.setup.lighting_description)

    def refine(self, draft: Lighting, critique: Critique, view: LightingView) -> Lighting:
        """Keep the strongest lamps; raise the level where it would be too dark to read."""
        kinds = {fault.kind for fault in critique.faults}
        update: dict[str, object] = {}
        if "too_many_lights" in kinds:
            update["lights"] = strongest(draft.lights, MOST_LIGHTS)
        if "too_dark" in kinds:
            update["set_luminance"] = max(draft.set_luminance, 0.02)
        if "flat_faces" in kinds:
            update["face_luminance"] = draft.set_luminance * 1.2
        return draft.model_copy(update=update)

    def change(self, current: Lighting, description: str, view: LightingView) -> Lighting:
        """Return the light after a change that the script states, e.g. ``The lights go out``.

        Args:
            current: The light until now.
            description: The script's or the Director's words.
            view: As for ``propose``.

        Returns:
            The new plan; ``current`` itself if the words name no change of light that is known.
        """
        words = description.lower()
        hour = next((time for pattern, time in _HOUR_WORDS if re.search(pattern, words)), None)
        if hour is not None and hour != view.setup.time_of_day:
            setup = view.setup.model_copy(update={"time_of_day": hour})
            return self.propose(LightingView(setup, view.plan, view.environment, view.layout, view.assets))
        if re.search(_OUT, words):
            return lights_out(current, indoor=view.plan.indoor)
        if re.search(_ON, words):
            lit = view.setup.model_copy(update={"lighting_description": ""})
            plan = self.propose(LightingView(lit, view.plan, view.environment, view.layout, view.assets))
            return plan if _practicals(plan) else _lamps_burn(plan, view)
        return _described(current, description)


class LightingCritic:
    """Checks that a plan can be rendered and read."""

    def judge(self, draft: Lighting, view: LightingView) -> Critique:
        """Score ten less: too many lamps, no light at all, faces under their surroundings."""
        faults: list[Fault] = []
        if len(draft.lights) > MOST_LIGHTS:
            faults.append(
                Fault(kind="too_many_lights", message=f"{len(draft.lights)} lamps; keep {MOST_LIGHTS}", severity=3.0)
            )
        if not any(light.power > 0 for light in draft.lights) and sum(draft.ambient) < 0.01:
            faults.append(Fault(kind="no_light", message="nothing lights the set", severity=6.0))
        if draft.set_luminance < 0.006:
            faults.append(Fault(kind="too_dark", message="the set is under what a board can show", severity=3.0))
        if draft.face_luminance < draft.set_luminance:
            faults.append(Fault(kind="flat_faces", message="faces are darker than the set around them", severity=3.0))
        return Critique.of(tuple(faults))


def light_place(setup: SceneSetup, plan: SetPlan, environment: Environment) -> Lighting:
    """Return the light plan of a place without props of the script: what ``propose`` gives before the layout."""
    return RulesLightingArranger().propose(LightingView(setup, plan, environment))


_SWITCHES = r"turn(s|ed)?|switch(es|ed)?|flip(s|ped)?|snuff(s|ed)?|blow(s|n)?"
_OUT = (
    r"\b(lights?|lamps?|power|electricity|bulbs?|candles?)\b.{0,24}\b(out|off|dies?|fails?|blow)\b"
    r"|\b(black ?out|pitch dark|plunged? into darkness|goes dark|total darkness)\b"
    rf"|\b({_SWITCHES}) (off|out)\b"
)
_ON = (
    r"\b(lights?|lamps?|power|bulbs?|candles?)\b.{0,24}\b(on|back|up|lit)\b"
    rf"|\b({_SWITCHES}) on\b|\blights? (a|the) (lamp|candle)\b"
)
_HOUR_WORDS: tuple[tuple[str, TimeOfDay], ...] = (
    (r"\b(sun ?rise|sun (comes|is coming) up|dawn breaks|first light)\b", "dawn"),
    (r"\b(sun ?set|sun (goes|is going) down)\b", "sunset"),
    (r"\b(night falls|night has fallen)\b", "night"),
    (r"\b(dusk|twilight) (falls|comes)\b", "dusk"),
)


def lights_out(lighting: Lighting, *, indoor: bool) -> Lighting:
    """Return a plan with its lamps out: what comes through the windows stays, and a little blue air."""
    dark = tuple(
        light.model_copy(update={"power": light.power * 0.5, "color": mix(light.color, MOON, 0.6)})
        for light in lighting.lights
        if light.role == "set" or light.role == "sun"
    )
    blue: Color = (0.012, 0.016, 0.026)
    return lighting.model_copy(
        update={
            "lights": dark,
            "ambient": blue if indoor else lighting.ambient,
            "set_luminance": max(0.012, lighting.set_luminance * DARKENED * 2),
            "face_luminance": max(0.05, lighting.face_luminance * 0.4),
            "key_color": (0.62, 0.76, 1.0),
            "fill_color": (0.5, 0.62, 0.9),
            "rim_color": (0.6, 0.76, 1.0),
            "key_fill_ratio": 6.0,
        }
    )


def strongest(lights: tuple[Light, ...], count: int) -> tuple[Light, ...]:
    """Return the ``count`` lamps that give the stage most, in their order; the sun always stays."""

    def weight(light: Light) -> float:
        if light.kind == "SUN":
            return math.inf
        return light.power * (4 if light.kind == "AREA" else 1) / (1.0 + math.dist(light.location, (0, 0, 1.4)) ** 2)

    kept = sorted(range(len(lights)), key=lambda index: -weight(lights[index]))[:count]
    return tuple(lights[index] for index in sorted(kept))


def _practicals(lighting: Lighting) -> bool:
    return any(light.role == "practical" for light in lighting.lights)


def _lamps_burn(plan: Lighting, view: LightingView) -> Lighting:
    return plan.model_copy(update={"lights": strongest((*plan.lights, *_lamps(view, 1.0)), MOST_LIGHTS)})


# ---------------------------------------------------------------------- lamps


def _lamps(view: LightingView, share: float) -> tuple[Light, ...]:
    """Return the burning lamps: those of the architecture and one inside every lamp prop."""
    if share <= 0:
        return ()
    lights = [*view.plan.lamps, *_lamp_props(view)]
    near = [light for light in lights if math.hypot(light.location[0], light.location[1]) < _REACH or light.power > 300]
    return tuple(light.model_copy(update={"power": round(light.power * share, 3)}) for light in near)


def _lamp_props(view: LightingView) -> Iterator[Light]:
    for node_id, key, place, yaw, height in _standing_props(view):
        kind, entry = LAMPS.get(key), PROPS.get(key)
        if kind is None:
            continue
        at = (0.0, 0.0, 0.5) if entry is None or entry.lamp is None else entry.lamp
        usual = entry.size[2] if entry is not None else 1.0
        if entry is not None and entry.placement != "ceiling" and height:
            at = (at[0], at[1], at[2] * height / usual)
        turn, (dx, dy, dz) = math.radians(yaw), (at[i] + kind.offset[i] for i in range(3))
        x = place[0] + dx * math.cos(turn) - dy * math.sin(turn)
        y = place[1] + dx * math.sin(turn) + dy * math.cos(turn)
        spot = (round(x, 3), round(y, 3), round(place[2] + dz, 3))
        ahead = (x + 2 * math.sin(turn), y - 2 * math.cos(turn), spot[2]) if key == "television" else (x, y, 0.0)
        yield Light(
            name=f"{node_id}_light",
            kind=kind.kind,
            role="practical",
            location=spot,
            target=ahead,
            power=kind.watts,
            color=kind.color,
            size=kind.size,
            cone=140.0,
            blend=0.6,
            glow=kind.glow,
        )


def _standing_props(view: LightingView) -> Iterator[tuple[str, str, Vec3, float, float]]:
    """Yield node_id, prop key, location, yaw and height of every prop of the scene."""
    if view.layout is None:
        for item in view.plan.furnishings:
            yield item.node_id, item.prop, item.location, item.yaw, float(item.params.get("height", 0.0))
        return
    assets = {asset.asset_id: asset for asset in view.assets}
    for placed in view.layout.objects:
        asset = assets.get(placed.asset_id)
        if asset is not None and asset.canonical is not None and asset.canonical.source == "catalog":
            height = asset.canonical.dimensions[2]
            yield placed.node_id, asset.canonical.key, placed.location, placed.rotation[2], height


# ---------------------------------------------------------------------- indoors


def _interior(view: LightingView) -> Lighting:
    hour, air = HOURS[view.setup.time_of_day], WEATHERS[view.setup.weather]
    openings = list(_window_walls(view.plan))
    day = hour.lamps < 0.3
    lamps = _lamps(view, 1.0 if not openings else hour.lamps)
    if not lamps and not day:
        lamps = (_ceiling_wash(view.plan, 0.5, (1.0, 0.8, 0.58)),)
    lights: list[Light] = []
    brightness = sum(hour.horizon) / 3 * air.dim
    for wall, centre, inward, size in openings:
        lights.append(
            _window_light(wall, centre, inward, size, level=0.25 + 1.5 * brightness, hour=hour, grey=air.gray)
        )
    if openings and hour.sun * air.sun > 0.4 and hour.elevation < 60:
        lights.append(_sun_through(openings, hour, air.sun, view.environment.seed))
    if day and openings:
        lights.append(_ceiling_wash(view.plan, 0.22, mix(hour.horizon, (1.0, 0.96, 0.9), 0.6)))
    elif lamps:
        lights.append(_ceiling_wash(view.plan, 0.1, (1.0, 0.80, 0.58)))
    warm = _mean_color(lamps) if lamps else (1.0, 0.94, 0.86)
    lit_room = not openings and day
    outside = sky_of(hour, view.setup.weather, GROUNDS["stone"])
    return Lighting(
        lights=strongest((*lights, *lamps), MOST_LIGHTS),
        sky=outside,
        ambient=mix((0.05, 0.042, 0.034), (0.15, 0.155, 0.16), 1.0 if day and openings else 0.15),
        fog=Fog(color=_scaled(warm, 0.012 if not day else 0.03), density=0.008 if not day else 0.004, start=3.0),
        face_luminance=hour.face if not lit_room else 0.21,
        set_luminance=round((hour.inside if not lit_room else 0.075) * (1.0 if not day else 0.5 + 0.5 * air.level), 4),
        key_color=mix(warm, (1.0, 0.95, 0.88), 0.55) if lamps else mix(hour.sun_color, (1.0, 0.97, 0.93), 0.6),
        fill_color=(0.78, 0.86, 1.0) if day else (0.62, 0.75, 1.0),
        rim_color=hour.sun_color if day else (0.72, 0.83, 1.0) if openings else warm,
        key_fill_ratio=2.8 if day and openings else 3.6,
    )


def _window_walls(plan: SetPlan) -> Iterator[tuple[Wall, Vec3, tuple[float, float], float]]:
    """Yield each wall with windows: the middle of its windows, the way into the room, the size of the opening."""
    for wall in plan.walls:
        windows = [opening for opening in wall.openings if opening.kind == "window" and opening.style != "bars"]
        if not windows:
            continue
        span = np.subtract(wall.end, wall.start)
        along = span / np.linalg.norm(span)
        area = sum(window.width * window.height for window in windows)
        x = sum((window.x + window.width / 2) * window.width * window.height for window in windows) / area
        z = (
            wall.base
            + sum((window.sill + window.height / 2) * window.width * window.height for window in windows) / area
        )
        middle = np.add(wall.start, along * x)
        yield wall, (float(middle[0]), float(middle[1]), float(z)), (-float(along[1]), float(along[0])), math.sqrt(area)


def _window_light(
    wall: Wall, centre: Vec3, inward: tuple[float, float], size: float, *, level: float, hour: Hour, grey: float
) -> Light:
    x, y, z = centre
    diameter = min(max(size * 1.2, 0.8), 3.4)
    night = hour.lamps > 0.95
    color = (
        (0.40, 0.56, 1.0)
        if night
        else mix(_scaled(hour.horizon, 1 / max(hour.horizon)), (0.8, 0.88, 1.0), 0.4 + 0.3 * grey)
    )
    return Light(
        name=f"{wall.node_id}_daylight",
        kind="AREA",
        role="set",
        location=(round(x + 0.15 * inward[0], 3), round(y + 0.15 * inward[1], 3), z),
        target=(round(x + 4 * inward[0], 3), round(y + 4 * inward[1], 3), 0.6),
        power=round(area_watts(level * (0.35 if night else 0.7), 3.0, diameter), 2),
        color=color,
        size=diameter,
    )


def _sun_through(
    openings: list[tuple[Wall, Vec3, tuple[float, float], float]], hour: Hour, share: float, seed: int
) -> Light:
    """Return a sun that falls through the largest windows: a pool of light on the floor."""
    _, centre, inward, _ = max(openings, key=lambda item: item[3] * (0.3 if item[0].node_id == "wall_front" else 1.0))
    turn = math.radians(28.0 if seed % 2 else -28.0)
    dx = inward[0] * math.cos(turn) - inward[1] * math.sin(turn)
    dy = inward[0] * math.sin(turn) + inward[1] * math.cos(turn)
    drop = math.tan(math.radians(min(max(hour.elevation, 12.0), 34.0)))
    return Light(
        name="sun",
        kind="SUN",
        role="sun",
        location=(round(centre[0] - 10 * dx, 3), round(centre[1] - 10 * dy, 3), round(centre[2] + 10 * drop, 3)),
        target=centre,
        power=round(hour.sun * share, 3),
        color=hour.sun_color,
        size=1.0,
    )


def _ceiling_wash(plan: SetPlan, level: float, color: Color) -> Light:
    """Return the soft light that a room's ceiling and walls throw back."""
    size = plan.size
    ceiling = next((slab.z for slab in plan.slabs if slab.role == "ceiling"), 3.0)
    width = min(size.x - size.x_negative, size.y - size.y_negative)
    diameter = min(max(0.55 * width, 1.6), 6.0)
    middle = ((size.x + size.x_negative) / 2, (size.y + size.y_negative) / 2)
    return Light(
        name="ceiling_bounce",
        kind="AREA",
        role="set",
        location=(*middle, round(ceiling - 0.06, 3)),
        target=(*middle, 0.0),
        power=round(area_watts(level, ceiling - 1.0, diameter), 2),
        color=color,
        size=diameter,
    )


def _mean_color(lights: tuple[Light, ...]) -> Color:
    watts = sum(light.power for light in lights) or 1.0
    red, green, blue = (sum(light.power * light.color[band] for light in lights) / watts for band in range(3))
    return (red, green, blue)


def _scaled(color: Color, gain: float) -> Color:
    return (color[0] * gain, color[1] * gain, color[2] * gain)


# ---------------------------------------------------------------------- under the sky


def _exterior(view: LightingView) -> Lighting:
    hour, weather = HOURS[view.setup.time_of_day], view.setup.weather
    air, ground = WEATHERS[weather], _ground_color(view)
    sky = sky_of(hour, weather, ground)
    side = 1.0 if view.environment.seed % 2 else -1.0
    azimuth = side * _sun_azimuth(view.plan, hour)
    where = sun_position(hour.elevation, azimuth)
    sun = Light(
        name="sun",
        kind="SUN",
        role="sun",
        location=where,
        target=(0.0, 0.0, 0.0),
        power=round(hour.sun * air.sun, 4),
        color=mix(hour.sun_color, (1.0, 1.0, 1.0), 0.7 * air.gray),
        size=1.0 + 12 * air.gray,
    )
    night = hour.lamps > 0.95
    gloom = hour.lamps if air.level > 0.7 else max(hour.lamps, 0.5)
    level = hour.outside * air.level
    open_sky = open_sky_light(sky)
    gray = sum(open_sky) / 3
    bounce = _scaled(ground, gray + hour.sun * air.sun * 0.15)
    ambient = mix(mix(open_sky, (gray, gray, gray), 0.35), bounce, 0.3)
    return Lighting(
        lights=strongest((sun, *_lamps(view, gloom)), MOST_LIGHTS),
        sky=sky,
        ambient=_scaled(ambient, 0.75),
        fog=_air(view, hour, sky.horizon, where),
        rain=air.rain,
        face_luminance=round(max(0.15, hour.face * (0.6 + 0.4 * air.level)), 4),
        set_luminance=round(level, 4),
        key_color=_outdoor_key(view, hour),
        fill_color=(0.74, 0.84, 1.0),
        rim_color=hour.sun_color,
        key_fill_ratio=hour.ratio - 0.5 * air.gray,
    )


def _outdoor_key(view: LightingView, hour: Hour) -> Color:
    """Return the colour of faces: sunlight softened; at night the lamps, or the moon where there are none."""
    if hour.lamps < 0.95:
        return mix(hour.sun_color, (1.0, 0.95, 0.9), 0.6)
    return (1.0, 0.78, 0.52) if _lamps(view, 1.0) else (0.7, 0.82, 1.0)


def _sun_azimuth(plan: SetPlan, hour: Hour) -> float:
    """Return the sun's place round the stage: raking along walls that face the audience, else a little behind."""
    built = sum(piece.part == "facade" for piece in plan.pieces) > 3
    if hour.elevation < 10:
        return 118.0 if built else 152.0
    return 58.0 if built else 104.0


def _ground_color(view: LightingView) -> Color:
    names = [slab.material for slab in view.plan.slabs if slab.role == "ground"]
    names += [str(piece.params["material"]) for piece in view.plan.pieces if piece.part == "terrain"]
    for stem, color in GROUNDS.items():
        if any(stem in name for name in names):
            return color
    return GROUNDS["grass"] if any("forest" in name for name in names) else GROUNDS["stone"]


def _air(view: LightingView, hour: Hour, horizon: Color, sun: Vec3) -> Fog:
    """Return the air: a thin haze by day, thicker at night and in woods, with the sun's glow in it."""
    weather, air = view.setup.weather, WEATHERS[view.setup.weather]
    density, start, height = air.fog, air.fog_start, air.fog_height
    if hour.lamps > 0.95 or view.setup.time_of_day in ("dawn", "dusk"):
        density, start = max(density, 0.012), min(start, 6.0)
    if view.plan.kit == "forest":
        density, start, height = max(density, 0.009), min(start, 8.0), min(height, 24.0)
    strength = (0.55 if hour.elevation < 10 else 0.22) * hour.sun * air.sun / 3
    length = math.hypot(*sun) or 1.0
    return Fog(
        color=_scaled(horizon, 0.8 if weather == "clear" else 0.9),
        density=density,
        start=start,
        height=height,
        sun_direction=(sun[0] / length, sun[1] / length, sun[2] / length) if strength > 0.02 else None,
        sun_color=_scaled(hour.sun_color, round(strength, 4)) if strength > 0.02 else (0.0, 0.0, 0.0),
    )


# ---------------------------------------------------------------------- words


_MOODS: tuple[tuple[str, dict[str, object]], ...] = (
    (r"\b(dim|dimly|gloomy|low key|low-key|shadowy|murky|dark)\b", {"set": 0.55, "ratio": 1.5}),
    (r"\b(bright|brightly|high key|high-key|well lit|well-lit|sunny|radiant)\b", {"set": 1.3, "ratio": 0.75}),
    (r"\b(harsh|hard light|stark)\b", {"ratio": 1.8}),
    (r"\b(soft|gentle|diffuse)\b", {"ratio": 0.75}),
    (
        r"\b(firelight|fire ?light|fire-lit|candle ?lit|candle ?light|by candle)\b",
        {"set": 0.75, "key": (1.0, 0.66, 0.36)},
    ),
    (r"\b(cold|blue light|bluish|moonlit|moonlight)\b", {"key": (0.72, 0.84, 1.0)}),
    (r"\b(warm|golden|amber)\b", {"key": (1.0, 0.82, 0.58)}),
    (r"\b(red light|red glow|emergency light)\b", {"key": (1.0, 0.36, 0.26), "set": 0.7}),
)


def _described(lighting: Lighting, words: str) -> Lighting:
    """Bend a plan by the words on light: dim, bright, harsh, soft, warm, cold, candlelight."""
    update: dict[str, object] = {}
    for pattern, change in _MOODS:
        if not re.search(pattern, words.lower()):
            continue
        if "set" in change:
            update["set_luminance"] = round(lighting.set_luminance * float(str(change["set"])), 4)
        if "ratio" in change:
            update["key_fill_ratio"] = round(lighting.key_fill_ratio * float(str(change["ratio"])), 2)
        if "key" in change:
            update["key_color"] = change["key"]
    return lighting.model_copy(update=update) if update else lighting

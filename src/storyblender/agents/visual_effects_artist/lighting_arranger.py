"""The Lighting Arranger: hour, weather and lamps of a place become the scene's light plan; changes become new plans.

Faces are not lit here: key, fill and rim of a shot are solved by the renderer for its camera (``look.face_light``).
"""

from __future__ import annotations

import re
from dataclasses import replace

from storyblender.agents.visual_effects_artist.exterior_light import exterior
from storyblender.agents.visual_effects_artist.interior_light import interior
from storyblender.agents.visual_effects_artist.lighting_arranger_view import (
    MOST_LIGHTS,
    LightingArrangerView,
    burning_lamps,
    lighting_arranger_view,
    strongest,
)
from storyblender.catalog.light_recipes import DARKENED, MOON, mix
from storyblender.catalog.set_plan import SetPlan
from storyblender.memory.base import Color
from storyblender.memory.scene_context import Environment, Lighting, SceneSetup
from storyblender.memory.vocabulary import TimeOfDay
from storyblender.reflection import Critique, Fault

__all__ = [
    "LightingArrangerCritic",
    "LightingArrangerView",
    "RulesLightingArranger",
    "light_place",
    "lighting_arranger_view",
    "lights_out",
]

_SWITCHES = r"turn(s|ed)?|switch(es|ed)?|flip(s|ped)?|snuff(s|ed)?|blow(s|n)?"
_OUT = (
    r"\b(lights?|lamps?|power|electricity|bulbs?|candles?)\b.{0,24}\b(out|off|dies?|fails?|blow)\b"
    r"|\b(black ?out|pitch dark|plunged? into darkness|goes dark|total darkness)\b"
    rf"|\b({_SWITCHES}) (off|out)\b|^(off|out|dead|dark|darkness|black)\.?$"
)
_ON = (
    r"\b(lights?|lamps?|power|bulbs?|candles?)\b.{0,24}\b(on|back|up|lit)\b"
    rf"|\b({_SWITCHES}) on\b|\blights? (a|the) (lamp|candle)\b|^(on|lit|bright|back)\.?$"
)
_HOUR_WORDS: tuple[tuple[str, TimeOfDay], ...] = (
    (r"\b(sun ?rise|sun rises|sun (comes|is coming) up|dawn breaks|first light)\b", "dawn"),
    (r"\b(sun ?set|sun sets|sun (goes|is going) down)\b", "sunset"),
    (r"\b(night falls|night has fallen)\b", "night"),
    (r"\b(dusk|twilight) (falls|comes)\b", "dusk"),
)

_MOODS: tuple[tuple[str, dict[str, object]], ...] = (
    # Windows are dark and lamps burn "in the dark" on every night; only a dark place or dark light asks for less.
    (
        r"\b(dim|dimly|gloomy|low key|low-key|shadowy|murky|(?<!in the )dark(?! (blue|windows?|sk(y|ies)|panes?)))\b",
        {"set": 0.7, "ratio": 1.3},
    ),
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


class RulesLightingArranger:
    """Lights by recipe (notes: sets and light, 1.4; director, 4.5)."""

    def propose(self, view: LightingArrangerView) -> Lighting:
        """Return the light plan of a scene, or the light after a change of it; words of no known change change none."""
        return _of_scene(view) if view.current is None else _changed(view.current, view)

    def refine(self, draft: Lighting, critique: Critique, view: LightingArrangerView) -> Lighting:
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


def _of_scene(view: LightingArrangerView) -> Lighting:
    lighting = exterior(view) if view.plan.under_the_sky else interior(view)
    return _described(lighting, view.setup.lighting_description)


def _changed(current: Lighting, view: LightingArrangerView) -> Lighting:
    """Return the light after a change; the current light itself if the words name no change that is known."""
    words = view.change.lower()
    hour = next((time for pattern, time in _HOUR_WORDS if re.search(pattern, words)), None)
    if hour is not None and hour != view.setup.time_of_day:
        return _of_scene(replace(view, setup=view.setup.model_copy(update={"time_of_day": hour})))
    if is_outage(words):
        return lights_out(current, indoor=view.plan.indoor)
    if is_lighting_up(words):
        plan = _of_scene(replace(view, setup=view.setup.model_copy(update={"lighting_description": ""})))
        return plan if _practicals(plan) else _lamps_burn(plan, view)
    return _described(current, words)


class LightingArrangerCritic:
    """Checks that a plan can be rendered and read."""

    def judge(self, draft: Lighting, view: LightingArrangerView) -> Critique:
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
    return RulesLightingArranger().propose(LightingArrangerView(setup, plan, environment))


def is_outage(words: str) -> bool:
    """Return whether words on light say that it goes out."""
    return re.search(_OUT, words.lower()) is not None


def is_lighting_up(words: str) -> bool:
    """Return whether words on light say that it goes on."""
    return not is_outage(words) and re.search(_ON, words.lower()) is not None


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


def _practicals(lighting: Lighting) -> bool:
    return any(light.role == "practical" for light in lighting.lights)


def _lamps_burn(plan: Lighting, view: LightingArrangerView) -> Lighting:
    return plan.model_copy(update={"lights": strongest((*plan.lights, *burning_lamps(view, 1.0)), MOST_LIGHTS)})


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

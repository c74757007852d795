"""The Lighting Arranger without a model: hour, weather and lamps become a scene's light plan; changes become new plans.

Faces are not lit here: the renderer solves key, fill and rim of a shot for its camera (``look.face_light``).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from storyblender.agents.visual_effects_artist.exterior_light import light_exterior
from storyblender.agents.visual_effects_artist.interior_light import light_interior
from storyblender.agents.visual_effects_artist.light_operations import after_operations
from storyblender.agents.visual_effects_artist.lighting_arranger_view import (
    MOST_LIGHTS,
    LightingArrangerView,
    burning_lamps,
    lighting_arranger_view,
    strongest_lights,
)
from storyblender.catalog.light_recipes import DARKENED, MOON, mix
from storyblender.catalog.set_plan import SetPlan
from storyblender.memory.base import Color
from storyblender.memory.scene_context import Environment, Lighting, SceneSetup
from storyblender.memory.shot_context import LightChange
from storyblender.memory.vocabulary import LightQuality
from storyblender.reflection import Critique, Fault

__all__ = [
    "LightingArrangerCritic",
    "LightingArrangerView",
    "RulesLightingArranger",
    "light_place",
    "lighting_arranger_view",
    "lights_out",
]

_QUALITIES: dict[LightQuality, dict[str, object]] = {
    "dim": {"set": 0.7, "ratio": 1.3},
    "bright": {"set": 1.3, "ratio": 0.75},
    "harsh": {"ratio": 1.8},
    "soft": {"ratio": 0.75},
    "candlelight": {"set": 0.75, "key": (1.0, 0.66, 0.36)},
    "cold": {"key": (0.72, 0.84, 1.0)},
    "warm": {"key": (1.0, 0.82, 0.58)},
    "red": {"key": (1.0, 0.36, 0.26), "set": 0.7},
}
"""Factors on the level of the set and on the key to fill ratio, and the colour of the key light."""


class RulesLightingArranger:
    """Lights by recipe."""

    def propose(self, view: LightingArrangerView) -> Lighting:
        """Return the light plan of a scene, or the light after a change of it."""
        return _light_scene(view) if view.current is None else _change_light(view.current, view)

    def refine(self, draft: Lighting, critique: Critique, view: LightingArrangerView) -> Lighting:
        """Keep the strongest lamps; raise levels that are too dark to read; do what a critic who looked names.

        Args:
            draft: The light plan.
            critique: Its faults.
            view: The scene.
        """
        draft = after_operations(draft, critique.faults)
        kinds = {fault.kind for fault in critique.faults}
        update: dict[str, object] = {}
        if "too_many_lights" in kinds:
            update["lights"] = strongest_lights(draft.lights, MOST_LIGHTS)
        if "too_dark" in kinds:
            update["set_luminance"] = max(draft.set_luminance, 0.02)
        if "flat_faces" in kinds:
            update["face_luminance"] = draft.set_luminance * 1.2
        return draft.model_copy(update=update)


def _light_scene(view: LightingArrangerView) -> Lighting:
    """Return the light plan of a scene by its hour, weather, lamps and light qualities."""
    lighting = light_exterior(view) if view.plan.under_the_sky else light_interior(view)
    return _with_qualities(lighting, view.setup.light)


def _change_light(current: Lighting, view: LightingArrangerView) -> Lighting:
    """Return the light after the change of the view: another hour, lamps on or off, or other qualities."""
    change, setup = view.change or LightChange(), view.setup
    if change.hour is not None and change.hour != setup.time_of_day:
        return _light_scene(replace(view, setup=setup.model_copy(update={"time_of_day": change.hour})))
    if change.lamps == "off":
        return lights_out(current, indoor=view.plan.indoor)
    if change.lamps == "on":
        plan = _light_scene(replace(view, setup=setup.model_copy(update={"light": ()})))
        return plan if _has_practicals(plan) else _add_burning_lamps(plan, view)
    return _with_qualities(current, change.qualities)


class LightingArrangerCritic:
    """Checks that a plan can be rendered and read."""

    def judge(self, draft: Lighting, view: LightingArrangerView) -> Critique:
        """Return the critique of a plan: too many lamps, no light at all, faces darker than the set.

        Args:
            draft: The light plan.
            view: The scene.
        """
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
    """Return the light plan of a place without its props, as it is before the layout.

    Args:
        setup: Hour, weather and light of the place.
        plan: The set.
        environment: Its environment.
    """
    return RulesLightingArranger().propose(LightingArrangerView(setup, plan, environment))


def lights_out(lighting: Lighting, *, indoor: bool) -> Lighting:
    """Return a plan with its lamps out: light from windows stays dimmed, with a little blue ambient light.

    Args:
        lighting: The plan.
        indoor: Whether the place is a room.
    """
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


def _has_practicals(lighting: Lighting) -> bool:
    """Return whether a plan has practical lamps."""
    return any(light.role == "practical" for light in lighting.lights)


def _add_burning_lamps(plan: Lighting, view: LightingArrangerView) -> Lighting:
    """Return a plan with all lamps of the set and its props burning."""
    return plan.model_copy(update={"lights": strongest_lights((*plan.lights, *burning_lamps(view, 1.0)), MOST_LIGHTS)})


def _with_qualities(lighting: Lighting, qualities: Sequence[LightQuality]) -> Lighting:
    """Return a plan with its level, contrast and key colour changed by the qualities of the light."""
    update: dict[str, object] = {}
    for change in (_QUALITIES[quality] for quality in qualities):
        if "set" in change:
            update["set_luminance"] = round(lighting.set_luminance * float(str(change["set"])), 4)
        if "ratio" in change:
            update["key_fill_ratio"] = round(lighting.key_fill_ratio * float(str(change["ratio"])), 2)
        if "key" in change:
            update["key_color"] = change["key"]
    return lighting.model_copy(update=update) if update else lighting

"""What a person decided about set and light, applied by code to what any policy of the role proposes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from storyblender.agents.visual_effects_artist.environment_designer import (
    EnvironmentDesignerView,
    RulesEnvironmentDesigner,
    with_size,
)
from storyblender.catalog.sets import SETS
from storyblender.memory.base import Color
from storyblender.memory.scene_context import Environment, Light, Lighting, Sky
from storyblender.memory.scene_decision import LampDecision, LampKind, LightDecision, SetDecision

_WARM: Color = (1.16, 1.0, 0.72)
"""What a step of warmth does to the red, green and blue of a light."""
USUAL_WATTS: Mapping[LampKind, float] = {"POINT": 60.0, "SPOT": 150.0, "AREA": 100.0, "SUN": 3.0}
"""Power of a lamp that is added without one."""
USUAL_HEIGHT = 2.2
"""Metres above the floor of a lamp that is added without a place."""
_NO_LESS = 0.006
"""Least luminance of a set that a board can show."""


def decided_environment(draft: Environment, view: EnvironmentDesignerView, decision: SetDecision | None) -> Environment:
    """Return the set as it was proposed, with what a person decided; another kit than theirs is made by rules.

    Args:
        draft: As proposed.
        view: The scene, with the decided kit in its setup.
        decision: What a person decided; None leaves the draft as it is.
    """
    if decision is None:
        return draft
    if decision.kit is not None and draft.kit != decision.kit:
        draft = RulesEnvironmentDesigner().propose(view)
    kit, params = SETS[draft.kit], dict(draft.params)
    params |= {option: on for option, on in decision.options.items() if option in kit.options}
    params |= {} if decision.period is None else {"period": decision.period}
    params |= {} if decision.snow is None else {"snow": decision.snow}
    params |= {} if decision.height is None else {"height": kit.height.clamp(decision.height)}
    furniture = {**draft.furniture, **decision.furniture}
    made = with_surfaces(draft.model_copy(update={"params": params, "furniture": furniture}), decision)
    if decision.width is None and decision.depth is None:
        return made
    usual = {"width": kit.width.usual, "depth": kit.depth.usual}
    width, depth = (getattr(decision, name) or float(params.get(name, usual[name])) for name in ("width", "depth"))
    return with_size(made, width, depth)


def with_surfaces(environment: Environment, decision: SetDecision) -> Environment:
    """Return a set with the finishes and pictures that were decided; a finish takes the place of pictures.

    Args:
        environment: The set.
        decision: What a person decided.
    """
    update: dict[str, object] = {}
    for name, pictured in (("walls", "wall_texture"), ("ground", "ground_texture")):
        finish, texture = getattr(decision, name), getattr(decision, pictured)
        update |= {} if finish is None else {name: finish, pictured: None}
        update |= {} if texture is None else {pictured: None if texture == "none" else texture}
    return environment.model_copy(update=update)


def decided_light(draft: Lighting, decision: LightDecision | None) -> Lighting:
    """Return a light plan as it was proposed, with the warmth, brightness, contrast and key side that were decided.

    Args:
        draft: As proposed for the hour, the weather and the qualities that were decided.
        decision: What a person decided; None leaves the draft as it is.
    """
    if decision is None:
        return draft
    update: dict[str, object] = {}
    if decision.warmth:
        update |= warmed(draft, decision.warmth)
    if decision.brightness:
        gain = 2.0**decision.brightness
        update["set_luminance"] = round(max(draft.set_luminance * gain, _NO_LESS), 4)
        update["face_luminance"] = round(max(draft.face_luminance * gain, _NO_LESS), 4)
    if decision.contrast:
        update["key_fill_ratio"] = round(max(draft.key_fill_ratio * 2.0**decision.contrast, 1.0), 2)
    if decision.key_side is not None:
        update["key_side"] = decision.key_side
    if decision.lamps:
        lights = update.get("lights", draft.lights)
        update["lights"] = tuple(_with_lamps(lights if isinstance(lights, tuple) else (), decision.lamps))
    return draft.model_copy(update=update) if update else draft


def _with_lamps(lights: tuple[Light, ...], lamps: Mapping[str, LampDecision | None]) -> Iterator[Light]:
    """Yield the lights of a plan as a person decided them, then those that they added."""
    for light in lights:
        lamp = lamps.get(light.name)
        if light.name not in lamps:
            yield light
        elif lamp is not None:
            yield light.model_copy(update=lamp.model_dump(exclude_none=True))
    there = {light.name for light in lights}
    for name, lamp in lamps.items():
        if name not in there and lamp is not None and lamp.kind is not None:
            x, y, z = lamp.location or (0.0, 0.0, USUAL_HEIGHT)
            usual = {"location": (x, y, z), "target": (x, y, z - 1.0), "power": USUAL_WATTS[lamp.kind]}
            yield Light.model_validate({"name": name, **usual, **lamp.model_dump(exclude_none=True)})


def warmed(draft: Lighting, warmth: float) -> dict[str, object]:
    """Return the fields of a light plan with its colours warmer, each as bright as before.

    Args:
        draft: The light plan.
        warmth: Steps; cooler below 0.
    """

    def tinted(color: Color) -> Color:
        red, green, blue = (value * gain**warmth for value, gain in zip(color, _WARM, strict=True))
        before, after = _luminance(color), _luminance((red, green, blue))
        share = before / after if after > 0 else 1.0
        return (round(red * share, 5), round(green * share, 5), round(blue * share, 5))

    def lit(light: Light) -> Light:
        return light.model_copy(update={"color": tinted(light.color)})

    sky = Sky(**{name: tinted(getattr(draft.sky, name)) for name in Sky.model_fields})
    fog = draft.fog and draft.fog.model_copy(update={"color": tinted(draft.fog.color)})
    colors = {name: tinted(getattr(draft, name)) for name in ("ambient", "key_color", "fill_color", "rim_color")}
    return {**colors, "lights": tuple(map(lit, draft.lights)), "sky": sky, "fog": fog}


def _luminance(color: Color) -> float:
    red, green, blue = color
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue

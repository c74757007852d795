"""The Lighting Arranger played by a language model: it names the mood in terms of light, and rules light the scene."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Annotated, Any, Literal

from pydantic import Field, StringConstraints

from storyblender.agents.asking import Asker, LanguagePolicy, Notes
from storyblender.agents.story_lines import story_lines
from storyblender.agents.visual_effects_artist.light_operations import Air, with_air
from storyblender.agents.visual_effects_artist.lighting_arranger import RulesLightingArranger
from storyblender.agents.visual_effects_artist.lighting_arranger_view import LightingArrangerView, burning_lamps
from storyblender.catalog.material_entry import hex_code, hex_color
from storyblender.memory.base import Color, Identifier, scene_name, shot_name
from storyblender.memory.scene_context import Light, Lighting
from storyblender.memory.shot_context import LightChange
from storyblender.memory.vocabulary import LightQuality
from storyblender.ports import Answerer, Embedder
from storyblender.reflection import Policy

_UNLIT = 24
"""Most lamps that do not burn in a request."""

HexColor = Annotated[str, StringConstraints(pattern=r"^#[0-9a-fA-F]{6}$")]
"""Colour of light as #rrggbb; only its tint counts, not how bright it is."""


class LampNotes(Notes):
    """One light of the set: a lamp, a window, the sun."""

    name: Identifier
    """As in `lights` or `lamps_off`."""
    on: bool = True
    stops: float = Field(default=0.0, ge=-4, le=4)
    """Brighter than planned by so many stops; one stop is twice the light, -1 is half."""
    color: HexColor | None = None


class LightNotes(Notes):
    """The light of a scene, or after a change of it. What is left out stays as `planned`."""

    qualities: tuple[LightQuality, ...] | None = None
    """Character of the light, in place of that in `planned`."""
    set_stops: float = Field(default=0.0, ge=-2.5, le=2)
    """Stops by which the place is brighter than planned; -1 is half as bright."""
    face_stops: float = Field(default=0.0, ge=-2, le=1.5)
    """Stops by which faces are brighter than planned."""
    key_side: Literal["left", "right"] | None = None
    """Side of the set, as the audience sees it, from which faces are lit."""
    key_to_fill: float | None = Field(default=None, ge=1, le=16)
    """Ratio of key to fill light on faces: 2 is soft and open, 4 has form, 8 is dark on one side."""
    key_color: HexColor | None = None
    fill_color: HexColor | None = None
    rim_color: HexColor | None = None
    """Of the light along the edge of people, from behind."""
    sun_side: Literal["left", "right"] | None = None
    """Side from which sun or moon shine."""
    lamps: tuple[LampNotes, ...] = ()
    """Only the lights that are not as planned."""
    air: Air | None = None


def language_lighting_arranger(
    answerer: Answerer, embedder: Callable[[], Embedder]
) -> Policy[LightingArrangerView, Lighting]:
    """Return the Lighting Arranger played by a model.

    Rules fill what an answer leaves out, and mend levels that nobody could see.

    Args:
        answerer: The model, or a person in its place.
        embedder: Not needed: all that the answer may name is in the scene.
    """
    rules = RulesLightingArranger()
    return LanguagePolicy(
        Asker(answerer, "lighting_arranger", LightNotes),
        show=lambda view: _shown(view, rules.propose(view)),
        check=lambda answer, view: _wrong_lamps(answer, view, rules),
        draft_of=lambda answer, view: _lighting(answer, view, rules),
        subject=subject_of,
        mend=rules.refine,
    )


def subject_of(view: LightingArrangerView) -> str:
    """Return what a light plan is for, for people: the scene, or the shot in which the light changes."""
    if view.outline is None:
        return ""
    number = view.outline.scene_id
    return shot_name(number, view.shot_id) if view.shot_id else scene_name(number)


def _lamps(view: LightingArrangerView) -> dict[str, Light]:
    """Return every lamp that there is in a scene as it burns at night, by name."""
    objects = view.layout.objects if view.layout is not None else ()
    lit = (*(item.node_id for item in view.plan.furnishings), *(item.asset_id for item in objects), *view.carried)
    return {light.name: light for light in burning_lamps(replace(view, burning=dict.fromkeys(lit, True)), 1.0)}


def known_lights(view: LightingArrangerView) -> set[str]:
    """Return the names of the lights of a scene: those that rules plan, and the lamps that do not burn."""
    return {light.name for light in RulesLightingArranger().propose(view).lights} | {*_lamps(view)}


def _wrong_lamps(answer: LightNotes, view: LightingArrangerView, rules: RulesLightingArranger) -> Iterator[str]:
    """Yield a sentence for every lamp of an answer that does not exist, or that the story has just put out."""
    planned, known = {light.name for light in rules.propose(view).lights}, known_lights(view)
    dark = view.change is not None and view.change.lamps == "off"
    for lamp in answer.lamps:
        if lamp.name not in known:
            yield f"there is no light {lamp.name!r}; take one of `lights` or `lamps_off`, or leave it out"
        elif dark and lamp.on and lamp.name not in planned:
            yield f"the story puts the lamps out in this shot; {lamp.name!r} cannot burn"


def _lighting(answer: LightNotes, view: LightingArrangerView, rules: RulesLightingArranger) -> Lighting:
    """Return the rules' light plan with what the answer says."""
    if answer.qualities is not None:
        change = (view.change or LightChange()).model_copy(update={"qualities": answer.qualities})
        setup = view.setup.model_copy(update={"light": answer.qualities})
        view = replace(view, setup=setup, change=change if view.change is not None else None)
    plan = rules.propose(replace(view, sun_side=answer.sun_side or view.sun_side))
    update: dict[str, Any] = {"lights": tuple(_with_lamps(answer.lamps, plan, view))}
    for name, stops in (("set_luminance", answer.set_stops), ("face_luminance", answer.face_stops)):
        update |= {name: round(getattr(plan, name) * 2**stops, 4)} if stops else {}
    colors = {name: getattr(answer, name) for name in ("key_color", "fill_color", "rim_color")}
    update |= {name: _tint(code) for name, code in colors.items() if code is not None}
    update |= {"key_side": answer.key_side} if answer.key_side is not None else {}
    update |= {"key_fill_ratio": answer.key_to_fill} if answer.key_to_fill is not None else {}
    if plan.fog is not None and answer.air is not None:
        update["fog"] = with_air(plan.fog, answer.air)
    return plan.model_copy(update=update)


def _with_lamps(notes: tuple[LampNotes, ...], plan: Lighting, view: LightingArrangerView) -> Iterator[Light]:
    """Yield the lights of a plan as the notes have them; lamps that are lit now are as strong as those beside them."""
    told, lamps = {note.name: note for note in notes}, _lamps(view)
    own = {light.name for light in plan.lights}
    gains = [light.power / lamps[light.name].power for light in plan.lights if light.name in lamps]
    gain = max(gains, default=1.0)
    lit = [lamps[note.name] for note in notes if note.name in lamps and note.name not in own]
    added = (light.model_copy(update={"power": light.power * gain}) for light in lit)
    for light in (*plan.lights, *added):
        note = told.get(light.name)
        if note is None:
            yield light
        elif note.on:
            tint = {"color": _tint(note.color)} if note.color is not None else {}
            yield light.model_copy(update={"power": round(light.power * 2**note.stops, 3), **tint})


def _tint(code: str) -> Color:
    """Return the colour of a light, its brightest part at one; black is white light."""
    red, green, blue = hex_color(code)
    brightest = max(red, green, blue)
    return (red / brightest, green / brightest, blue / brightest) if brightest > 0 else (1.0, 1.0, 1.0)


def _shown(view: LightingArrangerView, planned: Lighting) -> dict[str, Any]:
    """Return what a model is shown of a scene; ``planned`` is the light of the rules."""
    size, own = view.plan.size, {light.name for light in planned.lights}
    shown: dict[str, Any] = {
        "place": view.setup.place,
        "kit": view.plan.kit,
        "indoors": view.plan.indoor,
        "hour": view.setup.time_of_day,
        "weather": view.setup.weather,
        "size": {"left": size.x_negative, "right": size.x, "front": size.y_negative, "back": size.y},
        "people_at_first": people_at_first(view),
        "story": story_lines(view.outline),
    }
    if view.change is not None:
        shown["change"] = {"in_shot": view.shot_id, **view.change.model_dump(exclude_defaults=True)}
        shown["before"] = shown_levels(view.current) if view.current is not None else {}
    return shown | {
        "planned": shown_levels(planned) | {"qualities": list(view.setup.light)},
        "lights": [_shown_light(light) for light in planned.lights],
        "lamps_off": [_shown_light(light) for name, light in _lamps(view).items() if name not in own][:_UNLIT],
    }


def people_at_first(view: LightingArrangerView) -> dict[str, list[float]]:
    """Return where people are as the scene opens."""
    people = {asset.asset_id for asset in view.assets if asset.asset_type == "character"}
    objects = view.layout.objects if view.layout is not None else ()
    placed = (item for item in objects if item.asset_id in people)
    return {item.asset_id: [round(each, 1) for each in item.location[:2]] for item in placed}


def shown_levels(plan: Lighting) -> dict[str, Any]:
    """Return the levels of a plan; luminances are shares of white."""
    colors = {name: hex_code(getattr(plan, name)) for name in ("key_color", "fill_color", "rim_color")}
    levels = {"set": plan.set_luminance, "faces": plan.face_luminance, "key_to_fill": plan.key_fill_ratio}
    levels = {name: round(level, 3) for name, level in levels.items()}
    return {**levels, **colors, "key_side": plan.key_side or "as the camera wants"}


def _shown_light(light: Light) -> dict[str, Any]:
    """Return a light of the set; its place is x to the right, y to the back, z up in metres."""
    place = [round(each, 1) for each in light.location]
    shown = {"name": light.name, "role": light.role, "place": place, "watts": round(light.power, 1)}
    return shown | {"color": hex_code(light.color)}

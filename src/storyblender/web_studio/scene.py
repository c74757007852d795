"""The set and the light of a scene as the page shows them, with all that they can be changed to."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import get_args

from storyblender.catalog.light_recipes import HOURS
from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.sets import SETS, plan_of
from storyblender.catalog.sets.decided import has_ground, has_walls
from storyblender.catalog.sets.finishes import FINISHES
from storyblender.edits.targets import scene_named
from storyblender.memory.base import Described, scene_name, shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.panorama import Panorama
from storyblender.memory.scene_context import Environment, Light
from storyblender.memory.scene_decision import LampDecision, LightDecision
from storyblender.memory.texture import Texture
from storyblender.memory.vocabulary import LightQuality, Period, TimeOfDay, Weather


class Choice(Described):
    """Something that can be chosen."""

    key: str
    """As edits name it."""
    name: str
    """As people call it."""


class LampValue(Described):
    """A lamp of the scene's light plan."""

    name: str
    """Edits name it so."""
    kind: str
    """POINT, SPOT, AREA or SUN."""
    power: float
    """Watts; of a SUN watts a square metre."""
    color: tuple[float, float, float]
    """Red, green and blue, scene-linear."""


class SceneDetails(Described):
    """Everything about the set and the light of a scene that an edit may change."""

    scene: str
    """Its name."""
    title: str
    """Its heading."""
    shots: tuple[str, ...]
    """Names of its shots, in their order."""
    kit: str
    """Key of the set kit."""
    kits: tuple[Choice, ...]
    """Kits that it can have: those indoors or those outdoors."""
    options: dict[str, bool]
    """Options of the kit, on or off."""
    walls: str | None
    """Material that a person gave the walls; empty for the kit's own, None where there are none."""
    ground: str | None
    """The same of the floor or the ground."""
    surfaces: dict[str, str]
    """Pictures that ``walls`` and ``ground`` are made of, as the story names them; without those that have none."""
    repeats: dict[str, float]
    """Metres after which those pictures repeat."""
    materials: tuple[str, ...]
    """What both can be made of."""
    period: str
    """When it was furnished, if a person decided it."""
    snow: bool
    """Whether snow lies on the ground."""
    time_of_day: str
    """The hour."""
    weather: str
    """In the air and in the sky."""
    qualities: tuple[str, ...]
    """Character of the light."""
    warmth: float
    """Steps from the crew's light that a person decided."""
    brightness: float
    """Stops, likewise."""
    contrast: float
    """Stops, likewise."""
    key_side: str
    """From which side faces are lit, if a person decided it."""
    lamps: tuple[LampValue, ...]
    """Of the plan that the scene begins with."""
    outdoors: bool
    """Whether it can be lit by a panorama."""
    panorama: str
    """File name of the panorama that a person chose for the scene, or that lights it; empty where there is none."""
    panorama_rests: bool
    """Whether it does not light the scene at its hour."""
    panoramas: tuple[str, ...]
    """File names of those that it can be lit by: outside, those of the folder."""
    words: dict[str, tuple[str, ...]]
    """What hour, weather, qualities and period can be."""
    decided: tuple[str, ...]
    """What a person decided, in words."""
    locked: tuple[str, ...]
    """Parts that are locked."""


def scene_details(graph: ContinuityMemoryGraph, name: str, panoramas: Sequence[str] = ()) -> SceneDetails:
    """Return a scene as the page shows it.

    Args:
        graph: The story.
        name: Such as ``SC010``.
        panoramas: File names of those in the folder.

    Raises:
        InputError: There is no such scene.
    """
    scene = scene_named(graph, name)
    setup, light = scene.decided_setup, scene.light_decision or LightDecision()
    environment, plan = scene.environment, scene.lighting
    surfaces = _surfaces(environment)
    panorama = _panorama(graph, light, plan.panorama.digest if plan is not None and plan.panorama is not None else "")
    kit = SETS.get(environment.kit if environment is not None else setup.kit)
    built = plan_of(environment) if environment is not None and kit is not None else None
    outline = next(each for each in graph.outline if each.scene_id == scene.scene_id)
    place = scene.set_decision
    decisions = {"set": place, "light": scene.light_decision, "staging": scene.layout_decision}
    indoor = setup.scene_type == "indoor"
    return SceneDetails(
        scene=scene_name(scene.scene_id),
        title=outline.numbered_title,
        shots=tuple(shot_name(shot.scene_id, shot.shot_id) for shot in graph.shots_in_order(scene.scene_id)),
        kit=kit.key if kit is not None else "",
        kits=tuple(Choice(key=each.key, name=each.name) for each in SETS.values() if each.indoor == indoor),
        options=_options(kit.options, environment.params if environment is not None else {}) if kit is not None else {},
        walls=(environment.walls or "") if environment and built is not None and has_walls(built) else None,
        ground=(environment.ground or "") if environment and built is not None and has_ground(built) else None,
        surfaces={part: texture.provenance.file for part, texture in surfaces.items()},
        repeats={part: texture.metres for part, texture in surfaces.items()},
        materials=tuple(sorted({**FINISHES, **MATERIALS})),
        period=(place.period if place is not None else None) or "",
        snow=setup.snow,
        time_of_day=setup.time_of_day,
        weather=setup.weather,
        qualities=setup.light,
        warmth=light.warmth or 0.0,
        brightness=light.brightness or 0.0,
        contrast=light.contrast or 0.0,
        key_side=light.key_side or "",
        lamps=tuple(_lamps(plan.lights if plan is not None else (), light)),
        outdoors=not indoor,
        panorama=panorama,
        panorama_rests=bool(panorama) and bool(HOURS[setup.time_of_day].lamps),
        panoramas=() if indoor else tuple(panoramas),
        words={
            "time_of_day": get_args(TimeOfDay), "weather": get_args(Weather), "qualities": get_args(LightQuality),
            "period": get_args(Period),
        },
        decided=tuple(f"{part}: {each.words}" for part, each in decisions.items() if each is not None and each.words),
        locked=scene.locked,
    )  # fmt: skip


def _surfaces(environment: Environment | None) -> dict[str, Texture]:
    found = {"walls": environment.wall_texture, "ground": environment.ground_texture} if environment is not None else {}
    return {part: texture for part, texture in found.items() if texture is not None}


def _panorama(graph: ContinuityMemoryGraph, light: LightDecision, digest: str) -> str:
    """Return the file of the panorama that is decided, else of the one with a digest."""
    if isinstance(light.panorama, Panorama):
        return light.panorama.provenance.file
    return next((each.provenance.file for each in graph.panoramas if each.provenance.digest == digest), "")


def _lamps(lights: Sequence[Light], decision: LightDecision) -> Iterator[LampValue]:
    """Yield the lamps of a plan with what a person decided about them, which the crew may not have lit yet."""
    for lamp in lights:
        decided = decision.lamps.get(lamp.name, LampDecision())
        if decided is not None:
            power = lamp.power if decided.power is None else decided.power
            yield LampValue(name=lamp.name, kind=lamp.kind, power=round(power, 2), color=decided.color or lamp.color)


def _options(known: Mapping[str, object], params: Mapping[str, object]) -> dict[str, bool]:
    """Return the options of a kit as they are; those that are no switch are left out."""
    return {name: bool(params.get(name, usual)) for name, usual in known.items() if isinstance(usual, bool)}

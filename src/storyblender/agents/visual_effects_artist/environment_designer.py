"""The Environment Designer: a place of the script becomes a set kit with its options, large enough for the scene."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from storyblender.agents.visual_effects_artist.period import OLDER_KITS, PERIOD_OF_AGE
from storyblender.catalog.registry import ParamValue
from storyblender.catalog.sets import SETS, SetKit, plan_of
from storyblender.catalog.sets.places import kit_of
from storyblender.memory.base import Vec2, content_hash
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import Environment, SceneSetup
from storyblender.memory.vocabulary import Age
from storyblender.reflection import Critique, Fault

_CROWD = 3
"""People for whom a kit has room at its usual size."""
_ROOM_FOR_ONE = 1.6
"""Square metres for each further person."""
_SPARE = 3.0
"""Square metres of the script's own things for which a kit's usual size has room."""
_BESIDE, _SHARE_BESIDE = 3.0, 0.6
"""Metres of width beside the longest thing; at most this share of a small kit's usual width."""
_ROOM_TO_WALK = 2.2
"""Metres beyond the longest walk of a shot."""


@dataclass(frozen=True)
class EnvironmentDesignerView:
    """What the Environment Designer sees of a scene.

    Attributes:
        setup: The place in words.
        footprints: Width and depth in metres of the scene's own objects.
        people: Number of people on stage at once.
        travel: Metres of the longest walk in one shot.
        reference: Environment of the earlier scene in the same place; None if there is none.
        story: Summary of the story; its words choose options of a set of the past.
        headings: Headings of all scenes; their words tell a story in space.
        age: Age of the story; None if its words do not tell it.
    """

    setup: SceneSetup
    footprints: tuple[Vec2, ...] = ()
    people: int = 2
    travel: float = 0.0
    reference: Environment | None = None
    story: str = ""
    headings: str = ""
    age: Age | None = None


def environment_designer_view(graph: ContinuityMemoryGraph, scene_id: int) -> EnvironmentDesignerView:
    """Return the Environment Designer's projection of the graph.

    Args:
        graph: The graph, with the Director's plan and the script's own assets.
        scene_id: Number of the scene.
    """
    scene = graph.scene(scene_id)
    reference = scene.setup.reference_scene_id
    things = (asset for asset in graph.assets_of(scene_id) if asset.asset_type == "object")
    walks = (action.distance or 0.0 for shot in graph.shots_of(scene_id) for action in shot.character_actions)
    return EnvironmentDesignerView(
        setup=scene.setup,
        footprints=tuple(asset.canonical.dimensions[:2] for asset in things if asset.canonical is not None),
        people=graph.people_in(scene_id),
        travel=max(walks, default=0.0),
        reference=graph.scene(reference).environment if reference is not None else None,
        story=graph.story_summary,
        headings=" / ".join(outline.heading for outline in graph.outline),
        age=graph.age,
    )


class RulesEnvironmentDesigner:
    """Chooses the kit by the words of the heading and the scene; chooses its size by what must fit."""

    def propose(self, view: EnvironmentDesignerView) -> Environment:
        """Return the environment of a scene; the same place as before gets the same one, with or without snow."""
        setup = view.setup
        if view.reference is not None:
            ground = {"snow": True} if _has_snow(setup) else {}
            params = {name: value for name, value in view.reference.params.items() if name != "snow"} | ground
            return view.reference.model_copy(update={"params": params})
        kit = SETS[kit_of(setup)]
        period = PERIOD_OF_AGE[view.age] if view.age is not None else kit.period
        if not setup.kit:
            kit = SETS[OLDER_KITS.get(period, {}).get(kit.key, kit.key)]
        params: dict[str, ParamValue] = {"width": kit.width.usual, "depth": kit.depth.usual}
        if period != kit.period:
            params["period"] = period
        words = f"{setup.place} {setup.layout_description} {setup.ground_description} {setup.wall_description or ''}"
        told = f"{words} {view.story}" if period == "past" else words
        params |= _chosen_options(kit, words.lower(), told.lower(), view.headings.lower())
        if _has_snow(setup):
            params["snow"] = True
        seed = int(content_hash(setup.place.upper(), kit.key), 16) % 100_000
        return _with_size(Environment(kit=kit.key, params=params, seed=seed), *_needed_size(view, kit))

    def refine(self, draft: Environment, critique: Critique, view: EnvironmentDesignerView) -> Environment:
        """Return the environment at the size that the critic computed.

        Args:
            draft: The environment.
            critique: Its faults, with ``width`` and ``depth`` in metres as fixes.
            view: The scene.
        """
        for fault in critique.faults:
            if "width" in fault.fix:
                draft = _with_size(draft, float(fault.fix["width"]), float(fault.fix["depth"]))
        return draft


class EnvironmentDesignerCritic:
    """Checks that everything fits into the set, and that it is indoors or outdoors as the scene is."""

    def judge(self, draft: Environment, view: EnvironmentDesignerView) -> Critique:
        """Return the critique of an environment: too small, indoors instead of outdoors, or too short for an object.

        Args:
            draft: The environment.
            view: The scene.
        """
        plan, faults = plan_of(draft), []
        if plan.indoor != (view.setup.scene_type == "indoor"):
            faults.append(
                Fault(kind="wrong_sort", message=f"{draft.kit} does not suit {view.setup.scene_type}", severity=4.0)
            )
        width, depth = plan.size.x - plan.size.x_negative, plan.size.y - plan.size.y_negative
        kit = SETS[draft.kit]
        want_width, want_depth = _needed_size(view, kit)
        if width < kit.width.clamp(want_width) - 0.05 or depth < kit.depth.clamp(want_depth) - 0.05:
            message = f"the set is {width:.1f} x {depth:.1f} m; the scene wants {want_width:.1f} x {want_depth:.1f} m"
            fix: dict[str, float | str] = {"width": want_width, "depth": want_depth}
            faults.append(Fault(kind="too_small", message=message, severity=3.0, fix=fix))
        longest = max((max(size) for size in view.footprints), default=0.0)
        if longest + 1.5 > max(width, depth):
            message = f"an object is {longest:.1f} m long, the set {max(width, depth):.1f} m"
            faults.append(Fault(kind="does_not_fit", message=message, severity=1.5))
        return Critique.of(tuple(faults))


def _needed_size(view: EnvironmentDesignerView, kit: SetKit) -> Vec2:
    """Return the width and depth in metres that the people, things and walks of a scene need in a kit."""
    usual = kit.width.usual * kit.depth.usual
    extra = _ROOM_FOR_ONE * max(0, view.people - _CROWD)
    extra += max(0.0, 1.5 * sum(width * depth for width, depth in view.footprints) - _SPARE)
    scale = math.sqrt(1.0 + extra / usual)
    longest = max((max(size) for size in view.footprints), default=0.0)
    beside = min(_BESIDE, _SHARE_BESIDE * kit.width.usual)
    width = max(kit.width.usual * scale, view.travel + _ROOM_TO_WALK, longest + beside)
    return round(width, 1), round(kit.depth.usual * scale, 1)


def _with_size(environment: Environment, width: float, depth: float) -> Environment:
    """Return an environment at a width and depth in metres, within the limits of its kit."""
    kit = SETS[environment.kit]
    size: dict[str, ParamValue] = {"width": kit.width.clamp(width), "depth": kit.depth.clamp(depth)}
    return environment.model_copy(update={"params": environment.params | size})


_OPTION_WORDS = {
    "log": r"\blog\b|cabin|lodge",
    "pines": r"\bpines?\b|\bfirs?\b|snow",
    "palms": r"palms?|tropic|island|lagoon|jungle|rain ?forest",
    "dry": r"\bdry\b|prairie|savanna|wheat|corn|dusty|steppe",
    "lighthouse": r"light ?house",
    "cranes": r"\bcranes?\b",
    "space": r"\bspace|star ?ship|\bstars\b|orbit|shuttle|galax|planet",
    "frontier": r"frontier|western town|cowboy|gunslinger|sheriff|marshal|saloon|stagecoach|gold rush",
    "railway": r"station|rail|\btrains?\b|ticket|depot",
    "train": r"\btrain (stands|waits|stops|is standing|has stopped|at the platform)",
    "air": r"\bplane|air ?plane|aero ?plane|aircraft|airliner|\bjet\b|flight",
    "taxi": r"\btaxi|\bcab\b|cabbie",
}
_SNOW = r"\bsnow(y|field|drift|bound)?\b|glacier|\barctic|\bantarctic|blizzard|\bfrozen"
_SHIP_IN_SPACE = r"\bspace|star ?ship|airlock|\bhyper|cryo|\borbit"
_ON_EARTH = r"hotel|hospital|school|office|house|home|flat|apartment|prison|police|court|castle|palace|museum|theat"
"""Words of a place that is not aboard a ship in space, though the story has one."""


def _has_snow(setup: SceneSetup) -> bool:
    """Return whether a place has snow on the ground, by its weather and words."""
    return setup.weather == "snow" or re.search(_SNOW, f"{setup.place} {setup.ground_description}".lower()) is not None


def _chosen_options(kit: SetKit, words: str, story: str, headings: str) -> dict[str, ParamValue]:
    """Return the options of a kit that the words of the place, the story or the headings ask for."""
    aboard = re.search(_SHIP_IN_SPACE, headings) and not re.search(_ON_EARTH, words)
    options: dict[str, ParamValue] = {}
    for name in kit.options:
        listed = "|".join(rf"\b{re.escape(word)}" for word in kit.option_words.get(name, ())) or _OPTION_WORDS[name]
        if re.search(listed, story if name == "frontier" else words) or (name == "space" and aboard):
            options[name] = True
    return options

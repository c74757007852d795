"""The Environment Designer: a place of the script becomes a set kit with its parameters, large enough for the scene."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from storyblender.catalog.registry import ParamValue
from storyblender.catalog.sets import SETS, SetKit, plan_of
from storyblender.catalog.sets.drawing import Period
from storyblender.catalog.sets.places import kit_of
from storyblender.catalog.years import years_in
from storyblender.memory.base import Vec2, content_hash
from storyblender.memory.scene_context import Environment, SceneSetup
from storyblender.reflection import Critique, Fault

_CROWD = 3
"""People a kit has room for at its usual size."""
_ROOM_FOR_ONE = 1.6
"""Square metres for each further person."""
_SPARE = 3.0
"""Square metres of the script's own things that a kit's usual size has room for."""
_ROOM_TO_WALK = 2.2
"""Metres beyond the longest way somebody walks."""


@dataclass(frozen=True)
class EnvironmentView:
    """What the Environment Designer sees.

    Attributes:
        setup: The place in words.
        footprints: Width and depth in metres of the scene's own objects.
        people: How many are on stage at once.
        travel: The longest way somebody walks in one shot, metres.
        reference: The environment of the earlier scene in the same place.
        story: Any words that tell the period: summary, descriptions of characters.
        headings: Of all scenes: they tell a story in space.
    """

    setup: SceneSetup
    footprints: tuple[Vec2, ...] = ()
    people: int = 2
    travel: float = 0.0
    reference: Environment | None = None
    story: str = ""
    headings: str = ""


class RulesEnvironmentDesigner:
    """Chooses by the words of the heading, then by who and what is there; sizes by what must fit."""

    def propose(self, view: EnvironmentView) -> Environment:
        """Return the environment; the same place again gets the same one, but for the snow."""
        setup = view.setup
        if view.reference is not None:
            ground = {"snow": True} if _snow_lies(setup) else {}
            params = {name: value for name, value in view.reference.params.items() if name != "snow"} | ground
            return view.reference.model_copy(update={"params": params})
        kit = SETS[kit_of(setup)]
        seen = " ".join(setup.asset_ids).replace("_", " ")  # a sheriff or a laptop tells the time
        period = period_of(f"{setup.place} {setup.layout_description} {seen} {view.story}", kit)
        if period == "past":
            kit = SETS[_IN_THE_PAST.get(kit.key, kit.key)]
        params: dict[str, ParamValue] = {"width": kit.width.usual, "depth": kit.depth.usual}
        if period != kit.period:
            params["period"] = period
        words = f"{setup.place} {setup.layout_description} {setup.ground_description} {setup.wall_description or ''}"
        told = f"{words} {view.story}" if period == "past" else words
        params |= _options(kit, words.lower(), told.lower(), view.headings.lower())
        if _snow_lies(setup):
            params["snow"] = True
        seed = int(content_hash(setup.place.upper(), kit.key), 16) % 100_000
        return _enlarged(Environment(kit=kit.key, params=params, seed=seed), *_wanted(view, kit))

    def refine(self, draft: Environment, critique: Critique, view: EnvironmentView) -> Environment:
        """Return the set at the size the critic computed."""
        for fault in critique.faults:
            if "width" in fault.fix:
                draft = _enlarged(draft, float(fault.fix["width"]), float(fault.fix["depth"]))
        return draft


class EnvironmentCritic:
    """Measures the plan: does everything fit, and is the set of the right sort?"""

    def judge(self, draft: Environment, view: EnvironmentView) -> Critique:
        """Score ten less for a room too small or a roof where the sky should be."""
        plan, faults = plan_of(draft), []
        if plan.indoor != (view.setup.scene_type == "indoor"):
            faults.append(
                Fault(kind="wrong_sort", message=f"{draft.kit} does not suit {view.setup.scene_type}", severity=4.0)
            )
        width, depth = plan.size.x - plan.size.x_negative, plan.size.y - plan.size.y_negative
        kit = SETS[draft.kit]
        want_width, want_depth = _wanted(view, kit)
        if width < kit.width.clamp(want_width) - 0.05 or depth < kit.depth.clamp(want_depth) - 0.05:
            message = f"the set is {width:.1f} x {depth:.1f} m; the scene wants {want_width:.1f} x {want_depth:.1f} m"
            fix: dict[str, float | str] = {"width": want_width, "depth": want_depth}
            faults.append(Fault(kind="too_small", message=message, severity=3.0, fix=fix))
        longest = max((max(size) for size in view.footprints), default=0.0)
        if longest + 1.5 > max(width, depth):
            message = f"an object is {longest:.1f} m long, the set {max(width, depth):.1f} m"
            faults.append(Fault(kind="does_not_fit", message=message, severity=1.5))
        return Critique.of(tuple(faults))


def _wanted(view: EnvironmentView, kit: SetKit) -> Vec2:
    """Return the width and depth that the people, the things and the ways of a scene ask for."""
    usual = kit.width.usual * kit.depth.usual
    extra = _ROOM_FOR_ONE * max(0, view.people - _CROWD)
    extra += max(0.0, 1.5 * sum(width * depth for width, depth in view.footprints) - _SPARE)
    scale = math.sqrt(1.0 + extra / usual)
    longest = max((max(size) for size in view.footprints), default=0.0)
    width = max(kit.width.usual * scale, view.travel + _ROOM_TO_WALK, longest + 3.0)
    return round(width, 1), round(kit.depth.usual * scale, 1)


def _enlarged(environment: Environment, width: float, depth: float) -> Environment:
    kit = SETS[environment.kit]
    size: dict[str, ParamValue] = {"width": kit.width.clamp(width), "depth": kit.depth.clamp(depth)}
    return environment.model_copy(update={"params": environment.params | size})


_IN_THE_PAST = {"trench": "open_ground"}
"""What a place is before its time: knights meet on a field."""
_PERIOD_WORDS: dict[Period, str] = {
    "past": "medieval knight king queen prince princess castle viking victorian sword samurai pirate sheriff saloon "
    "cowboy western frontier gunslinger outlaw stagecoach ancient roman wizard peasant monk inn marshal gunfight",
    "modern": "laptop smartphone cellphone iphone computer monitor internet drone wifi tablet robot spaceship future "
    "email selfie hoodie sneakers cctv app video trawler winch",
    "classic": "fedora typewriter radio gramophone telephone noir wartime trolley jukebox",
}
_PERIOD_YEARS: dict[Period, tuple[int, int]] = {"past": (1000, 1899), "classic": (1900, 1979), "modern": (1980, 2099)}
"""First and last year of a period."""


def period_of(words: str, kit: SetKit) -> Period:
    """Return the period that the words speak of most, or the kit's own."""
    tokens = [token.rstrip("s") for token in re.findall(r"[a-z]+", words.lower())]
    years = years_in(words)
    best, most = kit.period, 0
    for period, listed in _PERIOD_WORDS.items():
        known = {word.rstrip("s") for word in listed.split()}
        first, last = _PERIOD_YEARS[period]
        count = sum(token in known for token in tokens) + 3 * sum(first <= year <= last for year in years)
        if count > most:
            best, most = period, count
    return best


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
"""A corridor or a bridge of a story in space is aboard, unless its own heading says where else it is."""


def _snow_lies(setup: SceneSetup) -> bool:
    return setup.weather == "snow" or re.search(_SNOW, f"{setup.place} {setup.ground_description}".lower()) is not None


def _options(kit: SetKit, words: str, story: str, headings: str) -> dict[str, ParamValue]:
    """Return what a kit is told: by the words of the place, or what the story is for a street of its age."""
    aboard = re.search(_SHIP_IN_SPACE, headings) and not re.search(_ON_EARTH, words)
    options: dict[str, ParamValue] = {}
    for name in kit.options:
        listed = "|".join(rf"\b{re.escape(word)}" for word in kit.option_words.get(name, ())) or _OPTION_WORDS[name]
        if re.search(listed, story if name == "frontier" else words) or (name == "space" and aboard):
            options[name] = True
    return options

"""The set kits of the built-in library and the one door to their plans: ``plan_of``. Pure; no bpy."""

from __future__ import annotations

from functools import lru_cache
from typing import get_args

import numpy as np

from storyblender.catalog.registry import Catalog, ParamValue
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets import (
    airfield,
    alley,
    attic,
    balcony,
    bar,
    barn,
    basement,
    bathroom,
    beach,
    bedroom,
    bridge,
    cafe,
    car,
    carriage,
    cave,
    cell,
    cemetery,
    church,
    classroom,
    coach,
    control_room,
    corridor,
    cottage,
    courtroom,
    desert,
    dining_room,
    dock,
    elevator,
    forest,
    gallery,
    great_hall,
    greenhouse,
    gym,
    hospital_ward,
    interrogation,
    kitchen,
    laboratory,
    library,
    lighthouse,
    living_room,
    lobby,
    locker_room,
    motel_room,
    mountain,
    nursery,
    office,
    open_ground,
    park,
    plain_room,
    platform,
    police_station,
    pool,
    porch,
    restaurant_kitchen,
    rooftop,
    ship_deck,
    shop,
    space_hull,
    square,
    stadium,
    stairwell,
    street,
    subway,
    supermarket,
    tatami_room,
    tent,
    theatre,
    trench,
    vineyard,
    waiting_room,
    warehouse,
    workshop,
)
from storyblender.catalog.sets.decided import with_decisions
from storyblender.catalog.sets.drawing import Period, SetParams
from storyblender.catalog.sets.from_file import kits_from_files
from storyblender.catalog.sets.kit import SetKit, Span
from storyblender.catalog.sets.lived_in import lived_in
from storyblender.catalog.sets.period import fit_to_period
from storyblender.catalog.sets.snow import under_snow
from storyblender.errors import InputError
from storyblender.memory.scene_context import Environment

__all__ = ["SETS", "SetKit", "Span", "furnished_in", "plan_of"]

SETS: Catalog[SetKit] = Catalog(
    "set",
    tuple(
        module.KIT
        for module in (
            plain_room, living_room, bedroom, motel_room, nursery, tatami_room, kitchen, dining_room,
            restaurant_kitchen, bathroom, cafe, bar, office, police_station, corridor, stairwell, hospital_ward,
            classroom, laboratory, library, cell, interrogation, shop, supermarket, basement, lobby, waiting_room,
            theatre, church, great_hall, courtroom, cottage, attic, lighthouse, tent, cave, warehouse, workshop, barn,
            gym, locker_room, control_room, elevator, gallery, greenhouse, subway, carriage, coach, car,
            open_ground, vineyard, street, alley, square, park, porch, cemetery, pool, stadium, forest, beach, dock,
            airfield, rooftop, balcony, bridge, platform, trench, desert, mountain, ship_deck, space_hull,
        )
    )
    + kits_from_files(),
)  # fmt: skip
"""Indoor kits first, each group from the most general to the most specific; then those of the kit files."""


def plan_of(environment: Environment) -> SetPlan:
    """Return the plan of a set: the same environment, the same plan.

    Args:
        environment: A kit, its parameters (``width``, ``depth``, ``height`` in metres, ``period``, ``snow`` if it
            lies, the kit's own options) and a seed. Dimensions are kept within what the kit can do.

    Raises:
        InputError: No such kit, or no such parameter.
    """
    return _plan(environment.model_dump_json())


def furnished_in(environment: Environment) -> Period:
    """Return the period in which a set is furnished. Raises InputError for a period that does not exist."""
    kit = SETS[environment.kit]
    return _params(kit, environment.params).period


@lru_cache(maxsize=64)
def _plan(environment_json: str) -> SetPlan:
    """Return the plan of an environment given as JSON, so that plans can be cached."""
    environment = Environment.model_validate_json(environment_json)
    if environment.kit not in SETS:
        raise InputError(f"the catalog has no set kit called {environment.kit!r}", mend=f"it has {sorted(SETS)}")
    kit = SETS[environment.kit]
    params = _params(kit, environment.params)
    plan = kit.draw(params, np.random.default_rng(environment.seed))
    plan = fit_to_period(plan, params.period)
    plan = lived_in(plan, kit.room, params.period, environment.seed)
    plan = under_snow(plan) if environment.params.get("snow") else plan
    return with_decisions(plan, environment) if environment.decided else plan


def _params(kit: SetKit, given: dict[str, ParamValue]) -> SetParams:
    """Return a kit's parameters, with dimensions kept within its limits; raises InputError for unknown ones."""
    known = {"width", "depth", "height", "period", "snow", *kit.options}
    unknown = sorted(set(given) - known)
    if unknown:
        raise InputError(f"the set kit {kit.key!r} has no parameter {unknown[0]!r}", mend=f"it has {sorted(known)}")
    period = given.get("period", kit.period)
    if period not in get_args(Period):
        raise InputError(f"there is no period {period!r}", mend=f"choose one of {', '.join(get_args(Period))}")
    return SetParams(
        width=kit.width.clamp(float(given.get("width", kit.width.usual))),
        depth=kit.depth.clamp(float(given.get("depth", kit.depth.usual))),
        height=kit.height.clamp(float(given.get("height", kit.height.usual))),
        period=period,  # pyright: ignore[reportArgumentType]
        options={name: given.get(name, default) for name, default in kit.options.items()},
    )

"""Which people and things of a reading are on the asset sheet, under which id and name."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from string import capwords

from storyblender.agents.director.creatures import is_creature
from storyblender.agents.director.fixtures import head_of, is_fixture
from storyblender.agents.director.reading import Person, Reading, Thing, ids_in
from storyblender.catalog.fixtures import fixtures_called
from storyblender.catalog.sets import SETS, plan_of
from storyblender.memory.scene_context import Environment

_TAPS = frozenset({"tap", "taps", "faucet", "faucets"})
_RAILS = frozenset({"rail", "rails", "railing", "railings"})
_HUNG = 0.8
"""Metres above the floor from which a part of a set hangs on a wall, such as a rail with pegs: nobody leans on it."""
_BASINS = frozenset({"sink", "basin", "washbasin", "bath", "bathtub", "tub"})


class StoryAssets:
    """All people and things that appear on stage in the story.

    Args:
        reading: The reading of the script.
        fitted: Part -> vehicle of the parts that are in one place on it; empty for the car of the set.

    Attributes:
        people: Those of ``reading.people`` who appear on stage.
        actors: Ids of the people who are cast as human figures.
        creatures: Ids of animals on their own feet and of machines: catalog props that move.
        assets: All ids on the asset sheet.
        fixtures: Parts of the set or of another thing: people go to them, but they are not built as assets.
        wholes: Part -> the thing it belongs to: acting on the lid acts on the box. Detachable parts are not listed.
        names: Id -> display name, also of people who only speak from outside.
    """

    def __init__(self, reading: Reading, fitted: Mapping[str, str] | None = None) -> None:
        self.fitted = fitted or {}
        staged = {person for unit in reading.units for person in unit.on_stage}
        self.people = [person for person in reading.people if person.id in staged]
        self.actors = {person.id for person in self.people if not is_creature(person, reading)}
        self.creatures = {person.id for person in self.people} - self.actors
        in_hand = _held_things(reading)
        own = in_hand | _rails_of_their_own(reading)
        self.fixtures = {thing.id for thing in reading.things if thing.id not in own and is_fixture(thing)}
        self.wholes = _fixed_parts(reading) | _taps_of_basins(reading)
        self.wholes = {part: whole for part, whole in self.wholes.items() if part not in self.fitted}
        self.fixtures = (self.fixtures | set(self.wholes)) - {*self.fitted}
        things = {thing.id for thing in reading.things} - self.fixtures
        self.assets = {person.id for person in self.people} | things
        self.names = {each.id: _display_name(each) for each in (*reading.people, *reading.things)}

    def visible_id(self, id_: str) -> str:
        """Return the id of the thing that shows a part, or the id itself."""
        while id_ in self.wholes:
            id_ = self.wholes[id_]
        return id_


def _held_things(reading: Reading) -> set[str]:
    """Return the ids of all things that are ever held: a held lid is no part of the set."""
    held = {id_ for unit in reading.units for things in unit.held.values() for id_ in things}
    return held | {id_ for unit in reading.units for things in unit.grips.values() for id_ in things}


def _rails_of_their_own(reading: Reading) -> set[str]:
    """Return the ids of the rails that are no part of a set: the set kits of their scenes have none."""
    found: set[str] = set()
    for thing in reading.things:
        if thing.kind != "set_piece" or head_of(thing.name) not in _RAILS:
            continue
        kits = {reading.scenes[unit.scene].kit for unit in reading.units if thing.id in ids_in(unit)}
        if kits and kits <= SETS.keys():
            plans = (plan_of(Environment(kit=kit)) for kit in kits)
            if not any(part.box.z < _HUNG for plan in plans for part in fixtures_called(plan, thing.id)):
                found.add(thing.id)
    return found


def _fixed_parts(reading: Reading) -> dict[str, str]:
    """Return part -> whole of parts that never come off: never held, and without a place of their own."""
    loose = _held_things(reading) | {id_ for unit in reading.units for id_ in unit.spots}
    loose |= {deed.prop for unit in reading.units for deed in unit.deeds if deed.prop}
    loose |= {change.subject for unit in reading.units for change in unit.changes}
    known = {thing.id for thing in reading.things}
    wholes = {thing.id: thing.part_of for thing in reading.things if thing.part_of in known and thing.id not in loose}
    return {part: whole for part, whole in wholes.items() if whole and not _is_circular(part, wholes)}


def _taps_of_basins(reading: Reading) -> dict[str, str]:
    """Return tap -> sink or bath: the first basin that the story names."""
    basins = [thing.id for thing in reading.things if head_of(thing.name) in _BASINS]
    taps = [thing.id for thing in reading.things if head_of(thing.name) in _TAPS and thing.part_of is None]
    return dict.fromkeys(taps, basins[0]) if basins else {}


def _is_circular(part: str, wholes: Mapping[str, str | None]) -> bool:
    """Whether a part belongs to itself through its wholes."""
    seen, at = {part}, wholes.get(part)
    while at is not None and at in wholes:
        if at in seen:
            return True
        seen.add(at)
        at = wholes[at]
    return False


def unique(items: Iterable[str | None]) -> list[str]:
    """Return the ids in order, each once, without None."""
    return list(dict.fromkeys(item for item in items if item))


def _display_name(each: Person | Thing) -> str:
    """Return a name as it is displayed: capitals become initial capitals."""
    return capwords(each.name) if each.name.isupper() else each.name

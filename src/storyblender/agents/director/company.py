"""The company: who and what of a reading is on the asset sheet, under which id and name."""

from __future__ import annotations

from collections.abc import Iterable
from string import capwords

from storyblender.agents.director.reading import Person, Reading, Thing


class Company:
    """Everybody who is ever on stage, and every thing.

    Args:
        reading: What the script says.

    Attributes:
        people: Those of ``reading.people`` who are ever on stage.
        actors: Ids of those of them who are cast.
        assets: All ids on the asset sheet.
        names: Id -> name for people to read, also of those who only speak from outside.
    """

    def __init__(self, reading: Reading) -> None:
        staged = {person for unit in reading.units for person in unit.on_stage}
        self.people = [person for person in reading.people if person.id in staged]
        self.actors = {person.id for person in self.people if is_character(person)}
        self.assets = {person.id for person in self.people} | {thing.id for thing in reading.things}
        self.names = {each.id: _shown_name(each) for each in (*reading.people, *reading.things)}


def is_character(person: Person) -> bool:
    """Whether somebody is cast: people, and animals that speak."""
    return person.kind != "animal" or person.speaks


def unique(items: Iterable[str | None]) -> list[str]:
    """Return the ids in order, each once, without gaps."""
    return list(dict.fromkeys(item for item in items if item))


def _shown_name(each: Person | Thing) -> str:
    return capwords(each.name) if each.name.isupper() else each.name

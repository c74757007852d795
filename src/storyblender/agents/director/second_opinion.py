"""Where two readings of a script differ on cast, places or things; a person should look there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from storyblender.agents.director.kit_choice import choose_kit
from storyblender.agents.director.reading import Person, Reading
from storyblender.catalog.inflection import noun_key
from storyblender.catalog.sets import SETS
from storyblender.memory.shot_context import Flag


def differences(reading: Reading, other: Reading) -> Iterator[Flag]:
    """Yield a flag for each difference between a reading and the rules' own of the same script.

    Args:
        reading: What is used.
        other: The second opinion.
    """
    yield from _of_names("cast", map(_names, reading.people), map(_names, other.people))
    things = ({noun_key(each.name.split()[-1].lower())} for each in reading.things if each.name.split())
    theirs = ({noun_key(each.name.split()[-1].lower())} for each in other.things if each.handled and each.name.split())
    yield from _of_names("thing", things, theirs)
    opened = {scene.start: scene for scene in other.scenes}
    for scene in reading.scenes:
        second = opened.get(scene.start)
        if second is None:
            continue
        if scene.scene_type != second.scene_type:
            reason = f"scene {scene.id} plays {scene.scene_type}; by its words it plays {second.scene_type}"
            yield Flag(topic="place", choice=scene.scene_type, reason=reason, start=scene.start, end=scene.end)
        kit = choose_kit(second, (), "", other.age)
        if scene.kit != kit:
            reason = f"{SETS[scene.kit].name} is the set of scene {scene.id}; by its words it is {SETS[kit].name}"
            yield Flag(topic="place", choice=scene.kit, reason=reason, start=scene.start, end=scene.end)


def _names(person: Person) -> set[str]:
    """Return everything a person is called, in lower case."""
    return {person.name.lower(), *person.aliases}


def _of_names(topic: str, ours: Iterable[set[str]], theirs: Iterable[set[str]]) -> Iterator[Flag]:
    """Yield a flag for each entry of one list that shares no name with the other."""
    first, second = list(ours), list(theirs)
    told, also = {name for names in first for name in names}, {name for names in second for name in names}
    for names in first:
        if not names & also:
            name = min(names, key=lambda each: (-len(each), each))
            yield Flag(topic=topic, choice=name, reason=f"only the Director's reading has “{name}”; the rules do not")
    for names in second:
        if not names & told:
            name = min(names, key=lambda each: (-len(each), each))
            yield Flag(topic=topic, choice="", reason=f"only the rules' reading has “{name}”; the Director does not")

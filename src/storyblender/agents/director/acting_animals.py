"""Tells animals that act like people (cast as upright characters with hands) from animals on their own four feet."""

from __future__ import annotations

from typing import Final

from storyblender.agents.director.casting import garments, kind_of
from storyblender.agents.director.motion_families import HANDS
from storyblender.agents.director.reading import Person, Reading

_BY_MOUTH: Final = frozenset(
    {"take", "pick_up", "hold", "catch", "drop", "give", "put_down", "touch", "search", "open"}
)
"""Verbs of handling that a beak or a claw can do as well."""
_PARROTS: Final = frozenset({"parrot", "macaw", "cockatoo", "parakeet", "budgie", "budgerigar"})
_AT_HOME: Final = frozenset({"cat", "dog", "bird", "parrot", "owl", "crow", "hen", "rabbit", "mouse", "squirrel"})
"""Animals that lie on beds and perch on chairs as plain animals."""
_TACK: Final = frozenset({
    "collar", "lead", "leash", "saddle", "bridle", "harness", "halter", "bell", "blanket", "reins", "muzzle", "tag",
    "bandage", "chain", "rope",
})  # fmt: skip
"""Things that people put on animals."""
_HELD: Final = frozenset({"right", "left", "both", "under_arm", "shoulder"})
_SEATED: Final = frozenset({"sit", "lie", "asleep", "lean"})


def acts_like_a_person(person: Person, reading: Reading) -> bool:
    """Return whether an animal or a robot speaks, wears clothes, has things in its hands or lives among furniture.

    In a story whose animals talk to each other, every animal that does something is cast. An animal that is ridden or
    led stays an animal, unless it speaks; so does a parrot that only speaks.

    Args:
        person: An animal or a robot.
        reading: The reading of the script.
    """
    handles = _uses_hands(person, reading)
    species = kind_of(person)
    if person.speaks:
        words = {*person.role.lower().split(), *person.name.lower().split()}
        return handles or _is_dressed(person) or (species is not None and not _PARROTS & words)
    if _is_mastered(person, reading):
        return False
    if _is_dressed(person) or handles:
        return True
    if species is None:
        return False
    if species.words[0] not in _AT_HOME and _sits_on_furniture(person, reading):
        return True
    fellows = [each for each in reading.people if each.kind == "animal" and each.speaks and kind_of(each) is not None]
    return len(fellows) > 1 and any(deed.actor == person.id for unit in reading.units for deed in unit.deeds)


def _is_dressed(person: Person) -> bool:
    """Whether the description of an animal names clothes, beyond its coat or collar."""
    worn = [words for words in person.outfit if not _TACK & {*words.lower().split()}]
    return bool(garments(", ".join(worn)))


def _uses_hands(person: Person, reading: Reading) -> bool:
    """Whether the animal does what no mouth or paw can do, carries in a hand, or puts something on."""
    names = {thing.id: thing.name for thing in reading.things}
    for unit in reading.units:
        for deed in unit.deeds:
            if deed.actor == person.id and deed.prop and deed.motion in HANDS - _BY_MOUTH:
                return True
        for thing, grip in unit.grips.get(person.id, {}).items():
            tack = _TACK & {*names.get(thing, thing).lower().split()}
            if grip in _HELD or (grip == "worn" and not tack):
                return True
    return False


def _is_mastered(person: Person, reading: Reading) -> bool:
    """Whether another character rides the animal, or leads it on a leash."""
    ridden = any(place == ("ride", person.id) for unit in reading.units for place in map(tuple, unit.posture.values()))
    ridden = ridden or any(
        deed.motion == "ride" and person.id in (deed.target, deed.prop) for unit in reading.units for deed in unit.deeds
    )
    return ridden or any(tether.held == person.id for unit in reading.units for tether in unit.tethers)


def _sits_on_furniture(person: Person, reading: Reading) -> bool:
    """Whether the animal sits or lies on or in a thing, as people do."""
    things = {thing.id for thing in reading.things}
    places = [unit.posture[person.id] for unit in reading.units if person.id in unit.posture]
    return any(posture in _SEATED and support in things for posture, support in places)

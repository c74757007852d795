"""Which animals act like people: they are cast, upright and with hands; the others stay animals on their own feet."""

from __future__ import annotations

from typing import Final

from storyblender.agents.director.casting import garments, kind_of
from storyblender.agents.director.motion_families import HANDS
from storyblender.agents.director.reading import Person, Reading

_BY_MOUTH: Final = frozenset(
    {"take", "pick_up", "hold", "catch", "drop", "give", "put_down", "touch", "search", "open"}
)
"""What of the work of hands a beak or a claw does."""
_PARROTS: Final = frozenset({"parrot", "macaw", "cockatoo", "parakeet", "budgie", "budgerigar"})
_AT_HOME: Final = frozenset({"cat", "dog", "bird", "parrot", "owl", "crow", "hen", "rabbit", "mouse", "squirrel"})
"""Kinds that lie on beds and perch on chairs as they are."""
_TACK: Final = frozenset({
    "collar", "lead", "leash", "saddle", "bridle", "harness", "halter", "bell", "blanket", "reins", "muzzle", "tag",
    "bandage", "chain", "rope",
})  # fmt: skip
"""What people put on animals."""
_HELD: Final = frozenset({"right", "left", "both", "under_arm", "shoulder"})
_SEATED: Final = frozenset({"sit", "lie", "asleep", "lean"})


def acts_like_a_person(person: Person, reading: Reading) -> bool:
    """Return whether an animal speaks, wears clothes, has things in its hands or lives among furniture.

    In a story whose animals talk to each other, every animal that does something is one of them. Who is ridden or
    led is an animal, unless it speaks; a parrot that only speaks is one, too.

    Args:
        person: Of the kind ``animal``.
        reading: What the script says.
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
    """Whether the looks of an animal name clothes, and not only its coat or its collar."""
    worn = [words for words in person.outfit if not _TACK & {*words.lower().split()}]
    return bool(garments(", ".join(worn)))


def _uses_hands(person: Person, reading: Reading) -> bool:
    """Whether it does what no mouth or paw does, carries in a hand, or puts something on."""
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
    """Whether somebody rides it, or leads it on a leash."""
    ridden = any(place == ("ride", person.id) for unit in reading.units for place in map(tuple, unit.posture.values()))
    ridden = ridden or any(
        deed.motion == "ride" and person.id in (deed.target, deed.prop) for unit in reading.units for deed in unit.deeds
    )
    return ridden or any(tether.held == person.id for unit in reading.units for tether in unit.tethers)


def _sits_on_furniture(person: Person, reading: Reading) -> bool:
    """Whether it sits or lies on or in a thing, as people do."""
    things = {thing.id for thing in reading.things}
    places = [unit.posture[person.id] for unit in reading.units if person.id in unit.posture]
    return any(posture in _SEATED and support in things for posture, support in places)

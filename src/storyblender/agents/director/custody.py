"""Which things people have in their hands, from readings that say only what is new.

A Director says what a person holds when it changes; in between the deeds tell. What is followed here is said in every
unit, and what cannot be is named: a thing that is held where it is absent, that two people hold, that is taken by the
one who has it, or given away by one who has not.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from storyblender.agents.director.motion_families import GETTING, HOLDING, PARTING
from storyblender.agents.director.reading import Deed, Thing, Unit
from storyblender.agents.director.reading_passes import with_directed_motions
from storyblender.agents.director.size_words import stated_size
from storyblender.catalog.carrying import ON_BODY
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import kind_named
from storyblender.memory.vocabulary import Grip

_TAKING = GETTING | {"grab"}
"""Motions after which the thing is in the hand."""
_KEEPING = HOLDING | {"offer", "show"}
"""Motions during which the thing is in the hand."""
_LETTING_GO = (PARTING - {"give"}) | {"pocket"}
"""Motions after which the thing is in nobody's hand."""
_LONG = 1.2
"""Metres: a longer thing can be carried by two people."""


@dataclass
class Custody:
    """The things in people's hands, followed through the units of one scene.

    Attributes:
        things: Ids of things that can be in a hand.
        shared: Ids of things that several people can have in hand at once.
        hands: Person -> thing -> how it is carried, None where that is left to the crew; in the order they got it.
        since: Thing -> number of the unit in which it came to where it is.
    """

    things: Collection[str]
    shared: Collection[str] = ()
    hands: dict[str, dict[str, Grip | None]] = field(default_factory=dict)
    since: dict[str, int] = field(default_factory=dict)

    def play(self, unit: Unit, number: int) -> list[str]:
        """Follow one unit; return a sentence for everything in it that cannot be.

        Args:
            unit: Its ``held`` and ``grips`` have only what is new.
            number: Of the unit, for the sentences.
        """
        wrong: list[str] = []
        for deed in with_directed_motions(unit).deeds:
            wrong += (f"unit {number}: {fault}" for fault in self._act(deed, number))
        wrong += (f"unit {number}: {fault}" for fault in self._wrongly_held(unit))
        for person, told in unit.held.items():
            before, grips = self.hands.get(person, {}), unit.grips.get(person, {})
            now: dict[str, Grip | None] = {thing: grips.get(thing) or before.get(thing) for thing in told}
            self.hands[person] = now
            for thing in told:
                self._claim(person, thing, unit.held)
                if thing not in before:
                    self.since[thing] = number
        for thing in {*unit.absent, *unit.spots} - {thing for told in unit.held.values() for thing in told}:
            self._let_go(thing)
        return wrong

    def holders(self, thing: str) -> list[str]:
        """Return the people who have a thing."""
        return [person for person, held in self.hands.items() if thing in held]

    def _act(self, deed: Deed, number: int) -> Iterator[str]:
        """Follow one deed; yield what of it cannot be."""
        thing = deed.prop or deed.target
        if thing is None or thing not in self.things:
            return
        others = [person for person in self.holders(thing) if person != deed.actor]
        own = self.hands.get(deed.actor, {})
        if deed.motion in _TAKING:
            in_hand = thing in own and own[thing] not in ON_BODY
            since = self.since.get(thing, 0)
            if in_hand and thing not in self.shared and deed.motion != "grab" and since < number:
                yield (
                    f"{deed.actor} is to {deed.motion.replace('_', ' ')} {thing!r}, and has it in hand already"
                    f"{f' since unit {since}' if since else ''}; leave that deed out, or say who has it before"
                )
            if thing not in self.shared:
                self._let_go(thing, but=deed.actor if in_hand else "")
            self.hands.setdefault(deed.actor, {}).setdefault(thing, None)
            self.since[thing] = number
        elif deed.prop is None:
            return
        elif deed.motion == "give" or deed.motion in _LETTING_GO:
            if others and thing not in own and thing not in self.shared:
                what = "gives away" if deed.motion == "give" else f"is to {deed.motion.replace('_', ' ')}"
                other = others[0]
                yield f"{deed.actor} {what} {thing!r}, which {other} has; let {other} do it, or hand it over before"
            self._let_go(thing)
            if deed.motion == "give" and deed.target is not None:
                self.hands.setdefault(deed.target, {})[thing] = None
            self.since[thing] = number
        elif deed.motion in _KEEPING and thing not in own and (not others or thing in self.shared):
            self.hands.setdefault(deed.actor, {})[thing] = None
            self.since[thing] = number

    def _wrongly_held(self, unit: Unit) -> Iterator[str]:
        """Yield what of the things that a unit says are held cannot be."""
        told = [(person, thing) for person, things in unit.held.items() for thing in things]
        for person, thing in told:
            if thing in unit.absent:
                yield f"{person} holds {thing!r}, which is `absent` there; leave it out of `holds` or out of `absent`"
            other = next((each for each, same in told if same == thing and each != person), None)
            if other is not None and thing not in self.shared and person < other:
                yield f"{person} and {other} both hold {thing!r}; say who has it, or make it two things"

    def _claim(self, person: str, thing: str, told: Mapping[str, Sequence[str]]) -> None:
        """Take a thing that a person is said to hold out of the hands of those who are not said to."""
        for other, held in self.hands.items():
            kept = other == person or thing in told.get(other, ()) or thing in self.shared
            if not kept:
                held.pop(thing, None)

    def _let_go(self, thing: str, but: str = "") -> None:
        """Take a thing out of all hands but one person's."""
        for person, held in self.hands.items():
            if person != but:
                held.pop(thing, None)


def things_in_hands(things: Sequence[Thing]) -> tuple[set[str], set[str]]:
    """Return the ids of things that can be in a hand, and of those that several people can have at once.

    Args:
        things: Of a reading; what is long, or several, can be in more hands than one person's.
    """
    found = {thing.id for thing in things if thing.kind == "prop" or thing.handled}
    return found, {thing.id for thing in things if _is_long(thing) or thing.name.lower().endswith("s")}


def _is_long(thing: Thing) -> bool:
    """Whether a thing is so long that two people can carry it."""
    kind = kind_named(thing.name)
    said = stated_size(thing.name, thing.description, person=False, kind=kind).measure
    if said is not None:
        return max(side or 0.0 for side in (said.width, said.depth, said.height)) > _LONG
    known = PROPS.get(kind or "")
    return known is not None and max(known.size) > _LONG


def with_things_in_hands(units: Sequence[Unit], things: Sequence[Thing]) -> list[Unit]:
    """Return the units of a Director, each with all that everybody on stage has in hand when it ends.

    What a person hands over, puts down or uses before anything else is said of it is in their hands from the start,
    unless it was absent before, or they were said to hold other things.

    Args:
        units: Of a whole reading, in order; their ``held`` says only what is new.
        things: Of the reading.
    """
    known, shared = things_in_hands(things)
    done: list[Unit] = []
    custody = Custody(known, shared)
    for index, unit in enumerate(units):
        if index == 0 or units[index - 1].scene != unit.scene:
            custody = Custody(known, shared)
            custody.hands = _had_from_the_start(units, index, known)
        custody.play(unit, index + 1)
        used = {deed.prop for deed in unit.deeds if deed.prop in custody.things}
        held = {person: [*custody.hands.get(person, ())] for person in unit.on_stage}
        grips = {
            person: {thing: grip for thing in things if (grip := custody.hands[person][thing]) is not None}
            for person, things in held.items()
        }
        done.append(
            replace(
                unit,
                held=held,
                grips={person: told for person, told in grips.items() if told},
                absent=[thing for thing in unit.absent if thing not in used or not custody.holders(thing)],
            )
        )
    return done


def _had_from_the_start(units: Sequence[Unit], first: int, known: Collection[str]) -> dict[str, dict[str, Grip | None]]:
    """Return what people have in hand as the scene that begins with a unit opens, as their first deeds tell."""
    hands: dict[str, dict[str, Grip | None]] = {}
    seen: set[str] = set()
    told: set[str] = set()
    for unit in units[first:]:
        if unit.scene != units[first].scene:
            break
        seen |= {*unit.absent}
        for deed in with_directed_motions(unit).deeds:
            thing = deed.prop
            has = deed.motion in PARTING | _KEEPING and deed.actor not in told
            if thing in known and thing not in seen and has:
                hands.setdefault(deed.actor, {})[str(thing)] = None
            seen |= {each for each in (deed.prop, deed.target) if each is not None}
        seen |= {thing for things in unit.held.values() for thing in things} | {*unit.spots}
        told |= unit.held.keys()
    return hands

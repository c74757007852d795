"""A reading of a page against a careful person's, fact by fact.

What both say is right, what only the first says is wrong, what only the person says is missed. People and things of
the two readings are matched by their names (see ``matched_people`` and ``named_things``). Somebody at another age or in
other clothes is the same person. A relation counts where words of the page state it: where people stand without a word
about it is staging, which the frames are judged by. Whatever stands on the floor is no relation. The words are English:
on pages in other languages no relation counts.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from storyblender.agents.director.kit_choice import choose_kit
from storyblender.agents.director.lexicon import CONJUNCTIONS, DETERMINERS, POSSESSIVES, PREPOSITIONS
from storyblender.agents.director.reading import Person, Reading, Thing, Unit
from storyblender.catalog.inflection import singular
from storyblender.catalog.motions import MOTION_KEYS, STANDING

FACTS = (
    "cast", "on stage", "speaker", "actor and motion", "targets", "postures", "relations", "things", "place kit",
    "time", "looks",
)  # fmt: skip
_WORD = re.compile(r"[^\W\d_]+")
_LOOK_WORD = re.compile(r"[^\W\d_]{3,}|\d+")
_SMALL = PREPOSITIONS | DETERMINERS | POSSESSIVES | CONJUNCTIONS | {"very", "too", "one", "her", "all"}
"""Words that say nothing of how somebody looks."""
_ALIKE = {"above": "over", "inside": "in", "at": "next_to"}
"""Relations that few people tell apart."""
_TOLD_BY = {
    "on": "on|onto|upon|atop|across|astride|sits?|lies?",
    "in": "in|into|inside|within|full of",
    "under": "under|beneath|below|underneath",
    "over": "over|above|overhead",
    "behind": "behind|after|back of",
    "in_front_of": "in front of|before|opposite|at",
    "next_to": "next to|beside|by|near|at|alongside|with|to",
    "against": "against|on",
    "between": "between",
    "around": "around|round",
    "facing": "facing|faces?|opposite|to",
    "left_of": "left",
    "right_of": "right",
}
"""Words that state a relation."""
_GROUND = frozenset({"floor", "ground"})


@dataclass
class Tally:
    """Counts of one kind of fact."""

    right: int = 0
    wrong: int = 0
    missed: int = 0

    def add(self, said: Iterable[object], meant: Iterable[object]) -> None:
        """Count two sets of facts; what is said twice counts twice."""
        one, other = Counter(said), Counter(meant)
        both = (one & other).total()
        self.right += both
        self.wrong += one.total() - both
        self.missed += other.total() - both

    def __iadd__(self, other: Tally) -> Tally:
        self.right, self.wrong, self.missed = (
            self.right + other.right, self.wrong + other.wrong, self.missed + other.missed,
        )  # fmt: skip
        return self

    @property
    def precision(self) -> float:
        return self.right / max(self.right + self.wrong, 1)

    @property
    def recall(self) -> float:
        return self.right / max(self.right + self.missed, 1)

    @property
    def f1(self) -> float:
        return 2 * self.right / max(2 * self.right + self.wrong + self.missed, 1)


@dataclass
class Comparison:
    """The rules' reading of one page against a person's.

    Args:
        rules: What the rules read.
        careful: What a person read.
    """

    rules: Reading
    careful: Reading
    tallies: dict[str, Tally] = field(default_factory=lambda: {fact: Tally() for fact in FACTS})

    def __post_init__(self) -> None:
        self.same = matched_people(self.rules.people, self.careful.people)
        self._names = {
            id(self.careful): {thing.id: _head(thing.name) for thing in self.careful.things},
            id(self.rules): named_things(self.rules.things, self.careful.things),
        }
        self._base = {
            id(reading): {person.id: person.variant_of or person.id for person in reading.people}
            for reading in self._both
        }
        self._called = {
            id(reading): {word for person in reading.people for word in _called(person)} for reading in self._both
        }
        self._postures = {id(reading): _postures(reading) for reading in self._both}

    def count(self) -> dict[str, Tally]:
        """Count every kind of fact."""
        staged = [{self._who(reading, person.id) for person in self._staged(reading)} for reading in self._both]
        self.tallies["cast"].add(*staged)
        self._count_scenes()
        for mine, theirs in self._units():
            for fact, facts in self._facts(self.rules, mine).items():
                self.tallies[fact].add(facts, self._facts(self.careful, theirs)[fact])
        for fact, facts in self._whole(self.rules).items():
            self.tallies[fact].add(facts, self._whole(self.careful)[fact])
        return self.tallies

    @property
    def _both(self) -> tuple[Reading, Reading]:
        return self.rules, self.careful

    @staticmethod
    def _staged(reading: Reading) -> list[Person]:
        staged = {person for unit in reading.units for person in unit.on_stage}
        return [person for person in reading.people if person.id in staged]

    def _count_scenes(self) -> None:
        """The set and the hour of each unit's scene, by the person's units."""
        kits: dict[int, dict[int, str]] = {}
        for reading in self._both:
            kits[id(reading)] = {index: self._kit(reading, index) for index in range(len(reading.scenes))}
        seen: set[tuple[int, int]] = set()
        for mine, theirs in self._units():
            if not mine or not theirs or (theirs[0].scene, mine[0].scene) in seen:
                continue
            seen.add((theirs[0].scene, mine[0].scene))
            one, other = mine[0].scene, theirs[0].scene
            if self.careful.scenes[other].kit or self.careful.scenes[other].place_kind:  # else none was named
                self.tallies["place kit"].add([kits[id(self.rules)][one]], [kits[id(self.careful)][other]])
            self.tallies["time"].add([_hour(self.rules.scenes[one].time)], [_hour(self.careful.scenes[other].time)])

    @staticmethod
    def _kit(reading: Reading, index: int) -> str:
        scene = reading.scenes[index]
        things = dict.fromkeys(thing for unit in reading.units if unit.scene == index for thing in unit.things)
        return choose_kit(scene, things, " ".join(things))

    def _units(self) -> list[tuple[list[Unit], list[Unit]]]:
        """The person's units one by one, each with the rules' units that have most of their words in it."""
        groups: dict[int, list[Unit]] = {index: [] for index in range(len(self.careful.units))}
        for unit in self.rules.units:
            shared = [
                min(unit.end, other.end) - max(unit.start, other.start) if other.start < unit.end else 0
                for other in self.careful.units
            ]
            best = max(range(len(shared)), key=lambda index: shared[index], default=-1)
            if best >= 0 and shared[best] > 0:
                groups[best].append(unit)
        return [(groups[index], [unit]) for index, unit in enumerate(self.careful.units)]

    def _facts(self, reading: Reading, units: list[Unit]) -> dict[str, list[object]]:
        """Facts of some units in names that both readings share."""
        last = units[-1:]
        deeds = [deed for unit in units for deed in unit.deeds if MOTION_KEYS[deed.motion] not in (*STANDING, "talk")]
        who = self._who
        return {
            "on stage": [*{who(reading, person) for unit in last for person in unit.on_stage}],
            "speaker": [who(reading, unit.speaker) for unit in units if unit.speaker],
            "actor and motion": [(who(reading, deed.actor), MOTION_KEYS[deed.motion]) for deed in deeds],
            "targets": [
                (who(reading, deed.actor), self._what(reading, target))
                for deed in deeds
                for target in {target for target in (deed.target, deed.prop) if target}
            ],
            "postures": [
                (who(reading, person), posture)
                for unit in last
                for person, posture in self._postures[id(reading)][unit.start].items()
                if person in unit.on_stage
            ],
        }

    def _whole(self, reading: Reading) -> dict[str, list[object]]:
        """Facts of the whole page."""
        told = {*map(singular, _LOOK_WORD.findall(reading.screenplay.text.lower()))}
        relations = {
            (_ALIKE.get(kind, kind), self._what(reading, each), self._what(reading, anchor))
            for units, kind, each, anchor in _placed(reading)
            if any(self._is_said(reading, _ALIKE.get(kind, kind), anchor, unit) for unit in units)
        }
        looks = {
            (self._who(reading, person.id), word)
            for person in self._staged(reading)
            for phrase in (person.age, *person.build, *person.outfit, *person.hair, *person.face)
            for word in map(singular, _LOOK_WORD.findall(phrase.lower()))
            if word in told - _SMALL - self._called[id(reading)]
        }
        used = {thing for unit in reading.units for thing in unit.things}
        things = {self._what(reading, thing.id) for thing in reading.things if thing.id in used}
        return {"relations": [*relations], "looks": [*looks], "things": [*things]}

    def _is_said(self, reading: Reading, kind: str, anchor: str, unit: Unit) -> bool:
        """Whether the words of a unit state a relation: they name what somebody is placed by, and how they are."""
        text = unit.text.lower()
        thing = next((thing for thing in reading.things if thing.id == anchor), None)
        head = _head(thing.name) if thing else ""
        said = re.search(rf"\b(?:{_TOLD_BY.get(kind, kind)})\b", text) is not None
        return said and head not in _GROUND and head in text

    def _who(self, reading: Reading, person: str | None) -> object:
        """The id that the careful reading gives somebody, whatever age they are and whatever they wear."""
        base = self._base[id(reading)].get(person or "", person)
        mine = self.same.get(base or "", base) if reading is self.rules else base
        return self._base[id(self.careful)].get(mine or "", mine)

    def _what(self, reading: Reading, thing: str) -> object:
        return self._names[id(reading)].get(thing) or self._who(reading, thing)


def _placed(reading: Reading) -> Iterator[tuple[list[Unit], str, str, str]]:
    """Everything that is placed by something: the units that may say so, the relation, what and by what."""
    for scene, relation in reading.relations:
        units = [unit for unit in reading.units if unit.scene == scene]
        yield units, relation.kind, relation.asset_id, relation.anchor_asset_id
    for unit in reading.units:
        for each, spot in unit.spots.items():
            if spot.anchor_id:
                yield [unit], spot.relation, each, spot.anchor_id


def _postures(reading: Reading) -> dict[int, dict[str, str]]:
    """Everybody who does not stand, after each unit by its start: postures stay until they are changed."""
    now: dict[str, str] = {}
    scene, found = -1, dict[int, dict[str, str]]()
    for unit in reading.units:
        now = now if unit.scene == scene else {}
        scene = unit.scene
        now = now | {person: posture for person, (posture, _) in unit.posture.items()}
        found[unit.start] = {person: posture for person, posture in now.items() if posture != "stand"}
    return found


def matched_people(mine: list[Person], theirs: list[Person]) -> dict[str, str]:
    """Return whom of one reading the other calls what: the same name first, then any shared name or role."""
    found: dict[str, str] = {}
    for names in (_own_name, _all_names):
        for person in mine:
            if person.id in found:
                continue
            taken = set(found.values())
            same = next((each for each in theirs if each.id not in taken and names(person) & names(each)), None)
            if same is not None:
                found[person.id] = same.id
    return found


def named_things(mine: list[Thing], theirs: list[Thing]) -> dict[str, str]:
    """Return the head nouns of things, in the words of another reading where both mean one thing.

    The same noun first, then one that ends or begins with the other (stick, drumstick), then any shared word.
    """
    heads = {_head(thing.name): _words(thing.name) for thing in theirs}
    found: dict[str, str] = {}
    for thing in mine:
        head, words = _head(thing.name), _words(thing.name)
        ending = (other for other in heads if _are_alike(*sorted((head, other), key=len)))
        shared = (other for other, said in heads.items() if words & said)
        found[thing.id] = head if head in heads else next(ending, None) or next(shared, head)
    return found


def _are_alike(short: str, long: str) -> bool:
    """``gun`` and ``shotgun``, ``photo`` and ``photograph``."""
    return (len(short) > 2 and long.endswith(short)) or (len(short) > 4 and long.startswith(short))


def _words(text: str) -> set[str]:
    return {singular(word) for word in _WORD.findall(text.lower()) if len(word) > 3}


def _called(person: Person) -> set[str]:
    """The words somebody goes by: that a moose is a moose is no look."""
    return {word for name in (person.name, person.role, *person.aliases) for word in _WORD.findall(name.lower())}


def _own_name(person: Person) -> set[str]:
    return {person.name.lower()}


def _all_names(person: Person) -> set[str]:
    words = {word for name in (person.name, *person.aliases) for word in _WORD.findall(name.lower())}
    return {word for word in words if len(word) > 2} - {"the", "man", "woman", "old", "young", "mrs", "one", "two"}


def _head(name: str) -> str:
    words = _WORD.findall(name.lower())
    return singular(words[-1]) if words else name


def _hour(time: str) -> str:
    """Whether it is day, dusk or night: what a picture shows."""
    if time in ("night", "evening"):
        return "night"
    return "dusk" if time in ("dawn", "sunset", "dusk") else "day"

"""The reader's state at one point of the script: who is there, what was talked about last, where things are.

One pass in reading order fills it; the passes (coreference, entrances, deeds, relations, speech) share it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from storyblender.agents.director import lexicon
from storyblender.agents.director.lexicon.foreign import Tongue
from storyblender.agents.director.reader.language.words import Word, key_of
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reader.props import Inventory
from storyblender.agents.director.reading import Person, Reading, SceneReading, Unit
from storyblender.memory.scene_context import Relation, Spot
from storyblender.memory.shot_context import Flag
from storyblender.memory.vocabulary import Age, Posture, RelationKind

_FADING = 0.45
"""What salience keeps from one sentence to the next."""
_SCENE_FADING = 0.3
_FORGOTTEN = 0.001
_CALLING = frozenset({"phone", "telephone", "radio", "cell", "mobile", "cellphone", "call", "intercom", "headset"})
"""Phones and the like: ``on the phone`` means beside it at most."""
_FLOORING = lexicon.words("flooring")
"""What is on it is on the floor."""


@dataclass
class Discourse:
    """What the text mentioned last; decides who and what a pronoun means."""

    sentence: int = 0
    salience: dict[str, float] = field(default_factory=dict)
    """Person -> how present they are in the reader's mind."""
    clock: int = 0
    last_named: dict[str, int] = field(default_factory=dict)
    """Person -> value of the clock when last spoken of."""
    last_sentence: dict[str, int] = field(default_factory=dict)
    groups: list[tuple[int, list[Person], int]] = field(default_factory=list)
    """People who did something together: sentence, who, clock."""
    subjects: list[Person] = field(default_factory=list)
    """Subject of the last sentence."""
    moving: str | None = None
    """The moving thing of the last sentence: ``The coin drops. Rolls away``."""
    things: dict[str, float] = field(default_factory=dict)
    """Thing -> how present it is in the reader's mind, for ``it``."""
    recent_things: list[str] = field(default_factory=list)
    """Things named lately, the last first."""
    last_plural: tuple[str, int] | None = None
    """Things named in the plural, and in which sentence."""
    epithets: dict[str, Person] = field(default_factory=dict)
    """``visitor``, ``old man`` -> who was called so last."""
    victim: tuple[Person, int] | None = None
    """Who was hit last, and in which sentence."""
    last_speaker: Person | None = None
    last_listener: Person | None = None

    def raise_salience(self, person: Person, weight: float) -> None:
        """Note that a person is mentioned: raise their salience by ``weight``, from 0 to 1."""
        self.salience[person.id] = max(self.salience.get(person.id, 0.0), 0.0) + weight
        self.clock += 1
        self.last_named[person.id] = self.clock

    def next_sentence(self) -> None:
        """Let all salience fade a little."""
        self.sentence += 1
        for person in self.salience:
            self.salience[person] *= _FADING
        self.things = {thing: weight * _FADING for thing, weight in self.things.items() if weight > _FORGOTTEN}

    def next_scene(self, keep_groups: bool) -> None:
        """Let all salience fade a lot and forget things; ``keep_groups`` keeps the last group of people."""
        for person in self.salience:
            self.salience[person] *= _SCENE_FADING
        self.groups = self.groups[-1:] if keep_groups else []
        self.subjects, self.last_plural, self.recent_things, self.things = [], None, [], {}
        self.last_speaker = self.last_listener = None


@dataclass
class SceneState:
    """Who and what is where in the current scene."""

    index: int = 0
    """Into the scenes of the reading."""
    on: list[str] = field(default_factory=list)
    """People on stage, in order of entrance."""
    before: list[str] = field(default_factory=list)
    """Who was there at the end of the scene before and may come along."""
    named: set[str] = field(default_factory=set)
    leaving: list[str] = field(default_factory=list)
    """They go when the sentence is over."""
    gone: list[str] = field(default_factory=list)
    """They went with the last sentence."""
    off_screen: set[str] = field(default_factory=set)
    """Heard but not seen yet."""
    pictured: set[str] = field(default_factory=set)
    """Seen on a screen only."""
    posture: dict[str, tuple[Posture, str | None]] = field(default_factory=dict)
    held: dict[str, list[str]] = field(default_factory=dict)
    fallen: str = ""
    """What was tipped over last."""
    relations: list[tuple[int, Relation]] = field(default_factory=list)
    activities: dict[str, str] = field(default_factory=dict)
    """Person -> lasting motion."""
    gaze: set[str] = field(default_factory=set)
    """People with closed eyes, or a gaze into empty space."""


@dataclass
class SentenceState:
    """Working memory for the sentence being read."""

    words: list[Word] = field(default_factory=list)
    subjects: list[Person] = field(default_factory=list)
    named: set[str] = field(default_factory=set)
    pronouns: dict[int, tuple[list[Person], str | None]] = field(default_factory=dict)
    """Position of a pronoun -> who or what it means."""
    verb: str = ""
    """Of the clause being read."""
    things: list[tuple[int, str]] = field(default_factory=list)
    """Position and id of every thing it names."""
    plurals: set[str] = field(default_factory=set)
    """Those of the things that are several."""
    plural_thing: str | None = None
    subject_thing: str | None = None
    first_thing: str | None = None
    """The subject of the first clause of the sentence, if it is a thing."""
    object_thing: str | None = None
    """The last thing in object position."""
    pictured: bool = False


@dataclass(frozen=True)
class UnreadAct:
    """An action of the script without a motion of its own."""

    person: str
    shown: str
    """The motion shown in its place, or an empty string."""
    reason: str
    start: int
    end: int


@dataclass
class ReaderState:
    """The state that all passes of the reader share."""

    roster: Roster
    inventory: Inventory
    reading: Reading
    tongue: Tongue | None = None
    """The language of the script, or None for English."""
    discourse: Discourse = field(default_factory=Discourse)
    scene: SceneState = field(default_factory=SceneState)
    sentence: SentenceState = field(default_factory=SentenceState)
    scene_dressed: dict[str, int] = field(default_factory=dict)
    """Person -> the first scene that describes their clothes."""
    age: Age | None = None
    """The age the story plays in, where its words tell."""
    calls: dict[str, int] = field(default_factory=dict)
    """Caller -> the place where they took the call."""
    called_from: set[int] = field(default_factory=set)
    """Places where a call was taken."""
    intercut: bool = False
    """Whether the pictures go between two places."""
    unread: list[UnreadAct] = field(default_factory=list)
    """Acts of the current sentence that have no motion of their own."""

    @property
    def place(self) -> SceneReading:
        """The current scene."""
        return self.reading.scenes[self.unit.scene]

    @property
    def unit(self) -> Unit:
        """The unit being read."""
        return self.reading.units[-1]

    def on_stage(self) -> list[Person]:
        """Return the people on stage, in the order of the cast."""
        return self.roster.in_order(filter(None, map(self.roster.person, self.scene.on)))

    def seen_or_mentioned(self) -> list[Person]:
        """Return the people on stage or mentioned in this scene, in the order of the cast."""
        ids = dict.fromkeys((*self.scene.on, *self.scene.named))
        return self.roster.in_order(filter(None, map(self.roster.person, ids)))

    def referable_people(self) -> list[Person]:
        """Return the people on stage whom ``they`` or ``the man`` may mean: all but the narrator."""
        return [person for person in self.on_stage() if person is not self.roster.narrator]

    def person(self, id: str) -> Person | None:
        """Return the person of an id, or None."""
        return self.roster.person(id)

    def enter(self, person: Person) -> None:
        """Bring a person on stage, unless they are only seen on a screen."""
        if person.id not in self.scene.on and person.id not in self.scene.pictured:
            self.scene.on.append(person.id)
            self.unit.entering.append(person.id)
            self.scene.off_screen.discard(person.id)

    def mention(self, person: Person, weight: float) -> None:
        """Note that a person is mentioned in this scene; ``weight``, from 0 to 1, is added to their salience."""
        self.discourse.raise_salience(person, weight)
        self.scene.named.add(person.id)

    def add_to_unit(self, person: Person) -> None:
        """Note that a person takes part in the current unit."""
        self.discourse.last_sentence[person.id] = self.discourse.sentence
        if person.id not in self.unit.people:
            self.unit.people.append(person.id)

    def find(self, name: str) -> Person | None:
        """Return the person that a name means here: on stage first, then the most salient, then the first cast."""
        people = self.roster.by_name.get(key_of(bare(name))) or self.roster.by_name.get(key_of(name))
        people = people or self.roster.find(name) or [p for p in self.roster.people if p.role == bare(name)]
        if not people and bare(name) in lexicon.TITLES:
            people = [p for p in self.roster.people if bare(p.name).startswith(f"{bare(name)} ")]  # CHIEF, of Chief Ba
        return max(people, key=self.prominence) if people else None

    def prominence(self, person: Person) -> tuple[bool, float]:
        """Return a sort key: on stage, then salience. On a tie ``max`` takes the first introduced."""
        return person.id in self.scene.on, self.discourse.salience.get(person.id, 0.0)

    def relate(self, subject: str, kind: RelationKind, anchor: str, second: str | None = None) -> None:
        """State a spatial relation, once a scene; for a person it is their spot until they move.

        Args:
            subject: Id of the person or thing.
            kind: The relation.
            anchor: Id of the person or thing it relates to.
            second: The other anchor of ``between``, or None.
        """
        if kind == "on" and self.inventory.head(anchor) in _FLOORING:
            anchor = self.inventory.id_of("floor", self.unit.start)
        called = kind == "on" and self.person(subject) and self.inventory.head(anchor) in _CALLING
        if subject == anchor or called or (kind == "in" and self.person(anchor)):
            return
        stated = (
            self.unit.scene,
            Relation(asset_id=subject, kind=kind, anchor_asset_id=anchor, second_anchor_asset_id=second),
        )
        if self.person(subject) and second is None:
            self.unit.spots[subject] = Spot(relation=kind, anchor_id=anchor)
        if stated not in self.scene.relations:
            self.scene.relations.append(stated)
            self.reading.relations.append(stated)
        for end in (subject, anchor, second or anchor):
            self.inventory.note(end, "related")
        if not self.person(anchor) and not self.person(subject):
            self.inventory.note(subject, "placed")
            self.inventory.note(anchor, "placed" if kind in ("in", "on") else "related")

    def record_pronoun(self, at: int, word: str, who: Iterable[str]) -> None:
        """Record that the pronoun ``word`` at offset ``at`` of the script means the people with the ids ``who``."""
        self.reading.pronouns.append((at, word, tuple(who)))

    def flag(self, topic: str, choice: str, reason: str, start: int, end: int) -> None:
        """Note a decision for a person to check.

        Args:
            topic: Kind of the decision.
            choice: What was chosen.
            reason: Why it is uncertain.
            start: Offset in the script where its words start.
            end: Offset where they end.
        """
        self.reading.flags.append(Flag(topic=topic, choice=choice, reason=reason, start=start, end=end))

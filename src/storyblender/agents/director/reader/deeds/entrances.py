"""People who enter, who stay from the scene before, or who are only mentioned (notes of the director, 1e)."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.words import Word
from storyblender.agents.director.reader.page.sentences import Sentence
from storyblender.agents.director.reader.people.person_reference import gender_fits, resolve_mention
from storyblender.agents.director.reader.people.roles import Roles
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import Gender

_CALLING = frozenset({"call", "shout", "yell", "scream", "answer"})
_ARRIVING = frozenset({"enter", "come", "arrive", "return", "burst", "appear"})
"""A person who was on a screen does this, and is there."""
_MINDING = frozenset({"think", "talk", "dream", "remember", "miss", "mention", "imagine"})
_NEAR = (
    "to", "at", "behind", "beside", "with", "by", "toward", "towards", "near", "against", "between", "in front of",
    "next to", "from", "around", "past", "over", "under",
)  # fmt: skip
_PICTURE_OF = re.compile(
    r"\b(photo|photograph|picture|portrait|painting|statue|name|letter|note|call|news|memory|voice|dream|sign|trace"
    r"|word|gift|present|shadow|thought)s? (of|from)\b|\bthink(s|ing)? of$|\bthought of$"
    r"|\b(about|without|like|unlike|named|called|calls|misses|remembers|expects|awaits)"
    r"( the| a| my| his| her| our| their)?$"
    r"|\b(look|search|wait|ask|hop|long|hunt)(s|es|ed|ing|ed)?( around| everywhere| about| in vain)? for( \w+)?( \w+)?$"
)


@rule("people.subject_is_there", without=True)
def enter_subjects(state: ReaderState, clause: Clause, subjects: Sequence[Person]) -> bool:
    """Bring the subjects of a clause on stage; return False where they are only heard.

    Args:
        state: The reader's state; changed in place.
        clause: The clause.
        subjects: Subjects of the clause.
    """
    seen = True
    for person in subjects:
        again = person.id in state.sentence.named
        state.mention(person, 1.0 if len(subjects) == 1 and not again else 0.3)
        state.sentence.named.add(person.id)
        state.discourse.last_sentence[person.id] = state.discourse.sentence
        calls = clause.verb in _CALLING and clause.particle != "out" and any(p == "from" for p, _ in clause.places)
        if calls and person.id not in state.scene.on:
            state.scene.off_screen.add(person.id)
            seen = False
        if clause.verb in _ARRIVING:
            state.scene.pictured.discard(person.id)
        if seen and not clause.unreal and not state.sentence.pictured:
            state.enter(person)
            state.add_to_unit(person)
    return seen


@rule("people.object_is_there")
def enter_objects(state: ReaderState, clause: Clause, roles: Roles, motion: str | None) -> None:
    """Bring people on stage who are touched, addressed or stood beside.

    Args:
        state: The reader's state; changed in place.
        clause: The clause.
        roles: The people and things of the clause.
        motion: Motion of its subject, or None.
    """
    physical = bool(roles.subjects) and not state.sentence.pictured
    for person in roles.people + roles.recipients:
        state.mention(person, 0.6)
        state.sentence.named.add(person.id)
        state.discourse.last_sentence[person.id] = state.discourse.sentence
        if physical and motion and motion not in ("think", "listen", "phone"):
            state.enter(person)
            state.add_to_unit(person)
    for place in roles.places:
        told = [is_elsewhere(state, noun.index) for noun in place.nouns if noun.kind == "person"]
        for person in place.people:
            state.mention(person, 0.5)
            state.sentence.named.add(person.id)
            state.discourse.last_sentence[person.id] = state.discourse.sentence
            if physical and place.preposition in _NEAR and clause.verb not in _MINDING and not all(told or [False]):
                state.enter(person)
                state.add_to_unit(person)


def is_elsewhere(state: ReaderState, index: int) -> bool:
    """Whether a named person is not there: ``a letter from Otto``, ``no sign of him``, ``thinks of Mia``.

    Args:
        state: The reader's state.
        index: Word index of the mention.
    """
    before = " ".join(word.low for word in state.sentence.words[max(0, index - 4) : index])
    return _PICTURE_OF.search(before) is not None


@rule("people.named_is_there")
def enter_named(state: ReaderState, words: list[Word], clauses: list[Clause]) -> None:
    """Bring the people named in action on stage, unless the words around say that they are elsewhere.

    Args:
        state: The reader's state; changed in place.
        words: Words of the sentence.
        clauses: Clauses of the sentence.
    """
    for index, word in enumerate(words):
        if word.mention is None or not word.named:
            continue
        fresh = not word.mention.people
        people = resolve_mention(state, word.mention)
        clause = next((c for c in clauses if any(n.index == index for n in c.subject + c.object)), None)
        possessive = index + 1 < len(words) and words[index + 1].low == "'s"
        elsewhere = possessive or state.sentence.pictured or is_elsewhere(state, index)
        elsewhere = elsewhere or (clause is not None and (clause.unreal or clause.verb in _MINDING))
        for person in people:
            if fresh:
                state.discourse.raise_salience(person, 0.3)
            state.scene.named.add(person.id)
            if not elsewhere and person.id not in state.scene.off_screen:
                state.enter(person)
                state.add_to_unit(person)


_SUBJECTS: dict[str, Gender] = {"he": "male", "she": "female", "they": "unknown", "both": "unknown"}
_OF_THEM = frozenset({"the", "both", "these", "those"})
_ANY_PERSON = frozenset({"friend", "other", "lover", "figure", "people", "them"}) | lexicon.words("pairs")
"""Heads that say nothing of who they are."""


@rule("people.brought_along")
def carry_over_people(state: ReaderState, sentence: Sentence) -> None:
    """Put people of the scene before on stage, if a sentence means them before anyone is there.

    Args:
        state: Its scene knows who was there before.
        sentence: A sentence of action of a script with scene headings.
    """
    before = state.roster.in_order(filter(None, map(state.roster.person, state.scene.before)))
    if state.scene.on or not before:
        return
    for word in sentence.words:
        mention = word.mention
        if mention is not None and mention.kind == "group" and mention.determiner in _OF_THEM:
            _put_on_stage(state, _group_of_number(before, mention.head, mention.number))
        elif mention is not None:
            state.scene.before = state.scene.before if mention.kind == "group" else []
            before = [person for person in before if person not in mention.candidates]
        elif word.low in _SUBJECTS and state.scene.before:
            _put_on_stage(state, _people_for_pronoun(state, before, word.low))


def _group_of_number(before: Sequence[Person], head: str, number: int) -> list[Person]:
    """Return all people of the scene before if they are as many as said: ``the two women``."""
    gender = lexicon.gender_of_word(head)
    if head not in _ANY_PERSON and (gender == "unknown" or head in lexicon.KIN):
        return []
    fitting = [person for person in before if person.kind == "human" and gender_fits(person, gender)]
    return fitting if len(fitting) == number else []


def _people_for_pronoun(state: ReaderState, before: Sequence[Person], pronoun: str) -> list[Person]:
    """Return whom a pronoun means: for ``they`` everybody, else the one mentioned most."""
    people = [person for person in before if person.kind != "animal"]
    if _SUBJECTS[pronoun] == "unknown":
        return people if len(people) > 1 or any(person.count > 1 for person in people) else []
    fitting = [person for person in people if person.gender == _SUBJECTS[pronoun]]
    told = Counter(id for unit in state.reading.units for id in unit.people)
    return [max(fitting, key=lambda person: told[person.id])] if fitting else []


def _put_on_stage(state: ReaderState, people: Sequence[Person]) -> None:
    """Put people on stage and forget the scene before."""
    state.scene.on += [person.id for person in people if person.id not in state.scene.on]
    state.scene.before = [] if people else state.scene.before


@rule("people.still_there")
def restore_people(state: ReaderState) -> None:
    """Put people back on stage, as they were, when the story returns to the place where it left them.

    Args:
        state: Its scene has just begun; the unit that begins it is not there yet.
    """
    scenes, units = state.reading.scenes, state.reading.units
    here = scenes[state.scene.index]
    places = {here.id, here.reference} - {None}
    earlier = next(
        (
            index
            for index in range(state.scene.index - 1, -1, -1)
            if {scenes[index].id, scenes[index].reference} & places and scenes[index].time == here.time
        ),
        None,
    )
    if earlier is None or not here.place or "LATER" in here.time_written:
        return
    last = next((at for at in range(len(units) - 1, -1, -1) if units[at].scene == earlier), None)
    if last is None:
        return
    seen = {person for unit in units[last + 1 :] for person in (*unit.on_stage, *unit.people)}
    left = units[last]
    state.scene.on = [person for person in left.on_stage if person not in seen | {*left.leaving}]
    state.scene.posture = {person: left.posture[person] for person in state.scene.on if person in left.posture}
    state.scene.held = {person: list(left.held[person]) for person in state.scene.on if person in left.held}

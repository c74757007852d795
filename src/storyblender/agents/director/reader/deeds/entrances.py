"""Who comes on stage, and mentions of people who do not (notes of the director, 1e)."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.words import Word
from storyblender.agents.director.reader.people.people_meant import resolve_mention
from storyblender.agents.director.reader.people.roles import Roles
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_CALLING = frozenset({"call", "shout", "yell", "scream", "answer"})
_ARRIVING = frozenset({"enter", "come", "arrive", "return", "burst", "appear"})
"""Whoever was on a screen does this, and is there."""
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
def subjects_enter(stage: Stage, clause: Clause, subjects: Sequence[Person]) -> bool:
    """Bring the subjects of a clause on stage; returns False where they are only heard."""
    seen = True
    for person in subjects:
        again = person.id in stage.sentence.named
        stage.mention(person, 1.0 if len(subjects) == 1 and not again else 0.3)
        stage.sentence.named.add(person.id)
        stage.discourse.last_sentence[person.id] = stage.discourse.sentence
        calls = clause.verb in _CALLING and clause.particle != "out" and any(p == "from" for p, _ in clause.places)
        if calls and person.id not in stage.scene.on:
            stage.scene.off_screen.add(person.id)
            seen = False
        if clause.verb in _ARRIVING:
            stage.scene.pictured.discard(person.id)
        if seen and not clause.unreal and not stage.sentence.pictured:
            stage.enter(person)
            stage.involve(person)
    return seen


@rule("people.object_is_there")
def objects_enter(stage: Stage, clause: Clause, roles: Roles, motion: str | None) -> None:
    """People who are touched, spoken to or stood beside are on stage too."""
    physical = bool(roles.subjects) and not stage.sentence.pictured
    for person in roles.people + roles.recipients:
        stage.mention(person, 0.6)
        stage.sentence.named.add(person.id)
        stage.discourse.last_sentence[person.id] = stage.discourse.sentence
        if physical and motion and motion not in ("think", "listen", "phone"):
            stage.enter(person)
            stage.involve(person)
    for place in roles.places:
        told = [is_elsewhere(stage, noun.index) for noun in place.nouns if noun.kind == "person"]
        for person in place.people:
            stage.mention(person, 0.5)
            stage.sentence.named.add(person.id)
            stage.discourse.last_sentence[person.id] = stage.discourse.sentence
            if physical and place.preposition in _NEAR and clause.verb not in _MINDING and not all(told or [False]):
                stage.enter(person)
                stage.involve(person)


def is_elsewhere(stage: Stage, index: int) -> bool:
    """``a letter from Otto``, ``no sign of him``, ``thinks of Mia``: somebody named who is not there."""
    before = " ".join(word.low for word in stage.sentence.words[max(0, index - 4) : index])
    return _PICTURE_OF.search(before) is not None


@rule("people.named_is_there")
def named_enter(stage: Stage, words: list[Word], clauses: list[Clause]) -> None:
    """Everybody named in action is on stage, unless the words around say otherwise."""
    for index, word in enumerate(words):
        if word.mention is None or not word.named:
            continue
        fresh = not word.mention.people
        people = resolve_mention(stage, word.mention)
        clause = next((c for c in clauses if any(n.index == index for n in c.subject + c.object)), None)
        possessive = index + 1 < len(words) and words[index + 1].low == "'s"
        elsewhere = possessive or stage.sentence.pictured or is_elsewhere(stage, index)
        elsewhere = elsewhere or (clause is not None and (clause.unreal or clause.verb in _MINDING))
        for person in people:
            if fresh:
                stage.discourse.raise_(person, 0.3)
            stage.scene.named.add(person.id)
            if not elsewhere and person.id not in stage.scene.off_screen:
                stage.enter(person)
                stage.involve(person)

"""What is on or in a thing because the thing is full of it: ``The desk is littered with letters``."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.phrases import NounPhrase, Phrase
from storyblender.agents.director.reader.language.words import Word
from storyblender.agents.director.reader.people.roles import Roles
from storyblender.agents.director.reader.places.anchors import CONTAINERS, THINGS, holds_things
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import RelationKind

_FILLED = lexicon.words("filled")
"""Participles: ``crammed with``, ``strewn with``."""
_FILLING = lexicon.words("filling")
"""``fills the jar with coins``."""
_COVERING = lexicon.words("covering")
"""``A sheet covers the piano``."""
_HOLDING = lexicon.words("having_inside")
"""``The drawer holds a pistol``."""
_BEARING = frozenset({"tray", "plate", "shelf", "rack", "platter"})
_FOOD = lexicon.words("food")
_BACK = 6
"""Phrases back to what is full."""


@rule("relations.contents")
def relate_contents(stage: Stage, clause: Clause, roles: Roles) -> None:
    """``The drawer holds a pistol``, ``Jars line the shelf``, ``She fills the jar with coins``.

    Args:
        stage: The state before.
        clause: Not negated.
        roles: Its people and things.
    """
    if clause.passive:
        return
    if not roles.subjects and roles.subject_things and roles.things:
        if clause.verb in _HOLDING:
            _relate(stage, roles.things, roles.subject_things[0])
        elif clause.verb in _COVERING:
            _relate(stage, roles.subject_things, roles.things[0], "on")
    elif roles.subjects and roles.things and clause.verb in _FILLING:
        inside = [thing for place in roles.places if place.preposition == "with" for thing in place.things]
        _relate(stage, inside, roles.things[0], "on" if clause.verb in ("cover", "drape", "strew") else None)


@rule("relations.filled")
def relate_filled(stage: Stage, words: list[Word], phrases: list[Phrase]) -> None:
    """``A box full of letters``, ``The shelf above the bed is crammed with trophies``.

    Args:
        stage: The state before.
        words: The words of the sentence.
        phrases: Their phrases.
    """
    for index, phrase in enumerate(phrases):
        if phrase.kind != "preposition" or phrase.text not in ("with", "of", "in") or not phrase.first:
            continue
        if phrase.text == "of" and phrases[index - 1].noun:
            _relate_measured(stage, phrases[index - 1].noun, listed(phrases, index + 1)[:1])
        before = [word.low for word in words[max(0, phrase.first - 2) : phrase.first]]
        filled = next((low for low in reversed(before) if low in _FILLED), "")
        if not filled or (phrase.text == "of") != (filled == "full") or (phrase.text == "in" and filled != "covered"):
            continue
        whole = _whole(phrases, index)
        inside = _things(stage, [noun for noun in listed(phrases, index + 1) if noun.kind == "thing"])
        if whole and inside:
            _relate(stage, inside, stage.inventory.id_of(whole.key, words[whole.index].start))


def _relate_measured(stage: Stage, holder: NounPhrase | None, nouns: list[NounPhrase]) -> None:
    """``a crate of clubs``, ``a tray of cups``; a bag of sugar is but a bag."""
    if holder is None or holder.head not in CONTAINERS | _BEARING or any(noun.head in _FOOD for noun in nouns):
        return
    things = [thing for thing in _things(stage, nouns) if stage.inventory.class_of(thing) in ("prop", "set_piece")]
    at = stage.sentence.words[holder.index].start
    _relate(stage, things, stage.inventory.id_of(holder.key, at))


def listed(phrases: list[Phrase], index: int) -> list[NounPhrase]:
    """The nouns of a list that starts at an index: ``a lamp, two clocks and a vase``."""
    nouns: list[NounPhrase] = []
    while index < len(phrases):
        noun = phrases[index].noun
        if noun is None:
            break
        nouns.append(noun)
        measured = [phrase.text for phrase in phrases[index + 1 : index + 2]] == ["of"]
        index += 2 if measured and index + 2 < len(phrases) and phrases[index + 2].noun else 0
        after = [phrase.text for phrase in phrases[index + 1 : index + 3]]
        if not after or after[0] not in (",", "and"):
            break
        index += 3 if after == [",", "and"] else 2
    return nouns


def _whole(phrases: list[Phrase], index: int) -> NounPhrase | None:
    """What is full: the noun before; where ``is`` stands between, its subject."""
    left = phrases[index - 1].noun if index else None
    if left and left.head != "full" and phrases[index].text == "of":
        return left if left.kind == "thing" else None  # a saucer full of pegs
    verb = next((at for at in range(index - 1, max(-1, index - 3), -1) if phrases[at].kind == "verb"), None)
    passive = verb is not None and phrases[verb].verb is not None and verb > 0
    start = verb if passive and verb is not None else index
    for at in range(start - 1, max(-1, start - _BACK), -1):
        noun, left = phrases[at].noun, phrases[at - 1] if at else None
        inner = passive and left is not None and left.kind == "preposition" and at > 1
        if noun and not inner:
            return noun if noun.kind == "thing" else None
    return None


def _things(stage: Stage, nouns: list[NounPhrase]) -> list[str]:
    return [stage.inventory.id_of(noun.key, stage.sentence.words[noun.index].start) for noun in nouns]


def _relate(stage: Stage, things: list[str], whole: str, kind: RelationKind | None = None) -> None:
    if not holds_things(stage, whole):
        return
    kind = kind or ("in" if stage.inventory.head(whole) in CONTAINERS else "on")
    for thing in things:
        if stage.inventory.class_of(thing) in THINGS and stage.inventory.head(thing) not in lexicon.LIQUIDS:
            stage.relate(thing, kind, whole)

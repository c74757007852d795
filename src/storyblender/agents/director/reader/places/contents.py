"""What is on or in a thing because the thing is full of it: ``The desk is littered with letters``."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.phrases import NounPhrase, Phrase
from storyblender.agents.director.reader.people.roles import Roles
from storyblender.agents.director.reader.places.anchors import CONTAINERS, THINGS, holds_things
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import RelationKind

_FILLING = lexicon.words("filling")
"""``fills the jar with coins``."""
_COVERING = lexicon.words("covering")
"""``A sheet covers the piano``."""
_HOLDING = lexicon.words("having_inside")
"""``The drawer holds a pistol``."""


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


def _relate(stage: Stage, things: list[str], whole: str, kind: RelationKind | None = None) -> None:
    if not holds_things(stage, whole):
        return
    kind = kind or ("in" if stage.inventory.head(whole) in CONTAINERS else "on")
    for thing in things:
        if stage.inventory.class_of(thing) in THINGS and stage.inventory.head(thing) not in lexicon.LIQUIDS:
            stage.relate(thing, kind, whole)

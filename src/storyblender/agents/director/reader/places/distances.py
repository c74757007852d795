"""People at a distance from each other: ``a YOUNG OFFICER ten metres behind him`` (notes of the director, 4.3)."""

from __future__ import annotations

from itertools import pairwise

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.words import Word
from storyblender.agents.director.reader.people.coreference import Referents, remember, resolve_pronoun
from storyblender.agents.director.reader.people.people_meant import resolve_mention
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_SIDES = frozenset({"side", "shoulder", "elbow", "hip", "cheek", "knee"})


@rule("relations.distance_told")
def settle_apart(stage: Stage, words: list[Word]) -> None:
    """``ROOK pushes through with a YOUNG OFFICER ten metres behind him``: him is Rook, named first."""
    named = [index for index, word in enumerate(words) if word.named]
    for index in named[1:]:
        _, after = _preposition_at(words, index + 3)
        counted = index + 1 < len(words) and (words[index + 1].low in lexicon.NUMBERS or words[index + 1].low.isdigit())
        mention = words[named[0]].mention
        if counted and mention and after < len(words) and lexicon.PRONOUNS.get(words[after].low) in ("male", "female"):
            remember(stage, after, Referents(resolve_mention(stage, mention)))


@rule("relations.apart")
def relate_apart(stage: Stage, words: list[Word], subjects: list[Person], previous: list[Person]) -> None:
    """``A YOUNG OFFICER ten metres behind him``: a person, a distance, a preposition and another person."""
    for index, word in enumerate(words):
        if not word.named or word.mention is None:
            continue
        at = index + 1
        if at >= len(words) or not (words[at].low in lexicon.NUMBERS or words[at].low.isdigit()):
            continue
        preposition, after = _preposition_at(words, at + 2)
        kind = lexicon.relation_of(preposition) if preposition != "ahead of" else "in_front_of"
        if kind is None or after >= len(words):
            continue
        people = resolve_mention(stage, word.mention)
        for other in _person_at(stage, words, after, [p for p in subjects if p not in people], previous):
            for person in people:
                stage.relate(person.id, kind, other.id)


@rule("relations.side_by_side")
def relate_side_by_side(stage: Stage, words: list[Word], subjects: list[Person]) -> None:
    """``They sit side by side``, ``stand shoulder to shoulder``: each next to the one named before.

    Args:
        stage: The state after the clauses.
        words: The sentence as it is written.
        subjects: Of the sentence.
    """
    low = [word.low for word in words]
    if any(low[i] == low[i + 2] in _SIDES and low[i + 1] in ("by", "to") for i in range(len(low) - 2)):
        for before, person in pairwise(subjects):
            stage.relate(before.id, "next_to", person.id)


def _preposition_at(words: list[Word], at: int) -> tuple[str, int]:
    """The preposition that starts at a position, and the position after it."""
    for length in (3, 2, 1):
        text = " ".join(word.low for word in words[at : at + length])
        if text in lexicon.RELATION_OF_PREPOSITION or text == "ahead of":
            return text, at + length
    return "", at


def _person_at(
    stage: Stage, words: list[Word], at: int, subjects: list[Person], previous: list[Person]
) -> list[Person]:
    word = words[at]
    if word.mention:
        return resolve_mention(stage, word.mention)
    if lexicon.PRONOUNS.get(word.low, "thing") == "thing":
        return []
    known = stage.sentence.pronouns.get(at)
    if known:
        return known[0]
    return remember(stage, at, Referents(resolve_pronoun(stage, word.low, "possessor", subjects, previous))).people

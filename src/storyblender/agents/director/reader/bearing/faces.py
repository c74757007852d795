"""Facial expressions without a deed: ``Furious, Otto``, ``She looks worried``, ``a grin spreads over his face``."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.words import Word
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_NOT = frozenset(
    {"not", "n't", "no", "never", "without", "hardly", "nor", "neither", "less", "nothing", "longer", "if"}
)
_LOOK_BACK = 4
"""Words before an expression in which a negation is looked for."""


@rule("bearing.face")
def note_faces_told(stage: Stage, words: Sequence[Word], people: Sequence[Person]) -> None:
    """Note the facial expressions in a sentence, each with its person.

    Args:
        stage: Its unit takes the expressions.
        words: The sentence.
        people: The people of the sentence, or of the one before if it names none.
    """
    for at, word in enumerate(words):
        expression = lexicon.EXPRESSION_OF_WORD.get(word.low)
        if expression is None or word.mention or word.quotation or _is_denied(words, at) or _is_of_a_thing(words, at):
            continue
        for person in _whose(stage, words, at) or people:
            stage.unit.expressions[person.id] = expression


def _is_denied(words: Sequence[Word], at: int) -> bool:
    return any(word.low in _NOT for word in words[max(0, at - _LOOK_BACK) : at])


def _is_of_a_thing(words: Sequence[Word], at: int) -> bool:
    """``an angry sea``, ``a sad little flag``: the word describes a thing."""
    for word in words[at + 1 : at + 3]:
        if word.mention:
            return False
        noun_class = lexicon.noun_class(word.low) if word.text.isalpha() else "unknown"
        if noun_class in ("prop", "set_piece", "scenery", "worn"):
            return True
        if not word.text.isalpha() or word.low in lexicon.PREPOSITIONS | lexicon.CONJUNCTIONS:
            return False
    return False


def _whose(stage: Stage, words: Sequence[Word], at: int) -> list[Person]:
    """Return the last person named before the word, or right after it at the start: ``Furious, Otto leaves``."""
    if at > 2 and words[at - 1].text == "," and stage.sentence.subjects:
        return []  # Otto looks at Nora, puzzled.
    for index in range(at - 1, -1, -1):
        if words[index].text in ";:" and index:
            break
        people = _people_of(stage, words, index)
        if people:
            return people
    following = next(
        (people for index in range(at + 1, min(at + 4, len(words))) if (people := _people_of(stage, words, index))), []
    )
    return following if at < 2 else []


def _people_of(stage: Stage, words: Sequence[Word], index: int) -> list[Person]:
    word = words[index]
    if word.mention and word.mention.people:
        return [person for person in word.mention.people if person.id in stage.scene.on]
    return [person for person in stage.sentence.pronouns.get(index, ([], None))[0] if person.id in stage.scene.on]

"""Which words of a sentence belong together though another clause stands around them."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.phrases import Phrase


def inverts(phrases: list[Phrase]) -> bool:
    """``Above the bed hangs a crucifix``: a place, a verb, and only then its subject.

    Args:
        phrases: Of a sentence that begins with a preposition.
    """
    verb = phrases[2].verb if len(phrases) > 3 and phrases[1].kind == "noun" else None
    return verb is not None and verb.lemma in lexicon.INVERTING | {"be"} and phrases[3].kind == "noun"


def has_own_place(phrases: list[Phrase], index: int) -> bool:
    """``Kate stands behind the counter, Joe in front of it.``: the last words are about Joe.

    Args:
        phrases: Of the sentence.
        index: Of the person.
    """
    after = phrases[index + 1 : index + 4]
    kinds = [phrase.kind for phrase in after[:2]]
    told = kinds == ["preposition", "noun"] and after[0].text in lexicon.RELATION_OF_PREPOSITION
    return told and (len(after) < 3 or after[2].text in (".", ",", ";"))

"""Word order in a sentence: inverted, fronted and absolute clauses, and lists."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.phrases import Phrase

_NEW = frozenset({"a", "an", "another", "two", "three", "four", "five", "six", "several", "some", "many", "more"})
_ENDS = (".", ",", ";", "and", "of", "with")


def is_inverted(phrases: list[Phrase]) -> bool:
    """Whether a place and a verb come before the subject: ``Above the bed hangs a crucifix``.

    Args:
        phrases: Of a sentence that begins with a preposition.
    """
    verb = phrases[2].verb if len(phrases) > 3 and phrases[1].kind == "noun" else None
    return verb is not None and verb.lemma in lexicon.INVERTING | {"be"} and phrases[3].kind == "noun"


def is_verbless_placement(phrases: list[Phrase], index: int) -> bool:
    """Whether a noun has a place without a verb: ``Kate stands there, Joe in front of it.``

    Args:
        phrases: Of the sentence.
        index: Of the person.
    """
    several = [phrase.text for phrase in phrases[index + 1 : index + 2]] == ["and"] and index + 2 < len(phrases)
    index += 2 if several and phrases[index + 2].kind == "noun" else 0  # Iris and Otto after them
    after = phrases[index + 1 : index + 4]
    kinds = [phrase.kind for phrase in after[:2]]
    told = kinds == ["preposition", "noun"] and after[0].text in lexicon.RELATION_OF_PREPOSITION
    return told and (len(after) < 3 or after[2].text in (".", ",", ";"))


def is_fronted(phrases: list[Phrase], at: int) -> bool:
    """Whether places at an index open a clause: ``under the window was a wheel``, ``behind him Al sat``.

    Args:
        phrases: Of the sentence.
        at: Of the first place.
    """
    start = at
    while at + 1 < len(phrases) and phrases[at].kind == "preposition" and phrases[at + 1].kind == "noun":
        if phrases[at].text not in lexicon.RELATION_OF_PREPOSITION:
            return False
        both = phrases[at].text == "between" and [p.text for p in phrases[at + 2 : at + 3]] == ["and"]
        at += 4 if both else 2
    if at == start or at >= len(phrases) or phrases[at - 1].kind != "noun":
        return False
    at += phrases[at].text == "," and at + 1 < len(phrases)
    new, after = phrases[at].noun, phrases[at + 1].text if at + 1 < len(phrases) else "."
    if new and phrases[start - 1].text != "," and (new.kind == "person" or new.determiner in ("a", "an")):
        return True  # a bed, and behind it a lamp
    told = new is not None and (new.determiner in _NEW or (phrases[start - 1].text == ";" and not new.determiner))
    if new and new.kind == "thing" and told and phrases[at - 1].kind in ("noun", "mark") and after in _ENDS:
        return True  # a sink, above it a mirror
    inverted = phrases[at].kind == "verb"
    verb = phrases[at if inverted or at + 1 == len(phrases) else at + 1].verb
    if verb is None or verb.kind not in ("past", "aux", "3sg") or not (inverted or phrases[at].kind == "noun"):
        return False
    return not inverted or (verb.lemma in lexicon.INVERTING | {"be"} and phrases[start - 1].text != ",")


def is_absolute(phrases: list[Phrase], index: int) -> bool:
    """Whether a noun opens an absolute clause: ``, the robot bumping along behind them``, ``, engine running``.

    Args:
        phrases: Of the sentence.
        index: Of who or what does it; a phrase stands before it.
    """
    left, following = phrases[index - 1], phrases[index + 1] if index + 1 < len(phrases) else None
    kinds = ("ing", "pp", "past") if left.text == "with" else ("ing", "pp")
    participle = following is not None and following.verb is not None and following.verb.kind in kinds
    return left.text in (",", "while", "with", "as") and participle


def list_ends(phrases: list[Phrase], index: int) -> bool:
    """Whether the noun at an index is in a list that an ``and`` closes: ``a pistol, a map and a key``.

    Args:
        phrases: Of the sentence.
        index: Of the noun.
    """
    while index > 0 and index < len(phrases) and phrases[index].kind == "noun":
        if phrases[index - 1].text == "and":
            return True
        measured = index + 2 < len(phrases) and phrases[index + 1].text == "of" and phrases[index + 2].kind == "noun"
        index += 2 if measured else 0  # a jar of brushes
        after = [phrase.text for phrase in phrases[index + 1 : index + 3]]
        if not after or after[0] not in (",", "and"):
            return False
        index += 3 if after == [",", "and"] else 2
    return False


def verb_follows(phrases: list[Phrase], index: int) -> bool:
    """Whether nouns from an index end at a finite verb: ``but her son, taking it, examined it``.

    Args:
        phrases: Of the sentence.
        index: Of the first noun.
    """
    linked, aside = index > 0 and phrases[index - 1].kind == "link", phrases[index + 1 : index + 3]
    if linked and len(aside) > 1 and aside[0].text == "," and aside[1].verb and aside[1].verb.kind == "ing":
        return True
    while index < len(phrases):
        phrase = phrases[index]
        right = phrases[index + 1] if index + 1 < len(phrases) else None
        joins = (
            right is not None and right.kind == "noun" and (phrase.text in (",", "and") or phrase.kind == "preposition")
        )
        if phrase.kind != "noun" and not joins:
            return phrase.kind == "verb" and (phrase.verb is None or phrase.verb.kind != "ing")
        index += 1
    return False

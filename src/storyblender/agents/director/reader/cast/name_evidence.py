"""Evidence in a prose story that a capitalised word is a person's name, and of the person's gender."""

from __future__ import annotations

import re
from functools import lru_cache

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import unaccented
from storyblender.agents.director.reader.language.morphology import form_kind, is_person_noun
from storyblender.agents.director.reader.language.words import TextIndex
from storyblender.catalog.inflection import singular

_REACH = 40
"""Characters before and after a name that are searched."""
_KNOWN = lexicon.FIRST_NAMES | lexicon.TITLES | lexicon.KIN
_DETERMINED = re.compile(
    rf"\b(?:(?:{'|'.join(sorted((lexicon.DETERMINERS | lexicon.POSSESSIVES) - {'that'}))})\s+|that\s+(?=[a-z]))"
    r"(?:([a-z-]+)\s+)?$",
    re.IGNORECASE,
)
"""``that certain Messuage``, ``a Mortgage``."""
_SAID = re.compile(rf"\b(?:{'|'.join(sorted(lexicon.SPEECH_VERBS))}|said|asked|cried)\s+$")
_AFTER = re.compile(r"(?:,\s+(?:who|with|in|an?|the|his|her)\b[^.;,]{0,30},)?\s+(?:[a-z]+ly\s+)?([a-z]+)")
_AGED = re.compile(r"\s*[,(]\s*(?:aged?\s)?\d\d?\b")
_OPENS = re.compile(r"(?:^|[.!?;…”\"\n(\[—–-])\s*$")


def is_person_name(name: str, told: TextIndex) -> bool:
    """Whether a name is a person's: it is known, acts, speaks, has an age, or occurs inside sentences.

    Args:
        name: The name as written.
        told: The words of the story without its speeches.
    """
    words = name.lower().split()
    first = unaccented(words[0].strip("."))
    if first in lexicon.TITLES and len(words) > 1:
        return True
    known = first in _KNOWN
    inside, places = False, list(told.places(name))
    for at in places:
        before, after = told.text[max(0, at - _REACH) : at], told.text[at + len(name) : at + len(name) + _REACH]
        determined = _is_determined(before)
        if _AGED.match(after) or _SAID.search(before) or (not determined and _is_action(after)):
            return True
        inside = inside or not (determined or _OPENS.search(before))
    return not places or (inside and (known or not _is_common(words)))


def _is_determined(before: str) -> bool:
    """Whether a determiner precedes: ``a Mortgage``, but not ``in the house Margaret sat``, ``her son Pierre``."""
    left = _DETERMINED.search(before)
    between = left.group(1) if left else None
    if between is not None and is_person_noun(singular(between)):
        return False
    return left is not None and (between is None or lexicon.noun_class(singular(between)) == "unknown")


def _is_action(after: str) -> bool:
    """Whether a verb of human action follows."""
    following = _AFTER.match(after)
    word = following.group(1) if following else ""
    return word in ("and", "who") or form_kind(word) in ("3sg", "past", "aux")


def _is_common(words: list[str]) -> bool:
    """Whether a capitalised word is a common noun: ``Mortgage``, ``Media``, ``Only``."""
    last = singular(words[-1])
    return (
        lexicon.noun_class(last) != "unknown"
        or words[0] in lexicon.ADJECTIVES | lexicon.ADVERBS
        or form_kind(words[0]) != ""
    )


@lru_cache(maxsize=1024)
def gender_by_pronouns(told: str, called: str) -> str:
    """Return the gender of ``he`` or ``she`` near a name that opens a sentence; ``unknown`` where none is.

    Args:
        told: The story without speeches.
        called: The name or noun.
    """
    votes = {"male": 0, "female": 0}
    for match in re.finditer(
        rf"(?:^|[.!?\n]\s*){called}\s([a-z][^.!?\nA-Z]*)(?:[.!?] {{1,2}}(He|She)\b|[.!?\n]|$)", told
    ):
        words = [*re.findall(r"\w+", match.group(1).lower())[:12], (match.group(2) or "").lower()]
        kind = next((lexicon.PRONOUNS[word] for word in words if word in ("he", "she")), "")
        if kind in votes:
            votes[kind] += 1
    for match in re.finditer(rf"\b{called}[.!?,]\s+(He|She)\b", told):
        votes["male" if match.group(1) == "He" else "female"] += 1
    if votes["male"] == votes["female"]:
        return "unknown"
    return max(votes, key=lambda kind: votes[kind])

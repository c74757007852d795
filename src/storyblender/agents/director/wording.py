"""The Director's own sentences: what a shot shows, how the camera sees it, what a person does."""

from __future__ import annotations

import re
from typing import Final

from storyblender.agents.director.lexicon import ADJECTIVES, DETERMINERS, POSSESSIVES, PREPOSITIONS
from storyblender.agents.director.reading import Deed, Thing, Unit
from storyblender.catalog.props.variants import COLORS, MATERIALS, PLAIN, TOY_WORDS

_LOOSE_END: Final = re.compile(
    r"[\s,;]*(?:\b(?:with|and|then|while|as|but|until|till|who|in|on)\b)?[\s,;]*(?:\b(?:an?|the|his|her|he|she|they|it)\b)?[\s,;.]*$",
    re.IGNORECASE,
)
"""What hangs over from the next clause."""
_DETERMINERS: Final = DETERMINERS | POSSESSIVES
_DESCRIBING: Final = COLORS.keys() | MATERIALS.keys() | PLAIN | TOY_WORDS
_MOTION_WORDS: Final = {"idle": "is there", "talk": "speaks", "whisper": "whispers", "shout": "shouts", "sing": "sings"}


def one_line(text: str) -> str:
    """Return text without line breaks and doubled spaces."""
    return " ".join(text.split())


def modifiers_of(thing: Thing, text: str) -> str:
    """Return what a thing is called besides its name where it is first named: ``small round`` of a table.

    A single word after an article belongs to the noun whatever it is; of more words only those that describe.

    Args:
        thing: ``first`` is the offset of the first mention.
        text: The script.
    """
    phrase = re.split(r"[.;:!?()\n]", text[max(0, thing.first - 60) : thing.first])[-1].lower()
    listed = phrase.rpartition(",")
    before = re.findall(r"[\w'-]+", listed[0])
    phrase = phrase if before and before[-1] in _DESCRIBING | ADJECTIVES else listed[2]
    words = re.findall(r"[\w'-]+", phrase)
    known = thing.name.lower().split()
    while words and words[-1] in known:
        words.pop()
    found: list[str] = []
    while words and words[-1] in _DESCRIBING | ADJECTIVES and words[-1] not in _DETERMINERS:
        found.insert(0, words.pop())
    if not found and len(words) > 1 and words[-2] in _DETERMINERS and words[-1] not in _DETERMINERS | PREPOSITIONS:
        found = [words[-1]]
    return " ".join(found)


def deed_words(deed: Deed, unit: Unit, text: str) -> str:
    """Return what a person does in the script's own words, from the verb to the next deed.

    Args:
        deed: The deed; in a speech, or if it is outside its unit, the words are those of its motion.
        unit: The unit with the deed.
        text: The script.
    """
    if unit.kind == "dialogue" or not unit.start <= deed.at < unit.end:
        return _MOTION_WORDS.get(deed.motion, deed.motion.replace("_", " "))
    later = [other.at for other in unit.deeds if deed.at < other.at < unit.end]
    words = one_line(text[deed.at : min(later, default=unit.end)])
    words = _LOOSE_END.sub("", words).rstrip(" ,;.!?:–—-")
    return words or deed.verb or deed.motion.replace("_", " ")

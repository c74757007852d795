"""Ages as people write them: ``late 30s``, ``72 years``, ``about nine``, ``sixty if she's a day``, ``15-year-old``."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon

_SPELLED = "|".join(sorted(map(re.escape, lexicon.SPELLED_AGES), key=lambda word: (-len(word), word)))
_PART = r"(early|mid|middle|late)(?:[- ]to[- ](?:mid|late))?[- ]+"
_ABOUT = (
    r"(?:age|aged|about|around|some|barely|nearly|almost|maybe|perhaps|pushing|roughly|of|just|only|not yet|over|under)"
)
_AGE = re.compile(
    rf"(?:(?:in )?(?:his|her|their) )?(?:{_ABOUT} )*(?:{_PART})?(\d{{1,3}}|{_SPELLED})(['’]?s|[- ]something|ish)?\+?"
    r"(?:[- ](?:years?|yrs?)(?:[- ](?:old|of age))?|[- ]?y/?o|[- ]year[- ]olds?)?"
    r"(?: if (?:he|she|they)(?:['’]s| is|['’]re| are) a day| or so| at (?:most|least)| going on \w+)?",
    re.IGNORECASE,
)
_STAGES = {
    "middle aged": "50s", "middle-aged": "50s", "midlife": "50s", "elderly": "70s", "teenaged": "teen",
    "late teens": "18", "early teens": "13", "mid teens": "15", "preteen": "11", "pre-teen": "11", "toddler": "infant",
    "college age": "20s", "college-aged": "20s", "retirement age": "60s",
}  # fmt: skip
_OLDEST = 120


def age_of(phrase: str) -> str:
    """Return the age in a part of a description, in the form casting reads, or an empty string.

    Args:
        phrase: A part without commas: ``mid-30s``, ``about nine years old``.
    """
    words = " ".join(phrase.lower().replace("–", "-").split()).strip(" .!?")
    if words in _STAGES:
        return _STAGES[words]
    match = _AGE.fullmatch(words)
    if match is None:
        return ""
    part, number, plural = match.groups()
    told = lexicon.SPELLED_AGES.get(number, number)
    if told.rstrip("s").isdigit() and int(told.rstrip("s")) > _OLDEST:
        return ""
    if part or (plural and told[-1] == "0"):
        told = f"{told.rstrip('s')}s"
    return f"{'mid' if part == 'middle' else part} {told}" if part else told

"""Asides: opinions, remarks and jokes of the writer to the reader, which cannot be filmed."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.manuscript import without_brackets
from storyblender.agents.director.reader.page.sentences import Sentence
from storyblender.agents.director.rules import rule

_TO_THE_READER = re.compile(
    r"\b(?:you (?:can(?:'t| not)?|could|know|see|get the (?:idea|picture)|guessed|should know|need to know|have been)"
    r"|dear reader|ladies and gentlemen|trust me"
    r"|believe me|don'?t (?:ask|worry|worry about)|by the way|to be (?:fair|honest|clear)|(?:i|we) (?:mean|know|think"
    r"|promise|swear|guess|have a budget)|picture (?:a|an|this)|imagine"
    r"|think (?:of )?[A-Z]\w+ meets|spoiler|needs? a twist|wait for it|more on (?:this|that|him|her|them) later"
    r"|we(?:'ve| have) all|we are all|our hero(?:ine)?"
    r"|in other words|as if|if you (?:have|know|like)|let(?:'s| us) (?:call|say|face)|no wonder|of course\W*$"
    r"|what can you do|that'?s (?:it|the \w+|all)\b|go with god)",
    re.IGNORECASE,
)
_INTERJECTION = re.compile(
    r"(?:oof|ouch|ugh|huh|hmm+|yep|yes|no|nope|well|oh|ah|aha|ha|okay|ok|fine|sure|exactly|anyway"
    r"|fair(?:'s fair| enough)|of course"
    r"|obviously|naturally|really|seriously|whatever|nothing|wrong answer|same here|literally|classic|typical"
    r"|bingo)\b\W*(?:\w+\W*)?$",
    re.IGNORECASE,
)
_TO_THE_ARTIST = re.compile(
    r"(?:please |just )?(?:leave|keep|draw|don'?t|let|give|gie|make|show|think|use|try|remember|have fun|note"
    r"|feel free|go wild)\b",
    re.IGNORECASE,
)
"""Phrases by which a comic script or a commercial addresses the artist."""
_GENDERS = ("male", "female", "plural")
_QUESTION = re.compile(r"\?\W*$")


@rule("page.aside", without=False)
def is_aside(sentence: Sentence, text: str, *, drawn: bool = False) -> bool:
    """Whether a sentence of action only speaks to the reader.

    Args:
        sentence: A sentence of action in a screenplay.
        text: The script.
        drawn: The page also addresses an artist.
    """
    words = " ".join(without_brackets(text[sentence.start : sentence.end]).split())
    if sentence.speech or sentence.camera or not words:
        return False
    named = any(word.mention is not None or lexicon.PRONOUNS.get(word.low) in _GENDERS for word in sentence.words)
    if _INTERJECTION.fullmatch(words) and not named:
        return True
    if named:
        return False
    if drawn and _TO_THE_ARTIST.match(words):
        return True
    return _TO_THE_READER.search(words) is not None or _QUESTION.search(words) is not None

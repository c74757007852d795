"""The historical age in which a story plays, decided once from its words, for clothes, sets and things.

Each word is counted once, so that one name or one picture on a wall does not decide it.
"""

from __future__ import annotations

import re
from typing import Final

from storyblender.agents.director.reader.manuscript import QUOTATION, without_quotations
from storyblender.catalog.years import years_in, years_said
from storyblender.memory.vocabulary import Age
from storyblender.screenplay.model import ElementKind, Screenplay

_SURE = 3
"""Weight of the words that tell an age."""
_WORDS: Final[dict[Age, dict[str, int]]] = {
    "medieval": {
        r"medieval|middle ages": 3,
        r"knights?": 2,
        r"vikings?|samurai|gladiators?|legionar(?:y|ies)|pharaohs?": 3,
        **dict.fromkeys((r"prince|princess", r"monks?"), 1),
        **dict.fromkeys(("king", "queen", "castle", "throne", r"swords?", "dungeon", "squire", r"peasants?"), 1),
        **dict.fromkeys((r"minstrel|bard", r"armou?r|chain ?mail", r"wizard|sorcerer", r"drawbridge|moat|lance"), 1),
    },
    "west": {
        r"cowboys?|gunslingers?|outlaws?|wild west": 2,
        r"saloon|stagecoach|frontier": 2,
        **dict.fromkeys(("sheriff", "marshal", "western", "whiske?y", "ranch", r"revolvers?|colt", "prairie"), 1),
    },
    "victorian": {
        r"victorian|edwardian|regency": 3,
        r"hansom|coachman|footm[ae]n|governess": 2,
        **dict.fromkeys((r"parlou?r", "carriage", "drawing[- ]room", "butler", "gaslight|gas lamp", "baronet"), 1),
        r"mail[- ]coach|post[- ]chaise|postilion|ostler|turnpike|highwayman|workhouse|lamplighter": 2,
        **dict.fromkeys((r"bonnets?|petticoats?|crinoline", r"breeches|cravat|waistcoats?", "snuff[- ]?box|gibbet"), 1),
        **dict.fromkeys((r"guineas?|shillings?|half[- ]a[- ]crown|farthings?", r"the (?:\w+ )?coach(?:es)?"), 1),
    },
    "classic": {
        **dict.fromkeys((r"fedora|trench ?coat", "gramophone", "telegram|typewriter", "speakeasy|noir"), 1),
        **dict.fromkeys((r"jukebox", r"trolley ?(?:car|bus)", r"dial telephone|switchboard"), 1),
        r"gestapo|wartime|air raid|blackout": 2,
        "steam train|steam engine|locomotive": 1,
        r"nazis?|wehrmacht|luftwaffe|third reich|resistance fighters?": 2,
        r"german (?:soldiers?|officers?)|bomber crews?|propellers?|biplanes?|ration (?:books?|cards?)": 1,
    },
    "space": {
        r"space ?ships?|star ?ships?|spacecraft|space station": 3,
        **dict.fromkeys((r"airlock", r"orbit", r"aliens?", r"planets?", r"galax(?:y|ies)", r"asteroids?"), 1),
    },
    "today": {
        r"laptops?|smart ?phones?|cell ?phones?|i(?:phone|pad|mac)s?|wi-?fi|selfies?|touch ?screens?|internet": 3,
        r"e-?mails?|emojis?|hash ?tags?|podcasts?|bluetooth|earbuds|webcams?|usb|google|youtube|instagram|netflix": 3,
        r"sat ?nav|gps|face ?time|zoom call|cctv|tiktok|voice ?mail|bar ?codes?|dvds?|text messages?": 3,
        **dict.fromkeys((r"apps?", r"drones?", r"hoodies?", r"suvs?", r"microwaves?", r"atm", r"vap(?:e|ing)"), 2),
        r"text(?:s|ed|ing)? (?:him|her|them|me|back)|uber": 2,
        **dict.fromkeys((r"computers?", r"monitors?", r"tablets?", r"sneakers", r"video"), 1),
    },
}  # fmt: skip
_YEARS: Final[dict[Age, tuple[int, int]]] = {
    "medieval": (1000, 1599),
    "victorian": (1600, 1909),
    "classic": (1910, 1969),
    "today": (1980, 2099),
}
"""First and last year of an age."""

_TOLD: frozenset[ElementKind] = frozenset(
    {"heading", "action", "cue", "parenthetical", "shot", "centered", "section", "synopsis", "title"}
)
_SAID: frozenset[ElementKind] = frozenset({"dialogue", "lyric"})


def narration_and_speech(screenplay: Screenplay) -> tuple[str, str]:
    """Return the narration and the speeches of a script, a paragraph a line."""
    told, said = [screenplay.title], []
    for element in screenplay.elements:
        if element.kind in _SAID:
            said.append(element.text)
        elif element.kind in _TOLD and screenplay.format == "prose":
            told.append(without_quotations(element.text))
            said += [quotation.group() for quotation in QUOTATION.finditer(element.text)]
        elif element.kind in _TOLD:
            told.append(element.text)
    return "\n".join(told), "\n".join(said)


def age_of(screenplay: Screenplay) -> Age | None:
    """Return the age that a script speaks of most; None where none is sure and today is assumed."""
    return age_in_words(*narration_and_speech(screenplay))


def age_in_words(story: str, said: str = "") -> Age | None:
    """Return the age that words speak of most, or None.

    Args:
        story: What the story tells: headings, title cards, action. No title page: a house number is no year.
        said: What its people say; they speak of other years than their own.
    """
    words = f"{story}\n{said}".lower()
    years = (*years_in(story), *years_said(said))
    weights: dict[Age, int] = {}
    for age, patterns in _WORDS.items():
        weights[age] = sum(value for pattern, value in patterns.items() if re.search(rf"\b(?:{pattern})\b", words))
        first, last = _YEARS.get(age, (1, 0))
        weights[age] += _SURE * any(first <= year <= last for year in years)
    if weights["west"] >= _SURE:
        weights["victorian"] = 0  # its years and revolvers are those of the west
    best = max(_WORDS, key=lambda age: weights[age])
    return best if weights[best] >= _SURE else None

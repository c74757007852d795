"""Costumes: what people of an age and a trade wear, where the script dresses nobody.

An age is heard from the story's own words, each word counted once, so that one name or one picture on a wall does not
move a story into another century. To dress a trade, add a line to ``_TRADES``.
"""

from __future__ import annotations

import re
from typing import Final, Literal

from storyblender.catalog.materials import hex_color
from storyblender.catalog.years import years_in, years_said
from storyblender.memory.asset_sheet import Garment

Age = Literal["medieval", "west", "victorian", "classic", "space", "today"]

_SURE = 3
"""Weight of the words that move a story into an age."""
_CHILD = 13

_WORDS: Final[dict[Age, dict[str, int]]] = {
    "today": {},
    "medieval": {
        r"medieval|middle ages": 3,
        r"knights?": 2,
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
    },
    "classic": {
        r"fedora|gramophone|trench ?coat|telegram|typewriter|speakeasy|noir": 1,
        r"gestapo|wartime|air raid|blackout": 2,
        "steam train|steam engine|locomotive": 1,
    },
    "space": {
        r"space ?ships?|star ?ships?|spacecraft|space station": 3,
        **dict.fromkeys((r"airlock", r"orbit", r"aliens?", r"planets?", r"galax(?:y|ies)", r"asteroids?"), 1),
    },
}  # fmt: skip
_YEARS: Final[dict[Age, tuple[int, int]]] = {
    "medieval": (1000, 1599),
    "victorian": (1600, 1909),
    "classic": (1910, 1969),
}
"""First and last year of an age."""

_EVERYDAY: Final[dict[Age, tuple[str, ...]]] = {
    "medieval": ("tunic:#5b4632 breeches:#3a342c boots", "tunic:#43503b breeches:#4a4038 boots", "gown:#4a3a2c shoes",
                 "gown:#3f5d46 shoes"),
    "west": ("shirt vest:#4d4136 trousers:#3d3a36 boots:#3a2312", "shirt:#8a7a5c vest trousers:#4a4038 boots",
             "blouse long_skirt boots", "blouse long_skirt:#5b4632 scarf boots"),
    "victorian": ("shirt vest bow_tie jacket:#2f2f33 trousers:same shoes",
                  "shirt vest:#4d4136 tie jacket:#4b4136 trousers shoes",
                  "blouse long_skirt boots", "blouse:#5d4a55 long_skirt boots"),
    "classic": ("shirt tie jacket trousers:same shoes", "shirt tie vest trousers shoes", "dress heels",
                "blouse skirt heels"),
    "space": ("uniform:#2f4a5e trousers:same boots", "uniform:#3a3f48 trousers:same boots") * 2,
}  # fmt: skip
"""Age -> two outfits of men, then two of women."""

_TRADES: Final[tuple[tuple[str, str, str, str], ...]] = (
    ("king|emperor", "medieval", "tunic:#6d1426 coat:#4a1020 breeches:#2c2d33 boots", ""),
    ("queen|princess|duchess", "", "", "gown:#5a1f3d heels"),
    ("lady", "medieval", "", "gown:#1f4d3a heels"),
    ("knight|sir|guard|soldier|captain", "medieval", "tunic:#85898f breeches:#4d5056 boots", ""),
    ("monk|friar|abbot|wizard|sorcerer", "", "coat:#4a3626 tunic:#4a3626 trousers:same boots", ""),
    ("sheriff|marshal|deputy|cowboy|gunslinger|outlaw|rancher", "",
     "shirt:#c9bfa6 vest:#4d3524 scarf:#7d2f28 trousers:#3b516e belt boots:#3a2312 hat:#4a3626", ""),
    ("gambler|card player", "west", "shirt:#e9e6de vest:#5c1626 bow_tie jacket:#1c1c20 trousers:same boots", ""),
    ("nurse|matron", "", "shirt:#8fb0c4 trousers:same shoes:#e4e2dc", "dress:#8fa9bd apron:#ece9e2 shoes:#e4e2dc"),
    ("doctor|dr|surgeon|physician|scientist|pharmacist|chemist", "classic today",
     "shirt tie trousers coat:#ece9e2 shoes", "blouse skirt coat:#ece9e2 heels"),
    ("patient", "", "shirt:#b4c6d2 trousers:same shoes:#c9c5bd", ""),
    ("bartender|barman|barkeep|barkeeper|innkeeper", "", "shirt:#e9e6de vest:#22252b trousers:#22252b apron shoes", ""),
    ("waiter|steward|maitre d", "", "shirt:#e9e6de vest:#17171a bow_tie trousers:#17171a shoes", ""),
    ("waitress|barmaid|barista", "", "shirt apron trousers shoes", "blouse skirt:#2c2d33 apron:#ece9e2 shoes"),
    ("butler|footman|valet", "", "shirt:#e9e6de vest:#17171a bow_tie jacket:#17171a trousers:same shoes", ""),
    ("maid|housemaid|chambermaid", "", "", "dress:#17171a apron:#ece9e2 shoes"),
    ("priest|vicar|reverend|pastor|parson|chaplain|bishop|father [a-z]+", "",
     "shirt:#e9e6de coat:#17171a trousers:#17171a shoes", ""),
    ("nun|abbess|mother superior", "", "", "blouse:#17171a long_skirt:#17171a scarf:#ece9e2 beanie:#17171a shoes"),
    ("bride", "", "", "gown:#ece9e2 heels:#ece9e2"),
    ("groom|best man", "", "shirt:#e9e6de bow_tie jacket:#17171a trousers:same shoes", ""),
    ("policeman|policewoman|police officer|police|cop|constable|patrolman|guard|security guard|warder", "",
     "uniform:#1d2a47 trousers:same boots cap:#1d2a47", ""),
    ("soldier|private|corporal|sergeant|lieutenant|major|colonel|general|sentry|commander|officer",
     "victorian classic today", "tunic:#5a5d3c trousers:same boots cap:#4e5136", ""),
    ("pilot|conductor|porter|ticket collector|stationmaster|station master|chauffeur|doorman|stewardess|bellboy|usher"
     "|ship's captain|skipper|admiral", "", "uniform:#23293a trousers:same shoes cap:#23293a", ""),
    ("detective|inspector|private eye|investigator|reporter|journalist", "classic",
     "shirt tie trousers coat hat shoes", "blouse skirt coat hat heels"),
    ("judge|magistrate|justice", "classic today", "shirt:#e9e6de tie:#17171a coat:#17171a trousers:#17171a shoes",
     "blouse:#e9e6de coat:#17171a skirt:#17171a heels"),
    ("coach|trainer|gym teacher|referee", "today", "sweater:#24466b trousers:#24466b shoes:#e4e2dc", ""),
    ("footballer|goalkeeper|goalie|striker|midfielder|football player|soccer player", "",
     "tee:#8a1f18 shorts:#e4e2dc socks shoes", ""),
    ("astronaut|cosmonaut|spacewalker", "", "uniform:#dcdcd6 trousers:same boots:#dcdcd6", ""),
    ("flight attendant|air hostess|cabin crew", "", "shirt:#e9e6de tie jacket:#23293a trousers:same shoes",
     "blouse:#e9e6de scarf:#8a1f18 jacket:#23293a skirt:same heels"),
    ("chef|cook|baker", "", "shirt:#e9e6de apron:#ece9e2 trousers beanie:#ece9e2 shoes", ""),
    ("shopkeeper|grocer|butcher|barber|blacksmith|carpenter|potter|cobbler|cashier", "", "shirt apron trousers shoes",
     "blouse skirt apron shoes"),
    ("farmer|farmhand|gardener|miner|lumberjack", "", "shirt:#7a3b2e trousers:#3b516e boots straw_hat",
     "blouse long_skirt apron boots straw_hat"),
    ("fisherman|sailor|seaman|boatman|dock ?worker|docker", "", "sweater:#2f3a55 trousers boots beanie", ""),
    ("mechanic|plumber|electrician|janitor|worker|builder|engineer|driver|trucker", "classic today",
     "shirt:#4a6078 trousers:same boots flat_cap", ""),
    ("hiker|camper|climber|mountaineer|ranger|backpacker", "", "sweater trousers boots beanie", ""),
    ("lawyer|attorney|banker|businessman|businesswoman|boss|manager|director|executive|agent|senator|president"
     "|professor|lecturer|politician|salesman|host|pianist", "classic today",
     "shirt tie jacket trousers:same shoes", "blouse jacket skirt:same heels"),
    ("teacher|schoolteacher|headmaster|headmistress|secretary|librarian|receptionist|clerk", "",
     "shirt tie jacket trousers shoes", "blouse cardigan skirt heels"),
    ("pupil|schoolboy|schoolgirl", "", "shirt:#e9e6de sweater:#2f3a55 shorts:#5c5f66 socks shoes",
     "blouse:#e9e6de skirt:#2f3a55 socks shoes"),
    ("student", "today", "sweater trousers:#3b516e shoes", ""),
)  # fmt: skip
"""Words of a trade, the ages it holds in (all if empty), the outfit of men and of everybody who may be one, of women.

An outfit is garments with their colours; ``same`` is the colour of what covers the body above. An empty one of women is
that of men, an empty one of men dresses women only.
"""


def age_of(story: str, said: str = "") -> Age:
    """Return the age that the words of a story speak of most; today where none is sure.

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
    return best if weights[best] >= _SURE else "today"


def costume(role: str, name: str, age: Age, gender: str, years: float, seed: int) -> tuple[Garment, ...]:
    """Return what somebody wears by trade, else by the age; nothing where today's everyday clothes will do.

    Args:
        role: What the story says they are.
        name: How it calls them; a trade counts at its start: Sheriff Cole, but not Tom Baker.
        age: Of the story.
        gender: ``female``, ``male`` or ``unknown``, who wears what both may wear.
        years: How old; children have no trade but school and no costume but today's.
        seed: Picks among outfits.
    """
    for pattern, ages, men, women in _TRADES:
        outfit = (women or men) if gender == "female" else men
        grown = years >= _CHILD or "pupil" in pattern
        if outfit and grown and (not ages or age in ages.split()) and _is_called(pattern, role.lower(), name.lower()):
            return _sewn(outfit)
    if age == "today" or years < _CHILD:
        return ()
    choices = _EVERYDAY[age][2:] if gender == "female" else _EVERYDAY[age][:2]
    return _sewn(choices[seed % 2])


def _is_called(pattern: str, role: str, name: str) -> bool:
    titled = re.match(rf"(?:(?:the|old|young|first|second) )?(?:{pattern})\b", name)
    return bool(titled or re.search(rf"\b(?:{pattern})\b", role))


def _sewn(outfit: str) -> tuple[Garment, ...]:
    """Return the garments of an outfit in words."""
    worn, above = [], None
    for key, _, tint in (word.partition(":") for word in outfit.split()):
        color = above if tint == "same" else hex_color(tint) if tint else None
        if key in ("shirt", "jacket", "tunic", "uniform"):
            above = color
        worn.append(Garment(key=key, color=color))
    return tuple(worn)

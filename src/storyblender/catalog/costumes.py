"""Costumes: what people of an age and a trade wear, where the script dresses nobody.

To dress a trade, add a line to ``_TRADES``.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from storyblender.catalog.materials import hex_color
from storyblender.memory.asset_sheet import Garment
from storyblender.memory.vocabulary import Age

_CHILD = 13

_CREW: Final = (
    "uniform:#2f4a5e trousers:same boots", "uniform:#3a3f48 trousers:same boots",
    "uniform:#6a4a2a trousers:#3a3f48 boots", "uniform:#5a2f38 trousers:#3a3f48 boots",
)  # fmt: skip
_EVERYDAY: Final[dict[Age, tuple[tuple[str, ...], tuple[str, ...]]]] = {
    "today": (
        ("shirt:#8fa6bd trousers:#3a352c shoes", "sweater:#7a3b2e jeans shoes", "tee:#c9c5bd jeans shoes:#e4e2dc",
         "shirt:#e4e0d6 cardigan:#5c6b54 trousers:#2e2f36 shoes", "tee:#33353a denim_jacket jeans boots",
         "shirt:#b48a2c jacket:#3b4654 trousers:#4a4038 shoes", "sweater:#2f3a55 trousers:#8a7a5c shoes",
         "shirt:#6b2f2f vest:#33353a trousers:#2b2f36 shoes", "hoodie:#5f6238 jeans shoes"),
        ("blouse:#ece9e2 jeans:#3b516e shoes", "dress:#8a2f2f shoes", "sweater:#c9a23c skirt:#33353a boots",
         "blouse:#8fb0c4 cardigan:#4a3a55 trousers:#2e2f36 shoes", "sundress:#7fa08a shoes", "tee:#b5656f jeans shoes",
         "blouse:#d9cbb0 jacket:#3b4654 trousers:same shoes", "sweater:#5d7a8a jeans boots",
         "blouse:#6d4a7a skirt:#3a352c shoes"),
    ),
    "medieval": (
        ("tunic:#5b4632 breeches:#3a342c boots", "tunic:#43503b breeches:#4a4038 boots",
         "tunic:#6b3a2a breeches:#2f2a24 boots", "tunic:#3c4a5c breeches:#4a4038 boots"),
        ("gown:#4a3a2c shoes", "gown:#3f5d46 shoes", "gown:#6a3640 shoes", "gown:#3c4a66 apron:#cbbf9f shoes"),
    ),
    "west": (
        ("shirt vest:#4d4136 trousers:#3d3a36 boots:#3a2312", "shirt:#8a7a5c vest trousers:#4a4038 boots",
         "shirt:#7a3b2e braces trousers:#33312d boots", "shirt:#5d6f7f vest:#2f2b26 jeans boots"),
        ("blouse long_skirt boots", "blouse long_skirt:#5b4632 scarf boots", "blouse:#8a6a55 long_skirt:#3a3f4a boots",
         "blouse:#c9bfa6 long_skirt:#5a2f33 boots"),
    ),
    "victorian": (
        ("shirt vest bow_tie jacket:#2f2f33 trousers:same shoes",
         "shirt vest:#4d4136 tie jacket:#4b4136 trousers shoes",
         "shirt vest:#5c4a2a bow_tie tailcoat:#26303c trousers:#4a4743 shoes",
         "shirt vest:#6a6256 tie coat:#3b342d trousers:#2b2825 boots"),
        ("blouse long_skirt boots", "blouse:#5d4a55 long_skirt boots", "blouse:#d9cfbb long_skirt:#4a2f3a boots",
         "blouse:#3f5a58 long_skirt:#2c3b3a boots"),
    ),
    "classic": (
        ("shirt tie jacket trousers:same shoes", "shirt tie vest trousers shoes",
         "shirt tie jacket:#6b5a44 trousers:#4a4038 shoes", "shirt:#d8cfbc braces trousers:#3d4038 shoes"),
        ("dress heels", "blouse skirt heels", "dress:#3c4f66 heels", "blouse:#c7a98a jacket:#5c3f36 skirt:same heels"),
    ),
    "space": (_CREW, _CREW),
}  # fmt: skip
"""Age -> outfits of men, then of women."""
_CHILDRENS: Final = (
    ("tee:#c8642a shorts:#33466b socks shoes", "sweater:#3f6b48 trousers:#4a4038 shoes",
     "shirt:#8fa6bd shorts:#5c5f66 socks shoes", "tee:#d4ac38 jeans shoes"),
    ("dress:#b5656f socks shoes", "sweater:#d4ac38 skirt:#33466b socks shoes", "dress:#2b6a70 socks shoes",
     "tee:#c9c5bd dungarees:#3b516e shoes"),
)  # fmt: skip
"""Today's outfits of boys, then of girls."""

_TRADES: Final[tuple[tuple[str, str, str, str], ...]] = (
    ("king|emperor", "", "tunic:#6d1426 cloak:#4a1020 breeches:#2c2d33 boots crown", ""),
    ("princess", "", "", "ball_gown heels crown"),
    ("queen|empress", "", "", "ball_gown:#5a1f3d cloak:#4a1020 heels crown"),
    ("prince|duke|count|baron", "medieval victorian", "tunic:#27344c cloak:#3a1f24 breeches:#2c2d33 boots", ""),
    ("duchess|countess|baroness", "", "", "gown:#5a1f3d necklace heels"),
    ("lady", "medieval", "", "gown:#1f4d3a heels"),
    ("knight", "", "armour helmet:#9aa0a6 boots:#6f757b", ""),
    ("guard|soldier|captain|sentry|man-at-arms", "medieval", "chainmail breeches:#4d5056 boots helmet:#85898f", ""),
    ("wizard|sorcerer|warlock|mage", "", "habit:#31406b witch_hat:#31406b boots",
     "habit:#31406b witch_hat:#31406b boots"),
    ("witch|sorceress", "", "habit:#1b1b22 witch_hat boots", "gown:#1b1b22 witch_hat boots"),
    ("monk|friar|abbot|hermit|druid", "", "habit:#4a3626 shoes", ""),
    ("sheriff|marshal|deputy", "",
     "shirt:#c9bfa6 vest:#4d3524 trousers:#3b516e belt boots:#3a2312 cowboy_hat badge", ""),
    ("cowboy|cowgirl|gunslinger|outlaw|rancher|ranch hand", "",
     "shirt:#c9bfa6 vest:#4d3524 scarf:#7d2f28 jeans belt boots:#3a2312 cowboy_hat", ""),
    ("angel|fairy", "", "toga:#ece9e2 wings shoes:#d3bd86", "sundress:#ece9e2 wings shoes:#d3bd86"),
    ("superhero|super hero|caped crusader", "", "wetsuit:#27406b cloak:#a3242a boots:#a3242a", ""),
    ("gambler|card player", "west", "shirt:#e9e6de vest:#5c1626 bow_tie jacket:#1c1c20 trousers:same boots", ""),
    ("surgeon", "", "scrubs:#5b8f8c face_mask skullcap:#5b8f8c shoes", ""),
    ("nurse|matron|orderly", "today space", "scrubs shoes:#e4e2dc", ""),
    ("nurse|matron", "", "shirt:#8fb0c4 trousers:same shoes:#e4e2dc",
     "dress:#8fa9bd apron:#ece9e2 sailor_cap:#ece9e2 shoes:#e4e2dc"),
    ("doctor|dr|physician|medic", "classic today",
     "shirt tie trousers lab_coat stethoscope shoes", "blouse trousers lab_coat stethoscope shoes"),
    ("scientist|pharmacist|chemist|lab technician|pathologist|dentist|vet|optician", "classic today space",
     "shirt tie trousers lab_coat shoes", "blouse skirt lab_coat shoes"),
    ("paramedic|ambulance driver", "", "overalls:#2f4a3d high_vis boots", ""),
    ("patient", "", "pyjamas:#b4c6d2 shoes:#c9c5bd", "nightgown:#b4c6d2 shoes:#c9c5bd"),
    ("bartender|barman|barkeep|barkeeper|innkeeper", "", "shirt:#e9e6de vest:#22252b trousers:#22252b apron shoes",
        ""),
    ("waiter|steward|maitre d", "", "shirt:#e9e6de vest:#17171a bow_tie trousers:#17171a shoes", ""),
    ("waitress|barmaid|barista", "", "shirt apron trousers shoes", "blouse skirt:#2c2d33 apron:#ece9e2 shoes"),
    ("butler|footman|valet", "", "shirt:#e9e6de vest:#17171a bow_tie jacket:#17171a trousers:same shoes", ""),
    ("maid|housemaid|chambermaid", "", "", "dress:#17171a apron:#ece9e2 shoes"),
    ("bishop|cardinal|pope", "", "cassock:#6d1426 mitre shoes", ""),
    ("priest|vicar|reverend|pastor|parson|chaplain|father [a-z]+|imam|rabbi|altar boy|choirboy", "",
     "cassock shoes", ""),
    ("nun|abbess|mother superior", "", "", "habit:#1b1b1e nun_veil shoes"),
    ("bride", "", "", "wedding_dress heels:#ece9e2"),
    ("ballerina|ballet dancer", "", "tank_top leggings shoes", "tutu shoes:#e0b9c4"),
    ("groom|best man", "", "shirt:#e9e6de bow_tie jacket:#17171a trousers:same shoes", ""),
    ("policeman|policewoman|police officer|police|cop|constable|patrolman|guard|security guard|warder", "",
     "uniform:#1d2a47 trousers:same boots cap:#1d2a47", ""),
    ("soldier|private|corporal|sergeant|lieutenant|major|colonel|general|sentry|commander|officer",
     "victorian classic today", "tunic:#5a5d3c trousers:same boots helmet:#4e5136", ""),
    ("pilot|conductor|porter|ticket collector|stationmaster|station master|chauffeur|doorman|stewardess|bellboy|usher"
     "|ship's captain|skipper|admiral", "", "uniform:#23293a trousers:same shoes cap:#23293a", ""),
    ("detective|inspector|private eye|investigator|reporter|journalist", "classic",
     "shirt tie trousers coat hat shoes", "blouse skirt coat hat heels"),
    ("judge|magistrate|justice", "classic today", "cassock shoes", "cassock heels"),
    ("coach|trainer|gym teacher|referee", "today", "sweater:#24466b trousers:#24466b shoes:#e4e2dc", ""),
    ("footballer|goalkeeper|goalie|striker|midfielder|football player|soccer player", "",
     "tee:#8a1f18 shorts:#e4e2dc socks shoes", ""),
    ("astronaut|cosmonaut|spacewalker", "", "space_suit", ""),
    ("flight attendant|air hostess|cabin crew", "", "shirt:#e9e6de tie jacket:#23293a trousers:same shoes",
     "blouse:#e9e6de scarf:#8a1f18 jacket:#23293a skirt:same heels"),
    ("chef|sous[- ]chef|pastry chef", "", "chef_jacket apron:#ece9e2 trousers chef_hat shoes", ""),
    ("cook|baker", "", "tee:#e9e6de apron:#ece9e2 trousers chef_hat shoes", ""),
    ("shopkeeper|grocer|butcher|barber|blacksmith|carpenter|potter|cobbler|cashier", "", "shirt apron trousers shoes",
     "blouse skirt apron shoes"),
    ("firefighter|fireman|fire chief", "", "firefighter_coat trousers:#2a2a22 fire_helmet boots", ""),
    ("miner", "", "shirt:#6a665c overalls hard_hat boots", ""),
    ("lumberjack|woodcutter|woodsman", "", "shirt:#7a2f2b braces jeans boots beanie", ""),
    ("farmer|farmhand|gardener", "", "shirt:#7a3b2e dungarees boots straw_hat",
     "blouse long_skirt apron boots straw_hat"),
    ("fisherman|trawlerman", "", "sweater:#2f3a55 raincoat trousers boots beanie", ""),
    ("sailor|seaman|boatman|dock ?worker|docker|deckhand", "", "sweater:#2f3a55 trousers boots beanie", ""),
    ("diver|frogman", "", "wetsuit air_tank boots:#17181b", ""),
    ("lifeguard|swimmer|surfer", "", "swim_trunks:#a3242a", "swimsuit:#a3242a"),
    ("boxer|prizefighter|wrestler", "", "swim_trunks:#a3242a boots", "tank_top shorts boots"),
    ("builder|construction worker|foreman|surveyor|road ?worker|site manager", "today",
     "shirt high_vis jeans boots hard_hat", ""),
    ("mechanic|plumber|janitor|garage hand|factory worker|repairman|caretaker", "", "overalls boots", ""),
    ("prisoner|inmate|convict", "", "overalls:#c4661e shoes", ""),
    ("painter|artist|sculptor", "", "shirt:#c9c5bd apron:#8a8578 trousers beret shoes", ""),
    ("postman|postwoman|mail ?man|mail carrier|courier|paper ?boy", "",
     "shirt:#8fa6bd trousers:#27344c cap:#27344c satchel shoes", ""),
    ("delivery (?:man|guy|driver|boy|girl|woman)", "", "tee:#a3242a jeans baseball_cap:#a3242a shoes", ""),
    ("biker", "", "tee leather_jacket jeans boots", ""),
    ("rapper|skater|skateboarder|hacker|graffiti artist|teen(?:ager)?|youth", "today", "hoodie jeans shoes", ""),
    ("jogger|runner|athlete", "today", "tracksuit shoes:#e4e2dc", ""),
    ("cyclist", "today", "tee leggings shoes helmet:#e4e2dc", ""),
    ("robber|burglar|bank robber", "", "sweater:#17171a trousers:#17171a balaclava shoes", ""),
    ("worker|electrician|engineer|driver|trucker|cab driver|taxi driver", "classic today",
     "shirt:#4a6078 jeans boots flat_cap", ""),
    ("hiker|camper|backpacker|trekker|explorer", "", "parka trousers boots beanie backpack", ""),
    ("climber|mountaineer|skier", "", "parka trousers boots beanie", ""),
    ("ranger|park ranger|scout", "", "shirt:#8a7a52 shorts:#5e6238 socks boots cowboy_hat:#6b5a3a", ""),
    ("lawyer|attorney|banker|businessman|businesswoman|boss|manager|director|executive|agent|senator|president"
     "|professor|lecturer|politician|salesman|host|pianist", "classic today",
     "shirt tie jacket trousers:same shoes", "blouse jacket skirt:same heels"),
    ("teacher|schoolteacher|headmaster|headmistress|secretary|librarian|receptionist|clerk", "",
     "shirt tie jacket trousers shoes", "blouse cardigan skirt heels"),
    ("pupil|schoolboy|schoolgirl", "", "shirt:#e9e6de sweater:#2f3a55 shorts:#5c5f66 socks shoes backpack",
     "blouse:#e9e6de skirt:#2f3a55 socks shoes backpack"),
    ("student", "today", "hoodie jeans shoes", "sweater jeans shoes"),
)  # fmt: skip
"""Words of a trade, the ages it holds in (all if empty), the outfit of men and of everybody who may be one, of women.

An outfit is garments with their colours; ``same`` is the colour of what covers the body above. An empty one of women is
that of men, an empty one of men dresses women only.
"""


def costume(
    role: str,
    name: str,
    age: Age,
    gender: str,
    years: float,
    seed: int,
    worn_by_others: Sequence[tuple[Garment, ...]] = (),
) -> tuple[Garment, ...]:
    """Return the outfit of a person by trade, else by the age of the story.

    Args:
        role: What the story says they are.
        name: How it calls them; a trade counts at its start: Sheriff Cole, but not Tom Baker.
        age: Of the story.
        gender: ``female``, ``male`` or ``unknown``, who wears what both may wear.
        years: How old; children have no trade but school and no clothes but today's.
        seed: Picks among outfits.
        worn_by_others: Outfits of the story's other people: two of them are told apart by their everyday clothes.
    """
    for pattern, ages, men, women in _TRADES:
        outfit = (women or men) if gender == "female" else men
        grown = years >= _CHILD or "pupil" in pattern
        if outfit and grown and (not ages or age in ages.split()) and _is_called(pattern, role.lower(), name.lower()):
            return _sewn(outfit)
    choices = (_CHILDRENS if years < _CHILD else _EVERYDAY[age])[gender == "female"]
    first = seed % len(choices)
    outfits = [_sewn(outfit) for outfit in (*choices[first:], *choices[:first])]
    return min(outfits, key=lambda outfit: sum(other == outfit for other in worn_by_others))


def _is_called(pattern: str, role: str, name: str) -> bool:
    """Return whether an occupation, or a name such as ``OLD KING``, matches a pattern of words."""
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

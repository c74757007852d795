"""Casting: how a person looks, from the words of the script. What is not said stays open or gets a plain default."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Final, Literal, TypeVar

from storyblender.agents.director.palette import cloth_color, hair_color
from storyblender.agents.director.reading import Person
from storyblender.catalog.costumes import costume
from storyblender.catalog.garments import GARMENTS
from storyblender.catalog.garments_of_trades import TRADE_GARMENTS
from storyblender.catalog.homelands import Homeland
from storyblender.catalog.species import SPECIES, Species, being_of, species_of
from storyblender.catalog.worn import WORN
from storyblender.memory.asset_sheet import CharacterLook, Garment
from storyblender.memory.base import Color, content_hash
from storyblender.memory.vocabulary import Age

Build = Literal["slim", "average", "athletic", "stocky", "heavy"]
Skin = Literal["pale", "light", "tan", "brown", "dark"]
_Key = TypeVar("_Key", bound=str)
FacialHair = Literal["none", "stubble", "moustache", "beard"]

_INTRODUCTION: Final = re.compile(
    r"[^\W\d_][\w.'’#-]*(?:\s[A-ZÀ-Ý\d#][\w.'’#-]*){0,3}?"
    r"(?:\s*\((?P<brackets>[^)]{3,200})\)|,\s+(?P<apposition>(?:an?|the|in|wearing)\s[^.;:!?]{3,120})"
    r"|\s+(?:dressed in|wearing|in)\s(?P<worn>[^.,;:!?]{3,60}))"
)
_EVERYDAY_GARMENTS: Final = {
    "dinner_jacket trousers:black shirt:white bow_tie:black": "dinner jacket|tuxedo|white tie|black tie",
    "jacket trousers:same shirt": "suit|pinstripes|three-piece suit",
    "uniform trousers:same cap:same boots:black": "uniform",
    "coat": "overcoat|trench ?coat|greatcoat|duster|coat",
    "cardigan": "cardigan",
    "scarf": "scarf|scarves|shawl|muffler|neckerchief",
    "jacket": "blazer|tweeds|sports coat|jacket",
    "sweater": "sweater|jumper|pullover|turtleneck|polo ?neck",
    "tee": "t-shirts?|tee|jersey|polo",
    "blouse": "blouse",
    "shirt": "dress shirt|shirt sleeves|shirtsleeves|work shirt|shirt",
    "tunic": "tunic|kurta|jerkin",
    "gown": "(?:evening|long|floor-length) (?:gown|dress(?:es)?)|gown|cheongsam",
    "tee shorts:same socks shoes": "(?:football |soccer |sports |rugby )?(?:kits?|strip)|football shirt",
    "dress": "frock|dress(?:es)?",
    "long_skirt": "(?:long|maxi|ankle-length|floor-length) skirt",
    "skirt": "skirt",
    "breeches": "(?:riding )?breeches|jodhpurs",
    "trousers": "trousers|slacks|pants|corduroys|chinos",
    "shorts": "shorts",
    "tie": "necktie|tie",
    "bow_tie": "bow tie|bow-tie|bowtie",
    "belt": "belt|sash",
    "vest": "waistcoat|vest",
    "apron": "apron|pinafore",
    "straw_hat": "straw hat|sun hat|panama(?: hat)?|boater|bonnet",
    "hat": "fedora|trilby|homburg|hat",
    "flat_cap": "flat cap|newsboy cap|cloth cap",
    "beanie": "beanie|watch cap|(?:woolly|wool|woollen|knitted) (?:hat|cap)",
    "cap": "peaked cap|kepi|cap",
    "boots": "wellingtons|wellies|riding boots|boots",
    "heels": "(?:high )?heels|stilettos|court shoes|pumps",
    "shoes": "sneakers|trainers|sandals|slippers|loafers|clogs|shoes",
    "socks": "stockings|tights|socks",
}  # fmt: skip
"""Garments (``key:colour``, ``same`` for the colour named) and the words for them."""
_GARMENTS: Final = _EVERYDAY_GARMENTS | {
    spec.key: "|".join(re.escape(word).replace(r"\ ", "[ -]") for word in (spec.name, *spec.tags))
    for spec in (*TRADE_GARMENTS, *WORN)
}
"""Costumes by their own names as well."""
_FEET: Final = {"heels", "shoes", "boots", "socks"}
_HAIR: Final = {
    "shaved": "shaved head|shaven|hairless|clean-shaven head|completely bald",
    "receding": "receding|thinning|high forehead|balding",
    "bald": "bald",
    "crop": "crop|cropped|crew cut|crew-cut|buzz ?cut|close-cut|shorn",
    "dreadlocks": "dreadlocks|dreads|locs",
    "spiky": "spiky|spiked|mohawk|mohican|punk",
    "cornrows": "cornrows|box braids",
    "undercut": "undercut|quiff|pompadour|flat ?top",
    "bowl_cut": "bowl cut|pudding basin|mop-top|moptop",
    "braid": "pigtails?|bunches|braids?|braided|plaits?|plaited",
    "ponytail": "ponytail|pony-tail",
    "pixie": "pixie(?: cut)?|gamine|boyish cut|elfin",
    "bun": "bun|chignon|updo|pinned up|pinned-up|knot|tied back",
    "bob": "bob|bobbed|chin-length|flapper",
    "afro": "afro",
    "curly": "curly|curls|frizzy|ringlets",
    "wavy": "wavy|waves|shoulder-length",
    "slick": "slick|slicked|slicked-back|pomaded|combed back|greased",
    "messy": "messy|tousled|untidy|unkempt|wild|tangled|dishevell?ed|ruffled|windblown|shaggy",
    "long": "long|flowing|waist-length",
    "short": "short|neat|combed|side-parted|trim",
}
_BUILD: Final[dict[Build, str]] = {
    "heavy": "heavy|heavyset|heavy-set|fat|plump|stout|large|overweight|obese|portly|rotund|round|big-bellied",
    "stocky": "stocky|broad|broad-shouldered|burly|squat|thickset|sturdy|barrel-chested",
    "athletic": "athletic|muscular|fit|strong|powerful|toned|wiry|sinewy",
    "slim": "slim|lean|thin|slender|skinny|lanky|gaunt|bony|petite|slight|willowy|frail",
}
_SKIN: Final[dict[Skin, str]] = {
    "dark": r"dark[- ]skin(?:ned)?|black[- ]skin(?:ned)?|ebony",
    "brown": r"brown[- ]skin(?:ned)?",
    "tan": r"tann?ed|tan skin|olive[- ]skin(?:ned)?|sunburn(?:ed|t)|weather-?beaten|weathered|bronzed",
    "pale": r"pale|ashen|pallid|pasty",
}
_FACIAL_HAIR: Final[dict[FacialHair, str]] = {
    "beard": "beard|bearded|goatee",
    "moustache": "moustache|mustache|moustached",
    "stubble": "stubble|unshaven|stubbled",
}
_AGES: Final = {
    "baby": 1, "infant": 1, "toddler": 3, "child": 9, "kid": 10, "little": 8, "boy": 10, "girl": 10, "adolescent": 15,
    "teen": 16, "teenage": 16, "teenager": 16, "young": 25, "youthful": 25, "student": 20, "adult": 35,
    "middle-aged": 50, "middle": 50, "older": 62, "aging": 62, "ageing": 62, "elderly": 74, "old": 72, "aged": 72,
    "grandmother": 70,
    "grandfather": 72, "grandma": 70, "grandpa": 72, "ancient": 84, "wizened": 80,
}  # fmt: skip
_SIZE_WORDS: Final = {
    "giant": 0.28, "enormous": 0.26, "huge": 0.24, "towering": 0.22, "very tall": 0.17, "tall": 0.11, "lanky": 0.08,
    "tiny": -0.16, "diminutive": -0.14, "very short": -0.13, "petite": -0.1, "short": -0.09, "small": -0.09,
}  # fmt: skip
"""Words of size -> metres that they add to an average adult."""
_DEFAULT_HAIR: Final = {
    "female": ("long", "bob", "bun", "ponytail"),
    "male": ("short", "crop", "messy"),
    "unknown": ("short",),
}
_FOREIGNER_WORDS: Final = (
    "foreigner|tourist|expatriate|expat|colonial|missionary|american|english(?:man|woman)?|british|brit|european|french"
    "|german|dutch|italian|russian|australian|swede|swedish|irish|scottish|white (?:man|woman)"
)
"""Words that say a person is not from where the story is set."""
_UNKNOWN_SPECIES: Final = "otter"
"""Species used for an animal of unknown kind."""
_GREYING_AGE: Final = 50.0
"""Years from which hair keeps the colour of its age."""


def age_word(person: Person, text: str) -> str:
    """Return the word of age before the first mention of a name (``Baby TOM``, ``little Ann``), or an empty string.

    Args:
        person: ``first`` is the offset of the first mention.
        text: The script.
    """
    before = re.search(r"([^\W\d_]+)\s+$", text[max(0, person.first - 20) : person.first])
    return before[1].lower() if before and before[1].lower() in _AGES else ""


def introduction_words(person: Person, text: str) -> str:
    """Return the words that introduce a person: in brackets after the name, in apposition, or after ``in``.

    Args:
        person: ``first`` is the offset of the first mention in ``text``.
        text: The script.
    """
    match = _INTRODUCTION.match(text, person.first)
    return " ".join((match["brackets"] or match["apposition"] or match["worn"]).split()) if match else ""


def cast_look(
    person: Person,
    introduced: str = "",
    era: Age = "today",
    homeland: Homeland | None = None,
    worn_by_others: Sequence[tuple[Garment, ...]] = (),
) -> CharacterLook:
    """Return the look of a person from the words of the script.

    What the words leave open is drawn from the person's id, so that the same person always looks the same.

    Args:
        person: The person as read.
        introduced: The words of the introduction, for what the reader did not sort (skin, glasses, a beard).
        era: Age of the story; with the person's role, it dresses whom the script does not.
        homeland: What is usual where the story is set, except for a foreigner.
        worn_by_others: Outfits of the people cast before.
    """
    if re.search(rf"\b(?:{_FOREIGNER_WORDS})\b", f"{person.role} {person.name} {introduced}".lower()):
        homeland = None
    seed = int(content_hash(person.id)[:8], 16)
    age = age_in_years(person, seed)
    hair = ", ".join(person.hair) or _hair_words(introduced)
    everything = ", ".join((*person.build, *person.hair, *person.face, *person.outfit, introduced))
    worn = garments_in(", ".join(person.outfit) or introduced)
    named = f"{person.role} {person.name} {' '.join((*person.build, *person.outfit))}"
    beast = (animal_species(person) or SPECIES[_UNKNOWN_SPECIES]) if person.kind == "animal" else being_of(named)
    if beast is None:
        worn = worn or costume(person.role, person.name, era, person.gender, age, seed, worn_by_others)
        worn = _with_heels(_with_swimsuit(worn, person.gender), person.gender, age)
    return CharacterLook(
        gender=person.gender,
        age=age,
        stature=_height(person, age) if beast is None else _animal_height(person, beast, age),
        species=beast.words[0] if beast else "",
        build=_first_match(_BUILD, ", ".join(person.build) or introduced) or "average",
        skin=_first_match(_SKIN, everything) or (homeland.skin if homeland else "light"),
        hair=_hair_style(person, hair, age, seed, homeland),
        hair_color=cloth_color(" ".join((*person.build, *person.hair)))
        if beast
        else hair_color(_without_facial_hair(hair))
        or (hair_color("black") if homeland and age < _GREYING_AGE else None),
        facial_hair=_first_match(_FACIAL_HAIR, everything) or "none",
        garments=worn,
        glasses=bool(re.search(r"(?<!sun)(?:glasses|spectacles|monocle)", everything)),
    )


def animal_species(person: Person) -> Species | None:
    """Return the species of an animal by its role, its name or its description."""
    looks = " ".join((*person.build, *person.outfit, *person.hair, *person.face))
    return species_of(person.role) or species_of(person.name) or species_of(looks)


def age_in_years(person: Person, seed: int = 0) -> float:
    """Return the age of a person in years: ``late 30s`` is 38, ``old`` is 72; if not said, 30 to 44 by ``seed``."""
    words = person.age.lower()
    if number := re.search(r"\d{1,3}", words):
        part = 2 if "early" in words else 5 if "mid" in words else 8 if "late" in words else 5 if "s" in words else 0
        return float(min(110, int(number[0]) + part))
    decade = re.search(r"\b(twen|thir|for|fif|six|seven|eigh)ties\b", words)
    if decade:
        decades = ["twen", "thir", "for", "fif", "six", "seven", "eigh"]
        return 25.0 + 10 * decades.index(decade[1])
    named = [
        word
        for word in re.findall(r"[a-z-]+", f"{words} {person.role} {' '.join(person.build)}".lower())
        if word in _AGES
    ]
    return float(_AGES[named[0]]) if named else 30.0 + seed % 15


def garments_in(words: str) -> tuple[Garment, ...]:
    """Return the garments that a description names, innermost first; the last one named wins a place on the body.

    A colour holds for the next garment named: ``white dinner jacket, black bow tie``. A garment named again without a
    colour, ``cream suit, jacket``, is the same one.
    """
    chosen: dict[str, Garment] = {}
    implied: dict[str, Garment] = {}
    for keys, color in _named_garments(words.lower()):
        first, *others = keys.split()
        key, _, own = first.partition(":")
        if key not in chosen or color or own:
            chosen[key] = Garment(key=key, color=color or cloth_color(own))
        for key, _, own in (other.partition(":") for other in others):
            implied[key] = Garment(key=key, color=color if own == "same" else cloth_color(own))
    return tuple(sorted((implied | chosen).values(), key=lambda garment: GARMENTS[garment.key].layer))


def _with_heels(worn: tuple[Garment, ...], gender: str, age: float) -> tuple[Garment, ...]:
    """Return an outfit with heels added for a woman in a dress whose shoes the script does not name."""
    keys = {garment.key for garment in worn}
    if gender != "female" or not 16 <= age < 65 or not keys & {"gown", "dress"} or keys & _FEET:
        return worn
    return (*worn, Garment(key="heels"))


def _with_swimsuit(worn: tuple[Garment, ...], gender: str) -> tuple[Garment, ...]:
    """Return an outfit with a swimsuit for a woman whose ``swimming costume`` was taken for trunks."""
    if gender != "female":
        return worn
    return tuple(
        garment.model_copy(update={"key": "swimsuit"}) if garment.key == "swim_trunks" else garment for garment in worn
    )


def _named_garments(words: str) -> list[tuple[str, Color | None]]:
    """Return the garment keys and colour of each garment word; the longest word wins."""
    named = [
        (match, keys) for keys, pattern in _GARMENTS.items() for match in re.finditer(rf"\b(?:{pattern})s?\b", words)
    ]
    named.sort(key=lambda pair: (pair[0].start(), -len(pair[0][0])))
    found: list[tuple[str, Color | None]] = []
    end = 0
    for match, keys in named:
        if match.start() < end:
            continue
        before = re.split(r",|;| and | with | over | under ", words[end : match.start()])[-1]
        found.append((keys, cloth_color(f"{before} {match[0]}")))
        end = match.end()
    return found


def describe_person(person: Person) -> str:
    """Return one sentence about a person, e.g. ``A lean woman, 35, short black hair, in a grey trench coat.``"""
    noun = person.role or {"female": "woman", "male": "man"}.get(person.gender, "person")
    if age_in_years(person) < 14:
        noun = {"female": "girl", "male": "boy"}.get(person.gender, "child")
    build = [re.sub(r"\s*\b(?:man|woman|boy|girl|person|child)$", "", words) for words in person.build]
    adjectives = [word for word in build if word and " " not in word]
    article = "An" if (adjectives or [noun])[0][:1].lower() in "aeiou" else "A"
    parts = [f"{article} {', '.join(adjectives)} {noun}".replace("  ", " ")]
    parts += [person.age] if person.age else []
    parts += [*(words for words in build if " " in words), *person.hair, *person.face]
    worn = [re.sub(r"^(?:.*\b(?:in|wearing)\s+)?(?:an?\s+)?", "", piece) for piece in person.outfit]
    parts += [f"in {', '.join(worn)}"] if worn else []
    return ", ".join(parts) + "."


def _first_match(table: Mapping[_Key, str], words: str) -> _Key | None:
    """Return the first key whose pattern occurs in the words, or None."""
    return next((key for key, pattern in table.items() if re.search(rf"\b(?:{pattern})\b", words.lower())), None)


def _hair_style(person: Person, hair: str, age: float, seed: int, homeland: Homeland | None) -> str:
    """Return the hair style told, else one usual for gender, age and homeland."""
    words = _without_facial_hair(", ".join((hair, *(face for face in person.face if "bald" in face))))
    style = _first_match(_HAIR, words)
    if style:
        return style
    if age >= 65 and person.gender == "female":
        return "bun"
    choices = _DEFAULT_HAIR[person.gender]
    if homeland is not None and person.gender != "unknown":
        choices = homeland.women if person.gender == "female" else homeland.men
    return choices[seed % len(choices)]


def _hair_words(introduced: str) -> str:
    """Return the parts of an introduction about hair."""
    parts = re.split(r",|;|\band\b|\bwith\b", introduced)
    return ", ".join(
        part for part in parts if re.search(r"hair|braid|bun\b|bob\b|ponytail|curls|bald|blond|brunette", part)
    )


def _without_facial_hair(words: str) -> str:
    """Return words about hair without beard and moustache, whose colour is not the head's."""
    return ", ".join(part for part in words.split(",") if not re.search(r"beard|moustache|mustache|stubble", part))


def _animal_height(person: Person, beast: Species, age: float) -> float:
    """Return the height in metres of an animal on two legs, by species, age and words of size."""
    words = " ".join((*person.build, *person.face)).lower()
    told = next((offset for word, offset in _SIZE_WORDS.items() if re.search(rf"\b{word}\b", words)), 0.0)
    grown = 0.62 if age < 10 else 0.8 if age < 15 else 1.0
    return round(min(2.3, max(0.45, beast.height * grown * (1 + 1.4 * told))), 2)


def _height(person: Person, age: float) -> float | None:
    """Return the height in metres that words of size tell of an adult, or None."""
    words = ", ".join((*person.build, *person.face)).lower()
    if age < 16:
        return None
    base = {"female": 1.65, "male": 1.78}.get(person.gender, 1.72)
    for word, offset in _SIZE_WORDS.items():
        if re.search(rf"\b{word}\b(?! hair)", words):
            return round(base + offset, 2)
    return None

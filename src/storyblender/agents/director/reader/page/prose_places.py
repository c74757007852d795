"""The places that sentences of a prose story name, and how the story gets there."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import form_kind
from storyblender.memory.vocabulary import SceneType

_DETERMINED = r"(?:the|a|an|his|her|their|my|our)\s+"
_WORDS = r"((?:[a-z'’-]+\s+){0,3}[a-z'’-]+)"
_PREPOSITIONS = (
    "in|at|into|to|inside|reached|entered|through|on|near|outside|of|across|aboard|along|over|up|down|by|behind|above"
    "|upon|beside|round|toward|towards|under|onto"
)
_PLACE_PHRASE = re.compile(rf"(?=\b(?:{_PREPOSITIONS})\s+{_DETERMINED}{_WORDS})")
_NAMED = re.compile(rf"\b(?:{_PREPOSITIONS})\s+(?:the\s+)?((?:[A-Z][\w'’-]+\s+){{1,2}})([A-Z][\w'’-]+)")
"""``down to Gannet Cove``."""
_NUMBERED = re.compile(
    r"\b((?:room|cabin|cell|ward|suite|flat|apartment|compartment|berth|bay|platform|hangar|studio|laboratory|lab)"
    rf" (?:number )?(?:\d+|{'|'.join(sorted(set(lexicon.NUMBERS) - {'a', 'an'}))}))\b"
)
"""``the door of Room Nine``."""
_NOUN_PHRASE = re.compile(rf"(?=\b{_DETERMINED}{_WORDS})")
_HOME = re.compile(r"\b(?:came|went|returned|was|got|comes|goes|returns|gets) home\b")
_PARTICLES = r"(?: (?:back|down|up|on|out|off|over|across|through|along|away|straight|upstairs|downstairs|inside))*"
_GOING = re.compile(
    r"\b(?:went|goes|go|walks|walked|walking|climbs|climbed|runs|ran|hurries|hurried|creeps|crept|slips|slipped|hastened"
    r"|drives|drove|rides|rode|follow\w* \w+|accompan\w+ \w+(?: \w+)?|led \w+|leads \w+|brought \w+|brings \w+|took \w+"
    rf"|takes \w+){_PARTICLES} (?:to|into|onto|towards?|in at the door and towards?|on an?(?: \w+)? \w+ \w+)"
    rf" {_DETERMINED}{_WORDS}"
)
"""``goes through to the kitchen``, ``brought them out on a ledge above the cave``."""
_THERE_AND_BACK = re.compile(r"\b(?:came|comes|come|ran|and|was|were|is) (?:straight )?back\b|\breturn(?:s|ed)\b")
_BEING = re.compile(
    r"[^,;:]{2,50}?(?:, [^,;:]{2,50},)? (?:is|was|are|were|stood|sat|stands|sits|waits|waited|lay|lies|knelt|kneels)"
    r"(?: (?:still|already|now|alone|up|down|asleep|awake|busy|\w+ing)){0,2}"
    rf" (?:in|at|aboard|inside|outside|on|against) {_DETERMINED}{_WORDS}"
)
"""``Mrs. Lunt is still in the kitchen``: so are we."""
_SUBJECT = re.compile(rf"(?:the|his|her|their|my|our)\s+{_WORDS}")
_OPENING = re.compile(rf"(?:the|his|her|their|my|our|(?:(?:mrs?|ms|dr)\. )?[^,.;]{{2,40}}['’]s)\s+{_WORDS}")
"""``Mrs. Crabbe's parlour was too small``, ``The bakery opened at four``: the subject a story begins with."""
_TELLING = re.compile(
    r"\s(?:of (?:the |an? )?[a-z'’-]+ )?(?:was|were|is|are|lay|lies|smelled|smells|smelt|stank|stinks|looked|looks"
    r"|stood|stands|had|has|held|holds|seemed|seems|hummed|hums|brought|brings|led|leads|echoed|echoes)\b"
)
_SMALL = lexicon.PREPOSITIONS | lexicon.DETERMINERS | lexicon.CONJUNCTIONS
_PLAIN = lexicon.ADJECTIVES | _SMALL | {"", "other", "next", "same", "whole", "own", "old", "empty", "single"}
"""``the day room`` is a kind of room, ``the little room`` is not."""
_THINGS = lexicon.PROPS | lexicon.SET_PIECES | lexicon.WORN
_OWNED = {
    "hut",
    "cabin",
    "shop",
    "tent",
    "cell",
    "study",
    "office",
    "workshop",
    "cottage",
    "kitchen",
    "chamber",
    "forge",
}
"""``the ferryman's hut``."""
_NEAR = 80
"""Characters before a place searched for another place that is a part of it."""
_NAMED_AFTER = lexicon.PLACES | _THINGS
WHOLE = {
    *("house", "cottage", "castle", "hotel", "inn", "motel", "palace", "mansion", "school", "schoolhouse", "church"),
    *("cathedral", "ship", "hospital", "prison", "jail", "monastery", "temple", "theatre", "theater", "museum"),
    *("station", "train", "plane", "factory", "mill", "farmhouse", "submarine", "spaceship", "lighthouse"),
}
"""They hold the rooms that the story is in: ``the house was silent`` is not another place."""


def sentence_place(opening: str, raw: str = "", home: str = "") -> str:
    """Return the place in which a sentence happens: a known kind of place, else the first one named.

    Args:
        opening: The sentence in small letters.
        raw: The same as written, for names of places.
        home: Where ``came home`` leads to.
    """
    if home and _HOME.search(opening):
        return home
    numbered = _NUMBERED.search(opening)
    if numbered:
        return numbered.group(1)
    places = [
        _part(opening[max(0, match.start() - _NEAR) : match.start()]) or place_head(match.group(1).split())
        for match in _PLACE_PHRASE.finditer(opening)
    ]
    named = [place for place in places if place and place != "room"]
    named += [(before + last).lower() for before, last in _NAMED.findall(raw) if last.lower() in lexicon.PLACES - WHOLE]
    known = [place for place in named if place in lexicon.PLACE_KINDS or place.rpartition("'s ")[2] in _OWNED]
    return (known or named or [""])[0]


def first_place(text: str) -> str:
    """Return the first place that a text names, also in a subordinate clause: ``who swept the station``."""
    places = [place_head(match.group(1).split()) for match in _NOUN_PHRASE.finditer(text)]
    return next((place for place in places if place), "")


def opening_place(opening: str) -> str:
    """Return the room or shop that is the subject of a story's first sentence; empty if it is none."""
    subject = _OPENING.match(opening)
    place = place_head(subject.group(1).split()) if subject else ""
    following = opening[opening.find(place) + len(place) :].split() if place else []
    acts = bool(following) and form_kind(following[0]) in ("past", "3sg", "aux")
    return place if acts and scene_type_of(place) == "indoor" else ""


def destination(told: list[str]) -> str:
    """Return where a person goes in the first sentence, if the paragraph continues there; else empty."""
    match = _GOING.search(told[0])
    if match is None or len(told) < 2 or _THERE_AND_BACK.search(told[0]):
        return ""
    return place_head(match.group(1).split()) or sentence_place(told[0][match.start() :])


def subject_place(opening: str, current: str) -> str:
    """Return the room that a paragraph begins with, or where its first sentence finds people; else empty.

    Args:
        opening: First sentence, in small letters.
        current: The place so far.
    """
    being = _BEING.match(opening)
    place = place_head(being.group(1).split()) if being else ""
    if place and "indoor" in (scene_type_of(place), scene_type_of(current)) and place not in WHOLE | {"room"}:
        return place
    numbered = _NUMBERED.match(opening)
    if numbered and _TELLING.match(opening[numbered.end() :]):
        return numbered.group(1)
    subject = _SUBJECT.match(opening)
    place = place_head(subject.group(1).split()) if subject else ""
    known = place not in WHOLE | {"room", ""} and place.rsplit(" ", 1)[-1] not in WHOLE
    at = opening.find(place) + len(place)
    return place if known and scene_type_of(place) == "indoor" and _TELLING.match(opening[at:]) else ""


def scene_type_of(place: str) -> SceneType:
    """Return the scene type of a place; what is unknown is outdoors."""
    head = place.partition(" ")[0] if _NUMBERED.match(place) else place.rpartition(" ")[2]
    return "indoor" if head in lexicon.INDOOR and head not in lexicon.OUTDOOR else "outdoor"


def place_head(words: list[str]) -> str:
    """Return the place in a list of words: ``small cottage at the edge`` -> cottage; ``castle gate`` stays."""
    for index, word in enumerate(words):
        if word in _SMALL:
            return ""
        compound = index + 1 < len(words) and words[index + 1] in _NAMED_AFTER
        if word in lexicon.PLACES and not compound:
            before = words[index - 1] if index else ""
            pair = f"{before} {word}".strip()
            owned = re.fullmatch(r"[a-z]+['’]s", before) is not None and word in _OWNED
            if owned:
                return f"{before.replace('’', chr(39))} {word}"
            of_a_kind = word == "room" and before not in _PLAIN and form_kind(before) in ("", "ing")
            return pair if of_a_kind or before in _NAMED_AFTER or pair in lexicon.PLACE_KINDS else word
    return ""


def room_within(place: str, told: list[str]) -> str:
    """Return the room of a building that the first paragraph comes into, else the place itself.

    Args:
        place: The building.
        told: Sentences of the paragraph, in lower case.
    """
    for sentence in told if place in WHOLE else ():
        for match in re.finditer(rf"\b(?:into|in)\s+{_DETERMINED}{_WORDS}", sentence):
            room = place_head(match.group(1).split())
            if room not in WHOLE | {"", "room"} and scene_type_of(room) == "indoor":
                return room
    return place


def _part(before: str) -> str:
    """Return the yard of ``the yard of the inn``; the place before a preposition, else an empty string."""
    words = before.split()
    return words[-1] if words and words[-1] in lexicon.PLACES and words[-2:-1] == ["the"] else ""

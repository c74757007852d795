"""Time of day, weather and passing time: in headings (five languages), and at the beginning of a prose story."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reading import SceneReading
from storyblender.memory.vocabulary import TimeOfDay, Weather

_CLOCK = re.compile(r"\b(\d{1,2})(?:[:.h]\d\d)?\s*([AP])\.?M\b\.?", re.IGNORECASE)
_CLOCK_24 = re.compile(r"\b(\d{1,2})(?::|h)(\d\d)\b(?:\s*(?:UHR|H|HOURS))?|\b(\d{1,2})\s*UHR\b", re.IGNORECASE)
_HOURS: tuple[tuple[int, TimeOfDay], ...] = (
    (5, "night"), (7, "dawn"), (12, "morning"), (13, "noon"), (17, "afternoon"), (20, "evening"), (24, "night"),
)  # fmt: skip
"""Hour at which each time of day ends, with its name."""
_GOES_ON = re.compile(
    r"\(?(?:CONTINUOUS(?: ACTION)?|CONT(?:INUED|INUING|['’]?D|\.)|SAME(?: TIME| DAY| MOMENT)?|MEANWHILE"
    r"|SIMULTANEOUS(?:LY)?|INTERCUT"
    r"|(?:(?:A|AN|ONE|TWO|THREE|FEW|SOME|SEVERAL|MUCH|A FEW|JUST|SOON) )?"
    r"(?:(?:BIT|LITTLE(?: WHILE)?|WHILE|MOMENTS?|MINUTES?|SECONDS?|HOURS?|DAYS?|WEEKS?|MONTHS?|YEARS?"
    r"|TIME) )?(?:LATER|EARLIER|AFTER)"
    r"|(?:THE )?(?:NEXT|FOLLOWING|PREVIOUS|ANOTHER) (?:DAY|WEEK|MONTH|YEAR)|FLASH ?BACK|PRESENT(?: DAY)?|ESTABLISHING"
    r"|RESUM(?:E|ING)"
    r"|MOVING|TRAVELL?ING|STATIONARY|PARKED|DREAM|FANTASY|MEMORY|MONTAGE|REAL TIME|DAY \d+|DAY [A-Z]"
    r"|(?:EARLY|LATE)?\s*(?:SPRING|SUMMER|AUTUMN|FALL|WINTER)|(?:MON|TUES|WEDNES|THURS|FRI|SATUR|SUN)DAY"
    r"|CONTIN[UÚ][OA]S?|CONTINUACI[ÓO]N|MISMO (?:TIEMPO|D[ÍI]A|MOMENTO)|(?:UN POCO )?M[ÁA]S TARDE|(?:MOMENTOS "
    r"|INSTANTES )?DESPU[ÉE]S|LUEGO"
    r"|AL D[ÍI]A SIGUIENTE|PLUS TARD|(?:UN PEU|QUELQUES INSTANTS|PEU) (?:PLUS TARD|APR[ÈE]S)|M[ÊE]ME (?:MOMENT|TEMPS)"
    r"|SUITE|CONTINU"
    r"|(?:(?:ETWAS|WENIG|KURZ|EINIGE ZEIT) )?SP[ÄA]TER|(?:KURZ |UNMITTELBAR |GLEICH )?(?:DANACH|DARAUF)|GLEICHZEITIG"
    r"|WEITER|FORTSETZUNG|DURCHGEHEND"
    r"|POCO DOPO|DOPO|PI[ÙU] TARDI|STESSO (?:MOMENTO|TEMPO)|VERANO|INVIERNO|OTO[ÑN]O|PRIMAVERA|HIVER|[ÉE]T[ÉE]"
    r"|AUTOMNE|PRINTEMPS"
    r"|(?:CIRCA )?[12]\d{3}(?:['’]?S)?)\)?\.?",
    re.IGNORECASE,
)
"""Words in the time slot of a heading that give no time of day: continuation, a season, a year."""
_BRACKET = re.compile(r"\s*\([^)]*\)\s*$")


def is_time_passage(text: str) -> bool:
    """Whether a part of a heading tells time but no time of day: ``CONTINUOUS``, ``WINTER``, ``1811``."""
    bare = _BRACKET.sub("", text).strip(" .,")
    return bool(bare) and _GOES_ON.fullmatch(bare) is not None


def heading_time(text: str) -> TimeOfDay | None:
    """Return the time of day in a part of a heading, in any of five languages, or None."""
    if clock := _CLOCK.search(text):
        return _time_of_hour(int(clock[1]) % 12 + 12 * (clock[2].upper() == "P"))
    if (clock := _CLOCK_24.search(text)) and (hour := int(clock[1] or clock[3])) < 24:
        return _time_of_hour(hour)
    words = re.findall(r"[^\W\d_]+", text.lower())
    foreign: list[TimeOfDay] = [lexicon.FOREIGN_TIMES[word] for word in words if word in lexicon.FOREIGN_TIMES]
    return time_in_text(text) or (foreign[0] if foreign else None)


def is_time(text: str) -> bool:
    """Whether a part of a heading is a time of day and no place: ``EARLY MORNING``, not ``NIGHT CLUB``."""
    if heading_time(text) is None:
        return False
    words = re.findall(r"[^\W\d_]+", text.lower())
    return not any(word in lexicon.PLACES for word in words) and len(words) <= 6


_PASSED: dict[TimeOfDay, TimeOfDay] = {"dawn": "morning", "sunset": "evening", "dusk": "evening"}


def time_in_text(text: str) -> TimeOfDay | None:
    """Return the first time of day in an English text, or None."""
    low = " ".join(re.findall(r"[a-z]+", text.lower()))
    for phrase, time in lexicon.TIME_PHRASES.items():
        if re.search(rf"\b{phrase}\b", low):
            return time
    named: list[TimeOfDay] = [lexicon.TIME_WORDS[word] for word in low.split() if word in lexicon.TIME_WORDS]
    return named[0] if named else None


def default_time(scenes: Sequence[SceneReading], place: str) -> TimeOfDay:
    """Return the time of a scene that tells none: that of the scene before.

    Dawn and dusk are over in another place.

    Args:
        scenes: The scenes so far.
        place: The place of the new scene.
    """
    if not scenes:
        return "day"
    last = scenes[-1]
    return _PASSED.get(last.time, last.time) if place and place != last.place else last.time


def weather_of(text: str) -> Weather:
    """Return the weather in a text; clear if it mentions none."""
    words = re.findall(r"[^\W\d_]+", text.lower())
    named: list[Weather] = [lexicon.WEATHER_WORDS[word] for word in words if word in lexicon.WEATHER_WORDS]
    return named[0] if named else "clear"


def _time_of_hour(hour: int) -> TimeOfDay:
    """Return the time of day of an hour, 0 to 23."""
    return next(time for until, time in _HOURS if hour < until)


_DARK = re.compile(
    r"\b(?:past|after|since|by) dark\b|\bin the dark(?:ness)?\b(?! of)|\bit was (?:\w+ )?dark\b"
    r"|\b(?:dark|darkness) (?:had )?(?:fell|fallen|came)\b|\b(?:the (?:full |new |half )?moon|the stars|starlight)\b"
    r"|\b(?:candle|lamp|torch)light\b|\bstreet ?lamps?\b|\bheadlights\b|\blights went out\b"
)
_LATE = re.compile(
    r"\b(?:past|at|after|by|before|nearly|almost|about) (?:\w+ past )?(?:nine|ten|eleven|twelve)(?: o'clock)?\b"
    r"(?! (?:minutes|hours|days|years|men|people|steps|miles|feet|times|of|or|and)\b)"
)
_SUN = re.compile(r"\b(?:the sun was|in the sun|sunlight|sunshine|the midday)\b")
_GREY = re.compile(r"\b(?:first|grey|gray|pale) (?:grey |gray )?light\b")
_GONE = re.compile(r"\b(?:since|until|till|last|yesterday|tomorrow)\W+(?:\w+ )?$")
"""``since noon``, ``last night``: another time than now."""


def story_time(told: list[str], title: str) -> TimeOfDay | None:
    """Return the time at which a story begins, or None.

    Args:
        told: Sentences of its first paragraph, in lower case.
        title: Title of the story.
    """
    whole = " ".join(told)
    return _opening_time(told[0]) or _opening_time(whole) or time_in_text(title)


def _opening_time(text: str) -> TimeOfDay | None:
    """Return the time of day that opening words tell, or None."""
    for match in re.finditer(r"[a-z]+", text):
        named = time_in_text(match.group(0))
        if named and not _GONE.search(text[: match.start()]):
            return named
    if _DARK.search(text) or (_LATE.search(text) and "morning" not in text and not _SUN.search(text)):
        return "night"
    return "dawn" if _GREY.search(text) else None

"""Scene headings: inside or outside, the place, the time, the weather, and which scene it returns to (notes, 4.5)."""

from __future__ import annotations

import re
from functools import lru_cache
from itertools import islice

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.manuscript import Paragraph
from storyblender.agents.director.reading import SceneReading
from storyblender.memory.vocabulary import SceneType, TimeOfDay, Weather
from storyblender.screenplay.fountain import LEADING_WORDS

_PREFIX = re.compile(r"^(INT\.?/EXT|EXT\.?/INT|I/E|E/I|INT|EXT|EST)\b\.?\s*(.*)$", re.IGNORECASE | re.DOTALL)
_NUMBER = re.compile(r"^\s*[A-Z]?\d+[A-Z]?[.)]?\s+(?=INT|EXT|I/E)|\s*#[^#]*#\s*$|\s+[A-Z]?\d+[A-Z]?\s*$")
_DASH = re.compile(r"\s+[-–—]+\s*|\s*[–—]+\s*|\s+--\s*")
_SAME_TIME = re.compile(
    r"^\(?(CONTINUOUS|CONTINUED|CONT['’]D|CONTINUING|SAME( TIME| DAY)?|MEANWHILE|SIMULTANEOUS|INTERCUT|"
    r"((A|AN|ONE|TWO|THREE|FEW|SOME|SEVERAL|MUCH|A FEW) )?"
    r"((BIT|LITTLE( WHILE)?|WHILE|MOMENTS?|MINUTES?|SECONDS?|HOURS?|DAYS?|WEEKS?|MONTHS?|YEARS?|TIME) )?"
    r"(LATER|EARLIER)|THE NEXT DAY|FLASHBACK|PRESENT( DAY)?|ESTABLISHING)\)?\.?$"
)
_BACK = re.compile(r"^back (?:in|at|to) (?:the )?|^(?:the|a) ")
_STOP = re.compile(r"(?<=[A-Za-z]{2})(?<!\bST)(?<!\bMT)(?<!\bDR)(?<!\bMR)(?<!\bMRS)(?<!\bFT)(?<!\bNO)\.\s+(?=[A-Z0-9])")
"""``INT. ASHDOWN PARK, BALLROOM. NIGHT. 1811``: full stops divide like dashes."""
_CLOCK = re.compile(r"\b(\d{1,2})(?::\d\d)?\s*([AP])\.?M\b", re.IGNORECASE)
_YEAR = re.compile(r"(?:CIRCA )?[12]\d{3}(?:['’]?S)?$")
_HOURS: tuple[tuple[int, TimeOfDay], ...] = (
    (5, "night"), (7, "dawn"), (12, "morning"), (13, "noon"), (17, "afternoon"), (20, "evening"), (24, "night"),
)  # fmt: skip
"""Until which hour it is what time of the day."""
_BRACKETS = re.compile(r"\s*\([^)]*\)\s*")
_LATELY = 250
"""Scenes back in which a place may be that is named shorter now."""
_SMALL = frozenset({"the", "a", "of", "in", "at", "s"})


def read_heading(paragraph: Paragraph, scenes: list[SceneReading]) -> SceneReading:
    """Read ``INT. MUSEUM - VAULT CORRIDOR - CONTINUOUS``.

    Args:
        paragraph: The heading.
        scenes: The scenes before; the new one takes the next id.
    """
    heading = " ".join(paragraph.text.split())
    match = _PREFIX.match(LEADING_WORDS.sub("", _NUMBER.sub("", heading)))
    prefix, rest = (match.group(1).lower(), match.group(2)) if match else ("", heading)
    place, time, written = _place_and_time(rest.strip(" .-"), scenes)
    place = _BACK.sub("", place.lower())
    scene_type = _scene_type(prefix, place)
    return SceneReading(
        id=len(scenes) + 1,
        heading=heading,
        place=place,
        place_kind=lexicon.place_kind(place),
        scene_type=scene_type,
        time=time,
        time_written=written,
        weather=weather_of(heading),
        reference=same_place(place, scene_type, scenes),
        number=paragraph.scene_number,
        start=paragraph.start,
        end=paragraph.end,
    )


def first_scene(paragraph: Paragraph) -> SceneReading:
    """A scene for a script that starts without a heading."""
    return SceneReading(1, "", "", "", "outdoor", "day", start=paragraph.start, end=paragraph.end)


def _place_and_time(rest: str, scenes: list[SceneReading]) -> tuple[str, TimeOfDay, str]:
    inherited: TimeOfDay = scenes[-1].time if scenes else "day"
    parts = [part for whole in _DASH.split(rest) if whole for part in _STOP.split(whole)]
    if len(parts) == 1 and "," in rest:
        place, last = rest.rsplit(",", 1)
        parts = [place, last.strip()] if _heading_time(last) or _SAME_TIME.match(last.strip().upper()) else parts
    time, written = inherited, ""
    while len(parts) > 1:
        last = parts[-1].strip(" .").upper()
        told = _heading_time(last)
        if not told and not _SAME_TIME.match(last) and not _YEAR.match(last):
            break
        time, written = (told or time), f"{last} {written}".strip()
        parts.pop()
        if told:
            break
    if len(parts) == 1 and not written:
        words = parts[0].split()
        if len(words) > 1 and words[-1].upper() in ("DAY", "NIGHT"):
            time, written, parts = time_of(words[-1]) or time, words[-1].upper(), [" ".join(words[:-1])]
    return _BRACKETS.sub(" ", " ".join(parts)).strip(" .,"), time, written


def _heading_time(text: str) -> TimeOfDay | None:
    """The time at the end of a heading, in English or another language."""
    clock = _CLOCK.search(text)
    if clock:
        hour = int(clock.group(1)) % 12 + 12 * (clock.group(2).upper() == "P")
        return next(time for until, time in _HOURS if hour < until)
    words = re.findall(r"[^\W\d_]+", text.lower())
    return time_of(text) or next((lexicon.FOREIGN_TIMES[word] for word in words if word in lexicon.FOREIGN_TIMES), None)


def time_of(text: str) -> TimeOfDay | None:
    """The first time of day a text names."""
    for word in re.findall(r"[a-z]+", text.lower()):
        if word in lexicon.TIME_WORDS:
            return lexicon.TIME_WORDS[word]
    return None


def weather_of(text: str) -> Weather:
    """The weather a text names; clear where it names none."""
    for word in re.findall(r"[a-z]+", text.lower()):
        if word in lexicon.WEATHER_WORDS:
            return lexicon.WEATHER_WORDS[word]
    return "clear"


def _scene_type(prefix: str, place: str) -> SceneType:
    if "/" in prefix and place.split()[-1:] and place.split()[-1] in lexicon.OUTDOOR - lexicon.INDOOR:
        return "outdoor"
    if prefix:
        return "indoor" if prefix.startswith(("int", "i/")) else "outdoor"
    return "indoor" if set(place.split()) & lexicon.INDOOR else "outdoor"


def same_place(place: str, scene_type: SceneType, scenes: list[SceneReading]) -> int | None:
    """Id of the first scene in the same place, else of the last whose place holds all its words."""
    exact = next((s.id for s in scenes if s.place == place and s.scene_type == scene_type), None)
    if exact:
        return exact
    words = _words(place)
    lately = islice(reversed(scenes), _LATELY)
    containing = (s.id for s in lately if s.scene_type == scene_type and words and words <= _words(s.place))
    return next(containing, None)


@lru_cache(maxsize=16384)
def _words(place: str) -> frozenset[str]:
    return frozenset(re.findall(r"[a-z0-9]+", place)) - _SMALL

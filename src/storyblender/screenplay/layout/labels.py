"""Labels at the start of a line: a speaker (``Baker:``, ``BAKER.``), text or sound (``SUPER:``, ``SFX:``)."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from typing import Final, NamedTuple

from storyblender.screenplay.headings import is_heading, place_label, scene_label
from storyblender.screenplay.layout.lines import Line
from storyblender.screenplay.model import ElementKind

_UP = "A-ZÀ-ÖØ-Þ"
_NAME = (
    rf"(?:\#\d{{1,3}}(?:[-–]\d{{1,3}})?|(?:[{_UP}][\w'’.&#-]*)(?:[ \t]+(?:(?:and|of|the|de|la|von|y|und|et|e|in"
    rf"|with)\b|&"
    rf"|[{_UP}#\d][\w'’.&#-]*))"
    r"{0,4})"
)
_BRACKET = r"(?:[ \t]*(?P<bracket>[(\[][^)\]\n]{1,120}[)\]]))?"
_LEAD = r"(?:[-–—•*·]\s+|\d{1,2}[.)]?\s+(?=[A-Z]{2}))?"
_COLON = re.compile(
    rf"{_LEAD}[*_]{{0,3}}(?P<name>{_NAME})[*_]{{0,3}}{_BRACKET}[*_]{{0,3}}\s?:[*_]{{0,3}}(?P<gap>\s+|$)"
)
_PLAIN = (
    rf"(?:(?:M(?:r|R|rs|RS|s|S)|D[rR]|S[tT]|Prof|Capt|Rev|Sgt)\. )?[{_UP}][\w'’&#-]*(?:[ \t](?:and|of|the|de|la"
    rf"|&|[{_UP}#\d][\w'’&#-]*)){{0,4}}"
)
"""A name without a full stop in it."""
_STOP = re.compile(rf"{_LEAD}[*_]{{0,3}}(?P<name>{_PLAIN})[*_]{{0,3}}{_BRACKET}\.(?:[-–—]+)?[*_]{{0,3}}(?P<gap>\s+|$)")
_DASH = re.compile(rf"{_LEAD}[*_]{{0,3}}(?P<name>{_NAME})[*_]{{0,3}}{_BRACKET}\s?(?:[-–—]{{1,2}})(?P<gap>\s+)")
_TAB = re.compile(
    rf"(?P<name>#\d{{1,3}}(?:[-–]\d{{1,3}})?|[{_UP}][{_UP}'’ .#\d]{{1,24}}?)(?P<bracket>)(?P<gap>\t+"
    rf"|[ ]{{3,}})(?=\S)"
)
FORMS: Final = {"colon": _COLON, "stop": _STOP, "dash": _DASH, "tab": _TAB}
"""Separators between a name and its speech on one line."""
_READ = re.compile(
    r"(?:(?:ON[- ]SCREEN )?(?:SUPER(?:IMPOSE[DS]?|TITLES?)?|TITLES?(?: CARD)?|CHYRON|SUBTITLES?|INTERTITLES?|(?:END "
    r"|TITLE |INTER)?CARD"
    r"|CAPTIONS?|CAP|TEXT|LEGAL|LOWER THIRD|GRAPHICS?|ON SCREEN(?: TEXT)?|SLIDE|NARRATION BOX"
    r"|INSERT TITLE|R[ÓO]TULO|T[ÍI]TULO|CARTEL|EINBLENDUNG|TEXTTAFEL|CARTON|CARTELLO))"
    r"(?: (?:OVER(?: BLACK)?|READS?|UP|APPEARS))?[ \t]*(?:\([^)\n]{1,60}\))?\s*(?:[:=]|[-–—]{1,2}\s)\s*",
)
_HEARD = re.compile(
    r"(?:SFX|FX|SOUNDS?(?: EFFECTS?)?|MUSIC(?: CUE)?|MUSIK|M[ÚU]SICA|MUSIQUE|SONIDO|GER[ÄA]USCHE?|TON|ATMO|MVT|MX"
    r"|SOUND ON TAPE|NAT ?SOT)"
    r"[ \t]*(?:\([^)\n]{1,60}\))?\s*(?::|\s[-–—])\s*",
    re.IGNORECASE,
)
_NOTED = re.compile(
    r"(?:NOTES?|N\.?B\.?|PS|P\.S|LOG ?LINE|SYNOPSIS|TAG ?LINE|DIRECTOR['’]?S NOTE|AUTHOR['’]?S NOTE"
    r"|TO (?:THE )?(?:ARTIST|LETTERER))"
    r"\b[^:\n]{0,24}:",
    re.IGNORECASE,
)
_NOBODY = {
    "setting", "scene", "place", "time", "set", "location", "note", "notes", "title", "author", "credit", "contact",
    "cast", "characters", "props", "video", "audio", "visual", "sound", "super", "sfx", "music", "lights", "light",
    "curtain", "blackout", "act", "chapter", "part", "page", "panel", "int", "ext", "client", "job", "format",
    "version", "camera", "product", "length", "date", "draft", "copyright", "synopsis", "logline", "summary",
    "warning", "subject", "fade in", "fade out", "cut to", "close", "close on", "wide", "shot", "day", "night",
    "later", "meanwhile", "at rise", "montage", "voice", "intercut", "insert", "caption", "cap", "end", "the end",
    "from", "to", "re", "then", "duration", "genre", "target", "runtime", "example", "step", "ingredients", "legal",
    "script", "text", "sign", "silence", "pause", "beat", "nothing", "no", "yes", "darkness", "dark", "rain",
    "black", "oh", "ah", "well", "so", "mr", "mrs", "dr", "ms", "st", "prof", "jr", "sr", "vol", "fig", "ltd", "p",
    "pp", "no.", "etc",
}  # fmt: skip
"""Words before a colon or a full stop that are no name."""


class Label(NamedTuple):
    """A line that begins with its speaker."""

    name: str
    bracket: str
    """Text of the bracket after the name, without the brackets."""
    start: int
    """Offsets of the name with its bracket."""
    end: int
    speech: int
    """Offset of the first word of the speech on this line; its end where there is none."""


class Convention(NamedTuple):
    """How speeches are marked on one page."""

    form: str
    """Key of ``FORMS``."""
    names: frozenset[str]
    """Names of everyone who speaks in this form, in capitals."""


def spoken_line(line: Line, convention: Convention) -> Label | None:
    """Return the speaker's label of a line, or None if it has none.

    Args:
        line: The line.
        convention: How this page marks speakers.
    """
    match = FORMS[convention.form].match(line.words)
    if match is None or key_of_name(match["name"]) not in convention.names:
        return None
    after = match.end("bracket") if match["bracket"] else match.end("name")
    return Label(
        plain_name(match["name"]),
        (match["bracket"] or "").strip("()[] "),
        line.start + match.start("name"),
        line.start + after,
        line.start + match.end(),
    )


def find_convention(lines: Sequence[Line], known: frozenset[str] = frozenset()) -> Convention | None:
    """Return how this page marks speakers, if at least three lines share one form and a name recurs.

    Args:
        lines: The lines of the page.
        known: Names of its cast list, in capitals.
    """
    best: tuple[int, Convention] | None = None
    for form, pattern in FORMS.items():
        names: Counter[str] = Counter()
        for line in lines:
            match = pattern.match(line.words)
            if match and _may_speak(match, line, form, known):
                names[key_of_name(match["name"])] += 1
        kept = {name for name, count in names.items() if count > 1 or name in known or _like(name, known)}
        spoken = sum(names[name] for name in kept)
        loud = sum(names.values())
        if spoken < 3 or (form == "stop" and len(kept) < 2):
            continue
        # In the page's own form, a name that speaks only once counts as well.
        everyone = kept if form == "dash" else {*names}
        if loud > 3 * spoken:
            everyone = kept
        if best is None or spoken > best[0]:
            best = spoken, Convention(form, frozenset(everyone))
    return best[1] if best else None


def key_of_name(name: str) -> str:
    """Return a name normalised for comparison: capitals, no punctuation."""
    return plain_name(name).upper()


def plain_name(name: str) -> str:
    """Return a name without emphasis marks and the full stop after it."""
    bare = " ".join(re.sub(r"[*_]", "", name).split())
    return bare[:-1] if bare.endswith(".") and not re.search(r"\b(?:[A-Z]|MR|MRS|DR|JR|SR|ST)\.$", bare, re.I) else bare


def element_of_label(words: str) -> tuple[ElementKind, int] | None:
    """Return the kind of a labelled line and the offset of its words: on-screen text, sound, or a note to the crew."""
    if match := _READ.match(words):
        return "title", match.end()
    if match := _HEARD.match(words):
        return "sound", 0
    return ("section", 0) if _NOTED.match(words) else None


def _may_speak(match: re.Match[str], line: Line, form: str, known: frozenset[str]) -> bool:
    """Return whether a matched label can be the name of a speaker."""
    name = plain_name(match["name"])
    words = name.lower().split()
    if not words or name.lower() in _NOBODY or words[0].strip(".") in _NOBODY or len(words) > 5:
        return False
    if is_heading(line.words) or scene_label(line.words) or place_label(line.words) or element_of_label(line.words):
        return False
    loud = name == name.upper()
    if form in ("stop", "dash"):  # ``Well. He goes.`` is no speech; before a full stop only capitals are a name
        listed = name.upper() in known or _like(name.upper(), known)
        marked = loud or listed or (form == "stop" and match[0][:1] in "_*")
        return marked and len(name) > 1 and not re.fullmatch(r"[IVXLC]+|[A-Z]", name)
    return loud or (line.words[match.end() :].strip() != "" and len(words) <= 3) or match["gap"] == ""


def _like(name: str, known: frozenset[str]) -> bool:
    """Return whether a name is a part of one in the cast list: CHIEF of CHIEF BABALOLA."""
    return any(name in other.split() for other in known)

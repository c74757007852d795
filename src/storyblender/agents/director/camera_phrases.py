"""Camera directions written in a script: ``CLOSE ON NORA``, ``we push in``, ``[[SHOT: low angle]]`` (notes, section 3).

A word alone counts only in capitals, or as a move after "we" or "the camera", since people also pull back. Phrases
used only for cameras (``Wide shot of``, ``Nahaufnahme``) count in any spelling, and so does everything in a ``SHOT``
note.
"""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from typing import Final

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import UPPER
from storyblender.agents.director.reading import CameraNote

Span = tuple[int, int]

_SHALLOW = (
    r"(?:SHALLOW|NARROW|SELECTIVE) (?:FOCUS|DEPTH OF FIELD)|FAIBLE PROFONDEUR DE CHAMP|POCA PROFUNDIDAD DE CAMPO"
    r"|GERINGE TIEFENSCH[ÄA]RFE"
)
_RACK = r"(?:RACK|PULL|SHIFT)(?:S|ING)? FOCUS|FOCUS (?:RACKS|PULLS|SHIFTS)|RACK(?:S|ING)?(?= TO\b)"
_FOCUS = rf"{_SHALLOW}|(?:DEEP|SOFT) FOCUS|{_RACK}"
_MEANINGS: Final[tuple[tuple[str, dict[str, str | float]], ...]] = (
    (
        r"EXTREME(?:LY)? (?:CLOSE|CU)|ECU|XCU|BCU|PRIMER[IÍ]SIMO|TR[ÈE]S GROS PLAN|DETAILAUFNAHME|PRIMISSIMO"
        r"|PLANO DETALLE|DETTAGLIO",
        {"size": "ECU"},
    ),
    (
        r"PLANO GENERAL|GRAN PLANO|PLAN (?:LARGE|D['’]ENSEMBLE|G[ÉE]N[ÉE]RAL)|WEITE|TOTALE|CAMPO LUNGO|CAMPO TOTALE"
        r"|GENERAL PLAN",
        {"size": "WS"},
    ),
    (r"PLANO ENTERO|PLAN (?:MOYEN|PIED)|HALBTOTALE|FIGURA INTERA", {"size": "FS"}),
    (r"PLANO AMERICANO|PLAN AM[ÉE]RICAIN|AMERIKANISCH|PIANO AMERICANO", {"size": "MWS"}),
    (r"PLANO MEDIO|PLAN (?:TAILLE|RAPPROCH[ÉE])|HALBNAHE?|MEZZO BUSTO", {"size": "MS"}),
    (r"PRIMER PLANO|GROS PLAN|NAHAUFNAHME|GRO(?:SS|ß)AUFNAHME|PRIMO PIANO|CLOSE PLAN", {"size": "CU"}),
    (r"MED(?:IUM)?\.? CLOSE|MCU", {"size": "MCU"}),
    (r"(?:EXTREME(?:LY)?|VERY) (?:WIDE|LONG)|EWS|ELS|AERIAL", {"size": "EWS"}),
    (r"MED(?:IUM)?\.? (?:WIDE|LONG|FULL)|MWS|MLS|COWBOY|AMERICAN SHOT", {"size": "MWS"}),
    (r"ESTABLISHING", {"size": "EWS", "kind": "establishing"}),
    (r"CLOSE(?:R|[- ]?UPS?)?|CU|TIGHT(?:ER)?", {"size": "CU"}),
    (r"FULL[- ](?:WIDTH|BLEED|PAGE)|SPLASH", {"size": "WS"}),
    (r"FULL(?:[- ]LENGTH)?|FS", {"size": "FS"}),
    (r"WIDE(?:R)?|LONG|WS|LS|MASTER", {"size": "WS"}),
    (r"MEDIUM|MED\.?|MS", {"size": "MS"}),
    (r"(?:TWO|2)[- ]?SHOT", {"kind": "two_shot"}),
    (r"GROUP|THREE[- ]SHOT", {"kind": "group"}),
    (r"INSERT|INSET", {"kind": "insert"}),
    (r"C[ÁA]MARA SUBJETIVA|PUNTO DE VISTA|CAM[ÉE]RA SUBJECTIVE|SUBJEKTIVE", {"kind": "pov"}),
    (r"CONTRAPICADO|CONTRE[- ]PLONG[ÉE]E|UNTERSICHT", {"angle": "low angle"}),
    (r"PICADO|PLONG[ÉE]E|AUFSICHT", {"angle": "high angle"}),
    (r"POV|POINT OF VIEW", {"kind": "pov"}),
    (r"OTS|OVER", {"kind": "ots"}),
    (r"REVERSE", {"kind": "reverse"}),
    (r"INTERCUT(?:TING)?", {"kind": "intercut"}),
    (r"MATCH CUT", {"kind": "match_cut"}),
    (r"SPLIT[- ]SCREEN", {"kind": "split_screen"}),
    (r"LOW", {"angle": "low angle"}),
    (r"OVERHEAD|TOP[- ]?(?:SHOT|DOWN)|HIGH", {"angle": "high angle"}),
    (r"BIRD['’]?S[- ]EYE|GOD['’]?S[- ]EYE|AERIAL", {"angle": "bird's-eye"}),
    (r"WORM['’]?S[- ]EYE", {"angle": "worm's-eye"}),
    (r"DUTCH|CANTED", {"angle": "dutch", "roll": 12.0}),
    (r"EYE[- ]LEVEL", {"angle": "eye-level"}),
    (r"(?:PUSH|DOLLY|MOVE|CLOSE|CREEP)(?:E?S|ING)? (?:CLOSER|IN)", {"movement": "push in"}),
    (r"(?:PULL|DOLLY|MOVE|DRAW)(?:E?S|ING)? (?:BACK|OUT|AWAY)", {"movement": "pull out"}),
    (r"ZOOM(?:S|ING)? OUT", {"movement": "zoom out"}),
    (r"ZOOM(?:S|ING)?(?: IN)?", {"movement": "zoom in"}),
    (r"(?:WHIP |SWISH )?PAN(?:S|NING)?", {"movement": "pan"}),
    (r"TILT(?:S|ING)?", {"movement": "tilt"}),
    (r"CRAN(?:E|ES|ING)|BOOM(?:S|ING)?|PEDESTAL|JIB|RIS(?:E|ES|ING)", {"movement": "pedestal"}),
    (r"TRUCK(?:S|ING)?", {"movement": "truck"}),
    (r"ORBIT(?:S|ING)?|CIRCL(?:E|ES|ING)|ARC(?:S|ING)?", {"movement": "orbit"}),
    (r"TRACK(?:S|ING)?|DOLLY|STEADICAM|FOLLOW(?:S|ING)?|DRIFT(?:S|ING)?", {"movement": "track"}),
    (r"HOLD(?:S|ING)?|STAY(?:S|ING)?|LINGER(?:S|ING)?|STATIC|LOCKED[- ]OFF|HANDHELD", {"movement": "static"}),
    (_SHALLOW, {"focus": "shallow"}),
    (r"DEEP FOCUS", {"focus": "deep"}),
    (r"SOFT FOCUS", {"focus": "soft"}),
    (_RACK, {"focus": "rack"}),
    (r"LEFT", {"direction": "left"}),
    (r"RIGHT", {"direction": "right"}),
    (r"UP(?:WARDS?)?", {"direction": "up"}),
    (r"DOWN(?:WARDS?)?", {"direction": "down"}),
)
"""What a camera word sets; the first pattern that sets a field wins, so longer phrases stand before their parts."""

_ALONE = r"\s*[-–—:.,]|\s*$"
_SIZE = (
    r"(?:EXTREME(?:LY)? |VERY |MED(?:IUM)?\.? )?(?:CLOSE(?:R|[- ]?UPS?)|CU\b"
    rf"|(?:CLOSE|TIGHT(?:ER)?)(?= (?:ON|OF|SHOT|IN\b)|{_ALONE})"
    rf"|(?:WIDE(?:R)?|LONG|FULL)(?= (?:ON|SHOT|ANGLE|VIEW|OF|FIGURE)|{_ALONE}))"
    r"|ECU|XCU|BCU|MCU|MWS|MLS|EWS|ELS|MS|FS|WS|LS|COWBOY SHOT|AMERICAN SHOT|MEDIUM (?=SHOT|ON|ANGLE)|MEDIUM SHOT"
)
_FORM = (
    r"ESTABLISHING(?: SHOT)?|AERIAL(?: SHOT| VIEW)?|(?:TWO|2|THREE|GROUP)[- ]?SHOT|MASTER SHOT|MASTER(?=\s*[-–—:])"
    r"|INSERT|REVERSE(?: ANGLE| SHOT)?|(?:LOW|HIGH|DUTCH|CANTED|NEW|ANOTHER|WIDE|WIDER)[- ]ANGLE|ANGLE(?= ON|\s*[-–—:])"
    r"|OVERHEAD(?: SHOT| VIEW)?|TOP[- ](?:SHOT|DOWN)|(?:BIRD|WORM|GOD)['’]?S[- ]EYE(?: VIEW| SHOT)?|EYE[- ]LEVEL"
    r"|INTERCUT(?:TING)?|MATCH CUT|SPLIT[- ]SCREEN|BACK TO SCENE|BACK TO|STATIC(?: SHOT)?|LOCKED[- ]OFF|HANDHELD"
)
_MOVE = (
    r"(?:PUSH|MOVE|CLOSE|CREEP)(?:E?S|ING)? (?:CLOSER|IN)|(?:PULL|MOVE|DRAW)(?:E?S|ING)? (?:BACK|OUT|AWAY)"
    r"|DOLLY(?:ING)?(?: IN| OUT| BACK| WITH)?|ZOOM(?:S|ING)?(?: IN| OUT)?|(?:WHIP |SWISH )?PAN(?:S|NING)?"
    r"|TILT(?:S|ING)?|CRAN(?:E|ES|ING)(?= SHOT| UP| DOWN| OVER)|BOOM(?:S|ING)? (?:UP|DOWN)|TRACK(?:S|ING)?"
    r"|TRUCK(?:S|ING)?(?= LEFT| RIGHT)|STEADICAM|ORBIT(?:S|ING)?|CIRCL(?:E|ES|ING)(?= AROUND)|ARC(?:S|ING)? (?:AROUND)"
    rf"|HOLD(?:S|ING)?(?= ON)|{_FOCUS}"
)
_SPOKEN_MOVE = (
    rf"{_MOVE}|CRAN(?:E|ES)|CIRCLE(?:S)?|RISE(?:S)?|DRIFT(?:S)?|FOLLOW(?:S)?|TRUCK(?:S)?"
    r"|STAY(?:S)?(?= ON)|LINGER(?:S)?(?= ON)"
)
_WAY = r"(?: (?:SLOWLY|QUICKLY|GENTLY|SHOT|SHOTS|ANGLE|VIEW|LEFT|RIGHT|UP|DOWN|UPWARDS?|DOWNWARDS?))*"
_HOW = r"(?:(?:A|AN|THE|SLOW|SLOWLY|QUICK|QUICKLY|GENTLY|STEADILY|VERY|THEN) )*"
_TERM = rf"(?:{_SIZE}|{_FORM}|{_MOVE})(?![A-Za-z]){_WAY}"
_RUN = rf"{_HOW}(?:{_TERM})(?:\s*[,/&-]?\s*(?:AND )?{_HOW}(?:{_TERM}))*"
_NAME = rf"[{UPPER}][{UPPER} .#0-9'’-]*?"
_LINK = (
    r"\s*(?:\b(?:UP ON|IN ON|ONTO|ON|OF|THROUGH|FROM|INTO|TOWARDS?|WITH|AT|BEHIND|PAST|ACROSS|ALONG|AROUND|OVER|BETWEEN"
    r"|TO REVEAL|TO FIND|TO SHOW|REVEALING|TO)\b)?\s*[:–—-]*\s*"
)

_POINT_OF_VIEW = re.compile(
    rf"\s*(?:FROM )?(?:(?P<before>{_NAME})(?:['’]S?)? )?(?:POV|POINT OF VIEW)\b"
    rf"(?:\s*(?:OF|[-–—:])?\s*(?P<after>(?!(?:THROUGH|FROM|OF|THE|ON|SHOT)\b){_NAME})(?=\s*(?:[-–—:.,]|$)))?"
)
_SHOULDER = re.compile(
    rf"\s*(?:OVER (?P<owner>(?!THE){_NAME})(?:['’]S?)? SHOULDER"
    rf"|(?:OVER[- ]THE[- ]SHOULDER|OTS)(?: SHOT)?"
    rf"(?:\s*(?:OF|[-–—:])?\s*(?P<after>(?!(?:ON|OF|THE)\b){_NAME})(?= ON\b| TO\b|\s*[-–—:.,]|\s*$))?)"
)
_LEAD = re.compile(rf"\s*(?:{_RUN}|ON(?= [{UPPER}]{{2}}))(?![A-Za-z])")
_SHOT_WORD = r"(?:SHOT|VIEW|ANGLE|FRAME|PANEL|PICTURE)"
_ALWAYS = (
    rf"(?:(?:A|AN|THE|THEN|NOW|BACK TO|CUT TO|OPEN ON|WE (?:OPEN|START|BEGIN) (?:ON|WITH)|SAME SHOT BUT"
    rf"|BIGGEST PANEL)[,:]? )*"
    rf"(?:(?:(?:EXTREME(?:LY)? |VERY )?(?:WIDE|LONG|FULL|MEDIUM|MID|TRACKING|PANNING|AERIAL|OVERHEAD|ESTABLISHING"
    rf"|HANDHELD|CRANE|DRONE|DOLLY"
    rf"|LOW[- ]ANGLE|HIGH[- ]ANGLE|BIRD['’]?S[- ]EYE|WORM['’]?S[- ]EYE|REVERSE|MASTER|TWO|GROUP|POV"
    rf"|POINT[- ]OF[- ]VIEW|CLOSE(?:[- ]?UP)?|TIGHT|BIG(?:GEST)?|LARGE|SMALL|TALL|NARROW|SAME)[- ]"
    rf"{_SHOT_WORD})(?! (?:GLASS|HOLE|GUN))|(?:EXTREME(?:LY)? |VERY )?CLOSE[- ]?UPS?(?= (?:ON|OF|SHOT)|{_ALONE})"
    rf"|(?:CLOSE|TIGHT) (?:IN )?ON\b"
    rf"|(?:EXTREME(?:LY)? )?(?:CLOSE|TIGHT|WIDE|CLOSER|WIDER|TIGHTER)(?=\s*[.:](?:\s|$)|$)|(?:LOW|HIGH) ANGLE\b"
    rf"|FULL[- ](?:WIDTH|BLEED)|SPLASH PAGE|SPLASH(?=[.:])"
    rf"|INSET(?=\s*[.:])|OPEN(?:S|ING)? ON(?=\s*:)|PAN(?:S|NING)? (?:TO|ACROSS|OVER)(?= (?:THE|A|AN)\b)"
    rf"|BIRD['’]?S[- ]EYE VIEW|{_FOCUS}"
    r"|(?:PRIMER[IÍ]SIMO )?PRIMER[IÍ]?(?:SIMO)? PLANO|PLANO (?:GENERAL|MEDIO|DETALLE|ENTERO|AMERICANO)"
    r"|GRAN PLANO GENERAL|C[ÁA]MARA SUBJETIVA|(?:CONTRA)?PICADO"
    r"|(?:TR[ÈE]S )?GROS PLAN|PLAN (?:LARGE|D['’]ENSEMBLE|MOYEN|AM[ÉE]RICAIN|RAPPROCH[ÉE])|(?:CONTRE-)?PLONG[ÉE]E"
    r"|NAHAUFNAHME|GRO(?:SS|ß)AUFNAHME|DETAILAUFNAHME|HALBTOTALE|HALBNAHE?|TOTALE(?=\s*[-–—:.,]| VON| DE)|(?:CLOSE"
    r"|GENERAL) PLAN(?=\s*[:,.])"
    r"|PRIMO PIANO|CAMPO LUNGO|DETTAGLIO(?= D|\s*[:.]))"
)
_LOOSE = re.compile(rf"\s*{_ALWAYS}(?![\w])", re.IGNORECASE)
"""Phrases used only for cameras, in any spelling."""
_TOLD_CAMERA = re.compile(
    r"(?<![Aa] )(?<!\w)(?:the )?camera\s+(?:(?:slowly|quickly|gently|then|also|now)\s+)*(?:moves?|cuts?|goes|turns?"
    r"|faces?|frames?|shows?|reveals?|finds?|drops?"
    r"|lowers?|closes?|focus(?:es)?|settles?|stops?|sweeps?|glides?|travels?|pulls?|pushes|comes?|rises?|flies|looks?|shoots?|captures?|switches"
    r"|zooms?)\b(?:\s+(?:in|out|up|down|back|away|over|around|past|left|right|close))*",
    re.IGNORECASE,
)
_FOCUSED = re.compile(
    rf"(?:\b(?:in|with) )?(?:an? )?(?P<focus>{_SHALLOW}|(?:DEEP|SOFT) FOCUS)\b(?:,(?= (?:as|while|when|and)\b))?",
    re.IGNORECASE,
)
_FROM_BEHIND = re.compile(
    r"\b(?:seen|shown|shot|him|her|them|angle|view|close|on \w+),? from behind(?=\s*[.,;:]|\s*$)"
    r"|(?:\b(?:his|her|their|its|with)|['’]s) backs? (?:is |are )?(?:turned )?(?:to|towards?) "
    r"(?:us|(?:the )?(?:camera|viewer|reader|audience))\b",
    re.IGNORECASE,
)
_INSIDE = re.compile(rf"(?<![\w'’]){_HOW}(?:{_MOVE})(?![A-Za-z]){_WAY}")
_SPOKEN = re.compile(
    rf"\b(?:WE|(?:THE )?CAMERA)\s+(?:SLOWLY |QUICKLY |GENTLY |THEN |ALSO )*(?:{_SPOKEN_MOVE})(?![A-Za-z]){_WAY}",
    re.IGNORECASE,
)
_NOTE_PREFIX = re.compile(r"\s*(?:SHOT|CAMERA|ANGLE)\s*[:=-]\s*", re.IGNORECASE)
_JOIN = re.compile(r"\s*(?:(?:as|while|when|and|then|where)\b|[,;:.–—-])\s*", re.IGNORECASE)
_ARTICLE = re.compile(r"\A(?:the|a|an|his|her|their|its)\s+", re.IGNORECASE)
_TRAILING_JOIN = re.compile(r"[\s,;–—-]*\b(?:as|while|and|then)?[\s,;–—-]*$", re.IGNORECASE)


def parse_direction(sentence: str) -> tuple[CameraNote | None, Span]:
    """Find the camera direction of a sentence.

    Args:
        sentence: As written, with its capitals.

    Returns:
        The direction, or None; and the span of ``sentence`` that still tells action (empty where nothing is left).
    """
    for pattern in (_POINT_OF_VIEW, _SHOULDER, _LEAD, _LOOSE):
        if (match := pattern.match(sentence)) and match[0].strip():
            return _with_focus(sentence, *_parse_match(sentence, match, 0))
    match = _SPOKEN.search(sentence) or _TOLD_CAMERA.search(sentence) or _INSIDE.search(sentence)
    if match is None:
        return None, (0, len(sentence))
    before = _TRAILING_JOIN.sub("", sentence[: match.start()])
    note, after = _parse_match(sentence, match, match.start())
    return note, (0, len(before)) if len(before.split()) >= 2 else after


def _with_focus(sentence: str, note: CameraNote, left: Span) -> tuple[CameraNote, Span]:
    """Read what a direction says of the focus after its subject: ``CLOSE ON ANA, shallow focus.``"""
    match = None if note.focus else _FOCUSED.search(sentence)
    if match is None:
        return note, left
    said = _to_note(match["focus"].upper(), "", {}).focus
    note = replace(note, focus=said, subject=_FOCUSED.sub("", note.subject).strip(" ,"))
    before = sentence[left[0] : match.start()]
    return note, left if re.search(r"\w", before) else _action_span(sentence, max(left[0], match.end()))


def both_directions(first: CameraNote, second: CameraNote) -> CameraNote | None:
    """Return two directions as one, if one of them is about the focus alone: ``CLOSE ON ANA. Rack focus to Ben.``

    Args:
        first: The direction that the script has first.
        second: The direction after it.

    Returns:
        None if neither is about the focus alone, or both name a focus.
    """
    for camera, other in ((first, second), (second, first)):
        if other.focus and not (other.size or other.kind or other.angle or other.movement or camera.focus):
            phrase = ", ".join(filter(None, (first.phrase, second.phrase)))
            subject = camera.subject or other.subject
            return replace(camera, phrase=phrase, focus=other.focus, rack=other.rack, subject=subject)
    return None


def from_behind(words: str) -> bool:
    """Return whether words show a person from behind: ``seen from behind``, ``her back to camera``."""
    return _FROM_BEHIND.search(words) is not None


def without_direction(sentence: str) -> str:
    """Return a sentence without its camera direction: its action, else the subject the camera is pointed at."""
    note, (start, end) = parse_direction(sentence)
    if note is None:
        return sentence
    return sentence[start:end].strip() or note.subject


def parse_note(text: str) -> CameraNote | None:
    """Read a note ``SHOT: low angle on the door, slow push in``; None where the note does not speak to the camera."""
    prefix = _NOTE_PREFIX.match(text)
    if prefix is None:
        return None
    words = " ".join(text[prefix.end() :].split())
    loud = words.upper()
    opening = next((m for p in (_POINT_OF_VIEW, _SHOULDER, _LEAD) if (m := p.match(loud)) and m[0].strip()), None)
    note = _to_note(loud, words, opening.groupdict() if opening else {})
    if opening:
        start = re.compile(_LINK).match(loud, opening.end())
        note = replace(note, subject=_subject(words, start.end() if start else opening.end())[0])
    elif not any((note.size, note.kind, note.angle, note.movement)):
        note = replace(note, subject=words)
    return replace(note, rack=note.subject) if note.focus == "rack" else note


def meaning_of_term(term: str) -> dict[str, str]:
    """Return what a camera term sets, by field of ``CameraNote``; nothing if the words are not just that term.

    Args:
        term: ``cowboy shot``, ``crane``, ``Nahaufnahme``; in any spelling.
    """
    fields = ("size", "angle", "movement")
    for pattern, meant in _MEANINGS:
        if re.fullmatch(pattern, term.upper()):
            return {field: str(value) for field, value in meant.items() if field in fields}
    return {}


def _parse_match(sentence: str, match: re.Match[str], start: int) -> tuple[CameraNote, Span]:
    """Read the matched phrase, what it points at, and what is left to act."""
    link = re.compile(_LINK, re.IGNORECASE).match(sentence, match.end())
    end = link.end() if link else match.end()
    note = _to_note(match[0].upper(), sentence[start:end].strip(" :-–—"), match.groupdict())
    if end == match.end() or sentence[match.end() : end].strip() in (".", ","):
        return note, _action_span(sentence, end)
    subject, left = _subject(sentence, end)
    return replace(note, subject=subject, rack=subject if note.focus == "rack" else ""), left


def _subject(sentence: str, start: int) -> tuple[str, Span]:
    """Return the noun phrase that starts there, and the span of the action that follows it.

    A participle or a verb right after the noun keeps the noun: in ``CLOSE ON NORA opening the letter`` it is Nora who
    acts. After ``as``, a colon or a full stop a new clause begins.
    """
    ending = _subject_ends().search(sentence, start)
    end = ending.start() if ending else len(sentence)
    subject = _ARTICLE.sub("", sentence[start:end].strip())
    if len(subject.split()) > 7:
        return "", (start, len(sentence))
    join = _JOIN.match(sentence, end)
    rest = join.end() if join else end
    if re.match(r"\s*\w+ing\b", sentence[rest:]) or (join is None and sentence[end:].strip()):
        rest = start
    return subject, _action_span(sentence, rest)


@cache
def _subject_ends() -> re.Pattern[str]:
    """Return the pattern of what ends a subject; compiled at its first use, since it has every verb in it."""
    nouns = lexicon.PROPS | lexicon.SET_PIECES | lexicon.BODY
    verbs = "|".join(f"{verb}e?s" for verb in lexicon.VERBS if verb not in nouns)
    return re.compile(
        r"\s*[.;!?]|\s*:|\s+[-–—]+\s|,|\s+(?=(?:as|while|when|who|where|and then|is|are)\b|\w{3,}ing\b)"
        rf"|\s+(?=(?:{verbs})\b(?!['’]))"
    )


def _action_span(sentence: str, start: int) -> Span:
    """The span from there on, empty where only punctuation is left."""
    join = _JOIN.match(sentence, start)
    start = join.end() if join else start
    words = sentence[start:]
    if not re.search(r"\w", words):
        return len(sentence), len(sentence)
    return start + len(words) - len(words.lstrip()), len(sentence)


def _to_note(loud: str, phrase: str, names: dict[str, str | None]) -> CameraNote:
    note = CameraNote(phrase=phrase)
    who = names.get("before") or names.get("owner") or names.get("after")
    words = loud.replace(who.upper(), "") if who else loud
    for pattern, fields in _MEANINGS:
        if not re.search(rf"(?<![A-Z])(?:{pattern})(?![A-Z])", words):
            continue
        for field, value in fields.items():
            if not getattr(note, field):
                setattr(note, field, value)
    if note.movement not in ("pan", "tilt", "pedestal", "truck", "track", "orbit"):
        note.direction = ""
    note.who = (who or "").strip(" .'’")
    return note

"""Lines of a screenplay page: emphasis, cues (names above speeches), and series of shots with their items."""

from __future__ import annotations

import re

_CONTINUED = re.compile(r"\s*\b(?:CONT['’]?D|CONTINUED|CONTINUING)\b\.?\s*", re.IGNORECASE)
_CAMERA_LEAD = re.compile(r"(?:CLOSE|EXTREME|WIDE|INSERT|ANGLE|POV|TRACKING|BACK TO SCENE|INTERCUT|MONTAGE)\b")
_EMPHASIS = re.compile(
    r"(?<!\\)(?P<stars>\*{1,3})(?=[^\s*])(?P<starred>[^\n]{0,400}?[^\s\\*])(?P=stars)"
    r"|(?<![\\\w])_(?=\S)(?P<lined>[^\n]{0,400}?[^\s\\])_(?!\w)"
)
_UNDERLINED = re.compile(r"([_*]{1,3})(?=[^\s_*])([^_*\n]+)\1(\s*\([^)\n]*\))?")
"""A whole line in emphasis, or all but a bracket at its end."""


def plain_line(words: str) -> str:
    """Return a line without the emphasis that goes around it: ``_INT. ROOM - DAY_``."""
    whole = _UNDERLINED.fullmatch(words) if words[:1] in ("_", "*") else None
    return whole[2] + (whole[3] or "") if whole else words


def strip_emphasis(text: str) -> str:
    """Return ``text`` without ``*``, ``**``, ``***`` and ``_`` markup; escaped marks become themselves."""
    previous = None
    while text != previous:
        previous = text
        text = _EMPHASIS.sub(lambda match: match["starred"] or match["lined"], text)
    return re.sub(r"\\([*_])", r"\1", text)


def split_cue(cue: str) -> tuple[str, str, bool]:
    """Return the name, the extension without CONT'D in capitals, and whether it is a dual-dialogue cue."""
    name = cue.strip()
    dual = name.endswith("^")
    name = name.removesuffix("^").rstrip()
    extensions: list[str] = []
    while name.endswith(")") and (opening := name.rfind("(")) > 0:
        extensions.insert(0, _CONTINUED.sub("", name[opening + 1 : -1]).strip())
        name = name[:opening].rstrip()
    return name, ", ".join(part.upper() for part in extensions if part), dual


def looks_like_cue(words: str) -> bool:
    """Return whether a line is a name in capitals, with or without brackets behind it."""
    name = split_cue(words[:120])[0]
    letters = [letter for letter in name if letter.isalpha()]
    if not letters or name != name.upper() or len(name) > 60 or _CAMERA_LEAD.match(name) or " - " in name:
        return False
    if name.endswith((":", "!", "?", "...", "…")) or (name.endswith(".") and len(name.split()[-1]) > 4):
        return False
    caseless = all(letter.lower() == letter.upper() for letter in letters)
    return not caseless or (len(name) <= 12 and not re.search(r"[。，！？、；：]", name))


_NAMES = (
    r"MONTAGE|SERIES OF SHOTS|QUICK CUTS|SERIE DE PLANOS|SECUENCIA DE MONTAJE|MONTAJE|S[ÉE]RIE DE PLANS"
    r"|BILDFOLGE|MONTAGGIO"
)
_OPENS = re.compile(rf"(?:BEGIN |START |A |THE )?(?:[A-Z'’ -]{{0,40}}\b)?(?:{_NAMES})\b(?:\s*[-–—:(.].*|\s*$)")
_CLOSES = re.compile(
    rf"(?:END(?: OF)?|FIN(?: DE LA| DEL| DE| DU)?|ENDE(?: DER)?|FINE)\s+(?:[A-Z'’ -]{{0,40}}\b)?(?:{_NAMES})\b.*"
    rf"|BACK TO SCENE\W*"
)
_ITEM = re.compile(r"(?:--?|[–—•*·]|\(?[A-Z]\)|\(?[a-z]\)|[A-Z]\.(?=\s[A-Z])|\(?\d{1,2}[.)])\s*(?=\S)")


def opens_series(words: str) -> bool:
    """Return whether a line says that a series of shots begins: ``BEGIN MONTAGE -- "SCHOOL"``, ``SERIE DE PLANOS:``."""
    return _OPENS.fullmatch(words) is not None and not closes_series(words)


def closes_series(words: str) -> bool:
    """Return whether a line says that a series of shots ends."""
    return _CLOSES.fullmatch(words) is not None


def item_mark(words: str) -> int:
    """Return the length of the mark before an item of a list, ``--`` or ``A)``; 0 where a line has none."""
    match = _ITEM.match(words)
    return match.end() if match else 0

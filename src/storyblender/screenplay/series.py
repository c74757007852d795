"""Series of shots: the lines that begin and end one, and the mark before each of its items."""

from __future__ import annotations

import re

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

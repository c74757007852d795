"""Asset ids: snake_case ASCII, always valid, never twice."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Container

_LATIN = [chr(code) for code in (*range(0xC0, 0x250), *range(0x1E00, 0x1F00)) if chr(code).isalpha()]
UPPER = "A-Z" + "".join(letter for letter in _LATIN if letter.isupper())
"""Latin capitals of all languages, for a character class: Ł and Ō as well as É."""
LOWER = "a-zʿʾʻ" + "".join(letter for letter in _LATIN if letter.islower())
"""Latin small letters of all languages, and the marks that transcribe Arabic."""

LONGEST = 48
"""Characters of an id before its number; a name of the graph has 64 at most."""
_NO_DECOMPOSITION = str.maketrans({"ß": "ss", "æ": "ae", "œ": "oe", "ø": "o", "ł": "l", "đ": "d", "ð": "d", "þ": "th"})


def unaccented(name: str) -> str:
    """A name in small ASCII letters, what cannot be spelled in them left out: ``Łucja`` -> ``lucja``."""
    lowered = name.lower().translate(_NO_DECOMPOSITION)
    return unicodedata.normalize("NFKD", lowered).encode("ascii", "ignore").decode()


def asset_id(name: str, taken: Container[str] = ()) -> str:
    """Make the id of a person or thing from its name: ``Élodie`` -> ``elodie``, ``MAN #2`` -> ``man_2``.

    Args:
        name: As written in the script; a leading article is left out.
        taken: Ids in use; the first free ``name_2``, ``name_3``, ... is given when the plain one is among them.

    Returns:
        An identifier that starts with a letter; ``asset`` where nothing of the name can be spelled in ASCII.
    """
    words = re.findall(r"[a-z0-9]+", re.sub(r"(?<=[a-z])'s?\b", "", unaccented(name)))
    if len(words) > 1 and words[0] in ("the", "a", "an"):
        words = words[1:]
    base = "_".join(words) or "asset"
    if base[0].isdigit():
        base = f"asset_{base}"
    base = base[:LONGEST].rstrip("_")
    candidate, count = base, 1
    while candidate in taken:
        count += 1
        candidate = f"{base}_{count}"
    return candidate

"""Words that can be read on a thing: ``a sign reads "CLOSED"``, ``a box marked FRAGILE``."""

from __future__ import annotations

import re
from typing import Final

_READS: Final = (
    r"(?:reads?|reading|says?|saying|marked|labell?ed|titled|entitled|bearing|spells?(?: out)?|spelling|written|printed"
    r"|scrawled|stencill?ed|lettered|inscribed|with the words?|the words?|stamped|embroidered|painted)"
)
_QUOTED: Final = r"[\"“‘'](?P<quoted>[^\"”\n]{1,90}?)[\"”’'](?![^\W\d_])"
_CAPITALS: Final = r"(?P<capitals>[A-Z0-9][A-Z0-9'’&!?-]*(?: [A-Z0-9'’&!?-]+){0,7})\b(?![a-z])"
_SAID, _BIG = _QUOTED.replace("quoted", "said"), _CAPITALS.replace("capitals", "big")
_WRITTEN: Final = re.compile(
    rf"^[^.!?\n\"“”]{{0,60}}?\b{_READS}\b[^.!?\n\"“”‘]{{0,24}}?[:,]?\s*(?:{_QUOTED}|{_CAPITALS})"
    rf"|^[^.!?\n\"“”,;]{{0,30}}?(?::|—|--)\s*(?:{_SAID}|{_BIG})"
)
_REACH: Final = 170
"""Characters after a thing's name that are searched for its writing."""


def writing_on(name: str, first: int, text: str) -> str:
    """Return the words that the script puts on a thing at its first mention, or an empty string.

    Args:
        name: The name of the thing, as written.
        first: Offset of its first mention.
        text: The script.
    """
    at = text.find(name.split()[-1], first) if name.split() else -1
    if at < 0 or at - first > _REACH:
        return ""
    found = _WRITTEN.match(text[at + len(name.split()[-1]) : at + _REACH].lstrip("s"))
    words = next((group for group in found.group("quoted", "capitals", "said", "big") if group), "") if found else ""
    return words.strip(" ,.") if len(words.strip(" ,.")) > 1 else ""

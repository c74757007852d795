"""Which language a page is written in, told by its small words."""

from __future__ import annotations

import re
from typing import Final

from storyblender.agents.director import lexicon

NAMES: Final = {
    "german": "German",
    "spanish": "Spanish",
    "french": "French",
    "italian": "Italian",
    "portuguese": "Portuguese",
}
_ENOUGH: Final = 12
"""Small words that a page needs to tell its language."""
_MORE: Final = 2.0
"""Times as many small words of another language as of English."""
_READ: Final = 6000
"""Characters that are looked at."""


def language_of(text: str) -> str:
    """Return ``English`` or another language that the lists of small words know, as a name in English."""
    words = re.findall(r"[^\W\d_]+", text[:_READ].lower())
    counts = {name: sum(word in small for word in words) for name, small in lexicon.SMALL_WORDS.items()}
    best = max(NAMES, key=lambda name: counts[name])
    if counts[best] < _ENOUGH or counts[best] < _MORE * counts["english"]:
        return "English"
    return NAMES[best]

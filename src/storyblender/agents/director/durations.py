"""How long the words of a script last on screen, in seconds."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Final

from storyblender.agents.director.draft import ShotDraft
from storyblender.memory.outline import WORDS_PER_SECOND, word_count

SHORTEST_SHOT: Final = 1.5
LONGEST_ACTION: Final = 8.0
SHORTEST_ESTABLISHING: Final = 3.0
"""An establishing shot stays at least this long: the eye needs it to read a place."""
_PAUSE: Final = re.compile(r"\b(?:beat|pause|silence|long)\b", re.IGNORECASE)
_BRACKETS: Final = re.compile(r"\([^)]*\)")


@lru_cache(maxsize=8192)
def speech_seconds(text: str, parenthetical: str = "") -> float:
    """Return how long a speech takes to say; ``(beat)`` adds a second.

    Args:
        text: The words.
        parenthetical: The bracket before them; empty for none.
    """
    pause = 1.0 if _PAUSE.search(parenthetical) else 0.0
    return max(SHORTEST_SHOT, word_count(text) / WORDS_PER_SECOND + 0.4 + pause)


@lru_cache(maxsize=8192)
def action_seconds(text: str) -> float:
    """Return the seconds that a sentence of action takes to play; words in brackets take no time."""
    return min(LONGEST_ACTION, max(SHORTEST_SHOT, 0.2 * word_count(_BRACKETS.sub(" ", text)) + 0.5))


def shot_seconds(shot: ShotDraft, text: str) -> float:
    """Return the seconds that a shot lasts.

    Args:
        shot: The shot; dual dialogue in it overlaps the speech before.
        text: The script.
    """
    total = last = 0.0
    for beat in shot.beats:
        words = text[beat.start : beat.end]
        if beat.unit.kind == "action":
            last = action_seconds(words)
        else:
            previous, last = last, speech_seconds(words, beat.unit.parenthetical)
            if beat.unit.dual:
                total -= min(previous, last)
        total += last
    return max(total, SHORTEST_ESTABLISHING if shot.kind == "establishing" else SHORTEST_SHOT)


def frame_count(seconds: float, fps: int) -> int:
    """Return seconds as whole frames at ``fps`` frames a second, at least one."""
    return max(1, round(seconds * fps))

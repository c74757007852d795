"""What the name of a motion clip says, word by word, and how alike two words are in what they come from."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Final

_WORD: Final = re.compile(r"[A-Z]+(?=[A-Z][a-z])|[A-Z]?[a-z]+|[A-Z]+")
_SAYS_NOTHING: Final = frozenset(
    ("take", "anim", "animation", "action", "clip", "motion", "mocap", "mixamo", "com", "bvh", "fbx", "final",
     "export", "exported", "retargeted", "inplace", "place", "in", "cycle", "loop", "looping", "fps", "the", "a",
     "an", "of", "with", "and", "to", "at", "on", "v", "x", "subject", "sub", "skeleton", "rig", "char", "character",
     "male", "female", "man", "woman", "armature", "layer", "base")
)  # fmt: skip
_ENDINGS: Final = (
    "ments", "ment", "ations", "ation", "ings", "ing", "edly", "ily", "ly", "iness", "ness", "ies", "ied", "ed", "es",
    "s", "e", "y",
)  # fmt: skip


def words_of_clip(name: str) -> tuple[str, ...]:
    """Return the words of a name that say something, lower-case.

    Args:
        name: Such as ``AngryArgument_02``; of a path its folders count as well.
    """
    words = [word.lower() for word in _WORD.findall(name)]
    return tuple(word for word in words if len(word) > 1 and word not in _SAYS_NOTHING)


@lru_cache(maxsize=50_000)
def stem(word: str) -> str:
    """Return what forms of a word share: ``argues``, ``arguing`` and ``argument`` are ``argu``."""
    for ending in _ENDINGS:
        if word.endswith(ending) and len(word) - len(ending) >= 3:
            rest = word[: -len(ending)]
            rest = f"{rest[:-1]}y" if rest[-1] == "i" else rest
            return rest[:-1] if len(rest) > 3 and rest[-1] == rest[-2] and rest[-1] not in "aeiou" else rest
    return word

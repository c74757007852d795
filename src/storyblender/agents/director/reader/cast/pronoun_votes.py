"""Whether a story calls somebody ``he`` or ``she``, before anybody knows who is meant where."""

from __future__ import annotations

import re
from functools import lru_cache

from storyblender.agents.director import lexicon


@lru_cache(maxsize=1024)
def gender_told(told: str, called: str) -> str:
    """The gender of ``he`` or ``she`` in a sentence that somebody opens, or at the start of the one after it.

    Args:
        told: The script without what is said.
        called: A pattern for the name or noun, a group.
    """
    votes = {"male": 0, "female": 0}
    for match in re.finditer(
        rf"(?:^|[.!?\n]\s*){called}\s([a-z][^.!?\nA-Z]*)(?:[.!?] {{1,2}}(He|She)\b|[.!?\n]|$)", told
    ):
        words = [*re.findall(r"\w+", match.group(1).lower())[:12], (match.group(2) or "").lower()]
        kind = next((lexicon.PRONOUNS[word] for word in words if word in ("he", "she")), "")
        if kind in votes:
            votes[kind] += 1
    for match in re.finditer(rf"\b{called}[.!?,]\s+(He|She)\b", told):
        votes["male" if match.group(1) == "He" else "female"] += 1
    if votes["male"] == votes["female"]:
        return "unknown"
    return max(votes, key=lambda kind: votes[kind])

"""Facts in the words of an action: in whose company it is done, out of a vehicle, on the wing."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Final

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.motions import MOTIONS
from storyblender.memory.shot_context import CharacterAction

_OUT: Final = re.compile(
    r"\b(gets?|got|climbs?|climbed|steps?|stepped|jumps?|jumped|hops?|slides?|slid|scrambles?)\b.{0,30}\b(out|off|down)\b"
    r"|\b(alights?|emerges?|emerged|exits?|exited)\b",
    re.IGNORECASE,
)
_FLIGHT: Final = re.compile(r"flies|flew|flying|fly\b|soars|swoops|flutters|hovers|takes off", re.IGNORECASE)


def with_facts(action: CharacterAction, names: Mapping[str, str]) -> CharacterAction:
    """Return an action with the facts that its words state.

    Args:
        action: With the script's words as description.
        names: Display names of the people on stage, by asset id.
    """
    words = action.action_description
    facts = {
        "company": _company(action, names),
        "gets_out": MOTIONS[action.motion].speed is not None and _OUT.search(words) is not None,
        "flies": _FLIGHT.search(words) is not None,
    }
    return action.model_copy(update=facts) if any(facts.values()) else action


def _company(action: CharacterAction, names: Mapping[str, str]) -> tuple[str, ...]:
    """Return the people named after ``with``: ``stands at the piano with the two soldiers``."""
    named = re.search(r"\bwith (.+)", action.action_description.lower())
    words = {noun_key(word) for word in re.findall(r"[^\W\d_]+", named[1])} if named is not None else set[str]()
    found: list[str] = []
    for asset_id, name in names.items():
        own = [noun_key(word) for word in re.findall(r"[^\W\d_]+", name)]
        if asset_id != action.asset_id and words & {*own[:1], *own[-1:]}:
            found.append(asset_id)
    return tuple(found)

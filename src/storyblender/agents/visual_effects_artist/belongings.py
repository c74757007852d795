"""What people have with them before anybody saw them take it. Pure."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from storyblender.catalog.motions import clip_of
from storyblender.memory.shot_context import CharacterAction, ShotContext


def brought_along(shots: Sequence[ShotContext]) -> list[str]:
    """Return what comes out of a pocket, and what is in a hand before anybody handled it or looked at it.

    Args:
        shots: Of one scene, in order.
    """
    found: dict[str, None] = {}
    seen: set[str] = set()
    for shot in shots:
        changes = shot.asset_modifications
        found |= {change.asset_id: None for change in changes if change.modification_type == "add"}
        in_hand = [prop for state in shot.states for prop in state.held]
        found |= {prop: None for prop in in_hand if prop not in seen}
        seen |= {*in_hand, *shot.camera_instruction.focus_on_ids}
        seen |= {name for action in shot.character_actions for name in (action.prop_id, action.target_id) if name}
    return list(found)


def players_of(shots: Sequence[ShotContext], prop_of: Callable[[CharacterAction], str | None]) -> dict[str, str]:
    """Return who plays a carried instrument that nobody handled before, and which.

    Args:
        shots: Of one scene, in order.
        prop_of: The thing that an action handles.
    """
    players: dict[str, str] = {}
    handled: set[str] = set()
    for action in (each for shot in shots for each in shot.character_actions):
        prop = prop_of(action)
        if prop is not None and prop not in handled and clip_of(action.motion).key == "play_piano":
            players[action.asset_id] = prop
        handled |= {prop} if prop is not None else set()
    return players

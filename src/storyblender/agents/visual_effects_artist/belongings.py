"""Props that people have with them before the audience sees them take anything."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from storyblender.memory.shot_context import CharacterAction, ShotContext

PLAYED = frozenset({"play_piano", "play_guitar", "violin", "flute", "trumpet"})
"""Motions with an instrument, which may be carried."""


def find_props_brought_along(shots: Sequence[ShotContext]) -> list[str]:
    """Return the asset ids of props taken out of clothes, or in a hand before anyone handled or looked at them.

    Args:
        shots: All shots of one scene, in order.
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


def find_instrument_players(
    shots: Sequence[ShotContext], prop_of: Callable[[CharacterAction], str | None]
) -> dict[str, str]:
    """Return the carried instrument that each player has from the first frame on, by the player's asset id.

    Args:
        shots: All shots of one scene, in order.
        prop_of: Returns the asset id of the prop that an action handles.
    """
    players: dict[str, str] = {}
    handled: set[str] = set()
    for action in (each for shot in shots for each in shot.character_actions):
        prop = prop_of(action)
        if prop is not None and prop not in handled and action.motion in PLAYED:
            players[action.asset_id] = prop
        handled |= {prop} if prop is not None else set()
    return players

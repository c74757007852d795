"""What people have with them, so that it is not to be seen before they come. Pure."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.memory.shot_context import ShotContext


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

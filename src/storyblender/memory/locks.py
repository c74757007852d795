"""What can be locked, and which fields of the graph each lock holds."""

from __future__ import annotations

from typing import Final, Literal

ShotLock = Literal["camera", "blocking", "duration"]
SceneLock = Literal["layout", "light", "set"]
StaleWork = SceneLock | Literal["motion"]
"""What the crew makes anew of a scene; ``motion``: people, light and cameras, in the layout as it is."""
LockName = Literal["camera", "blocking", "duration", "layout", "light", "set", "asset"]

SHOT_LOCKS: Final[dict[ShotLock, tuple[str, ...]]] = {
    "camera": ("camera", "camera_instruction", "camera_decision"),
    "blocking": ("blocking", "cues", "prop_states", "blocking_decision", "motion_by_hand"),
    "duration": ("duration", "decided_duration"),
}
SCENE_LOCKS: Final[dict[SceneLock, tuple[str, ...]]] = {
    "layout": ("layout", "layout_decision"),
    "light": ("lighting", "light_decision"),
    "set": ("environment", "set_decision"),
}

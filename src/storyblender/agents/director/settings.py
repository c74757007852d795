"""What the user may ask of the Director."""

from __future__ import annotations

from pydantic import Field

from storyblender.memory.base import Frozen


class DirectorSettings(Frozen):
    """How finely a script is cut into shots."""

    shots_per_scene: int | None = Field(default=4, ge=1)
    """What to aim at (the paper's stories have 3 to 5); None cuts every beat. A scene may need more: directions in the
    script are never dropped, and no joined shot grows beyond the two limits below."""
    longest_talk: float = Field(default=14.0, gt=1.5)
    """Seconds of talk that may share one shot; a single long speech may still exceed it."""
    longest_action: float = Field(default=9.0, gt=1.5)
    """Seconds of action, or of action and talk, that may share one shot."""
    fps: int = Field(default=24, ge=1)

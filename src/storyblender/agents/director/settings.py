"""What the user may ask of the Director."""

from __future__ import annotations

from pydantic import Field

from storyblender.memory.base import Frozen


class DirectorSettings(Frozen):
    """How finely a script is cut into shots."""

    shots_per_scene: int | None = Field(default=4, ge=1)
    """What to aim at; None cuts every beat. A scene may need more: directions in the script are never dropped, and
    no shot grows beyond ``longest_shot``."""
    longest_shot: float = Field(default=14.0, gt=1.5)
    """Seconds a shot may last once shots are joined; a single long speech may still exceed it."""
    fps: int = Field(default=24, ge=1)

"""What a person animated by hand in Blender: it lies over the motion that is acted, channel by channel.

A project keeps it in a file that is named by its content, and the shot names the content: so undo, redo and a second
project on the same file mean the same motion.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Final, Self

from pydantic import Field, StringConstraints, model_validator

from storyblender.memory.base import Coordinate, Digest, Frames, Frozen, Identifier, ShotId, content_hash

ROOT, HIPS_PLACE, PLACE, TURN = "root", "hips_place", "place", "turn"
"""Channels beside the bones: x, y, z (m) and yaw (rad) of a person, where the hips are; place and turn of a thing."""
_WIDTHS: Final = {ROOT: 4, HIPS_PLACE: 3, PLACE: 3}
"""Values of a key; those of a turn, and of a bone, are w, x, y, z of a quaternion."""
ChannelName = Annotated[str, StringConstraints(pattern=r"^[a-z][a-z0-9_]{0,30}(\.[LR])?$")]
"""One of the above, or a bone such as ``hand.L``."""


class HandChannel(Frozen):
    """Keys of one channel, linear between, the first and the last of them held."""

    frames: tuple[Frames, ...] = Field(min_length=1)
    """From the start of the shot."""
    values: tuple[tuple[Coordinate, ...], ...]
    """Of each key."""

    @model_validator(mode="after")
    def _is_whole(self) -> Self:
        if len(self.frames) != len(self.values) or any(a >= b for a, b in pairwise(self.frames)):
            raise ValueError("every key has a frame, one after the other, and values")
        return self


class MotionByHand(Frozen):
    """The channels of one person or thing in one shot; those that are not named are acted."""

    channels: dict[ChannelName, HandChannel] = Field(min_length=1, max_length=100)

    @model_validator(mode="after")
    def _is_whole(self) -> Self:
        for name, channel in self.channels.items():
            if any(len(values) != _WIDTHS.get(name, 4) for values in channel.values):
                raise ValueError(f"{name} has {_WIDTHS.get(name, 4)} values a key")
        return self

    @property
    def digest(self) -> str:
        """Names the content."""
        return content_hash(self)

    def then(self, later: Self) -> Self:
        """Return this motion with a later one on top."""
        return self.model_copy(update={"channels": {**self.channels, **later.channels}})


class HandMotion(Frozen):
    """The motion by hand of a character or a thing in a shot."""

    shot_id: ShotId
    """Of the scene that it goes with."""
    asset_id: Identifier
    """Who or what."""
    motion: MotionByHand
    """On top of what is acted."""


class HandMotionRead(Frozen):
    """What a .blend says that is otherwise than what is acted, for one object in one shot."""

    scene: str
    """Such as ``SC010``."""
    shot: str
    """Such as ``SC010_SH020``."""
    node_id: str
    """Of the object."""
    asset_id: Identifier
    """Of the object."""
    motion: MotionByHand
    """The channels that differ."""


def by_hand_file(digest: Digest) -> str:
    """Return the name in the project of the file with a motion by hand."""
    return f"by_hand/{digest}.json"

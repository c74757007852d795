"""A motion as a file has it: any skeleton, any units, any axes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from storyblender.errors import InputError
from storyblender.geometry.mocap import LONGEST, RATE
from storyblender.geometry.rotations import blended, continuous, matrices_of, quaternions_of
from storyblender.geometry.solids import Floats

MOST_JOINTS: Final = 600
MOST_FRAMES: Final = 200_000
_FASTEST: Final = 1000.0
"""Frames a second."""


@dataclass(frozen=True)
class SourceMotion:
    """A skeleton that moves; J joints, parents before children, N frames.

    Attributes:
        names: (J,) as in the file; ends of bones without a name are empty.
        parents: (J,) index of the joint above, -1 for a root.
        rest: (J, 3) places at rest, in the file's units and axes.
        turns: (N, J, 3, 3) orientations in the file's axes, from rest.
        places: (N, J, 3) of the joints.
        rate: Frames a second.
    """

    names: tuple[str, ...]
    parents: tuple[int, ...]
    rest: Floats
    turns: Floats
    places: Floats
    rate: float

    def children(self, joint: int) -> list[int]:
        """Return the joints below one."""
        return [index for index, parent in enumerate(self.parents) if parent == joint]

    def chain(self, joint: int) -> list[int]:
        """Return a joint and all above it, up to the root."""
        found = [joint]
        while self.parents[found[-1]] >= 0:
            found.append(self.parents[found[-1]])
        return found

    def checked(self) -> SourceMotion:
        """Return the motion. Raises InputError if it is none that can be used."""
        if len(self.names) > MOST_JOINTS or len(self.places) > MOST_FRAMES:
            raise InputError(f"it is too large: {len(self.names)} joints, {len(self.places)} frames")
        if len(self.places) < 2:
            raise InputError("it has no motion, only a pose")
        if not 1.0 <= self.rate <= _FASTEST:
            raise InputError(f"it cannot have {self.rate:g} frames a second")
        if not all(np.isfinite(array).all() for array in (self.rest, self.turns, self.places)):
            raise InputError("it has numbers that are not finite")
        return self

    def resampled(self) -> SourceMotion:
        """Return the motion at ``RATE`` poses a second, cut after ``LONGEST`` seconds."""
        seconds = min((len(self.places) - 1) / self.rate, LONGEST)
        at = np.arange(int(seconds * RATE + 1e-6) + 1) / RATE * self.rate
        low = np.minimum(at.astype(int), len(self.places) - 2)
        share = at - low
        if len(at) < 2:
            raise InputError("it is shorter than two frames of film")
        turns = continuous(quaternions_of(self.turns[: low[-1] + 2]))
        mixed = blended(turns[low], turns[low + 1], np.repeat(share[:, None], len(self.names), axis=1))
        places = self.places[low] * (1 - share)[:, None, None] + self.places[low + 1] * share[:, None, None]
        return SourceMotion(self.names, self.parents, self.rest, matrices_of(mixed), places, RATE)


def orientations(parents: tuple[int, ...], local: Floats) -> Floats:
    """Return orientations (N, J, 3, 3) of joints whose own turns (N, J, 3, 3) are in the frame of their parent."""
    whole = local.copy()
    for joint, parent in enumerate(parents):
        if parent >= 0:
            whole[:, joint] = whole[:, parent] @ local[:, joint]
    return whole

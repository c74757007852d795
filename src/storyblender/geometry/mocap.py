"""A recorded motion as numbers that fit every body: orientations from a T-pose, lengths in legs. Pure numpy.

The T-pose stands upright and faces -Y, +X to its left: arms along X with palms down, legs straight down, toes ahead.
A leg is hip joint to ankle, stretched. The solver brings these numbers onto a body (``blender/motion/mocap.py``).
"""

from __future__ import annotations

import hashlib
import io
from dataclasses import dataclass
from typing import Final, Self

import numpy as np
from numpy.typing import NDArray

from storyblender.geometry.solids import Floats

BONES: Final[tuple[str, ...]] = (
    "hips", "spine", "chest", "upper_chest", "neck", "head",
    "shoulder.L", "upper_arm.L", "forearm.L", "hand.L", "thigh.L", "shin.L",
    "shoulder.R", "upper_arm.R", "forearm.R", "hand.R", "thigh.R", "shin.R",
)  # fmt: skip
"""Bones of ``catalog.skeleton`` whose orientation is kept; feet and fingers are kept as angles."""
RATE: Final = 30.0
"""Poses a second."""
LONGEST: Final = 120.0
"""Seconds of a motion that are kept."""
_FINE: Final = 32767
_SHAPES: Final = {
    "root": (3,),
    "hips": (3,),
    "turns": (len(BONES), 4),
    "feet": (2, 3),
    "curls": (2, 3),
    "apart": (3,),
    "stands": (2,),
}
_LARGEST: Final = 1000.0


@dataclass(frozen=True)
class MocapPoses:
    """N poses, ``RATE`` of them a second; of pairs the left comes first.

    Attributes:
        root: (N, 3) path on the floor, x and y in legs, and yaw in radians, unwrapped; the first is 0, 0, 0.
        hips: (N, 3) middle of the hip joints in the frame of the root: aside and behind in legs, and the height over
            the ankle of a foot that stands flat.
        turns: (N, B, 4) orientations of ``BONES`` in the frame of the root, from the T-pose; w, x, y, z.
        feet: (N, 2, 3) yaw from the root in radians, pitch and pitch of the toes in degrees, > 0 with the toes up.
        curls: (N, 2, 3) degrees of index finger, other fingers, thumb.
        apart: (N, 3) from the right wrist to the left one in the frame of the chest, in legs.
        stands: (N, 2) whether the foot carries weight and does not slide.
        loops: Whether it may begin again where it ends.
    """

    root: Floats
    hips: Floats
    turns: Floats
    feet: Floats
    curls: Floats
    apart: Floats
    stands: NDArray[np.bool_]
    loops: bool = False

    @property
    def seconds(self) -> float:
        """Length."""
        return (len(self.root) - 1) / RATE

    @property
    def travel(self) -> float:
        """Legs on the floor from the first place to the last."""
        return float(np.hypot(*(self.root[-1, :2] - self.root[0, :2])))

    def save(self) -> bytes:
        """Return the motion as an archive of arrays; equal motions give equal bytes."""
        out = io.BytesIO()
        np.savez_compressed(out, **self._plain())
        return out.getvalue()

    @property
    def digest(self) -> str:
        """Names the content: 32 hex digits."""
        parts = (f"{name} {array.shape}".encode() + array.tobytes() for name, array in self._plain().items())
        return hashlib.sha256(b"\0".join(parts)).hexdigest()[:32]

    def _plain(self) -> dict[str, NDArray[np.generic]]:
        """Return the arrays as they are kept: orientations in 16 bits, the rest in 32."""
        arrays: dict[str, NDArray[np.generic]] = {
            name: np.ascontiguousarray(np.round(getattr(self, name), 5), "<f4") for name in _SHAPES if name != "stands"
        }
        arrays["turns"] = np.ascontiguousarray(np.round(self.turns * _FINE), "<i2")
        arrays["stands"] = np.ascontiguousarray(self.stands, np.uint8)
        arrays["loops"] = np.array([self.loops], np.uint8)
        return arrays

    @classmethod
    def load(cls, content: bytes) -> Self:
        """Return the motion of an archive.

        Raises:
            ValueError: It is none.
        """
        try:
            with np.load(io.BytesIO(content), allow_pickle=False) as data:
                arrays = {name: np.asarray(data[name], float) for name in _SHAPES}
                loops = bool(data["loops"].all())
        except (OSError, KeyError, EOFError, TypeError, MemoryError) as error:
            raise ValueError("it is no motion") from error
        except Exception as error:  # a damaged archive raises what zip and zlib raise
            raise ValueError("it is damaged") from error
        count = len(arrays["root"])
        whole = all(arrays[name].shape == (count, *shape) for name, shape in _SHAPES.items())
        if not whole or not 2 <= count <= LONGEST * RATE + 1:
            raise ValueError("its arrays do not fit together")
        if not all(np.isfinite(array).all() and np.abs(array).max() <= _FINE for array in arrays.values()):
            raise ValueError("it has numbers that cannot be")
        turns = arrays["turns"]
        lengths = np.linalg.norm(turns, axis=-1, keepdims=True)
        if (
            np.abs(lengths / _FINE - 1).max() > 0.01
            or max(np.abs(arrays[name]).max() for name in ("root", "hips", "apart")) > _LARGEST
        ):
            raise ValueError("it has numbers that cannot be")
        return cls(**arrays | {"turns": turns / _FINE, "stands": arrays["stands"] > 0}, loops=loops)

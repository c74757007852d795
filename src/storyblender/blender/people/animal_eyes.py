"""The eyes of an animal: large eyeballs on the eye bones, and lids with shape keys."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.people.face import Glint, bone_weights, eyeball
from storyblender.blender.people.sheet import Sheet, join, rigid_sheet
from storyblender.geometry.solids import Floats, skin_faces

_RINGS = ((0.0, 0), (0.3, 0), (0.31, 1), (0.62, 1), (0.63, 2), (0.7, 2), (0.71, 3), (1.0, 3), (1.5, 3), (2.0, 3))
"""Rings of the eyeball: angle from its axis (radians) and material slot: pupil, iris, rim, white."""
_AROUND = 20
_GLINT = Glint((-0.2, -1.0, 0.24), 0.11, 8)
_UPPER, _LOWER = (155.0, 56.0, -28.0), (-155.0, -60.0, -30.0)
"""Angles of a lid in degrees: its root, its edge when open, its edge when shut; 0 is straight ahead."""
LID_KEYS: dict[str, tuple[float, float]] = {
    "blink": (1.0, 1.0), "squint": (0.42, 0.8), "wide": (-0.3, -0.4), "smile": (0.0, 0.45), "brow_down": (0.22, 0.0),
    "worry": (0.1, 0.0), "grin": (0.1, 0.5),
}  # fmt: skip
"""Share by which each shape key closes the upper and the lower lid."""


def eyeballs(centers: dict[str, Floats], radius: float) -> Sheet:
    """Return both eyeballs; slots: 0 pupil, 1 iris, 2 rim, 3 white, 4 glint.

    Args:
        centers: Middle of each, (3,) metres, by side ``L`` and ``R``.
        radius: Metres.
    """
    return join([eyeball(centers[side], [radius] * len(_RINGS), side, _RINGS, _AROUND, _GLINT) for side in "LR"])


def eyelids(center: Floats, radius: float) -> tuple[Sheet, dict[str, Floats]]:
    """Return the upper and the lower lid of an eyeball and, by key, the offsets (V, 3) of their shape keys, metres.

    Args:
        center: Middle of the eyeball, (3,) metres.
        radius: Of the eyeball, metres.
    """
    sheets, moves = [], []
    for number, lid in enumerate((_UPPER, _LOWER)):
        open_, shut = _shell(lid, 0.0) * radius * 1.08, _shell(lid, 1.0) * radius * 1.08
        faces = skin_faces(len(open_), open_.shape[1], False)
        sheets.append(rigid_sheet(center + open_.reshape(-1, 3), faces, bone_weights("head")))
        moves.append(((shut - open_).reshape(-1, 3), number))
    keys = {key: np.concatenate([move * shares[number] for move, number in moves]) for key, shares in LID_KEYS.items()}
    return join(sheets), keys


def _shell(lid: tuple[float, float, float], shut: float) -> Floats:
    """Return the rows of a lid on the unit sphere, (rows, columns, 3), from its root to its edge."""
    root, edge = math.radians(lid[0]), math.radians(lid[1] + (lid[2] - lid[1]) * shut)
    turns = np.linspace(root, edge, 9)[:, None]
    across = np.radians(np.linspace(-84, 84, 13))[None]
    flat = np.cos(across) * np.ones_like(turns)
    return np.stack([np.sin(across) * np.ones_like(turns), -flat * np.cos(turns), flat * np.sin(turns)], -1)

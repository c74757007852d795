"""The measured body that the motion solver works with: skeleton, skin and weights of one person.

Saved beside the person's cached geometry as a numpy archive.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np

from storyblender.geometry.solids import Floats


@dataclass(frozen=True)
class RiggedBody:
    """A person at rest (A-pose), armature space: metres, Z up, facing -Y, soles at z = 0.

    Attributes:
        bone_names: (B,) in the order of the armature's bones.
        parents: (B,) index of each bone's parent, -1 for the root (``hips``).
        rest: (B, 4, 4) rest matrices (``bone.matrix_local``).
        heads: (B, 3) joint positions.
        tails: (B, 3).
        stature: Metres, barefoot crown height.
        vertices: (V, 3) rest positions of the body's skin.
        weights: (V, B) skin weights in the order of ``bone_names``; rows sum to 1.
        shape_keys: Names of the face's shape keys.
    """

    bone_names: tuple[str, ...]
    parents: tuple[int, ...]
    rest: Floats
    heads: Floats
    tails: Floats
    stature: float
    vertices: Floats
    weights: Floats
    shape_keys: tuple[str, ...]

    def save(self, part: Path) -> None:
        """Write the archive to a file."""
        arrays = {field.name: np.asarray(getattr(self, field.name)) for field in fields(self)}
        single = {name: arrays[name].astype(np.float32) for name in ("vertices", "weights")}
        np.savez_compressed(part, **(arrays | single))

    @classmethod
    def load(cls, path: Path) -> RiggedBody:
        """Return the body of an archive."""
        with np.load(path, allow_pickle=False) as data:
            return cls(
                bone_names=tuple(str(name) for name in data["bone_names"]),
                parents=tuple(int(parent) for parent in data["parents"]),
                rest=data["rest"],
                heads=data["heads"],
                tails=data["tails"],
                stature=float(data["stature"]),
                vertices=data["vertices"].astype(np.float64),
                weights=data["weights"].astype(np.float64),
                shape_keys=tuple(str(name) for name in data["shape_keys"]),
            )

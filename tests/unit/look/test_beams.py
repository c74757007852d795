"""A torch is seen as a beam in the air, along the way it shines."""

from __future__ import annotations

import numpy as np

from storyblender.look.atmosphere import add_halos
from storyblender.memory.scene_context import Light


def test_a_narrow_lamp_is_seen_as_a_beam_where_it_shines_and_nowhere_else() -> None:
    lamp = Light(name="torch", kind="SPOT", location=(0, 4, 0), target=(3, 4, 0), power=100, glow=1, cone=30, size=0.03)
    across = np.linspace(-3, 3, 61, dtype=np.float32)
    rays = np.zeros((1, 61, 3), np.float32)
    rays[0, :, 0], rays[0, :, 1] = across / 4, 1
    dark, depth = np.zeros((1, 61, 3), np.float32), np.full((1, 61), 8, np.float32)
    beam = add_halos(dark, [lamp], depth, rays, np.zeros(3))[0, :, 0]
    assert beam[across > 0.2].min() > 0 and beam[across < -0.6].max() < 1e-4
    lit = beam[across > 0.3]
    assert (np.diff(lit) < 0).all(), "fainter the farther it is, without steps"

"""Relief by normal maps: it turns with the lamp, adds no light where there is none, and leaves the rest alone."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.look.gbuffer import GBuffer, View
from storyblender.look.relief import emboss
from storyblender.memory.scene_context import Light

SIDE = 16


def wall(relief: np.ndarray | None) -> GBuffer:
    """Return a wall in the plane y = 0 that fills the view of a camera three metres before it."""
    axes = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
    view = View(np.array([0.0, -3.0, 1.0]), axes, SIDE, SIDE, 0.5, 0.5)
    normal = np.zeros((SIDE, SIDE, 3), np.float16)
    normal[..., 1] = -1
    flat = np.ones((SIDE, SIDE))
    table = np.zeros((2, 3), np.float32)
    return GBuffer(
        view, flat.astype(np.uint16), flat.astype(np.uint8), flat.astype(np.uint16), (3 * flat).astype(np.float32),
        normal, np.ones((SIDE, SIDE, 3), np.float16), table, table[:, 0], table[:, 0], table[:, 0], relief,
    )  # fmt: skip


def lamp(x: float) -> Light:
    return Light(name="lamp", kind="POINT", location=(x, -2.0, 1.0), power=2000.0)


def tilted() -> np.ndarray:
    """Return normals that lean to the left in the left half of the picture, with none in the lowest rows."""
    relief = np.zeros((SIDE, SIDE, 3), np.float16)
    relief[:-4] = (0, -1, 0)
    relief[:-4, : SIDE // 2] = (-0.5, -0.866, 0)
    return relief


@pytest.mark.parametrize("step", [1, 2])
def test_what_leans_to_the_lamp_is_lighter_and_what_leans_away_is_darker(step: int) -> None:
    half, rows = SIDE // step // 2, (SIDE - 4) // step
    for x, lighter in ((-6.0, True), (6.0, False)):
        light = np.ones((SIDE // step, SIDE // step, 3), np.float32)
        emboss(light, wall(tilted()), [lamp(x)])
        assert (light[:rows, :half] > 1.02).all() if lighter else (light[:rows, :half] < 0.98).all()
        assert light[:rows, half:] == pytest.approx(1, abs=1e-3), "level relief is as it was"
        assert (light[rows:] == 1).all(), "no map, no relief"


def test_darkness_stays_dark_and_a_frame_without_maps_is_left_alone() -> None:
    light = np.zeros((SIDE, SIDE, 3), np.float32)
    emboss(light, wall(tilted()), [lamp(-2.0)])
    assert not light.any()
    light = np.random.default_rng(1).random((SIDE, SIDE, 3)).astype(np.float32)
    before = light.copy()
    emboss(light, wall(None), [lamp(-2.0)])
    assert (light == before).all()

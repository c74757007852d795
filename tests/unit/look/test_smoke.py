"""Smoke is air: it thins out what is behind it, and nothing else."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.look.smoke import Puff, add_smoke, through_smoke
from storyblender.memory.scene_context import Light

EYE = np.zeros(3)
PUFF = Puff((0.0, 4.0, 0.0), 0.5, (0.7, 0.7, 0.7))
RAYS = np.array([[[0.0, 1.0, 0.0], [0.05, 1.0, 0.0], [0.6, 1.0, 0.0]]], np.float32)
"""Through the middle of the puff, near its edge, and past it."""
LAMP = Light(name="lamp", kind="POINT", location=(0, 0, 2), power=60.0, color=(1.0, 0.7, 0.4))


def through(puffs: list[Puff], depth: float) -> list[float]:
    return through_smoke(puffs, np.full((1, 3), depth, np.float32), RAYS, EYE)[0].tolist()


def test_it_is_thickest_in_the_middle_and_nothing_beside() -> None:
    middle, edge, past = through([PUFF], 9.0)
    assert middle < edge < 0.999 < past


def test_what_stands_before_it_is_clear() -> None:
    assert through([PUFF], 2.0) == pytest.approx([1.0, 1.0, 1.0], abs=1e-3)
    assert through([PUFF], 4.0)[0] > through([PUFF], 9.0)[0], "who stands in it is half veiled"


def test_more_puffs_let_less_through() -> None:
    assert through([PUFF, PUFF], 9.0)[0] == pytest.approx(through([PUFF], 9.0)[0] ** 2, rel=1e-4)


def test_a_picture_without_smoke_stays() -> None:
    picture = np.random.default_rng(1).random((1, 3, 3)).astype(np.float32)
    assert add_smoke(picture, [], np.ones((1, 3)), [LAMP], 0.1) is picture


def test_thick_smoke_has_the_colour_of_the_light() -> None:
    drawn = add_smoke(np.zeros((1, 1, 3), np.float32), [PUFF], np.zeros((1, 1), np.float32), [LAMP], 0.1)[0, 0]
    assert drawn[0] > drawn[1] > drawn[2] > 0

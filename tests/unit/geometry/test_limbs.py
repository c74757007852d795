import numpy as np
import pytest

from storyblender.geometry.limbs import capsule_penetration


def _bone(*ends: tuple[float, float, float]) -> np.ndarray:
    return np.array([ends], dtype=float)


RADIUS = np.array([0.1])


@pytest.mark.parametrize(
    ("other", "depth"),
    [
        (_bone((0.15, 0, 0), (0.15, 0, 1)), 0.05),
        (_bone((0.3, 0, 0), (0.3, 0, 1)), 0.0),
        (_bone((-1, 0.05, 0.5), (1, 0.05, 0.5)), 0.15),
        (_bone((0, 0, 1.12), (0, 0, 2)), 0.08),
        (_bone((0.12, 0, 0.5), (0.12, 0, 0.5)), 0.08),
    ],
)
def test_depth_is_the_overlap_of_two_capsules(other: np.ndarray, depth: float) -> None:
    one = _bone((0, 0, 0), (0, 0, 1))
    assert capsule_penetration(one, RADIUS, other, RADIUS) == pytest.approx(depth, abs=1e-9)
    assert capsule_penetration(other, RADIUS, one, RADIUS) == pytest.approx(depth, abs=1e-9)


def test_distances_are_those_of_sampled_segments() -> None:
    rng = np.random.default_rng(5)
    steps = np.linspace(0, 1, 201)
    for _ in range(20):
        a, b = rng.normal(size=(1, 2, 3)), rng.normal(size=(1, 2, 3))
        one, other = (each[0, 0] * (1 - steps)[:, None] + each[0, 1] * steps[:, None] for each in (a, b))
        sampled = np.linalg.norm(one[:, None] - other[None], axis=-1).min()
        radius = np.array([5.0])
        assert 10.0 - capsule_penetration(a, radius, b, radius) == pytest.approx(sampled, abs=0.02)

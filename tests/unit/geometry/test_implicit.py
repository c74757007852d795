"""Surfaces of rounded bodies are closed, look outwards and have the size of the body."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.geometry.implicit import ellipsoid, melted, rod, surface
from storyblender.geometry.solids import signed_volume


def test_a_ball_has_its_volume_and_looks_outwards() -> None:
    points, faces = surface(ellipsoid((0.3, 0, 0), (1, 1, 1)), (-0.9, -1.2, -1.2), (1.5, 1.2, 1.2), 0.08)
    assert signed_volume(points, [tuple(face) for face in faces.tolist()]) == pytest.approx(4.19, rel=0.04)


def test_every_edge_lies_between_two_faces() -> None:
    form = melted([ellipsoid((0, 0, 0), (1, 0.8, 0.9)), rod((0, 0, 0), (0, -2, 0), (0.4, 0.2))], 0.2)
    _, faces = surface(form, (-1.3, -2.5, -1.3), (1.3, 1.2, 1.3), 0.1)
    edges = np.sort(np.concatenate([faces[:, [side, (side + 1) % 4]] for side in range(4)]), axis=1)
    _, counts = np.unique(edges, axis=0, return_counts=True)
    assert (counts == 2).all()


def test_melting_adds_a_fillet_only_near_the_seam() -> None:
    near, far = np.array([[0.0, 0.0, 1.0]]), np.array([[-2.2, 0.0, 0.0]])
    parts = [ellipsoid((-1, 0, 0), (1.1, 1.1, 1.1)), ellipsoid((1, 0, 0), (1.1, 1.1, 1.1))]
    whole = melted(parts, 0.5)
    assert whole(near)[0] < min(part(near)[0] for part in parts) - 0.05
    assert whole(far)[0] == pytest.approx(parts[0](far)[0])

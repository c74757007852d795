import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from storyblender.geometry import solids
from storyblender.geometry.canonical import convex_hull, polygon_area

LENGTH = st.floats(0.05, 5)


@given(st.tuples(LENGTH, LENGTH, LENGTH), st.floats(0, 0.25))
def test_a_chamfered_box_is_closed_and_as_large_as_asked(size, share):
    bevel = share * min(size)
    vertices, faces = solids.box(size, bevel)
    assert np.ptp(vertices, axis=0) == pytest.approx(size)
    volume = solids.signed_volume(vertices, faces)
    assert 0.5 * np.prod(size) < volume <= np.prod(size) * 1.0001
    edges = [edge for face in faces for edge in zip(face, (*face[1:], face[0]), strict=True)]
    assert sorted(edges) == sorted((b, a) for a, b in edges)


def test_a_tube_keeps_its_thickness_in_a_bend():
    rings = solids.tube_rings([(0, 0, 0), (1, 0, 0), (1, 1, 0)], 0.1, 16, closed=False)
    start = rings[0]
    assert np.linalg.norm(start - start.mean(axis=0), axis=1) == pytest.approx(0.1)
    along_x = rings[1] - rings[0]
    across = along_x - np.outer(along_x @ [1, 0, 0], [1, 0, 0])
    assert np.abs(across).max() < 1e-9  # the first leg is a true prism up to its mitre


def test_grain_runs_along_the_longer_side():
    vertices, faces = solids.box((0.1, 0.1, 2.0))
    layout = solids.box_uv(vertices, faces, grain=True).reshape(-1, 4, 2)
    side = layout[np.ptp(layout, axis=1).max(axis=1) > 1]
    assert (np.ptp(side[..., 0], axis=1) > 1.9).all()


def test_hull_and_area():
    square = np.array([(0, 0), (1, 0), (1, 1), (0, 1), (0.5, 0.5)], float)
    assert polygon_area(convex_hull(square)) == pytest.approx(1)


@pytest.mark.parametrize("size", [(1.0, 2.0, 3.0), (0.6, 0.012, 0.4), (0.008, 0.008, 1.0)])
def test_a_chamfered_box_faces_outwards_at_any_size(size):
    vertices, faces = solids.box(size, bevel=0.004)
    assert solids.signed_volume(vertices, faces) > 0
    for face in faces:
        points = vertices[list(face)]
        normal = np.cross(points, np.roll(points, -1, axis=0)).sum(axis=0)
        assert normal @ points.mean(axis=0) >= -1e-12


def test_texture_layout_keeps_the_order_of_mixed_faces():
    vertices = np.array([(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0), (0, 0, 3), (2, 0, 3)], float)
    faces = [(0, 1, 2, 3), (0, 3, 4), (0, 1, 5, 4)]
    expected = np.r_[vertices[[0, 1, 2, 3]][:, :2], vertices[[0, 3, 4]][:, 1:], vertices[[0, 1, 5, 4]][:, [0, 2]]]
    assert np.array_equal(solids.box_uv(vertices, faces, grain=False), expected)
    turned = solids.box_uv(vertices, faces, grain=True)
    assert np.array_equal(turned[:4], expected[:4]) and np.array_equal(turned[7:], expected[7:, ::-1])

from dataclasses import replace

import numpy as np
import pytest

from storyblender.geometry.framing import project
from storyblender.geometry.moves import ease_in_out, follow_subject, interpolate_cameras, move_camera
from storyblender.geometry.orbit import camera_around, camera_looking_at, dolly, orbit, pan, roll, swivel

CAMERA = camera_around((0.3, 1.0, 1.5), 30, 10, 4, 50)


def test_angles_go_in_and_come_out() -> None:
    camera = camera_around((0, 0, 1), -70, 25, 3, 35, roll=12)
    assert (camera.azimuth, camera.elevation, camera.roll) == pytest.approx((-70, 25, 12))


def test_azimuth_zero_is_the_audience_and_the_picture_is_upright() -> None:
    camera = camera_around((0, 0, 1), 0, 0, 3, 35)
    assert camera.position == pytest.approx([0, -3, 1])
    screen, _ = project(camera, [(0.5, 0, 1), (0, 0, 1.5)])
    assert screen[0, 0] > 0.5 and screen[1, 1] < 0.5


def test_view_matrix_is_the_inverse_of_the_world_matrix() -> None:
    assert CAMERA.view @ CAMERA.world == pytest.approx(np.eye(4), abs=1e-9)


def test_the_pivot_is_in_the_middle_at_its_distance() -> None:
    screen, depth = project(CAMERA, CAMERA.pivot)
    assert screen[0] == pytest.approx([0.5, 0.5])
    assert depth[0] == pytest.approx(4)


def test_pan_moves_the_picture_one_to_one_at_the_pivot() -> None:
    screen, _ = project(pan(CAMERA, 0.1, 0.2), CAMERA.pivot)
    assert (0.5 - screen[0, 0]) * CAMERA.aspect == pytest.approx(0.1)
    assert screen[0, 1] - 0.5 == pytest.approx(0.2)


def test_dolly_follows_the_papers_law() -> None:
    assert dolly(CAMERA, 3).distance == pytest.approx(4 * 1.15**-3)
    assert dolly(dolly(CAMERA, 2), -2).distance == pytest.approx(4)


def test_orbit_keeps_pivot_distance_and_roll() -> None:
    leaned = roll(CAMERA, 12)
    around = orbit(leaned, -45, 20)
    assert around.pivot == leaned.pivot
    assert (around.azimuth, around.elevation, around.roll) == pytest.approx((-15, 30, 12))
    assert orbit(leaned, 0, 200).elevation == pytest.approx(85)


def test_swivel_keeps_the_position() -> None:
    turned = swivel(CAMERA, 20, -5)
    assert turned.position == pytest.approx(CAMERA.position)
    screen, _ = project(turned, CAMERA.pivot)
    assert screen[0, 0] > 0.5 and screen[0, 1] < 0.5


def test_between_looks_from_a_place_to_a_target() -> None:
    camera = camera_looking_at((1, -4, 2), (0, 0, 1), 35)
    assert camera.position == pytest.approx([1, -4, 2])
    assert project(camera, (0, 0, 1))[0][0] == pytest.approx([0.5, 0.5])


@pytest.mark.parametrize(
    ("movement", "direction", "check"),
    [
        ("pan", "left", lambda a, b: b.azimuth > a.azimuth and np.allclose(a.position, b.position)),
        ("tilt", "up", lambda a, b: b.elevation < a.elevation and np.allclose(a.position, b.position)),
        ("orbit", "left", lambda a, b: b.azimuth < a.azimuth and a.pivot == b.pivot),
        ("push in", None, lambda a, b: b.distance < a.distance and a.lens == b.lens),
        ("pull out", None, lambda a, b: b.distance > a.distance),
        ("zoom in", None, lambda a, b: b.lens > a.lens and b.distance == a.distance),
        ("zoom out", None, lambda a, b: b.lens < a.lens),
        ("truck", "right", lambda a, b: (b.position - a.position) @ a.axes[:, 0] > 0.3),
        ("pedestal", "down", lambda a, b: (b.position - a.position) @ a.axes[:, 1] < -0.2),
        ("static", None, lambda a, b: a == b),
    ],
)
def test_moves_end_where_their_name_says(movement, direction, check) -> None:
    assert check(CAMERA, move_camera(CAMERA, movement, direction))


@pytest.mark.parametrize("movement", ["track", "pan"])
def test_following_keeps_the_walker_where_they_were(movement: str) -> None:
    walker = np.array([0.5, 1.1, 1.6])
    travel = (1.5, 0.4, 0.0)
    before, _ = project(CAMERA, walker)
    after, _ = project(follow_subject(CAMERA, movement, travel), walker + travel)
    assert after[0] == pytest.approx(before[0], abs=0.03)


def test_a_panning_camera_stays_on_its_tripod_all_the_way() -> None:
    end = move_camera(CAMERA, "pan", "right")
    for share in (0.25, 0.5, 0.75):
        assert interpolate_cameras(CAMERA, end, share).position == pytest.approx(CAMERA.position)


def test_in_between_meets_both_ends() -> None:
    end = replace(move_camera(CAMERA, "orbit", "left"), lens=70)
    for share, wanted in ((0.0, CAMERA), (1.0, end)):
        got = interpolate_cameras(CAMERA, end, share)
        assert got.position == pytest.approx(wanted.position)
        assert got.lens == pytest.approx(wanted.lens)


def test_easing_rests_at_both_ends() -> None:
    assert (ease_in_out(0), ease_in_out(0.5), ease_in_out(1)) == pytest.approx((0, 0.5, 1))
    assert ease_in_out(0.01) < 1e-4


@pytest.mark.parametrize("movement", ["pan", "tilt", "orbit", "push in", "zoom out", "truck", "pedestal"])
def test_half_a_move_back_and_a_whole_one_on_is_half_a_move_on(movement: str) -> None:
    start, end = move_camera(CAMERA, movement, None, -0.5), move_camera(CAMERA, movement, None, 0.5)
    middle = interpolate_cameras(start, end, 0.5)
    assert middle.position == pytest.approx(CAMERA.position, abs=0.15)
    assert move_camera(start, movement).position == pytest.approx(end.position, abs=0.15)

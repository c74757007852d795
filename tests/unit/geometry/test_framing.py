import math

import numpy as np
import pytest

from storyblender.geometry.continuity import (
    crosses_line,
    do_looks_match,
    mirror_azimuth,
    screen_direction,
    side_of_line,
)
from storyblender.geometry.framing import (
    Figure,
    Film,
    elevation_of,
    face_screen_y,
    frame_group,
    frame_group_from,
    frame_insert,
    frame_master,
    frame_point_of_view,
    frame_single,
    project,
)
from storyblender.geometry.orbit import orbit
from storyblender.geometry.over_shoulder import frame_over_shoulder, lens_over_shoulder
from storyblender.memory.shot_sizes import SIZES

FILM = Film()


def figure(name: str, x: float, y: float, yaw: float, stature: float = 1.7) -> Figure:
    forward = (math.sin(math.radians(yaw)), -math.cos(math.radians(yaw)), 0.0)
    return Figure(name, (x, y, stature - 0.13), forward, 0.13 * stature, (x, y, 0))


ANNA, TOM = figure("anna", -0.6, 0, 90), figure("tom", 0.6, 0, -90, 1.85)


def head_share(camera, who: Figure) -> float:
    top = np.add(who.face, (0, 0, who.head / 2))
    screen, _ = project(camera, [top, top - (0, 0, who.head)])
    return float(screen[1, 1] - screen[0, 1])


@pytest.mark.parametrize("size", SIZES)
def test_a_single_has_the_head_height_of_its_size(size: str) -> None:
    camera = frame_single(FILM, ANNA, size, 40, 2, 50)
    assert head_share(camera, ANNA) == pytest.approx(SIZES[size].head, rel=0.06)
    assert project(camera, ANNA.face)[0][0, 1] == pytest.approx(face_screen_y(size), abs=0.01)


def test_a_body_that_is_bent_is_no_higher_in_the_picture_than_it_has_to_be() -> None:
    bent = figure("anna", -0.6, 0, 90, 0.9)
    bent = Figure(bent.node_id, bent.face, bent.forward, ANNA.head, bent.base)
    for who, crown in ((ANNA, SIZES["FS"].crown), (bent, SIZES["FS"].crown + 0.1)):
        camera = frame_single(FILM, who, "FS", 40, 2, 50)
        assert project(camera, who.crown)[0][0, 1] == pytest.approx(crown, abs=0.025)


def test_lead_room_is_on_the_side_the_face_looks_to() -> None:
    for azimuth in (20, 160):
        camera = frame_single(FILM, ANNA, "MCU", azimuth, 2, 65)
        looks_right = screen_direction(camera, ANNA.forward) > 0
        assert (project(camera, ANNA.face)[0][0, 0] < 0.5) == looks_right
    frontal = frame_single(FILM, ANNA, "MCU", 90, 2, 65)
    assert project(frontal, ANNA.face)[0][0, 0] == pytest.approx(0.5, abs=0.01)


def test_a_large_head_is_nearer_to_the_middle_and_its_hair_stays_in_the_picture() -> None:
    off = {
        size: abs(float(project(frame_single(FILM, ANNA, size, 160, 2, 85), ANNA.face)[0][0, 0]) - 0.5)
        for size in ("MS", "CU")
    }
    assert 0.06 < off["CU"] < 0.8 * off["MS"]


def test_a_two_shot_holds_both_and_centres_them() -> None:
    camera = frame_group(FILM, [ANNA, TOM], "MS", 0, 2, 50)
    xs = project(camera, [ANNA.face, TOM.face])[0][:, 0]
    assert xs.mean() == pytest.approx(0.5, abs=0.01)
    assert xs.min() > 0.1 and xs.max() < 0.9
    assert max(head_share(camera, who) for who in (ANNA, TOM)) <= SIZES["MS"].head * 1.05


def test_a_wide_group_steps_back_until_all_are_in() -> None:
    crowd = [figure(f"p{i}", -3 + 1.5 * i, 0.3 * i, 0) for i in range(5)]
    xs = project(frame_group(FILM, crowd, "MS", 0, 2, 50), [who.face for who in crowd])[0][:, 0]
    assert xs.min() > 0.15 and xs.max() < 0.85


@pytest.mark.parametrize("size", ["MS", "MWS", "FS"])
def test_who_lies_at_the_feet_of_another_is_in_the_picture(size: str) -> None:
    lying = figure("tom", 0.6, 0.4, 90, 0.3)
    pair = (figure("anna", 0, 0, 30), lying)
    held = [frame_group(FILM, pair, size, 10, 2, 50)]
    held.append(frame_group_from(FILM, pair, size, (0.5, -2.6, 1.5), 50, 18))
    for camera in held:
        screen, _ = project(camera, [each.face for each in pair])
        assert screen.min() > 0.03 and screen.max() < 0.97


@pytest.mark.parametrize("angle", ["eye-level", "low angle", "high angle"])
def test_a_full_shot_of_a_group_holds_heads_and_feet(angle: str) -> None:
    spots = [spot for who in (ANNA, TOM) for spot in (who.crown, who.base)]
    for azimuth in (0, 60):
        camera = frame_group(FILM, [ANNA, TOM], "FS", azimuth, elevation_of(angle, "FS"), 35)
        ys = project(camera, spots)[0][:, 1]
        assert ys.min() > 0 and ys.max() < 1
    near = project(frame_group_from(FILM, [ANNA, TOM], "FS", (0, -2.8, 1.0), 35, 18), spots)[0][:, 1]
    assert near.min() > 0 and near.max() < 1, "where the room is short the lens is wide enough for the feet"


def test_a_low_angle_of_whole_bodies_is_moderate() -> None:
    assert elevation_of("low angle", "MS") < elevation_of("low angle", "FS") < -6
    assert elevation_of("worm's-eye", "FS") == elevation_of("worm's-eye", "MS")


@pytest.mark.parametrize("side", [1, -1])
def test_over_the_shoulder_shows_both_in_their_halves(side: int) -> None:
    camera = frame_over_shoulder(FILM, ANNA, TOM, "MS", side, 0, 50)
    anna, tom = project(camera, [ANNA.face, TOM.face])[0]
    assert side_of_line(camera.position, TOM.face, ANNA.face) == side
    assert (anna[0] - 0.5) * (tom[0] - 0.5) < 0
    assert head_share(camera, TOM) > 1.3 * head_share(camera, ANNA)
    assert SIZES["MS"].band[0] < head_share(camera, ANNA) < SIZES["MS"].band[1]


def test_the_shoulder_of_somebody_far_away_is_beside_the_face_and_not_before_it() -> None:
    far = figure("tom", 1.4, 0, -90, 1.85)
    anna, tom = project(frame_over_shoulder(FILM, ANNA, far, "MCU", 1, 0, 65), [ANNA.face, far.face])[0]
    assert abs(anna[0] - tom[0]) == pytest.approx(0.42, abs=0.06)


def test_point_of_view_is_in_the_eyes() -> None:
    camera = frame_point_of_view(FILM, ANNA, TOM.face, 50)
    assert np.linalg.norm(camera.position - ANNA.face) < 0.2
    assert project(camera, TOM.face)[0][0] == pytest.approx([0.5, 0.5])


def test_an_insert_fills_the_picture_as_wanted() -> None:
    corners = np.array([(x, y, z) for x in (-0.2, 0.2) for y in (-0.1, 0.1) for z in (0.8, 1.0)])
    camera = frame_insert(FILM, corners, 20, 30, 85)
    screen, _ = project(camera, corners)
    assert (screen.max(0) - screen.min(0)).max() == pytest.approx(0.5, abs=0.06)


def test_a_master_holds_the_whole_place() -> None:
    corners = np.array([(x, y, z) for x in (-4, 4) for y in (-3, 3) for z in (0, 2)])
    screen, _ = project(frame_master(FILM, corners, 15, 10, 24), corners)
    assert screen.min() > 0 and screen.max() < 1
    assert (screen.max(0) - screen.min(0)).max() > 0.7


def test_the_line_is_crossed_only_on_the_other_side() -> None:
    camera = frame_group(FILM, [ANNA, TOM], "MS", 0, 2, 50)
    side = side_of_line(camera.position, ANNA.face, TOM.face)
    assert side == -1
    assert not crosses_line(orbit(camera, 60), ANNA.face, TOM.face, side)
    assert crosses_line(orbit(camera, 180), ANNA.face, TOM.face, side)
    assert side_of_line((-5, 0.05), ANNA.face, TOM.face) == 0


def test_mirrored_singles_match_their_eyelines() -> None:
    azimuth = 50.0
    reverse = mirror_azimuth(azimuth, ANNA.face, TOM.face)
    assert reverse == pytest.approx(-50)
    first, second = frame_single(FILM, ANNA, "MCU", azimuth, 2, 65), frame_single(FILM, TOM, "MCU", reverse, 2, 65)
    assert do_looks_match(first, ANNA.forward, second, TOM.forward)
    assert not do_looks_match(first, ANNA.forward, frame_single(FILM, TOM, "MCU", reverse + 180, 2, 65), TOM.forward)


def test_people_far_apart_get_a_longer_lens_over_the_shoulder_and_too_far_apart_none() -> None:
    near, far, beyond = (figure("tom", x, 0, -90) for x in (1.0, 2.9, 9.0))
    assert lens_over_shoulder(FILM, ANNA, near, "MS", 50) == 50
    assert lens_over_shoulder(FILM, ANNA, far, "MS", 50, (35, 50, 75)) == 75
    assert lens_over_shoulder(FILM, ANNA, far, "MS", 50, (50,)) is None
    assert lens_over_shoulder(FILM, ANNA, beyond, "MS", 50) is None

import dataclasses

import numpy as np
import pytest
from traced_frame import FLOOR, PERSON, WALL, gbuffer

from storyblender.look.ink import add_lines, apply_ink, draw_ink, people_nearby
from storyblender.look.surface import Surface

FRAME = gbuffer(480, 270)
CLEAR = np.ones((135, 240), np.float32)


def ink(frame=FRAME, air=CLEAR):
    return draw_ink(frame, 2, air)


def border(frame, a: int, b: int) -> np.ndarray:
    """True in the blocks of two where both ids show."""
    blocks = frame.ids.reshape(135, 2, 240, 2)
    return ((blocks == a).any((1, 3))) & ((blocks == b).any((1, 3)))


def test_a_person_before_a_wall_gets_an_outline():
    lines = ink()
    assert np.median(lines[border(FRAME, PERSON, WALL)]) > 0.4


def test_flat_ground_seen_at_a_glance_stays_clean():
    only = dataclasses.replace(FRAME, ids=np.where(FRAME.ids == FLOOR, FLOOR, 0).astype(np.uint16))
    lines = ink(only)
    floor = (FRAME.ids.reshape(135, 2, 240, 2) == FLOOR).all((1, 3))
    inner = floor & np.roll(floor, 3, 0) & np.roll(floor, -3, 0) & np.roll(floor, 3, 1) & np.roll(floor, -3, 1)
    inner[-4:] = inner[:, :4] = inner[:, -4:] = False
    assert lines[inner].max() == 0


def test_cloth_and_skin_of_one_person_get_no_outline_between_them():
    lines = ink()
    blocks = FRAME.surface.reshape(135, 2, 240, 2)
    neck = (blocks == Surface.SKIN).any((1, 3)) & (blocks == Surface.CLOTH).any((1, 3))
    assert neck.any() and lines[neck].max() < 0.05


def test_a_line_is_heavier_underneath_than_on_top():
    large, lines = gbuffer(1920, 1080), {}
    for name, up in (("top", 1.0), ("underside", -1.0)):
        normal = large.normal.copy()
        normal[large.ids == PERSON] = (0, -np.sqrt(0.5), up * np.sqrt(0.5))
        lines[name] = draw_ink(dataclasses.replace(large, normal=normal), 2, np.ones((540, 960), np.float32)).sum()
    assert lines["underside"] > 1.2 * lines["top"]


def test_fog_takes_lines_away():
    assert ink(air=CLEAR * 0.01).max() < 0.1 * ink().max()


def test_strips_leave_no_seams(monkeypatch):
    whole = ink()
    monkeypatch.setattr("storyblender.look.ink._BAND", 40)
    assert ink() == pytest.approx(whole, abs=1e-6)


def test_lines_of_people_turn_light_on_dark_ground():
    dark = np.full((135, 240, 3), 0.02, np.float32)
    people = people_nearby(FRAME, 2)
    drawn = apply_ink(dark, ink(), people, 0.88)
    line = border(FRAME, PERSON, WALL) & (people > 0.9)
    assert 0.04 < drawn[line].mean() < 0.12  # seen, not chalk
    bright = apply_ink(dark + 0.6, ink(), people, 0.88)
    assert bright[line].mean() < 0.45


def test_lines_of_a_moving_frame_stand_on_the_nearer_side_of_a_jump_and_not_on_a_receding_floor():
    view = gbuffer(32, 18).view
    depth = 1 / np.repeat(np.linspace(1 / 6, 1 / 2, 18, dtype=np.float32)[:, None], 32, axis=1)
    white = np.ones((18, 32, 3), np.float32)
    assert (add_lines(white, depth, view) == 1).all()
    depth[4:12, 10:20] = 1.0
    drawn = add_lines(white, depth, view)[..., 0]
    assert drawn[6:10, 10].max() < 0.6 and drawn[6:10, 19].max() < 0.6
    assert drawn[6:10, 9].min() > drawn[6:10, 10].max() and (drawn[:, 25:] == 1).all() and (white == 1).all()

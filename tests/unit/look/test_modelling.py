"""Skin gets back the form that coarse light has lost."""

from dataclasses import replace

import numpy as np
import pytest
from traced_frame import HEAD, gbuffer

from storyblender.look.modelling import Flesh, lift_hands, model_flesh
from storyblender.look.surface import Surface
from storyblender.memory.scene_context import Light

FRAME = gbuffer(192, 108)
SKIN = FRAME.surface == Surface.SKIN
KEY = Light(name="key", kind="SPOT", role="key", location=(-1.0, 2.4, 1.9), target=HEAD, power=60, cone=40)


def lit(frame, lamps):
    light = np.full((*frame.ids.shape, 3), 0.5, np.float32)
    model_flesh(light, frame, lamps)
    return light[..., 0]


def with_nose():
    """Turn a column of the face's pixels to the side the lamp is on, and the one beside it away."""
    normal = FRAME.normal.copy()
    columns = np.flatnonzero(SKIN.any(axis=0))
    middle = int(columns.mean())
    for column, turned in ((middle, (-0.8, -0.6, 0)), (middle + 1, (0.8, -0.6, 0))):
        normal[SKIN[:, column], column] = turned
    return replace(FRAME, normal=normal), middle


def test_a_nose_shows_by_its_lit_and_its_shaded_side():
    frame, middle = with_nose()
    face = lit(frame, [KEY])
    rows = SKIN[:, middle] & SKIN[:, middle + 1]
    assert face[rows, middle].mean() > 1.3 * face[rows, middle + 1].mean()
    assert 0.3 <= face[SKIN].min() < face[SKIN].max() <= 0.68, "within bounds, whatever the lamp"


def test_an_even_face_keeps_its_light_and_all_else_too():
    face = lit(FRAME, [KEY])
    assert abs(face[SKIN].mean() - 0.5) < 0.03
    assert (face[~SKIN] == 0.5).all()
    assert (lit(FRAME, []) == 0.5).all()


def people_lit(**shares):
    """Return light of 1 on a face and the given share of it on hands, after hands were lifted."""
    light = np.ones((4, 6, 3), np.float32)
    masks = {name: np.zeros((4, 6), bool) for name in ("face", "hand", "other_hand", "nobody")}
    masks["face"][0, :4], masks["hand"][2], masks["other_hand"][3] = True, True, True
    for name, share in shares.items():
        light[masks[name]] = share
    one, other = Flesh(masks["face"] | masks["hand"], masks["face"]), Flesh(masks["other_hand"], masks["nobody"])
    lift_hands(light, (one, other))
    return {name: float(light[mask].mean()) for name, mask in masks.items() if mask.any()}


def test_a_hand_in_the_dark_is_lifted_towards_its_face_and_no_further():
    after = people_lit(hand=0.2, other_hand=0.8)
    assert 0.35 < after["hand"] < 0.55
    assert (after["face"], after["other_hand"]) == (1.0, pytest.approx(0.8)), "what has light enough keeps its light"
    assert people_lit(hand=0.001)["hand"] < 0.01, "night stays night"


def test_who_is_turned_away_is_measured_by_the_faces_that_are_seen():
    assert people_lit(other_hand=0.2)["other_hand"] > 0.35
    dark = np.full((4, 6, 3), 0.1, np.float32)
    lift_hands(dark, (Flesh(np.ones((4, 6), bool), np.zeros((4, 6), bool)),))
    assert (dark == np.float32(0.1)).all(), "no face, nothing to measure by"

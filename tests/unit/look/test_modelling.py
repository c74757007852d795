"""Skin gets back the form that coarse light has lost."""

from dataclasses import replace

import numpy as np
from traced_frame import HEAD, gbuffer

from storyblender.look.modelling import model_flesh
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

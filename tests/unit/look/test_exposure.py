import numpy as np
import pytest
from traced_frame import HEAD, gbuffer

from storyblender.look.exposure import (
    bright_half,
    dim_set_lamps,
    find_faces,
    geometric_mean,
    shadow_lift,
    solve_faces,
    trim,
    with_shadows_raised,
)
from storyblender.look.illumination import LightField
from storyblender.look.raster import luminance
from storyblender.memory.scene_context import Light

FRAME = gbuffer()
FACES = find_faces(FRAME, [("ana", HEAD, 1.0)])
ALBEDO = FRAME.albedo.astype(np.float32)
NONE = np.zeros_like(ALBEDO)


def lamp(role: str, level: float, name: str = "", kind: str = "SPOT") -> LightField:
    light = Light.model_validate(
        {"name": name or role, "kind": kind, "role": role, "power": 100,
         "for_asset": "ana" if role in ("key", "fill", "rim") else None}
    )  # fmt: skip
    return LightField(light, np.full(FRAME.depth.shape, level, np.float32))


def face_level(fields, ambient=NONE) -> float:
    light = ambient + sum(field.amount[..., None] for field in fields)
    return bright_half(luminance(light * ALBEDO)[FACES[0].mask])


def test_a_face_is_found_by_its_skin_near_its_centre():
    assert [face.asset_id for face in FACES] == ["ana"]
    assert 10 < FACES[0].mask.sum() < 400
    assert not find_faces(FRAME, [("ben", (5.0, 4.0, 1.6), 1.0)])


@pytest.mark.parametrize("level", [0.25, 0.6, 1.0])
def test_the_key_brings_the_face_to_its_target(level):
    solved = solve_faces([lamp("set", 0.1), lamp("key", level)], NONE, ALBEDO, FACES, 0.2)
    assert face_level(solved) == pytest.approx(0.2, rel=0.02)
    assert solved[0].light.power == 100


def test_the_key_is_capped_and_the_fill_takes_the_rest():
    solved = solve_faces([lamp("key", 0.05), lamp("fill", 0.1)], NONE, ALBEDO, FACES, 0.2)
    assert solved[0].light.power == pytest.approx(200)
    assert solved[1].light.power > 200


def test_the_shaded_side_of_a_face_keeps_its_features():
    key, fill = lamp("key", 0.6), lamp("fill", 0.12)
    columns = np.flatnonzero(FACES[0].mask.any(0))
    key.amount[:, (columns[0] + columns[-1]) // 2 :] = 0
    light = sum(field.amount for field in solve_faces([key, fill], NONE, ALBEDO, FACES, 0.2))
    shown = (light * luminance(ALBEDO))[FACES[0].mask]
    dark = shown[shown <= np.median(shown)]
    assert dark.mean() == pytest.approx(0.45 * 0.2, rel=0.1)
    assert bright_half(shown) < 0.25


def test_a_face_in_the_sun_needs_no_key():
    solved = solve_faces([lamp("sun", 2.0, kind="SUN"), lamp("key", 0.5)], NONE, ALBEDO, FACES, 0.2)
    assert solved[1].light.power < 10


def test_rims_follow_dimmed_keys():
    solved = solve_faces([lamp("set", 0.3), lamp("key", 0.5), lamp("rim", 0.0)], NONE, ALBEDO, FACES, 0.2)
    assert solved[2].light.power < 100


def test_a_practical_that_burns_the_face_is_dimmed_but_the_sun_is_not():
    dimmed = dim_set_lamps([lamp("practical", 1.0), lamp("sun", 1.0, kind="SUN")], NONE, ALBEDO, FACES, 0.2)
    assert dimmed[0].light.power == pytest.approx(30)
    assert dimmed[1].light.power == 100
    gentle = dim_set_lamps([lamp("practical", 0.1)], NONE, ALBEDO, FACES, 0.2)
    assert gentle[0].light.power == 100


def test_the_trim_leaves_good_faces_alone_and_mends_the_others():
    picture = np.full((*FRAME.depth.shape, 3), 0.2, np.float32)
    assert trim(picture, FACES, 0.2, 0.05) == 0
    assert trim(picture * 2, FACES, 0.2, 0.05) == 0
    assert -1.5 <= trim(picture * 8, FACES, 0.2, 0.05) < -1
    assert 0 < trim(picture * 0.6, FACES, 0.2, 0.05) < 0.8
    assert trim(picture * 0.01, FACES, 0.2, 0.05) == pytest.approx(0.8)


def test_a_frame_without_faces_goes_half_the_way_to_its_level():
    picture = np.full((*FRAME.depth.shape, 3), 0.1, np.float32)
    assert trim(picture, (), 0.2, 0.05) == pytest.approx(-0.5, abs=0.01)


def test_a_night_is_raised_until_it_can_be_read_and_its_lamps_stay():
    night = np.full((20, 20, 3), 0.01, np.float32)
    night[0, 0] = 2.0
    raised = with_shadows_raised(night, shadow_lift(night))
    assert geometric_mean(luminance(raised)) > 3 * geometric_mean(luminance(night))
    assert raised[0, 0] == pytest.approx(night[0, 0], rel=0.01)
    assert (np.diff(np.sort(luminance(raised).ravel())) >= 0).all() and raised[5, 5, 0] < raised[0, 0, 0]


def test_a_day_keeps_its_shadows():
    day = np.full((20, 20, 3), 0.3, np.float32)
    day[:4] = 0.005
    assert shadow_lift(day) == 0
    assert with_shadows_raised(day, 0.0) is day

"""Air, wet ground, pencil, grade, looks."""

import numpy as np
import pytest
from traced_frame import PERSON, WALL, gbuffer, view

from storyblender.look import grade
from storyblender.look.atmosphere import add_fog, add_halos, add_rain, transmittance
from storyblender.look.bundled import blender_folder, bundled_module
from storyblender.look.face_light import face_lights
from storyblender.look.grade import to_bytes, to_display, to_film
from storyblender.look.looks import LOOKS
from storyblender.look.pencil import draw_pencil, level_ground
from storyblender.look.surface import PERSON as PEOPLE
from storyblender.look.surface import Surface
from storyblender.look.wet_ground import add_wet_ground, wetness
from storyblender.memory.scene_context import Fog, Light, Lighting, Sky

FRAME = gbuffer(192, 108)
RAYS, EYE = FRAME.view.rays(), FRAME.view.eye
GREY = np.full((108, 192, 3), 0.18, np.float32)
SKY = Sky(zenith=(0, 0, 0), horizon=(0, 0, 0), ground=(0, 0, 0))


def test_fog_hides_the_wall_more_than_the_person():
    fog = Fog(color=(0.5, 0.5, 0.5), density=0.1)
    through = transmittance(fog, FRAME.depth, RAYS, EYE)
    person, wall = through[FRAME.ids == PERSON].mean(), through[FRAME.ids == WALL].mean()
    assert person == pytest.approx(np.exp(-0.4), rel=0.05)
    assert wall < person
    assert add_fog(GREY, fog, through, RAYS)[FRAME.ids == WALL].mean() > 0.3
    assert transmittance(None, FRAME.depth, RAYS, EYE).min() == 1


def test_fog_glows_towards_the_sun():
    fog = Fog(color=(0.1, 0.1, 0.1), density=0.2, sun_direction=(0.4, 1, 0.1), sun_color=(1, 0.5, 0.2))
    seen = add_fog(GREY, fog, transmittance(fog, FRAME.depth, RAYS, EYE), RAYS)
    assert seen[20, -20, 0] > seen[20, 20, 0] + 0.05


def test_a_halo_surrounds_its_lamp_and_fades():
    lamp = Light(name="post", kind="POINT", location=(1.0, 6.0, 2.2), power=150, glow=0.5)
    seen = add_halos(GREY, [lamp], FRAME.depth, RAYS, EYE)[..., 0] - 0.18
    column, row, _ = FRAME.view.project(np.array(lamp.location))
    assert seen[int(row), int(column)] == seen.max() > 0.05
    assert seen[-5, 5] < 0.3 * seen.max()


def test_rain_stays_behind_what_is_near_and_repeats_with_its_seed():
    near = np.full((108, 192), 1.0, np.float32)
    assert (add_rain(GREY, near, 1.0, 3) == GREY).all()
    wet = add_rain(GREY, near * 50, 1.0, 3)
    assert wet.max() > 0.2
    assert (wet == add_rain(GREY, near * 50, 1.0, 3)).all()
    assert not (wet == add_rain(GREY, near * 50, 1.0, 4)).all()


def test_wet_ground_mirrors_the_person_under_their_feet():
    wet = gbuffer(192, 192, floor=Surface.WET)
    picture = np.where((wet.ids == PERSON)[..., None], np.float32([2.0, 0, 0]), np.float32([0.05, 0.05, 0.05]))
    seen = add_wet_ground(picture, wet, SKY, 1.0, water=True)
    feet = np.flatnonzero((wet.ids == PERSON)[:, 96])[-1]
    below, aside = seen[feet + 3 : feet + 12, 92:100, 0], seen[feet + 3 : feet + 12, 20:40, 0]
    assert below.mean() > 1.5 * aside.mean()
    assert (add_wet_ground(picture, wet, SKY, 0.0, water=True) == picture).all()


def test_ground_is_wet_by_rain_and_a_little_at_night():
    night, day = Lighting(sky=SKY, set_luminance=0.028), Lighting(sky=SKY, set_luminance=0.17)
    assert wetness(day, 0.0) == 0 < wetness(night, 0.0) < wetness(day.model_copy(update={"rain": 0.5}), 0.0) <= 1
    assert wetness(night, 1.0) == 0


def test_pencil_is_grey_and_keeps_faces_light():
    none = np.zeros((108, 192), np.float32)
    drawn = draw_pencil(GREY, none, none, none, 0.86)
    assert np.ptp(drawn[50, 50]) < 0.08
    flesh = np.zeros_like(none)
    flesh[40:60, 40:60] = 1
    dim = draw_pencil(GREY * 0.3, none, flesh, none, 0.86)
    assert dim[45:55, 45:55].mean() > dim[80:90, 80:90].mean() + 0.1


def test_pencil_keeps_the_eyes():
    display = np.full((108, 192, 3), 0.6, np.float32)
    display[50:53, 50:53] = 0.05
    flesh = np.zeros((108, 192), np.float32)
    flesh[30:70, 30:70] = 1
    drawn = draw_pencil(display, flesh * 0, flesh, flesh * 0, 0.86)
    assert drawn[51, 51].mean() < 0.7 * drawn[40, 40].mean()


def test_pencil_tells_dark_skin_from_fair():
    flesh = np.ones((108, 192), np.float32)
    tones = [draw_pencil(GREY * gain, flesh * 0, flesh, flesh * 0, 0.86).mean() for gain in (0.7, 1.5, 3.0)]
    assert tones[0] + 0.1 < tones[1] < tones[2] - 0.1


def test_pencil_keeps_the_strands_of_white_hair():
    display = np.full((108, 192, 3), 0.8, np.float32)
    display[:, ::8] = display[:, 1::8] = 0.7
    none = np.zeros((108, 192), np.float32)
    drawn = draw_pencil(display, none, none, none, 0.86)
    assert drawn[:, ::8].mean() < 0.95 * drawn[:, 4::8].mean()


def test_pencil_hatches_shade_and_leaves_light_bare():
    none = np.zeros((540, 960), np.float32)
    shade, light = (
        draw_pencil(np.full((540, 960, 3), tone, np.float32), none, none, none, 0.86)[..., 0] for tone in (0.2, 0.7)
    )
    assert shade.std() > 2 * light.std()
    # Strokes, not a screen: along no row do they repeat.
    rows = shade - shade.mean()
    for shift in range(4, 200):
        assert (rows[:, shift:] * rows[:, :-shift]).mean() < 0.6 * rows.var()


def test_pencil_strokes_lie_with_level_ground_and_a_light_one_gets_a_few():
    none = np.zeros((540, 960), np.float32)
    shade, sand = (np.full((540, 960, 3), tone, np.float32) for tone in (0.2, 0.6))
    upright, level = (draw_pencil(shade, none, none, none + ground, 0.86)[..., 0] for ground in (0, 1))
    along, across = (np.abs(np.diff(level, axis=axis)).mean() for axis in (1, 0))
    assert along < 0.6 * across, "strokes run from side to side"
    assert along < 0.7 * np.abs(np.diff(upright, axis=1)).mean()
    bare, drawn = (draw_pencil(sand, none, none, none + ground, 0.86)[..., 0] for ground in (0, 1))
    assert 0.02 < (drawn < bare - 0.03).mean() < 0.4


def test_level_ground_is_the_floor_not_the_wall_or_somebody():
    level = level_ground(FRAME)
    upward = FRAME.normal[..., 2] > 0.9
    assert (level[upward & ~np.isin(FRAME.surface, PEOPLE)] == 1).all()
    assert level[FRAME.ids == WALL].max() == level[FRAME.ids == PERSON].max() == 0


def test_pencil_night_is_darker_than_day():
    none = np.zeros((108, 192), np.float32)
    assert draw_pencil(GREY, none, none, none, 0.86).mean() < 0.8 * draw_pencil(GREY * 3, none, none, none, 0.86).mean()


def test_a_pencil_line_is_seen_on_a_black_coat():
    ink = np.zeros((540, 960), np.float32)
    ink[270:274] = 1
    display = np.full((540, 960, 3), 0.03, np.float32)
    display[:, 600:] = 0.5
    drawn = draw_pencil(display, ink, ink * 0, ink * 0, 0.86)[:, 100:500, 0]
    assert drawn[271:273].mean() < drawn[300:].mean() - 0.18


def test_pencil_lines_waver_but_stay_where_they_are():
    ink = np.zeros((540, 960), np.float32)
    ink[270:273] = 1
    drawn = draw_pencil(np.full((540, 960, 3), 0.8, np.float32), ink, ink * 0, ink * 0, 0.86)[..., 0]
    place = np.argmin(drawn, axis=0)
    assert 266 <= place.min() < place.max() <= 276


def test_grade_is_monotone_and_neutral():
    ramp = np.geomspace(1e-3, 10, 64, dtype=np.float32)[None, :, None].repeat(3, 2)
    for tone in (to_display(ramp)[0, :, 1], grade._filmic(ramp)[0, :, 1]):
        assert (np.diff(tone) > -1e-3).all()
        assert tone[0] < 0.06 and tone[-1] > 0.9
    assert np.ptp(to_display(GREY)[0, 0]) < 0.01


def test_without_colour_libraries_the_fallback_looks_alike(monkeypatch):
    agx = to_display(GREY)[0, 0, 0]
    monkeypatch.setattr(grade, "display_of", lambda contrast: None)
    assert to_display(GREY)[0, 0, 0] == pytest.approx(agx, abs=0.08)


def test_libraries_inside_blender_are_found():
    pytest.importorskip("bpy")
    assert blender_folder() is not None
    assert bundled_module("PyOpenColorIO") is not None
    assert bundled_module("no_such_library") is None


def test_bytes_round():
    assert to_bytes(np.float32([[[0, 0.5, 1.2]]])).tolist() == [[[0, 128, 255]]]


def test_every_look_has_its_key_and_divides():
    assert list(LOOKS) == ["board", "fast", "pencil", "render"]
    for key, look in LOOKS.items():
        assert look.key == key
        assert look.light_step in (1, 2, 4) and 0 <= look.ink <= 1


def test_face_lamps_stand_where_a_gaffer_would_put_them():
    plan = Lighting(sky=SKY)
    key, fill, rim = face_lights((0, 0, 1.6), 0.0, (0.0, -3.0, 1.6), plan, "ana")
    assert [lamp.role for lamp in (key, fill, rim)] == ["key", "fill", "rim"]
    assert key.location[2] > 2.5 and key.location[1] < 0
    assert rim.location[1] > 0 > fill.location[1]
    profile = face_lights((0, 0, 1.6), 90.0, (0.0, -3.0, 1.6), plan, "ana")[0]
    assert profile.location[0] > 0 > profile.location[1], "a profile keeps its lit side towards the lens"
    assert {lamp.for_asset for lamp in (key, fill, rim)} == {"ana"}


def test_reduced_views_see_the_same_frame():
    small = view().reduced(2)
    assert (small.width, small.height) == (48, 27)
    assert small.pixels_per_metre == pytest.approx(view().pixels_per_metre / 2)


def test_a_film_is_graded_like_a_frame():
    light = 2.0 ** np.random.default_rng(0).uniform(-9, 4, (60, 60, 3)).astype(np.float32)
    light = (light + light.mean(axis=2, keepdims=True)) / 2  # no picture is all lasers
    light[0, 0] = 0
    away = np.abs(to_film(light) - to_display(light))
    assert away.mean() < 0.5 / 255 and away.max() < 6 / 255 and (to_film(light)[0, 0] < 1e-3).all()

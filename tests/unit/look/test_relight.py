import dataclasses

import numpy as np
import pytest
from traced_frame import PERSON, WALL, gbuffer

from storyblender.look.moving_light import FlatFrame, MovingLight, normals_of
from storyblender.look.occlusion import ambient_occlusion
from storyblender.look.relight import demodulate, mean_albedo, remodulate, upsample
from storyblender.memory.scene_context import Light, Lighting, Sky

FRAME = gbuffer(192, 108)
DARK = Sky(zenith=(0, 0, 0), horizon=(0, 0, 0), ground=(0, 0, 0))


def test_demodulation_is_undone_by_remodulation():
    albedo = np.random.default_rng(1).random((8, 8, 3)).astype(np.float32)
    light = np.random.default_rng(2).random((8, 8, 3)).astype(np.float32)
    assert demodulate(remodulate(light, albedo), albedo) == pytest.approx(light, rel=1e-4)


def test_light_does_not_bleed_over_an_edge():
    low = FRAME.reduced(4)
    light = np.where(low.ids == PERSON, 1.0, 0.0)[..., None].repeat(3, 2).astype(np.float32)
    high = upsample(light, FRAME, 2)[..., 0]
    ids = FRAME.reduced(2).ids
    assert high[ids == PERSON].mean() > 0.95
    assert high[ids == WALL].mean() < 0.02


def test_light_that_mixes_two_surfaces_is_not_trusted():
    shown = (FRAME.ids == PERSON).astype(np.float32)
    mixed = shown.reshape(27, 4, 48, 4).mean((1, 3))  # as a path tracer averages over its pixels
    high = upsample(mixed[..., None].repeat(3, 2), FRAME, 2)[..., 0]
    assert np.percentile(high[FRAME.reduced(2).ids == PERSON], 10) > 0.95


def test_even_light_stays_even():
    light = np.full((27, 48, 3), 0.37, np.float32)
    assert upsample(light, FRAME, 2) == pytest.approx(0.37, abs=1e-4)


def test_the_sky_stands_in_for_albedo():
    sky = np.full((54, 96, 3), 0.8, np.float32)
    albedo = mean_albedo(FRAME, 2, sky)
    assert albedo[0, 0] == pytest.approx(0.8, abs=1e-3)
    assert mean_albedo(FRAME, 2)[0, 0] == pytest.approx(0)


def test_corners_are_darker_than_open_floor():
    low = FRAME.reduced(1)
    openness = ambient_occlusion(low.depth, low.view, low.normal.astype(np.float32))
    rows = np.flatnonzero(low.ids[:, 5] == 1)
    assert openness[rows[0], 5:40].mean() < 0.9 * openness[rows[-3], 5:40].mean()


def test_positions_and_projection_agree():
    column, row, depth = FRAME.view.project(FRAME.positions())
    shown = ~FRAME.sky
    rows, columns = np.mgrid[0:108, 0:192] + 0.5
    assert np.abs(column - columns)[shown].max() < 1e-2
    assert np.abs(row - rows)[shown].max() < 1e-2
    assert depth[shown] == pytest.approx(FRAME.depth[shown], rel=1e-4)


def test_normals_from_depth_point_at_the_eye():
    rays = FRAME.view.rays()
    normal = normals_of(FRAME.positions(), FRAME.depth, rays)
    agree = np.einsum("hwc,hwc->hw", normal, FRAME.normal.astype(np.float32))[~FRAME.sky]
    assert np.percentile(agree, 5) > 0.97


def test_moving_light_reuses_what_stands_still_and_relights_what_moves():
    plan = Lighting(sky=DARK, ambient=(0.1, 0.1, 0.1))
    lamp = Light(name="lamp", kind="POINT", location=(1, 1, 2.5), power=80)
    coverage = (~FRAME.sky).astype(np.float32)
    albedo, glow = FRAME.albedo.astype(np.float32), np.zeros((108, 192, 3), np.float32)
    body = FRAME.ids == PERSON
    first = FlatFrame(albedo, coverage, FRAME.depth, glow, body, body, FRAME.view)
    second = dataclasses.replace(first, depth=np.where(body, np.float32(2.5), FRAME.depth))

    mover = MovingLight(plan, 1.0)
    ((window, start),) = mover.light(first, [lamp])
    assert window == FRAME.view.whole
    parts = mover.light(second, [lamp])
    moved = start.copy()
    for window, picture in parts:
        moved[window.cut] = picture
    assert body[parts[0][0].cut].any() and sum(picture.size for _, picture in parts) < start.size
    fresh = MovingLight(plan, 1.0)
    ((_, whole),) = fresh.light(second, [lamp])

    still = (FRAME.ids == WALL) & (np.abs(moved - whole).max(axis=2) < 0.02)
    assert still.sum() > 0.95 * (FRAME.ids == WALL).sum()
    assert np.abs(moved - whole)[body].mean() < 0.1 * whole[body].mean()


def test_a_lamp_that_moves_lights_the_whole_picture_anew():
    plan = Lighting(sky=DARK, ambient=(0.1, 0.1, 0.1))
    lamp = Light(name="lamp", kind="POINT", location=(1, 1, 2.5), power=80)
    albedo, glow = FRAME.albedo.astype(np.float32), np.zeros((108, 192, 3), np.float32)
    coverage = (~FRAME.sky).astype(np.float32)
    nowhere = np.zeros_like(FRAME.sky)
    frame = FlatFrame(albedo, coverage, FRAME.depth, glow, nowhere, nowhere, FRAME.view)
    mover = MovingLight(plan, 1.0)
    mover.light(frame, [lamp])
    assert mover.light(frame, [lamp]) == []
    ((window, _),) = mover.light(frame, [lamp.model_copy(update={"location": (2, 1, 2.5)})])
    assert window == FRAME.view.whole


def test_a_picture_drawn_whole_again_keeps_its_light():
    plan = Lighting(sky=DARK, ambient=(0.1, 0.1, 0.1))
    lamp = Light(name="lamp", kind="POINT", location=(1, 1, 2.5), power=80)
    albedo, glow = FRAME.albedo.astype(np.float32), np.zeros((108, 192, 3), np.float32)
    everywhere = np.ones_like(FRAME.sky)
    coverage = (~FRAME.sky).astype(np.float32)
    frame = FlatFrame(albedo, coverage, FRAME.depth, glow, everywhere, everywhere, FRAME.view)
    mover = MovingLight(plan, 1.0)
    pictures = [mover.light(frame, [lamp])[0][1] for _ in range(3)]
    assert np.abs(pictures[1] - pictures[0]).max() < 1e-5 and np.abs(pictures[2] - pictures[0]).max() < 1e-5

import math

import numpy as np
import pytest

from storyblender.look.illumination import (
    LightField,
    ambient_light,
    bounce_light,
    light_field,
    power_for,
    sky_light,
    total,
)
from storyblender.look.shadow import ShadowMap
from storyblender.memory.scene_context import Light, Lighting, Sky

UP = np.array([[[0.0, 0.0, 1.0]]], np.float32)
ORIGIN = np.zeros((1, 1, 3), np.float32)
SKY = Sky(zenith=(0.1, 0.2, 0.5), horizon=(0.5, 0.6, 0.7), ground=(0.2, 0.2, 0.1))


def amount(light: Light, positions=ORIGIN, normal=UP) -> float:
    return float(light_field(light, positions, normal).amount[0, 0])


def lamp(kind="POINT", **fields) -> Light:
    return Light.model_validate(
        {"name": "lamp", "kind": kind, "location": (0, 0, 2), "power": 100, "size": 0.0} | fields
    )


def test_point_lamp_follows_the_formula_measured_against_cycles():
    assert amount(lamp()) == pytest.approx(100 / (4 * math.pi**2 * 4), rel=1e-5)


def test_light_falls_with_the_square_of_distance():
    assert amount(lamp()) == pytest.approx(4 * amount(lamp(location=(0, 0, 4))), rel=1e-5)


def test_surfaces_that_face_away_get_nothing():
    assert amount(lamp(), normal=-UP) == 0


def test_spot_lights_inside_its_cone_only():
    spot = lamp("SPOT", target=(0, 0, 0), cone=40, blend=0.2)
    beside = np.array([[[2.0, 0, 0]]], np.float32)
    assert amount(spot) == pytest.approx(amount(lamp()), rel=1e-5)
    assert amount(spot, beside) == 0


def test_area_lamp_gives_four_times_a_point_on_axis_at_a_distance():
    area = lamp("AREA", target=(0, 0, 0), location=(0, 0, 20))
    assert amount(area) == pytest.approx(4 * amount(lamp(location=(0, 0, 20))), rel=1e-3)


def test_sun_is_the_same_everywhere():
    sun = lamp("SUN", location=(0, 0, 5), target=(0, 0, 0), power=3.0)
    far = np.array([[[50.0, -20, 3]]], np.float32)
    assert amount(sun) == pytest.approx(3 / math.pi) == amount(sun, far)


def test_power_for_gives_the_luminance_it_promises():
    color = (1.0, 0.8, 0.6)
    key = lamp("SPOT", target=(0, 0, 0), power=power_for(0.2, 2.0, color), color=color)
    seen = total([light_field(key, ORIGIN, UP)], np.zeros((1, 1, 3), np.float32))[0, 0] * 0.4
    # the formula leaves a fifth for the turn of the cheek
    assert float(seen @ [0.2126, 0.7152, 0.0722]) == pytest.approx(0.2 / 0.8, rel=1e-3)


def test_light_is_linear_in_power():
    field = light_field(lamp(), ORIGIN, UP)
    assert field.scaled(0.25).light.power == 25
    assert float(field.scaled(0.25).amount[0, 0]) == pytest.approx(0.25 * float(field.amount[0, 0]))


def test_ambient_under_the_sky_comes_from_above_and_under_a_roof_from_everywhere():
    plan = Lighting(sky=SKY, ambient=(0.3, 0.4, 0.6))
    open_air = np.ones((1, 1), np.float32)
    assert ambient_light(plan, 0.0, UP, open_air)[0, 0] == pytest.approx(plan.ambient)
    assert ambient_light(plan, 0.0, -UP, open_air)[0, 0] == pytest.approx(SKY.ground)
    below = ambient_light(plan, 1.0, -UP, open_air)[0, 0]
    assert below == pytest.approx(np.array(plan.ambient) / 2)


def test_bounce_takes_the_colour_of_what_is_lit():
    red = np.broadcast_to(np.float32([0.8, 0.1, 0.1]), (4, 4, 3))
    bounce = bounce_light(red, np.ones((4, 4, 3), np.float32), np.ones((4, 4), bool), np.ones((4, 4), np.float32))
    assert bounce[0, 0, 0] > 4 * bounce[0, 0, 1] > 0


def test_sky_meets_its_colours():
    rays = np.array([[[0, 0, 1.0], [0, 1, 0], [0, 1, -1]]], np.float32)
    seen = sky_light(SKY, rays)[0]
    for color, expected in zip(seen, (SKY.zenith, SKY.horizon, SKY.ground), strict=True):
        assert color == pytest.approx(expected, abs=1e-5)


def test_shadow_map_hides_what_lies_behind_and_lights_what_lies_outside():
    depth = np.full((64, 64), 1e6, np.float32)
    depth[16:48, 16:48] = 1.0
    down = np.eye(3)
    shadow = ShadowMap(np.array([0.0, 0, 3]), down, 0.5, False, depth)
    points = np.array([[[0, 0, 0], [1.2, 0, 0], [9, 0, 0], [0, 0, 2.2]]], np.float32)
    lit = shadow.visibility(points, np.broadcast_to(UP, points.shape))[0]
    assert lit == pytest.approx([0, 1, 1, 1])


def test_slanted_surfaces_do_not_shade_themselves():
    sun_axes = np.array([[1, 0, 0], [0, 0.2, -0.98], [0, 0.98, 0.2]], float).T
    sun_axes /= np.linalg.norm(sun_axes, axis=0)
    grid = np.stack(np.meshgrid(np.linspace(-2, 2, 200), np.linspace(-0.4, 0.4, 100)), axis=2)
    floor = np.dstack([grid, np.zeros(grid.shape[:2])]).astype(np.float32)
    eye = sun_axes[:, 2] * 20
    local = (floor - eye) @ sun_axes
    depth = np.full((128, 128), 1e6, np.float32)
    column, row = ((local[..., 0] / 2.2 + 1) * 64).astype(int), ((1 - local[..., 1] / 2.2) * 64).astype(int)
    depth[row, column] = -local[..., 2]
    lit = ShadowMap(eye, sun_axes, 2.2, True, depth).visibility(floor, np.broadcast_to(UP, floor.shape))
    assert lit.min() > 0.99


def test_shadowed_takes_light_away():
    field = LightField(lamp(), np.ones((1, 2), np.float32))
    assert field.shadowed(np.float32([[0, 0.5]])).amount.tolist() == [[0, 0.5]]

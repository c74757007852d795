"""A car comes apart: its panels are objects of their own, and a part of the story is the car's own part."""

from __future__ import annotations

import bpy
import pytest
from tests.every import every

from storyblender.blender.props.build import build_prop
from storyblender.blender.sections import fitted_in, is_hidden_by, split_sections, with_sections
from storyblender.blender.tags import tag

CARS = ("car", "taxi", "police_car", "convertible", "jeep", "pickup", "van", "ambulance")


def _placed(key: str) -> bpy.types.Object:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    obj = bpy.data.objects.new("SC010.car", build_prop(key).mesh)
    bpy.context.scene.collection.objects.link(obj)
    return tag(obj, kind="prop", node_id="car", asset_id="car")


@every("key", CARS)
def test_a_car_in_sections_is_the_whole_car(key: str) -> None:
    obj = _placed(key)
    faces = len(obj.data.polygons)
    names = split_sections(obj, {})
    assert {"steering_wheel", "pedals", "seat_driver", "dashboard", "door_driver"} <= {*names}
    assert sum(len(each.data.polygons) for each in with_sections(obj)) == faces


@every("key", CARS)
def test_every_declared_section_is_built(key: str) -> None:
    build = build_prop(key)
    declared = {anchor.name for anchor in build.anchors if anchor.kind in ("part", "panel")}
    assert declared == {*build.mesh["panels"].split()}


@every("key", CARS)
def test_a_section_is_where_its_anchor_says(key: str) -> None:
    build = build_prop(key)
    obj = _placed(key)
    split_sections(obj, {})
    own = {str(each["section"]): each for each in with_sections(obj)[1:]}
    for anchor in build.anchors:
        if anchor.kind == "part":
            points = [vertex.co for vertex in own[f"car_{anchor.name}"].data.vertices]
            for axis in (0, 1):
                middle = (min(p[axis] for p in points) + max(p[axis] for p in points)) / 2
                assert middle == pytest.approx(anchor.location[axis], abs=0.25), anchor.name


def test_a_part_of_the_story_is_the_cars_own() -> None:
    obj = _placed("car")
    split_sections(obj, {"mirror": ("her_mirror", "her_mirror")})
    assert dict(fitted_in(obj)) == {"mirror": ("her_mirror", "her_mirror")}
    (mirror,) = (each for each in with_sections(obj) if each["node_id"] == "her_mirror")
    assert is_hidden_by(mirror, ("car_mirror",)) and is_hidden_by(mirror, ("her_mirror",))
    assert {each["node_id"] for each in with_sections(obj)} == {"car", "her_mirror"}


def test_a_chair_has_no_sections() -> None:
    obj = _placed("chair")
    assert split_sections(obj, {}) == [] and with_sections(obj) == [obj]

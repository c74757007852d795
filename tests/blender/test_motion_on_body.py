"""What no hand holds is on the body where it belongs, in every posture, and goes along."""

from __future__ import annotations

import bpy  # noqa: F401  # mathutils is its
import numpy as np
import pytest
from mathutils import Vector
from tests.blender.motion_stage import Playback, build_bodies, chair_at, cue_of, mark_at, perform, world_at

from storyblender.blender.motion.plan import StageProp
from storyblender.blender.people.body import RiggedBody
from storyblender.memory.shot_context import PropState
from storyblender.memory.vocabulary import BodyPlace

SIZES: dict[BodyPlace, tuple[float, float, float]] = {
    "head": (0.3, 0.34, 0.15), "face": (0.14, 0.14, 0.045), "ears": (0.19, 0.09, 0.2), "mouth": (0.01, 0.085, 0.01),
    "neck": (0.19, 0.22, 0.012), "chest": (0.06, 0.2, 0.004), "back": (0.32, 0.2, 0.45), "hip": (0.31, 0.14, 0.34),
    "shoulder": (0.06, 1.1, 0.19), "under_arm": (0.28, 0.38, 0.03), "lap": (0.34, 0.3, 0.23),
}  # fmt: skip
NEAR: dict[BodyPlace, tuple[str, float]] = {
    "head": ("head", 0.3), "face": ("head", 0.18), "ears": ("head", 0.25), "mouth": ("head", 0.2),
    "neck": ("neck", 0.3),
    "chest": ("upper_chest", 0.3), "back": ("upper_chest", 0.45), "hip": ("hips", 0.45),
    "shoulder": ("upper_arm.R", 0.5),
    "under_arm": ("upper_arm.L", 0.3), "lap": ("hips", 0.5),
}  # fmt: skip
"""The bone that a thing is at, and within how many metres times the stature its middle is from it."""


@pytest.fixture(scope="module")
def bodies() -> dict[str, RiggedBody]:
    return build_bodies()


def _worn(place: BodyPlace, who: str) -> StageProp:
    state = PropState(asset_id="it", held_by=who, place=place)
    return StageProp(world_at(0, 0, -5), SIZES[place], state=state)


def _middle(path: np.ndarray, frame: int, place: BodyPlace) -> Vector:
    return Vector((path[frame] @ (0, 0, SIZES[place][2] / 2, 1))[:3])


@pytest.mark.parametrize("place", SIZES)
@pytest.mark.parametrize("who", ["man", "girl"])
def test_it_is_at_its_place_and_goes_along(bodies: dict[str, RiggedBody], who: str, place: BodyPlace) -> None:
    shot = perform(
        bodies, (mark_at(who, 0, 0),), (cue_of(who, "walk", 2, mark=mark_at(who, 2.0, 0, 90)),), 4,
        ends=(mark_at(who, 2.0, 0, 90),), props={"it": _worn(place, who)},
    )  # fmt: skip
    played, (bone, far) = Playback(bodies[who], shot, who), NEAR[place]
    for frame in (0, 40, len(shot.props["it"]) - 1):
        assert (_middle(shot.props["it"], frame, place) - played.joint(bone, frame)).length < far


@pytest.mark.parametrize("place", ["chest", "back", "hip", "under_arm"])
def test_it_lies_on_the_body_and_not_in_it(bodies: dict[str, RiggedBody], place: BodyPlace) -> None:
    shot = perform(bodies, (mark_at("man", 0, 0),), (), 1, props={"it": _worn(place, "man")})
    arm = bodies["man"]
    skin = Playback(arm, shot, "man").skin(0)
    width, depth, height = SIZES[place]
    local = np.c_[skin, np.ones(len(skin))] @ np.linalg.inv(shot.props["it"][0]).T
    inside = (
        (np.abs(local[:, 0]) < width / 2 - 0.02)
        & (np.abs(local[:, 1]) < depth / 2 - 0.02)
        & (local[:, 2] > 0.02)
        & (local[:, 2] < height - 0.02)
    )
    assert inside.mean() < 0.01


def test_what_is_on_the_lap_is_on_the_thighs_of_who_sits(bodies: dict[str, RiggedBody]) -> None:
    mark = mark_at("man", 0, -0.24, posture="sit", support_id="chair", anchor_name="seat")
    shot = perform(bodies, (mark,), (), 1, furniture={"chair": chair_at(0, 0)}, props={"it": _worn("lap", "man")})
    x, y, z = shot.props["it"][0][:3, 3]
    assert abs(x) < 0.1 and -0.75 < y < -0.15 and 0.5 < z < 0.75


def test_what_hangs_on_the_belt_touches_the_hip(bodies: dict[str, RiggedBody]) -> None:
    size = (0.04, 0.14, 0.32)
    hammer = StageProp(world_at(0, 0, -5), size, state=PropState(asset_id="it", held_by="man", place="hip"))
    shot = perform(bodies, (mark_at("man", 0, 0),), (), 1, props={"it": hammer})
    skin = Playback(bodies["man"], shot, "man").skin(0)
    local = np.c_[skin, np.ones(len(skin))] @ np.linalg.inv(shot.props["it"][0]).T
    outside = np.abs(local[:, :3] - (0, 0, size[2] / 2)) - np.array(size) / 2
    assert np.linalg.norm(np.maximum(outside, 0), axis=1).min() < 0.03

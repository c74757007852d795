"""Clips of other programs come onto our skeleton, whatever their names, units, axes, rates and rests."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
from tests.every import every
from tests.motion_files import CONVENTIONS, Style, Walker, a_person, write_bvh

from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.geometry.mocap import BONES, RATE, MocapPoses
from storyblender.geometry.rotations import about_axis, matrices_of
from storyblender.geometry.solids import Floats
from storyblender.library.mocap.bvh import parse_bvh
from storyblender.library.mocap.folders import MotionFolders
from storyblender.library.mocap.retarget import retarget
from storyblender.memory.mocap import mocap_file

RAISED = 60.0
"""Degrees by which the left arm is raised, at the middle of the clip."""


def _does(t: float) -> Mapping[str, Floats]:
    """Both arms come down, the left one is raised again and bent, the head turns, the knees give."""
    share = math.sin(math.pi * min(1.0, t / 2.0))
    down, bend = math.radians(80), math.radians(70 * share)
    knee = math.radians(40 * share)
    sink = 0.41 * 2 * (1 - math.cos(knee / 2 * 2)) / 2
    own: dict[str, Floats] = {
        "upper_arm.L": about_axis(1, np.array(down - math.radians(RAISED * share))),
        "upper_arm.R": about_axis(1, np.array(-down)),
        "forearm.L": about_axis(2, np.array(-bend)),
        "head": about_axis(2, np.array(math.radians(50 * share))),
        "spine": about_axis(0, np.array(math.radians(15 * share))),
        "place": np.array([0.0, 0.0, -sink]),
    }
    for side in "LR":
        own |= {f"thigh.{side}": about_axis(0, np.array(-knee)), f"shin.{side}": about_axis(0, np.array(2 * knee))}
        own |= {f"foot.{side}": about_axis(0, np.array(-knee))}
    return own


def _angle(turns: Floats, others: Floats) -> Floats:
    """Degrees between rotations."""
    trace = np.trace(np.swapaxes(turns, -1, -2) @ others, axis1=-2, axis2=-1)
    return np.degrees(np.arccos(np.clip((trace - 1) / 2, -1, 1)))


def _wrong(walker: Walker, poses: MocapPoses) -> float:
    """Largest difference in degrees of the limbs' directions and of head and trunk, at matching times."""
    turns = matrices_of(poses.turns)
    count = len(walker.hips)
    best = 180.0
    for late in range(0, int(0.5 * RATE)):  # what does not move at the start is cut
        times = np.arange(len(turns)) / RATE * walker.rate + late / RATE * walker.rate
        if times[-1] > count - 1 + 0.5:
            continue
        rows = np.minimum(np.round(times).astype(int), count - 1)
        worst = 0.0
        for index, bone in enumerate(BONES):
            if bone in ("spine", "chest", "neck"):
                continue
            wanted, found = walker.turns[bone][rows], turns[:, index]
            if bone.startswith(("thigh", "shin", "upper_arm", "forearm")):
                axis = [0, 0, -1] if bone[0] in "ts" else [1 if bone.endswith("L") else -1, 0, 0]
                cosine = np.sum((wanted @ np.array(axis, float)) * (found @ np.array(axis, float)), axis=-1)
                worst = max(worst, float(np.degrees(np.arccos(np.clip(cosine, -1, 1))).max()))
            else:
                worst = max(worst, float(_angle(wanted, found).max()))
        best = min(best, worst)
    return best


@every("convention", sorted(CONVENTIONS))
def test_joints_are_known_by_the_names_of_any_program_or_by_the_shape(convention: str) -> None:
    walker = a_person(30.0, 2.0, _does)
    wrong = _wrong(walker, retarget(parse_bvh(write_bvh(walker, Style(convention=convention)))))
    assert wrong < (15 if convention == "nameless" else 1)  # fingers without names say the hand only roughly


@pytest.mark.parametrize(
    "style",
    [
        Style(unit=1.0, up="z"),
        Style(unit=39.37, order="ZXY"),
        Style(unit=100.0, order="XYZ", first_is_rest=True),
        Style(unit=2.5, order="YXZ", up="z"),
    ],
)
@pytest.mark.parametrize("rate", [24.0, 60.0, 119.88])
def test_units_axes_orders_and_rates_are_found(style: Style, rate: float) -> None:
    walker = a_person(rate, 2.0, _does)
    poses = retarget(parse_bvh(write_bvh(walker, style)))
    assert _wrong(walker, poses) < 4.0  # a frame of the fastest joint
    assert poses.seconds == pytest.approx(2.0, abs=0.35)
    assert poses.hips[:, 2].max() == pytest.approx(1.0, abs=0.02)
    assert poses.hips[:, 2].min() < 0.9


def test_a_rest_that_is_no_pose_of_a_person_gives_way_to_a_frame_that_is_one() -> None:
    walker = a_person(30.0, 2.0, _does)
    assert _wrong(walker, retarget(parse_bvh(write_bvh(walker, Style(pose="along"))))) < 5.0


def test_a_walk_has_a_path_and_feet_that_stand() -> None:
    def walks(t: float) -> Mapping[str, Floats]:
        own: dict[str, Floats] = {"place": np.array([0.0, -1.2 * t, 0.0])}
        for side, phase in (("L", 0.0), ("R", math.pi)):
            swing = math.radians(25) * math.sin(2 * math.pi * t + phase)
            own[f"thigh.{side}"] = about_axis(0, np.array(swing))
        return own

    poses = retarget(parse_bvh(write_bvh(a_person(30.0, 3.0, walks), Style())))
    legs = 0.82
    assert poses.travel * legs == pytest.approx(3.6, abs=0.3)
    assert abs(poses.root[-1, 0]) < 0.1, "straight ahead"
    assert poses.root[-1, 1] < 0, "people face -Y"


def test_a_turned_person_turns_the_root() -> None:
    def turns(t: float) -> Mapping[str, Floats]:
        return {"hips": about_axis(2, np.array(math.radians(45 * t)))}

    poses = retarget(parse_bvh(write_bvh(a_person(30.0, 3.0, turns), Style(up="z", unit=1.0))))
    assert math.degrees(poses.root[-1, 2]) == pytest.approx(135, abs=12)


def test_equal_files_give_equal_bytes_and_come_back_as_they_were() -> None:
    text = write_bvh(a_person(30.0, 2.0, _does), Style())
    poses, again = retarget(parse_bvh(text)), retarget(parse_bvh(text))
    assert poses.save() == again.save()
    loaded = MocapPoses.load(poses.save())
    assert loaded.digest == poses.digest
    assert np.abs(loaded.turns - poses.turns).max() < 1e-3


WHOLE = write_bvh(a_person(30.0, 1.0, _does), Style())


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "no BVH"),
        ("HIERARCHY\nROOT a\n{\n", "no BVH"),
        (WHOLE.replace("Frames: 31", "Frames: 999999999"), "number"),
        (WHOLE.replace("Frames: 31", "Frames: -5"), "frames"),
        (WHOLE.replace("Frames: 31", "Frames: 900000"), "frames"),
        (WHOLE.replace("Frame Time: 0.03333333", "Frame Time: 0"), "frames"),
        (WHOLE.replace("Frame Time: 0.03333333", "Frame Time: nan"), "number"),
        (WHOLE.replace("Frame Time: 0.03333333", "Frame Time: 1e-9"), "frames a second"),
        (WHOLE.replace("OFFSET", "OFFSET nan nan nan #", 1), "number"),
        (WHOLE.replace("OFFSET", "OFFSET 1e300 0 0 #", 1), "number"),
        (WHOLE.replace("Zrotation", "Wrotation", 1), "channel"),
        (WHOLE.replace("CHANNELS 3", "CHANNELS 9999999", 1), "channels"),
        (WHOLE[: WHOLE.index("MOTION")] + "MOTION\nFrames: 2\nFrame Time: 0.1\n1 2 3\n", "only a pose"),
        (WHOLE[: WHOLE.index("Frame Time") + 22] + " inf" * 9000, "finite"),
        (WHOLE[: WHOLE.index("Frame Time") + 22] + " abc" * 9000, "words"),
        ("HIERARCHY\n" + "ROOT a\n{\n" * 5000 + "MOTION\nFrames: 2\nFrame Time: 0.1\n", "joints"),
        ("HIERARCHY\n" + "}\n" * 50 + "MOTION\nFrames: 2\nFrame Time: 0.1\n", "odd word"),
    ],
)  # fmt: skip
def test_damaged_and_hostile_files_are_refused_in_one_clause(text: str, said: str) -> None:
    with pytest.raises(InputError) as error:
        retarget(parse_bvh(text))
    assert said in error.value.problem
    assert len(error.value.problem) < 120


def test_a_skeleton_that_is_no_person_is_refused() -> None:
    text = "HIERARCHY\nROOT tail\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n}\n"
    with pytest.raises(InputError, match="two arms and two legs"):
        retarget(parse_bvh(text + "MOTION\nFrames: 2\nFrame Time: 0.1\n0 0 0\n1 1 1\n"))


@pytest.mark.parametrize("damage", [b"", b"PK\x03\x04", b"\0" * 500])
def test_a_damaged_archive_is_no_motion(damage: bytes) -> None:
    with pytest.raises(ValueError, match=r"motion|damaged"):
        MocapPoses.load(damage)


def test_a_clip_is_kept_in_the_project_with_whose_work_it_is(tmp_path: Path) -> None:
    clips = tmp_path / "clips" / "sitting"
    clips.mkdir(parents=True)
    (clips / "AngryArgument_02.bvh").write_text(write_bvh(a_person(30.0, 2.0, _does)))
    (clips / "motions.toml").write_text(
        '["AngryArgument_02.bvh"]\ndescription = "argues"\nloop = true\nposture = "stand"\n'
    )
    (clips.parent / "credits.toml").write_text('author = "Ann"\nlicense = "CC-BY-4.0"\n')
    folders = MotionFolders([tmp_path / "clips"])
    file = folders.called("angryargument_02")
    assert file is not None
    project = tmp_path / "film"
    project.mkdir()
    clip = folders.take_in(file, Folder(project))
    assert (clip.name, clip.loops, clip.seated, clip.provenance.author) == ("angry argument", True, False, "Ann")
    assert MocapPoses.load((project / mocap_file(clip.digest)).read_bytes()).digest == clip.digest
    (clips / "outside.bvh").symlink_to("/etc/hostname")
    outside = next(each for each in MotionFolders([tmp_path / "clips"]).files if each.name.endswith("outside.bvh"))
    with pytest.raises(InputError, match="out of its folder"):
        folders.take_in(outside, Folder(project))

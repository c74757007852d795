"""``python -m benchmarks motions [FILE OR FOLDER ...]``: clips on people of three sizes, against what was recorded.

For each clip and person: degrees between the limbs as recorded and as performed, without the fades; millimetres a frame
by which heels and balls slide on the floor; the lowest toe; seconds to read the clip, and to solve a second of it.
Without files the solver's own motions are written as BVH files and read back.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import bpy
import numpy as np
from tests.blender.motion_stage import FPS, Playback, build_bodies, cue_of, mark_at, perform
from tests.blender.test_motion_mocap import recorded, replayed, slides
from tests.motion_files import write_bvh

from storyblender.blender.motion.mocap import FADE
from storyblender.blender.people.body import RiggedBody
from storyblender.errors import InputError
from storyblender.geometry.mocap import BONES, RATE, MocapPoses
from storyblender.geometry.rotations import matrices_of
from storyblender.library.mocap.bvh import parse_bvh
from storyblender.library.mocap.folders import LEG, READERS
from storyblender.library.mocap.retarget import retarget

OWN = ("walk", "run", "wave", "dance", "bow", "clap", "laugh", "shrug")
LIMBS = {"upper_arm": "forearm", "forearm": "hand", "thigh": "shin", "shin": "foot"}
AXES = {"upper_arm": (1, 0, 0), "forearm": (1, 0, 0), "thigh": (0, 0, -1), "shin": (0, 0, -1)}


def main(names: list[str]) -> None:
    """Print the table."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bodies = build_bodies("man", "woman", "girl")
    head = f"{'clip':28} {'who':6} {'s':>5} {'deg mean':>8} {'p95':>6} {'slide p99':>9} {'max mm':>7}"
    print(f"{head} {'toe cm':>6} {'read s':>6} {'s/s':>5}")
    for name, poses, read in _files(names) if names else _own(bodies["man"]):
        for who, body in bodies.items():
            print(f"{name[:28]:28} {who:6} {_row(poses, body, who, read)}", flush=True)


def _row(poses: MocapPoses, body: RiggedBody, who: str, read: float) -> str:
    start = mark_at(who, 0, 0)
    led = poses.root[-1, :2] * LEG * body.stature / 1.7
    end = mark_at(who, float(led[0]), float(led[1]), float(np.degrees(poses.root[-1, 2])))
    began = time.perf_counter()
    shot = replayed(body, poses, who, start, end if poses.travel * LEG > 0.25 else None, extra=1.0)
    taken = time.perf_counter() - began
    wrong, slid = _wrong(poses, Playback(body, shot, who), who), slides(body, shot, who) * 1000
    play = Playback(body, shot, who)
    low = min(play.joint(f"toe.{side}", frame).z for side in "LR" for frame in range(0, len(shot.frames), 3))
    told = f"{poses.seconds:5.1f} {wrong.mean():8.1f} {np.percentile(wrong, 95):6.1f} "
    told += f"{np.percentile(slid, 99) if len(slid) else 0:9.1f} {slid.max() if len(slid) else 0:7.1f}"
    return f"{told} {low * 100:6.1f} {read:6.2f} {taken / max(poses.seconds, 0.1):5.2f}"


def _wrong(poses: MocapPoses, play: Playback, who: str) -> np.ndarray:
    """Return the degrees between limbs as recorded and as performed, one a limb and frame."""
    turns, found = matrices_of(poses.turns), list[float]()
    first, last = int(FADE * FPS) + 1, int((poses.seconds - FADE) * FPS) - 1
    for frame in range(first, max(first + 1, last), 2):
        row = min(round(frame / FPS * RATE), len(turns) - 1)
        yaw = play.track.root[frame, 3]
        back = np.array([[np.cos(yaw), np.sin(yaw), 0], [-np.sin(yaw), np.cos(yaw), 0], [0, 0, 1]])
        posed = play.matrices(frame)
        for bone, below in LIMBS.items():
            for side, s in (("L", 1), ("R", -1)):
                axis = np.array(AXES[bone], float) * (s if bone in ("upper_arm", "forearm") else 1)
                wanted = turns[row, BONES.index(f"{bone}.{side}")] @ axis
                way = np.array(posed[f"{below}.{side}"].translation - posed[f"{bone}.{side}"].translation)
                cosine = wanted @ (back @ way) / np.linalg.norm(way)
                found.append(float(np.degrees(np.arccos(np.clip(cosine, -1, 1)))))
    return np.array(found)


def _files(names: list[str]) -> list[tuple[str, MocapPoses, float]]:
    paths = [
        path for name in names for path in ([Path(name)] if Path(name).is_file() else sorted(Path(name).rglob("*")))
    ]
    found: list[tuple[str, MocapPoses, float]] = []
    for path in (each for each in paths if each.suffix.lower() in READERS):
        began = time.perf_counter()
        try:
            poses = retarget(READERS[path.suffix.lower()](path))
        except InputError as error:
            print(f"{path.name[:28]:28} {error}")
            continue
        found.append((path.stem, poses, time.perf_counter() - began))
    return found


def _own(body: RiggedBody) -> list[tuple[str, MocapPoses, float]]:
    found: list[tuple[str, MocapPoses, float]] = []
    for clip in OWN:
        end = mark_at("man", 0, -4 if clip in ("walk", "run") else 0)
        shot = perform({"man": body}, (mark_at("man", 0, 0),), (cue_of("man", clip, 4, mark=end),), 5, ends=(end,))
        text = write_bvh(recorded(body, shot, "man"))
        began = time.perf_counter()
        found.append((clip, retarget(parse_bvh(text)), time.perf_counter() - began))
    return found


if __name__ == "__main__":
    main(sys.argv[1:])

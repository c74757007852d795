"""What was asked of a camera against what a client of the server can measure; no critic is asked.

The client knows the graph (cameras as stored), and of every frame that is drawn again who is in it and how large.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from storyblender.geometry.camera_path import orbit_of
from storyblender.geometry.framing import Film
from storyblender.geometry.orbit import Orbit
from storyblender.memory.shot_context import CameraPose
from storyblender.memory.shot_sizes import SHOT_SIZES, SIZES

TILT = {
    "eye-level": (-12, 26), "high angle": (12, 60), "low angle": (-45, -4), "bird's-eye": (42, 90),
    "worm's-eye": (-70, -14), "dutch": (-12, 26),
}  # fmt: skip
"""Degrees that the camera looks down."""
SEEN, SHOULDER = 0.0004, 0.02
"""Share of the picture that a person in it covers at least, and one whose shoulder is in front."""
READABLE = 110
"""Degrees by which the face of the first person may be turned from the camera in a picture of faces."""


@dataclass(frozen=True)
class Wanted:
    """What a framing request means, in what can be measured; what is left empty is not looked at.

    Attributes:
        size: Shot size of the first person.
        steps: Sizes tighter (or, below 0, wider) than the frame before.
        angle: A key of ``TILT``.
        lens: mm.
        f_number: Of the lens.
        move: As ``move_of`` calls it; ``static`` for a camera that stands still.
        people: Ids of those who are in the picture; the first shows the face in sizes from FS.
        things: Ids of things that are in the picture.
        over: Id of the person over whose shoulder it looks.
        pov: Id of the person through whose eyes it looks.
        rack: Ids of what is sharp first and last.
    """

    size: str = ""
    steps: int = 0
    angle: str = ""
    lens: float = 0
    f_number: float = 0
    move: str = ""
    people: tuple[str, ...] = ()
    things: tuple[str, ...] = ()
    over: str = ""
    pov: str = ""
    rack: tuple[str, str] | None = None


def misses(wanted: Wanted, before: dict[str, Any], shot: dict[str, Any], seen: dict[str, dict[str, Any]]) -> list[str]:
    """Return what of a request cannot be measured in its frame, a few words each.

    Args:
        wanted: The request.
        before: The shot as the graph had it.
        shot: The shot as the graph has it now.
        seen: Who and what is in the frame by id, as the server says it.
    """
    poses = [CameraPose.model_validate(pose) for pose in shot["camera"]["poses"]]
    ends = [orbit_of(pose, Film()) for pose in poses]
    found = [*_size(wanted, before, shot, seen), *_company(wanted, shot, seen)]
    down, roll = ends[0].elevation, abs(ends[0].roll)
    if wanted.angle and not TILT[wanted.angle][0] <= down <= TILT[wanted.angle][1]:
        found.append(f"looks down {down:.0f} degrees")
    if wanted.angle == "dutch" and roll < 6:
        found.append(f"leans {roll:.0f} degrees")
    if wanted.lens and abs(ends[0].lens / wanted.lens - 1) > 0.03:
        found.append(f"{ends[0].lens:.0f} mm")
    if wanted.f_number and shot["camera"]["f_number"] != wanted.f_number:
        found.append(f"f/{shot['camera']['f_number']:g}")
    if wanted.move and (move := move_of(ends[0], ends[-1])) != wanted.move:
        found.append(f"camera: {move}")
    if wanted.rack is not None:
        keys = [key.get("node_id") for key in shot["camera"].get("focus", ())]
        if not keys or (keys[0], keys[-1]) != wanted.rack:
            found.append(f"focus: {keys}")
    return found


def size_of(head: float) -> str:
    """Return the shot size that is nearest to a head of that share of the picture's height."""
    return min(SHOT_SIZES, key=lambda size: abs(math.log(max(head, 1e-4) / SIZES[size].head)))


def move_of(first: Orbit, last: Orbit) -> str:
    """Return what a camera does between two positions, in the words of film people."""
    way = last.position - first.position
    across, up, back = (float(value) for value in first.axes.T @ way)
    turn = math.remainder(last.azimuth - first.azimuth, 360)
    if math.hypot(across, up, back) < 0.1:
        if abs(math.log(last.lens / first.lens)) > 0.05:
            return "zoom in" if last.lens > first.lens else "zoom out"
        tilt = first.elevation - last.elevation
        if max(abs(turn), abs(tilt)) < 1:
            return "static"
        if abs(turn) < abs(tilt):
            return "tilt up" if tilt > 0 else "tilt down"
        return "pan left" if turn > 0 else "pan right"
    if abs(turn) > 8:
        return "orbit"
    if abs(back) > max(abs(across), abs(up)):
        return "push in" if back < 0 else "pull out"
    if abs(up) > abs(across):
        return "pedestal up" if up > 0 else "pedestal down"
    return "truck right" if across > 0 else "truck left"


def _size(wanted: Wanted, before: dict[str, Any], shot: dict[str, Any], seen: dict[str, Any]) -> list[str]:
    """Return what is wrong with the shot size. Several people may be taken from two sizes further away.

    The first thing of an insert fills six tenths of what its shot size says at least.
    """
    at = SHOT_SIZES.index(before["camera_instruction"]["size"]) + wanted.steps
    asked = wanted.size or (SHOT_SIZES[at] if wanted.steps else "")
    focus = shot["camera_instruction"].get("focus_on_ids", ())
    people = [seen[each] for each in focus if each in seen and seen[each]["head"]]
    if wanted.things:
        size = SIZES[shot["camera_instruction"]["size"]]
        left, top, right, bottom = seen.get(wanted.things[0], {}).get("box") or (0, 0, 0, 0)
        fills = max(right - left, bottom - top)
        return [] if fills >= 0.6 * size.fill else [f"{wanted.things[0]} fills {fills:.0%}"]
    if not asked or not people:
        return []
    head = max(each["head"] for each in people)
    low, high = SIZES[asked].band
    low = SIZES[SHOT_SIZES[max(SHOT_SIZES.index(asked) - 2, 0)]].band[0] if len(people) > 1 else low
    return [] if low <= head <= high else [f"reads as {size_of(head)}, not {asked}"]


def _company(wanted: Wanted, shot: dict[str, Any], seen: dict[str, dict[str, Any]]) -> list[str]:
    """Return who and what is not in the picture as asked."""
    found = [
        f"no {each}" for each in (*wanted.people, *wanted.things) if each not in seen or seen[each]["fills"] < SEEN
    ]
    lead = seen.get(wanted.people[0]) if wanted.people else None
    faces = SHOT_SIZES.index(shot["camera_instruction"]["size"]) >= SHOT_SIZES.index("FS")
    if lead is not None and faces and (lead["turned"] > READABLE or not _inside(lead["face"])):
        found.append(f"face of {lead['who']} turned {lead['turned']}")
    over = seen.get(wanted.over)
    if wanted.over and (over is None or over["fills"] < SHOULDER):
        found.append(f"no shoulder of {wanted.over}")
    elif over is not None and (over["turned"] < 95 or lead is None or over["head"] <= lead["head"]):
        found.append(f"{wanted.over} is not seen from behind")
    if wanted.pov and wanted.pov in seen and seen[wanted.pov]["fills"] > SHOULDER:
        found.append(f"{wanted.pov} is in the picture")
    return found


def _inside(face: list[float] | None) -> bool:
    return face is not None and all(-0.02 < value < 1.02 for value in face)

"""Judges whether a frame is as a person asked for: its size, angle, lens and move, its subjects, and whose shoulder."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from storyblender.agents.frame_critic.action_faults import NOT_ACCEPTED, fault
from storyblender.agents.frame_critic.frame_view import FrameView
from storyblender.agents.layout_artist.story_moment import board_frame
from storyblender.geometry.camera_path import camera_at
from storyblender.geometry.framing import Film
from storyblender.memory.measure import SubjectView
from storyblender.memory.shot_context import CameraDecision, CameraInstruction
from storyblender.memory.shot_sizes import SIZES
from storyblender.reflection import Fault

_OTHER_SIZE = 1.7
"""Factor between the height of a head and that of its shot size from which the picture is of another size."""
_OF_SEVERAL = 3.0
"""The same for smaller heads where a picture holds several people: it is taken from as far as they need."""
_TILT: Final[dict[str, tuple[float, float]]] = {
    "eye-level": (-12.0, 26.0), "high angle": (12.0, 60.0), "low angle": (-45.0, -4.0),
    "bird's-eye": (42.0, 90.0), "worm's-eye": (-70.0, -14.0), "dutch": (-12.0, 26.0),
}  # fmt: skip
"""Degrees that a camera looks down, in which an angle still reads as what it is called."""
_LEANS = 6.0
"""Least degrees by which the horizon of a dutch angle leans."""
_SEEN, _SHOULDER = 0.0004, 0.02
"""Least share of the picture for a person who was asked for, and for one whose shoulder the camera looks over."""
_FROM_BEHIND = 95.0
"""Least degrees between the camera and the face of a person whose shoulder it looks over."""
_OTHER_LENS = 0.03
"""Share by which a lens may differ from the one asked for."""
_INSERT_DOWN = 45.0
"""Most degrees that an insert looks down at a thing at eye level: what lies on a table is seen from above."""
_THING = 0.6
"""Share of the extent that a thing of an insert has at its shot size, at least."""
_ZOOMS = ("zoom in", "zoom out")


def find_order_faults(view: FrameView) -> list[Fault]:
    """Return what of a person's decision about the camera the frame does not show; none where nothing was decided."""
    decision, shot = view.shot.camera_decision, view.shot
    if decision is None or shot.camera is None or decision.placed is not None:
        return []
    checks = (_size_faults, _camera_faults, _subject_faults, _shoulder_faults)
    return [each for check in checks for each in check(view, decision, shot.camera_instruction)]


def _size_faults(view: FrameView, decision: CameraDecision, instruction: CameraInstruction) -> Iterator[Fault]:
    """Yield the fault of heads that are those of another shot size."""
    people = [seen for seen in _focus(view, instruction) if seen.node_id in view.people and seen.head_height > 0]
    if decision.size is not None and instruction.kind == "insert":
        yield from _insert_faults(view, instruction)
    if decision.size is None or not people or instruction.kind in ("insert", "pov", "establishing"):
        return
    largest, wanted = max(people, key=lambda seen: seen.head_height), SIZES[decision.size]
    ratio = largest.head_height / wanted.head
    if ratio > _OTHER_SIZE or ratio < 1 / (_OF_SEVERAL if len(people) > 1 else _OTHER_SIZE):
        share, told = largest.head_height, f"in {_an(wanted.words)} it is {wanted.head:.0%}"
        text = f"the head of {largest.node_id} fills {share:.0%} of the height; {told}"
        yield fault("not_the_size", largest.node_id, NOT_ACCEPTED, text)


def _insert_faults(view: FrameView, instruction: CameraInstruction) -> Iterator[Fault]:
    """Yield the fault of an insert whose first thing fills too little of the picture."""
    thing = view.subject(instruction.focus_on_ids[0]) if instruction.focus_on_ids else None
    if thing is None or thing.box is None or thing.node_id in view.people:
        return
    left, top, right, bottom = thing.box
    share, wanted = max(right - left, bottom - top), SIZES[instruction.size]
    if share < _THING * wanted.fill:
        text = f"{thing.node_id} fills {share:.0%} of the picture; in {_an(wanted.words)} it is {wanted.fill:.0%}"
        yield fault("not_the_size", thing.node_id, NOT_ACCEPTED, text)


def _camera_faults(view: FrameView, decision: CameraDecision, instruction: CameraInstruction) -> Iterator[Fault]:
    """Yield the faults of another angle, another lens, and a camera that stands still."""
    state = view.shot.camera
    assert state is not None
    camera = camera_at(state, board_frame(view.shot, view.played), Film(state.sensor_width, view.aspect))
    if decision.angle is not None and instruction.kind != "pov":
        low, high = _TILT[decision.angle]
        high = max(high, _INSERT_DOWN) if instruction.kind == "insert" else high
        level = decision.angle == "dutch" and abs(camera.roll) < _LEANS
        if level or not low <= camera.elevation <= high:
            way = "down" if camera.elevation > 0 else "up"
            text = f"the camera looks {abs(camera.elevation):.0f} degrees {way}{' and is level' if level else ''}"
            yield fault("not_the_angle", "", NOT_ACCEPTED, f"{text}; asked for is {decision.angle}")
    lens = state.poses[0].lens
    if decision.lens and instruction.movement not in _ZOOMS and abs(lens / decision.lens - 1) > _OTHER_LENS:
        text = f"the lens is {lens:.0f} mm; asked for are {decision.lens:g} mm"
        yield fault("not_the_lens", "", NOT_ACCEPTED, text)
    if decision.movement not in (None, "static") and len(state.poses) < 2:
        yield fault("no_move", "", NOT_ACCEPTED, f"the camera stands still; asked for is {decision.movement}")


def _subject_faults(view: FrameView, decision: CameraDecision, instruction: CameraInstruction) -> Iterator[Fault]:
    """Yield the faults of people who were asked for and are not in the picture, from the third on (see ``critic``)."""
    for asset_id in (decision.focus_on_ids or ())[2:]:
        subject = view.subject(asset_id)
        if asset_id in view.shot.on_stage and (subject is None or subject.pixels < _SEEN):
            yield fault("person_missing", asset_id, NOT_ACCEPTED, f"{asset_id} is not seen")


def _shoulder_faults(view: FrameView, decision: CameraDecision, instruction: CameraInstruction) -> Iterator[Fault]:
    """Yield the fault of a picture that does not look over the shoulder that was asked for."""
    if decision.over_id is None or instruction.kind != "ots":
        return
    over, focus = view.subject(decision.over_id), _focus(view, instruction)
    nearer = over is not None and over.head_height > max((seen.head_height for seen in focus), default=0.0)
    if over is None or over.pixels < _SHOULDER or over.face_angle < _FROM_BEHIND or not nearer:
        text = f"the camera does not look over the shoulder of {decision.over_id}"
        yield fault("no_shoulder", decision.over_id, NOT_ACCEPTED, text)


def _an(words: str) -> str:
    return f"{'an' if words[0] in 'aeiou' else 'a'} {words}"


def _focus(view: FrameView, instruction: CameraInstruction) -> list[SubjectView]:
    """Return the subjects of the instruction that are in the picture."""
    found = (view.subject(each) for each in instruction.focus_on_ids)
    return [each for each in found if each is not None and each.pixels >= _SEEN]

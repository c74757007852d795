"""What a person types, or a program writes, becomes typed edits; what is not in the vocabulary is refused."""

from __future__ import annotations

import re
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, get_args

from pydantic import ValidationError
from pydantic_core import from_json

from storyblender.catalog.materials import hex_color
from storyblender.edits.targets import as_id
from storyblender.errors import InputError
from storyblender.memory.camera_decision import CameraPosition, FreeCamera
from storyblender.memory.edits import EDITS, Edit
from storyblender.memory.shot_context import CameraDecision
from storyblender.memory.shot_sizes import ShotSize
from storyblender.memory.vocabulary import Angle, CameraDirection, Movement, ShotKind

Word = str | float | Sequence[str] | FreeCamera
CHOICES = {
    "size": get_args(ShotSize),
    "angle": get_args(Angle),
    "movement": get_args(Movement),
    "kind": get_args(ShotKind),
}


def camera_decision(words: Mapping[str, Word]) -> CameraDecision:
    """Read what a person says about a camera.

    Args:
        words: Fields of ``CameraDecision``; ``movement`` may end in its direction, as in ``pan left``, and people and
            things may be called as the script calls them.

    Raises:
        InputError: A word is not in the vocabulary.
    """
    said: dict[str, Any] = dict(words)
    move, _, way = str(words.get("movement", "")).rpartition(" ")
    if way in get_args(CameraDirection):
        said |= {"movement": move, "direction": way}
    for field in {"over_id", "pov_id", "focus", "focus_to"} & said.keys():
        said[field] = as_id(str(said[field]))
    if "focus_on_ids" in words:
        said["focus_on_ids"] = tuple(as_id(name) for name in said["focus_on_ids"])
    if "kind" in said:
        said["kind"] = str(said["kind"]).lower().replace("-", "_")
    try:
        return CameraDecision.model_validate(said)
    except ValidationError as error:
        fault = error.errors()[0]
        name = str(fault["loc"][0])
        given = words.get(name, "")
        if name in CHOICES:
            mend = f"it is one of: {', '.join(CHOICES[name])}"
        elif name == "lens":
            mend = "it is a number of mm, 4 to 1200"
        else:
            mend = fault["msg"][:1].lower() + fault["msg"][1:]
        raise InputError(f"{name.replace('_', ' ')} cannot be {given!r}", mend=mend) from error


def placed_camera(at: str | None, look_at: str | None, to: str | None, to_look_at: str | None) -> FreeCamera:
    """Read where a person places a camera.

    Args:
        at: Where it stands: ``X,Y,Z`` in metres.
        look_at: What it looks at, likewise.
        to: Where it travels, if it does.
        to_look_at: What it looks at there; None for what it looked at before.

    Raises:
        InputError: A point is missing, or cannot be read.
    """
    if at is None or look_at is None:
        raise InputError("a placed camera stands somewhere and looks somewhere", mend="give --at and --look-at")
    try:
        start = CameraPosition(location=_point(at), target=_point(look_at))
        if to is None and to_look_at is None:
            return FreeCamera(start=start)
        end = CameraPosition(location=_point(to or at), target=_point(to_look_at or look_at))
        return FreeCamera(start=start, end=end)
    except ValidationError as error:
        raise InputError(_message(error), mend="see `storyblender edit --help`") from error


def place_edit(
    where: str,
    what: str,
    at: tuple[str | None, float | None],
    to: tuple[str | None, float | None] = (None, None),
    height: float | None = None,
    scale: float | None = None,
    *,
    via: Sequence[str] | None = None,
) -> Edit:
    """Read where a person places a thing of a scene, or a person in a shot.

    Args:
        where: A scene for a thing, a shot for a person.
        what: The thing or the person.
        at: Floor point ``X,Y`` in metres, and degrees; of a person as the shot begins.
        to: The same as it ends, of a person.
        height: Metres above the floor, of a thing.
        scale: Factor on the size of a thing.
        via: Floor points that a person walks through; ``crew`` alone gives the way back.

    Raises:
        InputError: A point cannot be read, or it says nothing, or what a thing or a person has not.
    """
    first, last = (
        {name: value for name, value in _floor_place(*each).items() if value is not None} for each in (at, to)
    )
    if "_" in where:
        if height is not None or scale is not None:
            raise InputError("people stand on the floor, as tall as they are", mend="name a scene and a thing")
        marks: dict[str, object] = {when: place for when, place in (("start", first), ("end", last)) if place}
        if via:
            marks["via"] = [] if list(via) == ["crew"] else [_floor_point(point) for point in via]
        [edit] = edits_of([{"kind": "blocking", "shot": where, "person": what, "marks": marks}])
        return edit
    if last or via:
        raise InputError(
            "things stay where they are in a scene", mend="leave --to and --via out, or name a shot and a person"
        )
    place = first if height is None else {**first, "height": height}
    [edit] = edits_of([{"kind": "place", "scene": where, "thing": what, "place": place, "scale": scale}])
    return edit


def pose_edit(shot: str, person: str, pose: Mapping[str, object], *, at_end: bool = False) -> Edit:
    """Read how a person is to be in a shot.

    Args:
        shot: Such as ``SC010_SH020``.
        person: Their id or name.
        pose: Fields of ``PersonPlace`` that are decided: ``posture``, ``on``, ``looking_at``, ``holding``.
        at_end: As the shot ends, else as it begins.

    Raises:
        InputError: It says nothing, or there is no such posture.
    """
    named: dict[str, object] = {name: as_id(str(pose[name])) for name in ("on", "looking_at") if name in pose}
    holding = pose.get("holding")
    if isinstance(holding, list | tuple):
        named["holding"] = [as_id(str(each)) for each in holding]
    marks = {"end" if at_end else "start": {**pose, **named}}
    [edit] = edits_of([{"kind": "blocking", "shot": shot, "person": person, "marks": marks}])
    return edit


def line_edit(shot: str, person: str, number: int, said: Mapping[str, object]) -> Edit:
    """Read what a person says about when a line is said in a shot.

    Args:
        shot: Such as ``SC010_SH020``.
        person: Id or name of the speaker.
        number: Of the line in the shot, from 1.
        said: Fields of ``DecidedLine``; empty gives it back to the crew.

    Raises:
        InputError: A number cannot be.
    """
    marks = {"lines": {number: dict(said) or None}}
    [edit] = edits_of([{"kind": "blocking", "shot": shot, "person": person, "marks": marks}])
    return edit


def motion_edit(shot: str, person: str, motion: str, said: Mapping[str, object], *, remove: bool = False) -> Edit:
    """Read what a person says about a motion in a shot.

    Args:
        shot: Such as ``SC010_SH020``.
        person: Their id or name.
        motion: Key or words of the motion: ``wave``.
        said: Fields of ``DecidedMotion``; None says nothing.
        remove: Whether they do not do it.

    Raises:
        InputError: A number cannot be.
    """
    given = {name: value for name, value in said.items() if value is not None}
    given |= {name: as_id(str(given[name])) for name in ("target", "prop") if name in given}
    marks = {"motions": {as_id(motion): None if remove else given}}
    [edit] = edits_of([{"kind": "blocking", "shot": shot, "person": person, "marks": marks}])
    return edit


def lamp_edit(scene: str, lamp: str, said: Mapping[str, float | str | None], *, remove: bool = False) -> Edit:
    """Read what a person says about a lamp of a scene.

    Args:
        scene: Such as ``SC010``.
        lamp: Its name.
        said: Fields of ``LampDecision``, points and colours as ``1,2,3``, kinds in any case; None says nothing.
        remove: Whether it is taken away.

    Raises:
        InputError: It says nothing, or a word or a number cannot be.
    """
    points = {"location": "X,Y,Z in metres", "target": "X,Y,Z in metres", "color": "R,G,B, each 0 to 1"}
    given: dict[str, object] = {name: value for name, value in said.items() if value is not None}
    for name in points.keys() & given.keys():
        given[name] = _numbers(str(given[name]), 3, points[name])
    if "kind" in given:
        given["kind"] = str(given["kind"]).upper()
    if remove is bool(given):
        raise InputError(f"nothing is decided about {lamp}", mend="give --power, --at ..., or --remove alone")
    decision = {"lamps": {as_id(lamp): None if remove else given}}
    [edit] = edits_of([{"kind": "light", "scene": scene, "decision": decision}])
    return edit


def paint_edit(
    thing: str | None, material: str | None, scene: str | None, said: Mapping[str, Any], *, remove: bool = False
) -> Edit:
    """Read what a person says about a material.

    Args:
        thing: A thing, a person or a piece of a set; None for all that has the material.
        material: Its name; None for the one that covers most of the thing.
        scene: Such as ``SC010``; None for the whole story.
        said: Fields of ``PaintDecision``, a color as ``#8a2f2a`` or ``0.2,0.1,0.1``; None says nothing.
        remove: Whether the paint is taken off.

    Raises:
        InputError: It says nothing, or a word or a number cannot be.
    """
    given = {name: value for name, value in said.items() if value is not None}
    if remove is bool(given):
        raise InputError("nothing is decided", mend="give --color, --roughness, --finish ..., or --remove alone")
    if "color" in given:
        color = str(given["color"])
        coded = re.fullmatch("#[0-9a-fA-F]{6}", color)
        given["color"] = hex_color(color) if coded else _numbers(color, 3, "#RRGGBB, or R,G,B, each 0 to 1")
    edit = {"kind": "paint", "thing": thing, "material": material, "scene": scene, "look": given or None}
    return edits_of([edit])[0]


def format_edit(aspect: str | None, sensor: str | None) -> Edit:
    """Read what a person says about the picture of the film.

    Args:
        aspect: Width over height: ``2.39``, ``16:9``.
        sensor: Width in mm, or its name: ``Super 35``.

    Raises:
        InputError: It is no aspect ratio or no sensor.
    """
    told = {"aspect": aspect, "sensor_width": sensor}
    return edits_of([{"kind": "format", "decision": {name: value for name, value in told.items() if value}}])[0]


def _floor_place(point: str | None, rotation: float | None) -> dict[str, object]:
    return {"location": _floor_point(point) if point else None, "rotation": rotation}


def _floor_point(text: str) -> tuple[float, ...]:
    return _numbers(text, 2, "X,Y in metres, as in 2,-3")


def _point(text: str) -> tuple[float, float, float]:
    x, y, z = _numbers(text, 3, "X,Y,Z in metres, as in 2,-3,1.6")
    return x, y, z


def _numbers(text: str, count: int, form: str) -> tuple[float, ...]:
    try:
        numbers = tuple(map(float, text.split(",")))
    except ValueError:
        numbers = ()
    if len(numbers) != count:
        raise InputError(f"{text!r} is no point", mend=f"a point is {form}")
    return numbers


def read_edits(path: Path) -> tuple[Edit, ...]:
    """Read a batch of edits from a JSON file; ``-`` is standard input.

    Raises:
        InputError: It cannot be read, or holds something else.
    """
    try:
        text = sys.stdin.buffer.read() if path == Path("-") else path.read_bytes()
        return edits_of(from_json(text, allow_inf_nan=False), path)
    except (OSError, ValueError) as error:
        raise InputError(f"cannot be read as JSON ({error})", mend="see docs/edits.md", path=path) from error


def edits_of(values: object, path: Path | None = None) -> tuple[Edit, ...]:
    """Return plain values as edits.

    Args:
        values: A list of objects, each with the ``kind`` of its edit.
        path: The file they are from, if they are.

    Raises:
        InputError: One of them is no edit.
    """
    try:
        return EDITS.validate_python(values)
    except ValidationError as error:
        raise InputError(_message(error), mend="see docs/edits.md", path=path) from error


def _message(error: ValidationError) -> str:
    """Return the first fault as a sentence, with the place where it is."""
    fault = error.errors()[0]
    place = ".".join(str(part) for part in fault["loc"])
    message = fault["msg"].removeprefix("Value error, ")
    return f"{place}: {message[:1].lower()}{message[1:]}" if place else message

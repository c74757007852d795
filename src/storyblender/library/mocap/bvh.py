"""Reads a BVH: a hierarchy of joints with offsets and channels, then a row of numbers for every frame."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Final

import numpy as np

from storyblender.errors import InputError
from storyblender.geometry.rotations import about_axis
from storyblender.geometry.solids import Floats
from storyblender.library.mocap.source_motion import MOST_FRAMES, MOST_JOINTS, SourceMotion, orientations

LARGEST: Final = 64 * 2**20
"""Bytes of a file."""
_AXES: Final = {"x": 0, "y": 1, "z": 2}
_TURNS, _MOVES = "rotation", "position"
_TOKENS: Final = 20 * MOST_JOINTS * 4
_FRAMES: Final = re.compile(r"frames\s*:\s*(\S+)\s+frame\s+time\s*:\s*(\S+)", re.IGNORECASE)
_FURTHEST: Final = 1e7


class _Joint:
    """A joint as the hierarchy says it; ``channels`` are (kind, axis) in the order of the numbers."""

    def __init__(self, name: str, parent: int) -> None:
        self.name, self.parent = name, parent
        self.offset = np.zeros(3)
        self.channels: list[tuple[str, int]] = []


def read_bvh(path: Path) -> SourceMotion:
    """Return the motion of a BVH file.

    Args:
        path: The file.

    Raises:
        InputError: It is no BVH, is damaged or too large; one clause, without the file's name.
    """
    try:
        if path.stat().st_size > LARGEST:
            raise InputError(f"it has more than {LARGEST // 2**20} MB")
        text = path.read_bytes().decode("utf-8", errors="replace").lstrip("\ufeff")
    except OSError as error:
        raise InputError(f"it cannot be read ({error.strerror})") from error
    return parse_bvh(text)


def parse_bvh(text: str) -> SourceMotion:
    """Return the motion that the text of a BVH file says. Raises InputError."""
    head, found, rest = text.partition("MOTION")
    if not found or not head.lstrip()[:9].upper() == "HIERARCHY":
        raise InputError("it is no BVH")
    joints = _hierarchy(head)
    timing = _FRAMES.match(rest.lstrip())
    if timing is None:
        raise InputError("it does not say how many frames it has")
    count, step = (_number(word) for word in timing.groups())
    if not 2 <= count <= MOST_FRAMES or not step > 0:
        raise InputError(f"it says that it has {count:g} frames of {step:g} s")
    return _motion(joints, _rows(rest.lstrip()[timing.end() :], joints, int(count)), 1 / step).checked()


def _hierarchy(text: str) -> list[_Joint]:
    """Return the joints, parents before children."""
    words = text.split()[1:]
    if len(words) > _TOKENS:
        raise InputError("its hierarchy is too long")
    joints, open_, index = list[_Joint](), list[int](), 0
    while index < len(words):
        word = words[index].upper()
        if word in ("ROOT", "JOINT", "END"):
            start = index + 1
            while index < len(words) and words[index] != "{":
                index += 1
            name = "" if word == "END" else " ".join(words[start:index])
            if len(joints) >= MOST_JOINTS:
                raise InputError(f"it has more than {MOST_JOINTS} joints")
            joints.append(_Joint(name[:120], open_[-1] if open_ else -1))
            open_.append(len(joints) - 1)
            index += 1
        elif word == "}" and open_:
            open_.pop()
            index += 1
        elif word == "OFFSET" and open_:
            joints[open_[-1]].offset = np.array([_number(each) for each in words[index + 1 : index + 4]])
            index += 4
        elif word == "CHANNELS" and open_:
            many = int(_number(words[index + 1] if index + 1 < len(words) else ""))
            if not 0 <= many <= 12:
                raise InputError("a joint has too many channels")
            joints[open_[-1]].channels = [_channel(each) for each in words[index + 2 : index + 2 + many]]
            index += 2 + many
        else:
            raise InputError(f"its hierarchy has the odd word {words[index][:20]!r}")
    if open_ or not joints or any(len(joint.offset) != 3 for joint in joints):
        raise InputError("its hierarchy ends too early")
    return joints


def _channel(word: str) -> tuple[str, int]:
    axis, kind = _AXES.get(word[:1].lower()), word[1:].lower()
    if axis is None or kind not in (_TURNS, _MOVES):
        raise InputError(f"it has the odd channel {word[:20]!r}")
    return kind, axis


def _number(word: str) -> float:
    try:
        value = float(word)
    except ValueError:
        raise InputError(f"{word[:20]!r} is no number") from None
    if not abs(value) <= _FURTHEST:
        raise InputError(f"it has the number {word[:20]}")
    return value


def _rows(text: str, joints: list[_Joint], count: int) -> Floats:
    """Return the numbers (N, C) of the frames; fewer than were said where the file ends too early."""
    width = sum(len(joint.channels) for joint in joints)
    if width == 0:
        raise InputError("it has no channels")
    try:
        values = np.array(text.split(None, count * width)[: count * width], float)
    except ValueError:
        raise InputError("its frames have words among the numbers") from None
    rows = values[: len(values) // width * width].reshape(-1, width)
    if len(rows) < 2:
        raise InputError("it has no motion, only a pose")
    if not np.isfinite(rows).all() or np.abs(rows).max() > _FURTHEST:
        raise InputError("it has numbers that are not finite")
    return rows


def _motion(joints: list[_Joint], rows: Floats, rate: float) -> SourceMotion:
    parents = tuple(joint.parent for joint in joints)
    local = np.tile(np.eye(3), (len(rows), len(joints), 1, 1))
    moves = np.tile(np.array([joint.offset for joint in joints]), (len(rows), 1, 1))
    column = 0
    for index, joint in enumerate(joints):
        for kind, axis in joint.channels:
            if kind == _TURNS:
                local[:, index] = local[:, index] @ about_axis(axis, np.radians(rows[:, column]))
            else:  # the place of a joint takes the place of its offset
                moves[:, index, axis] = rows[:, column]
            column += 1
    turns, places = orientations(parents, local), moves.copy()
    rest = np.array([joint.offset for joint in joints])
    for index, parent in enumerate(parents):
        if parent >= 0:
            places[:, index] = places[:, parent] + np.einsum("nij,nj->ni", turns[:, parent], moves[:, index])
            rest[index] += rest[parent]
    names = tuple(joint.name for joint in joints)
    return SourceMotion(names, parents, rest, turns, places, rate)

"""Parts of vehicles: which words name them, what they are built as, and where they are where a model does not say."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from storyblender.geometry.boxes import Box
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec3

PART_PROPS: Final = {
    "seat_driver": "car_seat", "seat_passenger": "car_seat", "seat_rear": "carriage_seat",
    "steering_wheel": "steering_wheel", "mirror": "rear_view_mirror", "lever": "seat_lever", "pedals": "car_pedals",
    "mat": "car_mat",
}  # fmt: skip
"""Part -> key of ``catalog.props``."""
DRAWN: Final = frozenset({"steering_wheel", "mirror", "lever", "pedals", "mat"})
"""Parts that are drawn into a vehicle whose model does not have them apart."""
_HEADS: Final = {
    "seat": "seat_driver", "seats": "seat_driver", "track": "seat_driver", "wheel": "steering_wheel",
    "mirror": "mirror", "lever": "lever", "handbrake": "lever", "gearstick": "lever", "gearshift": "lever",
    "stick": "lever", "pedal": "pedals", "pedals": "pedals", "accelerator": "pedals", "brake": "pedals",
    "clutch": "pedals", "mat": "mat", "mats": "mat", "floormat": "mat",
}  # fmt: skip
_SHELL: Final = frozenset({
    "door", "doors", "window", "windows", "windshield", "windscreen", "bonnet", "hood", "boot", "trunk", "roof",
    "dashboard", "dash", "cab", "tailgate", "bumper", "headlight", "headlights", "engine", "ignition", "horn",
    "glovebox", "fender", "interior",
})  # fmt: skip
_SURE: Final = re.compile(
    r"\b(?:steering[- ]?wheel|rear-?view|(?:driver|passenger)(?:'s)?[- ]seat|car seat"
    r"|(?:seat|gear) (?:lever|track|stick)|gearstick|(?:brake|gas|clutch) pedal|pedals|accelerator|floor[- ]?mats?)\b"
)
"""Names that mean a part of a vehicle wherever they stand."""
_OUTSIDE: Final = re.compile(r"\b(?:wing|side|spare|front|back|rear|flat)\b")
"""Words before ``wheel`` and ``mirror`` that mean one outside."""
_BEFORE: Final = re.compile(r"\b(?:of|with|in|on|from|for|at|under)\b")


def part_named(name: str) -> str:
    """Return the part of a vehicle that a name means, a key of ``PART_PROPS``; empty if it means none.

    Args:
        name: As in the script: ``rear-view mirror``, ``driver's seat of the van``.
    """
    words = _BEFORE.split(name.lower())[0].split()
    part = _HEADS.get(words[-1], "") if words else ""
    if part in ("steering_wheel", "mirror"):
        return "" if _OUTSIDE.search(" ".join(words).replace("rear-view", "").replace("rear view", "")) else part
    if part == "seat_driver":
        said = " ".join(words)
        return "seat_passenger" if "passenger" in said else "seat_rear" if re.search(r"back|rear", said) else part
    return part


def is_sure_part(name: str) -> bool:
    """Return whether a name means a part of a vehicle wherever it stands."""
    return bool(_SURE.search(name.lower()))


def is_shell(name: str) -> bool:
    """Return whether a name means a part that is the vehicle itself to people who act on it: its door, its window."""
    words = _BEFORE.split(name.lower())[0].split()
    return bool(words) and words[-1] in _SHELL


def side_named(name: str) -> str:
    """Return the side of a vehicle on which a part is: ``passenger``, ``rear`` or ``driver``."""
    name = name.lower()
    return (
        "passenger" if "passenger" in name else "rear" if re.search(r"\b(?:back|rear)\b(?!-view)", name) else "driver"
    )


def part_box(part: str, size: Vec3, anchors: Sequence[Anchor]) -> Box:
    """Return the box of a part in its vehicle's own frame: what the model declares, else a plausible one.

    Args:
        part: A key of ``PART_PROPS``.
        size: Of the vehicle, metres.
        anchors: Of the vehicle.
    """
    own = next((anchor for anchor in anchors if anchor.kind == "part" and anchor.name == part), None)
    if own is not None:
        return Box(*own.location, *own.size, own.clearance or 0.1)
    width, depth, height = size
    seats = [anchor for anchor in anchors if anchor.kind == "seat"]
    wanted = part.removeprefix("seat_") if part.startswith("seat_") else "driver"
    seat = next((each for each in seats if each.name.startswith(wanted)), seats[0] if seats else None)
    x, y, z = seat.location if seat is not None else (0.22 * width, -0.12 * depth, 0.32 * height)
    off, box = _PLAUSIBLE[part.split("_")[0] if part.startswith("seat_") else part]
    return Box(x * (part != "mirror") + off[0], y + off[1], max(z + off[2], 0.0), *box)


_PLAUSIBLE: Final[dict[str, tuple[Vec3, Vec3]]] = {
    "seat": ((0.0, 0.3, -0.17), (0.5, 0.6, 0.8)),
    "steering_wheel": ((0.0, -0.1, 0.24), (0.4, 0.2, 0.36)),
    "mirror": ((0.0, -0.2, 0.8), (0.24, 0.05, 0.12)),
    "lever": ((0.0, -0.03, -0.16), (0.34, 0.08, 0.04)),
    "pedals": ((0.0, -0.45, -0.12), (0.36, 0.1, 0.16)),
    "mat": ((0.0, -0.3, -0.17), (0.5, 0.5, 0.02)),
}
"""Metres from the front edge of the driver's seat to the bottom centre of a part, and its size."""

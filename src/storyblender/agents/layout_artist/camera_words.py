"""What a model is told of a shot and its takes, in JSON values: the viewfinder's numbers, rounded."""

from __future__ import annotations

from typing import Any, Literal

from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView
from storyblender.geometry.orbit import Orbit
from storyblender.memory.measure import CameraView, SubjectView
from storyblender.memory.shot_sizes import SIZES

Operation = Literal[
    "orbit_left", "orbit_right", "orbit_up", "orbit_down", "pan_left", "pan_right", "pan_up", "pan_down",
    "zoom_in", "zoom_out", "roll_left", "roll_right",
]  # fmt: skip
"""The keys of ``OPERATIONS``."""

_VISIBLE = 0.002
"""Share of the picture from which a person besides the subjects is listed."""


def shown_shot(view: CameraOperatorView) -> dict[str, Any]:
    """Return what a shot is to show."""
    wanted = view.instruction
    told: dict[str, Any] = {
        "lines": view.lines,
        "kind": wanted.kind,
        "size": wanted.size,
        "angle": wanted.angle,
        "movement": wanted.movement,
        "direction": wanted.direction,
        "subjects": view.focus or view.named,
        "detail": wanted.detail,
        "over_the_shoulder_of": view.over.node_id if view.over is not None else None,
        "should_also_be_seen": view.in_frame,
        "script_orders": wanted.order,
        "asked_for": view.asked.model_dump(mode="json", exclude_defaults=True),
        "head_height_wanted": SIZES[wanted.size].band if view.people else None,
    }
    if view.previous is not None:
        before = view.previous.instruction
        told["shot_before"] = {"kind": before.kind, "size": before.size, "subjects": before.focus_on_ids}
    return {name: value for name, value in told.items() if value}


def shown_camera(camera: Orbit) -> dict[str, float]:
    """Return where a camera stands: degrees, metres, mm."""
    return {
        "azimuth": round(camera.azimuth),
        "elevation": round(camera.elevation),
        "roll": round(camera.roll),
        "distance": round(camera.distance, 1),
        "lens": round(camera.lens),
    }


def shown_look(seen: CameraView, view: CameraOperatorView) -> dict[str, Any]:
    """Return what a look shows of the subjects, and of others who are in the picture.

    Args:
        seen: The look.
        view: Its shot.
    """
    main = {*(view.focus or view.named), view.node(view.instruction.over_id or "")}
    others = (each for each in seen.subjects if each.node_id not in main and each.pixels > _VISIBLE)
    return {
        "subjects": [_shown_subject(each) for each in seen.subjects if each.node_id in main],
        "others": [_shown_subject(each) for each in others],
        "in_front_of_subjects": round(seen.foreground, 2),
        "empty": round(seen.void, 2),
    }


def _shown_subject(each: SubjectView) -> dict[str, Any]:
    """Return how one subject appears; shares of the picture from its upper left corner."""
    covered = 1 - each.visible_fraction / each.in_frame_fraction if each.in_frame_fraction > 0 else 0.0
    told: dict[str, Any] = {
        "id": each.node_id,
        "box": [round(side, 2) for side in each.box] if each.box is not None else None,
        "share_in_frame": round(each.in_frame_fraction, 2),
        "covered": round(max(covered, 0.0), 2),
    }
    if each.face is not None:
        told |= {
            "face_at": [round(side, 2) for side in each.face],
            "face_turned_away": round(each.face_angle),
            "face_visible": round(each.face_visible, 2),
            "head_height": round(each.head_height, 2),
            "headroom": round(each.head_top, 2) if each.head_top is not None else None,
        }
    return {name: value for name, value in told.items() if value is not None}

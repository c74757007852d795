"""Judges whether a frame shows the actions of its lines: by whom, at its moment, with hands that can be seen."""

from __future__ import annotations

from storyblender.agents.frame_critic.frame_view import FrameView, actions_not_shown, actions_to_see
from storyblender.catalog.motions import MOTIONS
from storyblender.reflection import Fault

NOT_ACCEPTED = 2.1
"""Points for a fault that a director would not accept, however good the rest of the picture is."""
_STAGING = dict.fromkeys(("missing", "no_path", "no_support", "unreachable", "crossing", "late"), NOT_ACCEPTED)
"""Points for each kind of failed staging, once a frame: a hand that misses its thing, a posture not reached."""
_FURTHER_ACTION, _NOTHING_DONE = 0.6, 3.2
"""Points for each further action that the picture does not show, and for a picture that shows none of them."""
_TURNED_AWAY = 112.0
"""Degrees between face and camera from which the hands of a person cannot be seen."""


def fault(kind: str, subject: str, severity: float, message: str) -> Fault:
    """Return a fault of a frame.

    Args:
        kind: The critic's word for it, such as ``not_done``.
        subject: asset_id or node_id that it is about; empty for the whole frame.
        severity: Points of ten, rounded to hundredths.
        message: Sentence for the user.
    """
    return Fault(kind=kind, subject=subject, severity=round(severity, 2), message=message)


def find_action_faults(view: FrameView) -> list[Fault]:
    """Return the faults of actions that the story moment does not show, and of hands turned away from the camera."""
    shot, instruction = view.shot, view.shot.camera_instruction
    if instruction.kind == "establishing":
        return []
    told = actions_to_see(shot)
    undone = actions_not_shown(shot, view.played)
    found: list[Fault] = []
    for number, action in enumerate(undone):
        none = not number and len(undone) == len({(each.motion, each.action_description) for each in told})
        severity = _NOTHING_DONE if none else _FURTHER_ACTION if number else NOT_ACCEPTED
        text = f"{action.asset_id} does not {MOTIONS[action.motion].name} at this moment"
        found.append(fault("not_done", action.asset_id, severity, text))
    if instruction.behind or instruction.explicit or instruction.kind in ("insert", "pov"):
        return found
    for asset_id in dict.fromkeys(action.asset_id for action in told if MOTIONS[action.motion].hands):
        subject = view.subject(asset_id)
        seen = subject is not None and asset_id in view.people and subject.pixels
        if subject is not None and seen and subject.face_angle > _TURNED_AWAY:
            found.append(fault("back_to_deed", asset_id, NOT_ACCEPTED, f"what {asset_id} does is turned away"))
            break
    return found


def find_staging_faults(view: FrameView) -> list[Fault]:
    """Return the faults of actions that were not staged as the script says."""
    found = [
        fault(f"not_staged_{flag.topic}", flag.choice, 2.5, flag.reason)
        for flag in view.shot.flags
        if flag.topic in ("action", "deed", "motion")
    ]
    for flaw in {(flaw.kind, flaw.subject): flaw for flaw in reversed(view.staged)}.values():
        if flaw.kind in _STAGING:
            found.append(fault(flaw.kind, flaw.subject, _STAGING[flaw.kind], flaw.message))
    return found

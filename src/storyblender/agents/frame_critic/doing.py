"""Judges whether a frame shows what its lines tell to be done: by whom, at its moment, by hands that can be seen."""

from __future__ import annotations

from storyblender.agents.frame_critic.frame_view import FrameView, actions_to_see, deeds_not_shown
from storyblender.catalog.motions import clip_of
from storyblender.reflection import Fault

SENT_BACK = 2.1
"""Points lost for what a director would not let pass, however good the rest of the picture is."""
_STAGING = dict.fromkeys(("missing", "no_path", "no_support", "unreachable", "crossing", "late"), SENT_BACK)
"""Points lost for each kind of failed staging, once a frame: a hand that misses its thing, a posture not reached."""
_MORE_UNDONE, _NOTHING_DONE = 0.6, 3.2
"""Points lost for each further deed that is not done in the picture, and for a picture in which none is."""
_TURNED_AWAY = 112.0
"""Degrees between face and camera from which the hands of a person cannot be seen."""


def fault(kind: str, subject: str, severity: float, message: str) -> Fault:
    """Return a fault of a frame."""
    return Fault(kind=kind, subject=subject, severity=round(severity, 2), message=message)


def deeds(view: FrameView) -> list[Fault]:
    """Report deeds that are not done at the drawn moment, and hands at work that are turned away from the camera."""
    shot, instruction = view.shot, view.shot.camera_instruction
    if instruction.kind == "establishing":
        return []
    told = actions_to_see(shot)
    undone = deeds_not_shown(shot, view.played)
    found: list[Fault] = []
    for number, action in enumerate(undone):
        none = not number and len(undone) == len({(each.motion, each.action_description) for each in told})
        severity = _NOTHING_DONE if none else _MORE_UNDONE if number else SENT_BACK
        text = f"{action.asset_id} does not {clip_of(action.motion).name} at this moment"
        found.append(fault("not_done", action.asset_id, severity, text))
    if instruction.behind or instruction.explicit or instruction.kind in ("insert", "pov"):
        return found
    for asset_id in dict.fromkeys(action.asset_id for action in told if clip_of(action.motion).hands):
        subject = view.subject(asset_id)
        seen = subject is not None and asset_id in view.people and subject.pixels
        if subject is not None and seen and subject.face_angle > _TURNED_AWAY:
            found.append(fault("back_to_deed", asset_id, SENT_BACK, f"what {asset_id} does is turned away"))
            break
    return found


def staging(view: FrameView) -> list[Fault]:
    """Report what the staging could not do of the script."""
    found = [
        fault(f"not_staged_{flag.topic}", flag.choice, 2.5, flag.reason)
        for flag in view.shot.flags
        if flag.topic in ("action", "deed", "motion")
    ]
    for flaw in {(flaw.kind, flaw.subject): flaw for flaw in reversed(view.staged)}.values():
        if flaw.kind in _STAGING:
            found.append(fault(flaw.kind, flaw.subject, _STAGING[flaw.kind], flaw.message))
    return found

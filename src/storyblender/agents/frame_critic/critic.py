"""Judges a finished frame as a director would: are the subjects of its lines in it, large enough, and not hidden?

The camera critic judges the composition of a camera; this critic judges whether the frame tells its lines.
Severities are points out of ten; a frame passes from 8.0, and is retaken below 5.0.
"""

from __future__ import annotations

from typing import Literal

from storyblender.agents.frame_critic.action_faults import NOT_ACCEPTED, fault, find_action_faults, find_staging_faults
from storyblender.agents.frame_critic.frame_view import FrameView, actions_to_see, speakers, things_to_see
from storyblender.agents.frame_critic.order_faults import find_order_faults
from storyblender.catalog.motions import MOTIONS
from storyblender.geometry.gaps import MAX_FACE_GAP, widest_face_gap
from storyblender.memory.measure import SubjectView
from storyblender.memory.shot_context import CameraInstruction, ShotContext
from storyblender.memory.shot_sizes import SHOT_SIZES, ShotSize
from storyblender.reflection import Critique, Fault

Verdict = Literal["pass", "fix", "reject"]
PASS, REJECT = 8.0, 5.0
"""Least score of a frame that passes, and the score below which it is retaken."""

_LEAST_PERSON: dict[ShotSize, float] = {
    "EWS": 0.0004, "WS": 0.002, "FS": 0.008, "MWS": 0.02, "MS": 0.03, "MCU": 0.04, "CU": 0.05, "ECU": 0.05,
}  # fmt: skip
"""Least share of the frame that a person must fill, by shot size."""
_LOOSE, _CLOSE = 7.0, 9.0
"""Least score (of ten) at which a used thing matches its words, and the thing that the picture is about."""
_LEAST_THING = 0.0003
_LEAST_INSERT = 0.012
_LEAST_EXTENT = {"ECU": 0.3, "CU": 0.22, "MCU": 0.16}
"""Least width or height, as a share of the picture's, of the first thing of an insert."""
_LEAST_WIDE = {"WS": 0.25, "EWS": 0.16}
"""Least height, as a share of the picture's, of the subject of a wide shot that the frame does not crop."""
_LEAST_DETAIL = 0.02
"""Least share of the picture that the person of an insert's hand or feet fills."""
_LEAST_SHOULDER = 0.01
"""Least share of the picture that the partner of an over-the-shoulder fills."""
_MOST_HEADLESS = 0.06
"""Largest share of the picture of a body whose head is outside it."""
_FACES_FROM: ShotSize = "FS"
"""The widest shot size in which faces must be readable."""
_PROFILE = 100.0
"""Most degrees between the face and the camera at which a face is readable."""
_BACK = 118.0
"""Degrees between face and camera from which a person counts as seen from behind."""
_MAX_GAP = MAX_FACE_GAP
"""Widest gap between two neighbours, in head heights; a wider one is an empty middle."""
_MOST_FLAT, _MOST_VOID, _MOST_FOREGROUND = 0.5, 0.08, 0.35
_DARK = 0.08


class FrameCritic:
    """The critic of finished frames."""

    def judge(self, draft: FrameView) -> Critique:
        """Return the critique of a frame; every fault says what is missing, and for which person or thing."""
        faults = (
            *_people_faults(draft),
            *_blocking_faults(draft),
            *_detail_faults(draft),
            *_face_faults(draft),
            *_gap_faults(draft),
            *_back_faults(draft),
            *_thing_faults(draft),
            *find_action_faults(draft),
            *find_staging_faults(draft),
            *find_order_faults(draft),
            *_picture_faults(draft),
        )
        return Critique.of(faults)


def verdict_of(score: float) -> Verdict:
    """Return the board's verdict for a score from 0 to 10."""
    return "pass" if score >= PASS else "fix" if score >= REJECT else "reject"


def _people_faults(view: FrameView) -> list[Fault]:
    """Return the faults of subjects who are missing, too small, cut or hidden, and of others who are not visible."""
    shot, instruction = view.shot, view.shot.camera_instruction
    if instruction.kind == "insert":
        return []
    meant = [each for each in instruction.focus_on_ids if each in shot.on_stage]
    # Where a person said whom the picture shows, nobody else of the lines is missed.
    chosen = bool(shot.camera_decision and shot.camera_decision.focus_on_ids)
    acting = [] if chosen else [action.asset_id for action in actions_to_see(shot)]
    left = {instruction.pov_id, *(shot.camera.leaves_out if shot.camera else ())}
    speaking = [] if chosen else speakers(shot)
    main = [each for each in dict.fromkeys([*meant, *acting, *speaking]) if each not in left]
    tight = SHOT_SIZES.index(instruction.size) >= SHOT_SIZES.index("MCU")
    found: list[Fault] = []
    for asset_id in main:
        central = asset_id in meant[:2] or asset_id in acting[:1]
        if tight and not central:
            continue
        subject = view.subject(asset_id)
        least = _LEAST_PERSON[instruction.size] * (1.0 if central else 0.25)
        if subject is None or subject.pixels < _LEAST_PERSON["EWS"]:
            found.append(fault("person_missing", asset_id, 4.0 if central else 2.0, f"{asset_id} is not seen"))
        elif subject.pixels < least or (asset_id in meant and _is_too_small(subject, instruction.size)):
            found.append(
                fault("person_small", asset_id, 2.2 if central else 1.5, f"{asset_id} is too small to be read")
            )
        elif central and _is_head_cut(subject, instruction.size):
            found.append(fault("face_out", asset_id, 2.2, f"the head of {asset_id} is cut by the frame"))
        elif central and _hidden_share(subject) > 0.6 and subject.face_visible < 0.5:
            found.append(fault("person_hidden", asset_id, 2.5, f"{asset_id} is {_hidden_share(subject):.0%} hidden"))
    found += _partner_faults(view)
    others = [each for each in shot.shown if each not in main and each != instruction.pov_id and not chosen]
    unseen = [each for each in others if (seen := view.subject(each)) is None or seen.pixels < _LEAST_PERSON["EWS"]]
    if not tight and unseen:
        told = ", ".join(unseen[:3])
        found.append(fault("people_missing", unseen[0], min(0.8 * len(unseen), 2.5), f"{told} not in the picture"))
    return found


def _partner_faults(view: FrameView) -> list[Fault]:
    """Return the faults of a two-shot without its second person, an OTS without a shoulder, a POV of itself."""
    shot, instruction = view.shot, view.shot.camera_instruction
    people = [each for each in instruction.focus_on_ids if _is_person(view, each)]
    left = shot.camera.leaves_out if shot.camera else ()
    found: list[Fault] = []
    if instruction.kind in ("two_shot", "group"):
        for asset_id in people[:2]:
            if asset_id in left or asset_id not in shot.on_stage:
                text = f"{asset_id} is not in the picture of {' and '.join(people[:2])}"
                found.append(fault("partner_missing", asset_id, 3.0, text))
    if instruction.kind == "ots" and instruction.over_id is not None:
        over = view.subject(instruction.over_id)
        if over is None or over.pixels < _LEAST_SHOULDER:
            text = f"the shoulder of {instruction.over_id} is not in the picture"
            found.append(fault("no_shoulder", instruction.over_id, NOT_ACCEPTED, text))
    own = view.subject(instruction.pov_id) if instruction.kind == "pov" and instruction.pov_id else None
    if own is not None and own.pixels > _LEAST_PERSON["WS"]:
        text = f"{own.node_id}, who looks, is in the picture"
        found.append(fault("pov_seen", own.node_id, 2.5, text))
    return found


def _is_person(view: FrameView, asset_id: str) -> bool:
    """Return whether an asset is a person, on stage or not."""
    asset = view.assets.get(asset_id)
    return asset_id in view.people or (asset is not None and asset.asset_type == "character")


def _blocking_faults(view: FrameView) -> list[Fault]:
    """Return the fault of a body without a head in the picture that takes much of it, and is not its subject."""
    instruction = view.shot.camera_instruction
    if instruction.kind in ("insert", "establishing"):
        return []
    found = []
    for subject in view.seen.subjects:
        person = subject.node_id in view.people and subject.node_id not in instruction.focus_on_ids[:1]
        head = subject.face is not None and 0 < subject.face[0] < 1 and 0 < subject.face[1] < 1
        if person and not head and subject.pixels > _MOST_HEADLESS:
            text = f"{subject.pixels:.0%} of the picture is {subject.node_id} without a head"
            found.append(fault("headless", subject.node_id, NOT_ACCEPTED + 4 * subject.pixels, text))
    return found


def _is_too_small(subject: SubjectView, size: ShotSize) -> bool:
    """Return whether the subject of a wide shot is too small to be recognised."""
    if subject.box is None or size not in _LEAST_WIDE or subject.head_height <= 0:
        return False
    _, top, _, bottom = subject.box
    return bottom - top < _LEAST_WIDE[size] and subject.head_height < 0.13 * _LEAST_WIDE[size]


def _is_head_cut(subject: SubjectView, size: ShotSize) -> bool:
    """Return whether the top of the picture cuts a head in a shot size that shows all of it."""
    whole = SHOT_SIZES.index(size) <= SHOT_SIZES.index("MS")
    return whole and subject.face is not None and 0 < subject.face[1] < 0.45 * subject.head_height


def _replacement_fault(view: FrameView, asset_id: str, focus: bool) -> Fault | None:
    """Return the fault of a thing that another one stands in for, or that matches its words loosely; else None.

    The thing that the picture is about (``focus``) must match best.
    """
    asset = view.assets.get(asset_id)
    if asset is None or asset.canonical is None:
        return None
    if asset.canonical.is_stand_in:
        return fault("stand_in", asset_id, 2.5 if focus else NOT_ACCEPTED, f"{asset_id} is a plain stand-in")
    score = asset.canonical.match_score
    if asset.asset_type != "object" or score is None or score >= (_CLOSE if focus else _LOOSE):
        return None
    return fault("loose_match", asset_id, NOT_ACCEPTED, f"{asset_id} is only like what the words say")


def _detail_faults(view: FrameView) -> list[Fault]:
    """Return the fault of an insert of a person's hand or feet with next to nothing of that person in it."""
    instruction = view.shot.camera_instruction
    first = instruction.focus_on_ids[:1]
    if instruction.kind != "insert" or not first or first[0] not in view.shot.on_stage:
        return []
    subject = view.subject(first[0])
    if subject is not None and subject.pixels >= _LEAST_DETAIL:
        return []
    text = f"the part of {first[0]} that the picture is about is not seen"
    return [fault("detail_missing", first[0], 4.0, text)]


def _is_insert_too_small(subject: SubjectView | None, instruction: CameraInstruction) -> bool:
    """Return whether the first thing of an insert is too small in the picture."""
    if subject is None or subject.box is None or subject.node_id not in instruction.focus_on_ids[:1]:
        return False
    left, top, right, bottom = subject.box
    return max(right - left, bottom - top) < _LEAST_EXTENT.get(instruction.size, 0.0)


def _is_close_up_too_wide(view: FrameView, subject: SubjectView | None) -> bool:
    """Return whether a close picture of things alone shows the first of them much smaller than its size asks for."""
    instruction = view.shot.camera_instruction
    alone = not any(each in view.shot.on_stage for each in instruction.focus_on_ids)
    if instruction.kind == "insert" or not alone or subject is None or subject.box is None:
        return False
    left, top, right, bottom = subject.box
    first = subject.node_id in view.nodes.get(instruction.focus_on_ids[0], instruction.focus_on_ids[:1])
    return first and max(right - left, bottom - top) < 0.6 * _LEAST_EXTENT.get(instruction.size, 0.0)


def _hidden_share(subject: SubjectView) -> float:
    """Return the share of a subject within the frame that something hides."""
    return 1 - subject.visible_fraction / max(subject.in_frame_fraction, 1e-6)


def _face_faults(view: FrameView) -> list[Fault]:
    """Return the faults of speakers and reacting people whose faces are not readable, except from far away."""
    shot, instruction = view.shot, view.shot.camera_instruction
    far = SHOT_SIZES.index(instruction.size) < SHOT_SIZES.index(_FACES_FROM)
    if far or instruction.behind or instruction.kind in ("insert", "establishing", "pov"):
        return []
    reacting = [state.asset_id for state in shot.states if state.expression != "neutral"]
    wanted = [each for each in dict.fromkeys([*speakers(shot), *reacting]) if each in instruction.focus_on_ids]
    found: list[Fault] = []
    for asset_id in wanted:
        subject = view.subject(asset_id)
        if subject is None or subject.node_id not in view.people or subject.face is None:
            continue
        x, y = subject.face
        if not (0 < x < 1 and 0 < y < 1):
            found.append(fault("face_out", asset_id, 3.0, f"the face of {asset_id} is outside the picture"))
        elif subject.face_angle > _PROFILE:
            found.append(fault("face_away", asset_id, 2.5, f"the face of {asset_id} is turned away"))
        elif subject.face_visible < 0.4:
            found.append(fault("face_hidden", asset_id, 2.5, f"the face of {asset_id} is hidden"))
    # In an over-the-shoulder one readable face is enough.
    turned = [each for each in found if each.kind == "face_away"]
    return found if len(turned) == len(wanted) else [each for each in found if each not in turned]


def _gap_faults(view: FrameView) -> list[Fault]:
    """Return the fault of people at both sides of a picture with nothing between them; wide shots may have that."""
    shot, instruction = view.shot, view.shot.camera_instruction
    seen = [view.subject(each) for each in instruction.focus_on_ids if each in shot.on_stage]
    shown = [each for each in seen if each is not None and each.face is not None and each.pixels > _LEAST_PERSON["EWS"]]
    faces = [(each.face[0], each.head_height) for each in shown if each.face is not None and 0 < each.face[0] < 1]
    if instruction.size in _LEAST_WIDE or instruction.kind not in ("group", "two_shot", "action") or len(faces) < 2:
        return []
    gap = widest_face_gap(faces, view.aspect)
    if gap < _MAX_GAP:
        return []
    return [fault("apart", shown[0].node_id, min(1.0 + 0.3 * (gap - _MAX_GAP), 3.0), "the middle is empty")]


def _back_faults(view: FrameView) -> list[Fault]:
    """Return the fault of a picture in which all subjects turn their backs."""
    shot, instruction = view.shot, view.shot.camera_instruction
    if instruction.kind in ("insert", "pov") or instruction.explicit or instruction.behind or instruction.size == "EWS":
        return []
    shown = [view.subject(each) for each in instruction.focus_on_ids if each in shot.on_stage]
    angles = [each.face_angle for each in shown if each is not None and each.node_id in view.people and each.pixels]
    if not angles or min(angles) < _BACK or _is_walking_off(shot):
        return []
    return [fault("backs", instruction.focus_on_ids[0], 2.5, "everybody is seen from behind")]


def _is_walking_off(shot: ShotContext) -> bool:
    """Return whether the first person of a shot walks, and may show their back."""
    return any(
        MOTIONS[action.motion].speed is not None and action.asset_id in shot.camera_instruction.focus_on_ids[:1]
        for action in shot.character_actions
    )


def _thing_faults(view: FrameView) -> list[Fault]:
    """Return the faults of used things that are not in the picture, and of a main thing that is small or a stand-in."""
    shot, instruction = view.shot, view.shot.camera_instruction
    tight = SHOT_SIZES.index(instruction.size) >= SHOT_SIZES.index("MCU")
    found: list[Fault] = []
    for asset_id in things_to_see(shot):
        asset = view.assets.get(asset_id)
        if asset is None or asset.part_of or asset_id in shot.absent:
            continue
        focus = asset_id in instruction.focus_on_ids
        subject = view.subject(asset_id)
        pixels = subject.pixels if subject is not None else 0.0
        if asset_id in view.built and not pixels:
            continue
        if (
            focus
            and instruction.kind == "insert"
            and (pixels < _LEAST_INSERT or _is_insert_too_small(subject, instruction))
        ):
            found.append(fault("thing_missing", asset_id, 4.0, f"{asset_id}, which the picture is about, is not seen"))
        elif focus and _is_close_up_too_wide(view, subject):
            found.append(fault("thing_small", asset_id, NOT_ACCEPTED, f"{asset_id} is too small for a close picture"))
        elif pixels < _LEAST_THING and (focus or not tight):
            found.append(fault("thing_missing", asset_id, 2.5 if focus else NOT_ACCEPTED, f"{asset_id} is not seen"))
        elif (replaced := _replacement_fault(view, asset_id, focus)) is not None:
            found.append(replaced)
    named = {each.subject for each in found}
    held = dict.fromkeys(prop for state in shot.states if state.asset_id in shot.shown for prop in state.held)
    in_hand = (_replacement_fault(view, prop, prop in instruction.focus_on_ids) for prop in held if prop not in named)
    found += [replaced for replaced in in_hand if replaced is not None][:1]
    return found


def _picture_faults(view: FrameView) -> list[Fault]:
    """Return the faults of an empty, flat or dark picture, a blocked foreground, and a camera inside a thing."""
    seen, picture, kind = view.seen, view.picture, view.shot.camera_instruction.kind
    found: list[Fault] = []
    if seen.void > _MOST_VOID:
        found.append(fault("void", "", 1 + 10 * (seen.void - _MOST_VOID), f"{seen.void:.0%} of the picture is empty"))
    masked = bool(view.shot.camera_instruction.through)
    if picture is not None and picture.flat > _MOST_FLAT and seen.sky < 0.3 and not masked:
        severity = 1 + 6 * (picture.flat - _MOST_FLAT)
        found.append(fault("flat", "", severity, f"{picture.flat:.0%} of the picture is one plain surface"))
    if seen.foreground > _MOST_FOREGROUND and kind not in ("pov", "establishing", "ots"):
        found.append(fault("foreground", "", 2.0, f"{seen.foreground:.0%} of the picture is blocked in front"))
    if picture is not None and picture.brightness < _DARK and not masked:
        found.append(fault("dark", "", 2.0, "the picture is too dark to be read"))
    if seen.inside or seen.below_floor:
        found.append(fault("inside", "", 4.0, f"the camera is inside {', '.join(seen.inside) or 'the floor'}"))
    if view.shot.on_stage and kind not in ("insert", "establishing", "pov"):
        largest = max((subject.pixels for subject in seen.subjects), default=0.0)
        if largest < _LEAST_PERSON["EWS"]:
            found.append(fault("nothing", "", 5.0, "nothing that the lines are about is in the picture"))
    return found

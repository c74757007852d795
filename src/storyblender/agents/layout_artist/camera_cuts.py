"""Judges the cut into a shot: the 180-degree line, the 30-degree rule, and eyelines that meet."""

from __future__ import annotations

import math

import numpy as np

from storyblender.agents.layout_artist.camera_composition import fault
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView, EarlierShot
from storyblender.geometry.camera_path import orbit_of
from storyblender.geometry.continuity import JUMP_CUT_DEGREES, angle_between_views, crosses_line, do_looks_match
from storyblender.geometry.framing import head_share
from storyblender.geometry.orbit import Orbit
from storyblender.memory.base import Vec3, shot_name
from storyblender.reflection import Fault

_AROUND = "orbit_left orbit_right"
_LIKE, _OTHER = math.log(1.5), math.log(2.5)
"""Logarithms of the change of head size in a cut: up to the first the pictures are alike, from the second not."""


def find_cut_faults(view: CameraOperatorView, take: CameraOperatorDraft) -> list[Fault]:
    """Return the faults of the cuts from the earlier shots to a take.

    Args:
        view: The shot, with the shots it has to match.
        take: Its camera.
    """
    found: list[Fault] = []
    name = shot_name(view.scene_id, view.shot_id)
    kind, axis = view.instruction.kind, view.axis
    if axis is not None and kind not in ("pov", "establishing", "insert"):
        crossed = [crosses_line(end, axis[0].face, axis[1].face, view.side) for end in (take.start, take.end)]
        if any(crossed):
            found.append(fault("line", name, 3.5, f"{name} crosses the line", ops=_AROUND))
    found += _find_jump_cut(view, take, name)
    reverse = view.reverse
    if reverse is not None and axis is not None and kind in ("single", "reaction", "ots") and view.people:
        partner = next((figure for figure in axis if figure.node_id != view.people[0].node_id), None)
        other = orbit_of(reverse.state.poses[0], view.film)
        if partner is not None and not do_looks_match(take.camera, view.people[0].forward, other, partner.forward):
            found.append(fault("eyeline", name, 1.5, "both singles look to one side of the picture", ops=_AROUND))
    return found


def _find_jump_cut(view: CameraOperatorView, take: CameraOperatorDraft, name: str) -> list[Fault]:
    """Return the fault of a cut between two nearly equal pictures of the same people; empty if there is none."""
    before = view.previous
    if before is None or "pov" in (view.instruction.kind, before.instruction.kind) or take.start.distance <= 0:
        return []
    last = orbit_of(before.state.poses[-1], view.film)
    alike, subject = _similarity(view, before, last, take.start)
    change = angle_between_views(last, take.start, subject)
    if not alike or change >= JUMP_CUT_DEGREES:
        return []
    short = JUMP_CUT_DEGREES - change + 3
    way = np.sign(take.start.azimuth - last.azimuth) or 1.0
    text = f"the cut moves only {change:.0f} degrees on the same subject"
    return [fault("jump", name, alike * (0.6 + short / 40), text, azimuth=float(way * short))]


def _similarity(view: CameraOperatorView, before: EarlierShot, last: Orbit, now: Orbit) -> tuple[float, Vec3]:
    """Return how alike two pictures are, 0 to 1, and the world point around which the change of angle is measured.

    People are compared by their heads: a wide shot of two close people may be as near as a medium shot of two apart.
    """
    pairs = [
        (then, figure)
        for figure in view.subjects(view.moments[0])
        for then in before.people
        if then.node_id == figure.node_id
    ]
    if not pairs:
        same = {*before.instruction.focus_on_ids} == {*view.instruction.focus_on_ids}
        return float(same and view.size_steps(before.instruction.size) < 2), now.pivot
    if not len(pairs) == len(before.people) == len(view.subjects(view.moments[0])):
        return 0.0, now.pivot
    scale = max(abs(math.log(head_share(now, figure) / head_share(last, then))) for then, figure in pairs)
    return min(max((_OTHER - scale) / (_OTHER - _LIKE), 0.0), 1.0), pairs[0][1].face

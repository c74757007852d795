"""Judges the cut: the 180-degree line, the 30-degree rule, and eyelines that meet."""

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
"""How many times heads grow or shrink in a cut, as logarithms: up to the first it is the same picture, from the second
on it is another one."""


def cuts(view: CameraOperatorView, take: CameraOperatorDraft) -> list[Fault]:
    """Return what is wrong with the cuts from the shots before."""
    found: list[Fault] = []
    name = shot_name(view.scene_id, view.shot_id)
    kind, axis = view.instruction.kind, view.axis
    if axis is not None and kind not in ("pov", "establishing", "insert"):
        crossed = [crosses_line(end, axis[0].face, axis[1].face, view.side) for end in (take.start, take.end)]
        if any(crossed):
            found.append(fault("line", name, 3.5, f"{name} crosses the line", ops=_AROUND))
    found += _jump(view, take, name)
    reverse = view.reverse
    if reverse is not None and axis is not None and kind in ("single", "reaction", "ots") and view.people:
        partner = next((figure for figure in axis if figure.node_id != view.people[0].node_id), None)
        other = orbit_of(reverse.state.poses[0], view.film)
        if partner is not None and not do_looks_match(take.camera, view.people[0].forward, other, partner.forward):
            found.append(fault("eyeline", name, 1.5, "both singles look to one side of the picture", ops=_AROUND))
    return found


def _jump(view: CameraOperatorView, take: CameraOperatorDraft, name: str) -> list[Fault]:
    """Return the cut from one picture of somebody to nearly the same picture of them."""
    before = view.previous
    if before is None or "pov" in (view.instruction.kind, before.instruction.kind) or take.start.distance <= 0:
        return []
    last = orbit_of(before.state.poses[-1], view.film)
    alike, subject = _alike(view, before, last, take.start)
    change = angle_between_views(last, take.start, subject)
    if not alike or change >= JUMP_CUT_DEGREES:
        return []
    short = JUMP_CUT_DEGREES - change + 3
    way = np.sign(take.start.azimuth - last.azimuth) or 1.0
    text = f"the cut moves only {change:.0f} degrees on the same subject"
    return [fault("jump", name, alike * (0.6 + short / 40), text, azimuth=float(way * short))]


def _alike(view: CameraOperatorView, before: EarlierShot, last: Orbit, now: Orbit) -> tuple[float, Vec3]:
    """Return how far a shot shows the same as the one before in like size, 0 to 1, and whom it is measured by.

    People are measured by their heads: a wide of two who stand together may be as near as a medium of two apart.
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

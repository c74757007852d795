"""Judges the cut: the 180-degree line, the 30-degree rule, and eyelines that meet."""

from __future__ import annotations

import numpy as np

from storyblender.agents.layout_artist.camera_brief import CameraBrief, Take, orbit_of
from storyblender.agents.layout_artist.camera_composition import fault
from storyblender.geometry.continuity import THIRTY, crosses_line, looks_meet, view_change
from storyblender.memory.base import shot_name
from storyblender.reflection import Fault

_AROUND = "orbit_left orbit_right"


def cuts(brief: CameraBrief, take: Take) -> list[Fault]:
    """Return what is wrong with the cuts from the shots before."""
    found: list[Fault] = []
    name = shot_name(brief.scene_id, brief.shot_id)
    kind, axis = brief.instruction.kind, brief.axis
    if axis is not None and kind not in ("pov", "establishing", "insert"):
        crossed = [crosses_line(end, axis[0].face, axis[1].face, brief.side) for end in (take.start, take.end)]
        if any(crossed):
            found.append(fault("line", name, 3.5, f"{name} crosses the line", ops=_AROUND))
    before = brief.previous
    if before is not None and set(before.instruction.focus_on_ids) & set(brief.instruction.focus_on_ids):
        found += _jump(brief, take, name)
    reverse = brief.reverse
    if reverse is not None and axis is not None and kind in ("single", "reaction", "ots") and brief.people:
        partner = next((figure for figure in axis if figure.node_id != brief.people[0].node_id), None)
        other = orbit_of(reverse.state.poses[0], brief.film)
        if partner is not None and not looks_meet(take.camera, brief.people[0].forward, other, partner.forward):
            found.append(fault("eyeline", name, 1.5, "both singles look to one side of the picture", ops=_AROUND))
    return found


def _jump(brief: CameraBrief, take: Take, name: str) -> list[Fault]:
    before = brief.previous
    if before is None or "pov" in (brief.instruction.kind, before.instruction.kind) or take.start.distance <= 0:
        return []
    if set(before.instruction.focus_on_ids) != set(brief.instruction.focus_on_ids):
        return []
    last = orbit_of(before.state.poses[-1], brief.film)
    subject = brief.people[0].face if brief.people else take.camera.pivot
    change, steps = view_change(last, take.start, subject), brief.size_steps(before.instruction.size)
    if steps >= 2 or change >= THIRTY:
        return []
    short = THIRTY - change + 3
    way = np.sign(take.start.azimuth - last.azimuth) or 1.0
    text = f"the cut moves only {change:.0f} degrees on the same subject"
    return [fault("jump", name, 0.6 + short / 40, text, azimuth=float(way * short))]

"""The check of a finished project: measures layout, framing, continuity, collisions and people in frame."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Mapping, Sequence

from storyblender.agents.layout_artist.layout_things import layout_violations
from storyblender.agents.layout_artist.placed_by_hand import without_placed
from storyblender.agents.layout_artist.spatial_planner_view import measures_of
from storyblender.catalog.sets import plan_of
from storyblender.deliver.checklist import STAGING, picture_flaws
from storyblender.geometry.continuity import has_new_line, side_of_line
from storyblender.geometry.orbit import Orbit
from storyblender.memory.base import Frozen, Vec3, scene_name, shot_name
from storyblender.memory.coverage import as_filmed
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import PackRef
from storyblender.memory.measure import Collision
from storyblender.memory.plain_words import names_of, plain
from storyblender.memory.shot_context import CameraPose, Flaw
from storyblender.pipeline.reviewing import FrameReview
from storyblender.pipeline.sighting import ShotSight, Sighting
from storyblender.ports import Engine

HIDDEN = 0.30
"""Share of a person behind other things from which they count as hidden."""
SEEN = 0.0004
"""Share of the frame from which a person counts as visible; that of a figure in the distance."""
WIDE = ("EWS", "WS", "FS")
"""Sizes in which people on stage may be visible without being subjects of the shot."""
REACH = STAGING["unreachable"][0]
"""Metres that a hand may stay from its target; the checklist uses the same limit."""
OCCM_EPSILON = 1e-6
CUTS = ("jump", "eyeline")
"""Flaw kinds of the camera critic about cuts: the 30-degree rule and eyelines that do not meet."""
MEASURED = ("inside", "below_floor", "hidden", "line")
"""Flaw kinds of the camera critic that have rows of their own here, measured again."""


class CheckRow(Frozen):
    """One line of the report."""

    name: str
    value: str
    ok: bool


class Inspection(Frozen):
    """The report."""

    rows: tuple[CheckRow, ...]
    findings: tuple[str, ...] = ()
    """One sentence for each thing to look at."""

    def with_story(self, changed: Sequence[str]) -> Inspection:
        """Return the report with a line about the Blender files.

        Args:
            changed: Names of the files that a person changed after they were compiled.
        """
        row = CheckRow(
            name="Blender file", value=f"{len(changed)} changed by hand" if changed else "as compiled", ok=True
        )
        sentences = [
            f"{name}: was changed by hand; before it is compiled again, a dated copy is kept" for name in changed
        ]
        return Inspection(rows=(*self.rows, row), findings=(*self.findings, *sentences))

    @property
    def clean(self) -> bool:
        """Whether every row of the report is ok."""
        return all(row.ok for row in self.rows)


def inspect(
    graph: ContinuityMemoryGraph,
    engine: Engine,
    packs: Sequence[PackRef],
    reviews: Mapping[str, FrameReview],
    progress: Callable[[int, int, str], None] = lambda step, total, scene: None,
) -> Inspection:
    """Check a project.

    Args:
        graph: The story graph.
        engine: The render engine that measures the frames.
        packs: The built scenes.
        reviews: Reviews of the Frame Critic, by shot name.
        progress: Callback with the number of scenes checked, their total, and the next scene.
    """
    graph = as_filmed(graph)
    graph = graph.model_copy(update={"shots": graph.cut})
    waiting = [
        (Sighting(graph, engine, pack), engine.find_collisions(pack), engine.measure_drift(pack)) for pack in packs
    ]
    sights: dict[str, ShotSight] = {}
    collisions: list[Collision] = []
    drift = 0.0
    for step, (sighting, hits, drifted) in enumerate(waiting):
        progress(step, len(waiting), scene_name(packs[step].scene_id))
        sights |= sighting.seen()
        collisions += hits.result()
        drift = max(drift, drifted.result())
    progress(len(waiting), len(waiting), "")
    findings: list[str] = []
    rows = [
        _layout_row(graph, findings),
        _drift_row(drift, findings),
        _presence_row(graph, sights, findings),
        _hidden_row(graph, sights, findings),
        _inside_row(sights, findings),
        _picture_row(graph, findings),
        _line_row(graph, sights, findings),
        _cut_row(graph, findings),
        _collision_row(collisions, findings),
        _reach_row(packs, findings),
        _staging_row(graph, packs, findings),
        _review_row(reviews, findings),
    ]
    names = names_of(graph)
    return Inspection(rows=tuple(rows), findings=tuple(plain(finding, names) for finding in findings))


def _layout_row(graph: ContinuityMemoryGraph, findings: list[str]) -> CheckRow:
    kinds: Counter[str] = Counter()
    for scene in graph.scenes:
        if scene.layout is None or scene.environment is None:
            continue
        layout = without_placed(graph, scene, scene.layout)
        faults = layout_violations(layout, measures_of(graph.assets), plan_of(scene.environment))
        kinds.update(fault.kind for fault in faults)
        findings += [f"scene {scene.scene_id}: {fault.message}" for fault in faults]
    counted = f" ({', '.join(f'{kind} {count}' for kind, count in sorted(kinds.items()))})" if kinds else ""
    return CheckRow(name="layout violations", value=f"{kinds.total()}{counted}", ok=not kinds)


def _drift_row(drift: float, findings: list[str]) -> CheckRow:
    """SDE (paper, appendix): how far a thing that nobody touches moves, in metres."""
    if drift:
        findings.append(
            f"a thing that nobody touches moves by {drift:g} m between shots, which is a fault of StoryBlender"
        )
    return CheckRow(name="metres that untouched things move (SDE)", value=f"{drift:g}", ok=drift == 0)


def _presence_row(graph: ContinuityMemoryGraph, sights: dict[str, ShotSight], findings: list[str]) -> CheckRow:
    """OCCM (paper, appendix): exp(-|D - E| / (eps + E)), D counted in the ID mask, E as planned.

    A tight shot shows exactly its planned people; people left out by its camera as too far away may be visible
    behind them. A wide shot shows at least its planned people, and others on stage may be visible.
    """
    scores = []
    for shot in graph.shots:
        name = shot_name(shot.scene_id, shot.shot_id)
        if name not in sights:
            continue
        cast = {figure.node_id for figure in sights[name].figures}
        seen = {item.node_id for item in sights[name].view.subjects if item.node_id in cast and item.pixels > SEEN}
        least = len(shot.shown)
        most = len(shot.on_stage) if shot.camera_instruction.size in WIDE else len(shot.in_frame)
        expected = min(max(len(seen), least), max(most, least))
        off = abs(len(seen) - expected)
        scores.append(math.exp(-off / (OCCM_EPSILON + expected)) if off else 1.0)
        if off:
            shown, planned = (", ".join(sorted(people)) or "nobody" for people in (seen, shot.shown))
            findings.append(f"{name}: shows {shown}; should show {planned}")
    mean = 100 * sum(scores) / max(1, len(scores))
    return CheckRow(name="people seen as planned, of 100 (OCCM)", value=f"{mean:.1f}", ok=mean >= 95)


def _hidden_row(graph: ContinuityMemoryGraph, sights: dict[str, ShotSight], findings: list[str]) -> CheckRow:
    """Count subjects of shots that are hidden behind something; inserts of a hand or a detail are left out."""
    hidden = 0
    for shot in graph.shots:
        if shot.camera_instruction.detail is not None:
            continue
        name = shot_name(shot.scene_id, shot.shot_id)
        there = {*shot.on_stage} - {*(shot.camera.leaves_out if shot.camera else ())}
        people = there.intersection(shot.camera_instruction.focus_on_ids)
        for item in sights[name].view.subjects if name in sights else ():
            share = item.visible_fraction / max(item.in_frame_fraction, 1e-6)
            if item.node_id in people and share < 1 - HIDDEN:
                hidden += 1
                findings.append(f"{name}: {item.node_id} is {100 * (1 - share):.0f} % hidden")
    return CheckRow(name="focus people hidden", value=str(hidden), ok=hidden == 0)


def _inside_row(sights: dict[str, ShotSight], findings: list[str]) -> CheckRow:
    inside = [(name, sight.view) for name, sight in sights.items() if sight.view.inside or sight.view.below_floor]
    findings += [f"{name}: the camera is in {', '.join(view.inside) or 'the floor'}" for name, view in inside]
    return CheckRow(name="cameras inside geometry", value=str(len(inside)), ok=not inside)


def _picture_row(graph: ContinuityMemoryGraph, findings: list[str]) -> CheckRow:
    """Report framing flaws that the Camera Operator could not mend."""
    return _flaw_row("framing", graph, findings, lambda kind: kind not in CUTS + MEASURED)


def _cut_row(graph: ContinuityMemoryGraph, findings: list[str]) -> CheckRow:
    return _flaw_row("jump cuts and eyelines", graph, findings, lambda kind: kind in CUTS)


def _flaw_row(
    name: str, graph: ContinuityMemoryGraph, findings: list[str], concerns: Callable[[str], bool]
) -> CheckRow:
    flaws = [
        f"{shot_name(shot.scene_id, shot.shot_id)}: {flaw.message}"
        for shot in graph.shots
        for flaw in picture_flaws(shot)
        if concerns(flaw.kind)
    ]
    findings += flaws
    return CheckRow(name=name, value=str(len(flaws)), ok=not flaws)


def _line_row(graph: ContinuityMemoryGraph, sights: dict[str, ShotSight], findings: list[str]) -> CheckRow:
    """Report cuts that cross the 180-degree line of a pair, unless the script wrote that camera."""
    crossings = 0
    for scene in graph.scenes:
        sides: dict[frozenset[str], int] = {}
        lines: dict[frozenset[str], tuple[Vec3, Vec3]] = {}
        for shot in graph.shots_of(scene.scene_id):
            name = shot_name(shot.scene_id, shot.shot_id)
            axis, instruction = shot.camera_instruction.axis, shot.camera_instruction
            if axis is None or name not in sights or shot.camera is None or instruction.kind in ("pov", "insert"):
                continue
            faces = {figure.node_id: figure.face for figure in sights[name].figures}
            first, second = sorted(axis)
            if first not in faces or second not in faces:
                continue
            line = (faces[first], faces[second])
            if has_new_line(lines.setdefault(frozenset(axis), line), line):
                del sides[frozenset(axis)]
            lines[frozenset(axis)] = line
            side = side_of_line(_orbit(shot.camera.poses[0]).position, *line)
            last = sides.setdefault(frozenset(axis), side)
            if side and last and side != last and not instruction.explicit:
                crossings += 1
                findings.append(f"{name}: crosses the line between {first} and {second}")
            sides[frozenset(axis)] = side or last
    return CheckRow(name="line crossings", value=str(crossings), ok=crossings == 0)


def _collision_row(collisions: list[Collision], findings: list[str]) -> CheckRow:
    findings += [
        f"{item.shot} frame {item.frame}: {item.asset_id} is {100 * item.depth:.0f} cm inside {item.node_id}"
        for item in collisions
    ]
    return CheckRow(name="people through things and people", value=str(len(collisions)), ok=not collisions)


def _reach_row(packs: Sequence[PackRef], findings: list[str]) -> CheckRow:
    """Report hands that end further than ``REACH`` from their target."""
    misses = [problem for pack in packs for problem in pack.problems if _misses(problem)]
    findings += [f"{miss.shot}: {miss.message}" for miss in misses]
    worst = max((miss.weight for miss in misses), default=0.0)
    farthest = f" (up to {worst:.2f} m)" if misses else ""
    return CheckRow(name="hands off their target", value=f"{len(misses)}{farthest}", ok=not misses)


def _misses(problem: Flaw) -> bool:
    return problem.kind == "unreachable" and problem.weight > REACH


def _staging_row(graph: ContinuityMemoryGraph, packs: Sequence[PackRef], findings: list[str]) -> CheckRow:
    """Report flaws of the staging: what the engine could not do, and what differs from the reading."""
    flaws = [
        f"{problem.shot}: {problem.message}" for pack in packs for problem in pack.problems if not _misses(problem)
    ]
    flaws += [
        f"{shot_name(shot.scene_id, shot.shot_id)}: {flaw.message}" for shot in graph.shots for flaw in shot.flaws
    ]
    findings += flaws
    return CheckRow(name="staging problems", value=str(len(flaws)), ok=True)


def _review_row(reviews: Mapping[str, FrameReview], findings: list[str]) -> CheckRow:
    """Report the frames that do not show what their script lines say."""
    poor = [review for review in reviews.values() if review.verdict != "pass"]
    for review in poor:
        reasons = "; ".join(fault.message for fault in review.faults)
        findings.append(f"{review.shot}: scores {review.score:.1f} of 10: {reasons}")
    value = f"{len(reviews) - len(poor)} of {len(reviews)}"
    return CheckRow(name="frames that tell their lines", value=value, ok=not poor)


def _orbit(pose: CameraPose) -> Orbit:
    return Orbit(pose.pivot, pose.rotation, pose.distance, pose.lens)

"""Coverage: shots are split, joined and added; the scene is staged as it was, and only what is new is drawn."""

from __future__ import annotations

import csv
import random
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import opentimelineio as otio
import pytest
from tests.home import SCRIPT, SETTINGS

from storyblender.deliver.panel import panels
from storyblender.edits.words import edits_of
from storyblender.errors import InputError
from storyblender.geometry.camera_path import camera_at
from storyblender.geometry.framing import Film
from storyblender.memory.base import shot_name
from storyblender.memory.coverage import as_filmed, is_beside, lines_of, spans_of, staged_spans
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.session import Session
from storyblender.studio import Studio

FIRST, SECOND, HALF, PARK = "SC010_SH010", "SC010_SH020", "SC010_SH015", "SC020_SH010"


def split(shot: str, **where: float) -> dict[str, Any]:
    return {"kind": "split", "shot": shot, **where}


def join(shot: str, other: str) -> dict[str, Any]:
    return {"kind": "join", "shot": shot, "other": other}


def add(shot: str, **more: Any) -> dict[str, Any]:
    return {"kind": "add_shot", "shot": shot, "decision": {"focus_on_ids": ["anna"], "size": "CU"}, **more}


def apply(session: Session, *edits: dict[str, Any]) -> tuple[str, ...]:
    """Apply edits and draw what they made stale, of which the names are returned."""
    applied = session.apply(edits_of(list(edits)))
    session.draw(applied)
    return applied.stale


def names(graph: ContinuityMemoryGraph) -> list[str]:
    return [shot_name(shot.scene_id, shot.shot_id) for shot in graph.cut]


def told(graph: ContinuityMemoryGraph) -> list[str]:
    return [line.text for panel in panels(graph) for line in panel.outline.lines]


def length(graph: ContinuityMemoryGraph) -> int:
    return sum(panel.shot.duration for panel in panels(graph))


def drawn(folder: Path) -> dict[str, int]:
    return {path.name: path.stat().st_mtime_ns for path in (folder / "build/frames").glob("*.png")}


def packs(folder: Path) -> dict[str, int]:
    return {path.name: path.stat().st_mtime_ns for path in (folder / "build/scenes").iterdir()}


def refuse_gaps(graph: ContinuityMemoryGraph) -> None:
    """The shots of a scene with a time of their own show all that is staged, and all its lines, once and in order."""
    for scene in graph.scenes:
        shots = graph.shots_of(scene.scene_id)
        spans, lines = spans_of(shots), lines_of(graph, scene.scene_id)
        own = [shot.shot_id for shot in shots if not shot.joined and not is_beside(shot)]
        outline = graph.outline_of(scene.scene_id)
        assert outline is not None
        ends = (max(end for _, end in staged_spans(shots).values()), sum(len(shot.lines) for shot in outline.shots))
        for parts, end in ((spans, ends[0]), (lines, ends[1])):
            assert parts[own[0]][0] == 0 and parts[own[-1]][1] == end
            assert all(parts[one][1] == parts[two][0] for one, two in pairwise(own))
        assert all(first < end for first, end in spans.values())


def exports_follow(session: Session) -> None:
    """Timeline, shot list, board frames and the Blender file have the shots of the film, as long as they are."""
    shots = panels(session.graph)
    lengths = {panel.name: panel.shot.duration for panel in shots}
    made = otio.adapters.read_from_file(str(session.folder / "timeline.otio"))
    assert {clip.name: clip.duration().value for clip in made.tracks[0]} == lengths
    assert [clip.name for clip in made.tracks[0]] == names(session.graph) == [*lengths]
    rows = {row["shot"]: row for row in csv.DictReader((session.folder / "shots.csv").open(encoding="utf-8-sig"))}
    assert {name: int(row["frames"]) for name, row in rows.items()} == lengths
    assert all((session.folder / "frames" / f"{name}.png").exists() for name in lengths)
    page = (session.folder / "index.html").read_text("utf-8")
    assert all(name in page for name in lengths)
    film = as_filmed(session.graph)
    assert [panel.start for panel in shots] == [
        sum(each.duration for each in film.cut[:index]) for index in range(len(shots))
    ]


BATCHES: list[Sequence[dict[str, Any]]] = [
    [split(FIRST, line=2)],
    [split(FIRST, frames=30)],
    [split(SECOND, seconds=1)],
    [split(FIRST, frames=30), split(FIRST, frames=10), split(HALF, frames=5)],
    [join(FIRST, SECOND)],
    [join(SECOND, FIRST), split(FIRST, seconds=1.5)],
    [add(FIRST), add(SECOND, at=0.5, seconds=1), add(FIRST)],
    [split(FIRST, frames=30), add(HALF), join(FIRST, HALF)],
]


@pytest.mark.parametrize("edits", BATCHES)
def test_all_is_told_once_nothing_else_is_drawn_and_undo_is_byte_equal(
    edits: Sequence[dict[str, Any]], session: Session
) -> None:
    before, lines, frames, scenes = session.graph, told(session.graph), drawn(session.folder), packs(session.folder)
    stale = apply(session, *edits)
    graph = session.graph
    refuse_gaps(graph)
    assert told(graph) == lines and packs(session.folder) == scenes
    assert length(graph) - sum(s.duration for s in graph.shots if is_beside(s)) == length(before)
    kept = {name: time for name, time in frames.items() if name in drawn(session.folder)}
    assert all(drawn(session.folder)[name] == time for name, time in kept.items())
    assert len(set(drawn(session.folder)) - set(frames)) <= len(stale)
    exports_follow(session)
    assert session.check().clean in (True, False), "what is cut anew can be checked"
    session.undo()
    assert session.graph.model_dump_json() == before.model_dump_json()
    session.redo()
    assert session.graph == graph


@pytest.mark.parametrize("where", [{"line": 2}, {"frames": 7}, {"seconds": 1.25}])
def test_split_and_joined_is_as_it_was(where: dict[str, float], session: Session) -> None:
    before, frames = session.graph.model_dump_json(), drawn(session.folder)
    apply(session, split(FIRST, **where))
    assert names(session.graph)[:3] == [FIRST, HALF, SECOND]
    apply(session, join(HALF, FIRST))
    assert session.graph.model_dump_json() == before and drawn(session.folder).items() >= frames.items()


def test_joined_and_split_again_covers_the_same(session: Session) -> None:
    before = session.graph
    spans, lines = spans_of(before.shots_of(1)), lines_of(before, 1)
    apply(session, join(FIRST, SECOND))
    joined = session.graph
    assert names(joined)[0] == FIRST and SECOND not in names(joined) and length(joined) == length(before)
    apply(session, split(FIRST, frames=before.shot(1, 1).duration))
    assert spans_of(session.graph.shots_of(1)) == spans and lines_of(session.graph, 1) == lines
    assert session.graph.shot(1, 2) == before.shot(1, 2), "the second has its own camera again"


def test_a_further_camera_shows_the_same_moment_and_has_no_lines(session: Session) -> None:
    shot = session.graph.shot(1, 2)
    apply(session, add(SECOND, seconds=1))
    [panel] = [each for each in panels(session.graph) if each.name == "SC010_SH025"]
    assert not panel.outline.lines and panel.shot.duration == 24 and shot.frame is not None
    start = spans_of(session.graph.shots_of(1))[panel.shot.shot_id][0] - spans_of(session.graph.shots_of(1))[2][0]
    assert start <= shot.frame < start + 24
    assert panel.shot.camera_instruction.size == "CU" and panel.shot.camera is not None
    apply(session, {"kind": "duration", "shot": "SC010_SH025", "frames": 10})
    assert [each.shot.duration for each in panels(session.graph) if each.name == "SC010_SH025"] == [10]


def test_bad_edits_are_refused_in_a_sentence(session: Session) -> None:
    last = len(lines_of(session.graph, 1)) and session.graph.shot(1, 2).duration
    approved, note = {"kind": "approve", "shot": FIRST}, {"kind": "note", "shot": SECOND, "text": "Slower."}
    cases: list[tuple[list[dict[str, Any]], str]] = [
        ([split(FIRST)], "a shot is split at a line, or at a time"),
        ([split(SECOND, line=2)], f"{SECOND} has one line; split it at a time"),
        ([split(FIRST, line=9)], f"{FIRST} has . lines; its lines have the numbers 1 to"),
        ([split(SECOND, frames=last)], f"{SECOND} has {last} frames .* split it at a time in between"),
        ([approved, split(FIRST, frames=9)], f"{FIRST} is approved"),
        ([{"kind": "omit", "target": SECOND}, split(SECOND, frames=9)], f"{SECOND} is omitted; restore it first"),
        ([add(FIRST), split(HALF, frames=9)], f"{HALF} is another camera on the same moment"),
        ([split(SECOND, frames=number) for number in range(40, 0, -1)], f"no number is free after {SECOND}"),
        ([join(FIRST, PARK)], "shots are joined within their scene"),
        ([join(FIRST, FIRST)], f"{FIRST} and {FIRST} are no neighbours"),
        ([split(FIRST, frames=9), join(FIRST, SECOND)], f"{FIRST} and {SECOND} are no neighbours"),
        ([add(FIRST), join(FIRST, SECOND)], f"{FIRST} and {SECOND} are no neighbours"),
        ([note, join(FIRST, SECOND)], f"{SECOND} has open notes; resolve or remove them first"),
        ([join(FIRST, SECOND), join(FIRST, SECOND)], f"{SECOND} is joined to the shot before it"),
        ([split(FIRST, frames=9), {"kind": "duration", "shot": FIRST, "frames": 50}], f"{FIRST} is split or joined"),
        (
            [
                split(FIRST, frames=9),
                {"kind": "blocking", "shot": HALF, "person": "tom", "marks": {"start": {"rotation": 9}}},
            ],
            f"{HALF} shows what is staged for {FIRST}; set the marks there",
        ),
        ([add(FIRST, at=99)], f"{FIRST} has .* s; begin within them"),
        ([add(SECOND, seconds=99)], "SC010 ends .* after that moment"),
        ([add(FIRST) | {"decision": {}}], "nothing is decided about the camera"),
        ([add(FIRST) | {"decision": {"kind": "pov"}}], "a point of view needs whose eyes"),
    ]
    before = session.graph
    for edits, sentence in cases:
        with pytest.raises(InputError, match=sentence):
            session.apply(edits_of(edits))
        assert session.graph == before


def test_what_is_only_planned_is_not_cut_yet(folder: Path) -> None:
    Studio(SETTINGS).plan(folder.parent / "home.fountain", folder.parent / "planned")
    with Studio(SETTINGS).open(folder.parent / "planned") as session:
        for edit in (split(FIRST, frames=9), join(FIRST, SECOND), add(FIRST)):
            with pytest.raises(InputError, match="SC010 is not staged yet"):
                session.apply(edits_of([edit]))


def test_what_is_staged_again_is_covered_as_before(session: Session) -> None:
    apply(session, split(FIRST, frames=30), add(SECOND), join("SC010_SH010", HALF), split(FIRST, frames=20))
    order, lines = names(session.graph), lines_of(session.graph, 1)
    apply(session, {"kind": "layout", "scene": "SC010"})
    moved = {"kind": "blocking", "shot": FIRST, "person": "tom", "marks": {"start": {"location": [0.5, 0.2]}}}
    apply(session, moved)
    refuse_gaps(session.graph)
    assert names(session.graph) == order and lines_of(session.graph, 1) == lines
    assert all(shot.camera is not None for shot in session.graph.shots)
    exports_follow(session)


@pytest.mark.parametrize("script", ["EXT. STREET - DAY\n\nA cat runs.\n\n" + SCRIPT, SCRIPT + "\nTOM laughs.\n"])
def test_coverage_stays_with_its_words_when_the_script_changes(script: str, folder: Path) -> None:
    with Studio(SETTINGS).open(folder) as session:
        apply(session, split(FIRST, line=2), add(PARK, seconds=1) | {"decision": {"focus_on_ids": ["tom"]}})
        apply(session, {"kind": "note", "shot": HALF, "text": "Slower."}, join(HALF, SECOND))
        before = session.graph
    (folder.parent / "home.fountain").write_text(script)
    later = script.startswith("EXT")
    with Studio(SETTINGS).open(folder) as session:
        session.make(folder.parent / "home.fountain")
        graph = session.graph
        refuse_gaps(graph)
        scene = 2 if later else 1
        half = next(panel for panel in panels(graph) if panel.shot.notes)
        assert half.name == shot_name(scene, 50_015)
        assert spans_of(graph.shots_of(scene)) == spans_of(before.shots_of(1))
        assert lines_of(graph, scene) == lines_of(before, 1) and graph.shot(scene, 2).joined
        assert shot_name(scene + 1, 50_015) in names(graph)
        exports_follow(session)
        session.undo()
        assert session.graph == before


def test_coverage_of_words_that_are_gone_is_told(folder: Path) -> None:
    told_events: list[str] = []
    with Studio(SETTINGS).open(folder) as session:
        apply(session, split(FIRST, line=2))
    (folder.parent / "home.fountain").write_text(SCRIPT.partition("EXT.")[2].join(("EXT.", "")))
    with Studio(SETTINGS, lambda event: told_events.append(str(event.message))).open(folder) as session:
        session.make(folder.parent / "home.fountain")
        refuse_gaps(session.graph)
    assert any("split off or added" in message for message in told_events)


def test_a_camera_goes_on_where_its_shot_is_split(session: Session) -> None:
    """Move and focus of the second part begin where those of the first are, and end where they ended."""
    film = Film(session.graph.format.sensor_width, session.graph.format.aspect)
    apply(session, {"kind": "camera", "shot": FIRST, "decision": {"movement": "push in"}})
    whole = session.graph.shot(1, 1).camera
    assert whole is not None and len(whole.poses) > 1
    apply(session, split(FIRST, frames=30))
    second = session.graph.shot(1, 50_015).camera
    assert second is not None and session.graph.shot(1, 1).camera == whole
    for frame in (0, second.poses[-1].frame):
        one, other = camera_at(second, frame, film), camera_at(whole, frame + 30, film)
        assert one.position == pytest.approx(other.position) and one.lens == pytest.approx(other.lens)


@pytest.mark.parametrize("seed", range(4))
def test_any_cut_leaves_nothing_out_and_is_taken_back(seed: int, session: Session) -> None:
    """Random edits of the cut, many of them refused: all of the scene is shown, told and numbered in order."""
    chance, before, lines, done = random.Random(seed), session.graph.model_dump_json(), told(session.graph), 0
    graphs = [before]
    for _ in range(120):
        shots = [shot_name(1, shot.shot_id) for shot in session.graph.shots_of(1)]
        one, other = chance.choice(shots), chance.choice(shots)
        edit = chance.choice(
            [
                split(one, frames=chance.randint(1, 60)),
                split(one, line=2),
                join(one, shots[min(shots.index(one) + 1, len(shots) - 1)]),
                join(one, other),
                add(one),
                {"kind": "omit", "target": one},
                {"kind": "restore", "target": one},
                {"kind": "reorder", "target": one, "after": other},
            ]
        )
        try:
            session.apply(edits_of([edit]))
        except InputError:
            continue
        done += 1
        refuse_gaps(session.graph)
        shown = [line.text for panel in panels(session.graph, with_omitted=True) for line in panel.outline.lines]
        assert sorted(shown) == sorted(lines), edit
        graphs.append(session.graph.model_dump_json())
    assert done > 12
    while len(graphs) > 1:
        assert session.graph.model_dump_json() == graphs.pop()
        session.undo()
    assert session.graph.model_dump_json() == before

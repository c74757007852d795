"""The cut: shots and scenes are omitted, restored and reordered; nothing is drawn, nothing is lost."""

from __future__ import annotations

import csv
from itertools import permutations
from pathlib import Path
from typing import Any

import opentimelineio as otio
import pytest
from tests.home import SCRIPT, SETTINGS

from storyblender.deliver.panel import panels
from storyblender.edits.words import edits_of
from storyblender.errors import InputError, StaleEdit
from storyblender.memory.base import shot_name
from storyblender.memory.graph import ContinuityMemoryGraph, in_order
from storyblender.session import Session
from storyblender.studio import Studio

FIRST, SECOND, ROOM, PARK, LATER = "SC010_SH010", "SC010_SH020", "SC010", "SC020", "SC030"


def apply(session: Session, *edits: dict[str, Any]) -> None:
    session.draw(session.apply(edits_of(list(edits))))


def order(*, before: str | None = None, after: str | None = None, target: str) -> dict[str, Any]:
    return {"kind": "reorder", "target": target, "before": before, "after": after}


def omit(target: str) -> dict[str, Any]:
    return {"kind": "omit", "target": target}


def restore(target: str) -> dict[str, Any]:
    return {"kind": "restore", "target": target}


def film(graph: ContinuityMemoryGraph) -> list[str]:
    return [shot_name(shot.scene_id, shot.shot_id) for shot in graph.cut]


def drawn(folder: Path) -> dict[str, int]:
    return {path.name: path.stat().st_mtime_ns for path in (folder / "frames").glob("SC*.png")}


def timeline(folder: Path) -> list[str]:
    made = otio.adapters.read_from_file(str(folder / "timeline.otio"))
    return [clip.name for clip in made.tracks[0]]


def rows(folder: Path) -> dict[str, dict[str, str]]:
    return {row["shot"]: row for row in csv.DictReader((folder / "shots.csv").open(encoding="utf-8-sig"))}


def test_what_is_known_keeps_every_id_in_a_wanted_order() -> None:
    for wanted in permutations((1, 2, 3)):
        assert in_order((1, 2, 3), wanted) == wanted
        assert sorted(in_order((1, 2, 3, 4), wanted)) == [1, 2, 3, 4]
        assert in_order((2, 3), wanted) == tuple(each for each in wanted if each != 1)
    assert in_order((1, 2, 3, 4), (3, 1)) == (3, 4, 1, 2)


@pytest.mark.parametrize("target", [SECOND, PARK])
def test_omitted_and_restored_is_as_it_was_and_draws_nothing(target: str, session: Session) -> None:
    before, frames = session.graph.model_dump_json(), drawn(session.folder)
    whole, all_rows = timeline(session.folder), rows(session.folder)
    apply(session, omit(target))
    gone = [name for name in whole if name.startswith(target)]
    assert film(session.graph) == [name for name in whole if name not in gone] == timeline(session.folder)
    assert drawn(session.folder) == frames, "the frames stay"
    listed = rows(session.folder)
    assert [*listed] == [*all_rows] and all(listed[name]["status"] == "omitted" for name in gone)
    assert not any(listed[name]["record_in"] for name in gone)
    page = (session.folder / "index.html").read_text("utf-8")
    assert all(f"{name} OMITTED" in page for name in gone)
    assert session.check().clean in (True, False), "what is left can be checked"
    apply(session, restore(target))
    assert session.graph.model_dump_json() == before and drawn(session.folder) == frames
    assert timeline(session.folder) == whole and rows(session.folder) == all_rows
    session.undo()
    session.undo()
    assert session.graph.model_dump_json() == before


def test_reordered_shots_are_the_same_shots_and_no_frame_is_drawn(session: Session) -> None:
    before, frames, shots = session.graph.model_dump_json(), drawn(session.folder), film(session.graph)
    packs = sorted((session.folder / "build" / "scenes").iterdir())
    apply(session, order(target=SECOND, before=FIRST))
    assert film(session.graph)[:2] == [SECOND, FIRST] and sorted(film(session.graph)) == sorted(shots)
    apply(session, order(target=ROOM, after=LATER))
    assert film(session.graph)[-3:-1] == [SECOND, FIRST] == timeline(session.folder)[-3:-1]
    starts = [panel.start for panel in panels(session.graph)]
    lengths = [shot.duration for shot in session.graph.cut]
    assert starts == [sum(lengths[:index]) for index in range(len(lengths))]
    assert drawn(session.folder) == frames and sorted((session.folder / "build" / "scenes").iterdir()) == packs
    back = (order(target=FIRST, before=SECOND), order(target=ROOM, before=PARK))
    apply(session, *back)
    assert session.graph.model_dump_json() == before, "the order of the script is no order of its own"
    for _ in range(3):
        session.undo()
    assert session.graph.model_dump_json() == before


def test_bad_edits_are_refused_in_a_sentence(session: Session) -> None:
    cases: list[tuple[list[dict[str, Any]], str]] = [
        ([omit(FIRST), omit(FIRST)], f"{FIRST} is omitted already"),
        ([omit("SC020_SH010")], "without SC020_SH010 the scene SC020 has no shots left; omit SC020"),
        ([omit(ROOM), omit(PARK), omit(LATER)], f"without {LATER} the film has no shots left"),
        ([restore(FIRST)], f"{FIRST} is not omitted"),
        ([omit(ROOM), restore(FIRST)], f"{FIRST} is not omitted; its scene {ROOM} is; restore that"),
        ([omit("anna")], "anna is neither a shot nor a scene"),
        ([order(target=FIRST, before=SECOND)], f"{FIRST} is before {SECOND} already"),
        ([order(target=FIRST, before=FIRST)], "before itself"),
        ([order(target=FIRST, after="SC020_SH010")], "shots are reordered within their scene"),
        ([order(target=FIRST, after=PARK)], "a scene among scenes"),
        ([order(target=FIRST)], "a new place is before something or after something"),
        ([{"kind": "approve", "shot": SECOND}, omit(SECOND)], f"{SECOND} is approved; withdraw the approval first"),
    ]
    before = session.graph
    for edits, sentence in cases:
        with pytest.raises(InputError, match=sentence):
            session.apply(edits_of(edits))
        assert session.graph == before


def test_an_older_revision_is_in_the_way_of_the_same_place_only(session: Session) -> None:
    seen = session.revision
    session.apply(edits_of([order(target=ROOM, after=PARK), omit(SECOND)]))
    session.apply(edits_of([{"kind": "camera", "shot": SECOND, "decision": {"size": "CU"}}]), seen)
    for edit in (order(target=LATER, before=PARK), restore(SECOND)):
        with pytest.raises(StaleEdit):
            session.apply(edits_of([edit]), seen)


def test_the_cut_stays_with_its_words_when_the_script_changes(folder: Path) -> None:
    with Studio(SETTINGS).open(folder) as session:
        apply(session, order(target=SECOND, before=FIRST), omit("SC030"), order(target=LATER, before=PARK))
    new = "EXT. STREET - DAY\n\nA cat runs.\n\n"
    (folder.parent / "home.fountain").write_text(new + SCRIPT)
    with Studio(SETTINGS).open(folder) as session:
        session.make(folder.parent / "home.fountain")
        graph = session.graph
        assert graph.scene_order == (1, 2, 4, 3) and graph.scene(4).omitted
        assert film(graph)[:3] == ["SC010_SH010", "SC020_SH020", "SC020_SH010"]
        session.undo()
        assert film(session.graph)[:2] == [SECOND, FIRST]

"""Notes and approval: written, seen in what is delivered, kept with the words of their shot, and in nobody's way."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import pytest
from tests.home import SCRIPT, SETTINGS

from storyblender.edits.words import edits_of
from storyblender.errors import InputError, Rejected, StaleEdit
from storyblender.memory.history import replace
from storyblender.memory.shot_context import ShotContext
from storyblender.session import Session
from storyblender.studio import Studio

SHOT, NEXT = "SC010_SH010", "SC010_SH020"
NOTE = {"kind": "note", "shot": SHOT, "text": "Too slow.", "author": "Ilsa"}
APPROVE = {"kind": "approve", "shot": SHOT}


def apply(session: Session, *edits: dict[str, Any], revision: str | None = None) -> tuple[str, ...]:
    applied = session.apply(edits_of(list(edits)), revision)
    assert applied.printed, "board, page and list show it"
    return applied.stale


def shot_of(session: Session) -> ShotContext:
    return session.graph.shots[0]


def test_a_note_is_added_resolved_reopened_and_removed_and_each_is_one_undo(session: Session) -> None:
    steps: list[dict[str, Any]] = [NOTE, {**NOTE, "text": "And closer."}]
    steps += [{"kind": "note", "shot": SHOT, "action": action, "number": 1} for action in ("resolve", "reopen")]
    steps += [{"kind": "note", "shot": SHOT, "action": "remove", "number": 2}]
    before = [session.graph.model_dump_json()]
    for step in steps:
        assert apply(session, step) == (), "no frame shows a note"
        before.append(session.graph.model_dump_json())
    assert [note.words for note in shot_of(session).notes] == ["Ilsa: Too slow."]
    for past in reversed(before[:-1]):
        session.undo()
        assert session.graph.model_dump_json() == past


def test_notes_and_approval_are_delivered_and_draw_no_frame(session: Session) -> None:
    frames = {path.name: path.stat().st_mtime_ns for path in (session.folder / "frames").iterdir()}
    done = {"kind": "note", "shot": NEXT, "text": "Done with."}
    session.draw(session.apply(edits_of([NOTE, done, APPROVE, {**NOTE, "text": "On <approved> too."}])))
    session.draw(session.apply(edits_of([{"kind": "note", "shot": NEXT, "action": "resolve", "number": 1}])))
    assert {path.name: path.stat().st_mtime_ns for path in (session.folder / "frames").iterdir()} == frames
    page = (session.folder / "index.html").read_text("utf-8")
    assert "Ilsa: Too slow." in page and "On &lt;approved&gt; too." in page and page.count("APPROVED") == 1
    assert '<p class="note resolved"><b>Note</b> Done with.' in page
    rows = list(csv.DictReader((session.folder / "shots.csv").open(encoding="utf-8-sig")))
    assert [row["status"] for row in rows] == ["approved", *[""] * (len(rows) - 1)]
    assert "Too slow." in rows[0]["notes"] and not rows[1]["notes"]


def test_another_light_of_what_is_approved_is_told(session: Session) -> None:
    warmer: list[dict[str, Any]] = [{"kind": "light", "scene": "SC010", "decision": {"warmth": 0.5}}]
    assert not session.apply(edits_of(warmer)).warnings
    session.undo()
    apply(session, APPROVE)
    told = session.apply(edits_of(warmer))
    assert SHOT in told.stale and told.warnings == (f"{SHOT} was approved and may look otherwise now",)


def test_what_is_approved_does_not_change_until_the_approval_is_withdrawn(session: Session) -> None:
    lock = {"kind": "lock", "target": SHOT, "parts": ["duration"]}
    apply(session, APPROVE)
    refused: list[dict[str, Any]] = [
        {"kind": "camera", "shot": SHOT, "decision": {"size": "CU"}}, {"kind": "duration", "shot": SHOT, "frames": 9},
        {"kind": "unlock", "target": SHOT}, {"kind": "layout", "scene": "SC010"}, APPROVE,
    ]  # fmt: skip
    for edit in refused:
        with pytest.raises(InputError, match=f"{SHOT} is approved"):
            session.apply(edits_of([edit]))
    apply(session, {**APPROVE, "approved": False})
    assert not shot_of(session).locked
    session.apply(edits_of([lock]))
    apply(session, APPROVE)
    apply(session, {**APPROVE, "approved": False})
    assert shot_of(session).locked == ("duration",), "as it was locked before"


def test_only_what_is_seen_is_approved(session: Session) -> None:
    closer = {"kind": "camera", "shot": SHOT, "decision": {"size": "ECU"}}
    with pytest.raises(InputError, match="as the same step changes it; look at its new frame first"):
        session.apply(edits_of([closer, {**APPROVE, "shot": SHOT.lower()}]))
    session.apply(edits_of([closer]))
    before = session.graph
    with pytest.raises(InputError, match=f"the frame of {SHOT} does not show the shot as it is now; draw it"):
        session.apply(edits_of([APPROVE]))
    assert session.graph == before
    apply(session, {**APPROVE, "shot": NEXT})
    session.shoot([SHOT])
    apply(session, APPROVE)
    session.undo()
    (session.folder / "frames" / f"{SHOT}.png").unlink()
    with pytest.raises(InputError, match=f"{SHOT} is not drawn yet"):
        session.apply(edits_of([APPROVE]))


def test_a_frame_that_an_artist_painted_on_is_approved(session: Session) -> None:
    (session.folder / "frames" / f"{SHOT}.png").write_bytes((session.folder / "frames" / f"{NEXT}.png").read_bytes())
    apply(session, APPROVE)


def test_what_light_made_old_is_not_approved_and_after_an_undo_it_is(session: Session) -> None:
    session.apply(edits_of([{"kind": "light", "scene": "SC010", "decision": {"warmth": 2}}]))
    for name in (SHOT, NEXT):
        with pytest.raises(InputError, match="as it is now"):
            session.apply(edits_of([{**APPROVE, "shot": name}]))
    session.undo()
    apply(session, APPROVE)


def test_bad_notes_are_refused_in_a_sentence(session: Session) -> None:
    apply(session, NOTE)
    cases: list[tuple[dict[str, Any], str]] = [
        ({**NOTE, "text": "  "}, "takes its text"),
        ({**NOTE, "number": 3}, "gets its number"),
        ({"kind": "note", "shot": SHOT, "action": "resolve"}, "takes its number"),
        ({"kind": "note", "shot": SHOT, "action": "resolve", "number": 7}, f"{SHOT} has no note 7; it has: 1"),
        ({"kind": "note", "shot": SHOT, "action": "reopen", "number": 1}, "is open already"),
        ({**APPROVE, "approved": False}, "not approved"),
    ]
    for edit, sentence in cases:
        with pytest.raises(InputError, match=sentence):
            session.apply(edits_of([edit]))


def test_the_crew_writes_no_notes_and_an_older_revision_is_in_the_way_only_of_the_same(session: Session) -> None:
    seen = session.revision
    apply(session, NOTE)
    session.apply(edits_of([{"kind": "camera", "shot": SHOT, "decision": {"size": "CU"}}]), seen)
    with pytest.raises(StaleEdit):
        apply(session, NOTE, revision=seen)
    project = session._project  # the crew's way in
    bare = shot_of(session).model_copy(update={"notes": ()})
    with pytest.raises(Rejected, match="people write the notes"):
        project.commit(replace(project.graph, bare), "camera_operator", "tidy")


def test_notes_and_approval_stay_with_the_words_of_their_shot(folder: Path) -> None:
    with Studio(SETTINGS).open(folder) as session:
        apply(session, NOTE, {**NOTE, "shot": "SC020_SH010", "text": "Park."}, {**APPROVE, "shot": "SC020_SH010"})
        approved = session.graph.shot(2, 1)
    before, park = SCRIPT.split("EXT. PARK - DAY")
    changed = f"EXT. PARK - DAY{park.replace('INT. LIVING ROOM - NIGHT', before + 'INT. LIVING ROOM - NIGHT')}"
    (folder.parent / "home.fountain").write_text(changed)
    with Studio(SETTINGS).open(folder) as session:
        session.make(folder.parent / "home.fountain")
        kept = session.graph.shot(1, 1)
        assert (
            [note.text for note in kept.notes] == ["Park."] and kept.approved == () and kept.locked == approved.locked
        )
        assert (kept.camera, kept.blocking) == (approved.camera, approved.blocking)
        assert [note.text for note in session.graph.shot(2, 1).notes] == ["Too slow."]

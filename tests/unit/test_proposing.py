"""Stagings that are proposed differ, have no fault, leave the scene as it is, and are what choosing one gives."""

from __future__ import annotations

import pytest

from storyblender.agents.layout_artist.layout_things import layout_violations
from storyblender.agents.layout_artist.spatial_planner_view import measures_of
from storyblender.catalog.sets import plan_of
from storyblender.edits.words import edits_of
from storyblender.errors import InputError
from storyblender.proposing import propose_stagings
from storyblender.session import Session

ROOM, SHOT = "SC010", "SC010_SH020"


def test_they_differ_and_the_scene_stays_as_it_is(session: Session) -> None:
    before = (session.folder / "graph.json").read_bytes()
    found = propose_stagings(session, ROOM, 2)
    assert (session.folder / "graph.json").read_bytes() == before
    assert len(found) == 2 and len({each.number for each in found}) == 2
    for each in found:
        assert {*each.pictures} == {f"{ROOM}_SH{number:03d}" for number in (10, 20, 30)}
        assert all(path.is_file() for path in each.pictures.values())
        assert max(each.moved.values()) > 0.25 and f"{max(each.moved.values()):.1f} m" in each.words


def test_the_one_that_is_chosen_is_the_one_that_was_shown_and_has_no_fault(session: Session) -> None:
    was = session.graph.scene(1).layout
    last = propose_stagings(session, SHOT, 2)[-1]
    assert [*last.pictures] == [SHOT]
    session.draw(session.apply(edits_of([{"kind": "layout", "scene": ROOM, "staging": last.number}])))
    scene = session.graph.scene(1)
    assert scene.layout is not None and scene.environment is not None and was is not None
    there = {item.node_id: item.location for item in was.objects}
    for item in scene.layout.objects:
        if item.node_id in last.moved:
            away = sum((a - b) ** 2 for a, b in zip(item.location, there[item.node_id], strict=True)) ** 0.5
            assert away == pytest.approx(last.moved[item.node_id], abs=0.006)
    assert not layout_violations(scene.layout, measures_of(session.graph.assets), plan_of(scene.environment))


def test_it_is_taken_back_whatever_happens(session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    before = (session.folder / "graph.json").read_bytes()

    def fail(_: object, names: object) -> None:
        raise OSError("the disk is full")

    monkeypatch.setattr(Session, "preview", fail)
    with pytest.raises(OSError, match="full"):
        propose_stagings(session, ROOM, 1)
    assert (session.folder / "graph.json").read_bytes() == before


@pytest.mark.parametrize("name, wanted", [("SC990", 2), ("SC010_SH990", 2), (ROOM, 0), (ROOM, 99)])
def test_what_cannot_be_is_refused(name: str, wanted: int, session: Session) -> None:
    with pytest.raises(InputError):
        propose_stagings(session, name, wanted)


def test_a_scene_that_is_locked_is_refused(session: Session) -> None:
    session.apply(edits_of([{"kind": "lock", "target": ROOM, "parts": ["layout"]}]))
    with pytest.raises(InputError, match="locked"):
        propose_stagings(session, ROOM, 2)

"""Only what an edit reaches becomes stale, is previewed from its own scene, and is drawn anew: by families of edits."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from pydantic import TypeAdapter
from tests.stage import SETTINGS, Stage

from storyblender.edits.effect import name_of
from storyblender.memory.edits import Edit, LayoutEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.session import Session
from storyblender.studio import Studio

EDIT: TypeAdapter[Edit] = TypeAdapter(Edit)
Words = Callable[[ContinuityMemoryGraph], dict[str, Any]]


def thing(graph: ContinuityMemoryGraph) -> str:
    layout = graph.scenes[0].layout
    assert layout is not None
    things = {asset.asset_id for asset in graph.assets if asset.asset_type == "object"}
    return next(item.node_id for item in layout.objects if item.asset_id in things)


def person(graph: ContinuityMemoryGraph) -> str:
    return next(each.start.asset_id for shot in graph.shots_of(1) for each in shot.blocking)


FAMILIES: dict[str, Words] = {
    "camera": lambda graph: {"kind": "camera", "shot": "SC010_SH010", "decision": {"size": "ECU"}},
    "light": lambda graph: {"kind": "light", "scene": "SC010", "decision": {"brightness": 1.0}},
    "layout": lambda graph: {"kind": "place", "scene": "SC010", "thing": thing(graph), "place": {"rotation": 33.0}},
    "staging": lambda graph: {"kind": "layout", "scene": "SC010"},
    "marks": lambda graph: {
        "kind": "blocking", "shot": "SC010_SH010", "person": person(graph), "marks": {"end": {"location": [1.0, -1.0]}}
    },
    "duration": lambda graph: {"kind": "duration", "shot": "SC010_SH010", "frames": 61},
    "set": lambda graph: {"kind": "set", "scene": "SC010", "decision": {"walls": "brick"}},
}  # fmt: skip


@pytest.fixture
def session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    stage = Stage(tmp_path / "p", monkeypatch)
    with Studio(SETTINGS).open(stage.folder) as session:
        session.apply([LayoutEdit(scene="SC010"), LayoutEdit(scene="SC020")])  # the crew has staged both
        session.render()
        assert not session.stale_frames()
        yield session, stage


@pytest.mark.parametrize("family", FAMILIES)
def test_only_reached_shots_are_stale(session: tuple[Session, Stage], family: str) -> None:
    opened, stage = session
    before = {name_of(shot): shot for shot in opened.graph.shots if shot.scene_id != 1}
    applied = opened.apply([EDIT.validate_python(FAMILIES[family](opened.graph))])
    own = [name_of(shot) for shot in opened.graph.shots_of(1)]
    assert applied.stale and {*applied.stale} <= {*own}
    stage.engine.calls.clear()
    opened.preview(applied.stale[:1])
    calls = dict(stage.engine.calls)
    assert calls["rehearse"] == 1 and calls["render_frame"] == 1
    assert not {"pack_scene", "render_motion", "compile_story"} & {*calls}, "no more than is looked at"
    drawn_anew = opened.stale_frames()
    assert {*drawn_anew} <= {*applied.stale}
    assert drawn_anew or family == "staging", "of a room with one chair, every staging is the same"
    assert {name_of(shot): shot for shot in opened.graph.shots if shot.scene_id != 1} == before


def test_another_light_leaves_a_camera_where_a_preview_has_set_it(session: tuple[Session, Stage]) -> None:
    opened, stage = session
    opened.apply([EDIT.validate_python(FAMILIES["camera"](opened.graph))])
    opened.preview(["SC010_SH010"])
    assert opened.graph.shot(1, 1).camera is None, "previews commit nothing"
    opened.apply([EDIT.validate_python(FAMILIES["light"](opened.graph) | {"decision": {"brightness": 1.4}})])
    stage.engine.calls.clear()
    opened.preview(["SC010_SH010"])
    assert stage.engine.calls["render_frame"] == 1 and not stage.engine.calls["look"]

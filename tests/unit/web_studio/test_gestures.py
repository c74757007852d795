"""Random gestures over the wire: undone, the story and its frames are as they were; redone, as they had become."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient
from tests.stage import Stage
from tests.unit.web_studio.test_wire import Browser, cards

from storyblender.project import read_project_graph
from storyblender.web_studio.app import build_app
from storyblender.web_studio.hub import Hub


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Stage:
    return Stage(tmp_path / "tale.storyboard", monkeypatch)


@pytest.fixture
def browser(stage: Stage) -> Iterator[Browser]:
    hub = Hub(stage.folder.parent)
    hub.open(stage.folder.name)
    with TestClient(build_app(hub)) as client, client.websocket_connect("/wire") as socket:
        yield Browser(socket)
    hub.close()


def gesture(chance: random.Random, stage: Stage, shots: list[str]) -> list[dict[str, Any]]:
    """Return one gesture of a person at the page; some of them cannot be made at the moment."""
    graph = read_project_graph(stage.folder)
    shot = chance.choice(shots)
    scene = shot[:5]
    other = chance.choice(shots)
    layout = next((each.layout for each in graph.scenes if f"SC{each.scene_id * 10:03d}" == scene), None)
    thing = chance.choice([item.node_id for item in layout.objects] or ["chair"]) if layout is not None else "chair"
    spot = [round(chance.uniform(-2, 2), 2), round(chance.uniform(-2, 2), 2)]
    camera = chance.choice(
        [{"size": chance.choice(["WS", "MS", "CU", "ECU"])}, {"lens": chance.choice([24, 35, 50, 85])},
         {"angle": chance.choice(["low angle", "high angle", "eye-level"])}, {"f_number": 2.8},
         {"placed": {"start": {"location": [*spot, 1.5], "target": [3, 3, 1]}}}]
    )  # fmt: skip
    person = chance.choice([mark.start.asset_id for each in graph.shots for mark in each.blocking] or ["ada"])
    return chance.choice(
        [
            [{"kind": "camera", "shot": shot, "decision": camera}],
            [{"kind": "camera", "shot": shot, "decision": camera}],
            [{"kind": "duration", "shot": shot, "frames": chance.randrange(20, 120)}],
            [{"kind": "place", "scene": scene, "thing": thing, "place": {"location": spot, "rotation": spot[0] * 90}}],
            [{"kind": "blocking", "shot": shot, "person": person, "marks": {"end": {"location": spot}}}],
            [{"kind": "light", "scene": scene, "decision": {"warmth": round(chance.uniform(-2, 2), 1)}}],
            [{"kind": "note", "shot": shot, "text": f"note {spot}"}],
            [{"kind": "approve", "shot": shot, "approved": chance.random() < 0.3}],
            [{"kind": chance.choice(["lock", "unlock"]), "target": shot, "parts": ["camera"]}],
            [{"kind": chance.choice(["omit", "restore"]), "target": shot}],
            [{"kind": "reorder", "target": shot, chance.choice(["before", "after"]): other}],
            [{"kind": "take", "shot": shot, "action": "keep"}],
            [{"kind": "take", "shot": shot, "action": "choose", "number": chance.randrange(1, 3)}],
            [{"kind": "take", "shot": shot, "of": "blocking", "action": "keep"}],
            [{"kind": "take", "shot": shot, "of": "blocking", "action": "choose", "number": chance.randrange(1, 3)}],
            [{"kind": "take", "shot": scene, "of": "layout", "action": "keep"}],
            [{"kind": "take", "shot": scene, "of": "layout", "action": "choose", "number": chance.randrange(1, 3)}],
            [{"kind": "split", "shot": shot, "frames": chance.randrange(2, 20)}],
            [{"kind": "join", "shot": shot, "other": other}],
        ]
    )


def changes_by_people(stage: Stage) -> int:
    """Return how many commits of the history are a person's."""
    commits = (json.loads(path.read_bytes()) for path in (stage.folder / "history").glob("*.json"))
    return sum(commit["author"] == "user" for commit in commits)


def story(stage: Stage) -> bytes:
    return read_project_graph(stage.folder).model_dump_json().encode()


def frames(stage: Stage, board: dict[str, Any]) -> dict[str, bytes]:
    names = [card["shot"] for card in cards(board) if not card["omitted"]]
    return {name: (stage.folder / "frames" / f"{name}.png").read_bytes() for name in names}


@pytest.mark.parametrize("gestures", [40, pytest.param(200, marks=[pytest.mark.slow, pytest.mark.timeout(2400)])])
def test_all_gestures_are_undone_and_redone(browser: Browser, stage: Stage, gestures: int) -> None:
    chance = random.Random(gestures)
    board = browser.is_drawn()
    first, first_frames = story(stage), frames(stage, board)
    began = changes_by_people(stage)
    made = refused = 0
    while made < gestures:
        shots = [card["shot"] for card in cards(browser.value("board"))]
        answer = browser.call("apply", edits=gesture(chance, stage, shots))
        assert answer["ok"] or "failed, and should not" not in answer["error"], answer
        made = changes_by_people(stage) - began
        refused += not answer["ok"]
        assert refused < 4 * gestures
        browser.news.clear()
    last_frames = frames(stage, browser.is_drawn())
    last = story(stage)
    assert last != first
    for way, after, drawn in (("undo", first, first_frames), ("redo", last, last_frames)):
        for number in range(gestures):
            browser.value(way)
            browser.news.clear()
            if number % 10 == 0:
                browser.is_drawn()  # the crew works on what the person has gone back to
        assert story(stage) == after, f"one gesture, one {way}"
        assert frames(stage, browser.is_drawn()) == drawn

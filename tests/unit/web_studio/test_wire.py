"""What the page and the studio say to each other, on a stand-in engine: calls, news, refusals, and any nonsense."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from starlette.testclient import TestClient, WebSocketTestSession
from tests.panoramas import write_sky
from tests.stage import Stage

from storyblender.project import read_project_graph
from storyblender.web_studio.address_file import ADDRESS_FILE, AddressFile
from storyblender.web_studio.app import LARGEST_CALL, build_app
from storyblender.web_studio.hub import Hub

SHOT = "SC010_SH010"
SIZE = [{"kind": "camera", "shot": SHOT, "decision": {"size": "ECU"}}]
MESSAGES = 5000


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Stage:
    return Stage(tmp_path / "tale.storyboard", monkeypatch)


@pytest.fixture
def page(stage: Stage) -> Iterator[TestClient]:
    hub = Hub(stage.folder.parent)
    hub.open(stage.folder.name)
    with TestClient(build_app(hub)) as client:
        yield client
    hub.close()


class Browser:
    """One browser on the wire."""

    def __init__(self, socket: WebSocketTestSession) -> None:
        self.socket, self.number, self.news = socket, 0, list[dict[str, Any]]()

    def says(self, text: str) -> dict[str, Any]:
        """Send a message and return its answer; news on the way are kept."""
        self.socket.send_text(text)
        while True:
            heard = json.loads(self.socket.receive_text())
            if "ok" in heard:
                return heard
            self.news.append(heard)

    def call(self, call: str, **values: Any) -> dict[str, Any]:
        self.number += 1
        answer = self.says(json.dumps({"id": self.number, "call": call, **values}))
        assert answer["id"] == self.number
        return answer

    def value(self, call: str, **values: Any) -> Any:
        answer = self.call(call, **values)
        assert answer["ok"], answer
        return answer["value"]

    def waits_for(self, news: str) -> dict[str, Any]:
        while True:
            for heard in self.news:
                if heard.get("news") == news:
                    self.news.remove(heard)
                    return heard
            self.news.append(json.loads(self.socket.receive_text()))

    def is_drawn(self) -> dict[str, Any]:
        """Wait until every frame shows the story as it is, and return the board."""
        while True:
            board = self.value("board")
            if all(card["state"] == "fresh" for card in cards(board)):
                return board
            self.waits_for("frames")


def cards(board: dict[str, Any]) -> list[dict[str, Any]]:
    return [card for scene in board["scenes"] for card in scene["shots"]]


def card(board: dict[str, Any], shot: str = SHOT) -> dict[str, Any]:
    return next(card for card in cards(board) if card["shot"] == shot)


def test_an_edit_is_one_undo_and_its_frame_follows(page: TestClient, stage: Stage) -> None:
    with page.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        board = browser.is_drawn()
        before = read_project_graph(stage.folder)
        assert card(board)["facts"].split()[0] != "ECU"
        done = browser.value("apply", edits=SIZE, revision=board["revision"])
        assert done["stale"] == [SHOT]
        board = browser.value("board")
        assert card(board)["facts"].startswith("ECU") and card(board)["state"] != "fresh"
        assert "ECU" in board["undo"] and not board["redo"]
        board = browser.is_drawn()
        assert page.get(card(board)["picture"]).content.startswith(b"\x89PNG")
        browser.value("undo")
        assert read_project_graph(stage.folder) == before
        assert "ECU" in browser.value("board")["redo"]


def test_shots_come_and_go_and_the_frames_of_the_others_are_drawn(page: TestClient) -> None:
    with page.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        board = browser.is_drawn()
        shots = [card["shot"] for card in cards(board)]
        split = {"kind": "split", "shot": SHOT, "frames": 5}
        add = {"kind": "add_shot", "shot": SHOT, "decision": {"size": "CU"}}
        for edits in ([split], [add], [split, add]):
            browser.value("apply", edits=edits)
            assert len(cards(browser.value("board"))) == len(shots) + len(edits)
            browser.value("undo")
            browser.value("apply", edits=SIZE)
            browser.value("undo")
        assert [card["shot"] for card in cards(browser.is_drawn())] == shots
        told = [heard["event"] for heard in browser.news if heard["news"] == "event"]
        assert not [event for event in told if event["kind"] == "warning" and event["role"] == "frames"]


def test_a_shot_is_offered_to_be_split_only_where_both_parts_are_shots_as_the_crew_plans_them(page: TestClient) -> None:
    with page.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        shots, tried = browser.value("shots"), 0
        for shot in shots:
            places = browser.value("shot", shot=shot["shot"])["split"]
            times = [places["first"], places["last"]] if places["first"] <= places["last"] else []
            assert times or shot["seconds"] < 2 * places["shortest"] + 0.2
            for where in [{"seconds": second} for second in times] + [{"line": line} for line in places["lines"]]:
                browser.value("apply", edits=[{"kind": "split", "shot": shot["shot"], **where}])
                parts = [each["seconds"] for each in browser.value("shots") if each not in shots]
                assert len(parts) == 2 and min(parts) >= places["shortest"], (shot["shot"], where)
                browser.value("undo")
                tried += 1
        assert tried


def test_two_browsers_see_each_others_edits_and_a_stale_one_is_refused(page: TestClient) -> None:
    with page.websocket_connect("/wire") as one, page.websocket_connect("/wire") as two:
        anna, ben = Browser(one), Browser(two)
        seen = ben.value("board")["revision"]
        anna.value("apply", edits=SIZE, revision=seen)
        assert ben.waits_for("board")["revision"] != seen
        refused = ben.call("apply", edits=[{**SIZE[0], "decision": {"size": "WS"}}], revision=seen)
        assert not refused["ok"] and "ECU" in refused["error"]
        assert ben.call("apply", edits=[{"kind": "duration", "shot": SHOT, "seconds": 3}], revision=seen)["ok"]


@pytest.mark.parametrize(
    "edits",
    [
        [{"kind": "camera", "shot": "SC990_SH010", "decision": {"size": "CU"}}],
        [{"kind": "camera", "shot": SHOT, "decision": {"size": "huge"}}],
        [{"kind": "nothing"}],
        [],
        [*SIZE, {"kind": "duration", "shot": SHOT, "seconds": -1}],
    ],
)
def test_an_edit_that_cannot_be_is_a_sentence_and_changes_nothing(
    page: TestClient, stage: Stage, edits: list[dict[str, Any]]
) -> None:
    with page.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        browser.is_drawn()
        before = read_project_graph(stage.folder)
        refused = browser.call("apply", edits=edits)
    assert not refused["ok"] and refused["error"] and "Traceback" not in refused["error"]
    assert read_project_graph(stage.folder) == before


@pytest.mark.parametrize(
    "address",
    ["/frames/..%2f..%2fgraph.png", "/frames/graph.png", "/files/graph.json", "/files/..%2fsecret", "/previews/x.png",
     "/takes/SC010_SH010-1.png", "/takes/..%2f..%2fgraph.png", "/static/..%2f..%2fserve.py", "/static/../serve.py"],
)  # fmt: skip
def test_nothing_but_pictures_and_deliverables_leaves_the_project(page: TestClient, address: str) -> None:
    assert page.get(address).status_code == 404


def nonsense(chance: random.Random, board: dict[str, Any]) -> str:
    """Return a message that may be broken at any depth."""
    shots = [card["shot"] for card in cards(board)]
    words = [*shots, "", "x" * 200, "\u0000", "../graph.json", "SC010", None, -1, 1e300, [], {}, True, "CU", "7"]
    calls = ["open", "apply", "instruct", "shot", "places", "board", "vocabulary", "undo", "redo", "check?", "", None]
    kinds = ["camera", "duration", "lock", "unlock", "take", "layout", "light", "set", "asset", "note", 3, None]
    edit = {"kind": chance.choice(kinds), "shot": chance.choice(words), "scene": chance.choice(words),
            "target": chance.choice(words), "seconds": chance.choice(words), "action": chance.choice(words),
            "decision": {chance.choice(["size", "lens", "angle", "x"]): chance.choice(words)}}  # fmt: skip
    kept = {name: value for name, value in edit.items() if name == "kind" or chance.random() < 0.4}
    message = {"id": chance.choice([1, 2, -1, "a", None]), "call": chance.choice(calls), "edits": [kept],
               "words": chance.choice(words), "shot": chance.choice(words), "revision": chance.choice(words),
               "project": chance.choice(words)}  # fmt: skip
    text = json.dumps({name: value for name, value in message.items() if chance.random() < 0.8})
    cut = chance.randrange(len(text))
    return text if chance.random() < 0.8 else text[:cut] + chance.choice(["", "}", '"', "\u2028"]) + text[cut + 1 :]


def test_any_nonsense_is_refused_and_the_story_stays_whole(page: TestClient, stage: Stage) -> None:
    chance = random.Random(15)
    with page.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        board = browser.value("board")
        refused = 0
        for _ in range(MESSAGES):
            answer = browser.says(nonsense(chance, board))
            refused += not answer["ok"]
            assert answer["ok"] or (answer["error"] and "Traceback" not in answer["error"])
        assert refused > MESSAGES // 2
        browser.value("open", project=stage.folder.name)
        assert browser.value("board")["scenes"]
    assert read_project_graph(stage.folder).shots


def test_the_stage_of_a_shot_has_its_model_and_the_cameras_of_its_scene(page: TestClient) -> None:
    with page.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        board = browser.is_drawn()
        stage = browser.value("stage", shot=SHOT)
        own = [shot["shot"] for scene in board["scenes"] if scene["scene"] == SHOT[:5] for shot in scene["shots"]]
        assert [camera["shot"] for camera in stage["cameras"]] == own
        assert 0 <= stage["frame"] < stage["frames"]
        assert page.get(stage["model"]).content.startswith(b"moment ")
        last = browser.value("stage", shot=SHOT, frame=10**6)
        assert last["frame"] == stage["frames"] - 1 and last["model"] != stage["model"]
        assert not browser.call("stage", shot="SC990_SH010")["ok"]


def test_a_shot_says_why_and_shows_its_other_takes(page: TestClient) -> None:
    with page.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        browser.is_drawn()
        assert browser.value("takes", shot=SHOT) == {}
        browser.value("apply", edits=[{"kind": "take", "shot": SHOT, "action": "keep"}, *SIZE])
        browser.is_drawn()
        [(number, address)] = browser.value("takes", shot=SHOT).items()
        reasons = browser.value("why", shot=SHOT)
        assert [role["by"] for role in reasons["roles"] if role["role"] == "camera_operator"] == ["rules"]
        assert number == "1" and page.get(address).content.startswith(b"\x89PNG")
        assert not browser.call("why", shot="SC990_SH010")["ok"]


def test_a_revised_script_is_compared_taken_over_and_taken_back(page: TestClient, stage: Stage) -> None:
    with page.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        browser.is_drawn()
        before = read_project_graph(stage.folder)
        [script] = stage.folder.glob("script.*")
        text = script.read_text(encoding="utf-8") + "\n\nINT. CELLAR - NIGHT\n\nA lamp burns on a table.\n"
        revised = {"script": f"tale{script.suffix}", "text": text}
        changes = browser.value("compare", **revised)
        assert {each["kind"] for each in changes["shots"]} == {"new"}
        assert read_project_graph(stage.folder) == before, "a comparison changes nothing"
        assert browser.value("revise", **revised)["busy"]
        while browser.waits_for("status")["status"]["busy"]:
            pass
        assert len(cards(browser.value("board"))) == sum(1 for _ in before.shots) + len(changes["shots"])
        browser.value("undo")
        assert len(cards(browser.value("board"))) == len(before.shots)
        assert not browser.call("compare", script="../tale.fountain", text=text)["ok"]
        assert not browser.call("compare", script="missing.fountain")["ok"]


def test_a_crew_that_names_a_folder_is_refused_from_the_page(page: TestClient) -> None:
    with page.websocket_connect("/wire") as socket:
        for crew in ("ask:/etc", "rules,director=replay:../elsewhere"):
            refused = Browser(socket).call("make", script="a.fountain", text="INT. A - DAY", crew=crew)
            assert not refused["ok"] and "crew" in refused["error"]


def test_a_script_is_opened_as_the_project_that_was_made_of_it(stage: Stage) -> None:
    hub = Hub(stage.folder.parent)
    hub.begin("tale.fountain")
    assert hub.place.session.folder == stage.folder
    hub.close()


def test_the_cut_is_the_film_in_its_order_with_what_is_said_when(page: TestClient) -> None:
    with page.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        cut = browser.value("cut")
        names = [shot["shot"] for shot in cut["shots"]]
        assert names == [card["shot"] for card in cards(browser.value("board"))]
        for shot in cut["shots"]:
            assert all(0 <= said["start"] <= said["end"] <= shot["frames"] for said in shot["speech"])
        browser.value("apply", edits=[{"kind": "omit", "target": names[0]}])
        assert [shot["shot"] for shot in browser.value("cut")["shots"]] == names[1:]
        browser.value("undo")
        assert not any(shot["held"] for shot in cut["shots"])
        held = {names[0]: {"kind": "lock", "target": names[0], "parts": ["duration"]}}
        held[names[1]] = {"kind": "split", "shot": names[1], "frames": 10}
        browser.value("apply", edits=list(held.values()))
        shots = {shot["shot"]: shot["held"] for shot in browser.value("cut")["shots"]}
        for name in held:
            refused = browser.call("apply", edits=[{"kind": "duration", "shot": name, "seconds": 9}])
            assert shots[name] and refused["error"] == shots[name], "the reason is that of the edit itself"
        browser.value("undo")


def test_a_scene_tells_its_set_and_light_and_what_both_can_be(page: TestClient) -> None:
    with page.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        board = browser.value("board")
        scene = browser.value("scene", scene=SHOT[:5])
        assert scene["shots"] == [card["shot"] for card in cards(board) if card["scene"] == SHOT[:5]]
        assert scene["kit"] in {kit["key"] for kit in scene["kits"]}
        assert scene["time_of_day"] in scene["words"]["time_of_day"]
        browser.value("apply", edits=[{"kind": "light", "scene": SHOT[:5], "decision": {"warmth": 1.5}}])
        changed = browser.value("scene", scene=SHOT[:5])
        assert changed["warmth"] == 1.5 and any("warmth" in said for said in changed["decided"])
        browser.value("undo")
        assert not browser.call("scene", scene="SC990")["ok"]


def test_a_program_makes_the_same_calls_one_at_a_time(page: TestClient) -> None:
    said = page.post("/calls", json={"id": 1, "call": "apply", "edits": SIZE}).json()
    assert said["ok"] and said["value"]["stale"] == [SHOT]
    shots = page.post("/calls", json={"id": 2, "call": "shots"}).json()["value"]
    assert [each["size"] for each in shots if each["shot"] == SHOT] == ["ECU"]
    drawn = page.post("/calls", json={"id": 3, "call": "draw", "shot": SHOT}).json()
    assert drawn["value"] == f"frames/{SHOT}.png"
    pulled = page.post("/calls", json={"id": 4, "call": "pull"}).json()
    assert pulled["value"] == {"files": [], "understood": [], "conflicts": [], "kept": []}
    assert page.post("/calls", json={"id": 5, "call": "write", "what": "all"}).json()["ok"]
    while (status := page.post("/calls", json={"id": 6, "call": "places"}).json()["value"]["status"])["busy"]:
        pass
    assert not status["error"]
    refused = page.post("/calls", content=b"\xff{").json()
    assert not refused["ok"] and refused["error"]
    assert page.post("/calls", content=b" " * (LARGEST_CALL + 1)).status_code == 413


def test_the_address_of_the_studio_is_in_the_open_project_alone_and_private(stage: Stage) -> None:
    hub = Hub(stage.folder.parent, AddressFile("http://127.0.0.1:1", "secret").follow)
    hub.open(stage.folder.name)
    file = stage.folder / ADDRESS_FILE
    assert json.loads(file.read_text()) == {
        "address": "http://127.0.0.1:1", "key": "secret", "project": str(stage.folder.resolve()),
    }  # fmt: skip
    assert file.stat().st_mode & 0o777 == 0o600
    hub.close()
    assert not file.exists()


def test_a_scene_is_lit_by_a_panorama_of_the_folder(page: TestClient, stage: Stage) -> None:
    write_sky(stage.folder.parent / "sky.hdr")
    with page.websocket_connect("/wire") as socket:
        browser = Browser(socket)
        browser.is_drawn()
        assert browser.value("scene", scene=SHOT[:5])["panoramas"] == [], "a room"
        assert browser.value("scene", scene="SC020")["panoramas"] == ["sky.hdr"]
        before = read_project_graph(stage.folder)
        browser.value("panorama", scene="SC020", file="sky.hdr")
        [decided] = [each for each in browser.value("scene", scene="SC020")["decided"] if "panorama" in each]
        assert decided == "light: panorama sky.hdr"
        for name in ("../sky.hdr", "other.hdr", "/etc/passwd"):
            assert "no panorama" in browser.call("panorama", scene="SC020", file=name)["error"]
        browser.value("undo")
        assert read_project_graph(stage.folder) == before

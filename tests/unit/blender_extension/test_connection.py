"""The extension talks to the studio that holds the project, to the program otherwise, and says what went wrong."""

from __future__ import annotations

import json
import sys
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("bpy")

from storyblender.blender_extension.connection import ADDRESS_FILE, NotDone, Program, Studio, reach
from storyblender.web_studio.address_file import ADDRESS_FILE as WRITTEN
from storyblender.web_studio.address_file import AddressFile


class Answering(BaseHTTPRequestHandler):
    """A studio that answers the right key, and keeps what it was asked."""

    asked: list[dict[str, Any]]
    answer: dict[str, Any]
    later: list[dict[str, Any]]
    """Answers after it."""

    def do_POST(self) -> None:
        body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        allowed = self.headers["Authorization"] == "Bearer right" and "Origin" not in self.headers
        if allowed:
            self.asked.append(body)
        text = json.dumps(self.answer if allowed else {}).encode()
        if allowed and self.later:
            type(self).answer = self.later.pop(0)
        self.send_response(200 if allowed else 403)
        self.send_header("Content-Length", str(len(text)))
        self.end_headers()
        self.wfile.write(text)

    def log_message(self, format: str, *args: Any) -> None:
        pass


@pytest.fixture
def studio() -> Iterator[HTTPServer]:
    Answering.asked, Answering.later = [], []
    Answering.answer = {"id": 1, "ok": True, "value": {"understood": []}}
    server = HTTPServer(("127.0.0.1", 0), Answering)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield server
    server.shutdown()
    server.server_close()


def address(studio: HTTPServer) -> str:
    return f"http://127.0.0.1:{studio.server_port}"


def program(folder: Path, code: str) -> str:
    """Write a program that does as it is told."""
    path = folder / "program"
    path.write_text(f"#!{sys.executable}\n{code}\n")
    path.chmod(0o755)
    return str(path)


def test_the_studio_is_found_by_the_file_that_it_writes(tmp_path: Path, studio: HTTPServer) -> None:
    assert ADDRESS_FILE == WRITTEN
    with pytest.raises(NotDone, match="Program"):
        reach(tmp_path, "")
    AddressFile(address(studio), "right").follow(tmp_path)
    link = reach(tmp_path, "")
    assert isinstance(link, Studio)
    link.edit([{"kind": "lock", "target": "SC010"}], "7.abc")
    [call] = Answering.asked
    assert call["call"] == "apply" and call["edits"][0]["target"] == "SC010" and call["revision"] == "7.abc"


@pytest.mark.parametrize("broken", ["{", "[]", '{"address": 3}', '{"address": "http://127.0.0.1:1"}'])
def test_a_file_that_no_studio_wrote_is_passed_over(tmp_path: Path, studio: HTTPServer, broken: str) -> None:
    file = tmp_path / ADDRESS_FILE
    file.write_text(broken)
    file.chmod(0o600)
    assert isinstance(reach(tmp_path, "program"), Program)


def test_a_studio_elsewhere_or_of_another_folder_or_read_by_others_is_not_talked_to(
    tmp_path: Path, studio: HTTPServer
) -> None:
    here, copy = tmp_path / "here", tmp_path / "copy"
    for folder in (here, copy):
        folder.mkdir()
    AddressFile(address(studio), "right").follow(here)
    (copy / ADDRESS_FILE).write_bytes((here / ADDRESS_FILE).read_bytes())
    (copy / ADDRESS_FILE).chmod(0o600)
    assert isinstance(reach(copy, "program"), Program), "copied with its project"
    (here / ADDRESS_FILE).chmod(0o644)
    assert isinstance(reach(here, "program"), Program), "anybody may have written it"
    AddressFile("http://elsewhere.example:80", "right").follow(here)
    assert isinstance(reach(here, "program"), Program)


def test_a_killed_studio_is_passed_over_and_one_that_ends_is_told(tmp_path: Path, studio: HTTPServer) -> None:
    AddressFile(address(studio), "right").follow(tmp_path)
    link = reach(tmp_path, "program")
    studio.shutdown()
    studio.server_close()
    with pytest.raises(NotDone, match="does not answer"):
        link.undo()
    assert isinstance(reach(tmp_path, "program"), Program)


def test_a_wrong_key_and_a_refusal_are_told_in_a_sentence(studio: HTTPServer) -> None:
    with pytest.raises(NotDone, match="refused the key"):
        Studio(f"127.0.0.1:{studio.server_port}", "wrong").pull()
    assert not Answering.asked
    Answering.answer = {"id": 1, "ok": False, "error": "SC010_SH010 is locked; unlock it first"}
    with pytest.raises(NotDone, match="is locked; unlock it first"):
        Studio(f"127.0.0.1:{studio.server_port}", "right").undo()


def test_the_studio_is_waited_for_while_it_writes_and_its_failure_is_told(studio: HTTPServer) -> None:
    busy, failed = {"busy": True, "error": ""}, {"busy": False, "error": "the disk is full"}
    answers = [{"status": busy}, {"status": busy}, {"status": failed}]
    Answering.later = [{"id": 1, "ok": True, "value": value} for value in answers]
    with pytest.raises(NotDone, match="the disk is full"):
        Studio(f"127.0.0.1:{studio.server_port}", "right").push()
    assert [call["call"] for call in Answering.asked] == ["write", "places", "places", "places"]
    assert Answering.asked[0]["what"] == "all"


def test_what_was_seen_of_the_shots_is_not_asked_for_again(studio: HTTPServer) -> None:
    Answering.answer = {"id": 1, "ok": True, "value": {"revision": "7.abc"}}
    link = Studio(f"127.0.0.1:{studio.server_port}", "right")
    assert link.story("7.abc")["shots"] == [] and link.story("6.abc")["shots"]
    assert [call["call"] for call in Answering.asked] == ["board", "board", "shots"]


def test_the_program_gets_edits_on_its_standard_input(tmp_path: Path) -> None:
    code = "import sys, json\njson.dump([sys.argv[1:], json.load(sys.stdin)], open(sys.argv[0] + '.said', 'w'))"
    path = program(tmp_path, code)
    Program(path, tmp_path).edit([{"kind": "lock"}], "7.abc")
    words, edits = json.loads(Path(f"{path}.said").read_text())
    assert words[:4] == ["edit", str(tmp_path), "--batch", "-"] and words[-3:] == ["--revision", "7.abc", "--json"]
    assert edits == [{"kind": "lock"}]


@pytest.mark.parametrize(
    ("code", "said"),
    [
        ("""print('{"event": {}}'); print('{"error": "another run is writing here"}'); exit(2)""", "another run"),
        ("import sys; sys.stderr.write('no such command'); exit(2)", "no such command"),
    ],
)
def test_why_the_program_failed_is_told(tmp_path: Path, code: str, said: str) -> None:
    with pytest.raises(NotDone, match=said):
        Program(program(tmp_path, code), tmp_path).push()


def test_a_program_that_is_not_there_is_told(tmp_path: Path) -> None:
    with pytest.raises(NotDone, match="set Program"):
        Program(str(tmp_path / "nowhere"), tmp_path).story("")

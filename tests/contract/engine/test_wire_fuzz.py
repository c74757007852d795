"""Both ends of the wire take any line: neither raises, hangs or ends because of what the other one says."""

from __future__ import annotations

import io
import json
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.contract.engine.noise import lines
from tests.contract.engine.small_server import refuse, scale

from storyblender.blender.server import read_lines, serve
from storyblender.engine import wire, worker
from storyblender.engine.wire import Lost, Refused, answer_in, value_in
from storyblender.engine.worker import Worker
from storyblender.errors import EngineError
from storyblender.folder import Folder

CASES = 4000
ODD_SERVER = [sys.executable, "-S", "-E", str(Path(__file__).with_name("odd_server.py"))]
CALL = {"name": "scale", "arguments": {"size": {"width": 2, "height": 3}, "factor": 2}}
REQUESTS: list[dict[str, Any]] = [
    {"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"protocolVersion": "2025-06-18"}},
    {"jsonrpc": "2.0", "method": "notifications/initialized"},
    {"jsonrpc": "2.0", "id": 2, "method": "ping"},
    {"jsonrpc": "2.0", "id": "three", "method": "tools/list", "params": {}},
    {"jsonrpc": "2.0", "id": 4, "method": "tools/call", "params": CALL},
    {"jsonrpc": "2.0", "id": 5, "method": "tools/call", "params": {"name": "refuse", "arguments": {}}},
]
CONTENT = [{"type": "text", "text": "12"}]
ANSWERS: list[dict[str, Any]] = [
    {"jsonrpc": "2.0", "id": 1, "result": {"content": CONTENT, "structuredContent": {"result": 12}, "isError": False}},
    {"jsonrpc": "2.0", "id": 1, "result": {"content": CONTENT, "isError": True}},
    {"jsonrpc": "2.0", "id": 1, "error": {"code": -32602, "message": "no tool"}},
    {"jsonrpc": "2.0", "method": "notifications/message", "params": {"level": "info", "data": "hm"}},
]
LIVE = json.dumps(REQUESTS[4]).encode() + b"\n"


def served(requests: list[bytes]) -> list[dict[str, Any]]:
    out = io.BytesIO()
    serve([scale, refuse], requests, out)
    return [json.loads(line) for line in out.getvalue().splitlines()]


@pytest.fixture(autouse=True)
def quiet(capfd: pytest.CaptureFixture[str]) -> Iterator[None]:
    """What the tools of the small server and their tracebacks print is no report of ours."""
    yield
    capfd.readouterr()


def test_the_server_answers_whatever_comes_and_lives_on() -> None:
    noise = list(lines(seed=11, count=CASES, samples=REQUESTS))
    answers = served([*noise, LIVE])
    assert len(answers) <= CASES + 1
    assert answers[-1]["result"]["structuredContent"] == {"result": {"width": 4.0, "height": 6.0}}
    assert all(("result" in answer) != ("error" in answer) for answer in answers)
    assert any(answer["id"] is None for answer in answers) and any("result" in answer for answer in answers)


@pytest.mark.parametrize(
    ("line", "code"),
    [
        (b"5", -32600), (b"null", -32600), (b"[]", -32600), (b'"ping"', -32600), (b"{" * 200_000, -32700),
        (b'{"id": null, "method": "ping"}', -32600), (b'{"id": [1], "method": "ping"}', -32600),
        (b'{"id": 1, "method": ["ping"]}', -32601), (b'{"id": 1, "method": "ping", "params": [1]}', -32602),
        (b'{"id": 1, "method": "tools/call", "params": {"name": ["scale"]}}', -32602),
        (b'{"id": 1, "method": "tools/call", "params": {"name": "scale", "arguments": [2]}}', -32602),
    ],
)  # fmt: skip
def test_what_is_no_request_is_refused_by_its_code(line: bytes, code: int) -> None:
    refusal, live = served([line + b"\n", LIVE])
    assert refusal["error"]["code"] == code
    assert live["id"] == 4 and "result" in live


def test_a_line_without_end_is_passed_over_and_not_held() -> None:
    stream = io.BytesIO(b"x" * 10_000 + b"\n" + LIVE + b"y" * 5000)
    assert list(read_lines(stream, 1000)) == [b"", LIVE, b""]


def test_the_client_reads_any_line_as_an_answer_a_refusal_or_a_loss() -> None:
    outcomes = {"answer": 0, "refusal": 0, "loss": 0, "other": 0}
    for line in lines(seed=12, count=CASES, samples=ANSWERS):
        try:
            result = answer_in(line, 1)
            outcomes["other" if result is None else "answer"] += 1
            if result is not None:
                value_in(result)
        except Refused as error:
            outcomes["refusal"] += 1
            assert str(error)
        except Lost:
            outcomes["loss"] += 1
    assert min(outcomes.values()) > CASES // 50, outcomes


@pytest.fixture
def odd(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., Worker]]:
    """Make workers on the odd server; lines and waits are short."""
    for module in (wire, worker):
        monkeypatch.setattr(module, "LONGEST", 1 << 20)
    monkeypatch.setattr(worker, "_PARTING", 0.2)
    made: list[Worker] = []

    def make(*arguments: str, attempts: int = 1, timeout: float = 20) -> Worker:
        log = Folder(tmp_path)
        made.append(Worker([*ODD_SERVER, *arguments], log, attempts=attempts, timeout=timeout))
        return made[-1]

    yield make
    for each in made:
        each.close()


def test_the_client_goes_on_after_whatever_a_server_says(odd: Callable[..., Worker]) -> None:
    client = odd(timeout=1)
    for index, line in enumerate(lines(seed=13, count=80, samples=ANSWERS)):
        text = line.decode("latin-1").replace('"id": 1,', '"id": NUMBER,')
        end = (
            json.dumps({"id": -1, "result": {}}) + "\n5\n"
        )  # at the latest here the client has to see that nothing comes
        try:
            client.call("say", {"text": text + end})
        except EngineError as error:
            assert str(error).startswith("say: ")
        if index % 10 == 0:
            try:
                assert client.call("echo", {"word": "here"}) == "here"
            except EngineError:  # what it was still saying came in between; now it is a new one
                assert client.call("echo", {"word": "here"}) == "here"


@pytest.mark.parametrize(
    ("name", "arguments", "words"),
    [
        ("say", {"text": '{"id": NUMBER, "result": '}, "no answer within"),
        ("say_and_end", {"text": '{"id": 2, "res'}, "no message"),
        ("say_and_end", {"text": ""}, "exit 3"),
        ("say", {"text": "\xff\xfe\xfd\n"}, "no message"),
        ("say", {"text": '{"id": NUMBER}\n'}, "without a result"),
        ("say", {"text": '{"id": NUMBER, "result": 5}\n'}, "without a result"),
        ("say", {"text": '{"id": NUMBER, "result": {}}\n'}, "without structured content"),
        ("say", {"text": '{"id": NUMBER, "result": {"isError": true}}\n'}, "failed"),
        ("say", {"text": '{"id": NUMBER, "error": "no"}\n'}, "no"),
        ("say", {"text": '{"id": "NUMBER", "result": {}}\n'}, "no answer within"),
        ("one_long_line", {}, "MiB"),
        ("flood", {}, "no answer within"),
        ("close", {}, "closed its output"),
    ],
)
def test_an_odd_answer_is_an_engine_error_and_the_next_call_is_answered(
    odd: Callable[..., Worker], name: str, arguments: dict[str, str], words: str
) -> None:
    client = odd(timeout=1)
    with pytest.raises(EngineError, match=words):
        client.call(name, arguments)
    assert client.call("echo", {"word": "here"}) == "here"


def test_a_server_that_stopped_reading_does_not_hold_the_client(odd: Callable[..., Worker]) -> None:
    client = odd("deaf", timeout=1)
    with pytest.raises(EngineError, match="no answer within 1 s"):
        client.call("echo", {"word": "x" * 10_000_000})

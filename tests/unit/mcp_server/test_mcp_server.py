"""A session of an agent with the server, in memory, on a stand-in engine."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any, TypeVar

import pytest
from fastmcp import Client
from tests.stage import Stage

from storyblender.mcp_server.server import build_server

T = TypeVar("T")
SHOT = "SC010_SH010"


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Stage:
    return Stage(tmp_path / "tale.storyboard", monkeypatch)


def talk(folder: Path, say: Callable[[Client[Any]], Awaitable[T]]) -> T:
    """Run a conversation with a server for a folder, and close its project."""

    async def run() -> T:
        server, place = build_server(folder)
        try:
            async with Client(server) as client:
                return await say(client)
        finally:
            place.close()

    return asyncio.run(run())


def called(folder: Path, *calls: tuple[str, dict[str, Any]]) -> list[dict[str, Any]]:
    """Call tools one after the other and return what they answered; errors as their sentence."""

    async def say(client: Client[Any]) -> list[dict[str, Any]]:
        answers = []
        for name, arguments in calls:
            answer = await client.call_tool(name, arguments, raise_on_error=False)
            if answer.is_error:
                answers.append({"error": getattr(answer.content[0], "text", "")})
            else:
                answers.append(answer.structured_content or {"content": answer.content})
        return answers

    return talk(folder, say)


OPEN = ("open_project", {"project": "tale.storyboard"})


def described(schema: dict[str, Any], where: str) -> list[str]:
    """Return every field of a JSON schema that says nothing about itself."""
    silent = []
    for name, field in schema.get("properties", {}).items():
        if not {"description", "$ref"} & field.keys():
            silent.append(f"{where}.{name}")
        silent += described(field, f"{where}.{name}") + described(field.get("items", {}), f"{where}.{name}")
    for name, inner in schema.get("$defs", {}).items():
        silent += described(inner, name)
    return silent


def test_every_tool_says_what_it_does_takes_and_returns(tmp_path: Path) -> None:
    tools = talk(tmp_path, lambda client: client.list_tools())
    assert {"make", "status", "describe_shot", "look", "edit", "undo", "check", "render", "export"} <= {
        tool.name for tool in tools
    }
    for tool in tools:
        assert tool.description and tool.annotations is not None, tool.name
        assert not described(tool.input_schema, tool.name)
        returned = tool.output_schema
        assert tool.name in ("look", "list_projects") or (returned and not described(returned, tool.name)), tool.name


def test_a_shot_is_looked_at_edited_and_put_back(stage: Stage) -> None:
    stage.render()
    story, before, seen, done, after, undone, again = called(
        stage.folder.parent,
        OPEN,
        ("describe_shot", {"shot": SHOT}),
        ("look", {"shot": SHOT, "width": 100}),
        ("edit", {"edits": [{"kind": "camera", "shot": SHOT, "decision": {"size": "ECU"}}]}),
        ("describe_shot", {"shot": SHOT}),
        ("undo", {}),
        ("describe_shot", {"shot": SHOT}),
    )
    assert [shot["shot"] for shot in story["shots"]] == ["SC010_SH010", "SC010_SH020", "SC020_SH010"]
    assert seen["content"][0].type == "image"
    assert before["size"] != "ECU" and after["size"] == "ECU" and after["decided"] == ["size ECU"]
    assert done["redrawn"] == [SHOT] and "size ECU" in done["done"]
    assert again["size"] == before["size"] and undone["revision"] == story["revision"]


def test_an_edit_on_an_older_revision_is_refused_with_what_changed(stage: Stage) -> None:
    size = {"kind": "camera", "shot": SHOT, "decision": {"size": "CU"}}
    story, _, refused = called(
        stage.folder.parent, OPEN, ("edit", {"edits": [size], "draw": False}),
        ("edit", {"edits": [size], "revision": "1", "draw": False}),
    )  # fmt: skip
    assert story["revision"]
    assert "changed since" in refused["error"]


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (("open_project", {"project": "../elsewhere"}), "leaves the project folder"),
        (("open_project", {"project": "/etc"}), "leaves the project folder"),
        (("make", {"script": "../x.fountain", "text": "INT. BAR"}), "leaves the project folder"),
        (("make", {"script": "x.py", "text": "print()"}), "no name of a script"),
        (("make", {"script": "none.fountain"}), "none.fountain"),
        (("look", {"shot": SHOT}), "no project is open"),
        (("undo", {}), "no project is open"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(
    tmp_path: Path, call: tuple[str, dict[str, Any]], sentence: str
) -> None:
    [refused] = called(tmp_path, call)
    assert sentence in refused["error"]
    assert not [path for path in tmp_path.rglob("*") if path.is_file()]


def test_a_shot_or_an_edit_that_is_not_there_is_refused(stage: Stage) -> None:
    _, shot, size = called(
        stage.folder.parent, OPEN, ("describe_shot", {"shot": "SC990_SH010"}),
        ("edit", {"edits": [{"kind": "camera", "shot": SHOT, "decision": {"size": "HUGE"}}]}),
    )  # fmt: skip
    assert "there is no shot" in shot["error"]
    assert "size" in size["error"]


def test_a_script_becomes_a_storyboard_while_the_agent_asks_how_far_it_is(stage: Stage, tmp_path: Path) -> None:
    text = "INT. BAR - NIGHT\n\nANNA sits at a table. She waves.\n\nANNA\nHello.\n"
    began, *_, ended, told, busy = called(
        tmp_path,
        ("make", {"script": "new.fountain", "text": text, "look": "fast", "width": 160}),
        ("status", {"wait_seconds": 50}),
        ("status", {"wait_seconds": 50}),
        ("story", {}),
        ("make", {"script": "new.fountain", "text": "other words"}),
    )
    assert began["work"] == "make new.fountain"
    assert (ended["busy"], ended["error"]) == (False, "")
    assert told["made"] and "anna" in told["cast"]
    assert "already" in busy["error"], "a script is never overwritten"


def test_an_edit_is_in_the_graph_at_once_and_its_frame_is_judged(stage: Stage) -> None:
    stage.render()

    async def say(client: Client[Any]) -> tuple[dict[str, Any], dict[str, Any], dict[str, Any]]:
        await client.call_tool(*OPEN)
        edit = {"kind": "camera", "shot": SHOT, "decision": {"size": "ECU", "lens": 111}}
        edited = (await client.call_tool("edit", {"edits": [edit]})).structured_content or {}
        graph, words = [
            json.loads((await client.read_resource(f"storyblender://{name}"))[0].text)  # type: ignore[union-attr]
            for name in ("graph", "vocabulary")
        ]
        return edited, graph, words

    edited, graph, words = talk(stage.folder.parent, say)
    instruction = graph["shots"][0]["camera_instruction"]
    assert instruction["size"] == "ECU" and instruction["lens"] == 111
    [frame] = edited["frames"]
    assert frame["shot"] == SHOT and frame["verdict"] in ("pass", "fix", "reject")
    assert bool(frame["faults"]) == (frame["score"] < 10)
    assert instruction["size"] in words["camera"]["size"]


def test_the_graph_is_a_resource_and_a_missing_board_is_said(stage: Stage) -> None:
    async def say(client: Client[Any]) -> tuple[Any, str]:
        await client.call_tool(*OPEN)
        [graph] = await client.read_resource("storyblender://graph")
        try:
            await client.read_resource("storyblender://board")
        except Exception as error:  # noqa: BLE001 - whatever the client makes of the refusal
            return graph, str(error)
        return graph, ""

    graph, refused = talk(stage.folder.parent, say)
    assert json.loads(graph.text)["shots"]
    assert refused

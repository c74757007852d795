"""``doctor --crew`` asks every model of a crew once, and says how it answers."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from storyblender.cli import app
from storyblender.doctor import examine_crew
from tests.wire.loopback import Act, Fail, Say, serving
from tests.wire.wires import SERVICES

GOOD, BLIND = Say('{"number": 3}'), Say('{"number": 3, "color": "none"}')
TEAL, ORANGE = Say('{"number": 3, "color": "Teal"}'), Say('{"number": 3, "color": "orange"}')


@pytest.mark.parametrize("name", SERVICES)
@pytest.mark.parametrize(
    ("acts", "healthy", "says"),
    [
        ([GOOD, TEAL, ORANGE], True, r"^answers in the (native|tool) form, [\d.]+ s, \d+ tokens, sees pictures$"),
        ([GOOD, TEAL], True, "does not see pictures"),
        ([GOOD, Fail(400, "no pictures here")], True, "does not see pictures"),
        ([Fail(400, "no", ("native", "tool")), GOOD], True, "in the prompted form"),
        ([Fail(401, "who are you")], False, r"^it does not accept the key \(401 who are you\)$"),
        ([Say("hello")], False, "no answer of the right form"),
    ],
    ids=["sees", "guesses", "pictures refused", "prompted", "no key", "no JSON"],
)
def test_each_model_is_asked(name: str, acts: list[Act], healthy: bool, says: str) -> None:
    import re

    service = SERVICES[name]
    with serving(service.wire, *acts) as server:
        setting = f"{service.provider}:{service.model}@{server.address}{service.path}"
        (finding,) = examine_crew(setting)
    assert finding.healthy == healthy and re.search(says, finding.says), finding


def test_one_that_cannot_answer_ends_the_command_with_1(tmp_path: Path) -> None:
    service, codes = SERVICES["ollama"], list[int]()
    for acts in ([GOOD], [Fail(401, "no")]):
        with serving(service.wire, *acts) as server:
            crew = f"rules,director=ollama:qwen3@{server.address}/v1,animator=ask:{tmp_path}"
            done = CliRunner().invoke(app, ["doctor", "--crew", crew, "--json"])
        codes.append(done.exit_code)
        found = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
        assert {each["name"] for each in found} == {"rules", "ollama:qwen3", f"ask:{tmp_path}"}
    assert codes == [0, 1]


def test_a_recording_that_is_not_there_is_said(tmp_path: Path) -> None:
    assert [finding.healthy for finding in examine_crew(f"replay:{tmp_path}")] == [True]
    assert [finding.healthy for finding in examine_crew(f"replay:{tmp_path / 'nowhere'}")] == [False]

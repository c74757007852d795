"""Who answers, and what is said where models cannot be asked."""

from __future__ import annotations

import sys
from pathlib import Path
from threading import Event

import pytest
from typer.testing import CliRunner

from storyblender.cli import app
from storyblender.language.answerers import answerers
from storyblender.reflection import silent

EXTRA = ("storyblender.language.provider", "storyblender.language.model_api")


@pytest.fixture
def bare(monkeypatch: pytest.MonkeyPatch) -> None:
    """Take the extra ``crew`` away."""
    for name in EXTRA:
        monkeypatch.delitem(sys.modules, name, raising=False)
    for name in ("pydantic_ai", "tenacity"):
        monkeypatch.setitem(sys.modules, name, None)


@pytest.mark.parametrize("command", [["plan", "{script}"], ["doctor"]], ids=" ".join)
def test_a_missing_extra_is_one_sentence_with_what_to_run(command: list[str], tmp_path: Path, bare: None) -> None:
    script = tmp_path / "room.fountain"
    script.write_text("INT. ROOM - DAY\n\nANNA sits.\n")
    words = [word.format(script=script) for word in command]
    done = CliRunner().invoke(app, [*words, "--crew", "ollama:qwen3"])
    assert done.exit_code == 2
    assert done.stderr.count("\n") == 1
    assert "run `make crew`" in done.stderr and 'pip install "storyblender[crew]"' in done.stderr


def test_rules_folders_and_recordings_need_no_extra(tmp_path: Path, bare: None) -> None:
    crew = f"rules,director=ask:{tmp_path / 'a'},animator=ask:{tmp_path / 'a'},set_dresser=replay:{tmp_path / 'b'}"
    by_role = answerers(crew, tmp_path, {}, Event(), silent)
    assert set(by_role) == {"director", "animator", "set_dresser"}
    assert by_role["director"] is by_role["animator"], "one player answers for all its roles"

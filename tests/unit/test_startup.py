"""Whoever uses no language model does not wait for what models need."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

CREW = {"anthropic", "google", "httpx2", "keyring", "openai", "opentelemetry", "pydantic_ai", "tenacity"}
"""Packages of the extras ``crew`` and ``services``."""
MAKE = """
import sys
from storyblender import studio
from storyblender.cli import app
from tests.stand_in_engine import StandInEngine
studio.BlenderEngine = StandInEngine
app(["make", *sys.argv[1:], "--quiet", "--no-animatic", "--width", "160", "--look", "fast"])
"""


def loaded(*words: str) -> set[str]:
    """Return the top packages that a Python process imports."""
    command = [sys.executable, "-X", "importtime", *words]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    lines = [line for line in done.stderr.splitlines() if line.startswith("import time:")]
    return {line.rpartition("|")[2].strip().partition(".")[0] for line in lines}


def test_help_loads_nothing_of_the_crew() -> None:
    packages = loaded("-m", "storyblender", "--help")
    assert "typer" in packages and not packages & {*CREW, "sqlite3"}


@pytest.mark.parametrize("crew", [(), ("--crew", "rules")], ids=["none named", "rules"])
def test_a_crew_of_rules_makes_a_board_without_what_models_need(crew: tuple[str, ...], tmp_path: Path) -> None:
    script = tmp_path / "room.fountain"
    script.write_text("INT. ROOM - DAY\n\nANNA sits at the table.\n")
    packages = loaded("-c", MAKE, str(script), *crew)
    assert (tmp_path / "room.storyboard" / "index.html").is_file()
    assert "pydantic" in packages and not packages & CREW

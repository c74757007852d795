"""A dry run says what would be fetched and made and what it costs, and does neither."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from typer.testing import CliRunner

from storyblender.cli import app
from tests.services.story_with_services import EXPECTED, SCRIPT, downloads, key_of, open_sites, services_of


@pytest.fixture
def script(tmp_path: Path) -> Path:
    path = tmp_path / "study.fountain"
    path.write_text(SCRIPT.replace("A guitar", "A samovar stands by the window. A guitar"))
    return path


def test_what_would_be_fetched_and_made_is_said_with_its_price(script: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with open_sites() as sites:
        for name, value in {**key_of(sites[1]), "OPENAI_API_KEY": "one", "MESHY_API_KEY": "two"}.items():
            monkeypatch.setenv(name, value)
        words = ["make", str(script), "--services", f"{services_of(*sites)},openai,meshy", "--dry-run"]
        told = CliRunner().invoke(app, [*words, "--json"])
        assert told.exit_code == 0, told.output
        plan = json.loads(told.output.splitlines()[-1])
        assert not downloads(*sites)
        shown = CliRunner().invoke(app, words).output
    by_name = {each["name"]: each for each in plan["expected"]}
    assert {name for name, each in by_name.items() if each["how"] == "fetched"} == {*EXPECTED}
    chair, samovar, guitar = (by_name[name] for name in ("armchair", "samovar", "guitar"))
    assert (chair["source"], chair["licence"]) == ("poly_haven", "CC0-1.0") and chair["megabytes"] > 0
    assert guitar["url"].startswith("https://sketchfab.com/") and guitar["licence"] == "CC-BY-4.0"
    assert samovar["how"] == "made" and samovar["dollars"] > 0 and plan["dollars"] == samovar["dollars"]
    assert by_name["desk"]["how"] == "here"
    assert "Powered by Poly Haven" in shown and f"${plan['dollars']:.2f}" in shown and "samovar" in shown
    assert list(script.parent.iterdir()) == [script], "there is no project"
    library = Path(os.environ["STORYBLENDER_LIBRARY"])
    assert {path.name for path in library.iterdir()} <= {"answers"}, "only what catalogues answered is kept"


def test_nothing_is_made_where_a_key_is_missing(script: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("keyring.get_password", lambda *_: None)
    for name in ("OPENAI_API_KEY", "MESHY_API_KEY"):
        monkeypatch.delenv(name, raising=False)
    told = CliRunner().invoke(app, ["make", str(script), "--services", "openai,meshy", "--dry-run"])
    assert told.exit_code == 0 and "$0.00" in told.output and "there is no key for openai" in told.output

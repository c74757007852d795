"""A dry run says what would be fetched and made and what it costs, and does neither."""

from __future__ import annotations

import json
import os
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from storyblender.cli import app
from storyblender.keys import TENCENT_KEYS
from storyblender.library.sources import service_run
from storyblender.services.register import ServiceRun
from tests.services.site import QUICK
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


def test_what_stands_in_and_what_is_yours_is_told(script: Path, tmp_path: Path) -> None:
    models = tmp_path / "models"
    (models / "cast").mkdir(parents=True)
    for name in ("desk.glb", "cast/ada.glb"):
        (models / name).write_bytes(b"not opened")
    words = ["make", str(script), "--models", str(models), "--dry-run"]
    told, shown = (CliRunner().invoke(app, [*words, *more]).stdout for more in (["--json"], []))
    by_name = {each["name"]: each for each in json.loads(told.splitlines()[-1])["expected"]}
    assert by_name["samovar"]["stands_in"] and "stands_in" not in by_name["guitar"]
    assert {name: each["what"] for name, each in by_name.items() if each["source"] == "models"} == {
        "Ada": "cast/ada.glb",
        "desk": "desk.glb",
    }
    rows = {words[0]: " ".join(words[1:]) for line in shown.splitlines() if (words := line.split())}
    assert rows["samovar"].endswith(", standing in") and rows["samovar"].startswith("on this machine built in ")
    assert rows["desk"] == "on this machine your folder desk.glb"


@pytest.fixture
def _no_keys(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("keyring.get_password", lambda *_: None)
    for name in ("GOOGLE_API_KEY", "OPENAI_API_KEY", "MESHY_API_KEY", *TENCENT_KEYS):
        monkeypatch.delenv(name, raising=False)


def dry_run(script: Path, services: str) -> tuple[dict[str, Any], str]:
    """Return what a dry run tells a machine, and the last line that a person reads."""
    words = ["make", str(script), "--services", services, "--dry-run"]
    told, shown = (CliRunner().invoke(app, [*words, *more]) for more in (["--json"], []))
    assert told.exit_code == shown.exit_code == 0, told.output
    return json.loads(told.stdout.splitlines()[-1]), shown.stdout.splitlines()[-1]


@pytest.mark.usefixtures("_no_keys")
def test_the_price_is_told_without_keys_and_who_lacks_one(script: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    told, last = dry_run(script, "openai,hunyuan3d,meshy")
    (samovar,) = (each for each in told["expected"] if each["name"] == "samovar")
    assert samovar["how"] == "made" and samovar["dollars"] == pytest.approx(0.442)
    assert [each["service"] for each in told["not_asked"]] == ["openai", "hunyuan3d", "meshy"]
    assert told["most_dollars"] == 5 and "$5.00" in last
    for words in ("openai (there is no key", "OPENAI_API_KEY", "hunyuan3d (", "meshy (", "$0.44"):
        assert words in last
    monkeypatch.setenv("MESHY_API_KEY", "two")
    told, last = dry_run(script, "openai,hunyuan3d,meshy")
    assert told["dollars"] == pytest.approx(0.642), "the service that has its key would be asked"
    assert "meshy (" not in last


@pytest.mark.usefixtures("_no_keys")
def test_a_server_without_an_address_is_named_and_nothing_is_made(script: Path) -> None:
    told, last = dry_run(script, "openai,trellis")
    assert told["dollars"] == 0 and "trellis@http://" in last


def test_a_catalogue_that_cannot_be_reached_is_named_last(script: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def quick(*given: Any) -> ServiceRun | None:
        made = service_run(*given)
        return None if made is None else replace(made, patience=QUICK)

    monkeypatch.setattr("storyblender.studio.service_run", quick)
    told, last = dry_run(script, "poly_haven@http://127.0.0.1:9")
    assert [each["service"] for each in told["not_asked"]] == ["poly_haven"]
    assert "poly_haven (it cannot be reached; this list is without it)" in last

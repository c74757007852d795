"""A reading written to a file and read back gives the same storyboard; what cannot be used is refused in a sentence."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import Any

import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.reader.reader import read_script
from storyblender.agents.director.reading import CameraNote, Deed, Person, SceneReading, StateChange, Thing, Unit
from storyblender.agents.director.reading_file import read_reading, write_reading
from storyblender.errors import InputError
from storyblender.screenplay.model import Screenplay
from storyblender.screenplay.source import load

ROOT = Path(__file__).parents[4]
EXAMPLES = sorted(path for path in (ROOT / "examples").iterdir() if path.suffix in (".fountain", ".txt", ".fdx"))


@pytest.fixture(scope="module")
def screenplay() -> Screenplay:
    return load(ROOT / "examples" / "two_hander.fountain")


@pytest.fixture
def plain(screenplay: Screenplay) -> dict[str, Any]:
    return json.loads(write_reading(read_script(screenplay)))


def read(plain: dict[str, Any], screenplay: Screenplay, folder: Path) -> Any:
    path = folder / "reading.json"
    path.write_text(json.dumps(plain), encoding="utf-8")
    return read_reading(path, screenplay)


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_a_reading_comes_back_as_it_was(example: Path, tmp_path: Path) -> None:
    screenplay = load(example)
    path = tmp_path / "reading.json"
    path.write_text(write_reading(read_script(screenplay)), encoding="utf-8")
    assert storyboard(read_reading(path, screenplay)) == storyboard(read_script(screenplay))


def test_a_correction_reaches_the_storyboard(plain: dict[str, Any], screenplay: Screenplay, tmp_path: Path) -> None:
    person = plain["people"][0]
    person["outfit"] = ["a yellow raincoat"]
    board = storyboard(read(plain, screenplay, tmp_path))
    look = next(asset.look for asset in board.asset_sheet if asset.asset_id == person["id"])
    before = storyboard(read_script(screenplay))
    assert look != next(asset.look for asset in before.asset_sheet if asset.asset_id == person["id"])


def _unit_with(plain: dict[str, Any], key: str) -> dict[str, Any]:
    return next(each["unit"] for each in plain["units"] if each["unit"].get(key))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda plain: plain["people"][0].update(hare=["red"]), "people 1, hare"),
        (lambda plain: plain["people"][0].update(gender="lady"), "people 1, gender"),
        (lambda plain: plain["people"][0].update(id="../up"), "not a valid id"),
        (lambda plain: plain["people"].append(dict(plain["people"][0])), "given twice"),
        (lambda plain: _unit_with(plain, "on_stage")["on_stage"].append("nobody"), "there is no person of that id"),
        (lambda plain: _unit_with(plain, "deeds")["deeds"][0].update(actor="nobody"), "there is no person of that id"),
        (lambda plain: _unit_with(plain, "deeds")["deeds"][0].update(motion="strolls"), "no motion of that id"),
        (lambda plain: _unit_with(plain, "deeds")["deeds"][0].update(motion="digging"), "nearest motion is 'dig'"),
        (lambda plain: plain["units"][1]["unit"].update(text="Something else entirely."), "unit 2 .*own words"),
        (lambda plain: plain["units"][1].update(number=7), "unit 2 has the number 7"),
        (lambda plain: plain["units"][1]["unit"].update(scene=99), "unit 2 is in scene 99"),
        (lambda plain: plain["units"][1]["unit"].update(end=10**9), "unit 2 covers the characters"),
        (lambda plain: plain["scenes"][0]["scene"].update(kit="nowhere"), "scene 0 has the set kit 'nowhere'"),
        (
            lambda plain: plain["scenes"][0]["scene"].update(kit="beach", set_options=["log"]),
            "'beach': palms, lighthouse",
        ),
        (lambda plain: plain["scenes"][0]["scene"].update(set_options=["palms"]), "the kit '': none"),
        (lambda plain: plain["scenes"][0]["scene"].update(crowd="many"), "scene 1, crowd.*'none', 'busy' or 'full'"),
        (lambda plain: plain.update(script="0" * 16), "another script"),
        (lambda plain: plain.update(reading_version=99), "reading_version"),
    ],
)
def test_what_cannot_be_used_is_refused(
    plain: dict[str, Any],
    screenplay: Screenplay,
    tmp_path: Path,
    change: Callable[[dict[str, Any]], None],
    words: str,
) -> None:
    change(plain)
    with pytest.raises(InputError, match=words):
        read(plain, screenplay, tmp_path)


@pytest.mark.parametrize("content", ["", "{", "[]", "null", "[" * 100_000])
def test_what_is_no_reading_is_refused(content: str, screenplay: Screenplay, tmp_path: Path) -> None:
    path = tmp_path / "reading.json"
    path.write_text(content, encoding="utf-8")
    with pytest.raises(InputError, match=r"reading-file\.md"):
        read_reading(path, screenplay)


def test_every_field_is_documented() -> None:
    page = (ROOT / "docs" / "reading-file.md").read_text(encoding="utf-8")
    kinds = (Person, Thing, Deed, CameraNote, StateChange, Unit, SceneReading)
    assert not [
        f"{kind.__name__}.{each.name}" for kind in kinds for each in fields(kind) if f"`{each.name}`" not in page
    ]


def test_a_file_of_version_1_has_its_panels_as_pictures(
    plain: dict[str, Any], screenplay: Screenplay, tmp_path: Path
) -> None:
    for each in plain["units"]:
        each["unit"] |= {"panel": each["number"] // 3, "picture": 99}
    with pytest.raises(InputError, match="panel"):
        read(plain, screenplay, tmp_path)
    plain["reading_version"] = 1
    units = read(plain, screenplay, tmp_path).units
    assert [unit.picture for unit in units] == [number // 3 for number in range(1, len(units) + 1)]

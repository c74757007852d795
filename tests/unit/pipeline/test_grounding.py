"""A corrected reading is planned from, kept in the project and used again, and never lost in silence."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from storyblender.errors import InputError
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.project import Project
from storyblender.settings import Settings
from storyblender.studio import Studio
from storyblender.trace import Event

WORDS = """INT. KITCHEN - DAY

ADA (60, grey hair) sits at the table with a cup.

ADA
You came back.
"""


class Desk:
    """A script, its project, and what was said while it was planned."""

    def __init__(self, folder: Path) -> None:
        self.script, self.folder, self.reading = folder / "a.fountain", folder / "p", folder / "reading.json"
        self.script.write_text(WORDS, encoding="utf-8")
        self.told: list[Event] = []

    def plan(self, reading: Path | None = None, export: Path | None = None) -> ContinuityMemoryGraph:
        return Studio(Settings(), self.told.append).plan(self.script, self.folder, reading, export).graph

    @property
    def reasons(self) -> list[str]:
        """Why the Director committed, in order."""
        with Project(self.folder) as project:
            return [commit.reason for commit in project.log() if commit.author == "director"]

    def undo(self) -> None:
        Studio(Settings(), self.told.append).undo(self.folder)

    def corrected(self) -> Path:
        """Ada is a young woman with red hair: not what the script says, so that it can only come from the file."""
        self.plan(export=self.reading)
        plain: dict[str, Any] = json.loads(self.reading.read_text(encoding="utf-8"))
        plain["people"][0].update(age="20", hair=["red hair"])
        self.reading.write_text(json.dumps(plain), encoding="utf-8")
        return self.reading


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    return Desk(tmp_path)


def hair(graph: ContinuityMemoryGraph) -> object:
    look = next(asset.look for asset in graph.assets if asset.asset_id == "ada")
    assert look is not None
    return look.hair_color


def test_a_half_made_project_without_kits_is_read_again(desk: Desk) -> None:
    planned = desk.plan()
    scene = planned.scenes[0]
    with Project(desk.folder) as project:
        plain = scene.model_copy(update={"setup": scene.setup.model_copy(update={"kit": ""})})
        project.commit(replace(planned, plain), "user", "as in schema 5, which chose kits later")
    assert desk.plan().scenes[0].setup.kit == scene.setup.kit == "kitchen"
    assert desk.reasons == ["plans a.fountain"] * 2
    desk.plan()
    assert desk.reasons == ["plans a.fountain"] * 2, "with its kits decided it is not read again"


def test_a_written_reading_gives_the_same_plan(desk: Desk) -> None:
    plain = desk.plan(export=desk.reading)
    again = desk.plan(reading=desk.reading)
    assert again.model_copy(update={"plan_digest": plain.plan_digest}) == plain


def test_a_correction_is_planned_from_and_used_again(desk: Desk) -> None:
    before = hair(desk.plan())
    corrected = desk.plan(reading=desk.corrected())
    assert hair(corrected) != before
    desk.reading.unlink()
    assert desk.plan() == corrected, "the project keeps the corrected reading"


def test_a_correction_of_other_words_is_set_aside_and_said(desk: Desk) -> None:
    desk.plan(reading=desk.corrected())
    desk.script.write_text(WORDS.replace("a cup", "a glass"), encoding="utf-8")
    desk.plan()
    warnings = [event for event in desk.told if event.kind == "warning"]
    assert any("other words" in event.message for event in warnings)
    assert (desk.folder / "reading.json").exists(), "what a person corrected stays on disk"


def test_undo_takes_a_corrected_reading_back(desk: Desk) -> None:
    plain, first = desk.plan(), desk.corrected()
    second = desk.reading.with_name("second.json")
    second.write_text(first.read_text(encoding="utf-8").replace("red hair", "white hair"), encoding="utf-8")
    red = desk.plan(reading=first)
    desk.undo()
    assert desk.plan() == plain, "the correction is not applied again"
    assert hair(desk.plan(reading=first)) == hair(red) != hair(desk.plan(reading=second))
    desk.undo()
    desk.plan(reading=first)
    assert hair(desk.plan()) == hair(red), "the reading that the project was made with last"


def test_what_a_person_wrote_into_the_projects_copies_is_kept_aside(desk: Desk) -> None:
    desk.plan()
    (desk.folder / "script.fountain").write_text("my own words", encoding="utf-8")
    desk.script.write_text(WORDS.replace("a cup", "a glass"), encoding="utf-8")
    desk.plan()
    copies = [
        path for path in desk.folder.glob("script *.fountain") if path.read_text(encoding="utf-8") == "my own words"
    ]
    assert len(copies) == 1
    assert any("script.fountain" in event.subject for event in desk.told if event.kind == "warning")


def test_a_file_that_is_there_is_not_overwritten(desk: Desk) -> None:
    written = desk.corrected().read_bytes()
    with pytest.raises(InputError, match="there already"):
        desk.plan(export=desk.reading)
    assert desk.reading.read_bytes() == written


def test_a_reading_that_cannot_be_used_changes_nothing(desk: Desk) -> None:
    before = desk.plan()
    desk.reading.write_text("{}", encoding="utf-8")
    with pytest.raises(InputError, match=r"reading-file\.md"):
        desk.plan(reading=desk.reading)
    assert desk.plan() == before and not (desk.folder / "reading.json").exists()

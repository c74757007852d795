"""The extension on a real story: alone by the command line, and with a real studio; what is done is in the project."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import bpy
import pytest

from storyblender.memory.base import shot_name
from storyblender.project import read_project_graph
from storyblender.web_studio.address_file import ADDRESS_FILE
from tests.blender.extension_stage import PACKAGE, drawn, installed, panel_state, part, settle
from tests.e2e.conftest import SCRIPT, SMALL, made

pytestmark = [pytest.mark.blender, pytest.mark.slow]


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A story, with the extension in Blender."""
    folder = tmp_path_factory.mktemp("directed")
    (folder / "two_cups.fountain").write_text(SCRIPT, encoding="utf-8")
    made([folder / "two_cups.fountain", "--out", folder / "two_cups.storyboard", "--no-animatic", *SMALL])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with installed(folder):
        preferences = bpy.context.preferences.addons[PACKAGE].preferences
        preferences.program = str(Path(sys.executable).with_name("storyblender"))
        yield folder / "two_cups.storyboard"


@pytest.fixture
def studio(project: Path) -> Iterator[subprocess.Popen[bytes]]:
    command = [sys.executable, "-m", "storyblender", "studio", str(project), "--no-browser"]
    process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    while not (project / ADDRESS_FILE).exists():
        assert process.poll() is None
        time.sleep(0.1)
    yield process
    process.terminate()
    process.wait(60)


def opened(project: Path) -> Any:
    """Open the story's file, and return what the extension knows of the story."""
    bpy.ops.wm.open_mainfile(filepath=str(project / "story.blend"), load_ui=False, use_scripts=False)
    settle()
    story = part("story").STORY
    assert not story.problem
    return story


def a_thing() -> Any:
    scene = bpy.data.scenes["SC010"]
    things = [obj for obj in scene.objects if str(obj.get("node_id")).startswith("set_") and obj.get("kind") == "prop"]
    return min(things, key=lambda obj: obj.name)


def first_shot(project: Path) -> Any:
    return read_project_graph(project).shots[0]


def directed(project: Path, link: str) -> None:
    """Write a note, lock the camera and keep a take through the panel; then take all of it back."""
    story, before = opened(project), read_project_graph(project)
    assert story.link == link
    assert [row.name for row in panel_state().shots] == [shot_name(s.scene_id, s.shot_id) for s in before.shots]
    assert {story.card(row.name)["state"] for row in panel_state().shots} == {"fresh"}
    panel_state().note = "Slower here."
    bpy.ops.storyblender.add_note()
    settle()
    bpy.ops.storyblender.lock(part="duration")
    settle()
    assert [note.text for note in first_shot(project).notes] == ["Slower here."]
    assert first_shot(project).locked == ("duration",)
    assert "Slower here." in drawn() and "LOCKED Duration" in drawn()
    bpy.ops.storyblender.lock(part="duration")
    bpy.ops.storyblender.take(action="keep")
    settle()
    assert len(story.details(panel_state().chosen)["takes"]) == 2 and not first_shot(project).locked
    for _ in range(4):
        bpy.ops.storyblender.undo_story()
        settle()
    assert read_project_graph(project) == before and not story.problem


def taken_over(project: Path) -> None:
    """Move a thing in Blender and pull: it stands there in the story, and in the file that is written anew."""
    story = opened(project)
    name, there = a_thing().name, a_thing().location.x + 0.3
    a_thing().location.x = there
    bpy.ops.storyblender.pull()
    settle()
    assert len(story.told) == 1 and story.told[0].startswith("Taken over: "), (story.told, story.problem)
    assert story.is_rewritten
    bpy.ops.storyblender.reload()
    settle()
    assert abs(bpy.data.scenes["SC010"].objects[name].location.x - there) < 0.002 and not story.is_rewritten
    bpy.ops.storyblender.pull()
    settle()
    assert story.told == ["Nothing was changed here."], "what was taken over is no change any more"


def test_alone_what_is_done_in_the_panel_arrives_in_the_story(project: Path) -> None:
    directed(project, "alone")


def test_alone_a_thing_that_was_moved_is_taken_over(project: Path) -> None:
    taken_over(project)


def test_alone_the_frame_of_a_shot_is_drawn_with_what_was_changed(project: Path) -> None:
    story = opened(project)
    picture = story.picture(panel_state().chosen)
    before = picture.read_bytes()
    bpy.data.objects[panel_state().chosen].data.lens *= 1.5
    bpy.ops.storyblender.draw_frame()
    settle()
    assert picture.read_bytes() != before and story.told[0].startswith("Taken over: ")
    assert story.is_rewritten, "Blender without a window counts as changed, so it is not opened by itself"
    assert str(picture) in {image.filepath for image in bpy.data.images}


def test_with_a_studio_the_same_is_done_over_its_wire(project: Path, studio: subprocess.Popen[bytes]) -> None:
    directed(project, "studio")
    taken_over(project)


def test_a_wrong_key_is_told_and_a_killed_studio_is_gone_on_without(
    project: Path, studio: subprocess.Popen[bytes]
) -> None:
    story, file = opened(project), project / ADDRESS_FILE
    right = file.read_text()
    file.write_text(json.dumps(json.loads(right) | {"key": "guessed"}))
    bpy.ops.storyblender.refresh()
    settle()
    assert "refused the key" in story.problem and "refused the key" in drawn()
    file.write_text(right)
    studio.kill()
    studio.wait()
    bpy.ops.storyblender.refresh()
    settle()
    assert story.link == "alone" and not story.problem

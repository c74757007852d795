"""The extension in Blender: installed, switched off and on; shots are gone to, edits asked for, refusals told."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import bpy
import pytest
from tests.blender.extension_stage import PACKAGE, Layout, drawn, installed, panel_state, part, settle

pytestmark = pytest.mark.blender

SHOTS = {"SC010": {"SC010_SH010": 1, "SC010_SH020": 25}, "SC020": {"SC020_SH010": 1}}


class Program:
    """Stands in for the studio: keeps what it is asked, and tells the story that it is given."""

    words = "studio"

    def __init__(self) -> None:
        self.asked: list[Any] = []
        self.refuses = ""
        self.changes: list[str] = []

    def story(self, seen: str) -> dict[str, Any]:
        names = [name for scene in SHOTS.values() for name in scene]
        card = {
            "state": "stale",
            "omitted": False,
            "approved": True,
            "locked": True,
            "notes": 1,
            "takes": 2,
            "problems": 1,
        }
        note = {"number": 1, "text": "Slower here, and stay on her hands.", "author": "Ilsa", "resolved": False}
        takes = [{"number": number, "in_film": number == 2, "camera": "CU single", "decided": []} for number in (1, 2)]
        shot = {
            "camera": "CU · 85 mm", "seconds": 2.0, "lines": [{"text": "Well.", "speaker": "anna"}], "notes": [note],
            "problems": ["Anna's face is hidden"], "locked": ["camera"], "takes": takes,
        }  # fmt: skip
        scene = {"shots": [{"shot": name, **card} for name in names]}
        board = {"revision": "7.abc", "undo": "SC010_SH010: size CU", "scenes": [scene]}
        return {"board": board, "shots": [{"shot": name, **shot} for name in names]}

    def edit(self, edits: Any, revision: str) -> None:
        if self.refuses:
            raise part("connection").NotDone(self.refuses)
        self.asked.append((edits, revision))

    def undo(self) -> None:
        self.asked.append("undo")

    def pull(self) -> dict[str, Any]:
        self.asked.append("pull")
        return {"understood": self.changes, "conflicts": [], "kept": ["the strip was moved"]}

    def draw(self, shot: str) -> None:
        self.asked.append(f"draw {shot}")

    def push(self) -> None:
        self.asked.append("push")


@pytest.fixture(scope="module", autouse=True)
def extension(empty_blender: None, tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    with installed(tmp_path_factory.mktemp("extension")):
        yield


@pytest.fixture(scope="module")
def story(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project with a file like a compiled one."""
    folder = tmp_path_factory.mktemp("made") / "tale.storyboard"
    folder.mkdir()
    (folder / "graph.json").write_text("{}")
    for number, (name, shots) in enumerate(SHOTS.items(), start=1):
        scene = bpy.data.scenes.new(name)
        scene["scene_id"] = number
        for shot, frame in shots.items():
            camera = bpy.data.objects.new(shot, bpy.data.cameras.new(shot))
            scene.collection.objects.link(camera)
            scene.timeline_markers.new(shot, frame=frame).camera = camera
    bpy.data.texts.new("storyblender.json")
    beside = bpy.data.objects.new("SC020_SH015", bpy.data.cameras.new("SC020_SH015"))
    bpy.data.scenes["SC020"].collection.objects.link(beside)
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "story.blend"))
    return folder / "story.blend"


@pytest.fixture
def program(story: Path, monkeypatch: pytest.MonkeyPatch) -> Program:
    """The story is open, and the program answers."""
    program = Program()
    monkeypatch.setattr(part("story"), "reach", lambda project, path: program)
    bpy.ops.wm.open_mainfile(filepath=str(story), load_ui=False)
    settle()
    return program


def test_it_is_switched_off_and_on_again_and_leaves_nothing() -> None:
    for _ in range(2):
        bpy.ops.preferences.addon_disable(module=PACKAGE)
        assert not hasattr(bpy.types, "STORYBLENDER_PT_shots") and not hasattr(bpy.types.WindowManager, "storyblender")
        assert not [each for each in bpy.app.handlers.load_post if each.__module__.startswith(PACKAGE)]
        bpy.ops.preferences.addon_enable(module=PACKAGE)
        assert hasattr(bpy.types, "STORYBLENDER_PT_shots") and hasattr(bpy.types.WindowManager, "storyblender")


def test_shots_are_gone_to_in_their_order_over_the_scenes(program: Program) -> None:
    assert bpy.ops.storyblender.go_to(step=0) == {"FINISHED"}
    seen = [("SC010_SH010", "SC010", 1)]
    while bpy.ops.storyblender.go_to(step=1) == {"FINISHED"}:
        scene = bpy.context.window.scene
        assert scene.camera.name == panel_state().chosen
        seen.append((panel_state().chosen, scene.name, scene.frame_current))
    assert seen == [(shot, scene, frame) for scene, shots in SHOTS.items() for shot, frame in shots.items()]
    bpy.ops.storyblender.go_to(step=-1)
    assert (panel_state().chosen, bpy.context.window.scene.name) == ("SC010_SH020", "SC010")


def test_without_the_program_shots_are_those_of_the_file(story: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def nobody(project: Path, path: str) -> None:
        raise part("connection").NotDone("no studio has this project open")

    monkeypatch.setattr(part("story"), "reach", nobody)
    bpy.ops.wm.open_mainfile(filepath=str(story), load_ui=False)
    settle()
    assert [row.name for row in panel_state().shots] == ["SC010_SH010", "SC010_SH020", "SC020_SH010", "SC020_SH015"]
    assert "no studio has this project open" in drawn() and "Not connected" in drawn()
    panel_state().active = 3
    assert bpy.ops.storyblender.go_to(step=0) == {"FINISHED"}
    assert bpy.context.window.scene.camera.name == "SC020_SH015", "another camera on the time of a shot has no marker"


def test_the_panels_show_what_is_known_of_a_shot(program: Program) -> None:
    said = drawn()
    for words in ("With the studio", "CU · 85 mm, 2.0 s", "ANNA: Well.", "To check: Anna's face",
                  "LOCKED Camera", "(on)", "UNLOCKED Duration", "Ilsa: Slower here",
                  "RADIOBUT_ON 2  CU single", "RADIOBUT_OFF 1",
                  "Undo: SC010_SH010: size CU", "FILE_REFRESH ", "RENDERLAYERS "):  # fmt: skip
        assert words in said, words
    with pytest.raises(AssertionError):
        Layout().label(text="x", icon="NO_SUCH_ICON")


def test_what_is_done_in_the_panel_is_asked_as_edits_of_what_was_seen(program: Program) -> None:
    panel_state().note = "  Cut on the look.  "
    bpy.ops.storyblender.add_note()
    bpy.ops.storyblender.lock(part="camera")
    bpy.ops.storyblender.lock(part="duration")
    bpy.ops.storyblender.take(action="choose", number=1)
    bpy.ops.storyblender.resolve_note(number=1)
    bpy.ops.storyblender.undo_story()
    assert not program.asked or part("work").WORK.doing, "Blender does not wait"
    settle()
    *edits, undone = program.asked
    assert undone == "undo" and {revision for _, revision in edits} == {"7.abc"}
    shot = {"shot": "SC010_SH010"}
    assert [edit for [edit], _ in edits] == [
        {"kind": "note", **shot, "action": "add", "text": "Cut on the look."},
        {"kind": "unlock", "target": "SC010_SH010", "parts": ["camera"]},
        {"kind": "lock", "target": "SC010_SH010", "parts": ["duration"]},
        {"kind": "take", **shot, "action": "choose", "number": 1},
        {"kind": "note", **shot, "action": "resolve", "number": 1},
    ]
    assert not panel_state().note
    with pytest.raises(RuntimeError, match="Write the note first"):
        bpy.ops.storyblender.add_note()


def test_a_refusal_is_told_until_the_next_thing_is_done(program: Program) -> None:
    program.refuses = "SC010_SH010 is approved; withdraw the approval first"
    bpy.ops.storyblender.lock(part="camera")
    settle()
    assert part("story").STORY.problem == program.refuses and "CANCEL SC010_SH010 is approved" in drawn()
    program.refuses = ""
    bpy.ops.storyblender.lock(part="camera")
    settle()
    assert not part("story").STORY.problem


def test_what_was_changed_is_saved_before_it_is_taken_over_and_then_the_file_is_written(
    program: Program, story: Path
) -> None:
    program.changes = ["chair moved"]
    bpy.data.objects["SC010_SH010"].location.x = 3
    before = story.stat().st_mtime_ns
    bpy.ops.storyblender.pull()
    assert story.stat().st_mtime_ns > before, "saved"
    settle()
    assert program.asked == ["pull", "push"]
    assert part("story").STORY.told == [
        "Taken over: chair moved",
        "Not taken over, kept in a copy: the strip was moved",
    ]
    program.asked.clear()
    bpy.ops.storyblender.draw_frame()
    settle()
    assert program.asked == ["pull", "draw SC010_SH010", "push"]


def test_a_file_that_was_written_anew_is_told_and_opened_where_one_was(program: Program, story: Path) -> None:
    bpy.ops.storyblender.go_to(step=1)
    assert not part("story").STORY.is_rewritten
    story.write_bytes(story.read_bytes())
    assert part("story").STORY.is_rewritten and "written anew" in drawn()
    bpy.ops.storyblender.reload()
    settle()
    assert not part("story").STORY.is_rewritten
    assert (panel_state().chosen, bpy.context.scene.frame_current) == ("SC010_SH020", 25)
    assert bpy.context.scene.name == "SC010" and bpy.context.scene.camera.name == "SC010_SH020"


def test_a_file_of_no_project_and_one_without_values_are_told(program: Program, tmp_path: Path) -> None:
    bpy.data.texts.remove(bpy.data.texts["storyblender.json"])
    assert "does not say what it was compiled as" in drawn()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "other.blend"), copy=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "other.blend"), load_ui=False)
    settle()
    assert "Open the story.blend" in drawn() and not bpy.ops.storyblender.pull.poll()

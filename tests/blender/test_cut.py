"""The file of a long story: scenes linked from the files of its sequences, a cut over all of them."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

import bpy
import pytest

sys.path.insert(0, str(Path(__file__).parent))

from story_stage import LENGTH, pack, shot, story

from storyblender.blender.cut import compile_cut
from storyblender.blender.story import compile_story
from storyblender.folder import Folder
from storyblender.memory.jobs import CutJob, SequenceFile


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three scenes in two sequences; the cut is compiled before the second one is there."""
    root = tmp_path_factory.mktemp("made") / "story"
    root.mkdir()
    packs = [pack(root, number, 2) for number in (1, 2, 3)]
    shots = [shot(number, each) for number in (1, 2, 3) for each in (1, 2)]
    sequences = (
        SequenceFile(path="story/SEQ010.blend", scene_ids=(1, 2)),
        SequenceFile(path="story/SEQ020.blend", scene_ids=(3,)),
    )
    for number, sequence in enumerate(sequences):
        ids = sequence.scene_ids
        job = story([each for each in packs if each.scene_id in ids], [each for each in shots if each.scene_id in ids])
        compile_story(job.model_copy(update={"out": sequence.path}), Folder(root))
        if number == 0:
            cut = CutJob(
                format=job.format, assets=(), shots=tuple(shots), packs=tuple(packs), sequences=sequences,
                out="story.blend",
            )  # fmt: skip
            compile_cut(cut, Folder(root))
    moved = root.with_name("moved")
    shutil.move(root, moved)
    return moved


@pytest.fixture
def opened(project: Path) -> Path:
    bpy.ops.wm.open_mainfile(filepath=str(project / "story.blend"), use_scripts=False)
    return project


def test_the_story_finds_its_sequences_wherever_the_folder_is(opened: Path):
    assert sorted(library.filepath for library in bpy.data.libraries) == [
        "//story/SEQ010.blend",
        "//story/SEQ020.blend",
    ]
    for number in (1, 2, 3):
        scene = bpy.data.scenes[f"SC0{number}0"]
        assert scene.library is not None and not scene.is_missing
        assert any(obj.get("node_id") == "ada" for obj in scene.objects)
        assert [marker.camera.name for marker in scene.timeline_markers] == [
            f"SC0{number}0_SH010",
            f"SC0{number}0_SH020",
        ]


def test_it_opens_on_the_first_scene_with_a_cut_over_all(opened: Path):
    assert bpy.context.window.scene.name == "SC010"
    strips = bpy.data.scenes["EDIT"].sequence_editor.strips
    assert [strip.name for strip in strips] == [f"SC0{n}0_SH0{k}0" for n in (1, 2, 3) for k in (1, 2)]
    for number, strip in enumerate(strips):
        assert strip.scene.name == strip.name[:5] and strip.scene_camera.name == strip.name
        assert (strip.frame_final_start, strip.frame_final_duration) == (1 + LENGTH * number, LENGTH)


def test_a_strip_of_a_linked_scene_renders(opened: Path, tmp_path: Path):
    """With Cycles, which draws everywhere; what is seen is not one colour."""
    edit = bpy.data.scenes["EDIT"]
    for scene in bpy.data.scenes:
        if scene.library is not None:
            scene.render.engine = "CYCLES"
            scene.cycles.samples = 1
    bpy.context.window.scene = edit
    edit.render.resolution_x, edit.render.resolution_y = 32, 18
    edit.frame_set(2 * LENGTH + 2)
    edit.render.filepath = str(tmp_path / "frame.png")
    bpy.ops.render.render(write_still=True)
    picture = bpy.data.images.load(str(tmp_path / "frame.png"))
    assert len({round(value, 2) for value in picture.pixels[:]}) > 3


def test_a_sequence_is_a_whole_file_of_its_own(project: Path):
    bpy.ops.wm.open_mainfile(filepath=str(project / "story" / "SEQ020.blend"), use_scripts=False)
    assert bpy.context.window.scene.name == "SC030" and not bpy.data.libraries
    assert [strip.name for strip in bpy.data.scenes["EDIT"].sequence_editor.strips] == ["SC030_SH010", "SC030_SH020"]

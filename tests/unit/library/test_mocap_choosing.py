"""Clips are found by what they are called, then by what it means, where the catalogue does not do it better."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.motion_files import a_person, write_bvh

from storyblender.catalog.motions import motion_called
from storyblender.library.embedder import load_embedder
from storyblender.library.mocap.choosing import choices_for
from storyblender.library.mocap.folders import MotionFile, MotionFolders
from storyblender.memory.shot_context import CharacterAction
from storyblender.memory.vocabulary import Mood

NAMES = (
    "shrug_03", "angry_argument_02", "sitting/laugh", "drunk_dance", "hip_hop_dance", "victory_celebration", "salute",
    "checking_phone", "despair", "stretching_arms", "ScratchingHead", "praying_kneeling", "mixamo.com_walk_loop",
)  # fmt: skip


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> tuple[MotionFile, ...]:
    folder = tmp_path_factory.mktemp("clips")
    text = write_bvh(a_person(30.0, 0.2))
    for name in NAMES:
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / f"{name}.bvh").write_text(text)
    (folder / "notes.txt").write_text("nothing")
    (folder / "motions.toml").write_text('["salute.bvh"]\nneeds = "person"\n')
    return MotionFolders([folder]).files


@pytest.mark.parametrize(
    ("words", "motion", "mood", "wanted"),
    [
        ("shrugs", None, "neutral", "shrug_03.bvh"),
        ("dances", None, "neutral", "hip_hop_dance.bvh"),
        ("dances drunkenly", None, "neutral", "drunk_dance.bvh"),
        ("scratches his head", None, "neutral", "ScratchingHead.bvh"),
        ("stretches her arms", "idle", "neutral", "stretching_arms.bvh"),
        ("celebrates his victory", "idle", "neutral", "victory_celebration.bvh"),
        ("is in despair", "idle", "sad", "despair.bvh"),
        ("speaks to Anna", "talk", "angry", "angry_argument_02.bvh"),
        ("speaks to Anna", "talk", "neutral", None),
        ("speaks to Anna", "talk", "happy", None),
        ("salutes", None, "neutral", None),
        ("laughs", None, "neutral", None),
        ("walks to the door", "walk", "neutral", None),
        ("waits in the middle of the room", "idle", "neutral", None),
        ("stands by the window", "idle", "neutral", None),
        ("sits down", "sit", "neutral", None),
    ],
)
def test_what_is_done_finds_the_clip_that_does_it(
    words: str, motion: str | None, mood: Mood, wanted: str | None, files: tuple[MotionFile, ...]
) -> None:
    key = motion or motion_called(words) or "idle"
    action = CharacterAction(asset_id="ben", action_description=words, motion=key, mood=mood)
    found = choices_for(action, files, load_embedder, "1 2 0 ben")
    assert (found[0].file.name if found else None) == wanted
    if found:
        assert found[0].reason


def test_who_sits_gets_the_seated_clip_and_whom_it_needs_has_to_be_there(files: tuple[MotionFile, ...]) -> None:
    laughs = CharacterAction(asset_id="ben", action_description="laughs", motion="laugh")
    assert choices_for(laughs, files, load_embedder, "x", seated=True)[0].file.name == "sitting/laugh.bvh"
    salutes = CharacterAction(asset_id="ben", action_description="salutes", motion="salute", target_id="anna")
    assert choices_for(salutes, files, load_embedder, "x")[0].file.name == "salute.bvh"


def test_people_get_different_ones_of_equal_clips_and_the_same_ones_again(tmp_path: Path) -> None:
    for number in range(6):
        (tmp_path / f"shrug_{number}.bvh").write_text("")
    clips = MotionFolders([tmp_path]).files
    action = CharacterAction(asset_id="ben", action_description="shrugs", motion="shrug")
    firsts = [choices_for(action, clips, load_embedder, name)[0].file.name for name in "abcdefghij"]
    assert len({*firsts}) > 2
    assert firsts == [choices_for(action, clips[::-1], load_embedder, name)[0].file.name for name in "abcdefghij"]

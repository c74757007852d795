"""Who talks gestures phrase by phrase, rests between, and looks away and back."""

from __future__ import annotations

import itertools

import bpy
import numpy as np
import pytest
from tests.blender.motion_stage import Playback, build_bodies, cue_of, mark_at, perform, table_at

from storyblender.blender.motion.clips.phrasing import GESTURES, REST, phrases
from storyblender.blender.motion.clips.speech import MANNERS, QUIET_HANDS
from storyblender.blender.people.body import RiggedBody
from storyblender.catalog.motions import stressed_moment
from storyblender.memory.vocabulary import Mood

pytestmark = pytest.mark.blender


@pytest.fixture(scope="module")
def bodies() -> dict[str, RiggedBody]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return build_bodies("man", "woman")


@pytest.mark.parametrize("mood", sorted(MANNERS))
def test_a_speech_is_cut_into_phrases_and_no_gesture_comes_twice_in_a_row(mood: str) -> None:
    manner = MANNERS[mood]
    spoken = phrases(1.0, 16.0, manner.shares, manner.pace, np.random.default_rng(5))
    assert spoken[0].start == 1.0
    assert spoken[-1].end == 16.0
    assert spoken[0].gesture != REST
    for before, after in itertools.pairwise(spoken):
        assert before.end == after.start
        assert before.gesture != after.gesture
    assert len({phrase.gesture for phrase in spoken}) >= 3
    assert all(phrase.start < stress < phrase.end for phrase in spoken for stress in phrase.stresses[1:])
    assert {name for manner in MANNERS.values() for name in manner.shares} - {REST} <= set(GESTURES)


def test_hands_that_are_quiet_stay_quiet() -> None:
    spoken = phrases(0.0, 9.0, QUIET_HANDS, 1.8, np.random.default_rng(1))
    assert {phrase.gesture for phrase in spoken} == {REST}


@pytest.mark.parametrize("mood", ["neutral", "sad", "angry"])
def test_hands_rise_and_rest_while_somebody_talks(bodies: dict[str, RiggedBody], mood: Mood) -> None:
    marks = (mark_at("man", -0.6, 0, 90), mark_at("woman", 0.6, 0, -90))
    shot = perform(bodies, marks, (cue_of("man", "talk", 2, target_id="woman", duration=330, mood=mood),), 14)
    play, k = Playback(bodies["man"], shot, "man"), bodies["man"].stature / 1.7
    heights = {side: [play.joint(f"hand.{side}", frame).z / k for frame in range(20, 320, 6)] for side in "LR"}
    tops = np.array(list(heights.values()))
    assert tops.max() > 0.97, "they gesture"
    assert (tops < 0.92).mean() > 0.15, "they rest"
    assert np.ptp(tops, axis=1).max() > 0.08
    steps = [abs(b - a) for each in heights.values() for a, b in itertools.pairwise(each)]
    assert max(steps) < 0.55, "nothing jumps"


@pytest.mark.parametrize("length", [24, 60, 200])
def test_mouth_and_eyes_are_open_where_a_picture_shows_a_speech(bodies: dict[str, RiggedBody], length: int) -> None:
    shot = perform(bodies, (mark_at("man", 0, 0),), (cue_of("man", "talk", 4, duration=length),), 10)
    track = shot.people["man"]
    frame = round(24 * stressed_moment(4 / 24, (4 + length) / 24))
    mouth, lids = (track.face[:, track.face_keys.index(key)] for key in ("mouth_open", "blink"))
    assert mouth[frame] > 0.85 * mouth.max() > 0.1
    assert lids[frame] < 0.2


def test_who_talks_with_a_full_hand_gestures_with_the_other(bodies: dict[str, RiggedBody]) -> None:
    marks = (mark_at("man", 0, 0, 0, held=(("R", "cup"),)),)
    shot = perform(bodies, marks, (cue_of("man", "talk", 2, duration=200),), 8.5, furniture={"table": table_at(0, 3)})
    play = Playback(bodies["man"], shot, "man")
    moved = {side: np.ptp([play.joint(f"hand.{side}", f).z for f in range(10, 190, 6)]) for side in "LR"}
    assert moved["L"] > 0.2


def test_who_laughs_throws_the_head_back_and_doubles_up_over_a_hand(bodies: dict[str, RiggedBody]) -> None:
    shot = perform(bodies, (mark_at("man", 0, 0),), (cue_of("man", "laugh", 2, duration=48),), 3)
    play = Playback(bodies["man"], shot, "man")
    ahead = [-play.joint("head", frame).y for frame in range(len(shot.frames))]
    assert min(ahead[8:20]) < ahead[0] - 0.03
    assert max(ahead[30:45]) > ahead[0] + 0.06
    assert (play.joint("hand.R", 36) - play.joint("spine", 36)).length < 0.35
    assert ahead[-1] == pytest.approx(ahead[0], abs=0.03)

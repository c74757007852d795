"""A coarse motion becomes the act that its verb and its words mean."""

from __future__ import annotations

import pytest

from storyblender.agents.director.fine_motions import UNREAD, fine_motion


@pytest.mark.parametrize(
    ("motion", "verb", "words", "act"),
    [
        ("look", "look", "looks over his shoulder", "look_back"),
        ("look", "look", "looks up at the ceiling", "look_up"),
        ("look", "look", "looks up from the map", "look"),
        ("work", "dig", "digs beside the wall", "dig"),
        ("work", "", "is sewing a sail", "sew"),
        ("hold", "clutch", "clutches his chest", "clutch_chest"),
        ("play_music", "play", "plays the violin", "violin"),
        ("open", "open", "opens the gate", "open"),
        ("hold", "hold", "holds her hand", "hold_hands"),
        ("take", "take", "takes him by the hand", "hold_hands"),
        ("hold", "hold", "sits at a table with a glass in his hand", "hold"),
    ],
)
def test_words_make_a_motion_finer(motion: str, verb: str, words: str, act: str) -> None:
    assert fine_motion(motion, verb, words) == act


@pytest.mark.parametrize(
    ("words", "act"),
    [
        ("Otto covers his ears.", "cover_ears"),
        ("Otto yawns.", "yawn"),
        ("The clock is on the wall behind him.", UNREAD),
    ],
)
def test_what_has_no_motion_is_an_act_where_its_verb_tells(words: str, act: str) -> None:
    assert fine_motion(UNREAD, "", words) == act

"""Sentences as people read them: names for ids, rounded numbers, no underscores, and nothing else touched."""

import pytest

from storyblender.memory.plain_words import plain

NAMES = {"ilsa_lund": "Ilsa Lund", "bar": "the bar", "set_chair_1": "the chair", "guitarist": "Guitarist"}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("the face of ilsa_lund is hidden", "the face of Ilsa Lund is hidden"),
        ("ilsa_lund's hand", "Ilsa Lund's hand"),
        ("the camera is in bar", "the camera is in the bar"),
        ("the camera is in the bar", "the camera is in the bar"),
        ("a bar is there", "a bar is there"),
        ("the library has no bar; it is called 'bar'", "the library has no bar; it is called 'bar'"),
        ("the guitarist sings", "Guitarist sings"),
        ("set_chair_1 placed at 1.2, 0.5", "the chair placed at 1.2, 0.5"),
        ("set_kept_side_table_4 is in the way", "the side table is in the way"),
        ("two_shot, over_shoulder", "two shot, over shoulder"),
        ("azimuth 9.329750213", "azimuth 9.33"),
        ("moved by -0.1000001 m", "moved by -0.1 m"),
        ("“ilsa_lund” at `storyblender place x.storyboard SC010 bar`",) * 2,
        ("made from tin_cup.obj, bar/tin_cup-2.obj or ilsa_lund-v2_final.glb",) * 2,
        ("SC010_SH020 and board_single.pdf and out/bar",) * 2,
    ],
)
def test_a_sentence_is_said_with_names_and_round_numbers(text: str, said: str) -> None:
    assert plain(text, NAMES) == said
    assert plain(said, NAMES) == said, "said twice it is the same"

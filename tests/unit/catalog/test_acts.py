"""Acts are rows that can be played: known faces, a telling moment inside the act, keys that repeat."""

from __future__ import annotations

from tests.every import every

from storyblender.catalog.acts import ACTS, Act
from storyblender.catalog.expressions import EXPRESSIONS, FACE_UNITS
from storyblender.catalog.motions import MOTIONS


@every("act", ACTS.values())
def test_an_act_can_be_played(act: Act) -> None:
    assert 0.15 < act.telling < 0.98
    assert all(key.face in (None, *EXPRESSIONS) for key in (*act.keys, *act.partner))
    assert act.again is None or (act.stretches and act.again < len(act.keys))
    assert act.still_key is None or act.still_key < len(act.keys)
    assert MOTIONS[act.key] == act.motion


def test_an_expression_uses_units_of_the_face_within_their_range() -> None:
    for face in EXPRESSIONS.values():
        assert {*face} <= {*FACE_UNITS}
        assert all(0 <= value <= 1 for value in face.values())

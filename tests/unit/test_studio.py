"""What a user says to the studio: shots by name."""

from __future__ import annotations

import pytest

from storyblender.errors import InputError
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import CameraInstruction, ShotContext
from storyblender.studio import _named_shots


def test_shots_are_named_in_any_case_and_a_slip_is_told_apart() -> None:
    shots = tuple(ShotContext(scene_id=1, shot_id=n, camera_instruction=CameraInstruction()) for n in (1, 2, 3))
    graph = ContinuityMemoryGraph(shots=shots)
    assert _named_shots(graph, ["sc010_sh020"]) == [shots[1]]
    assert _named_shots(graph, []) == list(shots)
    with pytest.raises(InputError, match="'SC010SH030'; did you mean SC010_SH030"):
        _named_shots(graph, ["SC010SH030"])
    with pytest.raises(InputError, match="they go from SC010_SH010 to SC010_SH030"):
        _named_shots(graph, ["last"])

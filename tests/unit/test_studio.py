"""What a user says to the studio: shots by name, and what becomes of the others."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import cast

import pytest

from storyblender.errors import InputError
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import CameraInstruction, ShotContext
from storyblender.pipeline.run import Run
from storyblender.settings import Settings
from storyblender.studio import Studio, _named_shots


def test_shots_are_named_in_any_case_and_a_slip_is_told_apart() -> None:
    shots = tuple(ShotContext(scene_id=1, shot_id=n, camera_instruction=CameraInstruction()) for n in (1, 2, 3))
    graph = ContinuityMemoryGraph(shots=shots)
    assert _named_shots(graph, ["sc010_sh020"]) == [shots[1]]
    assert _named_shots(graph, []) == list(shots)
    with pytest.raises(InputError, match="'SC010SH030'; did you mean SC010_SH030"):
        _named_shots(graph, ["SC010SH030"])
    with pytest.raises(InputError, match="they go from SC010_SH010 to SC010_SH030"):
        _named_shots(graph, ["last"])


def test_the_film_has_every_shot_moving_also_where_one_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    shots = tuple(ShotContext(scene_id=1, shot_id=n, camera_instruction=CameraInstruction()) for n in (1, 2))
    run = cast(Run, SimpleNamespace(graph=ContinuityMemoryGraph(shots=shots), project=SimpleNamespace(folder=Path())))
    filmed: list[ShotContext] = []
    monkeypatch.setattr("storyblender.studio.damaged_frames", lambda run, others: [])
    monkeypatch.setattr("storyblender.studio.shoot_frames", lambda run, shots: {})
    monkeypatch.setattr("storyblender.studio.retake_poor_frames", lambda run, shots: {})
    monkeypatch.setattr("storyblender.studio.Compilation", lambda run: None)
    monkeypatch.setattr("storyblender.studio.shoot_motion", lambda run, shots: filmed.extend(shots) or {})
    monkeypatch.setattr("storyblender.pipeline.delivery.deliver", lambda run, clips, story: [])
    Studio(Settings())._shoot(run, shots[:1])
    assert filmed == list(shots), "a shot without moving frames would be a still in the film"

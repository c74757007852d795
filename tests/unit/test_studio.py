"""What a user says to the studio."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import cast

import pytest

from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import CameraInstruction, ShotContext
from storyblender.pipeline.run import Run
from storyblender.settings import Settings
from storyblender.studio import Studio


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

"""Two shots and their frames, for all that is delivered of them."""

from __future__ import annotations

from pathlib import Path

import pytest
from PIL import Image

from storyblender.memory.graph import ContinuityMemoryGraph, ProjectFormat
from storyblender.memory.outline import SceneOutline, ScriptLine, ShotOutline, SourceSpan
from storyblender.memory.scene_context import SceneContext, SceneSetup
from storyblender.memory.shot_context import CameraInstruction, ShotContext


@pytest.fixture
def graph() -> ContinuityMemoryGraph:
    speech = ScriptLine(kind="dialogue", text="=Où est 李?", span=SourceSpan(start=9, end=20), speaker_name="Élodie")
    action = ScriptLine(kind="action", text="She waits & listens.", span=SourceSpan(start=0, end=8))
    shots = (
        ShotOutline(shot_id=1, lines=(action,)),
        ShotOutline(shot_id=2, lines=(speech,)),
    )
    outline = SceneOutline(scene_id=1, scene_description="A bar", heading="INT. BAR - NIGHT", shots=shots)
    contexts = tuple(
        ShotContext(
            scene_id=1,
            shot_id=number,
            duration=12,
            camera_instruction=CameraInstruction(size="MCU", movement="push in", lens=65, kind="single"),
        )
        for number in (1, 2)
    )
    return ContinuityMemoryGraph(
        title="Žluťoučký kůň",
        format=ProjectFormat(fps=12),
        outline=(outline,),
        scenes=(SceneContext(scene_id=1, setup=SceneSetup(place="BAR")),),
        shots=contexts,
    )


@pytest.fixture
def frames(tmp_path: Path) -> dict[str, Path]:
    (tmp_path / "frames").mkdir()
    paths = {name: tmp_path / "frames" / f"{name}.png" for name in ("SC010_SH010", "SC010_SH020")}
    for index, path in enumerate(paths.values()):
        Image.new("RGB", (160, 90), (200 * index, 60, 60)).save(path)
    return paths

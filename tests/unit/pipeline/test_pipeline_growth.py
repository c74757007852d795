"""The cost of a shot does not grow with the story: function calls are counted, which no machine's speed changes."""

from __future__ import annotations

import cProfile
import pstats
from collections.abc import Callable
from pathlib import Path
from typing import cast

from tests.crew import crew_of
from tests.stand_in_engine import StandInEngine

from storyblender.memory.shot_context import CameraPose, CameraState
from storyblender.pipeline.compiling import Compilation
from storyblender.pipeline.grounding import ground
from storyblender.pipeline.materializing import materialize
from storyblender.pipeline.packing import pack_scenes
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import prune, shoot_frames
from storyblender.pipeline.staging import stage
from storyblender.ports import Engine
from storyblender.project import Project
from storyblender.settings import Settings
from storyblender.trace import silent

SCENE = "INT. ROOM - DAY\n\nANNA stands by the table. TOM waits.\n\nANNA\nHere I am.\n\nTOM\nSo you are.\n\n"
CAMERA = CameraState(poses=(CameraPose(pivot=(0, 0, 1), rotation=(1, 0, 0, 0), distance=2, lens=35),))
SHORT, LONG = 5, 20
GROWTH = 1.3
"""Most that a shot of the long story may cost, in shots of the short one; quadratic would be 4."""


def calls_per_shot(folder: Path, scenes: int) -> dict[str, float]:
    """Make a story of equal scenes and return the function calls a shot of each stage."""
    script = folder / f"{scenes}.fountain"
    script.write_text(SCENE * scenes)
    with Project(folder / f"{scenes}.storyboard") as project:
        settings = Settings(look="fast", width=320, animatic=False)
        run = Run(project, cast(Engine, StandInEngine(project.folder)), crew_of(settings), settings, silent)  # type: ignore[arg-type]
        ground(run, script)
        materialize(run)
        counts = {"stage": counted(lambda: stage(run)), "pack": counted(lambda: pack_scenes(run))}
        run.commit("user", "cameras", *(shot.model_copy(update={"camera": CAMERA}) for shot in run.graph.shots))
        counts["frames"] = counted(lambda: shoot_frames(run, run.graph.shots))
        counts["frames again"] = counted(lambda: shoot_frames(run, run.graph.shots))
        counts["compile"] = counted(lambda: Compilation(run).finish())
        counts["prune"] = counted(lambda: prune(run, run.graph.shots))
        return {stage: count / len(run.graph.shots) for stage, count in counts.items()}


def counted(work: Callable[[], object]) -> int:
    profile = cProfile.Profile()
    profile.runcall(work)
    return pstats.Stats(profile).total_calls  # type: ignore[attr-defined]


def test_no_stage_costs_more_a_shot_in_a_long_story(tmp_path: Path) -> None:
    short, long = calls_per_shot(tmp_path, SHORT), calls_per_shot(tmp_path, LONG)
    growth = {stage: round(long[stage] / short[stage], 2) for stage in short}
    assert max(growth.values()) < GROWTH, growth

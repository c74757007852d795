"""What every stage shares: a refusal of the Gatekeeper is told before it ends the run."""

from __future__ import annotations

from pathlib import Path
from typing import cast

import pytest
from tests.crew import RULES

from storyblender.errors import Rejected
from storyblender.memory.scene_context import SceneContext, SceneSetup
from storyblender.pipeline.run import Run
from storyblender.ports import Engine
from storyblender.project import Project
from storyblender.settings import Settings
from storyblender.trace import Event


def test_what_the_gatekeeper_refuses_is_told_and_kept(tmp_path: Path) -> None:
    told: list[Event] = []
    with Project(tmp_path / "p") as project:
        run = Run(project, cast(Engine, None), RULES, Settings(), told.append)
        with pytest.raises(Rejected):
            run.commit("set_dresser", "dresses", SceneContext(scene_id=1, setup=SceneSetup(asset_ids=("nobody",))))
    assert [(event.kind, event.role, event.message) for event in told] == [("reject", "set_dresser", "dresses")]
    assert told[0].details and '"reject"' in (tmp_path / "p" / "trace.jsonl").read_text()

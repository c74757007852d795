"""Framing requests by a client that is not ours, in words and typed: the frames are as asked, and the critic agrees.

``python -m benchmarks framing`` sends forty to a longer story.
"""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest
from benchmarks.framing_measures import Wanted
from benchmarks.framing_requests import Request, outcomes

pytestmark = pytest.mark.blender

SHOT = "SC010_SH020"
REQUESTS = (
    Request(SHOT, "close-up of Ada, 85 mm", Wanted(size="CU", lens=85, people=("ada",))),
    Request(SHOT, "low angle, medium shot of Tom", Wanted(size="MS", angle="low angle", people=("tom",))),
    Request(SHOT, {"kind": "two_shot", "focus_on_ids": ["ada", "tom"], "size": "MWS", "movement": "push in"},
            Wanted(move="push in", people=("ada", "tom"))),
    Request(SHOT, "a purple mood", Wanted()),
)  # fmt: skip


def test_frames_are_as_they_were_asked_for(project: Path) -> None:
    *good, unknown = asyncio.run(outcomes(project.parent, project.name, REQUESTS, width=160))
    for outcome in good:
        assert not outcome.refused and not outcome.missed, outcome
        assert outcome.passes, (outcome.request, outcome.faults)
    assert "not understood: a purple mood" in unknown.refused

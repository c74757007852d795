"""Runs in this process, on a stand-in for Blender, that wait only milliseconds for a service."""

from __future__ import annotations

import pytest

from storyblender.library.sources import service_run
from tests.services.site import QUICK
from tests.stand_in_engine import StandInEngine


def hurry(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let every studio of a test use the stand-in, and give its services little patience."""

    def run(*given: object) -> object:
        made = service_run(*given)  # type: ignore[arg-type]
        if made is not None:
            object.__setattr__(made, "patience", QUICK)
        return made

    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
    monkeypatch.setattr("storyblender.studio.service_run", run)

"""The page's tests wait for frames: the pause before frames are drawn is short here."""

from __future__ import annotations

import pytest

from storyblender.web_studio import drawer


@pytest.fixture(autouse=True)
def _short_pause(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drawer, "REST", 0.05)

"""A session that is cancelled while a model thinks ends at once, and goes on with the next call."""

from __future__ import annotations

import threading
import time
from pathlib import Path

import pytest

from storyblender.errors import Cancelled
from storyblender.settings import Settings
from storyblender.studio import Studio
from storyblender.trace import Event
from tests.wire.loopback import Fail, Late, serving
from tests.wire.wires import SERVICES


def test_a_cancelled_session_does_not_wait_for_the_model(tmp_path: Path) -> None:
    service, script, folder = SERVICES["anthropic"], tmp_path / "hall.fountain", tmp_path / "hall.storyboard"
    script.write_text("INT. HALL - DAY\n\nANNA opens the door.\n")
    Studio(Settings()).plan(script, folder)
    script.write_text("INT. HALL - DAY\n\nANNA shuts the door. BELA sits.\n")
    events: list[Event] = []
    with serving(service.wire, Late(120), Fail(401, "who are you")) as server:
        settings = Settings(crew=f"director={service.provider}:{service.model}@{server.address}")
        with Studio(settings, events.append).open(folder) as session:
            threading.Thread(target=lambda: server.arrived.wait(60) and session.cancel()).start()
            began = time.monotonic()
            with pytest.raises(Cancelled):
                session.plan(script, why=False)
            assert time.monotonic() - began < 60
            assert any(event.kind == "cancel" for event in events)
            assert "BELA" not in str(session.graph), "nothing is half-written"
            session.plan(script, why=False)
            assert "BELA" in str(session.graph), "rules take over from a model that refuses"

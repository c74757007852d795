"""What the tests of models behind real wires share. They need the extra ``crew``; without it nothing is tested."""

from __future__ import annotations

from collections.abc import Callable
from importlib.util import find_spec
from threading import Event
from typing import Any

import pytest

from storyblender.language.budget import Budget
from storyblender.memory.request import Picture, Request
from tests.wire.loopback import Server
from tests.wire.wires import Service

collect_ignore_glob = [] if find_spec("pydantic_ai") else ["test_*.py"]

SCHEMA = (
    '{"type": "object", "properties": {"number": {"type": "integer"}}, "required": ["number"],'
    ' "additionalProperties": false}'
)
PNG = bytes.fromhex(
    "89504e470d0a1a0a0000000d49484452000000010000000108060000001f15c4890000000d49444154789c6364f8cf500f00030601805a34"
    "7d6b0000000049454e44ae426082"
)
"""One red pixel."""


def request_of(**changes: Any) -> Request:
    """Return a request with a picture, for a number."""
    given: dict[str, Any] = {
        "role": "director", "subject": "SC010", "instructions": "Count the doors.", "view": '{"walls": "MARKED WORDS"}',
        "answer_schema": SCHEMA, "pictures": (Picture(name="plan", png=PNG),),
    }  # fmt: skip
    return Request(**given | changes)


@pytest.fixture
def provider(monkeypatch: pytest.MonkeyPatch) -> Callable[..., Any]:
    """Make the provider of a service behind a server; it makes no pauses and does not wait long."""
    from storyblender.language.provider import Provider

    for name in ("OPENAI_API_KEY", "ANTHROPIC_API_KEY", "GOOGLE_API_KEY", "GEMINI_API_KEY"):
        monkeypatch.delenv(name, raising=False)

    def make(service: Service, server: Server, budget: Budget | None = None, **options: Any) -> Provider:
        given: dict[str, Any] = {"cancelled": Event(), "pause": 0.0, "timeout": 30.0}
        return Provider(service.player(server.address), budget or Budget({}), **given | options)

    return make

"""What every role asks for can be said on every wire."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import pytest
from pydantic import BaseModel

from storyblender.language_crew import ANSWERS
from tests.wire.conftest import request_of
from tests.wire.loopback import Fail, Say, serving
from tests.wire.wires import SERVICES


@pytest.mark.parametrize("refused", [(), ("native",)], ids=["best", "next"])
@pytest.mark.parametrize("kind", ANSWERS.values(), ids=ANSWERS)
@pytest.mark.parametrize("name", SERVICES)
def test_the_form_of_every_role_is_asked_for(
    name: str, kind: type[BaseModel], refused: tuple[str, ...], provider: Callable[..., Any]
) -> None:
    service, schema = SERVICES[name], json.dumps(kind.model_json_schema())
    form = next(form for form in service.forms if form not in refused)
    with serving(service.wire, Fail(400, "no such form", refused), Say('{"a": 1}')) as server:
        assert json.loads(provider(service, server).answer(request_of(answer_schema=schema))) == {"a": 1}
    assert server.forms[-1] == form and len(server.forms) <= 2
    body = json.dumps(server.bodies[-1])
    assert all(f'"{field}"' in body for field in kind.model_fields), "the schema arrives"


def test_openai_is_told_to_keep_nothing(provider: Callable[..., Any]) -> None:
    service = SERVICES["openai_responses"]
    with serving(service.wire, Say('{"number": 3}')) as server:
        provider(service, server).answer(request_of())
    assert server.bodies[0]["store"] is False

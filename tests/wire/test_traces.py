"""Requests to models are OpenTelemetry spans where an SDK is configured, and nothing where none is."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from storyblender.errors import NoAnswer
from tests.wire.conftest import request_of
from tests.wire.loopback import Fail, Say, serving
from tests.wire.test_secrets import KEY, key_name
from tests.wire.wires import SERVICES

GOOD = Say('{"number": 3}')


@pytest.fixture
def spans(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Configure an SDK that keeps its spans, and return what keeps them."""
    from opentelemetry.sdk.trace import TracerProvider
    from opentelemetry.sdk.trace.export import SimpleSpanProcessor
    from opentelemetry.sdk.trace.export.in_memory_span_exporter import InMemorySpanExporter

    from storyblender.language import model_api

    exporter, tracers = InMemorySpanExporter(), TracerProvider()
    tracers.add_span_processor(SimpleSpanProcessor(exporter))
    monkeypatch.setattr(model_api, "get_tracer_provider", lambda: tracers)
    return exporter


def test_without_an_sdk_nothing_is_traced(provider: Callable[..., Any]) -> None:
    from pydantic_ai.models.instrumented import InstrumentedModel

    service = SERVICES["openai_chat"]
    with serving(service.wire, GOOD) as server:
        assert not isinstance(provider(service, server)._api._model, InstrumentedModel)


@pytest.mark.parametrize("content", ["true", ""])
def test_a_span_has_tokens_and_words_only_where_they_are_asked_for(
    content: str, spans: Any, provider: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    service = SERVICES["openai_chat"]
    monkeypatch.setenv("OTEL_INSTRUMENTATION_GENAI_CAPTURE_MESSAGE_CONTENT", content)
    with serving(service.wire, GOOD) as server:
        monkeypatch.setenv(key_name(server), KEY)
        provider(service, server).answer(request_of())
    (span,) = spans.get_finished_spans()
    assert span.name == f"chat {service.model}" and span.attributes["gen_ai.usage.input_tokens"] == 20
    assert ("MARKED WORDS" in span.to_json()) == bool(content)
    assert KEY not in span.to_json()


def test_a_form_that_a_model_has_not_is_passed_over(spans: Any, provider: Callable[..., Any]) -> None:
    service = SERVICES["anthropic_whole"]
    with serving(service.wire, GOOD) as server:
        assert provider(service, server).answer(request_of()) == GOOD.text
    assert server.forms == ["tool"]


@pytest.mark.parametrize("content", ["true", ""])
@pytest.mark.parametrize("name", SERVICES)
def test_the_span_of_a_failure_has_no_key(
    name: str, content: str, spans: Any, provider: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    service = SERVICES[name]
    monkeypatch.setenv("OTEL_INSTRUMENTATION_GENAI_CAPTURE_MESSAGE_CONTENT", content)
    for act, said in ((Fail(401, "bad key in "), "does not accept the key"), (Say(KEY), "repeats the key")):
        with serving(service.wire, act, gossips=True) as server:
            monkeypatch.setenv(key_name(server), KEY)
            with pytest.raises(NoAnswer):
                provider(service, server).answer(request_of())
        *_, span = spans.get_finished_spans()
        assert not span.status.is_ok and "ModelFailure" in span.to_json()
        assert (said in span.to_json()) == bool(content)
        assert KEY not in span.to_json()

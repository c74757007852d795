"""One request to a model of a provider, by pydantic-ai: the only module that knows it.

Answers are taken as they come, unvalidated: the asker keeps, checks and repairs them. Every failure becomes one
``ModelFailure`` with a sentence; the provider's own errors, which may repeat a key, go no further.
"""
# pyright: reportMissingImports=false
# the extra ``crew`` is not installed where nobody uses a model

from __future__ import annotations

import asyncio
import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Final, cast

from opentelemetry.trace import ProxyTracerProvider, get_tracer_provider
from pydantic_ai import exceptions
from pydantic_ai.direct import model_request
from pydantic_ai.messages import BinaryContent, ModelMessage, ModelRequest, ModelResponse, ToolCallPart, UserPromptPart
from pydantic_ai.models import Model, ModelRequestParameters, infer_model
from pydantic_ai.models.instrumented import InstrumentationSettings, InstrumentedModel
from pydantic_ai.models.wrapper import WrapperModel
from pydantic_ai.output import OutputObjectDefinition
from pydantic_ai.providers import infer_provider_class
from pydantic_ai.settings import ModelSettings
from pydantic_ai.tools import ToolDefinition

from storyblender.crew_setting import Player
from storyblender.errors import InputError
from storyblender.language.access import address_of, key_of
from storyblender.language.answer_folder import LONGEST, fenced, repair_parts
from storyblender.language.budget import Budget
from storyblender.language.model_failure import ModelFailure
from storyblender.memory.request import Request

FORMS: Final = ("native", "tool", "prompted")
"""How the form of an answer is asked for, the best first: the provider's structured output, a tool call, words."""
_SHORTEST_KEY: Final = 8
_ONCE: Final[dict[str, Any]] = {"max_retries": 0}
"""The SDKs try nothing again themselves."""
_PRIVATE: Final = _ONCE | {"openai_store": False}
"""OpenAI keeps what it was asked and what it answered, unless it is told not to."""
_TELEMETRY_CONTENT: Final = "OTEL_INSTRUMENTATION_GENAI_CAPTURE_MESSAGE_CONTENT"
"""OpenTelemetry's own switch; unless it is ``true``, spans have no words of the script."""


class ModelApi:
    """A model, asked one thing at a time.

    Args:
        player: Provider, model, address.
        budget: Counts what is used.
        timeout: Seconds until a request is given up.

    Raises:
        InputError: There is no such model, or its key is missing.
    """

    def __init__(self, player: Player, budget: Budget, timeout: float) -> None:
        self._budget, self._key = budget, key_of(player)
        guarded = _Guarded(_model(player, self._key), self._key, timeout)
        self._model = _traced(guarded)
        self._settings = _PRIVATE if player.where == "openai" else _ONCE

    async def ask(self, request: Request, form: str) -> str:
        """Return one answer, as it was given.

        Args:
            request: What is asked.
            form: One of ``FORMS``.

        Raises:
            ModelFailure: There is none.
            NoAnswer: Nothing more may be asked.
        """
        self._budget.check()
        self._budget.spend(requests=1)
        messages, parameters = [_message(request, form)], _form(request, form)
        with _failures(self._key):
            response = await model_request(
                self._model,
                messages,
                model_settings=cast(ModelSettings, self._settings),
                model_request_parameters=parameters,
            )
        self._budget.spend(tokens=response.usage.total_tokens, dollars=_dollars(response))
        return _answer(response, form)


def _traced(model: Model) -> Model:
    """Return a model whose requests are OpenTelemetry spans, if an SDK is configured; else the model."""
    tracers = get_tracer_provider()
    if isinstance(tracers, ProxyTracerProvider):
        return model
    content = os.environ.get(_TELEMETRY_CONTENT, "").lower() == "true"
    settings = InstrumentationSettings(
        tracer_provider=tracers, include_content=content, include_binary_content=False,
        include_model_request_parameters=content,
    )  # fmt: skip
    return InstrumentedModel(model, settings)


class _Guarded(WrapperModel):
    """A model whose errors and answers have no key in them, and that answers in time."""

    def __init__(self, wrapped: Model, key: str, timeout: float) -> None:
        super().__init__(wrapped)
        self._key, self._timeout = key, timeout

    async def request(
        self,
        messages: list[ModelMessage],
        model_settings: ModelSettings | None,
        model_request_parameters: ModelRequestParameters,
    ) -> ModelResponse:
        """Return the model's response. Raises ModelFailure, without what caused it."""
        with _failures(self._key):
            try:
                async with asyncio.timeout(self._timeout):
                    response = await self.wrapped.request(messages, model_settings, model_request_parameters)
            except TimeoutError:
                raise ModelFailure(f"it gave no answer in {self._timeout:g} seconds", tries=2) from None
        said = f"{response.parts} {response.provider_details}"
        if _without(self._key, said) != said:
            raise ModelFailure("its answer repeats the key")
        return response


@contextmanager
def _failures(key: str) -> Iterator[None]:
    """Turn every error inside into a ModelFailure without the key, and without the error."""
    try:
        yield
    except ModelFailure:
        raise
    except Exception as error:  # noqa: BLE001 - four SDKs and what reads their responses have no error in common
        raise _failure(error, key) from None


_CAUSES: Final[tuple[tuple[type[Exception], str, int, bool], ...]] = (
    (exceptions.ModelRateLimitError, "it is asked too often", 4, False),
    (exceptions.ModelQuotaExceededError, "its quota is used up", 1, False),
    (exceptions.ModelAuthenticationError, "it does not accept the key", 1, False),
    (exceptions.ModelContextWindowExceededError, "the request is too long for it", 1, False),
    (exceptions.ModelNotFoundError, "the server has no such model or no such address", 1, True),
    (exceptions.ModelRequestRejectedError, "it refuses the request", 1, True),
    (exceptions.ModelTimeoutError, "the connection timed out", 2, False),
    (exceptions.ModelConnectionError, "the connection failed", 4, False),
    (exceptions.ModelUnavailableError, "it is overloaded", 4, False),
    (exceptions.ModelServerError, "its server failed", 4, True),
    (exceptions.ContentFilterError, "it refuses to answer", 1, False),
    (exceptions.UserError, "it cannot be asked like this", 1, True),
)
"""Type of an error, what it means, how often to try, and whether another form may help. The first that fits counts."""


def _failure(error: Exception, key: str) -> ModelFailure:
    """Return an error as a sentence without the key; one that no service raises comes from a malformed response."""
    found = next((cause for cause in _CAUSES if isinstance(error, cause[0])), None)
    if found is None:
        return ModelFailure("its response cannot be read", 2, other_form=True)
    _, meaning, tries, other_form = found
    return ModelFailure(
        f"{meaning} ({_said(error, key)})", tries, other_form, getattr(error, "retry_after", None) or 0.0
    )


def _without(key: str, text: str) -> str:
    """Return a text without a key; what is shorter than any key is only a word."""
    return text.replace(key, "***") if len(key) >= _SHORTEST_KEY else text


def _said(error: Exception, key: str) -> str:
    """Return the first line of what a server said in an error, shortened, without the key."""
    status, body = getattr(error, "status_code", ""), getattr(error, "body", None)
    inner = body.get("error", body) if isinstance(body, dict) else body
    said = inner.get("message") if isinstance(inner, dict) else inner
    lines = _without(key, str(said or error)).strip().splitlines()
    return " ".join(part for part in (str(status), lines[0][:160] if lines else "") if part)


def _message(request: Request, form: str) -> ModelRequest:
    """Return a request as a message; the schema is in it only where nothing else can say the form."""
    words = ["## What you know", fenced(request.view), *repair_parts(request)]
    if form == "prompted":
        words += ["## Your answer", "Answer with one JSON value of this schema, and nothing else:"]
        words.append(fenced(request.answer_schema))
    text = "\n\n".join(words)
    named = [(f"Picture `{each.name}`:", BinaryContent(each.png, media_type="image/png")) for each in request.pictures]
    content = [text, *(part for pair in named for part in pair)] if named else text  # some servers read only text
    return ModelRequest(parts=[UserPromptPart(content=content)], instructions=request.instructions)


def _form(request: Request, form: str) -> ModelRequestParameters:
    """Return how an answer of the request's schema is asked for."""
    schema: dict[str, Any] = json.loads(request.answer_schema)
    if form == "native":
        return ModelRequestParameters(output_mode="native", output_object=OutputObjectDefinition(schema, name="answer"))
    if form == "tool":
        words = "Give your answer."
        tool = ToolDefinition(name="answer", parameters_json_schema=schema, description=words, kind="output")
        return ModelRequestParameters(output_mode="tool", output_tools=[tool], allow_text_output=False)
    return ModelRequestParameters(output_mode="text")


def _answer(response: ModelResponse, form: str) -> str:
    """Return the text of a response, or the arguments of its tool call. Raises ModelFailure."""
    details = response.provider_details or {}
    if response.finish_reason == "content_filter" or "refusal" in details:
        said = str(details.get("refusal", "")).strip()[:160]
        raise ModelFailure(f"it refuses to answer ({said})" if said else "it refuses to answer")
    called = next((part.args for part in response.parts if isinstance(part, ToolCallPart)), None)
    given = called or response.text or ""
    text = given if isinstance(given, str) else json.dumps(given, ensure_ascii=False)
    text = text.encode(errors="replace").decode()  # JSON can escape half a surrogate pair, which no file can hold
    if not text.strip():
        cut = response.finish_reason == "length"
        raise ModelFailure("its limit of tokens was reached" if cut else "its answer is empty", 2, other_form=True)
    if form == "tool" and called is None and not text.lstrip().startswith(("{", "[", "```")):
        raise ModelFailure("it does not call the tool", other_form=True)  # nor has it seen the schema then
    if len(text.encode()) > LONGEST:
        raise ModelFailure(f"its answer is too long, {len(text):,} characters", 2)
    return text


def _dollars(response: ModelResponse) -> float:
    """Return the price of a response; 0 for a model of unknown price."""
    try:
        return float(response.cost().total_price)
    except (LookupError, ValueError, AssertionError):
        return 0.0


def _model(player: Player, key: str) -> Model:
    """Return pydantic-ai's model of a player. Raises InputError."""
    options = {"api_key": key or "none"} if player.where != "google-cloud" else {}
    if address := address_of(player):
        options["base_url"] = address
    try:
        return infer_model(f"{player.where}:{player.model}", lambda name: infer_provider_class(name)(**options))
    except Exception as error:  # noqa: BLE001 - as above
        problem = f"{player.where}:{player.model} cannot be used ({_said(error, key)})"
        raise InputError(problem, mend="see docs/crew.md") from None

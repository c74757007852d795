"""A model behind a provider's API, by pydantic-ai: the only module that knows it.

The form of the answer is asked for by the best means that the model has: its provider's structured output, then a tool
call, then words. Transient failures are tried again with growing pauses; everything else is told in a sentence, and the
role hands over. Keys come from the environment or the keyring of the operating system, and go nowhere else.
"""
# pyright: reportMissingImports=false
# the extra ``crew`` is not installed where nobody uses a model

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from decimal import Decimal
from typing import Any, Final

import tenacity
from pydantic_ai import Agent, BinaryContent, NativeOutput, PromptedOutput, StructuredDict, ToolOutput
from pydantic_ai.exceptions import (
    AgentRunError,
    ModelAPIError,
    ModelConnectionError,
    ModelRateLimitError,
    ModelServerError,
    ModelUnavailableError,
    UnexpectedModelBehavior,
    UsageLimitExceeded,
    UserError,
)
from pydantic_ai.models import Model, infer_model
from pydantic_ai.providers import infer_provider_class
from pydantic_ai.usage import RunUsage, UsageLimits

from storyblender.crew_setting import LimitName, Player
from storyblender.errors import InputError, NoAnswer
from storyblender.language.answer_folder import repair_parts
from storyblender.memory.request import Request

_KEYS: Final = {
    "anthropic": "ANTHROPIC_API_KEY", "google": "GOOGLE_API_KEY", "openai": "OPENAI_API_KEY",
    "openai-chat": "OPENAI_API_KEY", "openrouter": "OPENROUTER_API_KEY",
}  # fmt: skip
"""Provider -> the environment variable of its key, and the name under which the keyring has it."""
FORMS: Final[dict[str, Callable[[Any], Any]]] = {
    "native": lambda schema: NativeOutput(schema, strict=False),
    "tool": lambda schema: ToolOutput(schema, name="answer", strict=False),
    "prompted": PromptedOutput,
}
"""How an answer of a schema is asked for, the best first."""
_TRANSIENT: Final = (ModelRateLimitError, ModelServerError, ModelUnavailableError, ModelConnectionError)
_TRIES: Final = 4
_LONGEST_PAUSE: Final = 30.0
"""Seconds."""


class Provider:
    """Answers by a model.

    Args:
        player: Provider, model, address.
        limits: What a run may use in all.
        pause: Longest pause in seconds before a failed request is sent again.

    Attributes:
        usage: What was used so far.
        form: How answers are asked for, a key of ``FORMS``; falls to the next where the model cannot.

    Raises:
        InputError: There is no such model, or its key is missing.
    """

    def __init__(self, player: Player, limits: Mapping[LimitName, float], pause: float = _LONGEST_PAUSE) -> None:
        self._name = f"{player.where}:{player.model}"
        self._model = _model(player)
        self._limits = UsageLimits(
            request_limit=int(limits["requests"]),
            total_tokens_limit=int(limits["tokens"]),
            cost_limit=Decimal(str(limits["dollars"])),
        )
        self._pause = pause
        self.usage = RunUsage()
        self.form = next(iter(FORMS))

    def answer(self, request: Request) -> str:
        """Return the model's answer as JSON. Raises NoAnswer."""
        forms, reason = list(FORMS), ""
        for form in forms[forms.index(self.form) :]:
            try:
                answer = self._asked(request, form)
            except (UnexpectedModelBehavior, UserError) as error:
                reason = _reason(error)
                continue
            except UsageLimitExceeded as error:
                raise self._failed(_reason(error), "raise the limits of the crew") from error
            except ModelAPIError as error:
                if _is_refusal_of_form(error):
                    reason = _reason(error)
                    continue
                raise self._failed(_reason(error), "rules take over") from error
            except AgentRunError as error:
                raise self._failed(_reason(error), "rules take over") from error
            self.form = form
            return answer
        raise self._failed(f"no answer in any form, the last time: {reason}", "rules take over")

    def _asked(self, request: Request, form: str) -> str:
        """Return one answer in a form; what may pass by itself is tried again."""
        schema = StructuredDict(json.loads(request.answer_schema), name="answer")
        agent = Agent(self._model, output_type=FORMS[form](schema), instructions=request.instructions, retries=1)
        prompt = [_words(request), *(BinaryContent(each.png, media_type="image/png") for each in request.pictures)]
        again = tenacity.Retrying(
            retry=tenacity.retry_if_exception_type(_TRANSIENT),
            wait=tenacity.wait_exponential_jitter(max=self._pause, initial=min(1.0, self._pause)),
            stop=tenacity.stop_after_attempt(_TRIES),
            reraise=True,
        )
        result = again(agent.run_sync, prompt, usage_limits=self._limits, usage=self.usage)
        return json.dumps(result.output, ensure_ascii=False)

    def _failed(self, reason: str, mend: str) -> NoAnswer:
        return NoAnswer(f"{self._name} did not answer: {reason}", mend=mend)


def _words(request: Request) -> str:
    """Return what a model is told besides its instructions."""
    return "\n\n".join(["## What you know", f"```json\n{request.view}\n```", *repair_parts(request)])


def _model(player: Player) -> Model:
    """Return pydantic-ai's model of a player. Raises InputError."""
    name = _KEYS.get(player.where)
    key = _key(name) if name else None
    if name and not key and not player.address:
        mend = f"set {name}, or `keyring set storyblender {name}`"
        raise InputError(f"there is no key for {player.where}", mend=mend)
    options = {"api_key": key or "none"} if name else {}
    if player.address:
        options["base_url"] = player.address
    try:
        return infer_model(f"{player.where}:{player.model}", lambda name: infer_provider_class(name)(**options))
    except (UserError, ValueError, TypeError, ImportError) as error:
        problem = f"{player.where}:{player.model} cannot be used: {_reason(error)}"
        raise InputError(problem, mend="see docs/crew.md") from error


def _key(name: str) -> str | None:
    """Return a key from the environment, else from the keyring of the operating system."""
    if os.environ.get(name):
        return os.environ[name]
    import keyring
    from keyring.errors import KeyringError

    try:
        return keyring.get_password("storyblender", name)
    except KeyringError:
        return None


def _is_refusal_of_form(error: ModelAPIError) -> bool:
    """Return whether a server refused how the answer was asked for, not the request itself."""
    return getattr(error, "status_code", None) in (400, 404, 422, 500, 501) and not isinstance(error, _TRANSIENT[:1])


def _reason(error: Exception) -> str:
    """Return the first line of an error, shortened."""
    return (str(error).strip() or type(error).__name__).splitlines()[0][:300]

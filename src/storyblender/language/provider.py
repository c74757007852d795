"""A model behind a provider's API that answers requests, for as long as it can be reached and may be paid for.

The form of the answer is asked for by the best means that the model has, and the next one where the server refuses it.
What may pass by itself is tried again with growing pauses. Everything else is one sentence, and the role hands over.
"""
# pyright: reportMissingImports=false
# the extra ``crew`` is not installed where nobody uses a model

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from concurrent.futures import wait
from functools import cache
from threading import Event as Signal
from threading import Thread
from typing import Any, Final

import tenacity

from storyblender.crew_setting import Player
from storyblender.errors import Cancelled, NoAnswer
from storyblender.language.budget import Budget
from storyblender.language.model_api import FORMS, ModelApi
from storyblender.language.model_failure import ModelFailure
from storyblender.memory.request import Request

_LONGEST_PAUSE: Final = 30.0
_TIMEOUT: Final = 600.0
_GLANCE: Final = 0.05
"""Seconds between two looks at whether the run was cancelled; so are the two above."""
_FAILURES: Final = 3
"""After so many requests in a row without an answer a model is not asked again in this run."""


class Provider:
    """Answers by a model.

    Args:
        player: Provider, model, address.
        budget: What the run may use.
        cancelled: Set from any thread to end the request under way.
        pause: Longest pause in seconds before a failed request is sent again.
        timeout: Seconds until a request is given up.

    Attributes:
        form: How answers are asked for, one of ``FORMS``; falls to the next where the model cannot.
        blind: Whether the model refused pictures; it gets none any more.

    Raises:
        InputError: There is no such model, or its key is missing.
    """

    def __init__(
        self,
        player: Player,
        budget: Budget,
        cancelled: Signal,
        pause: float = _LONGEST_PAUSE,
        timeout: float = _TIMEOUT,
    ) -> None:
        self._name = f"{player.where}:{player.model}"
        self._api = ModelApi(player, budget, timeout)
        self._cancelled, self._pause = cancelled, pause
        self.form, self.blind = FORMS[0], False
        self._failures, self._reason = 0, ""

    def answer(self, request: Request) -> str:
        """Return the model's answer as it was given.

        Raises:
            NoAnswer: It failed for good, or nothing more may be asked.
            Cancelled: ``cancelled`` was set.
        """
        if self._failures >= _FAILURES:
            raise self._silent(f"it failed {_FAILURES} times and is not asked again ({self._reason})")
        try:
            answer = self._seen_or_told(request)
        except ModelFailure as failure:
            self._failures, self._reason = self._failures + 1, str(failure)
            raise self._silent(self._reason) from failure
        self._failures = 0
        return answer

    def _seen_or_told(self, request: Request) -> str:
        """Return an answer; a model that refuses pictures is asked in words alone from then on, where they are enough.

        Raises:
            ModelFailure: There is none.
            NoAnswer: The request is about its pictures, and the model does not see them.
        """
        if not request.pictures:
            return self._waited_for(self._in_any_form(request))
        if not self.blind:
            try:
                return self._waited_for(self._in_any_form(request))
            except ModelFailure as failure:
                if failure.tries > 1 or not failure.other_form:
                    raise  # only what lasts may be a refusal of pictures
                self._reason = str(failure)
        self.blind = True
        if request.pictures_needed:
            raise self._silent(f"it does not see pictures ({self._reason})")
        try:
            return self._waited_for(self._in_any_form(request.model_copy(update={"pictures": ()})))
        except ModelFailure:
            self.blind = False  # pictures were not the reason
            raise

    async def _in_any_form(self, request: Request) -> str:
        """Return an answer in the first form in which the model gives one, and keep to that form."""
        forms = FORMS[FORMS.index(self.form) :]
        for form in forms:
            try:
                answer = await self._again(request, form)
            except ModelFailure as failure:
                if not failure.other_form or form == forms[-1]:
                    raise
            else:
                self.form = max(self.form, form, key=FORMS.index)  # another thread may be further
                return answer
        raise AssertionError("the last form returns or raises")

    async def _again(self, request: Request, form: str) -> str:
        """Return an answer in one form; what may pass by itself is tried again."""
        again = tenacity.AsyncRetrying(
            retry=tenacity.retry_if_exception_type(ModelFailure),
            wait=self._wait,
            stop=lambda state: state.attempt_number >= _failure_of(state).tries,
            reraise=True,
        )
        return await again(self._api.ask, request, form)

    def _wait(self, state: tenacity.RetryCallState) -> float:
        """Return the seconds until the next try: what the server asks for, else twice as long each time."""
        return min(self._pause, _failure_of(state).retry_after or 2.0 ** (state.attempt_number - 1))

    def _waited_for(self, work: Coroutine[Any, Any, str]) -> str:
        """Return the result of work on the loop of all models, unless the run is cancelled first."""
        future = asyncio.run_coroutine_threadsafe(work, _loop())
        try:
            while not wait([future], timeout=_GLANCE).done:
                if self._cancelled.is_set():
                    raise Cancelled
            return future.result()
        finally:
            future.cancel()

    def _silent(self, reason: str) -> NoAnswer:
        return NoAnswer(f"{self._name} did not answer: {reason}", mend="rules take over")


def _failure_of(state: tenacity.RetryCallState) -> ModelFailure:
    """Return why the last try failed."""
    failure = state.outcome.exception() if state.outcome else None
    assert isinstance(failure, ModelFailure)
    return failure


@cache
def _loop() -> asyncio.AbstractEventLoop:
    """Return the event loop of all models, in a thread of its own: their connections belong to one loop."""
    loop = asyncio.new_event_loop()
    Thread(target=loop.run_forever, name="models", daemon=True).start()
    return loop

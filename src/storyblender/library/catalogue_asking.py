"""Asks a catalogue beside other work, for a person who looks: for seconds, and not again soon after it failed."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Sequence
from concurrent.futures import Future
from typing import Final, Literal, TypeVar

from storyblender.errors import ServiceFailure
from storyblender.services.offers import Catalogue, Offer
from storyblender.services.web import Missing

REST: Final = 60.0
"""Seconds for which a service that failed is not asked again by a person who looks."""
_Answer = TypeVar("_Answer")
_What = Literal["models", "pictures"]


class Asking:
    """What a person who looks asks of one catalogue. One thread at a time uses it.

    Args:
        catalogue: The service.
    """

    def __init__(self, catalogue: Catalogue) -> None:
        self._catalogue = catalogue
        self._asked: dict[str, Future[Sequence[Offer]]] = {}
        self._failed: dict[_What, tuple[float, ServiceFailure]] = {}

    def models(self, words: str) -> Sequence[Offer] | None:
        """Return what the service has for some words; None while it is being asked.

        Args:
            words: What a thing is called.

        Raises:
            ServiceFailure: It cannot be asked, or failed a moment ago.
        """
        self._refuse_resting("models")
        if words not in self._asked:
            self._asked[words] = _beside(lambda: self._catalogue.find(words, "model", soon=True))
        answer = self._asked[words]
        if not answer.done():
            return None
        if answer.exception() is not None:
            self._asked.clear()
        return self._noted("models", answer.result)

    def thumbnail(self, offer: Offer) -> bytes:
        """Return the small picture of a work; a service that failed is left alone for a while.

        Raises:
            ServiceFailure: There is none, or it cannot be had soon.
        """
        self._refuse_resting("pictures")
        return self._noted("pictures", lambda: self._catalogue.thumbnail(offer))

    def _refuse_resting(self, what: _What) -> None:
        """Raise what went wrong, if that was a moment ago."""
        since, failure = self._failed.get(what, (0.0, None))
        if failure is not None and time.monotonic() < since + REST:
            raise failure

    def _noted(self, what: _What, call: Callable[[], _Answer]) -> _Answer:
        """Return what a call does, and note that it failed; that one thing is missing is no failure of the service."""
        try:
            return call()
        except Missing:
            raise
        except ServiceFailure as failure:
            self._failed[what] = time.monotonic(), failure
            raise


def _beside(call: Callable[[], _Answer]) -> Future[_Answer]:
    """Return what a thread of its own will return."""
    future: Future[_Answer] = Future()

    def run() -> None:
        try:
            future.set_result(call())
        except Exception as error:  # noqa: BLE001 - raised where the answer is asked for
            future.set_exception(error)

    threading.Thread(target=run, name="asking a service", daemon=True).start()
    return future

"""Answerers for tests: a fixed list, and one that knows a finished reading by heart."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from storyblender.memory.request import Request


class Scripted:
    """Answers from a list, and keeps what it was asked.

    Args:
        answers: One a request, in order; an exception is raised.
    """

    def __init__(self, answers: Iterable[str | Exception]) -> None:
        self._answers = iter(answers)
        self.asked: list[Request] = []

    def answer(self, request: Request) -> str:
        self.asked.append(request)
        given = next(self._answers)
        if isinstance(given, Exception):
            raise given
        return given


class Answering:
    """Answers with what a function makes of the projection, and keeps what it was asked."""

    def __init__(self, function: Callable[[dict[str, Any]], dict[str, Any]]) -> None:
        self._function = function
        self.asked: list[Request] = []

    def answer(self, request: Request) -> str:
        self.asked.append(request)
        return json.dumps(self._function(json.loads(request.view)))


class Alike:
    """An embedder that finds every text as near to every other."""

    def embed(self, texts: Sequence[str]) -> NDArray[np.float32]:
        return np.ones((len(texts), 1), np.float32)

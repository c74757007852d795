"""Messages to and from a worker. Every line is untrusted: it is the answer, is skipped, or ends the worker."""

from __future__ import annotations

import json
from typing import Any

PROTOCOL = "2025-06-18"
"""Version of the Model Context Protocol."""
LONGEST = 1 << 26
"""Bytes of the longest line that a worker may say: an answer has some thousands."""
PROGRESS = "notifications/progress"
MOST_STEPS = 10**9
"""More are no number of steps."""
_QUOTED = 200
"""Most characters of a worker's text that an error message quotes."""


class Lost(Exception):
    """The process is gone, or says what is no message."""


class Refused(Exception):
    """The server answered with an error."""


def request_line(message: dict[str, Any]) -> bytes:
    """Return a message as it goes over the wire."""
    return json.dumps({"jsonrpc": "2.0", **message}).encode() + b"\n"


def answer_in(line: bytes, request: int) -> dict[str, Any] | None:
    """Return the result that a line brings for a request, or None where it is about something else.

    Args:
        line: As it was read; without its end where the worker stopped in the middle of it.
        request: Number of the request that waits.

    Raises:
        Lost: The line is no message, or an answer without a result.
        Refused: The answer is an error.
    """
    if len(line) > LONGEST:
        raise Lost(f"a line of more than {LONGEST >> 20} MiB")
    try:
        message = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise Lost(f"no message: {line[:80]!r}") from error
    if not isinstance(message, dict):
        raise Lost(f"no message: {line[:80]!r}")
    number = message.get("id")
    if "method" in message or type(number) is not int or number != request:
        return None
    if "error" in message:
        raise Refused(_words_of(message["error"]))
    result = message.get("result")
    if not isinstance(result, dict):
        raise Lost(f"an answer without a result: {line[:80]!r}")
    return result


def progress_in(line: bytes, request: int) -> tuple[int, int] | None:
    """Return the steps done and their total if a line reports the progress of a request, or None.

    Args:
        line: One that ``answer_in`` accepts as a message but not as the answer.
        request: Number of the request that waits; it is its own progress token.
    """
    message = json.loads(line)
    parameters = message.get("params")
    if message.get("method") != PROGRESS or not isinstance(parameters, dict):
        return None
    token, step, total = (parameters.get(name) for name in ("progressToken", "progress", "total"))
    if type(token) is not int or token != request or not isinstance(step, int | float):
        return None
    return (int(step), int(total)) if isinstance(total, int | float) and 0 <= step <= total < MOST_STEPS else None


def value_in(result: dict[str, Any]) -> Any:
    """Return what a tool gave back.

    Raises:
        Lost: The result is none that a tool gives.
        Refused: The tool failed.
    """
    if result.get("isError"):
        parts = result.get("content")
        words = [_words_of(part, "text") for part in parts] if isinstance(parts, list) else []
        raise Refused(" ".join(words) or "failed without a word")
    content = result.get("structuredContent")
    if not isinstance(content, dict):
        raise Lost("an answer without structured content")
    return content["result"] if set(content) == {"result"} else content


def _words_of(part: object, field: str = "message") -> str:
    words = part.get(field) if isinstance(part, dict) else part
    return words if isinstance(words, str) else repr(words)[:_QUOTED]

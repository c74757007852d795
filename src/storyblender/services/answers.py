"""What services say beside what they were asked for: how long to wait, and why they refuse."""

from __future__ import annotations

import json
import math
from datetime import UTC, datetime
from email.utils import parsedate_to_datetime
from typing import Any

from storyblender.services.offers import line_of

_PLACES = ("error", "message", "detail", "Response", "Error", "Message")
"""Names under which services put what went wrong; some put one in the other."""


def pause_asked_for(text: str) -> float | None:
    """Return the seconds of a Retry-After header, which has a number or a date; None if it has neither."""
    try:
        seconds = float(text)
    except ValueError:
        try:
            seconds = (parsedate_to_datetime(text) - datetime.now(UTC)).total_seconds()
        except (ValueError, TypeError):
            return None
    return max(0.0, seconds) if math.isfinite(seconds) else None


def said_in(content: bytes) -> str:
    """Return the sentence of an error, if the answer has one in any of the usual places; one line, cut."""
    try:
        value: Any = json.loads(content)
    except (ValueError, RecursionError):
        return ""
    for _ in range(3):
        if isinstance(value, str):
            return line_of(value)
        if not isinstance(value, dict):
            return ""
        value = next(
            (value[name] for name in ("error", "message", "detail", "Response", "Error") if value.get(name)), ""
        )
    return line_of(value)

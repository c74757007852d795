"""One test for a property of many things: each is checked, and all that fail are told in one message."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable
from typing import Any

from storyblender.errors import StoryBlenderError

FAILURES = (AssertionError, ArithmeticError, AttributeError, LookupError, RuntimeError, StoryBlenderError, TypeError,
            ValueError, Warning)  # fmt: skip
Test = Callable[..., None]


def every(names: str, cases: Iterable[Any] | Callable[[], Iterable[Any]]) -> Callable[[Test], Test]:
    """Run the body of a test for each case, as one test that fails with the names of all cases that failed.

    Args:
        names: The arguments that a case gives, parted by spaces; what else the body takes are fixtures, which
            all cases share.
        cases: A value for each case, or a tuple of values where there are several names; or a function that makes
            them when the test is run.
    """
    given = names.split()
    kept = cases if callable(cases) else list(cases)

    def gathered(body: Test) -> Test:
        @functools.wraps(body)
        def test(**fixtures: Any) -> None:
            made = [case if len(given) > 1 else (case,) for case in (kept() if callable(kept) else kept)]
            assert made, "no case was checked"
            failed: list[tuple[str, Exception]] = []
            for values in made:
                try:
                    body(**dict(zip(given, values, strict=True)), **fixtures)
                except FAILURES as error:
                    failed.append((_label(values), error))
            told = "".join(f"\n* {label}: {_said(error)}" for label, error in failed)
            if failed:
                raise AssertionError(f"{len(failed)} of {len(made)} cases failed:{told}") from failed[0][1]

        parameters = inspect.signature(body).parameters.values()
        test.__signature__ = inspect.Signature([one for one in parameters if one.name not in given])  # type: ignore[attr-defined]
        return test

    return gathered


def _label(values: Iterable[Any]) -> str:
    """Return what tells a case apart: its plain values, or the key of the thing."""
    told = (value if isinstance(value, str | int | float) else getattr(value, "key", None) for value in values)
    return " ".join(str(one) for one in told if one is not None)


def _said(error: Exception) -> str:
    return f"{type(error).__name__}: {error}".replace("\n", "\n  ")[:400]

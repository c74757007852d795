"""A gathered test fails for any of its cases, and names all that failed."""

from __future__ import annotations

import inspect

import pytest
from tests.every import every

from storyblender.errors import InputError


def test_all_cases_that_fail_are_named_and_no_other() -> None:
    @every("number", [1, 2, 3, 4])
    def odd(number: int) -> None:
        if number == 4:
            raise InputError("four cannot be used")
        assert number % 2, "it is even"

    with pytest.raises(AssertionError) as caught:
        odd()
    lines = str(caught.value).splitlines()
    assert lines[0] == "2 of 4 cases failed:"
    assert [line for line in lines if line.startswith("*")] == [
        "* 2: AssertionError: it is even",
        "* 4: InputError: four cannot be used",
    ]
    assert isinstance(caught.value.__cause__, AssertionError)


def test_cases_are_made_when_the_test_runs_and_fixtures_are_passed_on(tmp_path) -> None:
    seen = []

    @every("word number", lambda: zip("ab", (1, 2), strict=True))
    def one(word: str, number: int, tmp_path) -> None:
        seen.append((word, number, tmp_path))

    assert list(inspect.signature(one).parameters) == ["tmp_path"]
    one(tmp_path=tmp_path)
    assert seen == [("a", 1, tmp_path), ("b", 2, tmp_path)]


def test_a_property_of_nothing_is_no_test() -> None:
    @every("number", [])
    def none(number: int) -> None:
        assert number

    with pytest.raises(AssertionError, match="no case was checked"):
        none()

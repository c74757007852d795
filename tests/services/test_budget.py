"""A budget ends what a run spends, however many threads spend it."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import pytest

from storyblender.errors import ServiceFailure
from storyblender.services.budget import ServiceBudget


def test_nothing_is_spent_that_is_more_than_what_is_left() -> None:
    budget = ServiceBudget({"dollars": 1})
    for _ in range(3):
        budget.spend("dollars", 0.3)
    with pytest.raises(ServiceFailure, match=r"limit of 1 dollars.*\[service_limits\]"):
        budget.spend("dollars", 0.3)
    with pytest.raises(ServiceFailure):
        budget.ask("dollars", 0.2)
    budget.ask("dollars", 0.1)
    assert budget.left("dollars") == pytest.approx(0.1)
    budget.give_back("dollars", 0.3)
    budget.spend("dollars", 0.4)
    assert budget.left("dollars") == pytest.approx(0)


def test_threads_cannot_spend_more_than_there_is() -> None:
    budget = ServiceBudget({"dollars": 10})

    def spend(_: int) -> bool:
        try:
            budget.spend("dollars", 1)
        except ServiceFailure:
            return False
        return True

    with ThreadPoolExecutor(8) as pool:
        assert sum(pool.map(spend, range(100))) == 10

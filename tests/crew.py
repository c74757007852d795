"""The crew of rules as tests use it: one that needs no sentence model."""

from __future__ import annotations

from typing import NoReturn

import pytest

from storyblender.crew import Crew, rules_crew
from storyblender.library.sources import asset_sources
from storyblender.settings import Settings


def no_words() -> NoReturn:
    """Fail: the test compares no words by meaning."""
    pytest.fail("no words are compared")


def crew_of(settings: Settings | None = None) -> Crew:
    """Return the crew of rules for some settings."""
    settings = settings or Settings()
    return rules_crew(settings, no_words, asset_sources(settings, no_words))


RULES = crew_of()

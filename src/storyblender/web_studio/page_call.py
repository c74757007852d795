"""What every call of the page has."""

from __future__ import annotations

from pydantic import Field

from storyblender.memory.base import Described


class PageCall(Described):
    """A call of a browser."""

    id: int = Field(ge=0, le=2**53)
    """Number that the answer names."""

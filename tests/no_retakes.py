"""For tests that draw with a stand-in for Blender, which sees nothing in a frame, so that each would be taken again."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from storyblender.pipeline import retaking


@pytest.fixture(scope="session", autouse=True)
def no_retakes() -> Iterator[None]:
    """Take no frame again."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(retaking, "_STEPS", ())
        yield

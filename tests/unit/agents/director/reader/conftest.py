from collections.abc import Callable

import pytest

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read

Read = Callable[[str], Reading]


@pytest.fixture
def read_scene() -> Read:
    """Read action written under one heading."""
    return lambda action: read_script(read(f"INT. ROOM - DAY\n\n{action}\n"))

"""Props that plain words mean in the age of a story: today a phone is a smartphone, once a telephone. Data only."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from storyblender.memory.vocabulary import Age

WORDS_BY_AGE: Final[Mapping[Age, Mapping[str, str]]] = {
    "today": {"phone": "smartphone"},
    "classic": {"phone": "telephone", "camera": "photo_camera"},
    "victorian": {"lamp": "lantern", "carriage": "cart"},
    "west": {"lamp": "lantern", "wagon": "cart"},
    "medieval": {"lamp": "lantern"},
}
"""Age -> word -> key of a prop. A set kit's own ``means`` takes precedence."""
OVERHEAD_OUTDOORS: Final[Mapping[str, str]] = {"table_lamp": "lamppost", "floor_lamp": "lamppost"}
"""Key of a lamp -> the lamp that stands in its place outdoors, where a character or a thing is under it."""

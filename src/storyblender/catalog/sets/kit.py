"""What a set kit is: a name, its words, the sizes it works at, and the function that draws it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np

from storyblender.catalog.registry import ParamValue
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import Period, SetParams


@dataclass(frozen=True)
class Span:
    """Smallest, usual and largest value of a dimension in metres."""

    least: float
    usual: float
    most: float

    def clamp(self, value: float) -> float:
        """Return ``value`` kept inside the span."""
        return min(max(value, self.least), self.most)


@dataclass(frozen=True)
class SetKit:
    """One kind of place.

    Args:
        key: snake_case key of the kit.
        name: Display name.
        tags: Words in scene headings that mean this place, the strongest first.
        indoor: Whether the place is indoors.
        draw: Pure function ``(params, rng)`` of the set's parameters, dimensions already within the spans, and a seeded
            generator. Returns the plan in the world frame, metres; raises InputError if its kit file is invalid.
        width: Span in x.
        depth: Span in y.
        height: Span of the ceiling; ignored outdoors.
        period: When the place is usually set.
        options: The kit's own parameters and their defaults.
        means: Word -> prop that it means here: a bed in a ward is a hospital bed.
        has: Words for objects that its pieces include already, such as the mirror of a car: no prop is added for them.
        seated: Whether characters already here sit unless the script says otherwise.
        on_foot: Occupations that stand here nevertheless: the steward of a cabin.
        description: Visible contents in a sentence or two.
        counterpart: The kit for EXT. of this indoor place, or for INT. of this outdoor one; empty for the default.
        told_by: Objects and occupations that suggest this place if no word of the heading does, with their scores.
        option_words: Words in the place name that turn an option on.
        room: The sort of room whose belongings fill its bare walls and tops, a key of ``belongings.ROOMS``.
    """

    key: str
    name: str
    tags: tuple[str, ...]
    indoor: bool
    draw: Callable[[SetParams, np.random.Generator], SetPlan]
    width: Span
    depth: Span
    height: Span = Span(2.4, 2.8, 4.0)
    period: Period = "classic"
    options: Mapping[str, ParamValue] = field(default_factory=dict)
    means: Mapping[str, str] = field(default_factory=dict)
    has: tuple[str, ...] = ()
    seated: bool = False
    on_foot: tuple[str, ...] = ()
    description: str = ""
    counterpart: str = ""
    told_by: Mapping[str, int] = field(default_factory=dict)
    option_words: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    room: str = ""

    @property
    def meanings(self) -> Mapping[str, str]:
        """Word -> prop that it means here; indoors a tree is a Christmas tree unless the kit says otherwise."""
        return {"tree": "christmas_tree", **self.means} if self.indoor else self.means

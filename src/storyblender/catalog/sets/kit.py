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
        name: Name for people.
        tags: Words of headings that mean this place, the strongest first.
        indoor: False where the sky is the ceiling.
        draw: The kit's plan as a pure function of its parameters and a seeded generator.
        width: Span in x.
        depth: Span in y.
        height: Span of the ceiling; ignored outdoors.
        period: When the place is usually set.
        options: The kit's own parameters and their defaults.
        means: What plain words mean here, prop for prop: a bed in a ward is a hospital bed.
        has: Words for what its pieces are already, such as the mirror of a car: nothing else is put there for them.
        seated: Everybody who is found here sits unless the script says otherwise.
        on_foot: Trades that stand here all the same: the steward of a cabin.
        description: What is to be seen there, in a sentence or two.
        counterpart: The kit for EXT. of this indoor place, or for INT. of this outdoor one; empty for the usual.
        told_by: Things and trades that tell this place where no word of the heading does, with their points.
        option_words: Words of the place that turn an option on.
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

    @property
    def meanings(self) -> Mapping[str, str]:
        """What plain words mean here; under a ceiling a tree is one that somebody brought in."""
        return {"tree": "christmas_tree", **self.means} if self.indoor else self.means

"""What a run may ask of models in all, and what it has asked for so far."""

from __future__ import annotations

from collections.abc import Mapping

from storyblender.crew_setting import LIMITS, LimitName
from storyblender.errors import NoAnswer


class Budget:
    """Requests, tokens and US dollars, shared by all models of a run.

    Args:
        limits: The most of each, where it is not that of ``LIMITS``.

    Attributes:
        spent: What was used so far. Dollars count for models of a known price only.
    """

    def __init__(self, limits: Mapping[LimitName, float]) -> None:
        self._limits = {**LIMITS, **limits}
        self.spent: dict[LimitName, float] = dict.fromkeys(LIMITS, 0.0)

    def check(self) -> None:
        """Raise NoAnswer if nothing more may be asked."""
        for name in LIMITS:
            limit = self._limits[name]
            if self.spent[name] >= limit:
                mend = f"rules take over; a higher `{name}` under [limits] in storyblender.toml lets models go on"
                raise NoAnswer(f"the limit of {limit:g} {name} is reached", mend=mend)

    def spend(self, **used: float) -> None:
        """Count what was used, by the names of the limits."""
        for name in LIMITS:
            self.spent[name] += used.get(name, 0.0)

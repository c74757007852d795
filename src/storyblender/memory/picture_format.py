"""The shape of the picture and the sensor behind the lens: as people name them, and as a person decided them."""

from __future__ import annotations

import math
from typing import Annotated, Any, Final, Self

from pydantic import BeforeValidator, Field

from storyblender.memory.base import Described, is_none

LARGEST: Final = 7680
"""Pixels across and down."""
ASPECTS: Final[dict[str, float]] = {
    "16:9": 16 / 9, "1.85:1": 1.85, "2.39:1": 2.39, "4:3": 4 / 3, "1:1": 1.0, "9:16": 9 / 16
}  # fmt: skip
"""Width over height of usual pictures."""
SENSORS: Final[dict[str, float]] = {"Super 16": 12.52, "Super 35": 24.89, "full frame": 36.0, "65 mm film": 52.48}
"""Widths in mm of usual sensors and film gates."""


def _ratio(value: Any) -> Any:
    """Return a ratio written as people write it, ``16:9`` or ``2.39:1``, as the number that it is."""
    wide, colon, high = value.partition(":") if isinstance(value, str) else (value, "", "")
    try:
        return float(wide) / float(high) if colon else value
    except (ValueError, ZeroDivisionError):
        return value


def _width(value: Any) -> Any:
    """Return the width of a sensor that is called by its name."""
    named = {name.replace(" ", "").lower(): width for name, width in SENSORS.items()}
    return named.get(value.replace(" ", "").lower(), value) if isinstance(value, str) else value


Aspect = Annotated[float, BeforeValidator(_ratio), Field(ge=0.4, le=4)]
"""Width over height of the picture."""
SensorWidth = Annotated[float, BeforeValidator(_width), Field(ge=4, le=70)]
"""mm."""


class FormatDecision(Described):
    """What a person decided about the picture of the film; what is left out is as the settings have it."""

    aspect: Aspect | None = Field(default=None, exclude_if=is_none)
    """Width over height: 2.39, 1.85, ``16:9`` ..."""
    sensor_width: SensorWidth | None = Field(default=None, exclude_if=is_none)
    """mm: 36 is full frame, 24.89 Super 35; a narrower one sees less through the same lens."""

    @property
    def words(self) -> str:
        """The decision as a person reads it, e.g. ``aspect 2.39:1, sensor Super 35 (24.89 mm)``."""
        said: list[str] = []
        if self.aspect is not None:
            said.append(f"aspect {_named(ASPECTS, self.aspect) or f'{self.aspect:.4g}:1'}")
        if self.sensor_width is not None:
            name, width = _named(SENSORS, self.sensor_width), f"{self.sensor_width:.4g} mm"
            said.append(f"sensor {name} ({width})" if name else f"sensor {width} wide")
        return ", ".join(said)

    def then(self, later: Self) -> Self:
        """Return this decision with a later one on top."""
        return self.model_copy(update=later.told)

    @property
    def told(self) -> dict[str, float]:
        """What it says, by field, as ``ProjectFormat`` has them."""
        return {name: value for name, value in self if value is not None}


def _named(known: dict[str, float], value: float) -> str:
    return next((name for name, usual in known.items() if math.isclose(usual, value, rel_tol=1e-3)), "")

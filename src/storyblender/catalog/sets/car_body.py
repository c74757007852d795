"""Where the parts of a car are, metres: its plan and its builder read the same numbers. Nose at -Y."""

from __future__ import annotations

from typing import Final

HALF: Final = 0.86
"""From the middle to a door."""
BELT: Final = 0.86
"""Height of the lower edge of the windows."""
ROOF: Final = 1.52
"""Height of its lining: a head is clear of it."""
SCREEN: Final = (-1.22, -0.62)
"""Y of the windscreen's foot and head."""
REAR: Final = (1.36, 1.02)
"""Y of the rear window's foot and head."""
NOSE: Final = -2.3
TAIL: Final = 2.1
"""Y of both ends."""

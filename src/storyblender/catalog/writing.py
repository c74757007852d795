"""Text areas of props: side, position, size, background material and ink. Data only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

MAX_LETTERS = 90
"""Maximum number of characters shown; longer text is cut off."""


@dataclass(frozen=True)
class Writing:
    """Text area of a prop; lengths are fractions of the prop's size.

    Attributes:
        side: ``front`` is seen from -Y, ``top`` from above.
        middle: Centre of the text area, across and up from the prop's centre, -0.5 to 0.5.
        size: Width and height of the text area.
        ground: Material of the plate behind the words, empty for none.
        ink: Material of the letters.
    """

    side: Literal["front", "top"]
    middle: tuple[float, float]
    size: tuple[float, float]
    ground: str
    ink: str


_PAPER = Writing("top", (0.0, 0.0), (0.86, 0.86), "paper", "plastic_black")
_SCREEN = ("glass_dark", "lamp_cool")

CALL_WORDS = frozenset(
    {"call", "calls", "calling", "facetime", "skype", "zoom", "conference", "caller", "livestream", "selfie"}
)
"""Words about a screen that tell of a face on it."""
WRITING: dict[str, Writing] = {
    "door": Writing("front", (0.0, 0.2), (0.6, 0.09), "wood_dark", "brass"),
    "letter": _PAPER,
    "clipboard": Writing("top", (0.0, -0.06), (0.8, 0.7), "paper", "plastic_black"),
    "newspaper": Writing("top", (0.0, 0.32), (0.9, 0.26), "paper", "plastic_black"),
    "envelope": Writing("top", (0.05, -0.12), (0.7, 0.5), "", "plastic_black"),
    "book": Writing("top", (0.0, 0.08), (0.8, 0.5), "", "brass"),
    "folder": Writing("top", (0.1, -0.2), (0.6, 0.24), "paper", "plastic_black"),
    "passport": Writing("top", (0.0, 0.3), (0.8, 0.24), "", "brass"),
    "smartphone": Writing("top", (0.0, 0.05), (0.86, 0.7), *_SCREEN),
    "tablet": Writing("top", (0.0, 0.0), (0.84, 0.8), *_SCREEN),
    "street_sign": Writing("front", (0.0, 0.403), (0.86, 0.11), "paint", "wax"),
    "sandwich_board": Writing("front", (0.0, 0.05), (0.68, 0.62), "plastic_black", "wax"),
    "neon_sign": Writing("front", (0.0, 0.0), (0.84, 0.66), "plastic_black", "neon_red"),
    "notice_board": Writing("front", (0.0, 0.0), (0.7, 0.7), "paper", "plastic_black"),
    "blackboard": Writing("front", (0.0, 0.04), (0.86, 0.74), "plastic_black", "wax"),
    "whiteboard": Writing("front", (0.0, 0.04), (0.88, 0.78), "porcelain", "fabric_blue"),
    "laptop": Writing("front", (0.0, 0.12), (0.82, 0.6), *_SCREEN),
    "computer": Writing("front", (0.0, 0.16), (0.78, 0.48), *_SCREEN),
    "television": Writing("front", (-0.1, -0.08), (0.5, 0.26), *_SCREEN),
    "gravestone": Writing("front", (0.0, 0.06), (0.76, 0.5), "rock", "plastic_black"),
    "picture": Writing("front", (0.0, 0.0), (0.74, 0.66), "paper", "plastic_black"),
    "cardboard_box": Writing("front", (0.0, 0.0), (0.84, 0.5), "", "plastic_black"),
    "crate": Writing("front", (0.0, 0.0), (0.8, 0.4), "", "plastic_black"),
    "calendar": Writing("front", (0.0, 0.24), (0.84, 0.4), "paper", "fabric_red"),
    "suitcase": Writing("front", (0.0, -0.1), (0.4, 0.2), "paper", "plastic_black"),
    "placard": Writing("front", (0.0, 0.27), (0.92, 0.4), "", "plastic_black"),
    "banner": Writing("front", (0.0, 0.3), (0.9, 0.3), "", "fabric_red"),
    "poster": Writing("front", (0.0, 0.0), (0.9, 0.86), "", "plastic_black"),
    "sign_board": Writing("front", (0.0, 0.24), (0.9, 0.42), "", "wax"),
    "wall_sign": Writing("front", (0.0, 0.0), (0.9, 0.8), "", "plastic_black"),
    "shop_sign": Writing("front", (0.0, 0.37), (0.9, 0.15), "", "brass"),
    "mailbox": Writing("front", (0.0, 0.2), (0.7, 0.12), "", "wax"),
    "van": Writing("front", (0.0, -0.1), (0.5, 0.1), "", "wax"),
    "trophy": Writing("front", (0.0, -0.4), (0.5, 0.14), "brass", "plastic_black"),
    "gift": Writing("top", (0.2, -0.25), (0.5, 0.34), "paper", "plastic_black"),
    "cake": Writing("top", (0.0, -0.05), (0.6, 0.4), "", "fabric_red"),
    "jar": Writing("front", (0.0, -0.05), (0.8, 0.4), "paper", "plastic_black"),
    "bottle": Writing("front", (0.0, -0.2), (0.9, 0.24), "paper", "plastic_black"),
}
"""Text area by prop key."""
SCREENS = frozenset(key for key, area in WRITING.items() if (area.ground, area.ink) == _SCREEN)
"""Keys of what has a screen."""

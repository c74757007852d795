"""What a POV looks through, from the words of its note."""

from __future__ import annotations

import re
from typing import Final

from storyblender.memory.vocabulary import Aperture

_WORDS: Final[dict[Aperture, str]] = {
    "binoculars": r"binocular|field.?glass|opera.?glass",
    "keyhole": r"key.?hole",
    "scope": r"scope\b|sights?\b|cross.?hair|rifle",
    "tube": r"telescope|spyglass|periscope|peep|porthole|lens\b|microscope|magnif|eyepiece|monocle|hole",
    "viewfinder": r"view.?finder|camera|camcorder|phone|screen|monitor",
    "slats": r"blind|slat|shutter|louvre|grill|grate|vent",
    "bars": r"bars|fence|railing|cage",
    "panes": r"window|windscreen|windshield|pane|glass",
    "gap": r"crack|gap|slit|ajar|door|curtain|between|letter.?box|branches|leaves",
}
"""Kind of aperture to the word prefixes that name it; the first match wins."""


def aperture_of(words: str) -> Aperture | None:
    """Return the aperture that words name, e.g. ``the Venetian blinds`` -> ``slats``; None if they name none."""
    return next((kind for kind, named in _WORDS.items() if re.search(rf"\b(?:{named})", words.lower())), None)

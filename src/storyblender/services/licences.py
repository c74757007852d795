"""Licences of works from outside: one name for each, and what it allows.

A storyboard changes what it shows: things are scaled, simplified and painted, and their pictures are passed on. So a
work that may not be changed, or that is for news only, is never used, and neither is one without a known licence.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Final

from storyblender.service_setting import LicenceFilter


@dataclass(frozen=True)
class Licence:
    """A licence.

    Attributes:
        name: As in the SPDX list where it is there, else its owner's name for it; empty if it is not known.
        url: Its text.
        usable: Whether a work may be changed and shown in a story.
        commercial: Whether for commercial use too.
        free: Whether the work is given to the public domain.
    """

    name: str = ""
    url: str = ""
    usable: bool = False
    commercial: bool = False
    free: bool = False


_CREATIVE = "https://creativecommons.org"
_STORE = "https://sketchfab.com/licenses"
UNKNOWN: Final = Licence()
CC0: Final = Licence("CC0-1.0", f"{_CREATIVE}/publicdomain/zero/1.0/", usable=True, commercial=True, free=True)
_STORE_LICENCES: Final = {
    "st": Licence("Sketchfab Standard", _STORE, usable=True, commercial=True),
    "freest": Licence("Sketchfab Free Standard", _STORE, usable=True, commercial=True),
    "ed": Licence("Sketchfab Editorial", _STORE),
}
"""Slug, of letters only -> what it is. Their texts allow works in pictures, and forbid passing on the models."""
NOT_PASSED_ON: Final = frozenset(licence.name for licence in _STORE_LICENCES.values())
"""Names of the licences that forbid passing on a model itself, also inside of a scene."""
_STORE_NAMES: Final = {"standard": "st", "free standard": "freest", "editorial": "ed"}
_PARTS: Final = {
    "attribution": "by", "noncommercial": "nc", "non commercial": "nc", "sharealike": "sa", "share alike": "sa",
    "noderivs": "nd", "no derivs": "nd", "noderivatives": "nd", "no derivatives": "nd",
}  # fmt: skip
_VERSION = re.compile(r"\b([1-4]\.[0-9])\b")
_CC0 = re.compile(r"\bcc0\b|publicdomain/zero|\bcc zero\b|public domain dedication")
_CODES = ("by", "nc", "sa", "nd")


def licence_of(text: str) -> Licence:
    """Return the licence that a slug, a name or a URL means.

    Args:
        text: Such as ``by-nc``, ``CC Attribution``, ``CC BY 4.0``, ``http://creativecommons.org/licenses/by/4.0/``.
    """
    told = text.strip().lower()[:200]
    if _CC0.search(told):
        return CC0
    plain = re.sub(r"[^a-z]+", " ", told).strip()
    if (store := _STORE_LICENCES.get(_STORE_NAMES.get(plain, plain.replace(" ", "")))) is not None:
        return store
    for name, code in _PARTS.items():
        plain = re.sub(rf"\b{name}\b", code, plain)
    words = plain.split()
    codes = [code for code in _CODES if code in words]
    ours = all(word in (*_CODES, "cc", "creative", "commons") or "/" in told for word in words)
    if "by" not in codes or not ours or ("/" in told and "creativecommons.org/licenses/" not in told):
        return UNKNOWN
    version = found[1] if (found := _VERSION.search(told)) else "4.0"
    return Licence(
        name=f"CC-{'-'.join(codes).upper()}-{version}",
        url=f"{_CREATIVE}/licenses/{'-'.join(codes)}/{version}/",
        usable="nd" not in codes,
        commercial="nc" not in codes and "nd" not in codes,
    )


def is_allowed(licence: Licence, wanted: LicenceFilter) -> bool:
    """Tell whether a work of a licence may be used under the filter of the settings."""
    return licence.usable and (wanted == "any" or (licence.commercial if wanted == "commercial" else licence.free))

"""Words of the command line about how a person looks become an edit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from difflib import get_close_matches

from storyblender.catalog.garments import GARMENTS
from storyblender.catalog.wardrobe import color_named, garment_named
from storyblender.edits.targets import as_id
from storyblender.edits.words import edits_of
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Garment
from storyblender.memory.edits import Edit


def look_edit(person: str, said: Mapping[str, object], wear: Sequence[str] = (), take_off: Sequence[str] = ()) -> Edit:
    """Read what a person says about how a character looks.

    Args:
        person: Their id or name.
        said: Fields of ``LookDecision``, a colour as a word or a hex code; None says nothing.
        wear: What they put on: ``red coat``.
        take_off: What they take off: ``hat``.

    Raises:
        InputError: A word or a number cannot be.
    """
    given = {name: value for name, value in said.items() if value is not None}
    if "hair" in given:
        given["hair"] = as_id(str(given["hair"]))
    if "hair_color" in given:
        color = color_named(str(given["hair_color"]))
        if color is None:
            raise InputError(f"{given['hair_color']!r} is no colour", mend="say black, brown, red ..., or #6b4a30")
        given["hair_color"] = color
    put_on = [_garment(each).model_dump() for each in wear]
    off = [_garment(each).key for each in take_off]
    [edit] = edits_of([{"kind": "look", "person": person, "decision": given, "wear": put_on, "take_off": off}])
    return edit


def _garment(words: str) -> Garment:
    """Return the garment that words name. Raises InputError."""
    found = garment_named(words)
    if found is None:
        known = [name for each in GARMENTS.values() for name in (each.name, *each.tags)]
        near = get_close_matches(words.lower(), known, n=3, cutoff=0.5)
        mend = f"did you mean {', '.join(near)}?" if near else "`storyblender catalog garments` lists them"
        raise InputError(f"there is no garment {words!r}", mend=mend)
    return found

"""What a licence is called, and what the filter of the settings lets pass."""

from __future__ import annotations

import pytest

from storyblender.services.licences import is_allowed, licence_of

NAMES = {
    "CC0-1.0": ["cc0", "CC0", "CC0 Public Domain", "https://creativecommons.org/publicdomain/zero/1.0/", "CC0-1.0"],
    "CC-BY-4.0": ["by", "CC Attribution", "cc-by-4.0", "CC BY 4.0", "http://creativecommons.org/licenses/by/4.0/"],
    "CC-BY-3.0": ["http://creativecommons.org/licenses/by/3.0/"],
    "CC-BY-SA-4.0": ["by-sa", "CC Attribution-ShareAlike", "CC-BY-SA-4.0"],
    "CC-BY-NC-4.0": ["by-nc", "CC Attribution-NonCommercial", "CC BY-NC 4.0"],
    "CC-BY-NC-SA-4.0": ["by-nc-sa", "CC Attribution-NonCommercial-ShareAlike"],
    "CC-BY-ND-4.0": ["by-nd", "CC Attribution-NoDerivs"],
    "CC-BY-NC-ND-4.0": ["by-nc-nd", "CC Attribution-NonCommercial-NoDerivs"],
    "Sketchfab Standard": ["st", "Standard"],
    "Sketchfab Free Standard": ["free-st", "Free Standard"],
    "Sketchfab Editorial": ["ed", "Editorial"],
    "": ["", "by permission of the author", "all rights reserved", "https://evil.example/licenses/by/4.0/", "x" * 9999,
         "stand by", "no", "CC", "st-nick"],
}  # fmt: skip


@pytest.mark.parametrize(("name", "text"), [(name, text) for name, texts in NAMES.items() for text in texts])
def test_a_licence_has_one_name_however_it_is_written(name: str, text: str) -> None:
    assert licence_of(text).name == name


ALLOWED = {
    "any": {"cc0", "by", "by-sa", "by-nc", "by-nc-sa", "st", "free-st"},
    "commercial": {"cc0", "by", "by-sa", "st", "free-st"},
    "free": {"cc0"},
}
EVERY = ("cc0", "by", "by-sa", "by-nc", "by-nc-sa", "by-nd", "by-nc-nd", "st", "free-st", "ed", "", "whatever")


@pytest.mark.parametrize("wanted", ["any", "commercial", "free"])
def test_a_filter_lets_pass_what_it_says(wanted: str) -> None:
    assert {slug for slug in EVERY if is_allowed(licence_of(slug), wanted)} == ALLOWED[wanted]  # type: ignore[arg-type]

"""The built-in props: entries by category, one catalog."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry
from storyblender.catalog.props.fittings import FITTINGS
from storyblender.catalog.props.furniture import FURNITURE
from storyblender.catalog.props.hand import HAND_PROPS
from storyblender.catalog.props.outdoors import ANIMALS, NATURE, STREET, VEHICLES
from storyblender.catalog.registry import Catalog

__all__ = ["PROPS", "PropEntry"]

PROPS: Catalog[PropEntry] = Catalog("prop", FURNITURE + FITTINGS + HAND_PROPS + VEHICLES + STREET + NATURE + ANIMALS)
"""In the order they are listed to people."""

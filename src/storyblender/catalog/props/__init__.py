"""The built-in props: entries by category, one catalog."""

from __future__ import annotations

from storyblender.catalog.props.beasts import BEASTS
from storyblender.catalog.props.carried import CARRIED
from storyblender.catalog.props.entry import PropEntry
from storyblender.catalog.props.fittings import FITTINGS
from storyblender.catalog.props.furniture import FURNITURE
from storyblender.catalog.props.machines import MACHINES
from storyblender.catalog.props.nature import ANIMALS, NATURE
from storyblender.catalog.props.places import PLACES
from storyblender.catalog.props.seats import SEATS
from storyblender.catalog.props.street import STREET
from storyblender.catalog.props.table_and_desk import TABLE_AND_DESK
from storyblender.catalog.props.vehicles import VEHICLES
from storyblender.catalog.registry import Catalog

__all__ = ["PROPS", "PropEntry"]

PROPS: Catalog[PropEntry] = Catalog(
    "prop",
    SEATS
    + FURNITURE
    + FITTINGS
    + MACHINES
    + TABLE_AND_DESK
    + CARRIED
    + VEHICLES
    + STREET
    + PLACES
    + NATURE
    + ANIMALS
    + BEASTS,
)
"""In the order they are listed to people."""

"""The built-in props: entries by category, one catalog."""

from __future__ import annotations

from storyblender.catalog.props.beasts import BEASTS
from storyblender.catalog.props.carried import CARRIED
from storyblender.catalog.props.commonplace import COMMONPLACE
from storyblender.catalog.props.entry import PropEntry
from storyblender.catalog.props.errands import ERRANDS
from storyblender.catalog.props.everyday import EVERYDAY
from storyblender.catalog.props.fittings import FITTINGS
from storyblender.catalog.props.furniture import FURNITURE
from storyblender.catalog.props.household import HOUSEHOLD
from storyblender.catalog.props.laboratory import LABORATORY
from storyblender.catalog.props.machines import MACHINES
from storyblender.catalog.props.music_and_sport import MUSIC_AND_SPORT
from storyblender.catalog.props.nature import ANIMALS, NATURE
from storyblender.catalog.props.ordinary import ORDINARY
from storyblender.catalog.props.pantry import PANTRY
from storyblender.catalog.props.partitions import PARTITIONS
from storyblender.catalog.props.places import PLACES
from storyblender.catalog.props.rooms import ROOMS
from storyblender.catalog.props.seats import SEATS
from storyblender.catalog.props.signs import SIGNS
from storyblender.catalog.props.street import STREET
from storyblender.catalog.props.table_and_desk import TABLE_AND_DESK
from storyblender.catalog.props.vehicles import VEHICLES
from storyblender.catalog.props.wildlife import WILDLIFE
from storyblender.catalog.props.yard import YARD
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
    + SIGNS
    + PLACES
    + NATURE
    + ANIMALS
    + BEASTS
    + WILDLIFE
    + PANTRY
    + HOUSEHOLD
    + LABORATORY
    + MUSIC_AND_SPORT
    + YARD
    + ROOMS
    + EVERYDAY
    + ERRANDS
    + ORDINARY
    + COMMONPLACE
    + PARTITIONS,
)
"""In the order they are listed to people."""

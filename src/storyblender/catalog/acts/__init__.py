"""Acts: motions defined as rows of key poses. ``blender/motion/clips/acts.py`` plays them all."""

from __future__ import annotations

from storyblender.catalog.acts.arts import ARTS
from storyblender.catalog.acts.bearing import BEARING
from storyblender.catalog.acts.bodies import BODIES
from storyblender.catalog.acts.chores import CHORES
from storyblender.catalog.acts.entry import Act
from storyblender.catalog.acts.signs import SIGNS
from storyblender.catalog.registry import Catalog

ACTS: Catalog[Act] = Catalog("act", (*SIGNS, *BEARING, *BODIES, *CHORES, *ARTS))
"""All acts, by key."""

__all__ = ["ACTS", "Act"]

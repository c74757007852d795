"""Builds stand-ins: the plain shape of a class of objects that no catalog prop resembles."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, two_hands
from storyblender.blender.props.build import PropBuild, settle
from storyblender.catalog.stand_ins import DEFAULT, STAND_INS, StandIn
from storyblender.memory.asset_sheet import AssetDimension

CONE = (1.0, 0.98, 0.42, 0.12, 0.05)
"""Width of the cone from foot to tip."""


def build_stand_in(key: str, dimension: AssetDimension | None = None) -> PropBuild:
    """Build the stand-in of a thing.

    Args:
        key: A key of ``catalog.stand_ins``; an unknown one gives the default class.
        dimension: The wanted size.
    """
    entry = STAND_INS.get(key, STAND_INS[DEFAULT])
    builder = MeshBuilder(f"stand_in_{entry.key}")
    _body(builder, entry)
    return settle(builder.mesh(), _grips(entry), dimension)


def _body(b: MeshBuilder, entry: StandIn) -> None:
    """Add the plain shape of a class of things."""
    (w, d, h), skin = entry.size, entry.material
    edge = 0.08 * min(w, d, h)
    match entry.shape:
        case "box":
            b.rounded_box(skin, (0, 0, h * 0.36), (w * 0.98, d * 0.98, h * 0.72), edge)
            b.rounded_box(skin, (0, 0, h * 0.86), (w, d, h * 0.28), edge)
        case "slab":
            b.box(skin, (0, 0, h / 2), (w, d, h), bevel=edge)
        case "drum":
            r = w / 2
            b.lathe(skin, [(r - edge, 0), (r, edge), (r, h - edge), (r - edge, h)], segments=32)
        case "rod":
            b.lathe(skin, np.multiply([(0.3, 0), (0.5, 0.02), (0.4, 0.5), (0.5, 0.98), (0.3, 1)], (w, h)), segments=16)
        case "ball":
            r = w / 2
            arc = [(r * math.cos(a), r + r * math.sin(a)) for a in np.linspace(-1.2, math.pi / 2, 14)]
            b.lathe(skin, arc, segments=28)
        case "cone":
            rings = []
            for t, s in zip((0.0, 0.12, 0.75, 0.95, 1.0), CONE, strict=True):
                angle = np.linspace(0, math.tau, 28, endpoint=False)
                rings.append(np.c_[w / 2 * s * np.cos(angle), d / 2 * s * np.sin(angle), np.full(28, h * t)])
            b.loft(skin, rings)


def _grips(entry: StandIn) -> Anchors:
    """Return where hands hold a stand-in; none if it is not holdable."""
    if not entry.holdable:
        return ()
    w, d, h = entry.size
    if entry.shape == "slab":
        return two_hands((0, d * 0.35, -0.012), (0, -1, 0), (0, 0, 1), (0.15, 0.2, 0.0))
    return two_hands((-w / 2, 0, h * 0.45), (0.25, -1, 0), (1, 0.2, 0), (0.45, 0.5, 0.3))

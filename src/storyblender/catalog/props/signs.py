"""Catalog entries of props: signs, posters and other lettered props; ``catalog.writing`` says where their text goes."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry, held

SIGNS: tuple[PropEntry, ...] = (
    held("placard", "protest sign, picket sign, cardboard sign, handmade sign, name board, welcome sign",
        (0.6, 0.04, 1.5), {"board": "cardboard", "stick": "wood"}, "A sign on a stick."),
    entry("street", "banner", "cloth banner, protest banner, birthday banner, finish line, bunting banner",
        (3.0, 0.05, 2.4), {"cloth": "linen", "pole": "wood"}, "A cloth between two poles."),
    entry("fitting", "poster",
        "wanted poster, movie poster, film poster, missing poster, playbill, flyer on the wall, notice",
        (0.5, 0.004, 0.72), {"paper": "paper"}, "A poster.", placement="wall"),
    entry("street", "sign_board",
        "for sale sign, town sign, wooden sign, welcome board, billboard, notice sign, no trespassing sign, warning "
        "sign, road board", (1.2, 0.16, 1.6), {"board": "paint", "post": "wood"}, "A board on two posts.",
        params={"color": "#31486b"}),
    entry("fitting", "wall_sign",
        "door sign, name plate, nameplate, plaque, brass plate, exit sign, closed sign, open sign, room number, "
        "door plate, no smoking sign, vacancy sign", (0.42, 0.012, 0.16), {"plate": "porcelain"}, "A plate.",
        placement="wall"),
    entry("street", "shop_sign", "shop front sign, store sign, cafe sign, inn sign, pub sign, station sign",
        (2.0, 0.2, 2.9), {"board": "paint", "rim": "brass"}, "The board of a shop on two posts.",
        params={"color": "#2a3a30"}),
)  # fmt: skip
"""Roughly from small to large."""

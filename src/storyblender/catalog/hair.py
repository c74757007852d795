"""Hairstyles as data: where hair grows, how it is combed, how long the locks are.

Lengths are metres on an adult's head. Directions are on the head's unit sphere: +x the person's left, +y back, +z up.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from storyblender.catalog.registry import Catalog


@dataclass(frozen=True, kw_only=True)
class HairSpec:
    """A hairstyle.

    Attributes:
        key: Key in the catalog.
        name: Display name.
        tags: Synonyms.
        top: Thickness on top.
        side: Thickness at the sides.
        comb: ``part`` away from the parting, ``back``, ``crown`` outwards from the whorl, ``gather`` to the knot.
        parting: x of the parting on the unit sphere.
        sweep: How much a parted lock also runs back (+) or forward (-).
        locks: Number of locks.
        width: Width of a lock.
        reach: Length of a lock on the head, radians.
        hang: Length of a lock below the ear; 0 for hair that ends on the head.
        mess: How much locks stray from the combing direction, 0 to 1.
        lift: Height of the locks above the head.
        wave: Sideways wave of hanging locks.
        tip: Width at the end of a lock, as a share.
        growth: ``full``, ``receding`` or ``wreath`` (bald on top).
        knot: ``bun``, ``tail`` or ``braid`` at the back; empty for none.
        curls: Round curls instead of locks.
    """

    key: str
    name: str
    tags: tuple[str, ...]
    top: float = 0.018
    side: float = 0.009
    comb: Literal["part", "back", "crown", "gather"] = "part"
    parting: float = 0.35
    sweep: float = 0.3
    locks: int = 70
    width: float = 0.022
    reach: float = 0.8
    hang: float = 0.0
    mess: float = 0.15
    lift: float = 0.003
    wave: float = 0.0
    tip: float = 0.12
    growth: Literal["full", "receding", "wreath"] = "full"
    knot: Literal["", "bun", "tail", "braid"] = ""
    curls: bool = False


HAIRSTYLES: Catalog[HairSpec] = Catalog("hairstyle", (
    HairSpec(key="short", name="Short", tags=("side parting", "neat", "combed", "gentleman"),
             locks=110, width=0.016, reach=1.15, mess=0.07, lift=0.002),
    HairSpec(key="crop", name="Crop", tags=("buzz cut", "crew cut", "military", "shaved"),
             top=0.006, side=0.003, comb="crown", locks=0),
    HairSpec(key="slick", name="Slicked back", tags=("pomade", "combed back", "greased"),
             top=0.016, side=0.007, comb="back", locks=70, reach=1.0, mess=0.06, lift=0.001, width=0.02),
    HairSpec(key="messy", name="Messy", tags=("tousled", "fringe", "boyish", "wild"),
             top=0.024, side=0.014, comb="crown", locks=95, reach=0.75, mess=0.55, lift=0.008, tip=0.05),
    HairSpec(key="receding", name="Receding", tags=("thinning", "high forehead"),
             top=0.010, side=0.008, comb="back", locks=80, reach=1.0, mess=0.08, lift=0.002,
             growth="receding", width=0.014),
    HairSpec(key="bald", name="Bald", tags=("bald on top", "wreath of hair", "tonsure"),
             top=0.006, side=0.010, comb="crown", locks=60, reach=0.45, growth="wreath", width=0.020),
    HairSpec(key="shaved", name="Shaved head", tags=("no hair", "hairless"), top=0, side=0, locks=0, growth="wreath"),
    HairSpec(key="bun", name="Bun", tags=("chignon", "updo", "knot", "pinned up"),
             top=0.016, side=0.011, comb="gather", locks=64, reach=1.5, mess=0.06, lift=0.002, knot="bun"),
    HairSpec(key="ponytail", name="Ponytail", tags=("tied back", "pigtail"),
             top=0.014, side=0.009, comb="gather", locks=64, reach=1.5, mess=0.06, lift=0.002, knot="tail"),
    HairSpec(key="braid", name="Braid", tags=("plait", "braided", "plaited"),
             top=0.014, side=0.009, comb="gather", locks=64, reach=1.5, mess=0.06, lift=0.002, knot="braid"),
    HairSpec(key="long", name="Long", tags=("flowing", "loose", "shoulder length", "straight"),
             top=0.018, side=0.016, parting=0.18, sweep=0.25, locks=92, reach=1.6, hang=0.25, mess=0.10, lift=0.003,
             width=0.030, wave=0.010, tip=0.3),
    HairSpec(key="bob", name="Bob", tags=("chin length", "pageboy", "flapper"),
             top=0.020, side=0.020, parting=0.25, sweep=0.15, locks=86, reach=1.6, hang=0.075, mess=0.06, lift=0.003,
             width=0.030, tip=0.75),
    HairSpec(key="wavy", name="Wavy", tags=("forties waves", "curled", "glamour"),
             top=0.022, side=0.022, parting=0.38, sweep=0.25, locks=90, reach=1.6, hang=0.16, mess=0.15, lift=0.006,
             width=0.034, wave=0.028, tip=0.35),
    HairSpec(key="curly", name="Curly", tags=("curls", "ringlets", "frizzy"),
             top=0.032, side=0.026, comb="crown", locks=240, curls=True, width=0.031, mess=0.5),
    HairSpec(key="afro", name="Afro", tags=("natural", "round"),
             top=0.060, side=0.052, comb="crown", locks=250, curls=True, width=0.036, mess=0.25),
    HairSpec(key="pixie", name="Pixie", tags=("gamine", "elfin", "boyish cut"),
             top=0.018, side=0.008, locks=120, width=0.014, reach=0.95, mess=0.22, lift=0.003, sweep=-0.35,
             parting=0.3),
    HairSpec(key="bowl_cut", name="Bowl cut", tags=("pudding basin", "mop top", "fringe all round"),
             top=0.024, side=0.018, comb="crown", locks=150, width=0.02, reach=1.25, mess=0.05, lift=0.002, tip=0.6),
    HairSpec(key="undercut", name="Undercut", tags=("quiff", "pompadour", "flat top"),
             top=0.034, side=0.003, comb="back", locks=80, reach=0.9, mess=0.1, lift=0.010, width=0.018, tip=0.3),
    HairSpec(key="spiky", name="Spiky", tags=("spiked", "mohawk", "punk"),
             top=0.010, side=0.0015, comb="back", locks=60, reach=0.35, mess=0.12, lift=0.05, width=0.02, tip=0.1),
    HairSpec(key="dreadlocks", name="Dreadlocks", tags=("dreads", "locs"),
             top=0.020, side=0.018, parting=0.1, sweep=0.3, locks=70, width=0.034, reach=1.6, hang=0.2, mess=0.3,
             lift=0.006,
             wave=0.03, tip=0.8),
    HairSpec(key="cornrows", name="Cornrows", tags=("box braids", "canerows"),
             top=0.007, side=0.005, comb="back", locks=120, reach=1.5, mess=0.0, lift=0.004, width=0.011, tip=0.7),
))  # fmt: skip


def hairstyle(key: str) -> HairSpec:
    """Return the hairstyle of a key; short hair for an unknown key."""
    return HAIRSTYLES.get(key, HAIRSTYLES["short"])

"""The pieces that garments are sewn from, as data. The tailor has one builder for each kind of piece.

Lengths are metres on a person of 1.70 m and scale with the wearer.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Level = tuple[str, float]
"""A landmark (sole ankle knee crotch hip belt waist ribs chest neck) and metres above it."""

Fabric = Literal["cloth", "knit", "leather", "satin", "metal", "rubber"]


@dataclass(frozen=True)
class GarmentOpening:
    """The opening of a neckline in front.

    Attributes:
        bottom: Where the V ends.
        width: Half width of the V at the base of the neck.
        gap: Half width that stays open from ``bottom`` down to the hem; 0 closes it.
    """

    bottom: Level
    width: float
    gap: float = 0.0


@dataclass(frozen=True, kw_only=True)
class GarmentPiece:
    """One piece of a garment.

    Attributes:
        tint: ``main``, ``dark`` or ``light`` (shades of the garment's colour), or a hex code.
        fabric: How it shines.
    """

    tint: str = "main"
    fabric: Fabric = "cloth"


@dataclass(frozen=True, kw_only=True)
class Bodice(GarmentPiece):
    """Cloth for the trunk and arms.

    Attributes:
        sleeve: Where the sleeve ends: 0 shoulder, 1 elbow, 2 wrist.
        hem: Lower edge.
        neck: How far it goes up the neck.
        ease: Least distance to the skin.
        drape: Rounds of smoothing; more hides more of the body.
        opening: The neckline's opening, or None.
        elbow: Least radius of the sleeve at the elbow.
        cuff: Least radius of the sleeve at the wrist.
    """

    sleeve: float = 1.93
    hem: Level = ("hip", 0.0)
    neck: float = 0.03
    ease: float = 0.007
    drape: int = 6
    opening: GarmentOpening | None = None
    elbow: float = 0.0
    cuff: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Lapel(GarmentPiece):
    """The turned-out edges of a jacket's opening."""

    opening: GarmentOpening
    width: float = 0.036
    ease: float = 0.02


@dataclass(frozen=True, kw_only=True)
class Legs(GarmentPiece):
    """Cloth for the hips and both legs.

    Attributes:
        waist: Upper edge.
        hem: Lower edge.
        thigh: Least radius at the upper thigh.
        knee: Least radius at the knee.
        cuff: Least radius at the hem.
        drop: How far the hem falls over the shoe.
    """

    waist: Level = ("belt", 0.0)
    hem: Level = ("ankle", -0.01)
    thigh: float = 0.082
    knee: float = 0.070
    cuff: float = 0.068
    drop: float = 0.022


@dataclass(frozen=True, kw_only=True)
class Skirt(GarmentPiece):
    """A tube around both legs.

    Attributes:
        top: Upper edge.
        hem: Lower edge.
        flare: Growth of the radius down to the hem, 0.3 = 30 %.
        folds: How many folds run around.
        depth: Depth of the folds as a share of the radius.
        ease: Least distance to the body.
        opening: Half width of a gap in front, 0 = closed.
    """

    top: Level = ("belt", 0.02)
    hem: Level = ("knee", 0.0)
    flare: float = 0.2
    folds: int = 11
    depth: float = 0.035
    ease: float = 0.008
    opening: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Footwear(GarmentPiece):
    """A shoe, boot or sock.

    Attributes:
        top: Upper edge.
        ease: Thickness over the foot.
        shaft: Least radius of a boot's shaft, 0 follows the leg.
        sole: Tint of the sole, empty for a sock.
        throat: The instep is cut out, as in a court shoe.
    """

    top: Level = ("ankle", 0.015)
    ease: float = 0.007
    shaft: float = 0.0
    sole: str = "#151210"
    throat: bool = False
    fabric: Fabric = "leather"


@dataclass(frozen=True, kw_only=True)
class Band(GarmentPiece):
    """A belt or waistband over whatever is worn there."""

    low: Level = ("belt", -0.025)
    high: Level = ("belt", 0.015)
    ease: float = 0.012
    fabric: Fabric = "leather"


@dataclass(frozen=True, kw_only=True)
class Collar(GarmentPiece):
    """A folded collar: a band of the neck that flares out below.

    Attributes:
        low: Lower edge up the neck.
        high: Upper edge up the neck.
        flare: How far the lower edge stands off.
        gap: Half width of the gap in front.
        point: How much deeper the lower edge goes in front.
    """

    low: float = 0.012
    high: float = 0.054
    flare: float = 0.010
    gap: float = 0.030
    point: float = 0.030


@dataclass(frozen=True, kw_only=True)
class Buttons(GarmentPiece):
    """A row of buttons down the front."""

    top: Level
    bottom: Level
    count: int
    radius: float = 0.008
    offset: float = 0.0
    tint: str = "#d8d4c8"
    fabric: Fabric = "satin"


@dataclass(frozen=True, kw_only=True)
class Patches(GarmentPiece):
    """A pair of pockets (or one, to the wearer's left)."""

    top: Level
    offset: float
    width: float = 0.10
    height: float = 0.11
    pair: bool = True
    tint: str = "dark"


@dataclass(frozen=True, kw_only=True)
class Necktie(GarmentPiece):
    """A long tie; ``length`` from the knot to the tip."""

    length: float = 0.36
    fabric: Fabric = "satin"


@dataclass(frozen=True, kw_only=True)
class BowTie(GarmentPiece):
    """A bow at the collar."""

    fabric: Fabric = "satin"


@dataclass(frozen=True, kw_only=True)
class Scarf(GarmentPiece):
    """A wound ring around the neck."""

    fabric: Fabric = "knit"


@dataclass(frozen=True, kw_only=True)
class Bib(GarmentPiece):
    """The front of an apron: a panel from the chest to the hem with a waist band."""

    top: Level = ("chest", -0.04)
    hem: Level = ("knee", 0.05)


HatShape = Literal[
    "fedora", "peaked", "flat", "straw", "beanie", "baseball", "top", "bowler", "cowboy", "hard", "helmet", "toque",
        "witch",
    "turban", "beret", "skullcap", "party", "sombrero", "crown", "sailor", "mitre", "globe",
]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Hat(GarmentPiece):
    """Headwear.

    Attributes:
        shape: Shape of the hat; ``globe`` is the helmet of a space or diving suit, open in front of the face.
        band: Tint of its band.
        visor: Tint of its visor.
    """

    shape: HatShape
    band: str = "dark"
    visor: str = "#0c0b0b"


@dataclass(frozen=True, kw_only=True)
class HeadCloth(GarmentPiece):
    """Cloth cut from the skin of the head.

    Attributes:
        region: ``hood`` covers all but the face, ``scarf`` the hair, ``mask`` nose and mouth,
            ``balaclava`` all but the eyes, ``band`` the forehead, ``blindfold`` the eyes.
        ease: Offset from the skin in metres.
    """

    region: Literal["hood", "scarf", "mask", "balaclava", "band", "blindfold"]
    ease: float = 0.012


@dataclass(frozen=True, kw_only=True)
class Gear(GarmentPiece):
    """A solid accessory worn on the body."""

    shape: Literal["backpack", "tank", "necklace", "stethoscope", "wings", "cape", "satchel", "braces", "headphones",
                   "sunglasses", "eyepatch"]  # fmt: skip


HIDES_HAIR: frozenset[str] = frozenset({"hood", "scarf", "balaclava", "globe"})
"""Regions and shapes that hide the hair completely."""

AnyPiece = (Bodice | Lapel | Legs | Skirt | Footwear | Band | Collar | Buttons | Patches | Necktie | BowTie | Scarf
            | Bib | Hat | HeadCloth | Gear)  # fmt: skip


def hides_hair(piece: AnyPiece) -> bool:
    """Return whether a piece hides the hair completely."""
    return (isinstance(piece, HeadCloth) and piece.region in HIDES_HAIR) or (
        isinstance(piece, Hat) and piece.shape in HIDES_HAIR
    )

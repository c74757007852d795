"""The wardrobe: every garment as data, and the default clothes where the script names none.

Everyday clothes are here, costumes in ``garments_of_trades``, hats and accessories in ``worn``. To add a garment, add
one entry (docs/add-a-garment.md).
"""

from __future__ import annotations

import numpy as np

from storyblender.catalog.cuts import (
    Band,
    Bib,
    Bodice,
    BowTie,
    Buttons,
    Collar,
    Footwear,
    GarmentOpening,
    Hat,
    Lapel,
    Legs,
    Necktie,
    Patches,
    Scarf,
    Skirt,
)  # fmt: skip
from storyblender.catalog.garment_entry import GarmentSpec, garment
from storyblender.catalog.garments_of_trades import TRADE_GARMENTS
from storyblender.catalog.registry import Catalog
from storyblender.catalog.worn import WORN
from storyblender.memory.asset_sheet import CharacterLook, Garment

_JACKET_V = GarmentOpening(("waist", 0.05), 0.085)
_DINNER_V = GarmentOpening(("waist", 0.03), 0.095)
_DRESS_V = GarmentOpening(("chest", -0.01), 0.085)
_KNIT_V = GarmentOpening(("ribs", 0.0), 0.085, gap=0.004)
_VEST_V = GarmentOpening(("ribs", 0.02), 0.085)
_COAT_V = GarmentOpening(("ribs", 0.04), 0.085)


GARMENTS: Catalog[GarmentSpec] = Catalog("garment", (
    garment("socks", "stockings, hose, knee socks", 0, "", "#c9c5bd #3a3c44 #6f6a60",
          Footwear(top=("ankle", 0.07), ease=0.003, sole="", fabric="knit")),
    garment("shoes", "oxfords, loafers, sneakers, pumps", 10, "feet", "#1d1410 #0d0c0c #4a2a18",
          Footwear()),
    garment("heels", "high heels, court shoes, pumps, slippers", 10, "feet", "#5d0c18 #1d1410 #0d0c0c",
          Footwear(ease=0.005, throat=True)),
    garment("shirt", "dress shirt, button-down, collared shirt", 20, "upper", "#e9e6de #c9d6e4 #d9cfc0 #8fa6bd",
          Bodice(sleeve=1.96, neck=0.046, elbow=0.045, cuff=0.035),
          Collar(), Buttons(top=("neck", -0.06), bottom=("waist", 0.02), count=6, radius=0.005)),
    garment("blouse", "ladies' shirt", 20, "upper", "#ece6da #d8b7b4 #b9c9c2",
          Bodice(sleeve=1.9, neck=0.014, ease=0.008, drape=8, elbow=0.046, cuff=0.034),
          Collar(low=-0.014, high=0.026, gap=0.03, point=0.02)),
    garment("tie", "necktie, cravat", 25, "", "#2a3f66 #5d1620 #2f2f33 #3d5240",
          Necktie()),
    garment("bow_tie", "bow, black tie", 25, "", "#0a0a0c #5d1620",
          BowTie()),
    garment("trousers", "pants, slacks, jeans", 30, "lower", "#2c2d33 #3d3a36 #4a4038 #39424f #6b6250",
          Legs(), Band(ease=0.010, tint="dark", fabric="cloth", low=("belt", -0.03), high=("belt", 0.004))),
    garment("shorts", "short trousers", 30, "lower", "#2b4a7a #6b5f46 #43503b",
          Legs(hem=("knee", 0.05), thigh=0.09, knee=0.088, cuff=0.088, drop=0.0)),
    garment("breeches", "riding breeches, uniform trousers", 30, "lower", "#4e5136 #6b6250 #2c2d33",
          Legs(hem=("ankle", 0.21), thigh=0.092, knee=0.072, cuff=0.055, drop=0.0)),
    garment("skirt", "knee-length skirt, pencil skirt", 30, "lower", "#574a52 #2f3a4c #5b4632 #3d4a3c",
          Skirt(hem=("knee", -0.10), flare=0.16)),
    garment("long_skirt", "maxi skirt, ankle-length skirt", 30, "lower", "#574a52 #2f3a4c #3b2e2a",
          Skirt(hem=("ankle", 0.16), flare=0.16, folds=13)),
    garment("dress", "frock, summer dress", 30, "upper lower", "#a3142a #27506b #3f5d46 #6a4a73 #c08a3e",
          Bodice(sleeve=0.34, neck=-0.012, ease=0.006, drape=4, hem=("belt", -0.03), opening=_DRESS_V),
          Skirt(hem=("knee", -0.03), flare=0.33, ease=0.010),
          Band(low=("belt", -0.02), high=("belt", 0.02), ease=0.014, tint="dark")),
    garment("gown", "evening gown, long dress, ball gown, wedding dress, robe", 30, "upper lower",
          "#2b2140 #7a1f33 #1f3d3a #d9d2c4",
          Bodice(sleeve=0.12, neck=-0.02, ease=0.005, drape=3, hem=("belt", -0.03), opening=_DRESS_V, fabric="satin"),
          Skirt(hem=("ankle", 0.03), flare=0.5, ease=0.008, folds=13, depth=0.05, fabric="satin"),
          Band(low=("belt", -0.02), high=("belt", 0.02), ease=0.012, tint="dark", fabric="satin")),
    garment("belt", "leather belt, sash", 35, "", "#3a2312 #15110e",
          Band(), Patches(top=("belt", 0.006), offset=0.0, width=0.035, height=0.024, pair=False, tint="#b59a4a",
                          fabric="metal")),
    garment("tee", "t-shirt, jersey, undershirt, polo", 40, "upper", "#d9a520 #b8433a #3f6b8a #d8d4cc #4d6b4a",
          Bodice(sleeve=0.72, neck=0.006, ease=0.010, drape=10, hem=("hip", -0.04))),
    garment("sweater", "pullover, jumper, turtleneck", 42, "upper", "#7a3b2e #3d5240 #6d6a63 #2f3a55",
          Bodice(sleeve=1.9, neck=0.03, ease=0.013, drape=12, hem=("hip", -0.05), elbow=0.054, cuff=0.038,
                 fabric="knit")),
    garment("vest", "waistcoat, sleeveless jacket", 45, "upper", "#3b3d45 #4d4136 #22252b",
          Bodice(sleeve=-0.12, neck=0.004, ease=0.010, drape=8, hem=("hip", 0.01), opening=_VEST_V),
          Buttons(top=("ribs", 0.0), bottom=("hip", 0.07), count=4, radius=0.006, tint="#15110e")),
    garment("cardigan", "knitted jacket", 55, "upper", "#6d7fa6 #8a6d4f #5c6b54 #7a4a52",
          Bodice(sleeve=1.85, neck=0.0, ease=0.013, drape=12, hem=("crotch", 0.04), opening=_KNIT_V, elbow=0.05,
              cuff=0.041, fabric="knit"),
          Buttons(top=("ribs", -0.03), bottom=("hip", 0.0), count=4, radius=0.007, offset=0.0)),
    garment("jacket", "suit jacket, blazer, sports coat", 60, "upper", "#2f3239 #4b4136 #3b4654 #5c5349",
          Bodice(sleeve=1.9, neck=0.026, ease=0.012, drape=10, hem=("crotch", 0.0), opening=_JACKET_V, elbow=0.054,
              cuff=0.045),
          Lapel(opening=_JACKET_V, tint="dark"),
          Patches(top=("hip", 0.03), offset=0.115, width=0.12, height=0.03),
          Buttons(top=("waist", 0.03), bottom=("waist", -0.05), count=2, tint="#1a1614")),
    garment("dinner_jacket", "tuxedo, smoking jacket, white tie", 60, "upper", "#ebe6da #121216",
          Bodice(sleeve=1.88, neck=0.026, ease=0.012, drape=10, hem=("crotch", 0.0), opening=_DINNER_V, elbow=0.054,
              cuff=0.045),
          Lapel(opening=_DINNER_V, width=0.042, tint="light", fabric="satin"),
          Buttons(top=("waist", 0.01), bottom=("waist", 0.01), count=1, tint="#0c0c0d")),
    garment("tunic", "military tunic, battledress, service coat", 60, "upper", "#5a5d3c #5c5340 #3d4654",
          Bodice(sleeve=1.95, neck=0.034, ease=0.012, drape=10, hem=("crotch", 0.0), elbow=0.056, cuff=0.044),
          Collar(low=0.0, high=0.042, flare=0.010, gap=0.02, point=0.012),
          Buttons(top=("neck", -0.07), bottom=("waist", 0.03), count=5, tint="#c9a344", fabric="metal"),
          Patches(top=("chest", 0.0), offset=0.095),
          Band(low=("waist", -0.03), high=("waist", 0.018), tint="#3a2312")),
    garment("uniform", "police uniform, officer, guard, porter, chauffeur", 60, "upper", "#23293a #2b2f36 #4a1f24",
          Bodice(sleeve=1.95, neck=0.030, ease=0.012, drape=10, hem=("crotch", 0.0), elbow=0.055, cuff=0.044),
          Collar(low=0.0, high=0.040, flare=0.008, gap=0.016, point=0.010),
          Buttons(top=("chest", 0.06), bottom=("hip", 0.05), count=4, offset=0.055, tint="#c9a344", fabric="metal"),
          Band(low=("waist", -0.03), high=("waist", 0.012), tint="#141210")),
    garment("apron", "pinafore, smock", 70, "", "#e4ded0 #7d8a93 #5b4632",
          Bib(), Band(low=("belt", -0.045), high=("belt", 0.012), ease=0.014, fabric="cloth")),
    garment("coat", "trench coat, overcoat, raincoat, trenchcoat", 80, "upper", "#8a7450 #2e2f36 #4d4238",
          Bodice(sleeve=1.97, neck=0.02, ease=0.020, drape=14, hem=("belt", -0.06), opening=_COAT_V, elbow=0.062,
              cuff=0.054),
          Skirt(top=("belt", 0.03), hem=("knee", -0.06), flare=0.10, folds=7, depth=0.025, ease=0.026, opening=0.006),
          Lapel(opening=_COAT_V, width=0.050, tint="dark"),
          Collar(low=-0.012, high=0.044, flare=0.026, gap=0.07, point=0.0),
          Buttons(top=("ribs", 0.0), bottom=("hip", -0.02), count=3, offset=0.055, radius=0.011, tint="#2a2018"),
          Band(low=("belt", -0.02), high=("belt", 0.025), ease=0.03, tint="dark", fabric="cloth")),
    garment("boots", "riding boots, army boots, wellingtons", 32, "feet", "#0e0b09 #3a2312",
          Footwear(top=("ankle", 0.24), ease=0.010, shaft=0.060)),
    garment("scarf", "shawl, muffler, neckerchief", 85, "", "#8a2f2f #3d5240 #c9b48a",
          Scarf()),
    garment("hat", "fedora, trilby, homburg", 90, "head", "#3b342d #55504a #2b2420",
          Hat(shape="fedora", band="#15110e")),
    garment("straw_hat", "boater, sun hat, panama", 90, "head", "#d3bd86",
          Hat(shape="straw", band="#27304d")),
    garment("cap", "peaked cap, officer's cap, police cap", 90, "head", "#4e5136 #23293a",
          Hat(shape="peaked")),
    garment("flat_cap", "newsboy cap, cloth cap", 90, "head", "#5c5349 #3d4654",
          Hat(shape="flat", visor="#3f3932")),
    garment("beanie", "knitted cap, watch cap, woolly hat", 90, "head", "#2f3a55 #7a3b2e",
          Hat(shape="beanie", fabric="knit")),
    *TRADE_GARMENTS,
    *WORN,
))  # fmt: skip
"""From the inside out, as they are put on."""


TIE_LAYER = 25
OUTER_LAYER = 45
"""From here on a garment is worn over another one and may be open in front."""


def default_outfit(gender: str, age: float, seed: int) -> tuple[Garment, ...]:
    """Return what a person wears if the script does not say.

    Args:
        gender: ``female`` or ``male``.
        age: Years; under 13 for children's clothes.
        seed: Picks one of the usual outfits.
    """
    rng = np.random.default_rng(seed + 2)
    if age < 13:
        choices = ("tee shorts socks shoes", "shirt shorts socks shoes") if gender == "male" else ("dress socks shoes",)
    elif gender == "male":
        choices = ("shirt trousers shoes", "shirt trousers jacket shoes", "tee trousers shoes")
    else:
        choices = ("dress shoes", "blouse skirt shoes", "blouse trousers shoes")
    return tuple(Garment(key=key) for key in choices[int(rng.integers(len(choices)))].split())


def worn_open(key: str) -> bool:
    """Return whether a garment needs another below it: a jacket, not a buttoned tunic; False for an unknown key."""
    spec = GARMENTS.get(key)
    return (
        spec is not None
        and spec.layer >= OUTER_LAYER
        and any(isinstance(piece, Bodice) and piece.opening for piece in spec.pieces)
    )


def dressed(look: CharacterLook, gender: str, seed: int) -> tuple[Garment, ...]:
    """Return a person's garments from the inside out, completed so that nobody is unclothed; unknown keys are left out.

    Args:
        look: Casting words.
        gender: ``female`` or ``male``.
        seed: Picks the default outfit.
    """
    chosen = [garment for garment in look.garments if garment.key in GARMENTS]
    specs = [GARMENTS[garment.key] for garment in chosen]
    covered = {area for spec in specs for area in (*spec.covers, *spec.bares)}
    if not covered & {"upper", "lower"} and not any(spec.layer == TIE_LAYER for spec in specs):
        for garment in default_outfit(gender, look.age, seed):
            if "feet" not in GARMENTS[garment.key].covers or "feet" not in covered:
                chosen.append(garment)
    else:
        inner = any("upper" in (*spec.covers, *spec.bares) and not worn_open(spec.key) for spec in specs)
        young = look.age < 13
        basics = {
            "upper": "" if inner else "blouse" if gender == "female" and not young else "shirt",
            "lower": "" if "lower" in covered else "shorts" if young else "trousers",
            "feet": "" if "feet" in covered else "shoes",
        }
        chosen += [Garment(key=key) for key in basics.values() if key]
    return tuple(sorted(chosen, key=lambda garment: GARMENTS[garment.key].layer))

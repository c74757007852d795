"""Catalog entries of props: linen, clothes and small things of the house."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry, held
from storyblender.look.surface import Surface

HOUSEHOLD: tuple[PropEntry, ...] = (
    held("pillow", "cushion, throw pillow, bolster", (0.6, 0.42, 0.15), {"cloth": "linen"}, "A pillow."),
    held("blanket",
        "quilt, duvet, folded blanket, bedspread, coverlet, eiderdown, bedroll, sleeping bag, bed sheet, dust sheet",
        (0.46, 0.36, 0.15), {"cloth": "fabric_blue", "stripe": "linen"}, "A folded blanket."),
    held("cloth",
        "napkin, handkerchief, rag, dish towel, tea towel, dishcloth, hankie, bandage, scarf, shawl, veil, hand towel",
        (0.2, 0.2, 0.13), {"cloth": "linen"}, "A cloth, as one puts it down.", None, Surface.CLOTH),
    held("folded_clothes",
        "clothes, coat, jacket, overcoat, raincoat, shirt, dress, robe, apron, uniform, sweater, cardigan, "
        "trousers, costume, cloak, cape, garment, laundry, pyjamas, gown, nightgown, suit, parka, vest, tunic, "
        "skirt, kimono, spacesuit, duster", (0.38, 0.3, 0.11), {"cloth": "fabric", "button": "wood_dark"},
        "A folded coat.", None, Surface.CLOTH),
    held("boots", "boot, riding boots, wellingtons, pair of boots", (0.26, 0.3, 0.3),
        {"leather": "leather", "sole": "rubber"}, "A pair of boots."),
    held("gloves", "glove, mittens, gauntlet, gauntlets, boxing gloves, boxing glove, baseball glove, oven mitt",
        (0.16, 0.27, 0.08), {"leather": "leather"}, "A pair of gloves."),
    held("laundry_basket", "basket of laundry, clothes basket, washing basket, hamper", (0.6, 0.42, 0.4),
        {"wicker": "thatch", "linen": "linen"}, "A wicker basket full of linen."),
    entry("hand", "candle", "tallow candle, wax candle, taper, burning candle, votive candle", (0.07, 0.07, 0.22),
        {"wax": "wax", "flame": "flame"}, "A burning candle.", placement="surface", holdable=True, lamp=(0, 0, 0.2)),
    held("comb", "pocket comb, hair comb", (0.04, 0.17, 0.006), {"body": "plastic_black"}, "A comb."),
    held("hairbrush", "brush, clothes brush, hair brush, scrubbing brush", (0.075, 0.24, 0.04),
        {"body": "wood", "bristle": "plastic_black"}, "A hairbrush."),
    held("scissors", "shears, pair of scissors, clippers, kitchen scissors", (0.09, 0.2, 0.012),
        {"grip": "plastic_black", "steel": "steel"}, "Scissors."),
)  # fmt: skip

"""The paint chart of the sets: a finish is a material of ``catalog.materials`` in a colour. Plans name finishes."""

from __future__ import annotations

from typing import NamedTuple

from storyblender.catalog.materials import hex_color
from storyblender.memory.base import Color


class Finish(NamedTuple):
    """A material key and the colour it is made in; None keeps the material's own."""

    material: str
    color: Color | None = None


_CHART = """
plaster_ochre      plaster    #b08a58
plaster_cream      plaster    #d3c7ab
plaster_grey       plaster    #a7a69f
plaster_green      plaster    #8d917f
plaster_mint       plaster    #a9bbae
plaster_blue       plaster    #8d9fb0
plaster_rose       plaster    #b9988c
plaster_red        plaster    #7d352c
plaster_dark       plaster    #4a4440
plaster_soot       plaster    #6d675e
plaster_teal       plaster    #4f6a68
limewash           plaster    #cbbfa4
paper_green        wallpaper  #8b8d6c
paper_rose         wallpaper  #b08f80
paper_blue         wallpaper  #7f8f9c
ceiling_white      plaster    #cfcabd
ceiling_warm       plaster    #b9ad97
ceiling_dark       plaster    #3b3733
dado_dark          wall_planks #4d2c17
dado_brown         wall_planks #6b4325
dado_white         wall_planks #c4c0b4
dado_green         wall_planks #43543f
log_wall           wall_planks #8a653f
boards_grey        planks_gray #857c70
boards_dark        planks     #4d2c17
boards             planks     #7a5230
boards_light       planks     #a98258
brick_red          brick      #7a3b28
brick_brown        brick      #5d4436
brick_yellow       brick      #a48857
brick_pale         brick      #a9a196
stone_dark         stone      #5c5953
stone_light        stone      #b5ac99
stone_sand         stone      #b79c70
cave_rock          rock       #6f5f4f
flagstones         paving     #7a746a
concrete_dark      concrete   #5a5b5b
concrete_light     concrete   #a8a7a1
tile_check         tile       #8d7a60
tile_green         tile       #b9b5a4
tile_terracotta    paving     #96563a
lino_grey          linoleum   #8f918a
lino_brown         linoleum   #7d6a54
paving_light       paving     #a29b8c
tarmac             concrete   #5d6063
grass_dry          grass      #8f8548
grass_lush         grass      #5b6c36
dust               sand       #a98a62
gravel             dirt       #8c8478
mud                dirt       #55442f
sand_desert        sand       #c79a63
water_deep         water      #16303c
pool_water         water      #2f9db5
leaf               leaves     #566b31
leaf_yellow        leaves     #7f8434
pine               leaves_dark #2f4a33
hedge              leaves     #3d5a2b
leaf_snow          leaves     #c6ced4
bark_dark          bark       #3f3226
cloth_red          fabric     #6b1d1d
cloth_green        fabric     #22402e
cloth_blue         fabric     #2b3556
cloth_cream        fabric     #d8cfbd
velvet_red         fabric     #741a22
roof_tile          shingles   #8d4a33
roof_slate         shingles   #4b5057
paint_white        paint      #d9d5ca
paint_cream        paint      #cfc4aa
paint_black        paint      #171717
paint_brown        paint      #4a3322
paint_green        paint      #2f4a38
paint_blue         paint      #33506b
paint_red          paint      #8a1f18
paint_yellow       paint      #b8912c
paint_grey         paint      #77797a
chalkboard         linoleum   #22332b
metal_green        paint      #4f5a4c
metal_grey         paint      #8a8d8c
frosted            paint      #93a3a0
carpet_worn        carpet     #6b5a48
tatami             linen      #a89a62
mat_border         fabric     #1f2a24
hull_plate         concrete   #a3a6a8
carpet_red         carpet     #6e2b2a
ice                paint      #b4cbd6
grain              linen      #c2a050
moon_dust          sand       #8f8c88
sea_floor          sand       #8fa08a
void               plastic_black #05060a
cell_blue          glass_dark #16305c
sea_blue           lampshade  #2b5c94
land_green         lampshade  #5f7a48
cloud_white        lampshade  #c9d2d8
pane_warm          lampshade  #ffc173
pane_cool          lampshade  #cfe0ff
"""

FINISHES: dict[str, Finish] = {
    key: Finish(material, hex_color(code))
    for key, material, code in (line.split() for line in _CHART.split("\n") if line)
}


def finish_of(key: str) -> Finish:
    """Return the finish of that name; any other key is a material in its own colour."""
    return FINISHES.get(key, Finish(key))

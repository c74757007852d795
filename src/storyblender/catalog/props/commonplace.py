"""Catalog entries of props: common things unlike any other entry: doors by themselves, tubs, stacks, smoke."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry, held
from storyblender.look.surface import Surface

COMMONPLACE: tuple[PropEntry, ...] = (
    entry("fitting", "door", "front door, back door, closet door, cupboard door, cellar door, trapdoor, doors, hatch",
          (1.0, 0.12, 2.1), {"leaf": "wood", "frame": "wood_light", "metal": "brass"}, "A door in its frame.",
          params={"open": False}, placement="wall"),
    entry("fitting", "window", "window pane, windowpane, casement, porthole", (1.1, 0.12, 1.2),
          {"frame": "wood_light", "glass": "glass_dark"}, "A window in its frame.", placement="wall"),
    entry("fitting", "barbecue", "bbq, barbeque, grill, gas grill, barbecue grill, kettle grill", (1.15, 0.55, 1.1),
          {"lid": "paint", "metal": "steel", "tyre": "rubber"}, "A barbecue on wheels.", params={"color": "#22262c"}),
    held("food_tub", "tub of ice cream, ice cream tub, tub of butter, tub of popcorn, carton of ice cream, tub of food",
         (0.13, 0.13, 0.13), {"body": "porcelain", "lid": "fabric_red"}, "A round carton with a lid."),
    entry("furniture", "aquarium", "fish tank, terrarium, goldfish tank, goldfish bowl, fish bowl", (0.6, 0.3, 0.4),
          {"frame": "plastic_black", "water": "glass", "sand": "sand", "fish": "fabric_red", "weed": "leaves"},
          "A tank of water with two fish.", placement="surface", surface=Surface.GLASS),
    entry("fitting", "lever", "control stick, joystick, throttle, gear stick, gear lever, handbrake, control lever",
          (0.22, 0.26, 0.42), {"base": "iron", "knob": "plastic_black"}, "A lever in its slot.", placement="surface"),
    entry("furniture", "drawer", "desk drawer, cash drawer, cutlery drawer, top drawer, bottom drawer",
          (0.42, 0.48, 0.16), {"wood": "wood_light", "metal": "brass"}, "A drawer, pulled out of what it belongs to.",
          placement="surface"),
    entry("street", "clothesline", "clothes line, washing line, line of washing, line of laundry, laundry line, "
          "clothes on a rope, clothes on a line, washing on a line, hanging laundry", (3.2, 0.5, 2.0),
          {"post": "wood_gray", "cloth": "linen", "other": "fabric_blue", "third": "fabric_red"}, "Washing on a line."),
    entry("fitting", "bunting", "garland, garlands, streamers, streamer, paper chain, party flags, pennants",
          (3.4, 0.04, 0.75), {"flag": "fabric_red", "other": "fabric_blue", "third": "brass"},
          "A string of small flags.", placement="ceiling"),
    entry("nature", "smoke", "column of smoke, cloud of smoke, plume of smoke, steam, fumes, exhaust, fog, mist, haze, "
          "vapour, vapor, dust cloud, cloud of dust", (0.9, 0.75, 1.65), {"puff": "smoke"}, "Billowing smoke.",
          params={"color": "#b9bcc0"}),
    entry("nature", "running_water", "tap water, falling water, stream from a tap, dripping water", (0.14, 0.14, 0.3),
          {"water": "glass"}, "Water that runs from a spout.", params={"color": "#a9bcc2"}, placement="surface"),
    entry("nature", "water_jet", "spray of water, water spray, jet of water", (0.12, 2.4, 0.3), {"water": "glass"},
          "A jet of water.", params={"color": "#a9bcc2"}, placement="surface"),
    entry("nature", "liquid", "surface of a liquid", (0.2, 0.2, 0.01), {"liquid": "glass"}, "What fills a vessel.",
          params={"color": "#8fa6ad", "oblong": False}, placement="surface"),
    entry("nature", "cloud", "storm cloud, storm, thundercloud, storm clouds, clouds, rain cloud", (6.0, 3.0, 2.0),
          {"puff": "fabric"}, "A heavy cloud.", params={"color": "#6f7684"}),
    entry("street", "lighthouse", "light house, beacon tower", (4.4, 4.4, 14.0),
          {"wall": "plaster_white", "band": "fabric_red", "lamp": "lamp_warm", "metal": "iron"}, "A lighthouse.",
          lamp=(0.0, 0.0, 12.4)),
    entry("furniture", "platform", "stage, dais, riser, bandstand, plinth", (4.0, 2.6, 0.4),
          {"top": "planks", "side": "wood_dark"}, "A low stage."),
    entry("nature", "hole", "pit, hole in the ground, open grave, ditch, crater, burrow, manhole, trap",
          (1.5, 1.1, 0.14), {"rim": "dirt", "dark": "plastic_black"}, "A hole with earth around it."),
)  # fmt: skip
"""Fittings first, then what is held, then what stands outdoors."""

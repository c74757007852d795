"""Catalog entries of props that stand between people or before a way: service windows, hatches, rails, gates."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry

PARTITIONS: tuple[PropEntry, ...] = (
    entry("furniture", "service_window",
        "serving window, ticket window, ticket counter, teller window, teller's window, teller counter, "
        "cashier window, cashier's window, counter window, box office window, reception window, pay window, "
        "bulletproof window, bulletproof glass, security window, drive-through window, enquiry window, "
        "bank counter, bandit screen",
        (2.0, 0.7, 2.15), {"body": "wood", "top": "wood_dark", "frame": "steel", "glass": "glass"},
        "A counter with a pane on it and a slot below the pane; the clerk is behind it (+Y), the customer in front."),
    entry("furniture", "serving_hatch",
        "service hatch, tea hatch, kitchen hatch, coffee hatch, food hatch, buffet hatch, pass-through, servery, "
        "snack window, tea counter, refreshment counter, canteen hatch", (2.2, 0.7, 2.3),
        {"body": "wood_light", "top": "wood", "frame": "enamel"},
        "A counter under an open hatch with its shutter up; who serves is behind it (+Y)."),
    entry("street", "tube_rail",
        "rail, steel rail, metal rail, ring rail, cattle rail, iron rail, metal railing, steel railing, pipe rail, "
        "crowd rail, sheep hurdle, hurdle, cattle hurdle", (2.4, 0.09, 1.15), {"metal": "steel"},
        "A chest-high rail of three tubes on two posts."),
    entry("street", "field_gate",
        "steel gate, metal gate, ring gate, cattle gate, tubular gate, five-bar gate, pen gate, paddock gate",
        (2.2, 0.1, 1.25), {"metal": "steel"}, "A gate of tubes between two posts.", params={"open": False}),
    entry("nature", "nest_box",
        "nesting box, bird box, birdhouse, bird house, owl box, nestbox, starling box", (0.46, 0.4, 0.62),
        {"wood": "wood_gray", "dark": "plastic_black"},
        "A box of boards for birds, open at its front under a sloping lid."),
    entry("furniture", "milk_churn", "churn, milk can, dairy can, milk canister, milk pail", (0.38, 0.38, 0.74),
        {"metal": "sheet_metal"}, "A tall can with two handles and a lid."),
)  # fmt: skip

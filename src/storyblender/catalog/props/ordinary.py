"""Ordinary things that scripts name in passing: hardware, paper, shoes, small household things."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry, held

_HARDWARE: tuple[PropEntry, ...] = (
    held("light_bulb", "lightbulb, bulb, spare bulb", (0.06, 0.06, 0.11), {"glass": "wax", "cap": "brass"},
        "A light bulb."),
    held("battery", "batteries, torch battery, dry cell, penlight battery", (0.034, 0.034, 0.062),
        {"body": "plastic_black", "top": "copper", "pole": "steel"}, "A battery."),
    held("screw", "wood screw, screws", (0.014, 0.014, 0.05), {"metal": "steel"}, "A screw."),
    held("bolt", "nut and bolt, lug nut, wheel nut, rivet", (0.03, 0.03, 0.07), {"metal": "steel"},
        "A bolt with its nut."),
    held("nail", "iron nail, rusty nail, tack, thumbtack, drawing pin", (0.012, 0.07, 0.012),
        {"metal": "iron"}, "A nail."),
    held("tape_roll", "tape, roll of tape, duct tape, sticky tape, adhesive tape, electrical tape, gaffer tape, "
         "masking tape, packing tape, scotch tape, sellotape", (0.11, 0.11, 0.05), {"tape": "plastic"},
        "A roll of tape.", {"color": "#7d8084"}),
    held("bolt_cutters", "bolt cutter, bolt croppers, wire cutters, pruning loppers, loppers", (0.17, 0.62, 0.035),
        {"handle": "fabric_red", "jaw": "iron"}, "Bolt cutters."),
    held("lock_picks", "lock pick, lockpick, lockpicks, lock pick set, picklock", (0.13, 0.16, 0.012),
        {"pick": "steel", "roll": "leather_black"}, "Lock picks in their roll."),
    held("padlock", "lock, combination lock, bike lock", (0.05, 0.022, 0.085), {"body": "brass", "bow": "steel"},
        "A padlock."),
    held("key_ring", "keyring, keychain, key chain, bunch of keys, ring of keys, set of keys",
        (0.1, 0.14, 0.012), {"metal": "brass"}, "Keys on a ring."),
    held("thread_spool", "thread, spool of thread, reel of cotton, spool, reel of thread, bobbin, string, twine, "
         "ball of string, ball of twine", (0.045, 0.045, 0.06), {"thread": "fabric_red", "wood": "wood_light"},
        "A spool of thread."),
    held("needle_and_thread", "sewing needle, needle with thread, darning needle, safety pin, pin, sewing pin, hatpin",
        (0.05, 0.09, 0.006), {"thread": "fabric_red", "metal": "steel"}, "A needle with its thread."),
    held("poker", "fire poker, fireplace poker, fire iron, branding iron", (0.06, 0.03, 0.72), {"metal": "iron"},
        "A poker."),
    entry("street", "hose", "garden hose, hosepipe, fire hose, water hose, rubber hose", (0.5, 0.62, 0.16),
        {"hose": "rubber"}, "A coiled hose.", params={"color": "#3c6a42"}, placement="surface", holdable=True),
    entry("street", "tire", "tyre, car tire, spare tire, spare tyre, rubber tire, flat tire, bald tire",
        (0.64, 0.64, 0.2), {"rubber": "rubber"}, "A tire that lies flat, or a stack.",
        params={"stacked": False}, holdable=True),
    entry("street", "gas_cylinder", "gas cylinder, gas bottle, gas tank, propane tank, propane bottle, oxygen tank, "
          "oxygen cylinder, oxygen bottle, air tank, butane bottle, cylinder of gas, helium tank",
        (0.3, 0.3, 1.0), {"body": "paint", "valve": "brass"}, "A gas cylinder.", params={"color": "#3f5f7a"},
        holdable=True),
)  # fmt: skip

_DESK: tuple[PropEntry, ...] = (
    held("paper_stack", "stack of paper, pile of paper, pile of papers, ream of paper, paper ream, ream, paper pile, "
         "stack of papers, pile of paperwork, bundle of papers, sheaf of papers, stack of forms, pile of forms, "
         "stack of documents, pile of documents, stack of files, pile of files", (0.23, 0.31, 0.06), {"paper": "paper"},
        "A stack of paper."),
    held("rubber_stamp", "ink stamp, date stamp, office stamp, hand stamp", (0.05, 0.035, 0.09),
        {"handle": "wood_red", "foot": "rubber"}, "A rubber stamp."),
    held("envelope_stack", "stack of envelopes, pile of mail, stack of letters, pile of letters, bundle of letters, "
         "stack of mail, bundle of mail, stack of post", (0.24, 0.16, 0.05), {"paper": "paper", "string": "cardboard"},
        "Envelopes in a bundle."),
    held("ticket", "train ticket, plane ticket, raffle ticket, lottery ticket, movie ticket, cinema ticket, "
         "concert ticket, parking ticket, bus ticket, ticket stub, claim ticket, boarding pass, pawn ticket",
        (0.14, 0.055, 0.002), {"paper": "paper", "print": "fabric_red"}, "A ticket.", {"color": "#d8b46a"}),
    held("id_card", "identity card, id, id badge, name tag, nametag, name badge, visitor badge, pass, security badge, "
         "keycard, key card, access card, press pass, swipe card, lanyard", (0.06, 0.2, 0.004),
        {"card": "plastic", "band": "fabric_blue"}, "A card on its band."),
    held("badge", "police badge, sheriff's badge, star badge, tin star, marshal's badge",
        (0.07, 0.012, 0.085), {"metal": "gold"}, "A badge with a star."),
    held("medal", "medallion, gold medal, silver medal, medal of honor, bronze medal, war medal",
        (0.055, 0.16, 0.006), {"disc": "gold", "ribbon": "fabric_red"}, "A medal on its ribbon."),
    held("remote_control", "remote, tv remote, clicker, remote control unit, zapper", (0.05, 0.19, 0.024),
        {"body": "plastic_black", "key": "plastic", "power": "fabric_red"}, "A remote control."),
    held("stapler", "staple gun, hole punch, paper punch", (0.036, 0.15, 0.062), {"body": "paint", "metal": "steel"},
        "A stapler.", {"color": "#1b1b1d"}),
    held("ruler", "yardstick, measuring stick, foot rule, meter stick", (0.032, 0.31, 0.004), {"wood": "wood_light"},
        "A ruler."),
    held("tape_measure", "measuring tape, measuring-tape, steel tape", (0.07, 0.13, 0.065),
        {"case": "paint", "tape": "wax"}, "A tape measure, pulled out a little.", {"color": "#c9a21f"}),
)  # fmt: skip

_WORN: tuple[PropEntry, ...] = (
    held("shoe", "shoes, running shoe, sneaker, sneakers, trainers, loafer, loafers, slipper, slippers, brogue, "
         "school shoe, dress shoe, leather shoe, tennis shoe, footwear, ballet shoe, moccasin", (0.1, 0.28, 0.11),
        {"leather": "leather", "sole": "rubber"}, "A laced shoe, or a pair.", {"pair": False}),
    held("high_heel", "high heels, heels, pump shoe, high heeled shoe, glass slipper",
        (0.085, 0.24, 0.15), {"leather": "leather_black"}, "A high-heeled shoe, or a pair.",
        {"pair": False, "color": "#861622"}),
    held("sandal", "sandals, flip flop, flip flops, flip-flop, flip-flops, thong sandal, beach sandal, espadrille",
        (0.1, 0.27, 0.06), {"strap": "fabric_blue", "sole": "rubber"}, "A sandal, or a pair.", {"pair": False}),
    held("sock", "socks, wool sock, stocking, stockings, christmas stocking, sports sock", (0.2, 0.3, 0.03),
        {"wool": "fabric", "trim": "fabric_red"}, "A sock, or a pair.", {"pair": False, "color": "#d6cfc0"}),
    entry("furniture", "dress_form", "tailor's dummy, dressmaker's dummy, mannequin, dummy, shop dummy, dress dummy, "
          "tailor dummy, display dummy, crash test dummy", (0.44, 0.44, 1.66),
        {"cover": "linen", "wood": "wood_dark"}, "A tailor's dummy on its stand."),
    held("hanging_garment", "garment on a hanger, coat on a hanger, dress on a hanger, suit on a hanger, hanger, "
         "clothes hanger, coat hanger, coathanger, garment bag", (0.5, 0.2, 0.98), {"cloth": "fabric"},
        "A garment on its hanger.", {"color": "#3a4658"}),
    held("necktie", "tie, silk tie, striped tie, cravat", (0.09, 0.62, 0.014),
        {"silk": "fabric_blue", "stripe": "fabric_red"}, "A necktie."),
    held("bow_tie", "bow-tie, bowtie, dicky bow, hair bow", (0.12, 0.03, 0.065), {"silk": "fabric_red"},
        "A bow tie."),
    held("belt", "leather belt, waist belt, dog collar, sash belt", (0.12, 0.18, 0.035),
        {"leather": "leather", "buckle": "brass"}, "A rolled belt."),
    held("hair_curlers", "hair curler, curler, curlers, hair roller, hair rollers", (0.16, 0.14, 0.075),
        {"body": "plastic"}, "Hair curlers.", {"color": "#d394a0"}),
    held("whistle", "referee's whistle, police whistle, coach's whistle, dog whistle", (0.048, 0.158, 0.024),
        {"metal": "chrome", "cord": "plastic_black"}, "A whistle on its cord."),
    held("crutch", "crutches, walking crutch, underarm crutch", (0.2, 0.045, 1.3),
        {"wood": "wood_light", "pad": "rubber"}, "A crutch, or a pair.", {"pair": False}),
    held("drumstick", "drumsticks, drum stick, drum sticks", (0.018, 0.4, 0.016), {"wood": "wood_light"},
        "A drumstick, or a pair.", {"pair": False}),
    held("feather", "plume, eagle feather, ostrich feather, goose feather", (0.07, 0.26, 0.012), {"vane": "linen"},
        "A feather."),
    held("leash", "dog lead, dog leash, lead, dog's lead", (0.24, 0.34, 0.035), {"strap": "fabric_red"},
        "A dog's lead."),
    held("megaphone", "bullhorn, loudhailer, loud hailer, speaking trumpet", (0.22, 0.34, 0.3),
        {"horn": "paint", "grip": "fabric_red"}, "A megaphone.", {"color": "#d9d5ca"}),
    held("toothbrush", "tooth brush, electric toothbrush", (0.013, 0.19, 0.02),
        {"body": "fabric_blue", "bristle": "linen"}, "A toothbrush."),
    held("toothpaste", "tube of toothpaste, toothpaste tube, tube, tube of paint, tube of cream, tube of glue, "
         "paint tube", (0.05, 0.18, 0.034), {"body": "plastic", "band": "fabric_red", "cap": "fabric_blue"},
        "A tube.", {"color": "#e4e0d6"}),
)  # fmt: skip

_HOME: tuple[PropEntry, ...] = (
    held("ice_cream_scoop", "scoop, ice-cream scoop, scooper, melon baller", (0.056, 0.21, 0.034),
        {"metal": "steel", "handle": "fabric_red"}, "An ice cream scoop."),
    held("thermos", "thermos flask, vacuum flask, insulated flask, coffee flask, coffee thermos, travel mug",
        (0.12, 0.09, 0.3), {"body": "paint", "metal": "steel", "cup": "fabric_red"}, "A vacuum flask.",
        {"color": "#2f4a3a"}),
    held("lunch_box", "lunchbox, lunch pail, lunch tin, bento box, packed lunch", (0.26, 0.14, 0.2),
        {"body": "paint", "metal": "steel"}, "A lunch box.", {"color": "#8a2f2a"}),
    held("sponge", "kitchen sponge, washing-up sponge, bath sponge, scouring pad, loofah", (0.11, 0.07, 0.035),
        {"foam": "brass", "rough": "leaves"}, "A sponge.", {"color": "#d8b43a"}),
    held("toast", "slice of toast, piece of toast, slice of bread, buttered toast, french toast",
        (0.11, 0.11, 0.016), {"crumb": "linen", "crust": "wood_light", "butter": "wax"}, "A slice of toast.",
        {"color": "#c98f4a"}),
    held("sausage", "sausages, string of sausages, link of sausages, frankfurter, bratwurst, salami, chorizo",
        (0.26, 0.05, 0.032), {"meat": "leather"}, "Sausages.", {"color": "#8a4426"}),
    held("wallet", "billfold, money clip, pocketbook, leather wallet, card case", (0.115, 0.09, 0.022),
        {"leather": "leather", "notes": "fabric_green"}, "A wallet."),
    held("lipstick", "lip balm, lip gloss, tube of lipstick", (0.02, 0.02, 0.08),
        {"stick": "fabric_red", "case": "gold"}, "A lipstick."),
    held("pill_bottle", "pills, bottle of pills, pill box, prescription bottle, medication, aspirin, "
         "painkillers, sleeping pills, vitamins, pill", (0.044, 0.06, 0.085),
        {"body": "glass_amber", "label": "paper", "cap": "porcelain"}, "A bottle of pills."),
    held("milk_carton", "carton of milk, juice carton, carton of juice, milk container, orange juice carton, juice box",
        (0.085, 0.085, 0.24), {"card": "porcelain", "band": "fabric_blue"}, "A carton of milk."),
    held("credit_card", "bank card, debit card, charge card, library card, gift card, business card, plastic card",
        (0.086, 0.054, 0.001), {"body": "fabric_blue"}, "A bank card."),
    held("firework", "fireworks, rocket firework, fireworks rocket, roman candle, bottle rocket, skyrocket",
        (0.05, 0.05, 0.5), {"paper": "fabric_red", "stripe": "gold"}, "A firework rocket."),
    held("firecrackers", "firecracker, string of firecrackers, banger, bangers, cracker string", (0.08, 0.26, 0.02),
        {"paper": "fabric_red"}, "A plait of firecrackers."),
    held("cymbal", "cymbals, brass cymbal, crash cymbal, hi-hat", (0.4, 0.4, 0.08),
        {"brass": "brass", "strap": "leather"}, "A cymbal."),
    held("car_battery", "truck battery, lead battery, battery pack, accumulator", (0.24, 0.175, 0.2),
        {"body": "plastic_black", "lid": "plastic"}, "A car battery."),
)  # fmt: skip

_YARD: tuple[PropEntry, ...] = (
    entry("vehicle", "excavator", "digger, backhoe, jcb, mechanical digger, bulldozer, earthmover, steam shovel",
        (2.46, 7.2, 3.46), {"body": "paint", "track": "iron"}, "An excavator.", params={"color": "#d0a02a"}, seats=1),
    entry("fitting", "standing_fan", "floor fan, pedestal fan, stand fan, upright fan, big fan, wind machine",
        (0.44, 0.44, 1.3), {"base": "plastic_black", "metal": "steel"}, "A fan on a stand.", holdable=True),
    entry("furniture", "mattress", "bare mattress, old mattress, air mattress, crash mat, gym mat",
        (0.95, 1.95, 0.2), {"cover": "linen", "piping": "fabric_blue"}, "A mattress.", seats=1),
    entry("furniture", "ironing_board", "ironing table", (1.3, 0.38, 0.9), {"cover": "fabric_blue"},
        "An ironing board."),
    held("golf_club", "golf iron, putter, driver club, nine iron, polo mallet, croquet mallet", (0.115, 0.07, 0.98),
        {"metal": "chrome", "grip": "rubber"}, "A golf club."),
    held("hockey_stick", "ice hockey stick, field hockey stick, hurley", (0.42, 0.05, 1.4),
        {"wood": "wood_light", "tape": "plastic_black"}, "A hockey stick."),
    held("skis", "ski, pair of skis, snow skis, water skis", (0.26, 0.13, 1.75), {"board": "paint"},
        "A pair of skis.", {"color": "#9c2622"}),
)  # fmt: skip

ORDINARY: tuple[PropEntry, ...] = _HARDWARE + _DESK + _WORN + _HOME + _YARD
"""By where they are found: hardware, the desk, on people, the home, outdoors."""

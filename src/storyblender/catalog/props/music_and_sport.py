"""Catalog entries of props: instruments, sport and prizes."""

from __future__ import annotations

from storyblender.catalog.props.entry import PropEntry, entry, held

MUSIC_AND_SPORT: tuple[PropEntry, ...] = (
    held("drum", "drums, snare drum, bongo, tom-tom, tambourine, side drum, drum set, drum kit, toy drum",
        (0.4, 0.4, 0.28), {"shell": "fabric_red", "hoop": "wood", "skin": "linen"}, "A side drum with its sticks."),
    held("flute", "recorder, clarinet, oboe, piccolo, fife, tin whistle, penny whistle, pan pipes",
        (0.62, 0.024, 0.034), {"body": "silver", "metal": "chrome"}, "A flute."),
    entry("furniture", "harp", "concert harp, celtic harp, lyre", (0.42, 0.95, 1.7),
        {"body": "gold", "string": "linen"}, "A concert harp; the player is at +Y."),
    held("accordion", "squeezebox, concertina, bandoneon, melodeon", (0.46, 0.22, 0.38),
        {"body": "fabric_red", "bellows": "leather_black"}, "An accordion."),
    held("racket", "tennis racket, badminton racket, racquet, squash racket", (0.27, 0.035, 0.69),
        {"frame": "wood_light", "string": "linen", "grip": "leather_black"}, "A racket."),
    held("bat", "baseball bat, club, cudgel, juggling club, cricket bat, pool cue, cue", (0.068, 0.068, 0.84),
        {"wood": "wood_light", "grip": "leather_black"}, "A baseball bat."),
    held("dumbbell", "weight, hand weight, barbell, dumbbells, kettlebell", (0.32, 0.13, 0.13),
        {"iron": "iron", "bar": "chrome"}, "A dumbbell."),
    held("trophy", "prize, prize cup, loving cup, award, statuette, sports cup, silver cup", (0.26, 0.17, 0.36),
        {"cup": "gold", "base": "wood_black"}, "A cup with two handles."),
    held("balloon", "toy balloon, party balloon, red balloon, balloons, bunch of balloons", (0.28, 0.28, 1.05),
        {"skin": "plastic"}, "A balloon on its string.", {"color": "#b3241c"}),
)  # fmt: skip

"""The motions people can perform: names, tags, durations, postures. Pure data and arithmetic.

The clips that play them are in ``blender/motion/clips``; the Director's motion vocabulary maps onto them here.
"""

from __future__ import annotations

import math

from storyblender.catalog.acts import ACTS
from storyblender.catalog.motion_entry import AWAKE, UPRIGHT, Motion
from storyblender.catalog.registry import Catalog

TURN_IN_STRIDE = 50.0
"""Largest turn, in degrees, within the steps of a walk; larger ones are done on the spot."""
TURN_STEP, TURN_STEP_SECONDS = 55.0, 0.26
"""Turning on the spot: degrees for which both feet step once, and the seconds of each step."""

AIMED: frozenset[str] = frozenset({"put_down", "look"})
"""Motions whose mark is the place of a prop or of a look, not of the person."""

IN_THEIR_SEAT: dict[str, str] = {
    "hit": "slam", "punch": "raise_fist", "push": "offer", "push_away": "halt", "pull": "row", "bow": "nod",
    "bend": "look_down", "curtsy": "nod", "recoil": "flinch", "cower": "cover_face", "dance": "clap",
    "stamp": "raise_fist", "guard": "raise_fist",
}  # fmt: skip
"""Motion of a standing person -> the motion of a seated one instead."""

MOTIONS: Catalog[Motion] = Catalog(
    "motion",
    (
        Motion("idle", "stand at ease", ("wait", "stay"), 1.0, ("idle",), stretches=True),
        Motion("stand", "stand", ("on their feet",), 1.0, ("stand",), stretches=True),
        # travel
        Motion("walk", "walk", ("go", "enter", "leave", "cross"), 0.9, ("walk",), 1.25, True, UPRIGHT, "stand",
            "place"),
        Motion("run", "run", ("rush", "flee", "chase"), 0.6, ("run",), 3.1, True, UPRIGHT, "stand", "place"),
        Motion("hurry", "hurry", ("storm out", "stride off", "walk fast"), 0.7, ("hurry",), 1.9, True, UPRIGHT, "stand",
            "place"),
        Motion("sneak", "sneak", ("tiptoe", "creep"), 0.8, ("sneak",), 0.7, True, UPRIGHT, "stand", "place"),
        Motion("stagger", "stagger", ("limp", "stumble"), 0.8, ("stagger",), 0.75, True, UPRIGHT, "stand", "place"),
        Motion("crawl", "crawl", ("on all fours",), 2.2, ("crawl",), 0.55, True, UPRIGHT, "stand", "place"),
        Motion("turn", "turn around", ("spin", "face"), 1.3, ("turn",), before=AWAKE, telling=0.95),
        Motion("jump", "jump", ("leap", "hop"), 1.6, ("jump",), before=UPRIGHT, after="stand", telling=0.45),
        Motion("climb", "climb", ("clamber", "scale"), 3.5, ("climb",), None, True, UPRIGHT, "stand", "thing", 0.55,
            2, telling=0.6),
        # seats, beds, floor
        Motion("sit", "sit down", ("take a seat",), 1.4, ("sit",), None, False, UPRIGHT, "sit", "thing", telling=0.95),
        Motion("rise", "stand up", ("get up", "rise"), 1.7, ("stand_up",), after="stand", telling=0.9),
        Motion("get_up", "get up", ("from the floor", "out of bed"), 3.2, (), after="stand", telling=0.9),
        Motion("kneel", "kneel down", ("on one knee",), 1.1, ("kneel",), None, False, UPRIGHT, "kneel", telling=0.97),
        Motion("crouch", "crouch", ("duck", "squat"), 0.9, ("crouch",), None, False, UPRIGHT, "crouch", telling=0.97),
        Motion("hide", "hide", ("take cover",), 1.0, ("hide",), None, False, UPRIGHT, "crouch", telling=0.97),
        Motion("lie_down", "lie down", ("recline",), 3.8, ("lie_down",), None, False, ("stand", "sit"), "lie",
            "thing", telling=0.97),
        Motion("sleep", "sleep", ("doze",), 1.2, ("sleep",), stretches=True, telling=0.9),
        Motion("wake", "wake up", ("stir",), 1.2, ("wake",), telling=0.8),
        Motion("fall", "fall down", ("collapse", "faint", "die"), 1.5, ("fall",), None, False, AWAKE, "lie",
            telling=0.95),
        Motion("lean", "lean", ("against a wall", "on the bar"), 1.2, ("lean",), None, False, UPRIGHT, "lean",
            "thing", telling=0.97),
        # off the floor
        Motion("hang", "hang", ("dangle", "cling", "hang from a rope"), 1.0, ("hang", "dangle"), before=UPRIGHT,
            after="hang", telling=0.97),
        Motion("upside_down", "hang upside down", ("head down",), 1.0, ("upside_down",), before=UPRIGHT,
            after="upside_down", telling=0.97),
        Motion("float", "float", ("drift", "hover", "levitate"), 1.0, ("float", "swim"), before=UPRIGHT,
            after="float", telling=0.97),
        Motion("ride", "ride", ("on horseback", "on a bicycle", "mount"), 1.0, ("ride", "mount"), before=UPRIGHT,
            after="ride", telling=0.97),
        Motion("on_all_fours", "on all fours", ("hands and knees",), 1.0, (), before=UPRIGHT, after="crawl",
            telling=0.97),
        # gaze and head
        Motion("face", "put on a face", ("show a feeling",), 0.3),
        Motion("look", "look", ("watch", "stare", "glance"), 0.6, ("look",), stretches=True, telling=0.9),
        Motion("listen", "listen", ("hear", "attend"), 2.0, ("listen",), stretches=True),
        Motion("look_around", "look around", ("scan the room",), 2.5, ("look_around",)),
        Motion("peek", "peek", ("spy",), 2.1, ("peek",), telling=0.5),
        Motion("nod", "nod", ("agree",), 1.05, ("nod",), telling=0.22),
        Motion("shake_head", "shake the head", ("no",), 1.05, ("shake_head",), telling=0.4),
        Motion("think", "think", ("ponder",), 2.4, ("think",), stretches=True, hands=1),
        # voice
        Motion("talk", "talk", ("say", "speak"), 2.5, ("talk",), stretches=True),
        Motion("whisper", "whisper", ("murmur",), 2.0, ("whisper",), stretches=True),
        Motion("shout", "shout", ("yell", "scream"), 1.6, ("shout",), stretches=True),
        Motion("laugh", "laugh", ("giggle",), 2.0, ("laugh",), stretches=True),
        Motion("cry", "cry", ("weep",), 3.0, ("cry",), stretches=True, hands=2),
        # signs
        Motion("point", "point", ("indicate",), 2.0, ("point",), stretches=True, before=AWAKE, hands=1),
        Motion("wave", "wave", ("greet",), 2.25, ("wave", "shake"), before=AWAKE, hands=1),
        Motion("shrug", "shrug", ("who knows",), 1.55, ("shrug",), hands=2, telling=0.5),
        Motion("salute", "salute", (), 1.9, ("salute",), stretches=True, before=AWAKE, hands=1),
        Motion("clap", "clap", ("applaud",), 2.5, ("clap",), stretches=True, before=AWAKE, hands=2),
        Motion("pray", "pray", (), 3.0, ("pray",), stretches=True, hands=2, lasts=True),
        Motion("bow", "bow", ("curtsy",), 1.9, ("bow",), before=UPRIGHT, telling=0.48),
        Motion("dance", "dance", ("waltz",), 4.0, ("dance",), None, True, UPRIGHT, distance=0.5, hands=2),
        # props
        Motion("hold", "hold", ("grip", "carry"), 0.5, ("hold", "carry"), stretches=True, hands=1),
        Motion("pick_up", "pick up", ("lift", "grab"), 2.0, ("pick_up",), reach="thing", distance=0.5, hands=1,
            telling=0.95),
        Motion("put_down", "put down", ("set", "place"), 1.8, ("put_down",), reach="thing", distance=0.5, hands=1,
            telling=0.86),
        Motion("drop", "drop", ("let fall",), 1.0, ("drop",), hands=1, telling=0.5),
        Motion("throw", "throw", ("toss", "hurl"), 1.6, ("throw",), before=AWAKE, hands=1, telling=0.5),
        Motion("drink", "drink", ("sip",), 2.85, ("drink",), hands=1, telling=0.5),
        Motion("eat", "eat", ("bite", "chew"), 2.2, ("eat",), hands=1, telling=0.42),
        Motion("smoke", "smoke", ("puff",), 2.6, ("smoke",), hands=1),
        Motion("pour", "pour", ("fill",), 2.8, ("pour",), hands=1, telling=0.6),
        Motion("phone", "telephone", ("call",), 2.5, ("phone",), stretches=True, hands=1, lasts=True),
        Motion("read", "read", ("leaf",), 3.0, ("read",), stretches=True, hands=2, lasts=True),
        Motion("write", "write", ("sign", "draw"), 3.0, ("write",), stretches=True, hands=2, lasts=True),
        Motion("cross_out", "cross out a line of a text", ("strike out words", "tick off a list"), 2.0, ("cross_out",),
            stretches=True, hands=2, lasts=True),
        Motion("aim", "aim a gun", ("point a gun",), 1.2, ("aim",), before=AWAKE, hands=2, telling=0.8, lasts=True),
        Motion("shoot", "shoot", ("fire",), 1.7, ("shoot",), before=AWAKE, hands=2, telling=0.55),
        # two people
        Motion("give", "hand over", ("pass", "offer"), 2.3, ("give",), reach="person", distance=0.78, hands=1),
        Motion("take", "take", ("accept", "snatch"), 2.3, ("take",), reach="thing", distance=0.5, hands=1, telling=0.6),
        Motion("catch", "catch", ("be thrown",), 2.2, ("catch",), before=AWAKE, reach="thing", distance=0.5, hands=1,
            telling=0.8),
        Motion("shake_hands", "shake hands", (), 2.9, ("shake_hands",), reach="person", distance=0.75, hands=1),
        Motion("hug", "hug", ("embrace",), 3.9, ("hug",), reach="person", distance=0.34, hands=2),
        Motion("lift", "lift somebody", ("swing up", "raise"), 3.6, (), None, False, UPRIGHT, None, "person", 0.5, 2,
            telling=0.6),
        Motion("kiss", "kiss", (), 3.9, ("kiss",), reach="person", distance=0.34, hands=2),
        Motion("touch", "touch", ("stroke", "comfort"), 2.5, ("touch",), reach="person", distance=0.6, hands=1),
        Motion("hit", "hit", ("slap", "punch"), 1.5, ("hit", "fight"), None, False, UPRIGHT, None, "person", 0.55, 1,
            telling=0.36),
        Motion("kick", "kick", ("stomp",), 1.2, ("kick",), None, False, UPRIGHT, None, "thing", 0.7, telling=0.45),
        # the set
        Motion("open", "open", ("unlock", "uncover"), 2.4, ("open",), reach="thing", distance=0.5, hands=1,
            telling=0.75),
        Motion("close", "close", ("shut", "lock"), 2.4, ("close",), reach="thing", distance=0.5, hands=1, telling=0.75),
        Motion("knock", "knock", ("rap",), 2.5, ("knock",), reach="thing", distance=0.5, hands=1, telling=0.4),
        Motion("press", "press", ("switch", "ring"), 2.0, ("press", "light"), reach="thing", distance=0.5, hands=1,
            telling=0.45),
        Motion("push", "push", ("shove",), 2.9, ("push",), None, True, UPRIGHT, None, "thing", 0.5, 2, telling=0.6),
        Motion("pull", "pull", ("drag",), 2.9, ("pull",), None, True, UPRIGHT, None, "thing", 0.5, 2, telling=0.6),
        Motion("type", "type", ("keyboard",), 3.0, ("type",), stretches=True, hands=2, lasts=True),
        Motion("play_guitar", "play the guitar", ("strum", "banjo", "lute, ukulele"), 4.0, ("play_guitar",),
            stretches=True, hands=2, lasts=True),
        Motion("play_piano", "play the piano", ("keyboard, organ", "any other instrument", "music"), 4.0,
            ("play_music",), stretches=True, hands=2, lasts=True),
        Motion("wipe", "wipe", ("clean", "stir", "cook"), 3.0, ("clean",), stretches=True, reach="thing",
            distance=0.5, hands=1, lasts=True),
        Motion("work", "work", ("hammer", "dig", "cut"), 3.2, ("work",), stretches=True, reach="thing", distance=0.5,
            hands=2, lasts=True),
        Motion("search", "search", ("rummage",), 3.2, ("search",), stretches=True, reach="thing", distance=0.5,
            hands=2),
        Motion("dress", "put on or take off clothes", ("wear", "undress"), 2.4, ("wear", "take_off"), hands=2,
            telling=0.6),
        *(act.motion for act in ACTS.values()),
    ),
)  # fmt: skip
"""Every motion, in the order of the printed catalogue."""

FIELDS: dict[str, str] = {
    "give": "target: the person who gets it; prop: the thing",
    "take": "target: the person it is taken from, or what it lies on; prop: the thing",
    "catch": "target: the person who throws it; prop: the thing",
    "throw": "target: the person or thing it is thrown at; prop: the thing",
    "offer": "target: the person; prop: the thing held out, which is not yet taken",
    "show": "target: the person; prop: the thing held up",
    "drive": "target: the vehicle; no prop; a person who is driven has no action",
    "ride": "target: the animal or the bicycle; no prop",
    "pick_up": "prop: the thing; target: what it lies on",
    "put_down": "prop: the thing; target: what it is put on or in",
    "pull": "target: the person or thing that is pulled",
    "push": "target: the person or thing that is pushed",
    "aim": "target: the person or thing aimed at; prop: the weapon",
    "shoot": "target: the person or thing shot at; prop: the weapon",
    "write": "target: the paper or what it lies on; prop: the pen",
    "cross_out": "target: the paper or what it lies on; prop: the pen",
    "pour": "prop: the bottle; target: the glass",
    "strike_match": "prop: the matches or the lighter; target: what is lit",
    "feed": "target: the person; prop: the spoon or the food",
    "lean_on_stick": "prop: the stick",
    "lower_weapon": "prop: the weapon",
    "bid": "prop: the paddle or card",
    "shoulder": "prop: the long thing",
    "grip_rail": "target: the ladder, rail or gate",
    "adjust_mirror": "target: the mirror",
    "peer_through": "target: what is looked at or through",
}
"""What ``target`` and ``prop`` of an action are, by motion, for those who write actions."""

FIRST_STRESS = 1.1
"""Seconds into a speech at which a picture shows it: hands raised, mouth open; half of a short speech."""

MOCAP = "idle"
"""The motion under a recorded one that the catalogue has nothing like."""

STANDING: frozenset[str] = frozenset({"idle", "stand"})
"""Motions that show no action; on ``stand`` who sits or lies gets up first."""

MOTION_KEYS: dict[str, str] = {key: key for key in MOTIONS} | {
    word: motion.key for motion in MOTIONS.values() for word in motion.directs
}
"""Motion of the Director's vocabulary, or key of ``MOTIONS`` -> key of ``MOTIONS``; the graph holds keys only."""
_CALLED: dict[str, str] = {
    word.replace("_", " "): motion.key
    for motion in reversed(list(MOTIONS.values()))
    for word in (*motion.tags, motion.name, motion.key)
} | {word.replace("_", " "): key for word, key in MOTION_KEYS.items()}
"""Name or synonym -> key of the motion; the first motion with a name wins."""


def motion_words(key: str, tags: int = 3) -> str:
    """Return what a motion is in a line: its name, ``tags`` other words, and what target and prop are."""
    motion = MOTIONS[key]
    named = ", ".join(dict.fromkeys((motion.name, *motion.tags[:tags])))
    return f"{named} ({FIELDS[key]})" if key in FIELDS else named


def motion_called(words: str) -> str | None:
    """Return the key of the motion that words name: all words, else verb and particle, else the verb; else None.

    Args:
        words: Such as ``leaning over``; the verb may be inflected.
    """
    verb, *rest = words.lower().replace("_", " ").split() or [""]
    said = (" ".join((form, *rest[:count])) for count in range(len(rest), -1, -1) for form in _base_forms(verb))
    return next((_CALLED[each] for each in said if each in _CALLED), None)


def _base_forms(verb: str) -> list[str]:
    """Return the possible base forms of an inflected verb."""
    forms = [verb]
    for ending in ("ing", "es", "s", "ed", "d"):
        stem = verb.removesuffix(ending)
        if stem != verb and len(stem) > 2:
            forms += [stem, f"{stem}e", stem[:-1] if stem[-1] == stem[-2] else stem]
    return forms


def natural_seconds(motion: Motion, *, distance: float = 0.0, stature: float = 1.7) -> float:
    """Return the duration of a motion.

    Args:
        motion: The motion.
        distance: Metres to travel, for motions that travel.
        stature: Metres; duration and speed grow with its square root.
    """
    root = math.sqrt(stature / 1.7)
    seconds = motion.seconds * (root if motion.speed or motion.after else 1.0)
    if motion.speed and distance > 0:
        seconds += distance / (motion.speed * root)
    return seconds


def stressed_moment(start: float, end: float) -> float:
    """Return the second of a speech from ``start`` to ``end`` at which a picture shows it."""
    return start + min((end - start) / 2, FIRST_STRESS)


def turning_seconds(degrees: float, stature: float = 1.7) -> float:
    """Return the seconds of a turn on the spot; small turns take none, as they are part of a walk's steps.

    Args:
        degrees: Angle turned, to either side.
        stature: Metres; the duration grows with its square root.
    """
    if abs(degrees) <= TURN_IN_STRIDE:
        return 0.0
    return 2 * TURN_STEP_SECONDS * math.ceil(abs(degrees) / TURN_STEP) * math.sqrt(stature / 1.7) + 0.1

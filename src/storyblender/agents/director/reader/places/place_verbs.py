"""Verbs by what they tell of where somebody or something is."""

from __future__ import annotations

from storyblender.agents.director import lexicon

STATIVE, ATTACHING = lexicon.words("stative"), lexicon.words("attaching")
TURNING = frozenset({"turn", "hesitate"})
"""``turns at the door``."""
HALTING = frozenset({"stop", "pause", "halt"})
"""``stops at the counter``."""
ARRIVING = TURNING | HALTING | {"drop", "emerge", "step", "watch", "follow", "appear", "pull"}
"""Verbs that place only relative to people: behind, before, beside."""
GETTING_DOWN = frozenset({"hop", "jump", "leap", "drop", "slide", "climb", "clamber", "spring"})
"""``hops to the floor``."""
HANGING = frozenset({"hang", "dangle", "swing", "droop", "suspend", "sway"})
"""``swings from a hook`` is on it."""
BENT = frozenset({"bend", "stoop", "hunch", "bow"})
"""``is bent over the desk``, but who bends over it does not stay so."""
TOUCHING = frozenset(
    {"bang", "tap", "pound", "rap", "thump", "stamp", "wipe", "rub", "strike", "knock", "drum", "draw"}
)
"""``bangs her stick on the floor``, ``draws a cross on it``."""

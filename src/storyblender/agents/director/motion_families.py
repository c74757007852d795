"""Families of motions by what of the body must be seen (notes of the director, section 2)."""

from __future__ import annotations

from typing import Final

from storyblender.agents.director import lexicon
from storyblender.catalog.acts import ACTS

TRAVEL: Final = lexicon.words("travel")
"""The whole body must stay in frame."""
WHOLE_BODY: Final = frozenset({
    "sit", "stand_up", "lie_down", "kneel", "crouch", "bow", "fight", "hit", "kick", "push", "pull", "throw", "hug",
    "work", "cook", "clean", "lean", "hide", "turn", "carry", "stand", "sleep", "wake", "play_music",
    "hang", "float", "upside_down", *(act.key for act in ACTS.values() if act.bodily),
})  # fmt: skip
"""Hips and knees tell it."""
HANDS: Final = frozenset({
    "give", "take", "pick_up", "put_down", "hold", "open", "close", "press", "type", "write", "read", "phone", "pour",
    "cut", "light", "knock", "touch", "shake_hands", "catch", "drop", "wear", "take_off", "aim", "shoot", "point",
    "wave", "search", *(act.key for act in ACTS.values() if act.hands and not act.bodily),
})  # fmt: skip
"""Hands, and the faces above them."""
FAST: Final = frozenset({"run", "ride", "drive"})
"""The camera must travel along."""
LOW: Final = frozenset({"fall", "lie_down", "crawl"})
"""Seen from above."""
POSES: Final = frozenset({"sit", "lie_down", "kneel", "crouch", "lean", "stand", "sleep"})
"""Where a scene opens on one of these, it is a state, not a movement."""
POSING: Final = POSES | {"stand_up", "wake", "fall", "bow", "turn"}
"""Motions that end in a posture."""
PORTABLE: Final = frozenset({"phone", "sing", "talk", "carry", "drive", "ride", "play_music"})
"""Lasting activities that go on while a person walks."""
GETTING: Final = frozenset({"take", "pick_up", "catch"})
"""A thing comes into the hand."""
PARTING: Final = frozenset({"give", "throw", "drop", "put_down"})
"""A thing leaves the hand that held it."""
HOLDING: Final = frozenset({"hold", "carry", "aim"})
"""A thing is in the hand already."""
STRONG: Final = PARTING | GETTING | frozenset({
    "hug", "kiss", "hit", "kick", "push", "pull", "fight", "shoot", "aim", "fall", "shake_hands", "touch", "dance",
    "light", "cut", "pour", *(act.key for act in ACTS.values() if act.reach == "person" or act.reach == "thing"),
})  # fmt: skip
"""What a picture is remembered by; two of them want two pictures."""
SPOKEN: Final = frozenset({"talk", "whisper", "shout", "sing"})

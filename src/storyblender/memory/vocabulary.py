"""The closed vocabularies of the field. The paper's values keep their spelling; ours extend them."""

from __future__ import annotations

from typing import Literal

AssetType = Literal["character", "object"]
SceneType = Literal["indoor", "outdoor"]
ModificationType = Literal["add", "remove", "transform"]

Age = Literal["medieval", "west", "victorian", "classic", "space", "today"]
"""When a story plays."""

ShotKind = Literal["establishing", "action", "two_shot", "group", "ots", "single", "reaction", "insert", "pov"]
Angle = Literal["eye-level", "high angle", "low angle", "bird's-eye", "worm's-eye", "dutch"]
Movement = Literal[
    "static",
    "pan",
    "tilt",
    "orbit",
    "push in",
    "pull out",
    "truck",
    "pedestal",
    "zoom in",
    "zoom out",
    "track",
]
CameraDirection = Literal["left", "right", "up", "down"]

Relationship = Literal["on_top_of", "on_the_left_of", "on_the_right_of", "in_front_of", "behind"]
Facing = Literal["facing", "facing_away", "left_side_facing", "right_side_facing"]
RelationKind = Literal[
    "on", "in", "under", "over", "behind", "in_front_of", "next_to", "at", "against", "between", "facing",
    "left_of", "right_of", "inside", "above", "around",
]  # fmt: skip
Posture = Literal[
    "stand", "sit", "lie", "kneel", "crouch", "lean", "asleep",
    "crawl", "hang", "upside_down", "float", "ride",
]  # fmt: skip
Expression = Literal[
    "neutral", "smile", "laugh", "sad", "cry", "angry", "rage", "afraid", "terrified", "surprised", "disgusted",
    "pained", "tender", "thoughtful", "suspicious", "tired",
]  # fmt: skip
Grip = Literal["right", "left", "both", "under_arm", "shoulder", "lap", "mouth", "worn"]
"""How a thing is carried: in which hand, or where on the body."""
BodyPlace = Literal[
    "head", "face", "ears", "mouth", "neck", "chest", "back", "hip", "shoulder", "under_arm", "lap",
]  # fmt: skip
"""Where on the body a thing is that no hand holds."""
GazeDirection = Literal["left", "right", "up", "down", "camera", "closed"]
"""Direction of a gaze at nothing in the set, from the viewer's side; ``closed`` for closed eyes."""
Side = Literal["left", "right", "front", "back", "driver", "passenger", "rear"]
"""A side of a thing, from its own point of view; the last three are seats and doors of a vehicle."""
TetherKind = Literal["leash", "rope", "chain", "hand"]
Moment = Literal["start", "middle", "end"]
"""Which moment of its script lines a panel shows; ``end`` is after the last action."""
Hand = Literal["L", "R"]
Aperture = Literal["binoculars", "keyhole", "scope", "tube", "viewfinder", "slats", "bars", "panes", "gap"]
"""What a POV looks through; ``tube`` is a telescope or a porthole, ``gap`` a door ajar."""
BodyPart = Literal["hand", "eyes", "mouth", "feet"]
Mood = Literal["neutral", "happy", "sad", "angry", "afraid", "tender"]
TimeOfDay = Literal["dawn", "morning", "day", "noon", "afternoon", "sunset", "dusk", "evening", "night"]
SizeWord = Literal[
    "tiny", "minuscule", "miniature", "small", "little", "low", "short", "narrow", "compact", "big", "large", "tall",
    "wide", "long", "broad", "huge", "enormous", "massive", "giant", "gigantic", "towering", "colossal",
]  # fmt: skip
"""Words for the size of a thing; of several the first counts."""
StatureWord = Literal["tall", "towering", "giant", "huge", "big", "short", "small", "little", "petite", "tiny"]
"""Words for the stature of a person; of several the first counts."""
LightQuality = Literal["dim", "bright", "harsh", "soft", "candlelight", "cold", "warm", "red"]
"""The character of a light, besides its hour and weather."""
Weather = Literal["clear", "cloudy", "fog", "rain", "storm", "snow"]
Period = Literal["past", "classic", "modern"]
"""When a place was furnished; past: before electric light; classic: about 1900 to 1970."""
Crowd = Literal["busy", "full"]
"""How full of background people a place is."""
ThingState = Literal[
    "open", "closed", "on", "off", "lit", "unlit", "running", "overflowing", "flickering", "dim", "burning", "smoking",
    "steaming", "broken", "mended", "torn", "tipped", "spilled", "upright", "full", "empty", "wet", "dry", "dirty",
    "clean", "bloody", "gone", "there", "lettered",
]  # fmt: skip
"""What the story changes about a thing; ``lettered``: other words are written on it."""
Gender = Literal["female", "male", "unknown"]

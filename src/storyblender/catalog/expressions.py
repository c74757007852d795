"""Facial expressions: shape keys, the sixteen expressions mixed from them. Data."""

from __future__ import annotations

from collections.abc import Mapping

from storyblender.memory.vocabulary import Mood

FACE_UNITS: Mapping[str, Mapping[str, float]] = {
    "mouth_open": {"mouth-open": 0.7, "mouth-depression": 0.3},
    "smile": {"mouth-corner-puller": 1.0},
    "blink": {"eye-left-closure": 1.0, "eye-right-closure": 1.0},
    "brow_up": {"eyebrows-left-up": 1.4, "eyebrows-right-up": 1.4},
    "brow_down": {"eyebrows-left-down": 1.3, "eyebrows-right-down": 1.3},
    "grin": {"mouth-upward-retraction": 1.0},
    "frown": {"mouth-depression": 1.0},
    "worry": {"eyebrows-left-inner-up": 1.4, "eyebrows-right-inner-up": 1.4},
    "wide": {"eye-left-opened-up": 1.4, "eye-right-opened-up": 1.4},
    "squint": {"eye-left-slit": 0.5, "eye-right-slit": 0.5},
    "snarl": {"mouth-part-later": 0.8, "nose-left-elevation": 1.0, "nose-right-elevation": 1.0},
    "purse": {"mouth-pursing": 1.4},
    "wail": {"mouth-depression-retraction": 1.0},
    "wrinkle": {
        "nose-compression": 1.1, "nose-left-elevation": 1.1, "nose-right-elevation": 1.1, "mouth-elevation": 0.5,
    },
}  # fmt: skip
"""Shape keys of a person's face, each with the MakeHuman units it is mixed from."""
FACE: tuple[str, ...] = tuple(FACE_UNITS)
"""Names of the face values in their fixed order."""

EXPRESSIONS: Mapping[str, Mapping[str, float]] = {
    "neutral": {},
    "smile": {"smile": 1.0, "squint": 0.25, "brow_up": 0.1},
    "laugh": {"grin": 1.0, "mouth_open": 0.45, "squint": 0.7, "brow_up": 0.2},
    "sad": {"frown": 0.8, "worry": 0.95, "blink": 0.3},
    "cry": {"wail": 0.55, "frown": 0.9, "worry": 1.0, "blink": 0.75},
    "angry": {"brow_down": 0.85, "frown": 0.5, "squint": 0.4, "wrinkle": 0.25},
    "rage": {"brow_down": 1.0, "snarl": 0.8, "mouth_open": 0.7, "wide": 0.2, "wrinkle": 0.35},
    "afraid": {"worry": 0.85, "brow_up": 0.35, "wide": 0.65, "mouth_open": 0.15, "wail": 0.35},
    "terrified": {"worry": 0.85, "brow_up": 0.65, "wide": 1.0, "mouth_open": 0.85, "wail": 0.3},
    "surprised": {"brow_up": 1.0, "wide": 0.7, "mouth_open": 0.5},
    "disgusted": {"brow_down": 0.45, "squint": 0.6, "wrinkle": 1.0, "frown": 0.6},
    "pained": {"brow_down": 0.55, "worry": 0.55, "blink": 0.8, "snarl": 0.5, "wrinkle": 0.55},
    "tender": {"smile": 0.6, "worry": 0.4, "blink": 0.15},
    "thoughtful": {"brow_down": 0.3, "purse": 0.35, "squint": 0.3},
    "suspicious": {"brow_down": 0.6, "squint": 0.9, "purse": 0.2, "frown": 0.3},
    "tired": {"blink": 0.5, "worry": 0.3, "frown": 0.35},
    # besides the sixteen: expressions used by single acts
    "asleep": {"blink": 1.0},
    "eyes_closed": {"blink": 1.0, "smile": 0.2},
    "whistle": {"purse": 1.0, "mouth_open": 0.06},
    "sing": {"mouth_open": 0.75, "brow_up": 0.4, "worry": 0.3},
    "yawn": {"mouth_open": 1.0, "blink": 0.85, "worry": 0.3},
    "kiss": {"purse": 0.7, "blink": 1.0},
}
"""Expression -> values of the shape keys, 0..1."""

OF_MOOD: Mapping[Mood, str] = {
    "neutral": "neutral", "happy": "smile", "sad": "sad", "angry": "angry", "afraid": "afraid", "tender": "tender",
}  # fmt: skip
"""Mood to facial expression."""


def values_of(weights: Mapping[str, float]) -> tuple[float, ...]:
    """Return the shape key values in the order of ``FACE``; missing keys are 0."""
    return tuple(weights.get(key, 0.0) for key in FACE)

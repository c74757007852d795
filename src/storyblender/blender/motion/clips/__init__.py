"""The clips: every motion a person can perform, one function each, registered by its key in ``catalog.motions``."""

from __future__ import annotations

from storyblender.blender.motion.clips import (
    acts,
    arms,
    crawling,
    dancing,
    embraces,
    floor,
    gaze,
    gesture,
    handling,
    leaps,
    lifting,
    locomotion,
    pairs,
    postures,
    seat,
    speech,
    support,
    throwing,
    using,
    work,
)
from storyblender.blender.motion.clips.registry import CLIPS, Clip, play

FAMILIES = (
    acts,
    arms,
    crawling,
    dancing,
    embraces,
    floor,
    gaze,
    gesture,
    handling,
    leaps,
    lifting,
    locomotion,
    pairs,
    postures,
    seat,
    speech,
    support,
    throwing,
    using,
    work,
)
"""Importing a family registers its clips."""

__all__ = ["CLIPS", "FAMILIES", "Clip", "play"]

"""The clips: one function for every motion a person can perform, registered by its key in ``catalog.motions``."""

from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules

from storyblender.blender.motion.clips.registry import CLIPS, Clip, play

for _family in iter_modules(__path__):
    import_module(f"{__name__}.{_family.name}")  # registers its clips

__all__ = ["CLIPS", "Clip", "play"]

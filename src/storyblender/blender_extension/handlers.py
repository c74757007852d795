"""What happens by itself: a file that is opened is read, and a running studio is asked what is new."""

import bpy
from bpy.app.handlers import persistent

from .story import STORY
from .work import WORK

_EVERY = 5.0
"""Seconds between two questions to a running studio."""


@persistent
def _opened(*_: object) -> None:
    STORY.opened()
    if STORY.project is not None:
        STORY.refresh("Reading the story")


@persistent
def _saved(*_: object) -> None:
    STORY.saved()


def _watch() -> float:
    """Ask a studio what is new, unless something is under way; alone, only what the person does changes the story."""
    if STORY.link == "studio" and not WORK.under_way:
        STORY.refresh()
    return _EVERY


def _begin() -> None:
    """Look at the file that is open already; Blender lets nothing be looked at while extensions are switched on."""
    _opened()


def register() -> None:
    """Begin to listen."""
    bpy.app.handlers.load_post.append(_opened)
    bpy.app.handlers.save_post.append(_saved)
    bpy.app.timers.register(_begin, first_interval=0.0)
    bpy.app.timers.register(_watch, first_interval=_EVERY, persistent=True)


def unregister() -> None:
    """Stop listening."""
    WORK.forget()
    for timer in (_begin, _watch):
        if bpy.app.timers.is_registered(timer):
            bpy.app.timers.unregister(timer)
    bpy.app.handlers.load_post.remove(_opened)
    bpy.app.handlers.save_post.remove(_saved)

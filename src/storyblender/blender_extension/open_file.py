"""The open file is saved before the program reads it, and opened again when the program has written it anew."""

from __future__ import annotations

from typing import Any

import bpy

from .shots_in_file import go_to
from .story import STORY

_NEWER = "story.blend was written anew: press Reload; what you changed here since you pulled is lost then"


def save_changes() -> None:
    """Save what was changed here."""
    if bpy.data.is_dirty:
        bpy.ops.wm.save_mainfile()


def taken_over(pulled: dict[str, Any]) -> None:
    """Tell what became of what a person changed here, and open the file that has it.

    Args:
        pulled: As the program says it.
    """
    ways = {"understood": "Taken over", "conflicts": "Conflict", "kept": "Not taken over, kept in a copy"}
    told = [f"{way}: {words}" for key, way in ways.items() for words in pulled[key]]
    STORY.told = told or ["Nothing was changed here."]
    open_anew()


def open_anew() -> None:
    """Open the file if it was written anew, unless something was changed here meanwhile: then say so."""
    if STORY.is_rewritten:
        if bpy.data.is_dirty:
            STORY.problem = _NEWER
        else:
            reload()


def reload() -> None:
    """Open the file as it is on disk, and go back to the shot that was looked at."""
    window = bpy.context.window_manager.windows[0]
    scene, frame, told = window.scene.name, window.scene.frame_current, STORY.told
    chosen = bpy.context.window_manager.storyblender.chosen
    bpy.ops.wm.open_mainfile(filepath=bpy.data.filepath, load_ui=False, use_scripts=False)
    STORY.told = told
    window = bpy.context.window_manager.windows[0]
    go_to(window, chosen)
    if window.scene.name == scene:
        window.scene.frame_set(frame)
    STORY.choose(chosen)

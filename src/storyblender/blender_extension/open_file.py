"""The open file is saved before the program reads it, and opened again when the program has written it anew."""

from __future__ import annotations

from typing import Any

import bpy

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
    said = {**pulled, "conflicts": [each["words"] for each in pulled["conflicts"]]}
    told = [f"{way}: {words}" for key, way in ways.items() for words in said[key]]
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
    """Open the file as it is on disk, and go back to where the person was."""
    window, told = bpy.context.window_manager.windows[0], STORY.told
    shown, frame = window.scene.name, window.scene.frame_current
    chosen = bpy.context.window_manager.storyblender.chosen
    bpy.ops.wm.open_mainfile(filepath=bpy.data.filepath, load_ui=False, use_scripts=False)
    STORY.told = told
    STORY.choose(chosen)
    scene = bpy.data.scenes.get(shown)
    if scene is not None:
        bpy.context.window_manager.windows[0].scene = scene
        scene.frame_set(frame)

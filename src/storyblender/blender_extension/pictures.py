"""The frames of the storyboard, shown in the panel and in image editors; the .blend keeps none of them."""

from __future__ import annotations

from pathlib import Path

import bpy
import bpy.utils.previews

_SHOWN: dict[str, bpy.utils.previews.ImagePreviewCollection] = {}


def icon_of(path: Path) -> int:
    """Return the number of a frame as an icon; a frame that is drawn anew gets another one.

    Args:
        path: Of the picture.
    """
    shown = _SHOWN["frames"]
    name = f"{path}?{path.stat().st_mtime_ns}"
    if name not in shown:
        for old in [key for key in shown if key.startswith(f"{path}?")]:
            del shown[old]
        shown.load(name, str(path), "IMAGE")
        _ = shown[name].image_size[0]  # loads it now, so that the panel that asks for it shows it
    return shown[name].icon_id


def show(path: Path | None) -> bool:
    """Show a frame in all image editors, as it is on disk now.

    Args:
        path: Of the picture; nothing is shown if there is none.

    Returns:
        Whether there is an image editor.
    """
    if path is None:
        return False
    image = bpy.data.images.load(str(path), check_existing=True)
    image.reload()
    windows = bpy.context.window_manager.windows
    editors = [area.spaces.active for window in windows for area in window.screen.areas if area.type == "IMAGE_EDITOR"]
    for editor in editors:
        editor.image = image
    return bool(editors)


def register() -> None:
    """Begin with no frames."""
    _SHOWN["frames"] = bpy.utils.previews.new()


def unregister() -> None:
    """Forget them."""
    bpy.utils.previews.remove(_SHOWN.pop("frames"))

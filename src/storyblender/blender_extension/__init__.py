"""The Blender extension: a panel to direct a storyboard from Blender.

It runs in the user's Blender, so it imports nothing of the program: it talks to a running studio, or runs the
command line. ``storyblender blender-extension`` writes it as a zip.
"""

from . import handlers, operators, panels, pictures, preferences, properties

_PARTS = (preferences, properties, pictures, operators, panels, handlers)


def register() -> None:
    """Add everything to Blender."""
    for part in _PARTS:
        part.register()


def unregister() -> None:
    """Take everything out of Blender again."""
    for part in reversed(_PARTS):
        part.unregister()

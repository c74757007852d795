"""What the user sets once: where the program is."""

import shutil

import bpy


class StoryBlenderPreferences(bpy.types.AddonPreferences):
    """Preferences of the extension."""

    bl_idname = __package__ or __name__

    program: bpy.props.StringProperty(
        name="Program",
        description="The command `storyblender`, which is run while no studio has the project open",
        subtype="FILE_PATH",
    )

    def draw(self, context: bpy.types.Context) -> None:
        """Show the preferences."""
        self.layout.prop(self, "program", placeholder=shutil.which("storyblender") or "storyblender is not on the path")
        self.layout.label(text="`storyblender blender-extension` says where it is. A studio needs no program.")


def program() -> str:
    """Return the path of the program; empty if it is neither set nor on the path."""
    addon = bpy.context.preferences.addons.get(__package__ or "")
    chosen = addon.preferences.program if addon is not None and addon.preferences is not None else ""
    return bpy.path.abspath(chosen) if chosen else shutil.which("storyblender") or ""


def register() -> None:
    """Add the preferences."""
    bpy.utils.register_class(StoryBlenderPreferences)


def unregister() -> None:
    """Take them out."""
    bpy.utils.unregister_class(StoryBlenderPreferences)

"""What the panel holds while Blender runs: the list, what is chosen in it, and the note that is being written."""

import bpy


class ShotRow(bpy.types.PropertyGroup):
    """A row of the list; its name is the shot's."""


class PanelState(bpy.types.PropertyGroup):
    """The state of the panel."""

    shots: bpy.props.CollectionProperty(type=ShotRow)
    active: bpy.props.IntProperty(name="Shot", description="The shot that is looked at")
    note: bpy.props.StringProperty(name="Note", description="What is to be done about this shot", maxlen=2000)

    @property
    def chosen(self) -> str:
        """Name of the shot that is looked at; empty if there is none."""
        return self.shots[self.active].name if 0 <= self.active < len(self.shots) else ""


def register() -> None:
    """Add the state to the window manager, which no file keeps."""
    bpy.utils.register_class(ShotRow)
    bpy.utils.register_class(PanelState)
    bpy.types.WindowManager.storyblender = bpy.props.PointerProperty(type=PanelState)


def unregister() -> None:
    """Take it out."""
    del bpy.types.WindowManager.storyblender
    bpy.utils.unregister_class(PanelState)
    bpy.utils.unregister_class(ShotRow)

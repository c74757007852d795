"""What the buttons do. Each is done at once in the file, or asked of the program, whose answer comes later."""

import bpy

from . import pictures
from .connection import Program, Studio
from .open_file import open_anew, reload, save_changes, taken_over
from .shots_in_file import go_to, shots
from .story import STORY


class ShotOperator(bpy.types.Operator):
    """Base of what needs a story."""

    bl_options = {"REGISTER"}

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Return whether there is one."""
        return STORY.project is not None

    def chosen(self, context: bpy.types.Context) -> str:
        """Return the shot that is looked at."""
        return context.window_manager.storyblender.chosen

    def edit(self, what: str, *edits: dict) -> set[str]:
        """Make edits of the story as one undo of it.

        Args:
            what: It is, in words.
            edits: As the program takes them.
        """
        revision = STORY.revision
        STORY.ask(what, lambda link: link.edit(edits, revision), lambda _: None)
        return {"FINISHED"}


class Refresh(ShotOperator):
    """Hear of the story again"""

    bl_idname = "storyblender.refresh"
    bl_label = "Refresh"

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Ask."""
        STORY.refresh("Reading the story")
        return {"FINISHED"}


class GoTo(bpy.types.Operator):
    """Show this shot: its scene, its first frame, its camera"""

    bl_idname = "storyblender.go_to"
    bl_label = "Go to Shot"

    step: bpy.props.IntProperty(name="Step", description="Shots before or after the one that is looked at", default=0)

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Go there; what the film leaves out, and what is not in the file, is passed over on the way."""
        state = context.window_manager.storyblender
        there = {shot.name for shot in shots()}
        index = state.active + self.step
        while self.step and 0 <= index < len(state.shots) and state.shots[index].name not in there:
            index += self.step
        if not 0 <= index < len(state.shots):
            self.report({"INFO"}, "There is no further shot.")
            return {"CANCELLED"}
        name = state.shots[index].name
        if not go_to(context.window, name):
            self.report({"ERROR"}, f"{name} is not in this file: press Push to write it anew.")
            return {"CANCELLED"}
        state.active = index
        return {"FINISHED"}


class DrawFrame(ShotOperator):
    """Save, take over what you changed, and draw this shot's frame in the look of the storyboard"""

    bl_idname = "storyblender.draw_frame"
    bl_label = "Draw Frame"

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Ask for it, show it where pictures are shown, then open the file that has what was taken over."""
        name = self.chosen(context)
        save_changes()

        def drawn(pulled: dict) -> None:
            pictures.show(STORY.picture(name))
            if pulled["understood"]:
                STORY.ask("Writing story.blend", lambda link: link.push(), lambda _: taken_over(pulled))
            else:
                taken_over(pulled)

        STORY.ask(f"Drawing {name}", lambda link: (link.pull(), link.draw(name))[0], drawn)
        return {"FINISHED"}


class ShowFrame(ShotOperator):
    """Show this shot's frame in a window of its own"""

    bl_idname = "storyblender.show_frame"
    bl_label = "Show Frame"

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Open an image editor with it."""
        picture = STORY.picture(self.chosen(context))
        if picture is None:
            self.report({"ERROR"}, "This shot is not drawn yet: press Draw Frame.")
            return {"CANCELLED"}
        if not pictures.show(picture) and not bpy.app.background:
            bpy.ops.wm.window_new()
            context.window_manager.windows[-1].screen.areas[0].type = "IMAGE_EDITOR"
            pictures.show(picture)
        return {"FINISHED"}


class Pull(ShotOperator):
    """Save, and let the story take over what you changed here; all of it is one undo of the story"""

    bl_idname = "storyblender.pull"
    bl_label = "Pull"

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Ask for it, and open the file that is written anew."""
        save_changes()

        def taken(link: Studio | Program) -> dict:
            pulled = link.pull()
            if pulled["understood"]:
                link.push()
            return pulled

        STORY.ask("Taking over what you changed", taken, taken_over)
        return {"FINISHED"}


class Push(ShotOperator):
    """Draw what is stale, write story.blend from the story as it is now, and open it"""

    bl_idname = "storyblender.push"
    bl_label = "Push"

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Ask for it; what was changed here is taken over first, so nothing is lost."""
        save_changes()
        STORY.ask("Writing story.blend", lambda link: link.push(), lambda _: open_anew())
        return {"FINISHED"}


class Reload(ShotOperator):
    """Open the file as it was written anew; what you changed here since is lost"""

    bl_idname = "storyblender.reload"
    bl_label = "Reload"

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Open it."""
        reload()
        return {"FINISHED"}


class Lock(ShotOperator):
    """Lock or unlock this part of the shot: neither the crew nor an edit changes what is locked"""

    bl_idname = "storyblender.lock"
    bl_label = "Lock"

    part: bpy.props.EnumProperty(
        name="Part", items=[(part, part.title(), "") for part in ("camera", "blocking", "duration")]
    )

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Do the other thing than is."""
        name = self.chosen(context)
        kind = "unlock" if self.part in STORY.details(name).get("locked", ()) else "lock"
        return self.edit(f"{kind.title()}ing {name}", {"kind": kind, "target": name, "parts": [self.part]})


class AddNote(ShotOperator):
    """Add the note to the shot"""

    bl_idname = "storyblender.add_note"
    bl_label = "Add Note"

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Add what is written in the panel."""
        state = context.window_manager.storyblender
        text = state.note.strip()
        if not text:
            self.report({"ERROR"}, "Write the note first.")
            return {"CANCELLED"}
        state.note = ""
        note = {"kind": "note", "shot": self.chosen(context), "action": "add", "text": text}
        return self.edit("Adding the note", note)


class ResolveNote(ShotOperator):
    """Say that the note is done, or that it is not after all"""

    bl_idname = "storyblender.resolve_note"
    bl_label = "Resolve Note"

    number: bpy.props.IntProperty(name="Note")

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Do the other thing than is."""
        name = self.chosen(context)
        notes = {note["number"]: note for note in STORY.details(name).get("notes", ())}
        action = "reopen" if notes.get(self.number, {}).get("resolved") else "resolve"
        return self.edit("Noting it", {"kind": "note", "shot": name, "action": action, "number": self.number})


class Take(ShotOperator):
    """Keep this take of the shot and begin another, or choose which one the film shows"""

    bl_idname = "storyblender.take"
    bl_label = "Take"

    action: bpy.props.EnumProperty(
        name="Action",
        items=[("keep", "Keep", "Put this camera by, and begin the next take with it"), ("choose", "Choose", "")],
    )
    number: bpy.props.IntProperty(name="Take")

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Keep it or choose it."""
        edit = {"kind": "take", "shot": self.chosen(context), "action": self.action}
        if self.action == "choose":
            edit["number"] = self.number
        return self.edit("Changing takes", edit)


class UndoStory(ShotOperator):
    """Take back the last change of the story, made here or by anybody else"""

    bl_idname = "storyblender.undo_story"
    bl_label = "Undo in Story"

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Ask for it."""
        STORY.ask("Undoing", lambda link: link.undo(), lambda _: None)
        return {"FINISHED"}


_CLASSES = (
    Refresh, GoTo, DrawFrame, ShowFrame, Pull, Push, Reload, Lock, AddNote, ResolveNote, Take, UndoStory,
)  # fmt: skip


def register() -> None:
    """Add the operators."""
    for each in _CLASSES:
        bpy.utils.register_class(each)


def unregister() -> None:
    """Take them out."""
    for each in reversed(_CLASSES):
        bpy.utils.unregister_class(each)

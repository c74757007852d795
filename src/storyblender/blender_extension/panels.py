"""The panel in the sidebar of the 3D viewport: shots, the shot that is looked at, its notes and takes, the story."""

import textwrap

import bpy

from . import pictures
from .shots_in_file import warnings
from .story import STORY
from .work import WORK

_LETTER = 6.5
"""Width of a letter in points, about: Blender wraps no text."""
_PARTS = ("camera", "blocking", "duration")


class ShotList(bpy.types.UIList):
    """The shots, each with what a person should know of it."""

    bl_idname = "STORYBLENDER_UL_shots"

    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index) -> None:
        """Show a row."""
        card = STORY.card(item.name)
        row = layout.row(align=True)
        row.active = not card.get("omitted", False)
        row.label(text=item.name, icon="CAMERA_DATA")
        for shown, text, symbol in _marks(card):
            if shown:
                row.label(text=text, icon=symbol)


class StoryPanel(bpy.types.Panel):
    """Base of the panels."""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "StoryBlender"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Return whether there is a story."""
        return STORY.project is not None


class ShotPanel(StoryPanel):
    """Base of the panels of the shot that is looked at."""

    bl_parent_id = "STORYBLENDER_PT_shots"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Return whether something is known of it."""
        return bool(_details(context))


class Shots(StoryPanel):
    """The shots, and what is under way."""

    bl_idname = "STORYBLENDER_PT_shots"
    bl_label = "StoryBlender"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Return True: it says also that there is no story."""
        return True

    def draw(self, context: bpy.types.Context) -> None:
        """Show the panel."""
        layout, state = self.layout, context.window_manager.storyblender
        for sentence in warnings():
            _paragraph(layout, context, sentence, icon="ERROR")
        if STORY.project is None:
            _paragraph(layout, context, "Open the story.blend of a StoryBlender project.", icon="INFO")
            return
        row = layout.row()
        known = {"studio": ("Connected to the studio", "LINKED"), "alone": ("On its own", "CONSOLE")}
        text, symbol = known.get(STORY.link, ("Not connected", "UNLINKED"))
        row.label(text=text, icon=symbol)
        row.operator("storyblender.refresh", text="", icon="FILE_REFRESH")
        layout.template_list("STORYBLENDER_UL_shots", "", state, "shots", state, "active", rows=6)
        row = layout.row(align=True)
        row.operator("storyblender.go_to", text="Previous", icon="TRIA_LEFT").step = -1
        row.operator("storyblender.go_to", text="Go to", icon="VIEW_CAMERA").step = 0
        row.operator("storyblender.go_to", text="Next", icon="TRIA_RIGHT").step = 1
        picture = STORY.picture(state.chosen)
        if picture is not None:
            layout.template_icon(icon_value=pictures.icon_of(picture), scale=9.0)
        row = layout.row(align=True)
        row.operator("storyblender.draw_frame", icon="RENDER_STILL")
        row.operator("storyblender.show_frame", text="", icon="WINDOW")
        row = layout.row(align=True)
        row.operator("storyblender.pull", icon="IMPORT")
        row.operator("storyblender.push", icon="EXPORT")
        if STORY.is_rewritten:
            _paragraph(layout, context, "story.blend was written anew since you opened it.", icon="ERROR")
            layout.operator("storyblender.reload", icon="FILE_REFRESH")
        for doing in WORK.doing:
            layout.label(text=f"{doing} …", icon="SORTTIME")
        if STORY.problem:
            box = layout.box()
            box.alert = True
            _paragraph(box, context, STORY.problem, icon="CANCEL")
        for sentence in STORY.told:
            _paragraph(layout, context, sentence, icon="CHECKMARK")
        undo = STORY.board.get("undo", "")
        if undo:
            layout.operator("storyblender.undo_story", text=f"Undo: {undo}", icon="LOOP_BACK")


class Shot(ShotPanel):
    """The shot's words, camera, locks, and what to check."""

    bl_idname = "STORYBLENDER_PT_shot"
    bl_label = "Shot"

    def draw(self, context: bpy.types.Context) -> None:
        """Show the panel."""
        layout, details = self.layout, _details(context)
        _paragraph(layout, context, f"{details['camera']}, {details['seconds']:.1f} s", icon="CAMERA_DATA")
        for line in details["lines"]:
            said = f"{line['speaker'].replace('_', ' ').upper()}: " if line["speaker"] else ""
            _paragraph(layout, context, f"{said}{line['text']}", icon="SPEAKER" if said else "TEXT")
        for sentence in details["problems"]:
            _paragraph(layout, context, f"To check: {sentence}", icon="ERROR")
        row = layout.row(align=True)
        for part in _PARTS:
            locked = part in details["locked"]
            symbol = "LOCKED" if locked else "UNLOCKED"
            row.operator("storyblender.lock", text=part.title(), icon=symbol, depress=locked).part = part


class Notes(ShotPanel):
    """The shot's notes."""

    bl_idname = "STORYBLENDER_PT_notes"
    bl_label = "Notes"

    def draw(self, context: bpy.types.Context) -> None:
        """Show the panel."""
        layout = self.layout
        for note in _details(context)["notes"]:
            row = layout.row()
            column = row.column()
            column.active = not note["resolved"]
            author = f"{note['author']}: " if note["author"] else ""
            _paragraph(column, context, f"{author}{note['text']}", icon="NONE", less=3)
            done = row.operator(
                "storyblender.resolve_note", text="", icon="CHECKBOX_HLT" if note["resolved"] else "CHECKBOX_DEHLT"
            )
            done.number = note["number"]
        row = layout.row(align=True)
        row.prop(context.window_manager.storyblender, "note", text="", placeholder="Write a note")
        row.operator("storyblender.add_note", text="", icon="ADD")


class Takes(ShotPanel):
    """The shot's takes."""

    bl_idname = "STORYBLENDER_PT_takes"
    bl_label = "Takes"

    def draw(self, context: bpy.types.Context) -> None:
        """Show the panel."""
        layout = self.layout
        for take in _details(context)["takes"]:
            row = layout.row(align=True)
            words = f"{take['number']}  {take['camera']}"
            if take["in_film"]:
                row.label(text=words, icon="RADIOBUT_ON")
            else:
                choose = row.operator("storyblender.take", text=words, icon="RADIOBUT_OFF")
                choose.action, choose.number = "choose", take["number"]
        layout.operator("storyblender.take", text="Keep This Take, Begin Another", icon="ADD").action = "keep"


def _details(context: bpy.types.Context) -> dict:
    return STORY.details(context.window_manager.storyblender.chosen)


def _marks(card: dict) -> list[tuple[bool, str, str]]:
    """Return whether each mark of a shot is shown, with its text and its icon."""
    state, notes, takes, problems = (card.get(key, 0) for key in ("state", "notes", "takes", "problems"))
    return [
        (bool(card.get("omitted")), "", "HIDE_ON"),
        (state in ("stale", "preview"), "", "FILE_REFRESH"),
        (state == "none", "", "IMAGE_PLANE"),
        (bool(card.get("approved")), "", "CHECKMARK"),
        (bool(card.get("locked")), "", "LOCKED"),
        (notes > 0, str(notes), "TEXT"),
        (takes > 1, str(takes), "RENDERLAYERS"),
        (problems > 0, str(problems), "ERROR"),
    ]


def _paragraph(layout: bpy.types.UILayout, context: bpy.types.Context, text: str, *, icon: str, less: int = 0) -> None:
    """Show a text over as many lines as the sidebar needs for it.

    Args:
        layout: Where.
        context: Of the sidebar.
        text: One paragraph.
        icon: Before its first line.
        less: Letters that something beside it takes.
    """
    region, scale = context.region, context.preferences.system.ui_scale
    width = region.width / scale if region is not None else 300.0
    column = layout.column(align=True)
    for number, line in enumerate(textwrap.wrap(text, max(16, int(width / _LETTER) - 7 - less))):
        column.label(text=line, icon=icon if number == 0 else ("NONE" if icon == "NONE" else "BLANK1"))


_CLASSES = (ShotList, Shots, Shot, Notes, Takes)


def register() -> None:
    """Add the panels."""
    for each in _CLASSES:
        bpy.utils.register_class(each)


def unregister() -> None:
    """Take them out."""
    for each in reversed(_CLASSES):
        bpy.utils.unregister_class(each)

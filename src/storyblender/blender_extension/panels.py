"""The panel in the sidebar of the 3D viewport: shots, the shot that is looked at, its notes and takes, the story."""

import blf
import bpy

from . import pictures
from .shots_in_file import warnings
from .story import STORY
from .work import WORK

_FONT = 0
"""Blender's own."""
_USUAL, _EDGES = 220, 94
"""Points: the width of the sidebar as it opens, and what is around a text in it."""
_PARTS = ("camera", "blocking", "duration")


class ShotList(bpy.types.UIList):
    """The shots, each with what a person should know of it."""

    bl_idname = "STORYBLENDER_UL_shots"

    def draw_item(self, context, layout, data, item, icon, active_data, active_property, index) -> None:
        """Show a row."""
        card = STORY.card(item.name)
        split = layout.split(factor=0.64)
        split.active = not card.get("omitted", False)
        split.label(text=item.name)
        marks = split.row(align=True)
        marks.alignment = "RIGHT"
        for shown, symbol in _marks(card):
            if shown:
                marks.label(icon=symbol)


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
        known = {"studio": ("With the studio", "LINKED"), "alone": ("Without a studio", "CONSOLE")}
        text, symbol = known.get(STORY.link, ("Not connected", "UNLINKED"))
        row.label(text=text, icon=symbol)
        row.operator("storyblender.refresh", text="", icon="FILE_REFRESH")
        layout.template_list("STORYBLENDER_UL_shots", "", state, "shots", state, "active", rows=6)
        row = layout.row(align=True)
        row.operator("storyblender.go_to", text="", icon="TRIA_LEFT").step = -1
        row.operator("storyblender.go_to", text="Go to", icon="VIEW_CAMERA").step = 0
        row.operator("storyblender.go_to", text="", icon="TRIA_RIGHT").step = 1
        picture = STORY.picture(state.chosen)
        if picture is not None:
            layout.template_icon(icon_value=pictures.icon_of(picture), scale=8.0)
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
            _paragraph(box, context, STORY.problem, icon="CANCEL", less=12)
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
        column = layout.column(align=True)
        for part in _PARTS:
            locked = part in details["locked"]
            symbol = "LOCKED" if locked else "UNLOCKED"
            column.operator("storyblender.lock", text=part.title(), icon=symbol, depress=locked).part = part


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
            _paragraph(column, context, f"{author}{note['text']}", icon="TEXT", less=24)
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


def _marks(card: dict) -> list[tuple[bool, str]]:
    """Return the icon of each mark, and whether the shot has it."""
    approved = card.get("approved", False)
    return [
        (card.get("omitted", False), "HIDE_ON"),
        (card.get("state") in ("stale", "preview", "none"), "FILE_REFRESH"),
        (approved, "CHECKMARK"),
        (card.get("locked", False) and not approved, "LOCKED"),
        (card.get("notes", 0) > 0, "TEXT"),
        (card.get("takes", 0) > 1, "RENDERLAYERS"),
        (card.get("problems", 0) > 0, "ERROR"),
    ]


def _paragraph(layout: bpy.types.UILayout, context: bpy.types.Context, text: str, *, icon: str, less: int = 0) -> None:
    """Show a text over as many lines as the sidebar needs for it, because Blender wraps none.

    Args:
        layout: Where.
        context: Of the sidebar.
        text: One paragraph.
        icon: Before its first line.
        less: Points that something around it or beside it takes.
    """
    region, scale = context.region, context.preferences.system.ui_scale
    width = (region.width if region is not None else _USUAL * scale) - (_EDGES + less) * scale
    blf.size(_FONT, context.preferences.ui_styles[0].widget.points * scale)
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and blf.dimensions(_FONT, longer)[0] > width:
            lines.append(word)
        else:
            lines[-1] = longer
    column = layout.column(align=True)
    for number, line in enumerate(lines):
        column.label(text=line, icon=icon if number == 0 else "BLANK1")


_CLASSES = (ShotList, Shots, Shot, Notes, Takes)


def register() -> None:
    """Add the panels."""
    for each in _CLASSES:
        bpy.utils.register_class(each)


def unregister() -> None:
    """Take them out."""
    for each in reversed(_CLASSES):
        bpy.utils.unregister_class(each)

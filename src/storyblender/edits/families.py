"""What each kind of edit does to the graph: the item as it is then, and what of the crew's work is stale."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Final

from storyblender.edits.asset_edits import asset_effects
from storyblender.edits.blocking_edits import blocking_effects
from storyblender.edits.by_hand_edits import by_hand_effects
from storyblender.edits.camera_edits import camera_effects, duration_effects
from storyblender.edits.coverage_edits import add_effects, join_effects, split_effects
from storyblender.edits.cut_edits import omit_effects, reorder_effects, restore_effects
from storyblender.edits.effect import Effect, with_effects
from storyblender.edits.format_edits import format_effects
from storyblender.edits.lock_edits import lock_effects, unlock_effects
from storyblender.edits.look_edits import look_effects
from storyblender.edits.note_edits import approve_effects, note_effects
from storyblender.edits.paint_edits import paint_effects
from storyblender.edits.place_edits import place_effects
from storyblender.edits.scene_edits import layout_effects, light_effects, set_effects
from storyblender.edits.take_edits import take_effects
from storyblender.memory.edits import (
    AddShotEdit,
    ApproveEdit,
    AssetEdit,
    BlockingEdit,
    ByHandEdit,
    CameraEdit,
    DurationEdit,
    Edit,
    FormatEdit,
    JoinEdit,
    LayoutEdit,
    LightEdit,
    LockEdit,
    LookEdit,
    NoteEdit,
    OmitEdit,
    PaintEdit,
    PlaceEdit,
    ReorderEdit,
    RestoreEdit,
    SetEdit,
    SplitEdit,
    TakeEdit,
    UnlockEdit,
)
from storyblender.memory.graph import ContinuityMemoryGraph


def effects_of(graph: ContinuityMemoryGraph, edit: Edit) -> list[Effect]:
    """Return what an edit does, item by item.

    Args:
        graph: As it is.
        edit: Any.

    Raises:
        InputError: It names what does not exist, what is locked, or what cannot be.
    """
    return _FAMILIES[type(edit)](graph, edit)


def tried(graph: ContinuityMemoryGraph, edits: Sequence[Edit]) -> ContinuityMemoryGraph:
    """Return the graph as edits would leave it.

    Args:
        graph: As it is.
        edits: In order; a later one sees what an earlier one does.

    Raises:
        InputError: One of them cannot be.
    """
    for edit in edits:
        graph = with_effects(graph, effects_of(graph, edit))
    return graph


_FAMILIES: Final[dict[type[Edit], Callable[[ContinuityMemoryGraph, Any], list[Effect]]]] = {
    CameraEdit: camera_effects,
    DurationEdit: duration_effects,
    LightEdit: light_effects,
    SetEdit: set_effects,
    LayoutEdit: layout_effects,
    PlaceEdit: place_effects,
    BlockingEdit: blocking_effects,
    ByHandEdit: by_hand_effects,
    AssetEdit: asset_effects,
    LookEdit: look_effects,
    PaintEdit: paint_effects,
    FormatEdit: format_effects,
    TakeEdit: take_effects,
    NoteEdit: note_effects,
    ApproveEdit: approve_effects,
    OmitEdit: omit_effects,
    RestoreEdit: restore_effects,
    ReorderEdit: reorder_effects,
    SplitEdit: split_effects,
    JoinEdit: join_effects,
    AddShotEdit: add_effects,
    LockEdit: lock_effects,
    UnlockEdit: unlock_effects,
}

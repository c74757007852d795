"""The file that a worker has open: a packed scene, or one that was built here, with the viewfinder on it."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import bpy

from storyblender.blender.measure.view import WIDTH, OpenViewfinder, viewfinder
from storyblender.blender.progress import Report, ignore
from storyblender.folder import Folder
from storyblender.memory.base import scene_name
from storyblender.memory.jobs import (
    PackRef,
)

if TYPE_CHECKING:
    from storyblender.blender.asset_store import AssetStore
    from storyblender.blender.rehearsal import Rehearsals


class OpenPack:
    """What every job of a worker needs: the project's files, its assets, the open scene.

    Args:
        root: The project folder; every path in a job is relative to it and must stay inside.
        models: The user's folders of models.
        build: Folder for names below ``build/``; None for the project folder.
        report: Receives the progress of the running job.
    """

    def __init__(
        self, root: Path, models: Sequence[Path] = (), build: Path | None = None, report: Report = ignore
    ) -> None:
        self._files = Folder(root, build)
        self._models, self._report = models, report
        self._open = ""
        self._rehearsals: Rehearsals | None = None
        """The scenes in the open file, if they were built here and not opened."""
        self._viewfinder_scene = ExitStack()
        self._background = ThreadPoolExecutor(1)
        self._viewfinder: tuple[tuple[str, int | None, int], OpenViewfinder] | None = None
        """The open viewfinder, after its pack, frame and height."""

    @cached_property
    def _store(self) -> AssetStore:
        """The canonical assets."""
        from storyblender.blender.asset_store import AssetStore

        return AssetStore(self._files, self._models)

    def _viewfinder_at(self, pack: PackRef, frame: int | None, aspect: float) -> OpenViewfinder:
        """Return the viewfinder at a frame; it is kept, because the Camera Operator returns to it many times."""
        height = max(2, round(WIDTH / aspect))
        key = (pack.path, frame, height)
        if self._viewfinder is None or self._viewfinder[0] != key:
            scene = self._open_pack(pack, () if frame is None else (frame,))
            self._viewfinder = key, self._viewfinder_scene.enter_context(viewfinder(scene, frame, WIDTH, height))
        return self._viewfinder[1]

    def _release_viewfinder(self) -> None:
        """Close the viewfinder; the file is as before."""
        self._viewfinder = None
        self._viewfinder_scene.close()

    def _close_pack(self) -> None:
        """Forget the open pack before a job that opens files of its own."""
        self._release_viewfinder()
        self._open, self._rehearsals = "", None

    def _open_pack(self, pack: PackRef, frames: Sequence[int] = ()) -> bpy.types.Scene:
        """Open a pack, unless it is open, and return its scene.

        Args:
            pack: The pack.
            frames: Of its timeline, that are looked at.
        """
        self._release_viewfinder()
        if self._open != pack.path:
            self._close_pack()
            bpy.ops.wm.open_mainfile(filepath=str(self._files.path(pack.path)), load_ui=False, use_scripts=False)
            self._open = pack.path
        if self._rehearsals is not None:
            self._rehearsals.pose(pack.scene_id, frames)
        scene = bpy.data.scenes[scene_name(pack.scene_id)]
        bpy.context.window.scene = scene
        return scene

"""The engine's jobs on single assets: built and measured, pictured, written as glTF."""

from __future__ import annotations

from typing import TYPE_CHECKING

import bpy

from storyblender.blender.open_pack import OpenPack
from storyblender.catalog.hair import HAIRSTYLES
from storyblender.memory.base import Vec3
from storyblender.memory.jobs import (
    AssetJob,
)
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.paint import Paint

if TYPE_CHECKING:
    pass


class AssetSession(OpenPack):
    """Does the jobs on assets in this process."""

    def build_asset(self, job: AssetJob) -> AssetMeasure:
        """Build and measure one asset."""
        self._close_pack()
        return self._store.measure(job)

    def portrait(self, job: AssetJob, out: str, paints: tuple[Paint, ...] = ()) -> str:
        """Render a small picture of one asset to ``out``.

        Args:
            job: The asset, with its canonical.
            out: Path of the picture, relative to the project folder; it is returned.
            paints: What a person decided about its materials.
        """
        from storyblender.blender.props.portrait import render_portrait

        canonical = job.asset.canonical
        assert canonical is not None, "a portrait shows what an asset became"
        parts = self._parts_of(job, paints)
        with self._files.writing(out) as part:
            render_portrait(parts, part, head=canonical.key in HAIRSTYLES)
        return out

    def write_asset(self, job: AssetJob, out: str, paints: tuple[Paint, ...] = ()) -> str:
        """Write one asset as glTF to ``out``.

        Args:
            job: The asset, with its canonical.
            out: Path of the file, relative to the project folder; it is returned.
            paints: What a person decided about its materials.
        """
        from storyblender.blender.asset_glb import write_asset

        parts = self._parts_of(job, paints)
        with self._files.writing(out) as part:
            write_asset(parts, part)
        return out

    def draw_sides(self, job: AssetJob, folder: str) -> Vec3:
        """Render an object from its six sides and as a portrait; return its width, depth and height in metres.

        Args:
            job: The object, which is built for it and not kept.
            folder: Of the pictures, relative to the project folder: ``front.png`` and so on, ``portrait.png``.
        """
        from storyblender.blender.props.portrait import SIDE_SIZE, render_portrait, render_sides

        self._close_pack()
        build = self._store.draft(job)
        thing = bpy.data.objects.new(job.asset.asset_id, build.mesh)
        with self._files.writing_tree(folder) as part:
            render_sides(thing, part)
            render_portrait([thing], part / "portrait.png", (2 * SIDE_SIZE[0], 2 * SIDE_SIZE[1]))
        return build.dimensions

    def _parts_of(self, job: AssetJob, paints: tuple[Paint, ...]) -> list[bpy.types.Object]:
        """Return the mesh objects of an asset alone in an empty file, painted; a person stands at ease."""
        from storyblender.blender.painting import paint_objects

        parts = self._unpainted(job)
        for obj in parts:
            obj["asset_id"] = job.asset.asset_id
        paint_objects(parts, paints)
        return parts

    def _unpainted(self, job: AssetJob) -> list[bpy.types.Object]:
        """Return the mesh objects of an asset, as they were made."""
        from storyblender.blender.people.at_ease import stand_at_ease

        self._close_pack()
        made = job.asset.canonical
        if job.asset.asset_type == "object" and made is not None and not made.geometry_hash:
            build = self._store.draft(job)  # not kept; it opens an empty file, so nothing of bpy.data is named before
            return [bpy.data.objects.new(job.asset.asset_id, build.mesh)]
        measure = self._store.measure(job)
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
        canonical = job.asset.canonical
        assert canonical is not None, "what an asset became is shown"
        asset = job.asset.model_copy(update={"canonical": canonical.model_copy(update={"digest": measure.digest})})
        if asset.asset_type != "character":
            return [bpy.data.objects.new(asset.asset_id, self._store.append_mesh(asset))]
        member = self._store.append_person(asset)
        stand_at_ease(member.armature)
        return list(member.meshes)

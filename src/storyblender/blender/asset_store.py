"""The canonical assets on disk: ``assets/<digest>.blend`` with the geometry, ``.json`` with its measure.

Content-addressed: a recipe is built once, by the first worker that needs it, and appended everywhere else.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import bpy

from storyblender.blender.appending import append
from storyblender.blender.measure.hashing import geometry_hash
from storyblender.blender.measure.surfaces import find_tops
from storyblender.blender.people.body import RiggedBody
from storyblender.blender.people.drape import drape_seated
from storyblender.blender.people.person import PersonBuild, build_person
from storyblender.blender.props.build import PropBuild, build_prop
from storyblender.blender.props.imported import build_from_file
from storyblender.blender.props.stand_in import build_stand_in
from storyblender.catalog.props.prop_names import prop_of
from storyblender.catalog.wardrobe import person_seed
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.geometry.mocap import MocapPoses
from storyblender.memory.asset_sheet import Asset, CharacterLook, Credit, ModelPose
from storyblender.memory.base import content_hash, seed_of
from storyblender.memory.jobs import ADOPTED, ASSETS, FETCHED, GIVEN, AssetJob, asset_suffixes
from storyblender.memory.measure import AssetMeasure, AssetRecord
from storyblender.memory.mocap import mocap_file
from storyblender.model_content import content_of
from storyblender.outputs import digest_of


@dataclass(frozen=True)
class CastMember:
    """An appended person.

    Attributes:
        armature: The rig's object.
        meshes: Objects that it deforms.
        body: Measured body for the motion solver.
    """

    armature: bpy.types.Object
    meshes: list[bpy.types.Object]
    body: RiggedBody


class AssetStore:
    """Builds assets into the project and appends them to the open file.

    Args:
        files: The project folder.
        models: Where the files of models may lie: the user's folders, searched before those of the project.
    """

    def __init__(self, files: Folder, models: Sequence[Path] = ()) -> None:
        self.files, self._models = files, models

    def measure(self, job: AssetJob) -> AssetMeasure:
        """Return the measure of an asset; build it into the store first if it is missing or damaged.

        Building replaces the open Blender file.
        """
        record, suffixes = self._path(job.digest, ".json"), asset_suffixes(job.asset)
        try:
            known = AssetRecord.model_validate_json(record.read_bytes())
            if known.files == self._digests(job.digest, suffixes):
                return known.measure
        except (OSError, ValueError):
            pass
        # An empty file; the add-ons stay registered, which a return to factory settings would do anew for each asset.
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
        measure = self._build(job)
        known = AssetRecord(measure=measure, files=self._digests(job.digest, suffixes))
        self.files.write(self.files.name_of(record), known.model_dump_json())
        return measure

    def draft(self, job: AssetJob) -> PropBuild:
        """Return an object as it would be built, without keeping it. Replaces the open Blender file."""
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
        return self._make_object(job.asset, job.digest)

    def append_mesh(self, asset: Asset) -> bpy.types.Mesh:
        """Return the canonical mesh of an object, appended to the open file at most once."""
        digest = _digest(asset)
        present = next((mesh for mesh in bpy.data.meshes if mesh.get("digest") == digest), None)
        if present is not None:
            return present
        objects = self._append(digest)
        mesh = objects[0].data
        for obj in objects:
            bpy.data.objects.remove(obj)
        mesh.name = asset.asset_id  # it may have been built for another story
        return mesh

    def append_person(self, asset: Asset) -> CastMember:
        """Return a new copy of a person's rig and meshes in the open file, not linked to a collection."""
        digest = _digest(asset)
        objects = self._append(digest)
        armature = next(obj for obj in objects if obj.type == "ARMATURE")
        meshes = [obj for obj in objects if obj.type == "MESH"]
        return CastMember(armature, meshes, self.body(digest))

    def body(self, digest: str) -> RiggedBody:
        """Return the measured body of a person by the digest of their asset."""
        return RiggedBody.load(self._path(digest, ".npz"))

    def mocap(self, digest: str) -> MocapPoses | None:
        """Return a recorded motion that the project keeps; None where its file is gone, or was changed."""
        try:
            poses = MocapPoses.load(self.files.path(mocap_file(digest)).read_bytes())
        except (OSError, ValueError, InputError):
            return None
        return poses if poses.digest == digest else None

    def _path(self, digest: str, suffix: str) -> Path:
        """Return the path of a file of an asset."""
        return self.files.path(ASSETS, f"{digest}{suffix}")

    def _digests(self, digest: str, suffixes: Sequence[str]) -> dict[str, str]:
        """Return the digests of an asset's files by suffix."""
        return {suffix: digest_of(self._path(digest, suffix)) for suffix in suffixes}

    def _append(self, digest: str) -> list[bpy.types.Object]:
        """Append the objects of an asset to the open file, ordered by name."""
        (collection,) = append(self._path(digest, ".blend"), "collections")
        objects = sorted(collection.objects, key=lambda obj: obj.name)
        bpy.data.collections.remove(collection)
        return objects

    def _build(self, job: AssetJob) -> AssetMeasure:
        """Build an asset into the open file, save it and return its measure."""
        asset, digest = job.asset, job.digest
        collection = bpy.data.collections.new(f"AST_{asset.asset_id}")
        if asset.asset_type == "character":
            measure = self._build_person(asset, digest, collection)
        else:
            measure = self._build_object(asset, digest, collection)
        with self.files.writing(f"{ASSETS}/{digest}.blend") as part:
            bpy.data.libraries.write(str(part), {collection}, compress=True, fake_user=True)
        return measure

    def _build_person(self, asset: Asset, digest: str, collection: bpy.types.Collection) -> AssetMeasure:
        """Build a person with seated clothes into a collection; return its measure."""
        build, notes, credit = self._make_person(asset)
        for obj in (build.armature, *build.meshes):
            collection.objects.link(obj) if obj.name not in collection.objects else None
            obj.data["digest"] = digest
        with self.files.writing(f"{ASSETS}/{digest}.npz") as part:
            build.body.save(part)
        hashes = [geometry_hash(obj.data) for obj in build.meshes]
        width = float(build.body.vertices[:, 0].max() - build.body.vertices[:, 0].min())
        depth = float(build.body.vertices[:, 1].max() - build.body.vertices[:, 1].min())
        return AssetMeasure(
            asset_id=asset.asset_id,
            digest=digest,
            geometry_hash=content_hash(list(hashes)),
            dimensions=(min(width, 0.55 * build.body.stature / 1.7), depth, build.body.stature),
            faces=sum(len(obj.data.polygons) for obj in build.meshes),
            notes=notes,
            credit=credit,
        )

    def _make_person(self, asset: Asset) -> tuple[PersonBuild, tuple[str, ...], Credit]:
        """Return a person in the open file, with notes and the credit of the model they are made from, if any."""
        canonical = asset.canonical
        if canonical is not None and canonical.source == "file":
            from storyblender.blender.cast.character import character_from_file

            path, folder = self._model_path(canonical.key, str(canonical.params.get("content", "")))
            certainty, pose = canonical.certainty, ModelPose.of(canonical.params)
            made = character_from_file(asset.asset_id, path, folder, asset.dimension, certainty=certainty, pose=pose)
            return made.person, made.notes, made.credit
        look = asset.decided_look or CharacterLook()
        if asset.dimension is not None and asset.dimension.height is not None:
            look = look.model_copy(update={"stature": min(2.4, max(0.4, asset.dimension.height))})
        build = build_person(asset.asset_id, look, seed=person_seed(asset))
        drape_seated(build)
        return build, (), Credit()

    def _build_object(self, asset: Asset, digest: str, collection: bpy.types.Collection) -> AssetMeasure:
        """Build an object into a collection; return its measure."""
        build = self._make_object(asset, digest)
        build.mesh.name = asset.asset_id
        build.mesh["digest"] = digest
        obj = bpy.data.objects.new(asset.asset_id, build.mesh)
        collection.objects.link(obj)
        tops = () if any(anchor.kind == "top" for anchor in build.anchors) else find_tops(build.mesh)
        return AssetMeasure(
            asset_id=asset.asset_id,
            digest=digest,
            geometry_hash=geometry_hash(build.mesh),
            dimensions=build.dimensions,
            anchors=(*build.anchors, *tops),
            faces=len(build.mesh.polygons),
            notes=build.notes,
            credit=build.credit,
        )

    def _make_object(self, asset: Asset, digest: str) -> PropBuild:
        """Return the built prop of an asset, from the catalogue, a user's file, or as a stand-in."""
        canonical = asset.canonical
        assert canonical is not None, "the Concept Artist decides what an asset is before it is built"
        seed = seed_of(digest)
        match canonical.source:
            case "catalog":
                return build_prop(canonical.key, canonical.params, seed, asset.dimension)
            case "file":
                path, folder = self._model_path(canonical.key, str(canonical.params.get("content", "")))
                return build_from_file(
                    path,
                    asset.dimension,
                    folder=folder,
                    prop=prop_of(asset),
                    certainty=canonical.certainty,
                    pose=ModelPose.of(canonical.params),
                )
            case _:
                return build_stand_in(canonical.key, asset.dimension)

    def _model_path(self, name: str, content: str) -> tuple[Path, Path]:
        """Return the file of a model, and the folder of models that has it with the content chosen before.

        Raises:
            InputError: No folder has it, or only with another content.
        """
        mend = "restore it, or run `storyblender make` with --models FOLDER"
        found: Path | None = None
        for folder in (*self._models, *map(self.files.path, (GIVEN, FETCHED, ADOPTED))):
            path = folder / name
            if not path.resolve().is_relative_to(folder.resolve()):
                raise InputError(f"the model {name!r} is outside the folder of models")
            if path.is_file():
                if content in ("", content_of(path, folder)):
                    return path, folder
                found = found or path
        if found is not None:
            mend = "run `storyblender make` to use it as it is now"
            raise InputError("the model has changed since it was added to the story", mend=mend, path=found)
        for folder in self._models:
            if not folder.is_dir():
                raise InputError(f"the folder of the model {name!r} does not exist", mend=mend, path=folder)
        raise InputError(f"no folder of models has the model {name!r}", mend=mend)


def _digest(asset: Asset) -> str:
    """Return the digest of a built asset."""
    assert asset.canonical is not None, f"{asset.asset_id} has not been built"
    return asset.canonical.digest

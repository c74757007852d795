"""The protocols between StoryBlender and the world outside it. Agents and pipeline get ports, never adapters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Future
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from storyblender.catalog.recipe import AssetQuery, Recipe
from storyblender.folder import Folder
from storyblender.geometry.framing import Figure
from storyblender.memory.base import Vec3
from storyblender.memory.blend_values import AdoptedObject, BlendReading
from storyblender.memory.jobs import (
    AssetJob,
    CutJob,
    ExportJob,
    FrameJob,
    FrameReport,
    MomentJob,
    MotionJob,
    PackRef,
    SceneJob,
    StoryJob,
)
from storyblender.memory.measure import AssetMeasure, CameraView, Collision, ViewRequest
from storyblender.memory.paint import Paint
from storyblender.memory.request import Picture, Request

__all__ = ["Answerer", "AssetSource", "Embedder", "Engine", "ViewRequest", "Viewfinder"]


class Answerer(Protocol):
    """Answers for a role: a language model, a person at a chat window, or a recording of either."""

    def answer(self, request: Request) -> str:
        """Return the answer as it was given; whether it is of the form that was asked for is the asker's to check.

        Raises:
            NoAnswer: It failed for good, and the role's next policy takes over.
            AnswerAwaited: It has to come from outside first; the run stops here and goes on from here.
        """
        ...


class Viewfinder(Protocol):
    """The engine's eye: renders an ID mask and returns what is seen, as numbers; asked for it, as a picture."""

    def look(self, requests: Sequence[ViewRequest]) -> list[CameraView]:
        """Return one view per request, in order."""
        ...

    def preview(self, requests: Sequence[ViewRequest]) -> list[Picture]:
        """Return one picture per request, in order: more than the frame, the subjects outlined in red."""
        ...


class Embedder(Protocol):
    """Turns texts into vectors whose dot product is likeness of meaning."""

    def embed(self, texts: Sequence[str]) -> NDArray[np.float32]:
        """Return (n, d) unit vectors."""
        ...


class AssetSource(Protocol):
    """A place that assets come from: the built-in library, folders of models, a service."""

    @property
    def name(self) -> str:
        """What the source is called in the provenance of its assets."""
        ...

    def search(self, query: AssetQuery, *, by_meaning: bool = False) -> Sequence[Recipe]:
        """Return what fits an object, best first, each with its score and the reason for it.

        Args:
            query: The object.
            by_meaning: Also return what is only similar in meaning; asked where no source has a thing of that name.
        """
        ...

    def inventory(self) -> Mapping[str, str]:
        """Return names and digests of what can be found, as it is now; a change asks for another plan."""
        ...

    def fetch(self, recipe: Recipe, files: Folder) -> Recipe:
        """Make what a recipe of this source names readable for the engine; return the recipe with its provenance.

        Args:
            recipe: As it was found by ``search``.
            files: The project folder; files from elsewhere are written to ``FETCHED`` in it, named as the recipe's key.

        Raises:
            InputError: It cannot be fetched.
        """
        ...


class Engine(Protocol):
    """The port that builds, measures and renders: Blender, a render farm, or a stand-in for tests.

    Long work is a future, which raises EngineError where the job failed for good. Names of files in jobs are relative
    to the project folder.
    """

    @property
    def processes(self) -> int:
        """How many processes share the work."""
        ...

    def warm(self) -> None:
        """Start Blender now, for a call that is sure to come."""
        ...

    def cancel_waiting(self) -> None:
        """Cancel the jobs that no process has begun; those under way end as usual, though nobody may wait for them."""
        ...

    @property
    def front(self) -> Engine:
        """An engine of the same project for what a person waits for, beside what this one is busy with."""
        ...

    def build_asset(self, job: AssetJob) -> Future[AssetMeasure]:
        """Build one canonical asset and measure it."""
        ...

    def pack_scene(self, job: SceneJob) -> Future[PackRef]:
        """Build one scene with the motion of all its shots."""
        ...

    def rehearse(self, job: SceneJob, shot_ids: Sequence[int]) -> Future[PackRef]:
        """Have a scene be as its pack will be in some of its shots, without building and saving all of it.

        Args:
            job: The scene.
            shot_ids: Staged shots of it; calls on the pack that is returned see them, until another one is rehearsed.
        """
        ...

    def read_figures(self, pack: PackRef, frames: Sequence[int]) -> Future[list[list[Figure]]]:
        """Say where all people's faces are at some frames of a scene.

        Args:
            pack: The scene.
            frames: Frame numbers on the scene's timeline.

        Returns:
            All people with a face, for each frame in the order given; world frame, metres.
        """
        ...

    def look(self, pack: PackRef, requests: Sequence[ViewRequest], aspect: float) -> Future[list[CameraView]]:
        """Look through the viewfinder.

        Args:
            pack: The scene.
            requests: Camera poses, each at one frame of a shot of the scene.
            aspect: Width over height of the picture.

        Returns:
            One view per request, in order.
        """
        ...

    def preview(self, pack: PackRef, requests: Sequence[ViewRequest], aspect: float) -> Future[list[Picture]]:
        """Draw what the viewfinder shows: plain colours, more than the frame, the subjects outlined in red.

        Args:
            pack: The scene.
            requests: Camera poses, each at one frame of a shot of the scene.
            aspect: Width over height of the frame.

        Returns:
            One picture per request, in order.
        """
        ...

    def find_collisions(self, pack: PackRef) -> Future[list[Collision]]:
        """Find people inside furniture, in every shot of a pack."""
        ...

    def measure_drift(self, pack: PackRef) -> Future[float]:
        """Measure the Spatial Drift Error of a scene's static things."""
        ...

    def render_frame(self, job: FrameJob) -> Future[FrameReport]:
        """Render the board frame of one shot."""
        ...

    def write_moment(self, job: MomentJob) -> Future[str]:
        """Write what a scene looks like at one moment as glTF, for a viewer; return the file's name."""
        ...

    def render_motion(self, job: MotionJob) -> Future[int]:
        """Render the moving frames of one shot."""
        ...

    def compile_story(self, job: StoryJob) -> Future[str]:
        """Compile the .blend of a story or of one sequence."""
        ...

    def compile_cut(self, job: CutJob) -> Future[str]:
        """Compile the .blend of a long story, which links those of its sequences."""
        ...

    def read_story(self, name: str) -> Future[BlendReading]:
        """Read back a .blend of the story, which a person may have changed; raises EngineError if it cannot be read.

        Args:
            name: Of the file in the project folder.
        """
        ...

    def adopt_object(self, name: str, scene: str, node: str, *, keep: bool) -> Future[AdoptedObject]:
        """Write an object of a .blend of the story as a model of its own; raises EngineError if it cannot be one.

        Args:
            name: Of the file in the project folder.
            scene: Of the file.
            node: Name of the object.
            keep: False only says what would be written.
        """
        ...

    def export_scene(self, job: ExportJob) -> Future[str]:
        """Write one scene as glTF or USD."""
        ...

    def portrait(self, job: AssetJob, out: str, paints: Sequence[Paint] = ()) -> Future[str]:
        """Render a small picture of one asset.

        Args:
            job: The asset, which is built if it is not yet.
            out: Name of the PNG in the project folder; it is returned.
            paints: What a person decided about its materials.
        """
        ...

    def write_asset(self, job: AssetJob, out: str, paints: Sequence[Paint] = ()) -> Future[str]:
        """Write one asset as glTF, for a viewer.

        Args:
            job: The asset; people and things that are built come from the store, another thing is built for it.
            out: Name of the .glb in the project folder; it is returned.
            paints: What a person decided about its materials.
        """
        ...

    def draw_sides(self, job: AssetJob, folder: str) -> Future[Vec3]:
        """Render an object from its six sides and as a portrait.

        Args:
            job: The object, which is built for it and not kept.
            folder: In the project folder; ``front.png``, ``back.png``, ``left.png``, ``right.png``, ``top.png``,
                ``bottom.png`` at one scale and ``portrait.png`` are written into it.

        Returns:
            Width, depth and height in metres.
        """
        ...

"""The protocols between StoryBlender and the world outside it. Agents and pipeline get ports, never adapters."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Future
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from storyblender.geometry.framing import Figure
from storyblender.memory.jobs import (
    AssetJob,
    CutJob,
    ExportJob,
    FrameJob,
    FrameReport,
    MotionJob,
    PackRef,
    SceneJob,
    StoryJob,
)
from storyblender.memory.measure import AssetMeasure, CameraView, Collision, ViewRequest

__all__ = ["Embedder", "Engine", "ViewRequest", "Viewfinder"]


class Viewfinder(Protocol):
    """The engine's eye: renders an ID mask and returns what is seen, as numbers."""

    def look(self, requests: Sequence[ViewRequest]) -> list[CameraView]:
        """Return one view per request, in order."""
        ...


class Embedder(Protocol):
    """Turns texts into vectors whose dot product is likeness of meaning."""

    def embed(self, texts: Sequence[str]) -> NDArray[np.float32]:
        """Return (n, d) unit vectors."""
        ...


class Engine(Protocol):
    """The port that builds, measures and renders: Blender, a render farm, or a stand-in for tests.

    Long work is a future; names of files in jobs are relative to the project folder.
    """

    @property
    def processes(self) -> int:
        """How many processes share the work."""
        ...

    def warm(self) -> None:
        """Start Blender now, for a call that is sure to come."""
        ...

    def build_asset(self, job: AssetJob) -> Future[AssetMeasure]:
        """Build one canonical asset and measure it."""
        ...

    def pack_scene(self, job: SceneJob) -> Future[PackRef]:
        """Build one scene with the motion of all its shots."""
        ...

    def read_figures(self, pack: PackRef, frames: Sequence[int]) -> Future[list[list[Figure]]]:
        """Say where everybody's face is at frames of the scene's timeline."""
        ...

    def look(self, pack: PackRef, requests: Sequence[ViewRequest], aspect: float) -> Future[list[CameraView]]:
        """Look through the viewfinder."""
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

    def render_motion(self, job: MotionJob) -> Future[int]:
        """Render the moving frames of one shot."""
        ...

    def compile_story(self, job: StoryJob) -> Future[str]:
        """Compile the .blend of a story or of one sequence."""
        ...

    def compile_cut(self, job: CutJob) -> Future[str]:
        """Compile the .blend of a long story, which links those of its sequences."""
        ...

    def export_scene(self, job: ExportJob) -> Future[str]:
        """Write one scene as glTF or USD."""
        ...

    def portrait(self, job: AssetJob, out: str) -> Future[str]:
        """Render a small picture of one asset."""
        ...

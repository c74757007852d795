"""The MCP server: a closed set of typed tools. No tool runs code, no path leaves the project folder."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import TypeVar

from fastmcp import FastMCP

from storyblender.blender.main_thread import MainThread
from storyblender.blender.session import Session
from storyblender.geometry.framing import Figure
from storyblender.memory.jobs import (
    AssetJob,
    ExportJob,
    FrameJob,
    FrameReport,
    MotionJob,
    PackRef,
    SceneJob,
    StoryJob,
)
from storyblender.memory.measure import AssetMeasure, CameraView, Collision, ViewRequest

Result = TypeVar("Result")


def make_server(session: Session, main_thread: MainThread) -> FastMCP:
    """Return the server whose tools act on ``session``.

    Args:
        session: The Blender state of this process.
        main_thread: Where every tool's work is done.
    """
    server: FastMCP = FastMCP("storyblender-engine")

    async def on_main(call: Callable[[], Result]) -> Result:
        return await asyncio.wrap_future(main_thread.submit(call))

    @server.tool
    async def health() -> dict[str, str]:
        """Say that the worker lives, and which Blender it is."""
        return await on_main(session.health)

    @server.tool
    async def build_asset(job: AssetJob) -> AssetMeasure:
        """Build one canonical asset into the asset cache and measure it."""
        return await on_main(lambda: session.build_asset(job))

    @server.tool
    async def pack_scene(job: SceneJob) -> PackRef:
        """Build one scene with the motion of all its shots into a pack."""
        return await on_main(lambda: session.pack_scene(job))

    @server.tool
    async def read_figures(pack: PackRef, frames: list[int]) -> list[list[Figure]]:
        """Say where everybody's face is at frames of the scene's timeline."""
        return await on_main(lambda: session.figures(pack, frames))

    @server.tool
    async def look(pack: PackRef, requests: list[ViewRequest], aspect: float) -> list[CameraView]:
        """Look through the viewfinder: ID masks turned into numbers."""
        return await on_main(lambda: session.look(pack, requests, aspect))

    @server.tool
    async def find_collisions(pack: PackRef) -> list[Collision]:
        """Find people inside furniture, in every shot of a pack."""
        return await on_main(lambda: session.find_collisions(pack))

    @server.tool
    async def measure_drift(pack: PackRef) -> float:
        """Measure the Spatial Drift Error of a scene's static things."""
        return await on_main(lambda: session.measure_drift(pack))

    @server.tool
    async def render_frame(job: FrameJob) -> FrameReport:
        """Render the board frame of one shot."""
        return await on_main(lambda: session.render_frame(job))

    @server.tool
    async def render_motion(job: MotionJob) -> int:
        """Render the moving frames of one shot; returns how many were written."""
        return await on_main(lambda: session.render_motion(job))

    @server.tool
    async def compile_story(job: StoryJob) -> str:
        """Compile the story's .blend from the packs; returns its path."""
        return await on_main(lambda: session.compile_story(job))

    @server.tool
    async def export_scene(job: ExportJob) -> str:
        """Write one scene as glTF or USD; returns the path."""
        return await on_main(lambda: session.export_scene(job))

    @server.tool
    async def portrait(job: AssetJob, out: str) -> str:
        """Render a small picture of one asset; returns the path."""
        return await on_main(lambda: session.portrait(job, out))

    return server

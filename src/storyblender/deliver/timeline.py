"""The editorial timeline: OpenTimelineIO always, EDL and FCPXML where their adapters are installed."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import opentimelineio as otio

from storyblender.deliver.panel import Panel, panels
from storyblender.deliver.speech import speeches
from storyblender.errors import InputError
from storyblender.memory.graph import ContinuityMemoryGraph

EXTRA_FORMATS = {"edl": ("cmx_3600", ".edl"), "fcpxml": ("fcpx_xml", ".fcpxml")}


def build_timeline(graph: ContinuityMemoryGraph, frames: Mapping[str, Path], folder: Path) -> otio.schema.Timeline:
    """Return one video track with a clip per shot, markers for dialogue, and the numbers as metadata.

    Args:
        graph: The story.
        frames: Shot name to picture.
        folder: Media are named relative to it, so the project can be moved.
    """
    timeline = otio.schema.Timeline(name=graph.title or "storyboard")
    track = otio.schema.Track(name="storyboard", kind=otio.schema.TrackKind.Video)
    timeline.tracks.append(track)
    for panel in panels(graph):
        track.append(_clip(panel, frames.get(panel.name), folder))
    return timeline


def write_timeline(graph: ContinuityMemoryGraph, frames: Mapping[str, Path], out: Path) -> None:
    """Write ``timeline.otio``."""
    otio.adapters.write_to_file(build_timeline(graph, frames, out.parent), str(out))


def write_extra(graph: ContinuityMemoryGraph, frames: Mapping[str, Path], out: Path, name: str) -> Path:
    """Write the timeline as ``edl`` or ``fcpxml`` beside ``out`` and return its path.

    Raises:
        InputError: The adapter is not installed, or an EDL has no timecode for the rate.
    """
    adapter, suffix = EXTRA_FORMATS[name]
    if adapter not in otio.adapters.available_adapter_names():
        raise InputError(f"{name} needs an extra", mend="pip install 'storyblender[edl]'")
    path = out.with_suffix(suffix)
    timeline, rate = build_timeline(graph, frames, out.parent), graph.format.fps
    if adapter == "cmx_3600" and not otio.opentime.RationalTime(0, rate).is_valid_timecode_rate(rate):
        raise InputError(
            f"an EDL cannot count {rate} frames a second", mend="timeline.otio can; or make it with --fps 24"
        )
    options = {"rate": rate} if adapter == "cmx_3600" else {}
    otio.adapters.write_to_file(timeline, str(path), adapter_name=adapter, **options)
    return path


def reel_of(panel: Panel) -> str:
    """Return the name an EDL knows a shot's picture by: eight characters at most, and of no other shot."""
    return panel.name.replace("SC", "").replace("SH", "")


def _clip(panel: Panel, frame: Path | None, folder: Path) -> otio.schema.Clip:
    duration = otio.opentime.RationalTime(panel.shot.duration, panel.fps)
    span = otio.opentime.TimeRange(otio.opentime.RationalTime(0, panel.fps), duration)
    media: otio.core.MediaReference = otio.schema.MissingReference(available_range=span)
    if frame is not None:
        media = otio.schema.ExternalReference(frame.relative_to(folder).as_posix(), span)
    clip = otio.schema.Clip(name=panel.name, media_reference=media, source_range=span)
    instruction = panel.shot.camera_instruction
    clip.metadata["cmx_3600"] = {"reel": reel_of(panel)}
    clip.metadata["storyblender"] = {
        "scene": panel.shot.scene_id,
        "shot": panel.shot.shot_id,
        "heading": panel.scene.heading,
        "size": instruction.size,
        "angle": instruction.angle,
        "movement": panel.movement,
        "lens_mm": panel.lens,
        "action": panel.action,
    }
    for speech in speeches(panel):
        start, length = (otio.opentime.RationalTime(n, panel.fps) for n in (speech.start, speech.end - speech.start))
        name = " ".join(f"{speech.line.speaker_name}: {speech.line.text}".split())
        clip.markers.append(otio.schema.Marker(name=name, marked_range=otio.opentime.TimeRange(start, length)))
    return clip

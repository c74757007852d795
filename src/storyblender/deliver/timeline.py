"""The editorial timeline: OpenTimelineIO always, FCPXML on request, EDL where its adapter is installed."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import opentimelineio as otio

from storyblender.deliver.fcpxml import write_fcpxml
from storyblender.deliver.panel import Panel, frame_of, panels
from storyblender.deliver.speech import speeches
from storyblender.errors import InputError
from storyblender.memory.graph import ContinuityMemoryGraph

EXTRA_FORMATS = {"edl": ".edl", "fcpxml": ".fcpxml"}
_EDL = "cmx_3600"
STILL = "still"
"""Name of a clip's other media: its board frame, beside the moving picture."""


def build_timeline(
    graph: ContinuityMemoryGraph,
    frames: Mapping[str, Path],
    clips: Mapping[str, Path],
    folder: Path,
    start: str = "00:00:00:00",
) -> otio.schema.Timeline:
    """Return one video track with a clip per shot, markers for dialogue, and the numbers as metadata.

    Args:
        graph: The story.
        frames: Shot name to picture.
        clips: Shot name to moving picture, as long as the shot; the frame is the clip's other media then.
        folder: Media are named relative to it, so the project can be moved.
        start: Timecode of the first frame.
    """
    timeline = otio.schema.Timeline(name=" ".join(graph.title.split()) or "storyboard")
    fps = graph.format.fps
    timeline.global_start_time = otio.opentime.RationalTime(frame_of(start, fps), fps)
    track = otio.schema.Track(name="storyboard", kind=otio.schema.TrackKind.Video)
    timeline.tracks.append(track)
    for panel in panels(graph):
        track.append(_clip(panel, frames.get(panel.name), clips.get(panel.name), folder))
    return timeline


def write_timeline(
    graph: ContinuityMemoryGraph,
    frames: Mapping[str, Path],
    clips: Mapping[str, Path],
    part: Path,
    folder: Path,
    start: str,
) -> None:
    """Write ``timeline.otio`` to ``part``; the other arguments are those of ``build_timeline``."""
    otio.adapters.write_to_file(build_timeline(graph, frames, clips, folder, start), str(part))


def write_extra(
    graph: ContinuityMemoryGraph,
    frames: Mapping[str, Path],
    clips: Mapping[str, Path],
    part: Path,
    folder: Path,
    name: str,
    start: str,
) -> None:
    """Write the timeline to ``part`` as ``edl`` or ``fcpxml``; the other arguments are those of ``build_timeline``.

    Raises:
        InputError: The adapter is not installed, or an EDL has no timecode for the rate.
    """
    if name == "edl":
        _write_edl(build_timeline(graph, frames, clips, folder, start), part, graph.format.fps)
    else:
        write_fcpxml(graph, frames, clips, part, folder, frame_of(start, graph.format.fps))


def _write_edl(timeline: otio.schema.Timeline, part: Path, rate: int) -> None:
    if _EDL not in otio.adapters.available_adapter_names():
        raise InputError("edl needs an extra", mend="pip install 'storyblender[edl]'")
    if not otio.opentime.RationalTime(0, rate).is_valid_timecode_rate(rate):
        raise InputError(
            f"an EDL cannot count {rate} frames a second", mend="timeline.otio can; or make it with --fps 24"
        )
    before = otio.opentime.TimeRange(otio.opentime.RationalTime(0, rate), timeline.global_start_time)
    timeline.tracks[0].insert(0, otio.schema.Gap(source_range=before))  # the adapter counts from zero, whatever we say
    otio.adapters.write_to_file(timeline, str(part), adapter_name=_EDL, rate=rate)


def reel_of(panel: Panel) -> str:
    """Return the name an EDL knows a shot's picture by: eight characters at most, and of no other shot."""
    return panel.name.replace("SC", "").replace("SH", "")


def _clip(panel: Panel, frame: Path | None, clip: Path | None, folder: Path) -> otio.schema.Clip:
    duration = otio.opentime.RationalTime(panel.shot.duration, panel.fps)
    span = otio.opentime.TimeRange(otio.opentime.RationalTime(0, panel.fps), duration)
    pictures = [
        otio.schema.ExternalReference(path.relative_to(folder).as_posix(), span) for path in (clip, frame) if path
    ]
    shown: list[otio.core.MediaReference] = [*pictures, otio.schema.MissingReference(available_range=span)]
    result = otio.schema.Clip(name=panel.name, media_reference=shown[0], source_range=span)
    if len(pictures) == 2:
        key = result.active_media_reference_key
        result.set_media_references({key: pictures[0], STILL: pictures[1]}, key)
    instruction = panel.shot.camera_instruction
    result.metadata["cmx_3600"] = {"reel": reel_of(panel)}
    result.metadata["storyblender"] = {
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
        result.markers.append(otio.schema.Marker(name=name, marked_range=otio.opentime.TimeRange(start, length)))
    return result

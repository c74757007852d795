"""The editorial timeline: OpenTimelineIO always, FCPXML on request, EDL where its adapter is installed."""

from __future__ import annotations

from pathlib import Path

import opentimelineio as otio

from storyblender.deliver.fcpxml import write_fcpxml
from storyblender.deliver.panel import Panel, panels
from storyblender.deliver.speech import speeches
from storyblender.deliver.timeline_media import TimelineMedia
from storyblender.errors import InputError

EXTRA_FORMATS = {"edl": ".edl", "fcpxml": ".fcpxml"}
_EDL = "cmx_3600"
STILL = "still"
"""Media key of a clip's board frame, beside its moving picture."""


def build_timeline(media: TimelineMedia) -> otio.schema.Timeline:
    """Return one video track with a clip per shot, markers for dialogue, and the numbers as metadata.

    A shot with a moving picture has its still as the clip's other media.
    """
    timeline = otio.schema.Timeline(name=" ".join(media.graph.title.split()) or "storyboard")
    timeline.global_start_time = otio.opentime.RationalTime(media.first, media.graph.format.fps)
    track = otio.schema.Track(name="storyboard", kind=otio.schema.TrackKind.Video)
    timeline.tracks.append(track)
    for panel in panels(media.graph):
        track.append(_clip(panel, media))
    return timeline


def write_timeline(media: TimelineMedia, part: Path) -> None:
    """Write the timeline as OpenTimelineIO.

    Args:
        media: The story with its pictures.
        part: Where to write it; ends in ``.otio``.
    """
    otio.adapters.write_to_file(build_timeline(media), str(part))


def write_extra(media: TimelineMedia, part: Path, name: str) -> None:
    """Write the timeline in another format.

    Args:
        media: The story with its pictures.
        part: Where to write it.
        name: ``edl`` or ``fcpxml``.

    Raises:
        InputError: The adapter is not installed, or an EDL has no timecode for the rate.
    """
    if name == "edl":
        _write_edl(build_timeline(media), part, media.graph.format.fps)
    else:
        write_fcpxml(media, part)


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
    """Return a shot's reel name for an EDL: unique, at most eight characters."""
    return panel.name.replace("SC", "").replace("SH", "")


def _clip(panel: Panel, media: TimelineMedia) -> otio.schema.Clip:
    duration = otio.opentime.RationalTime(panel.shot.duration, panel.fps)
    span = otio.opentime.TimeRange(otio.opentime.RationalTime(0, panel.fps), duration)
    paths = [found[panel.name] for found in (media.clips, media.frames) if panel.name in found]
    pictures = [otio.schema.ExternalReference(path.relative_to(media.folder).as_posix(), span) for path in paths]
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

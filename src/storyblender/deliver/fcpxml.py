"""The timeline as FCPXML, for Final Cut Pro and DaVinci Resolve: a clip a shot, or its still, with dialogue as markers.

Written here, because OpenTimelineIO's adapter leaves out the size, the start timecode and most frame rates.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from pathlib import Path
from urllib.parse import quote
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

import av

from storyblender.deliver.panel import Panel, panels
from storyblender.deliver.speech import speeches
from storyblender.deliver.timeline_media import TimelineMedia

_REC709 = "1-1-1 (Rec. 709)"
"""Primaries, transfer and matrix as FCPXML names them."""
_NO_XML = {code: " " for code in (*range(32), 127, 0xFFFE, 0xFFFF) if chr(code) not in "\t\n"}
"""Characters that XML may not hold."""


def write_fcpxml(media: TimelineMedia, part: Path) -> None:
    """Write the timeline to ``part``, with the moving picture of each shot, or else its still.

    Args:
        media: The story with its pictures, all below its ``folder``.
        part: Where to write it.
    """
    graph, clips = media.graph, media.clips
    shots, fps = panels(graph), graph.format.fps
    root = Element("fcpxml", version="1.8")
    resources = SubElement(root, "resources")
    size = graph.format.width, graph.format.height
    for key, (width, height) in (("r1", size), ("r2", _size(clips) if clips else size)):
        shape = {"width": str(width), "height": str(height), "colorSpace": _REC709}
        SubElement(resources, "format", {"id": key, "frameDuration": _seconds(1, fps), **shape})
    title = _text(" ".join(graph.title.split()) or "Storyboard")
    project = SubElement(SubElement(root, "event", name=title), "project", name=title)
    length = _seconds(sum(panel.shot.duration for panel in shots), fps)
    timing = {"format": "r1", "duration": length, "tcStart": _seconds(media.first, fps), "tcFormat": "NDF"}
    spine = SubElement(SubElement(project, "sequence", timing), "spine")
    for panel in shots:
        path = clips.get(panel.name) or media.frames.get(panel.name)
        _shot(resources, spine, panel, path and path.relative_to(media.folder), panel.name in clips, media.first)
    ElementTree.indent(root, "  ")
    text = ElementTree.tostring(root, encoding="unicode")
    part.write_text(f'<?xml version="1.0" encoding="UTF-8"?>\n<!DOCTYPE fcpxml>\n{text}\n', encoding="utf-8")


def _shot(resources: Element, spine: Element, panel: Panel, media: Path | None, moving: bool, first: int) -> None:
    """Add a shot to the timeline and its file to the resources; a gap where it has no picture yet."""
    duration = _seconds(panel.shot.duration, panel.fps)
    place = {
        "name": panel.name,
        "offset": _seconds(first + panel.start, panel.fps),
        "duration": duration,
        "start": "0s",
    }
    if media is None:
        element = SubElement(spine, "gap", place)
    elif moving:
        element = SubElement(
            spine, "asset-clip", {"ref": _asset(resources, panel.name, media, "r2", duration), **place}
        )
    else:
        element = SubElement(spine, "clip", place)
    if panel.action:
        SubElement(element, "note").text = _text(panel.action)
    if media is not None and not moving:
        key = _asset(resources, panel.name, media, "r1", duration)
        SubElement(element, "video", {"ref": key, "offset": "0s", "start": "0s", "duration": duration})
    for speech in speeches(panel):
        said = _text(" ".join(f"{speech.line.speaker_name}: {speech.line.text}".split()))
        span = {"start": _seconds(speech.start, panel.fps), "duration": _seconds(speech.end - speech.start, panel.fps)}
        SubElement(element, "marker", {**span, "value": said})


def _asset(resources: Element, name: str, media: Path, form: str, duration: str) -> str:
    """Add a file to the resources and return its key."""
    key = f"r{len(resources) + 1}"
    source = {"id": key, "name": name, "src": f"./{quote(media.as_posix())}", "start": "0s", "duration": duration}
    SubElement(resources, "asset", {**source, "format": form, "hasVideo": "1"})
    return key


def _size(clips: Mapping[str, Path]) -> tuple[int, int]:
    with av.open(str(next(iter(clips.values())))) as film:
        return film.streams.video[0].width, film.streams.video[0].height


def _seconds(frames: int, fps: int) -> str:
    """Return a time in the rational notation of FCPXML: ``13/2s``."""
    return f"{Fraction(frames, fps)}s"


def _text(words: str) -> str:
    return words.translate(_NO_XML)

"""The animatic: an H.264 film of the moving frames, with the dialogue as a subtitle track and as an ``.srt`` file."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path

import av
from av.container import OutputContainer
from av.subtitles.subtitle import SubtitleSet
from PIL import Image

from storyblender.deliver.panel import Panel, panels
from storyblender.deliver.segments import Segment, add_track, join
from storyblender.deliver.speech import Subtitle, subtitles
from storyblender.memory.graph import ContinuityMemoryGraph

_STYLE = b"""[V4+ Styles]
Format: Name, Fontname, Fontsize, PrimaryColour, BackColour, Alignment
Style: Default,Arial,18,&Hffffff,&H0,2
[Events]
Format: Layer, Start, End, Style, Name, MarginL, MarginR, MarginV, Effect, Text
"""
"""White subtitles at the bottom of the picture, as an ASS header, the only form that the encoder reads."""
_MILLISECOND = Fraction(1, 1000)
_MARKUP = re.compile(r"[<&\\]")
_BRACES = str.maketrans("{}", "｛｝")


def film_segments(
    graph: ContinuityMemoryGraph, clips: Mapping[str, Sequence[Path]], stills: Mapping[str, Path]
) -> list[Segment]:
    """Return the shots of the film, in order.

    Args:
        graph: The story; its format gives the rate.
        clips: Shot name to its moving frames in order; each is held equally long so that together they fill the shot.
        stills: Shot name to its board frame, for a shot without moving frames.
    """
    size = _size(clips, stills)
    return [
        Segment(tuple(clips.get(panel.name) or [stills[panel.name]]), panel.shot.duration, size, panel.fps)
        for panel in panels(graph)
    ]


def write_animatic(graph: ContinuityMemoryGraph, segments: Sequence[Path], part: Path) -> None:
    """Write the film with a subtitle track that a player can switch off.

    Args:
        graph: The story; its format gives the rate.
        segments: Every shot, encoded, in order.
        part: The ``.mp4``.
    """
    shots = panels(graph)
    pieces = [(path, panel.shot.duration) for path, panel in zip(segments, shots, strict=True)]
    with av.open(str(part), "w", format="mp4", options={"movflags": "faststart"}) as film:
        track = add_track(film, segments[0])
        _add_subtitles(film, subtitles(shots))
        join(pieces, graph.format.fps, film, track)


def write_subtitles(graph: ContinuityMemoryGraph, part: Path) -> None:
    """Write the dialogue as an ``.srt`` file.

    Args:
        graph: The story.
        part: Where to write it.
    """
    part.write_text(subrip(panels(graph)), encoding="utf-8")


def subrip(shots: Sequence[Panel]) -> str:
    """Return the dialogue as SubRip text; characters that players read as markup are escaped."""
    return "\n".join(
        f"{number}\n{_srt_time(piece.start)} --> {_srt_time(piece.end)}\n{_unmarked(piece.text)}\n"
        for number, piece in enumerate(subtitles(shots), start=1)
    )


def _unmarked(text: str) -> str:
    """Escape markup for SubRip, which has no escape syntax.

    An invisible word joiner keeps ``<i>`` and ``&lt;`` from being read as markup. Players hide any text in braces, so
    braces become full-width ones.
    """
    return _MARKUP.sub("\\g<0>\u2060", text).translate(_BRACES)


def _add_subtitles(container: OutputContainer, pieces: Sequence[Subtitle]) -> None:
    """Add the subtitle track; no track for a film without dialogue."""
    if not pieces:
        return
    track = container.add_stream("mov_text")
    track.time_base = _MILLISECOND
    track.codec_context.subtitle_header = _STYLE
    for number, piece in enumerate(pieces):
        start, length = round(piece.start * 1000), round((piece.end - piece.start) * 1000)
        # joiners keep a backslash in the script from being read as a code; a new line is one
        text = piece.text.replace("\\", "\u2060\\\u2060").replace("\n", "\\N")
        line = f"{number},0,Default,,0,0,0,,{text}"
        packet = track.codec_context.encode_subtitle(SubtitleSet.create(line.encode(), 0, length, start))
        packet.stream, packet.time_base = track, _MILLISECOND
        packet.pts = packet.dts = start
        packet.duration = length
        container.mux(packet)


def _size(clips: Mapping[str, Sequence[Path]], stills: Mapping[str, Path]) -> tuple[int, int]:
    """Return width and height of the first picture, rounded down to even numbers for the codec."""
    first = next((paths[0] for paths in clips.values() if paths), None) or next(iter(stills.values()))
    with Image.open(first) as image:
        return image.width // 2 * 2, image.height // 2 * 2


def _srt_time(seconds: float) -> str:
    milliseconds = round(seconds * 1000)
    return (
        f"{milliseconds // 3_600_000:02d}:{milliseconds // 60_000 % 60:02d}:"
        f"{milliseconds // 1000 % 60:02d},{milliseconds % 1000:03d}"
    )

"""Shots of the animatic as H.264 segments, named by their content: encoded once, joined without encoding again."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from fractions import Fraction
from io import BytesIO
from pathlib import Path

import av
from av.container import OutputContainer
from av.video.frame import PictureType
from av.video.reformatter import ColorPrimaries, ColorRange, Colorspace, ColorTrc, Interpolation
from av.video.stream import VideoStream

from storyblender.folder import Folder
from storyblender.outputs import Outputs

SEGMENTS = "build/film"
_CODEC = {"crf": "20", "preset": "veryfast", "threads": "1"}
"""One thread an encoder, so that its result is the same on every machine; segments are encoded in parallel."""
_COLORS = (ColorPrimaries.BT709, ColorTrc.BT709, Colorspace.ITU709, ColorRange.MPEG)
"""Colour metadata written into the file; without it players guess, and not all alike."""
_SCALING = Interpolation.BILINEAR | Interpolation.ACCURATE_RND | Interpolation.BITEXACT
"""Exact rounding; the fast one darkens every picture by a step or two."""
_SEEK = 4
"""Most seconds between key frames; every cut is one too."""


@dataclass(frozen=True)
class Segment:
    """One shot of the film.

    Attributes:
        pictures: In order; each is held equally long so that together they fill the shot.
        length: Frames of the film.
        size: Pixels across and down, both even.
        fps: Frames a second.
    """

    pictures: tuple[Path, ...]
    length: int
    size: tuple[int, int]
    fps: int

    @property
    def digest(self) -> str:
        """Hash of pictures and encoder settings: equal digests, equal segments."""
        settings = (av.__version__, sorted(_CODEC.items()), _COLORS, _SCALING, _SEEK, self.length, self.size, self.fps)
        content = hashlib.sha256(repr(settings).encode())
        for path in self.pictures:
            content.update(hashlib.sha256(path.read_bytes()).digest())
        return content.hexdigest()[:16]


def encode_segments(
    segments: Sequence[Segment],
    files: Folder,
    outputs: Outputs,
    processes: int = 1,
    progress: Callable[[int, int], None] = lambda done, of: None,
) -> list[Path]:
    """Return a file for each segment, in order; encode only new ones and delete unused ones.

    Args:
        segments: The film.
        files: The project.
        outputs: The record of written files.
        processes: How many are encoded in parallel.
        progress: Called with the number of segments encoded and to encode.
    """
    names = [f"{SEGMENTS}/{segment.digest}.mp4" for segment in segments]
    new = {name: segment for name, segment in zip(names, segments, strict=True) if not outputs.whole(name)}

    def encode(name: str) -> None:
        with outputs.writing(name) as part:
            _encode(new[name], part)

    with ThreadPoolExecutor(processes) as threads:
        for done, _ in enumerate(threads.map(encode, new), start=1):
            progress(done, len(new))
    outputs.keep_only(f"{SEGMENTS}/", names)
    return [files.path(name) for name in names]


def add_track(film: OutputContainer, segment: Path) -> VideoStream:
    """Add a video stream to a film with the codec parameters of a segment.

    Args:
        film: Open for writing.
        segment: An encoded file with one video stream.
    """
    with av.open(str(segment)) as piece:
        return film.add_stream_from_template(piece.streams.video[0])


def join(segments: Sequence[tuple[Path, int]], fps: int, film: OutputContainer, track: VideoStream) -> None:
    """Append segments to a film.

    Args:
        segments: Files of equal size, and their lengths in frames.
        fps: Frames a second.
        film: The film.
        track: Its video stream.
    """
    start = 0
    for path, length in segments:
        with av.open(str(path)) as piece:
            for packet in piece.demux(video=0):
                if packet.dts is None or packet.pts is None:  # the demuxer's last, which is empty
                    continue
                offset = round(Fraction(start, fps) / packet.time_base)
                packet.pts, packet.dts = packet.pts + offset, packet.dts + offset
                packet.stream = track
                film.mux(packet)
        start += length


def _encode(segment: Segment, part: Path) -> None:
    with av.open(str(part), "w", format="mp4") as container:
        stream = container.add_stream("libx264", rate=segment.fps)
        stream.width, stream.height = segment.size
        stream.pix_fmt = "yuv420p"
        stream.options = {**_CODEC, "g": str(_SEEK * segment.fps)}
        stream.time_base = rate = Fraction(1, segment.fps)
        codec = stream.codec_context
        codec.color_primaries, codec.color_trc, codec.colorspace, codec.color_range = _COLORS
        shown, frame = b"", None
        for index in range(segment.length):
            content = segment.pictures[index * len(segment.pictures) // segment.length].read_bytes()
            if content != shown or frame is None:
                shown, frame = content, _frame(content, segment.size)
            frame.pts, frame.time_base = index, rate
            container.mux(stream.encode(frame))
        container.mux(stream.encode(None))


def _frame(content: bytes, size: tuple[int, int]) -> av.VideoFrame:
    """Decode a picture into the codec's pixel format and the film's colour space."""
    with av.open(BytesIO(content), "r") as image:
        picture = next(image.decode(video=0))
    primaries, transfer, matrix, limited = _COLORS
    frame = picture.reformat(
        *size,
        format="yuv420p",
        interpolation=_SCALING,
        dst_colorspace=matrix,
        src_color_range=ColorRange.JPEG,
        dst_color_range=limited,
        dst_color_trc=transfer,
        dst_color_primaries=primaries,
    )
    frame.pict_type = PictureType.NONE  # a picture by itself is a key frame; in the film the codec decides
    return frame

"""The film in segments: joined it is one film, frame for frame, and a changed shot is the only one encoded."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import av
import pytest
from PIL import Image

from storyblender.deliver.segments import Segment, add_track, encode_segments, join
from storyblender.folder import Folder
from storyblender.outputs import Outputs

FPS = 24
LENGTHS = (30, 7, 111)
SIZE = (64, 36)


def segment(folder: Path, number: int, length: int, grey: int) -> Segment:
    """A shot on twos that grows lighter."""
    paths: list[Path] = []
    for index in range((length + 1) // 2):
        paths.append(folder / f"{number}_{grey}_{index}.{'png' if number else 'jpg'}")
        Image.new("RGB", SIZE, (grey + index // 2,) * 3).save(paths[-1])
    return Segment(tuple(paths), length, SIZE, FPS)


def made(segments: list[Segment], folder: Path, processes: int = 1) -> list[Path]:
    files = Folder(folder)
    return encode_segments(segments, files, Outputs(files), processes)


def greys(film: Path) -> list[float]:
    """The mean of each picture of a film."""
    with av.open(str(film)) as container:
        return [float(frame.to_ndarray(format="rgb24").mean()) for frame in container.decode(video=0)]


def joined(paths: list[Path], out: Path) -> list[tuple[float, float]]:
    with av.open(str(out), "w") as film:
        track = add_track(film, paths[0])
        join(list(zip(paths, LENGTHS, strict=True)), FPS, film, track)
    with av.open(str(out)) as film:
        return [(frame.time, frame.to_ndarray(format="rgb24").mean()) for frame in film.decode(video=0)]


def test_joined_they_are_one_film(tmp_path: Path) -> None:
    segments = [segment(tmp_path, number, length, 40 + 60 * number) for number, length in enumerate(LENGTHS)]
    seen = joined(made(segments, tmp_path, 2), tmp_path / "film.mp4")
    shown = [
        40 + 60 * n + i * ((length + 1) // 2) // length // 2 for n, length in enumerate(LENGTHS) for i in range(length)
    ]
    assert [time for time, _ in seen] == pytest.approx([index / FPS for index in range(sum(LENGTHS))])
    assert [grey for _, grey in seen] == pytest.approx(shown, abs=2.5)


def test_a_player_can_jump_to_every_cut_and_every_four_seconds(tmp_path: Path) -> None:
    segments = [segment(tmp_path, number, length, 40) for number, length in enumerate(LENGTHS)]
    joined(made(segments, tmp_path), tmp_path / "film.mp4")
    with av.open(str(tmp_path / "film.mp4")) as film:
        stops = [
            round(packet.pts * packet.time_base * FPS)
            for packet in film.demux(video=0)
            if packet.is_keyframe and packet.pts is not None
        ]
    assert {0, 30, 37} <= set(stops)
    assert max(after - before for before, after in pairwise([*stops, sum(LENGTHS)])) <= 4 * FPS


def test_only_what_is_new_or_damaged_is_encoded_and_what_is_of_no_use_is_deleted(tmp_path: Path) -> None:
    segments = [segment(tmp_path, number, length, 40 + 60 * number) for number, length in enumerate(LENGTHS)]
    before = made(segments, tmp_path)
    untouched = before[0].stat().st_ino
    content, shown = before[2].read_bytes(), greys(before[2])
    before[2].write_bytes(content[: len(content) // 2])
    (before[0].parent / "mine.mp4").write_bytes(b"mine")
    after = made([segments[0], segment(tmp_path, 1, LENGTHS[1], 90), segments[2]], tmp_path)
    assert after[0].stat().st_ino == untouched and after[1] != before[1] and after[2] == before[2]
    assert greys(after[2]) == pytest.approx(shown, abs=0.5)
    assert sorted(after[0].parent.iterdir()) == sorted([*after, after[0].parent / "mine.mp4"])


def test_equal_pictures_of_equal_length_are_one_segment(tmp_path: Path) -> None:
    first = segment(tmp_path, 4, 8, 40)
    again = segment(tmp_path, 5, 8, 40)
    assert first.digest == again.digest != Segment(first.pictures, 9, SIZE, FPS).digest


def test_it_is_told_how_many_new_ones_are_done(tmp_path: Path) -> None:
    segments = [segment(tmp_path, number, 4, 40 + number) for number in range(3)]
    files, told = Folder(tmp_path), list[tuple[int, int]]()
    outputs = Outputs(files)
    encode_segments(segments[:1], files, outputs)
    encode_segments(segments, files, outputs, 2, lambda done, of: told.append((done, of)))
    assert told == [(1, 2), (2, 2)]

"""The film in segments: joined it is one film, frame for frame, and a changed shot is the only one encoded."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import av
import pytest
from PIL import Image

from storyblender.deliver.segments import Segment, add_track, encoded, join

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


def joined(paths: list[Path], out: Path) -> list[tuple[float, float]]:
    with av.open(str(out), "w") as film:
        track = add_track(film, paths[0])
        join(list(zip(paths, LENGTHS, strict=True)), FPS, film, track)
    with av.open(str(out)) as film:
        return [(frame.time, frame.to_ndarray(format="rgb24").mean()) for frame in film.decode(video=0)]


def test_joined_they_are_one_film(tmp_path: Path) -> None:
    segments = [segment(tmp_path, number, length, 40 + 60 * number) for number, length in enumerate(LENGTHS)]
    seen = joined(encoded(segments, tmp_path / "kept", 2), tmp_path / "film.mp4")
    shown = [
        40 + 60 * n + i * ((length + 1) // 2) // length // 2 for n, length in enumerate(LENGTHS) for i in range(length)
    ]
    assert [time for time, _ in seen] == pytest.approx([index / FPS for index in range(sum(LENGTHS))])
    assert [grey for _, grey in seen] == pytest.approx(shown, abs=2.5)


def test_a_player_can_jump_to_every_cut_and_every_four_seconds(tmp_path: Path) -> None:
    segments = [segment(tmp_path, number, length, 40) for number, length in enumerate(LENGTHS)]
    joined(encoded(segments, tmp_path / "kept"), tmp_path / "film.mp4")
    with av.open(str(tmp_path / "film.mp4")) as film:
        stops = [
            round(packet.pts * packet.time_base * FPS)
            for packet in film.demux(video=0)
            if packet.is_keyframe and packet.pts is not None
        ]
    assert {0, 30, 37} <= set(stops)
    assert max(after - before for before, after in pairwise([*stops, sum(LENGTHS)])) <= 4 * FPS


def test_only_what_is_new_is_encoded_and_what_is_gone_is_deleted(tmp_path: Path) -> None:
    kept = tmp_path / "kept"
    segments = [segment(tmp_path, number, length, 40 + 60 * number) for number, length in enumerate(LENGTHS)]
    before = encoded(segments, kept)
    for path in before:
        path.write_bytes(b"as it was")
    (kept / "killed.part").touch()
    after = encoded([segments[0], segment(tmp_path, 1, LENGTHS[1], 90), segments[2]], kept)
    assert [path.read_bytes() == b"as it was" for path in after] == [True, False, True]
    assert sorted(kept.iterdir()) == sorted(after)


def test_equal_pictures_of_equal_length_are_one_segment(tmp_path: Path) -> None:
    first = segment(tmp_path, 4, 8, 40)
    again = segment(tmp_path, 5, 8, 40)
    assert first.digest == again.digest != Segment(first.pictures, 9, SIZE, FPS).digest

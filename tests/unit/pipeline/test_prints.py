"""Prints of the frames: bounded in size, made only for new pictures, gone with their shots."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import cast

from PIL import Image
from tests.crew import RULES

from storyblender.pipeline.prints import PRINT_WIDTH, THUMBNAIL_WIDTH, make_prints
from storyblender.pipeline.run import Run
from storyblender.ports import Engine
from storyblender.project import Project
from storyblender.settings import Settings
from storyblender.trace import Event


def test_only_new_pictures_are_printed_and_no_print_is_wider_than_it_is_shown(tmp_path: Path) -> None:
    frames = {"SC010_SH010": tmp_path / "a.png", "SC010_SH020": tmp_path / "b.png"}
    for number, path in enumerate(frames.values()):
        Image.new("RGB", (2400, 1000), (90 * number, 60, 60)).save(path)
    engine = cast(Engine, SimpleNamespace(processes=2))
    told: list[Event] = []
    with Project(tmp_path / "p") as project:
        run = Run(project, engine, RULES, Settings(), told.append)
        first = make_prints(run, frames)
        for made, width in ((first.large, PRINT_WIDTH), (first.small, THUMBNAIL_WIDTH)):
            with Image.open(made["SC010_SH020"]) as picture:
                assert picture.size == (width, round(width / 2.4))
        Image.new("RGB", (320, 180), (9, 9, 90)).save(frames["SC010_SH020"])
        untouched = {path: path.stat().st_ino for path in (first.large["SC010_SH010"], first.small["SC010_SH010"])}
        assert [(event.role, event.step, event.total) for event in told] == [("prints", 1, 2), ("prints", 2, 2)]
        again = make_prints(run, frames)
        assert [(event.step, event.total) for event in told[2:]] == [(1, 1)], "only of new pictures"
        assert untouched == {path: path.stat().st_ino for path in untouched}
        with Image.open(again.small["SC010_SH020"]) as picture:
            assert picture.size == (320, 180), "a small picture stays as it is"
        left = make_prints(run, {"SC010_SH010": frames["SC010_SH010"]})
        assert left.small == {"SC010_SH010": project.folder / "thumbnails" / "SC010_SH010.jpg"}
        assert len(list((project.folder / "build" / "prints").iterdir())) == 2
        assert len(list((project.folder / "thumbnails").iterdir())) == 1

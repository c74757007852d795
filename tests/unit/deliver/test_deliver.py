"""Deliverables read back: PDF text, CSV rows, OTIO durations, film length, page content."""

from __future__ import annotations

import csv
from pathlib import Path

import av
import opentimelineio as otio
import pytest
from PIL import Image

from storyblender.deliver import animatic, board, contact_sheet, page, shot_list, slate, timeline
from storyblender.deliver.panel import panels, timecode
from storyblender.memory.graph import ContinuityMemoryGraph, ProjectFormat
from storyblender.memory.outline import SceneOutline, ScriptLine, ShotOutline, SourceSpan
from storyblender.memory.scene_context import SceneContext, SceneSetup
from storyblender.memory.shot_context import CameraInstruction, ShotContext


@pytest.fixture
def graph() -> ContinuityMemoryGraph:
    speech = ScriptLine(kind="dialogue", text="=Où est 李?", span=SourceSpan(start=9, end=20), speaker_name="Élodie")
    action = ScriptLine(kind="action", text="She waits & listens.", span=SourceSpan(start=0, end=8))
    shots = (
        ShotOutline(shot_id=1, shot_description="She waits.", lines=(action,)),
        ShotOutline(shot_id=2, shot_description="She asks.", lines=(speech,)),
    )
    outline = SceneOutline(scene_id=1, scene_description="A bar", heading="INT. BAR - NIGHT", shots=shots)
    contexts = tuple(
        ShotContext(
            scene_id=1,
            shot_id=number,
            duration=12,
            camera_instruction=CameraInstruction(size="MCU", movement="push in", lens=65, kind="single"),
        )
        for number in (1, 2)
    )
    return ContinuityMemoryGraph(
        title="Žluťoučký kůň",
        format=ProjectFormat(fps=12),
        outline=(outline,),
        scenes=(SceneContext(scene_id=1, setup=SceneSetup()),),
        shots=contexts,
    )


@pytest.fixture
def frames(tmp_path: Path) -> dict[str, Path]:
    (tmp_path / "frames").mkdir()
    paths = {name: tmp_path / "frames" / f"{name}.png" for name in ("SC010_SH010", "SC010_SH020")}
    for index, path in enumerate(paths.values()):
        Image.new("RGB", (160, 90), (200 * index, 60, 60)).save(path)
    return paths


def test_panels_are_laid_end_to_end(graph: ContinuityMemoryGraph) -> None:
    assert [(panel.name, panel.start) for panel in panels(graph)] == [("SC010_SH010", 0), ("SC010_SH020", 12)]
    assert timecode(25, 12) == "00:00:02:01"


@pytest.mark.parametrize("layout", ["grid", "single"])
def test_board_is_a_pdf_with_every_panel_and_is_reproducible(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path, layout: str
) -> None:
    board.write_board(graph, frames, tmp_path / "a.pdf", layout)  # type: ignore[arg-type]
    board.write_board(graph, frames, tmp_path / "b.pdf", layout)  # type: ignore[arg-type]
    data = (tmp_path / "a.pdf").read_bytes()
    assert data.startswith(b"%PDF") and data == (tmp_path / "b.pdf").read_bytes()
    assert data.count(b"/Type /Page\n") == (1 if layout == "grid" else 2)


def test_shot_list_rows_are_verbatim_and_inert(graph: ContinuityMemoryGraph, tmp_path: Path) -> None:
    shot_list.write_shot_list(graph, tmp_path / "shots.csv")
    rows = list(csv.DictReader((tmp_path / "shots.csv").open(encoding="utf-8-sig")))
    assert rows[0]["action"] == "She waits & listens." and rows[0]["lens_mm"] == "65"
    assert rows[1]["dialogue"] == "Élodie: =Où est 李?" and rows[1]["record_in"] == "00:00:01:00"


def test_timeline_reads_back_with_relative_media(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path
) -> None:
    timeline.write_timeline(graph, frames, tmp_path / "timeline.otio")
    read = otio.adapters.read_from_file(str(tmp_path / "timeline.otio"))
    assert read.duration().value == 24
    clips = list(read.find_clips())
    assert clips[0].media_reference.target_url == "frames/SC010_SH010.png"
    assert clips[1].markers[0].name.startswith("Élodie")


def test_animatic_has_every_frame_and_subtitles(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path
) -> None:
    clips = {"SC010_SH010": list(frames.values())}
    animatic.write_animatic(graph, clips, frames, tmp_path / "animatic.mp4")
    with av.open(str(tmp_path / "animatic.mp4")) as film:
        pictures = [frame.to_ndarray(format="rgb24").mean(axis=(0, 1)) for frame in film.decode(video=0)]
    assert len(pictures) == 24
    assert pictures[0][0] < 60 < pictures[7][0], "the second moving frame fills the second half of the shot"
    assert "00:00:01,000 --> 00:00:02,000\nÉlodie: =Où est 李?" in (tmp_path / "animatic.srt").read_text("utf-8")


def test_page_shows_words_escaped_and_names_no_network(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path
) -> None:
    page.write_page(graph, frames, tmp_path / "index.html", ["Who says <this>?"])
    text = (tmp_path / "index.html").read_text("utf-8")
    assert "She waits &amp; listens." in text and "Who says &lt;this&gt;?" in text
    assert "http" not in text.replace("http-equiv", "") and text.count("<article") == 2


def test_slate_darkens_only_the_foot_of_a_copy(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path
) -> None:
    clean = frames["SC010_SH020"]
    slate.burn_in(clean, panels(graph)[1], tmp_path / "slate.png")
    with Image.open(clean) as before, Image.open(tmp_path / "slate.png") as after:
        assert before.getpixel((5, 5)) == after.getpixel((5, 5))
        assert before.getpixel((70, 88)) != after.getpixel((70, 88))


def test_contact_sheet_holds_all(frames: dict[str, Path], tmp_path: Path) -> None:
    contact_sheet.write_contact_sheet(frames, tmp_path / "sheet.png", columns=2, width=100)
    with Image.open(tmp_path / "sheet.png") as sheet:
        assert sheet.width == 218

"""Deliverables read back: PDF text, CSV rows, OTIO durations, film length, page content."""

from __future__ import annotations

import csv
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import av
import opentimelineio as otio
import pytest
from PIL import Image
from reportlab.pdfgen.canvas import Canvas

from storyblender.deliver import animatic, board, contact_sheet, lettering, page, segments, shot_list, timeline
from storyblender.deliver.checklist import Check
from storyblender.deliver.panel import cue_of, panels, timecode
from storyblender.deliver.speech import speeches, subtitles
from storyblender.deliver.timeline_media import TimelineMedia
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.geometry import orbit
from storyblender.memory.board_layout import BoardLayout
from storyblender.memory.graph import ContinuityMemoryGraph, ProjectFormat
from storyblender.memory.outline import SceneOutline, ScriptLine, SourceSpan
from storyblender.memory.shot_context import CameraInstruction, CameraPose, CameraState, Cue
from storyblender.outputs import Outputs

START = "01:00:00:00"


def film_of(
    graph: ContinuityMemoryGraph, clips: dict[str, list[Path]], frames: dict[str, Path], folder: Path
) -> list[Path]:
    """Write film and subtitles into a folder, and return its shots."""
    files = Folder(folder)
    paths = segments.encode_segments(animatic.film_segments(graph, clips, frames), files, Outputs(files))
    animatic.write_animatic(graph, paths, folder / "animatic.mp4")
    animatic.write_subtitles(graph, folder / "animatic.srt")
    return paths


def test_panels_are_laid_end_to_end(graph: ContinuityMemoryGraph) -> None:
    assert [(panel.name, panel.start) for panel in panels(graph)] == [("SC010_SH010", 0), ("SC010_SH020", 12)]
    assert timecode(25, 12) == "00:00:02:01"


@pytest.mark.parametrize(
    ("texts", "read"),
    [
        (("He waits.", "he sings louder than all."), ("He waits.", "… he sings louder than all.")),
        (("He walks to her", "until he sees the gun."), ("He walks to her …", "… until he sees the gun.")),
        (("A sign reads OPEN", "Ilsa waits."), ("A sign reads OPEN", "Ilsa waits.")),
        (("“Go!”", "éric goes."), ("“Go!”", "… éric goes.")),
    ],
)
def test_words_under_a_picture_read_alone(
    graph: ContinuityMemoryGraph, texts: tuple[str, str], read: tuple[str, str]
) -> None:
    scene = graph.outline[0]
    lines = [ScriptLine(kind="action", text=text, span=SourceSpan(start=0, end=9)) for text in texts]
    shots = [shot.model_copy(update={"lines": (line,)}) for shot, line in zip(scene.shots, lines, strict=True)]
    apart = graph.model_copy(update={"outline": (scene.model_copy(update={"shots": tuple(shots)}),)})
    assert tuple(panel.action for panel in panels(apart)) == read


def test_clauses_in_one_picture_are_one_sentence(graph: ContinuityMemoryGraph) -> None:
    scene = graph.outline[0]
    texts = ("She turns,", "and goes.")
    lines = tuple(ScriptLine(kind="action", text=text, span=SourceSpan(start=0, end=9)) for text in texts)
    shots = (scene.shots[0].model_copy(update={"lines": lines}), scene.shots[1])
    joined = graph.model_copy(update={"outline": (scene.model_copy(update={"shots": shots}),)})
    assert panels(joined)[0].action == "She turns, and goes."


@pytest.mark.parametrize("layout", [board.USUAL, BoardLayout(panels=1)])
def test_board_is_a_pdf_with_every_panel_and_is_reproducible(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path, layout: BoardLayout
) -> None:
    board.write_board(graph, frames, tmp_path / "a.pdf", layout)
    board.write_board(graph, frames, tmp_path / "b.pdf", layout)
    data = (tmp_path / "a.pdf").read_bytes()
    assert data.startswith(b"%PDF") and data == (tmp_path / "b.pdf").read_bytes()
    assert data.count(b"/Type /Page\n") == (1 if layout.panels > 1 else 2)


def test_prints_are_bound_without_being_unpacked(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    prints = {name: path.with_suffix(".jpg") for name, path in frames.items()}
    for name, path in prints.items():
        Image.open(frames[name]).save(path)
    unpacked: list[tuple[int, int]] = []
    tobytes = Image.Image.tobytes
    monkeypatch.setattr(Image.Image, "tobytes", lambda image, *how: unpacked.append(image.size) or tobytes(image, *how))
    board.write_board(graph, prints, tmp_path / "a.pdf")
    assert (160, 90) not in unpacked
    assert (tmp_path / "a.pdf").read_bytes().count(b"/DCTDecode") == 2, "each is its own picture"


def test_shot_list_rows_are_verbatim_and_inert(graph: ContinuityMemoryGraph, tmp_path: Path) -> None:
    shot_list.write_shot_list(graph, tmp_path / "shots.csv")
    rows = list(csv.DictReader((tmp_path / "shots.csv").open(encoding="utf-8-sig")))
    assert rows[0]["action"] == "She waits & listens." and rows[0]["lens_mm"] == "65"
    assert rows[1]["dialogue"] == "Élodie: =Où est 李?" and rows[1]["record_in"] == "00:00:01:00"


def test_timeline_reads_back_with_relative_media(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path
) -> None:
    timeline.write_timeline(TimelineMedia(graph, frames, {}, tmp_path, START), tmp_path / "timeline.otio")
    read = otio.adapters.read_from_file(str(tmp_path / "timeline.otio"))
    assert read.duration().value == 24
    clips = list(read.find_clips())
    assert otio.opentime.to_timecode(read.global_start_time.rescaled_to(24)) == START
    assert clips[0].media_reference.target_url == "frames/SC010_SH010.png"
    assert clips[1].markers[0].name.startswith("Élodie")


def test_the_shot_list_describes_the_camera_as_it_became(graph: ContinuityMemoryGraph, tmp_path: Path) -> None:
    still = orbit.camera_around((0, 0, 1.5), 30, 5, 5.0, 35)
    pose = CameraPose(frame=0, pivot=still.pivot, rotation=still.rotation, distance=still.distance, lens=35)
    wanted = CameraInstruction(size="CU", kind="insert", movement="pan", order="CLOSE ON")
    changes = {"camera_instruction": wanted, "camera": CameraState(poses=(pose,))}
    shots = (graph.shots[0].model_copy(update=changes), graph.shots[1])
    shot_list.write_shot_list(graph.model_copy(update={"shots": shots}), tmp_path / "shots.csv")
    row = next(csv.DictReader((tmp_path / "shots.csv").open(encoding="utf-8-sig")))
    assert (row["size"], row["movement"]) == ("CU", "static")
    assert row["description"] == "A static insert close-up of Bar, eye-level (script: CLOSE ON)."


def test_the_shot_list_takes_the_place_from_the_graph(graph: ContinuityMemoryGraph, tmp_path: Path) -> None:
    empty = graph.shots[0].camera_instruction.model_copy(update={"focus_on_ids": (), "kind": "establishing"})
    shots = (graph.shots[0].model_copy(update={"camera_instruction": empty}), graph.shots[1])
    scene = graph.scenes[0].model_copy(update={"setup": graph.scenes[0].setup.model_copy(update={"place": "CAR"})})
    outline = (graph.outline[0].model_copy(update={"heading": "INT./EXT. CAR - DAY"}), *graph.outline[1:])
    told = graph.model_copy(update={"shots": shots, "scenes": (scene, *graph.scenes[1:]), "outline": outline})
    shot_list.write_shot_list(told, tmp_path / "shots.csv")
    row = next(csv.DictReader((tmp_path / "shots.csv").open(encoding="utf-8-sig")))
    assert " of Car, " in row["description"]


def test_every_timeline_shows_moving_pictures_where_there_are_any(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path
) -> None:
    graph = graph.model_copy(update={"title": "One\n& two \x07", "format": ProjectFormat(fps=25, width=160)})
    clips = {"SC010_SH020": film_of(graph, {}, frames, tmp_path)[1]}
    media = TimelineMedia(graph, frames, clips, tmp_path, START)
    still, shown = timeline.build_timeline(media).find_clips()
    assert still.media_reference.target_url == "frames/SC010_SH010.png"
    assert shown.media_reference.target_url == f"build/film/{clips['SC010_SH020'].name}"
    assert shown.media_references()[timeline.STILL].target_url == "frames/SC010_SH020.png"

    path = tmp_path / "timeline.fcpxml"
    timeline.write_extra(media, path, "fcpxml")
    root = ElementTree.parse(path).getroot()
    formats = {item.get("id"): item for item in root.iter("format")}
    assets = {item.get("id"): item for item in root.iter("asset")}
    sequence = next(root.iter("sequence"))
    assert [sequence.get(key) for key in ("duration", "tcStart", "tcFormat")] == ["24/25s", "3600s", "NDF"]
    made = formats[sequence.get("format")]
    assert [made.get(key) for key in ("frameDuration", "width", "height")] == ["1/25s", "160", "88"]
    picture, clip = next(root.iter("spine"))
    assert [(item.tag, item.get("offset")) for item in (picture, clip)] == [
        ("clip", "3600s"),
        ("asset-clip", "90012/25s"),
    ]
    assert assets[next(picture.iter("video")).get("ref")].get("src") == "./frames/SC010_SH010.png"
    source = assets[clip.get("ref")]
    assert formats[source.get("format")].get("height") == "90" and (tmp_path / (source.get("src") or "")).is_file()
    assert [marker.get("value") for marker in clip.iter("marker")] == ["Élodie: =Où est 李?"]
    assert next(root.iter("project")).get("name") == "One & two  "
    if "fcpx_xml" in otio.adapters.available_adapter_names():
        read = otio.adapters.read_from_file(str(path), adapter_name="fcpx_xml")
        lengths = [item.duration().to_frames() for item in read.find_clips()]
        assert lengths == [12, 12], lengths


def drawn(monkeypatch: pytest.MonkeyPatch, graph: ContinuityMemoryGraph, tmp_path: Path) -> list[str]:
    """Everything that a board says, page by page, as it is set."""
    said: list[str] = []
    set_ = board._setting
    monkeypatch.setattr(board, "_setting", lambda p, *a, **k: said.extend(text for text, _ in p) or set_(p, *a, **k))
    monkeypatch.setattr(board, "draw_way", lambda canvas, panel, way, *where: said.append(f"arrow {way}"))
    left, right = Canvas.drawString, Canvas.drawRightString
    monkeypatch.setattr(Canvas, "drawString", lambda *a: said.append(a[3]) or left(*a))
    monkeypatch.setattr(Canvas, "drawRightString", lambda *a: said.append(a[3]) or right(*a))
    board.write_board(graph, {}, tmp_path / "a.pdf")
    return said


def test_board_heads_every_scene_where_it_begins(
    graph: ContinuityMemoryGraph, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    outline = graph.outline[0]
    other = outline.model_copy(update={"scene_id": 2, "heading": "EXT. ROAD - DAY", "shots": outline.shots[:1]})
    shot = graph.shots[0].model_copy(update={"scene_id": 2})
    scenes = (*graph.scenes, graph.scenes[0].model_copy(update={"scene_id": 2}))
    graph = graph.model_copy(update={"outline": (outline, other), "scenes": scenes, "shots": (*graph.shots, shot)})
    said = drawn(monkeypatch, graph, tmp_path)
    assert said.count("INT. BAR - NIGHT") == 1 and said.index("EXT. ROAD - DAY") > said.index("SC010_SH020")


def test_board_says_where_words_were_cut(
    graph: ContinuityMemoryGraph, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert "…" not in drawn(monkeypatch, graph, tmp_path)
    outline = graph.outline[0]
    speech = outline.shots[1].lines[0]
    long = outline.shots[1].model_copy(update={"lines": (speech,) * 30})
    graph = graph.model_copy(update={"outline": (outline.model_copy(update={"shots": (outline.shots[0], long)}),)})
    assert "…" in drawn(monkeypatch, graph, tmp_path)


def test_board_sets_a_long_speech_whole_in_smaller_letters(
    graph: ContinuityMemoryGraph, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    outline = graph.outline[0]
    line = outline.shots[1].lines[0].model_copy(update={"text": "I waited for the train and it never came. " * 18})
    long = outline.shots[1].model_copy(update={"lines": (line,)})
    graph = graph.model_copy(update={"outline": (outline.model_copy(update={"shots": (outline.shots[0], long)}),)})
    assert "…" not in drawn(monkeypatch, graph, tmp_path)
    monkeypatch.setattr(board, "SHRINKING", ())
    assert "…" in drawn(monkeypatch, graph, tmp_path), "the speech must be one that does not fit at full size"


def test_notes_stand_on_board_list_and_page(
    graph: ContinuityMemoryGraph, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = graph.outline[0].shots
    noted = (first, second.model_copy(update={"notes": ("Match <scene> 3",)}))
    outline = graph.outline[0].model_copy(update={"notes": ("Real rain?",), "shots": noted})
    about = {"script_name": "bar.fountain", "edition": "Second draft, 22 Nov 2026"}
    graph = graph.model_copy(update={"outline": (outline,), **about})
    said = drawn(monkeypatch, graph, tmp_path)
    assert said.index("Real rain?") < said.index("SC010_SH020") < said.index("Match <scene> 3")
    assert "bar.fountain · Second draft, 22 Nov 2026" in said and "1 / 1" in said
    shot_list.write_shot_list(graph, tmp_path / "shots.csv")
    rows = list(csv.DictReader((tmp_path / "shots.csv").open(encoding="utf-8-sig")))
    assert [row["notes"] for row in rows] == ["Real rain?", "Match <scene> 3"]
    page.write_page(graph, {}, tmp_path / "index.html", tmp_path)
    text = (tmp_path / "index.html").read_text("utf-8")
    assert '<p class="note"><b>Note</b> Match &lt;scene&gt; 3</p>' in text and text.count("Real rain?") == 1
    assert "0:02 minutes · Second draft, 22 Nov 2026" in text


def test_a_line_that_is_too_long_ends_in_an_ellipsis_in_any_letters(
    graph: ContinuityMemoryGraph, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for word in ("夜の電車", "Night train\n", "Night train " * 10_000):
        said = drawn(monkeypatch, graph.model_copy(update={"title": word * 40}), tmp_path)
        assert said[0].startswith(word[:3]) and said[0].endswith("…")


@pytest.mark.parametrize("word", ["夜の電車", "Night train "])
def test_the_work_of_setting_words_ends_where_the_page_does(
    graph: ContinuityMemoryGraph, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, word: str
) -> None:
    measured: list[int] = []
    width = board._width
    monkeypatch.setattr(
        board, "_width", lambda canvas, text, size: measured.append(len(text)) or width(canvas, text, size)
    )
    wrapped: list[int] = []
    words_of = lettering.words_of
    monkeypatch.setattr(lettering, "words_of", lambda text, color: wrapped.append(len(text)) or words_of(text, color))
    outline = graph.outline[0]
    line = outline.shots[1].lines[0].model_copy(update={"text": word * 20_000})
    shots = (outline.shots[0], outline.shots[1].model_copy(update={"lines": (line,)}))
    outlines = (outline.model_copy(update={"shots": shots}),)
    board.write_board(graph.model_copy(update={"outline": outlines, "title": word * 20_000}), {}, tmp_path / "a.pdf")
    assert sum(measured) < 20_000, "a title is cut in a few steps, and not letter by letter"
    assert max(wrapped, default=0) <= board.MOST_LETTERS


def test_board_says_how_long_the_story_is_and_which_scene_of_the_script(
    graph: ContinuityMemoryGraph, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    outline = graph.outline[0].model_copy(update={"script_number": "12A"})
    said = drawn(monkeypatch, graph.model_copy(update={"outline": (outline,)}), tmp_path)
    assert "1 scene, 2 shots, 0:02 minutes" in said and "12A  INT. BAR - NIGHT" in said
    assert b"/Outlines" in (tmp_path / "a.pdf").read_bytes()


def test_facts_name_an_angle_that_is_not_at_eye_level(graph: ContinuityMemoryGraph) -> None:
    assert panels(graph)[0].facts == "MCU · 65 mm · push in"
    instruction = graph.shots[0].camera_instruction.model_copy(update={"angle": "low angle"})
    shots = (graph.shots[0].model_copy(update={"camera_instruction": instruction}), graph.shots[1])
    assert panels(graph.model_copy(update={"shots": shots}))[0].facts == "MCU · low angle · 65 mm · push in"


def test_facts_name_no_lens_while_the_camera_is_being_set(graph: ContinuityMemoryGraph) -> None:
    instruction = graph.shots[0].camera_instruction.model_copy(update={"lens": None})
    shot = graph.shots[0].model_copy(update={"camera": None, "camera_instruction": instruction})
    assert panels(graph.model_copy(update={"shots": (shot, graph.shots[1])}))[0].facts == "MCU · push in"


def test_the_frame_of_a_push_in_is_what_the_camera_sees_at_its_end(graph: ContinuityMemoryGraph) -> None:
    ends = tuple(
        CameraPose(frame=frame, pivot=(0, 0, 1), rotation=(1, 0, 0, 0), distance=distance, lens=lens)
        for frame, distance, lens in ((0, 4.0, 50), (11, 3.0, 75))
    )
    for poses in (ends, ends[::-1]):
        shots = (graph.shots[0].model_copy(update={"camera": CameraState(poses=poses)}), graph.shots[1])
        assert panels(graph.model_copy(update={"shots": shots}))[0].closes_to == pytest.approx(0.5)


@pytest.mark.parametrize(
    ("movement", "turned", "way"),
    [
        ("track", lambda camera: orbit.pan(camera, -0.5, 0.1), "left"),
        ("track", lambda camera: replace(camera, distance=3.0), "in"),
        ("pan", lambda camera: orbit.swivel(camera, -20), "right"),
        ("tilt", lambda camera: orbit.swivel(camera, 0, 12), "up"),
        ("pan", lambda camera: camera, None),
        ("zoom out", lambda camera: camera, "out"),
        ("static", lambda camera: camera, None),
    ],
)
def test_a_panel_says_where_its_camera_really_goes(
    graph: ContinuityMemoryGraph, movement: str, turned: Callable[[orbit.Orbit], orbit.Orbit], way: str | None
) -> None:
    first = orbit.camera_around((0, 0, 1.5), 30, 5, 5.0, 35)
    poses = tuple(
        CameraPose(frame=frame, pivot=o.pivot, rotation=o.rotation, distance=o.distance, lens=35)
        for frame, o in ((0, first), (11, turned(first)))
    )
    instruction = CameraInstruction.model_validate({"movement": movement, "direction": "down"})
    changes = {"camera": CameraState(poses=poses), "camera_instruction": instruction}
    shots = (graph.shots[0].model_copy(update=changes), graph.shots[1])
    panel = panels(graph.model_copy(update={"shots": shots}))[0]
    assert panel.way == way
    assert panel.movement == (movement if way is None or movement.endswith(way) else f"{movement} {way}")


def test_a_camera_is_called_what_it_does_and_not_what_was_wanted(graph: ContinuityMemoryGraph) -> None:
    first = orbit.camera_around((0, 0, 1.5), 30, 5, 5.0, 35)
    start, end = (
        CameraPose(frame=frame, pivot=o.pivot, rotation=o.rotation, distance=o.distance, lens=35)
        for frame, o in ((0, first), (11, orbit.swivel(first, 20)))
    )
    said: list[str] = []
    for movement, poses in (("track", (start,)), ("pan", (start,)), ("static", (start, end))):
        instruction = CameraInstruction.model_validate({"movement": movement})
        changes = {"camera": CameraState(poses=poses), "camera_instruction": instruction}
        shots = (graph.shots[0].model_copy(update=changes), graph.shots[1])
        said.append(panels(graph.model_copy(update={"shots": shots}))[0].movement)
    assert said == ["static", "static", "pan left"]


def test_the_film_is_read_in_pieces_while_mouths_move(graph: ContinuityMemoryGraph, tmp_path: Path) -> None:
    outline = graph.outline[0]
    line = outline.shots[1].lines[0].model_copy(update={"speaker": "elodie", "text": "a word " * 30})
    spoken = outline.shots[1].model_copy(update={"lines": (line, line)})
    cues = (
        Cue(asset_id="elodie", clip="whisper", start=2, duration=5),
        Cue(asset_id="elodie", clip="talk", start=6, duration=20),
        Cue(asset_id="sam", clip="talk", start=0, duration=3),
    )
    shots = (graph.shots[0], graph.shots[1].model_copy(update={"cues": cues}))
    outlines = (outline.model_copy(update={"shots": (outline.shots[0], spoken)}),)
    graph = graph.model_copy(update={"outline": outlines, "shots": shots})
    assert [(said.start, said.end) for said in speeches(panels(graph)[1])] == [(2, 6), (6, 12)]
    pieces = subtitles(panels(graph))
    assert all(len(piece.text) <= 84 for piece in pieces) and len(pieces) == 6
    assert pieces[0].start == pytest.approx(14 / 12) and pieces[-1].end == pytest.approx(2.0)
    assert all(a.end <= b.start + 1e-9 for a, b in pairwise(pieces))
    marker = list(timeline.build_timeline(TimelineMedia(graph, {}, {}, tmp_path)).find_clips())[1].markers[0]
    assert (marker.marked_range.start_time.value, marker.marked_range.duration.value) == (2, 4)


def test_subtitles_end_where_sentences_do_and_break_near_the_middle(graph: ContinuityMemoryGraph) -> None:
    outline = graph.outline[0]
    text = "Two exit papers, Rick. Keep them for an hour. You despise me, so I trust you."
    line = outline.shots[1].lines[0].model_copy(update={"text": text})
    spoken = outline.shots[1].model_copy(update={"lines": (line,)})
    graph = graph.model_copy(update={"outline": (outline.model_copy(update={"shots": (outline.shots[0], spoken)}),)})
    assert [piece.text for piece in subtitles(panels(graph))] == [
        "Élodie: Two exit papers,\nRick. Keep them for an hour.",
        "You despise me, so I trust you.",
    ]


@pytest.mark.parametrize(
    ("heading", "text", "heard"),
    [
        ("", "“The train,” she said, “stopped at Brno,” and sat.", "Élodie: The train, stopped at Brno"),
        ("", '"You are late," said Jan.', "Élodie: You are late"),
        ("", "She whispered that it was late.", "Élodie: She whispered that it was late."),
        ("INT. BAR", 'He told me "never again" and left.', 'Élodie: He told me "never again" and left.'),
    ],
)
def test_subtitles_of_prose_are_what_is_heard(
    graph: ContinuityMemoryGraph, heading: str, text: str, heard: str
) -> None:
    outline = graph.outline[0]
    line = outline.shots[1].lines[0].model_copy(update={"text": text})
    shots = (outline.shots[0], outline.shots[1].model_copy(update={"lines": (line,)}))
    told = graph.model_copy(update={"outline": (outline.model_copy(update={"shots": shots, "heading": heading}),)})
    assert " ".join(subtitles(panels(told))[0].text.split()) == heard


def test_marks_of_emphasis_are_not_shown(graph: ContinuityMemoryGraph) -> None:
    outline = graph.outline[0]
    lines = [shot.lines[0].model_copy(update={"text": "I *never* **saw** _it_ 2 * 2."}) for shot in outline.shots]
    shots = tuple(s.model_copy(update={"lines": (line,)}) for s, line in zip(outline.shots, lines, strict=True))
    marked = graph.model_copy(update={"outline": (outline.model_copy(update={"shots": shots}),)})
    first, second = panels(marked)
    assert first.action == second.dialogue[0].text == "I never saw it 2 * 2."


def test_a_cue_has_its_parenthetical(graph: ContinuityMemoryGraph) -> None:
    line = graph.outline[0].shots[1].lines[0].model_copy(update={"parenthetical": "softly", "off_screen": True})
    assert cue_of(line) == "ÉLODIE (O.S.) (softly)"


def test_animatic_has_every_frame_and_subtitles(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path
) -> None:
    clips = {"SC010_SH010": list(frames.values())}
    film_of(graph, clips, frames, tmp_path)
    with av.open(str(tmp_path / "animatic.mp4")) as film:
        pictures = [frame.to_ndarray(format="rgb24").mean(axis=(0, 1)) for frame in film.decode(video=0)]
        film.seek(0)
        words = [(packet.pts, packet.duration, bytes(packet)[2:].decode()) for packet in film.demux(subtitles=0)]
        told = film.streams.video[0].codec_context
        colors = (told.color_primaries, told.color_trc, told.colorspace, told.color_range)
    assert len(pictures) == 24
    assert colors == (1, 1, 1, 1), "Rec. 709 within the limits of television"
    assert (1000, 1000, "Élodie: =Où est 李?") in words, "the film carries its dialogue"
    assert pictures[0][0] < 60 < pictures[7][0], "the second moving frame fills the second half of the shot"
    assert "00:00:01,000 --> 00:00:02,000\nÉlodie: =Où est 李?" in (tmp_path / "animatic.srt").read_text("utf-8")


@pytest.mark.parametrize("said", ["<i>Go</i>", r"{\an8}Up", "{gone}", "2 < 3 &lt; 4", r"a\Nb"])
def test_markup_in_subtitles_is_read_as_it_is_written(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path, said: str
) -> None:
    outline = graph.outline[0]
    line = outline.shots[1].lines[0].model_copy(update={"text": said, "speaker_name": "Jo"})
    spoken = outline.shots[1].model_copy(update={"lines": (line,)})
    graph = graph.model_copy(update={"outline": (outline.model_copy(update={"shots": (outline.shots[0], spoken)}),)})
    film_of(graph, {}, frames, tmp_path)
    plain = str.maketrans({"\u2060": None, "｛": "{", "｝": "}"})
    with av.open(str(tmp_path / "animatic.mp4")) as film:
        carried = [bytes(packet)[2:].decode() for packet in film.demux(subtitles=0) if packet.size > 2]
    assert [text.translate(plain) for text in carried] == [f"Jo: {said}"]
    with av.open(str(tmp_path / "animatic.srt")) as words:  # as players read it: codes in braces, after eight fields
        read = [item for packet in words.demux() for found in packet.decode() for item in (found.ass.decode(),)]
    text = read[0].split(",", 8)[-1]
    assert "{" not in text and text.translate(plain) == f"Jo: {said}"


def test_page_shows_words_escaped_and_names_no_network(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path
) -> None:
    check = Check("SC010_SH020", "Who says <this>?", "storyblender make my.fountain")
    page.write_page(graph, frames, tmp_path / "index.html", tmp_path, [check])
    text = (tmp_path / "index.html").read_text("utf-8")
    assert "She waits &amp; listens." in text and "Who says &lt;this&gt;?" in text
    assert "1 to check" in text and 'id="check-SC010_SH020"><a href="#SC010_SH020">' in text
    assert 'href="#check"' in text and "1 scene, 2 shots, 0:02 minutes" in text and "<video" not in text
    (tmp_path / "animatic.mp4").write_bytes(b"")
    page.write_page(graph, frames, tmp_path / "index.html", tmp_path)
    film = (tmp_path / "index.html").read_text("utf-8")
    assert 'poster="frames/SC010_SH010.png"' in film and "[[1.0, 2.0, &quot;Élodie: =Où est 李?&quot;]]" in film
    assert "http" not in text.replace("http-equiv", "") and text.count("<article") == 2


def test_a_long_story_has_contact_sheets_of_a_height_that_a_jpeg_may_have(
    frames: dict[str, Path], tmp_path: Path
) -> None:
    picture = frames["SC010_SH010"]
    story = {f"SC010_SH{number:04d}": picture for number in range(1200)}
    pages = contact_sheet.sheet_pages(story)
    assert [name for shown in pages for name in shown] == list(story)
    for shown in (pages[0], pages[-1]):
        contact_sheet.write_contact_sheet(shown, tmp_path / "sheet.jpg")
        with Image.open(tmp_path / "sheet.jpg") as sheet:
            assert sheet.width == 1630 and sheet.height <= contact_sheet.TALLEST
            rows = -(-len(shown) // contact_sheet.COLUMNS)
            assert sheet.height == rows * (225 + contact_sheet.LABEL + contact_sheet.GAP) + contact_sheet.GAP
    assert len(contact_sheet.sheet_pages(frames)) == 1 and contact_sheet.sheet_pages({}) == []


def test_the_page_shows_thumbnails_until_a_picture_is_enlarged(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path
) -> None:
    small = {name: tmp_path / "thumbnails" / f"{name}.jpg" for name in frames}
    for name in ("contact_sheet.jpg", "contact_sheet_2.jpg"):
        (tmp_path / name).touch()
    page.write_page(graph, frames, tmp_path / "index.html", tmp_path, thumbnails=small)
    text = (tmp_path / "index.html").read_text("utf-8")
    assert text.count('src="thumbnails/SC010_SH020.jpg" data-frame="frames/SC010_SH020.png"') == 1
    assert (
        'Contact sheets <a href="contact_sheet.jpg"' in text
        and 'aria-label="Contact sheet 2">2</a>' in text
        and text.count('loading="lazy"') == 2
    )


def test_a_scene_without_heading_is_called_by_how_it_begins() -> None:
    scene = SceneOutline(scene_id=1, scene_description="Day. " + "She waits and waits. " * 20)
    assert scene.title.startswith("Day. She waits") and scene.title.endswith(" …") and len(scene.title) <= 90
    assert scene.model_copy(update={"heading": "INT. BAR - DAY"}).title == "INT. BAR - DAY"


def test_an_edl_has_one_reel_a_shot_and_one_line_a_marker(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path
) -> None:
    pytest.importorskip("otio_cmx3600_adapter")
    lines = graph.outline[0].shots[1].lines
    said = graph.outline[0].shots[1].model_copy(update={"lines": (lines[0].model_copy(update={"text": "One.\nTwo."}),)})
    scene = graph.outline[0].model_copy(update={"shots": (graph.outline[0].shots[0], said)})
    with pytest.raises(InputError, match="cannot count 12 frames a second"):
        timeline.write_extra(TimelineMedia(graph, frames, {}, tmp_path, START), tmp_path / "timeline.edl", "edl")
    graph = graph.model_copy(update={"outline": (scene,), "format": ProjectFormat(fps=25)})
    path = tmp_path / "timeline.edl"
    timeline.write_extra(TimelineMedia(graph, frames, {}, tmp_path, START), tmp_path / "timeline.edl", "edl")
    events = [line.split() for line in path.read_text(encoding="utf-8").splitlines() if line[:3].isdigit()]
    assert [event[1] for event in events] == ["010_010", "010_020"]
    assert [event[6] for event in events] == ["01:00:00:00", "01:00:00:12"], "the record begins where the setting says"
    assert "ONE. TWO." in path.read_text(encoding="utf-8") and "TRUNCATED" not in path.read_text(encoding="utf-8")

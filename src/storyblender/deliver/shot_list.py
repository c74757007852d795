"""The shot list as CSV, one row a shot; those that are omitted have theirs, without a place in the film."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from pathlib import Path
from string import capwords

from storyblender.deliver.panel import Panel, frame_of, panels, timecode
from storyblender.memory.camera_words import camera_sentence
from storyblender.memory.graph import ContinuityMemoryGraph

COLUMNS: tuple[str, ...] = (
    "shot", "scene", "heading", "script_scene", "size", "kind", "angle", "movement", "direction", "lens_mm",
    "f_number", "frames", "seconds", "record_in", "record_out", "characters", "action", "dialogue", "notes", "sound",
    "description", "script_start", "script_end", "status",
)  # fmt: skip

_FORMULA = tuple("=+-@＝＋－＠")


def write_shot_list(graph: ContinuityMemoryGraph, part: Path, start: str = "00:00:00:00") -> None:
    """Write the list. UTF-8 with a byte order mark, so that spreadsheets read names rightly.

    Args:
        graph: The story.
        part: The CSV file.
        start: Timecode of the first frame.
    """
    first = frame_of(start, graph.format.fps)
    names = {asset.asset_id: asset.name or asset.asset_id for asset in graph.assets}
    with part.open("w", encoding="utf-8-sig", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        for panel in panels(graph, with_omitted=True):
            shot, instruction = panel.shot, panel.shot.camera_instruction
            spans = [line.span for line in panel.outline.lines]
            row = {
                "shot": panel.name,
                "scene": shot.scene_id,
                "heading": panel.scene.heading,
                "script_scene": panel.scene.script_number,
                "size": instruction.size,
                "kind": instruction.kind,
                "angle": instruction.angle,
                "movement": panel.move,
                "direction": panel.way or "",
                "lens_mm": f"{panel.lens:.0f}",
                "f_number": f"{shot.camera.f_number:g}" if shot.camera else "",
                "frames": shot.duration,
                "seconds": f"{panel.seconds:.2f}",
                "record_in": "" if panel.omitted else timecode(first + panel.start, panel.fps),
                "record_out": "" if panel.omitted else timecode(first + panel.start + shot.duration, panel.fps),
                "characters": ", ".join(names.get(asset_id, asset_id) for asset_id in shot.shown),
                "action": panel.action,
                "dialogue": " / ".join(f"{line.speaker_name}: {line.text}" for line in panel.dialogue),
                "notes": " / ".join(panel.open_notes),
                "sound": shot.sound_effect or "",
                "description": _description(panel, names, graph.scene(shot.scene_id).setup.place),
                "script_start": min((span.start for span in spans), default=""),
                "script_end": max((span.end for span in spans), default=""),
                "status": panel.status.lower(),
            }
            writer.writerow({key: inert(value) for key, value in row.items()})


def _description(panel: Panel, names: Mapping[str, str], place: str) -> str:
    """Return the camera in a sentence, with the move that it really makes."""
    wanted = panel.shot.camera_instruction
    way = panel.way if panel.way not in ("in", "out") else None
    became = wanted.model_copy(update={"movement": panel.move, "direction": way})
    return camera_sentence(became, names, capwords(place))


def inert(value: object) -> object:
    """Quote text that a spreadsheet would run as a formula, also after blanks and in full-width characters."""
    return f"'{value}" if isinstance(value, str) and value.lstrip()[:1] in _FORMULA else value

"""``index.html``: frames, words and film on one page that needs no network and no server."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from importlib.resources import files
from pathlib import Path
from string import Template

from storyblender.deliver.panel import Panel, panels
from storyblender.memory.graph import ContinuityMemoryGraph

FILES = (
    ("story.blend", "Blender file"),
    ("board.pdf", "Board (PDF)"),
    ("shots.csv", "Shot list"),
    ("timeline.otio", "Timeline"),
    ("animatic.mp4", "Animatic"),
)


def write_page(graph: ContinuityMemoryGraph, frames: Mapping[str, Path], out: Path, report: Sequence[str] = ()) -> None:
    """Write the page.

    Args:
        graph: The story.
        frames: Shot name to picture, inside the folder of ``out``.
        out: ``index.html``.
        report: Sentences for a person to check, in order.
    """
    folder = out.parent
    shots = panels(graph)
    scenes = []
    for scene in graph.outline:
        cards = "\n".join(_card(panel, frames.get(panel.name), folder) for panel in shots if panel.scene is scene)
        heading = escape(scene.heading or scene.scene_description)
        scenes.append(f'<h2>{heading}</h2>\n<div class="grid">\n{cards}\n</div>')
    seconds = sum(shot.duration for shot in graph.shots) / graph.format.fps
    counted = f"{len(graph.outline)} scenes, {len(shots)} shots, {seconds / 60:.1f} minutes"
    summary = f"{escape(graph.story_summary)} <br>{counted}" if graph.story_summary else counted
    page = Template((files("storyblender.deliver") / "page.html").read_text(encoding="utf-8"))
    out.write_text(
        page.substitute(
            title=escape(graph.title or "Storyboard"),
            summary=summary,
            aspect=f"{graph.format.aspect:.4f}",
            files="".join(f'<a href="{name}">{label}</a>' for name, label in FILES if (folder / name).exists()),
            video=_video(folder),
            scenes="\n".join(scenes),
            report=_report(report),
        ),
        encoding="utf-8",
    )


def _video(folder: Path) -> str:
    if not (folder / "animatic.mp4").exists():
        return ""
    return '<video controls preload="metadata" src="animatic.mp4"></video>'


def _card(panel: Panel, frame: Path | None, folder: Path) -> str:
    picture = ""
    if frame is not None:
        source = escape(frame.relative_to(folder).as_posix(), quote=True)
        alt = escape(panel.outline.shot_description, quote=True)
        picture = f'<img loading="lazy" src="{source}" alt="{alt}">'
    facts = f"{panel.framing} · {panel.lens:.0f} mm · {panel.movement}"
    words = [f"<p>{escape(panel.action)}</p>"] if panel.action else []
    for line in panel.dialogue:
        words.append(f'<p class="speech"><b>{escape(line.speaker_name.upper())}</b> {escape(line.text)}</p>')
    return (
        f'<article id="{panel.name}">{picture}<div class="text">'
        f'<div class="slate"><span>{panel.name}</span><span>{panel.seconds:.1f} s</span></div>'
        f'<div class="facts">{escape(facts)}</div>{"".join(words)}</div></article>'
    )


def _report(report: Sequence[str]) -> str:
    if not report:
        return ""
    items = "".join(f"<li>{escape(sentence)}</li>" for sentence in report)
    return f'<h2>Please check</h2><ul class="flags dim">{items}</ul>'

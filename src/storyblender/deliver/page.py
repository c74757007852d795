"""``index.html``: frames, script and animatic on one page that needs neither network nor server."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from html import escape
from importlib.resources import files
from itertools import groupby
from pathlib import Path
from string import Template
from types import MappingProxyType

from storyblender.deliver.asset_list import ASSETS_FILE
from storyblender.deliver.checklist import CHECKLIST_FILE, Check
from storyblender.deliver.contact_sheet import sheets_in
from storyblender.deliver.credits import CREDITS_FILE
from storyblender.deliver.panel import Panel, length_of, panels
from storyblender.deliver.speech import subtitles
from storyblender.memory.base import scene_name
from storyblender.memory.graph import ContinuityMemoryGraph

FILES = (
    ("story.blend", "Blender file"),
    ("board.pdf", "Board (PDF)"),
    ("board_single.pdf", "Board, one shot a page (PDF)"),
    ("shots.csv", "Shot list"),
    (ASSETS_FILE, "Asset list"),
    (CHECKLIST_FILE, "Checklist"),
    ("timeline.otio", "Timeline"),
    ("animatic.mp4", "Animatic"),
    (CREDITS_FILE, "Credits"),
)

UNFOLDED = 24
"""Scenes up to which the list of scenes starts expanded."""


def write_page(
    graph: ContinuityMemoryGraph,
    frames: Mapping[str, Path],
    part: Path,
    folder: Path,
    checks: Sequence[Check] = (),
    thumbnails: Mapping[str, Path] = MappingProxyType({}),
) -> None:
    """Write the page.

    Args:
        graph: The story.
        frames: Shot name to picture, inside the folder.
        part: The file to write.
        folder: The project folder, where the page will lie; the page links to the files in it.
        checks: The checklist.
        thumbnails: Shot name to a small picture, shown until the frame is enlarged.
    """
    shots = panels(graph)
    counts = Counter(check.shot for check in checks)
    film = (folder / "animatic.mp4").exists()
    scenes, headings = [], []
    pictures = {
        name: (_source(thumbnails.get(name, path), folder), _source(path, folder)) for name, path in frames.items()
    }
    listed = panels(graph, with_omitted=True)
    for _, group in groupby(listed, key=lambda panel: panel.scene.scene_id):
        shown = list(group)
        scene = shown[0].scene
        cards = "\n".join(
            _omitted(panel) if panel.omitted else _card(panel, pictures.get(panel.name), counts[panel.name], film)
            for panel in shown
        )
        headings.append((scene_name(scene.scene_id), escape(scene.numbered_title)))
        scenes.append(f'<h2 id="{headings[-1][0]}">{headings[-1][1]}</h2>\n<div class="grid">\n{cards}\n</div>')
    counted = " · ".join(filter(None, (length_of(shots), escape(graph.edition))))
    summary = f"{escape(graph.story_summary)} <br>{counted}" if graph.story_summary else counted
    page = Template((files("storyblender.deliver") / "page.html").read_text(encoding="utf-8"))
    part.write_text(
        page.substitute(
            title=escape(graph.title or "Storyboard"),
            summary=summary,
            aspect=f"{graph.format.aspect:.4f}",
            files=_links(folder, len(checks)),
            video=_video(folder, shots, frames),
            contents=_contents(headings),
            scenes="\n".join(scenes),
            checks=_checks(checks) + _stand_ins(graph),
        ),
        encoding="utf-8",
    )


def _links(folder: Path, to_check: int) -> str:
    links = [f'<a href="{name}">{label}</a>' for name, label in FILES if (folder / name).exists()]
    sheets = sheets_in(folder)
    if len(sheets) == 1:
        links.append(f'<a href="{sheets[0]}">Contact sheet</a>')
    elif sheets:
        numbered = [
            f'<a href="{sheet}" aria-label="Contact sheet {n}">{n}</a>' for n, sheet in enumerate(sheets, start=1)
        ]
        links.append(f"<span>Contact sheets {' '.join(numbered)}</span>")
    if to_check:
        links.append(f'<a href="#check">Please check ({to_check})</a>')
    return "".join(links)


def _contents(headings: Sequence[tuple[str, str]]) -> str:
    """Return links to the scenes as HTML, collapsed where there are many; empty for a single scene."""
    links = "".join(f'<a href="#{name}">{heading}</a>' for name, heading in headings)
    shown = " open" if len(headings) <= UNFOLDED else ""
    listed = f'<nav class="links" aria-label="Scenes">{links}</nav>'
    return f"<details{shown}><summary>{len(headings)} scenes</summary>{listed}</details>" if len(headings) > 1 else ""


def _source(path: Path, folder: Path) -> str:
    return escape(path.relative_to(folder).as_posix(), quote=True)


def _video(folder: Path, shots: Sequence[Panel], frames: Mapping[str, Path]) -> str:
    """Return the video element with its subtitles inline: without a server a browser cannot load a subtitle file."""
    if not (folder / "animatic.mp4").exists():
        return ""
    cues = [[round(piece.start, 3), round(piece.end, 3), escape(piece.text, quote=False)] for piece in subtitles(shots)]
    data = escape(json.dumps(cues, ensure_ascii=False), quote=True)
    first = next((frames[panel.name] for panel in shots if panel.name in frames), None)
    poster = f' poster="{_source(first, folder)}"' if first else ""
    return f'<video controls preload="metadata" src="animatic.mp4"{poster} data-subtitles="{data}"></video>'


def _card(panel: Panel, sources: tuple[str, str] | None, to_check: int, film: bool) -> str:
    """Return one shot as an HTML card.

    Args:
        panel: The shot.
        sources: Links to its thumbnail and its frame; None without a frame.
        to_check: Number of its entries in the checklist.
        film: Whether there is an animatic; the length of the shot then becomes a button that plays it.
    """
    picture, length = "", f"{panel.seconds:.1f} s"
    if sources is not None:
        alt = escape(panel.description, quote=True)
        image = f'<img loading="lazy" decoding="async" src="{sources[0]}" data-frame="{sources[1]}" alt="{alt}">'
        picture = f'<button class="picture" aria-label="Enlarge {panel.name}">{image}</button>'
    if film:
        start = f'data-start="{panel.start / panel.fps:.3f}" data-seconds="{length}" title="Play the film from here"'
        length = f'<button class="play" {start}>{length} ▶</button>'
    words = [
        f'<p class="speech"><b>{escape(cue)}</b> {escape(text)}</p>' if cue else f"<p>{escape(text)}</p>"
        for cue, text in panel.script
    ]
    words += [f'<p class="note"><b>Note</b> {escape(note)}</p>' for note in panel.notes]
    for note in panel.shot.notes:
        words.append(f'<p class="note{" resolved" * note.resolved}"><b>Note</b> {escape(note.words)}</p>')
    if to_check:
        words.append(f'<p class="mark"><a href="#check-{panel.name}">{to_check} to check</a></p>')
    status = f' <b class="status">{panel.status}</b>' if panel.status else ""
    return (
        f'<article id="{panel.name}">{picture}<div class="text">'
        f'<div class="slate"><span>{panel.name}{status}</span><span>{length}</span></div>'
        f'<div class="facts">{escape(panel.facts)}</div>{"".join(words)}</div></article>'
    )


def _omitted(panel: Panel) -> str:
    """Return what stands for a shot that is not in the film."""
    return f'<article id="{panel.name}" class="omitted"><div class="text">{panel.name} OMITTED</div></article>'


def _checks(checks: Sequence[Check]) -> str:
    """Return the checklist as HTML, grouped by shot."""
    if not checks:
        return ""
    shots = []
    for shot, group in groupby(checks, key=lambda check: check.shot):
        items = "".join(f"<li>{escape(check.says)} <code>{escape(check.mend)}</code></li>" for check in group)
        shots.append(f'<dt id="check-{shot}"><a href="#{shot}">{shot}</a></dt><dd><ul>{items}</ul></dd>')
    return f'<h2 id="check">Please check</h2><dl class="checks">{"".join(shots)}</dl>'


def _stand_ins(graph: ContinuityMemoryGraph) -> str:
    """Return the things that something else stands in for as HTML, each with the prompt that makes it elsewhere."""
    shown = [asset for asset in graph.assets if asset.image_prompt]
    if not shown:
        return ""
    told = "Paste a prompt into a service that makes pictures or 3D models, and put the model in your folder of models."
    items = "".join(
        f"<dt>{escape(asset.name or asset.asset_id)}</dt><dd>{escape(asset.image_prompt)}</dd>" for asset in shown
    )
    return f'<h2 id="stand-ins">Stand-ins</h2><p class="dim">{told}</p><dl class="checks">{items}</dl>'

"""``credits.md``: models, surfaces, motions and panoramas from outside, with author, licence and origin."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from storyblender.memory.asset_sheet import Provenance
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.mocap import MocapClip
from storyblender.memory.shot_context import ShotContext
from storyblender.services.licences import NOT_PASSED_ON

CREDITS_FILE = "credits.md"
_COLUMNS = ("Shown as", "File", "Author", "Licence", "Copyright", "Origin", "SHA-256")
_SPECIAL = re.compile(r"([\\`*~\[\]<|]|(?<!\w)_|_(?!\w)|&(?=#?\w+;))")
"""What Markdown would read as more than a letter. One ``_`` inside a word is none, so that names of files stay legible
where the credits are read as plain text.
"""
_ADDRESS = re.compile(r"https?://[^\s<>|]+")
_NOT_SAID = "not stated"
_POLY_HAVEN = "https://polyhaven.com"


def credited_works(graph: ContinuityMemoryGraph) -> dict[Provenance, list[str]]:
    """Return every work from outside with the names of what shows it: assets as in the asset sheet, sets, the sky."""
    shown: dict[Provenance, list[str]] = {}
    for asset in graph.assets:
        if asset.canonical is not None and asset.canonical.provenance is not None:
            shown.setdefault(asset.canonical.provenance, []).append(asset.name or asset.asset_id)
    for environment in (scene.environment for scene in graph.scenes):
        textures = (environment.wall_texture, environment.ground_texture) if environment is not None else (None, None)
        for texture, name in zip(textures, ("walls", "ground"), strict=True):
            if texture is not None and name not in shown.setdefault(texture.provenance, []):
                shown[texture.provenance].append(name)
    for shot in graph.shots:
        for name, clip in _clips_in(shot):
            shown.setdefault(clip.provenance, [])
            if name not in shown[clip.provenance]:
                shown[clip.provenance].append(name)
    lit = _panoramas_seen(graph)
    for panorama in graph.panoramas:
        if panorama.provenance.digest in lit:
            shown.setdefault(panorama.provenance, []).append("light of the sky")
    return shown


def works_to_keep(graph: ContinuityMemoryGraph) -> dict[Provenance, list[str]]:
    """Return the works whose licence forbids passing on the model itself, with the names of what shows them."""
    return {work: names for work, names in credited_works(graph).items() if work.license in NOT_PASSED_ON}


def says_what_to_keep(graph: ContinuityMemoryGraph, credits_file: Path) -> bool:
    """Return whether the credits that were written before say already what must not be passed on.

    Args:
        graph: The story as it is now.
        credits_file: Which may not be there.
    """
    if not credits_file.is_file():
        return False
    return _to_keep(graph) in credits_file.read_text(encoding="utf-8", errors="replace").splitlines()


def write_credits(graph: ContinuityMemoryGraph, part: Path) -> None:
    """Write the credits as one Markdown table.

    Args:
        graph: The story.
        part: The file to write.
    """
    rows = [_COLUMNS, ("---",) * len(_COLUMNS)]
    works = credited_works(graph)
    for model, names in works.items():
        told = (", ".join(names), model.file, model.author, model.license, model.copyright, model.url)
        rows.append((*(_cell(text) for text in told), model.digest[:16]))
    moves = any(True for shot in graph.shots for _ in _clips_in(shot))
    kind = "Works" if moves or _panoramas_seen(graph) or graph.textures else "Models"
    lines = ["# Credits", "", f"{kind} in “{_cell(graph.title)}” that are not part of StoryBlender.", ""]
    part.write_text(
        "\n".join([*lines, *(f"| {' | '.join(row)} |" for row in rows), *_below(graph, works), ""]), encoding="utf-8"
    )


def _below(graph: ContinuityMemoryGraph, works: Iterable[Provenance]) -> Iterator[str]:
    """Yield the lines below the table: what must not be passed on, and what services ask to be said."""
    if to_keep := _to_keep(graph):
        yield from ("", to_keep)
    if any(work.url.startswith(f"{_POLY_HAVEN}/") for work in works):  # asked for by the terms of its API
        yield from ("", f"Powered by [Poly Haven]({_POLY_HAVEN}).")


def _to_keep(graph: ContinuityMemoryGraph) -> str:
    """Return the line that says what must not be passed on; empty if all may be."""
    told = ", ".join(_cell(name) for names in works_to_keep(graph).values() for name in names)
    return f"Not to be passed on as models, nor in story.blend or exports: {told}." if told else ""


def _clips_in(shot: ShotContext) -> Iterator[tuple[str, MocapClip]]:
    """Yield the motion clips from outside that are played in a shot, with what shows them."""
    played = {cue.mocap for cue in shot.cues}
    decided = shot.blocking_decision.people if shot.blocking_decision is not None else {}
    clips = [each.mocap for each in shot.character_actions]
    clips += [each.mocap for marks in decided.values() for each in marks.motions.values() if each is not None]
    yield from ((f"motion {clip.name}", clip) for clip in clips if clip is not None and clip.digest in played)


def _panoramas_seen(graph: ContinuityMemoryGraph) -> set[str]:
    """Return the digests of the panoramas that light a scene or a shot."""
    plans = (each.lighting for each in (*graph.scenes, *graph.shots))
    return {plan.panorama.digest for plan in plans if plan is not None and plan.panorama is not None}


def _cell(text: str) -> str:
    """Return text from outside as Markdown that shows it and does nothing else."""
    if _ADDRESS.fullmatch(text):
        return f"<{text}>"
    return _SPECIAL.sub(r"\\\1", text) or _NOT_SAID

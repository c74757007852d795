"""``credits.md``: the models and the panorama from outside in a storyboard, with author, licence and origin."""

from __future__ import annotations

import re
from pathlib import Path

from storyblender.memory.asset_sheet import Provenance
from storyblender.memory.graph import ContinuityMemoryGraph

CREDITS_FILE = "credits.md"
_COLUMNS = ("Shown as", "File", "Author", "Licence", "Copyright", "Origin", "SHA-256")
_SPECIAL = re.compile(r"([\\`*_{}\[\]<>|#&])")
_ADDRESS = re.compile(r"https?://[^\s<>|]+")
_NOT_SAID = "not stated"


def credited_works(graph: ContinuityMemoryGraph) -> dict[Provenance, list[str]]:
    """Return every work from outside with the names of what shows it: assets as in the asset sheet, then the sky."""
    shown: dict[Provenance, list[str]] = {}
    for asset in graph.assets:
        if asset.canonical is not None and asset.canonical.provenance is not None:
            shown.setdefault(asset.canonical.provenance, []).append(asset.name or asset.asset_id)
    if graph.panorama is not None and _panorama_lights(graph):
        shown.setdefault(graph.panorama.provenance, []).append("light of the sky")
    return shown


def write_credits(graph: ContinuityMemoryGraph, part: Path) -> None:
    """Write the credits as one Markdown table.

    Args:
        graph: The story.
        part: The file to write.
    """
    rows = [_COLUMNS, ("---",) * len(_COLUMNS)]
    for model, names in credited_works(graph).items():
        told = (", ".join(names), model.file, model.author, model.license, model.copyright, model.url)
        rows.append((*(_cell(text) for text in told), model.digest[:16]))
    kind = "Works" if _panorama_lights(graph) else "Models"
    lines = ["# Credits", "", f"{kind} in “{_cell(graph.title)}” that are not part of StoryBlender.", ""]
    part.write_text("\n".join([*lines, *(f"| {' | '.join(row)} |" for row in rows), ""]), encoding="utf-8")


def _panorama_lights(graph: ContinuityMemoryGraph) -> bool:
    """Return whether the light of a scene or of a shot has the panorama."""
    return any(each.lighting and each.lighting.panorama for each in (*graph.scenes, *graph.shots))


def _cell(text: str) -> str:
    """Return text from outside as Markdown that shows it and does nothing else."""
    if _ADDRESS.fullmatch(text):
        return f"<{text}>"
    return _SPECIAL.sub(r"\\\1", text) or _NOT_SAID

"""The open project as the page shows it."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from itertools import groupby
from pathlib import Path

from storyblender.deliver.checklist import to_check
from storyblender.deliver.panel import Panel, length_of, panels
from storyblender.memory.base import scene_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.picture_format import ASPECTS, SENSORS
from storyblender.proposing import ProposedStaging
from storyblender.session import Session
from storyblender.web_studio.messages import Board, PanelCard, SceneCard, StagingCard


def board_of(session: Session, stale: Collection[str], previews: Mapping[str, Path]) -> Board:
    """Return the board of a session.

    Args:
        session: Open.
        stale: Names of shots whose frames do not show the story as it is.
        previews: Pictures that stand in for these frames, by shot name.
    """
    graph, shown = session.graph, panels(session.graph, with_omitted=True)
    titles = {panel.scene.scene_id: panel.scene.numbered_title for panel in shown}
    scenes: list[SceneCard] = []
    for scene_id, group in groupby(shown, key=lambda panel: panel.scene.scene_id):
        cards = tuple(_card(session.folder, panel, stale, previews) for panel in group)
        omitted = graph.scene(scene_id).omitted
        scenes.append(SceneCard(scene=scene_name(scene_id), title=titles[scene_id], omitted=omitted, shots=cards))
    undo, redo = session.next_steps
    return Board(
        project=session.folder.name,
        title=graph.title or "Storyboard",
        revision=session.revision,
        made=session.made,
        aspect=graph.format.aspect,
        aspects=ASPECTS,
        sensor_width=graph.format.sensor_width,
        sensors=SENSORS,
        lens_kit=session.lens_kit,
        summary=length_of([panel for panel in shown if not panel.omitted]),
        scenes=tuple(scenes),
        cast=_cast(graph),
        undo=undo,
        redo=redo,
        film=_film(session.folder),
    )


def _card(folder: Path, panel: Panel, stale: Collection[str], previews: Mapping[str, Path]) -> PanelCard:
    frame, preview = folder / "frames" / f"{panel.name}.png", previews.get(panel.name)
    state, picture = "fresh", frame
    if panel.name in stale and not panel.omitted:
        state, picture = ("preview", preview) if preview is not None else ("stale", frame)
    if not picture.is_file():
        state, address = "none", ""
    elif state == "preview":
        address = f"/previews/{panel.name}.png?v={picture.stem}"
    else:
        address = f"/frames/{panel.name}.png?v={picture.stat().st_mtime_ns}"
    return PanelCard(
        shot=panel.name,
        scene=scene_name(panel.scene.scene_id),
        facts=panel.facts,
        seconds=round(panel.seconds, 2),
        words=panel.action,
        script=panel.script,
        picture=address,
        state=state,
        omitted=panel.omitted,
        approved=panel.shot.approved is not None,
        notes=sum(not note.resolved for note in panel.shot.notes),
        locked=bool(panel.shot.locked),
        takes=len(panel.shot.takes) + 1,
        problems=len(to_check(panel.shot, {})),
    )


def _cast(graph: ContinuityMemoryGraph) -> dict[str, str]:
    people = [asset for asset in graph.assets if asset.asset_type == "character" and asset.origin != "dressing"]
    return {person.asset_id: person.name or person.asset_id for person in people}


def _film(folder: Path) -> str:
    film = folder / "animatic.mp4"
    return f"/files/{film.name}?v={film.stat().st_mtime_ns}" if film.exists() else ""


def staging_cards(found: Sequence[ProposedStaging], shot: str) -> tuple[list[StagingCard], dict[str, Path]]:
    """Return stagings as the page shows them, and their pictures by the name in their address.

    Args:
        found: With previews.
        shot: The shot that is shown.
    """
    pictures = {f"{shot}-staging-{each.number}": each.pictures[shot] for each in found}
    cards = [
        StagingCard(number=each.number, picture=f"/takes/{name}.png?v={path.stem}", moved=each.words)
        for each, (name, path) in zip(found, pictures.items(), strict=True)
    ]
    return cards, pictures

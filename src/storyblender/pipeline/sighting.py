"""What every camera of a scene sees at the shot's story moment, and where the people are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from storyblender.agents.frame_critic.frame_view import things_to_see
from storyblender.agents.layout_artist.camera_operator_view import pose_of
from storyblender.agents.layout_artist.story_moment import board_frame
from storyblender.geometry.camera_path import camera_at
from storyblender.geometry.framing import Figure, Film
from storyblender.memory.base import Frozen, shot_name
from storyblender.memory.coverage import filmed
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import PackRef, PlayedCue
from storyblender.memory.measure import CameraView, ViewRequest
from storyblender.memory.shot_context import ShotContext
from storyblender.ports import Engine


class ShotSight(Frozen):
    """What a shot's camera sees at its story moment, and where the people are."""

    view: CameraView
    figures: tuple[Figure, ...]


class Sighting:
    """A pending request for what the cameras of a scene see.

    Args:
        graph: The story; shots without a camera are left out.
        engine: The engine that looks through the cameras.
        pack: The scene pack.
        only: Ids of the shots to look at; None for all.
    """

    def __init__(
        self, graph: ContinuityMemoryGraph, engine: Engine, pack: PackRef, only: set[int] | None = None
    ) -> None:
        shots = [filmed(graph, shot) for shot in graph.shots_of(pack.scene_id) if shot.camera and not shot.joined]
        shots = [shot for shot in shots if only is None or shot.shot_id in only]
        nodes = nodes_of(graph, pack.scene_id)
        requests = [_request(shot, graph.format.aspect, nodes, pack.played(shot.shot_id)) for shot in shots]
        frames = [pack.start_of(request.shot_id) + request.frame for request in requests]
        self._names = [shot_name(shot.scene_id, shot.shot_id) for shot in shots]
        self._views = engine.look(pack, requests, graph.format.aspect)
        self._figures = engine.read_figures(pack, frames)

    def seen(self) -> dict[str, ShotSight]:
        """Return the sight of every shot by name."""
        answers = zip(self._names, self._views.result(), self._figures.result(), strict=True)
        return {name: ShotSight(view=view, figures=tuple(faces)) for name, view, faces in answers}


def nodes_of(graph: ContinuityMemoryGraph, scene_id: int) -> dict[str, tuple[str, ...]]:
    """Return the node_ids that show each asset of a scene, by asset_id; an asset outside the layout is its own node.

    Args:
        graph: The story.
        scene_id: The scene; one without a layout has no nodes.
    """
    nodes: dict[str, tuple[str, ...]] = {}
    layout = next((scene.layout for scene in graph.scenes if scene.scene_id == scene_id), None)
    for item in layout.objects if layout is not None else ():
        nodes[item.asset_id] = (*nodes.get(item.asset_id, (item.asset_id,)), item.node_id)
    return {asset_id: tuple(dict.fromkeys(shown)) for asset_id, shown in nodes.items()}


def _request(
    shot: ShotContext, aspect: float, nodes: Mapping[str, tuple[str, ...]], played: Sequence[PlayedCue]
) -> ViewRequest:
    assert shot.camera is not None, "only shots with a camera are looked at"
    frame, film = board_frame(shot, played), Film(shot.camera.sensor_width, aspect)
    return ViewRequest(
        scene_id=shot.scene_id,
        shot_id=shot.shot_id,
        frame=frame,
        pose=pose_of(camera_at(shot.camera, frame, film), frame),
        sensor_width=shot.camera.sensor_width,
        hidden_node_ids=shot.camera.hidden_node_ids,
        focus_ids=shot.camera_instruction.focus_on_ids,
        other_ids=tuple(node for thing in things_to_see(shot) for node in nodes.get(thing, (thing,))),
    )

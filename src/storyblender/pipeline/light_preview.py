"""Small pictures of a scene in a light that is only proposed, for a critic who looks; drawn when that critic asks.

Nothing of it is in vain: the pack is the one that is filmed later. Cameras that are not set yet are the rules' own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property

from storyblender.agents.layout_artist.camera_scene import shoot_scene
from storyblender.agents.layout_artist.spatial_planner_view import measures_of
from storyblender.agents.layout_artist.story_moment import board_frame
from storyblender.agents.visual_effects_artist.decided import decided_light
from storyblender.agents.visual_effects_artist.lamp_states import light_shots
from storyblender.agents.visual_effects_artist.lighting_arranger import RulesLightingArranger
from storyblender.agents.visual_effects_artist.lighting_arranger_view import (
    LightingArrangerView,
    lighting_arranger_view,
)
from storyblender.catalog.sets import plan_of
from storyblender.errors import EngineError, NoAnswer
from storyblender.memory.base import shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.jobs import FrameJob, PackRef
from storyblender.memory.request import Picture
from storyblender.memory.scene_context import Lighting, SceneContext
from storyblender.memory.shot_context import CameraState, ShotContext
from storyblender.memory.shot_sizes import SHOT_SIZES
from storyblender.memory.thing_states import Condition
from storyblender.pipeline.filming import PackViewfinder
from storyblender.pipeline.hand_motions import with_hand_motions
from storyblender.pipeline.packing import pack_scene, scene_job
from storyblender.pipeline.run import Run

PREVIEWS = "build/light"
"""Folder of the pictures."""
_WIDTH = 480
"""Pixels."""
_CLOSEST = SHOT_SIZES.index("CU")
"""Sizes tighter than this show no more of the light."""


class LightPreview:
    """Draws some shots of a scene in a proposed light.

    Args:
        run: With the scene laid out.
        scene: As it is to be committed.
        shots: Of the scene, with their motion.
    """

    def __init__(self, run: Run, scene: SceneContext, shots: Sequence[ShotContext]) -> None:
        self._run, self._scene, self._shots = run, scene, tuple(shots)
        self._cameras: dict[int, CameraState] = {}

    def draw_opening(self, usual: Lighting) -> tuple[Picture, ...]:
        """Return pictures of the first shot, and of the closest one with people before the script changes the light.

        Args:
            usual: The plan of the scene if nothing is switched.

        Raises:
            NoAnswer: The engine fails.
        """
        plans = self._plans(usual, lambda current, shot: current)
        return tuple(self._draw(shot, plans[shot.shot_id]) for shot in _opening_shots(self._shots))

    def draw_change(self, changed: ShotContext, before: Lighting, after: Lighting) -> tuple[Picture, ...]:
        """Return two pictures of a shot: ``before`` the script changes the light in it, and as it is then.

        Args:
            changed: The shot.
            before: The plan before it.
            after: The plan from it on.

        Raises:
            NoAnswer: The engine fails.
        """
        plans = self._plans(before, lambda current, shot: after if shot.shot_id == changed.shot_id else current)
        earlier = self._draw(changed, decided_light(before, self._scene.light_decision))
        return earlier.model_copy(update={"name": "before"}), self._draw(changed, plans[changed.shot_id])

    def _plans(self, usual: Lighting, change: Callable[[Lighting, ShotContext], Lighting]) -> Mapping[int, Lighting]:
        """Return the light of every shot by shot id, with the lamps that burn in it and what a person decided."""
        plan, lit, _ = self._lit(usual, change)
        plans: dict[int, Lighting] = {}
        for shot in lit:
            plan = shot.lighting or plan
            plans[shot.shot_id] = decided_light(plan, self._scene.light_decision)
        return plans

    def _lit(
        self, usual: Lighting, change: Callable[[Lighting, ShotContext], Lighting]
    ) -> tuple[Lighting, tuple[ShotContext, ...], dict[str, Condition]]:
        return light_shots(usual, self._view, self._shots, self._scene.setup.found, change)

    @cached_property
    def _view(self) -> LightingArrangerView:
        return lighting_arranger_view(self._run.graph, self._scene.scene_id)

    @cached_property
    def _packed(self) -> tuple[ContinuityMemoryGraph, PackRef]:
        """The story with the scene as it is going to be filmed, and its pack."""
        usual = RulesLightingArranger().propose(self._view)  # what lamps do to the set is the script's, not the plan's
        _, lit, found = self._lit(usual, lambda current, shot: current)
        scene = self._scene.model_copy(update={"setup": self._scene.setup.model_copy(update={"found": found})})
        job = scene_job(replace(self._run.graph, scene, *lit), scene.scene_id)
        pack = pack_scene(self._run, with_hand_motions(self._run, job))
        framed = (
            shot.model_copy(update={"frame": board_frame(shot, pack.played(shot.shot_id)), "joined": False})
            for shot in lit
        )
        return replace(self._run.graph, scene, *framed), pack

    def _draw(self, shot: ShotContext, plan: Lighting) -> Picture:
        """Return a picture of a shot in a light. Raises NoAnswer."""
        name = shot_name(shot.scene_id, shot.shot_id)
        try:
            graph, pack = self._packed
            job = FrameJob(
                pack=pack,
                shot=self._with_camera(graph, pack, shot.shot_id),
                lighting=plan,
                format=graph.format.model_copy(update={"width": min(_WIDTH, graph.format.width)}),
                look=self._run.settings.look,
                frame=graph.shot(shot.scene_id, shot.shot_id).frame or 0,
                out="",
            )
            out = f"{PREVIEWS}/{job.digest}.png"
            if not self._run.outputs.whole(out):
                self._run.engine.render_frame(job.model_copy(update={"out": out})).result()
                self._run.outputs.note(out)
        except EngineError as error:
            raise NoAnswer(f"{name} cannot be drawn: {error}") from error
        return Picture(name=f"shot_{shot.shot_id}", png=self._run.project.path(out).read_bytes(), drawn_from=job.digest)

    def _with_camera(self, graph: ContinuityMemoryGraph, pack: PackRef, shot_id: int) -> ShotContext:
        """Return a shot with its camera and no face lights; where no camera is set, with the one that rules set."""
        shot = graph.shot(pack.scene_id, shot_id)
        if shot_id not in self._cameras:
            environment = self._scene.environment
            assert environment is not None, "the set comes before its light"
            viewfinder = PackViewfinder(self._run, pack, (shot,))
            self._cameras |= shoot_scene(
                graph.model_copy(update={"shots": (shot,)}),
                pack.scene_id,
                plan_of(environment),
                measures_of(graph.assets),
                viewfinder.moments,
                viewfinder,
                kit=self._run.settings.lens_kit,
            )
        return shot.model_copy(update={"camera": self._cameras[shot_id], "lights": ()})


def _opening_shots(shots: Sequence[ShotContext]) -> list[ShotContext]:
    """Return the first shot and the closest one with people, of those before the script changes the light."""
    changes = next((number for number, shot in enumerate(shots) if shot.light_change is not None), len(shots))
    usual = shots[: max(changes, 1)]
    faces = [shot for shot in usual if shot.in_frame and shot.camera_instruction.kind != "insert"]
    closest = max(faces, key=lambda shot: min(SHOT_SIZES.index(shot.camera_instruction.size), _CLOSEST), default=None)
    return [usual[0]] if closest is None or closest is usual[0] else [usual[0], closest]

"""The Animator without a model: marks, walks and cues of everybody in every shot of a scene.

The end marks of a shot are the start marks of the next one, unless the script changes a state in between.
"""

from __future__ import annotations

from collections.abc import Mapping

from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.agents.visual_effects_artist.marks_by_hand import set_marks
from storyblender.agents.visual_effects_artist.poses_by_hand import with_poses
from storyblender.agents.visual_effects_artist.rehearsal import Rehearsal, ShotDirections, ShotStaging
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets import plan_of
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Frozen, Identifier
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import SceneOutline
from storyblender.memory.scene_context import Layout
from storyblender.memory.shot_context import Mark, ShotContext
from storyblender.memory.thing_states import Condition
from storyblender.reflection import Critique

__all__ = ["AnimatorDraft", "AnimatorView", "RulesAnimator", "ShotStaging"]


class AnimatorView(Frozen):
    """The Animator's projection of the graph: one scene, laid out, its assets measured."""

    scene_id: int
    layout: Layout
    plan: SetPlan
    assets: tuple[Asset, ...]
    """Everything in the scene, with ``canonical`` sizes and anchors."""
    shots: tuple[ShotContext, ...]
    """In order."""
    outline: SceneOutline | None = None
    """For the words of the speeches."""
    fps: int = 24
    found: dict[Identifier, Condition] = {}
    """States in which things are as the scene opens."""


def animator_view(graph: ContinuityMemoryGraph, scene_id: int) -> AnimatorView:
    """Return the Animator's projection of the graph.

    Args:
        graph: With the scene's set and layout.
        scene_id: Of the scene.
    """
    scene = graph.scene(scene_id)
    assert scene.layout is not None and scene.environment is not None, "set and layout come before motion"
    return AnimatorView(
        scene_id=scene_id,
        layout=scene.layout,
        plan=plan_of(scene.environment),
        assets=graph.assets_of(scene_id),
        shots=with_poses(graph.staged_shots_of(scene_id)),
        outline=graph.outline_of(scene_id),
        fps=graph.format.fps,
        found=scene.setup.found,
    )


class AnimatorDraft(Frozen):
    """The staging of all shots of a scene, in order."""

    shots: tuple[ShotStaging, ...]


class RulesAnimator:
    """The Animator without a model."""

    def propose(self, view: AnimatorView) -> AnimatorDraft:
        """Stage every shot of the scene in order."""
        return self.stage(view)

    def stage(self, view: AnimatorView, directions: Mapping[int, ShotDirections] = {}) -> AnimatorDraft:
        """Stage every shot of the scene in order.

        Args:
            view: The scene.
            directions: Marks, goals of walks and overlaps that are asked for, by shot id.
        """
        floor = Floor(view.layout, view.assets, view.plan)
        rehearsal = Rehearsal(floor, view.assets, view.layout.objects, view.fps, view.found)
        rehearsal.stage.find_instrument_players(view.shots)
        rehearsal.stage.hide_props_brought_along(view.shots)
        lines = {shot.shot_id: shot.lines for shot in view.outline.shots} if view.outline else {}
        stagings: list[ShotStaging] = []
        for index, shot in enumerate(view.shots):
            if "blocking" in shot.locked:
                rehearsal.keep_locked_blocking(shot)
                stagings.append(
                    ShotStaging(
                        shot_id=shot.shot_id,
                        blocking=shot.blocking,
                        cues=shot.cues,
                        prop_states=shot.prop_states,
                        duration=shot.duration,
                    )
                )
                continue
            stay = view.shots[index + 1].on_stage if index + 1 < len(view.shots) else shot.on_stage
            asked = directions.get(shot.shot_id, ShotDirections())
            stagings.append(rehearsal.play(shot, lines.get(shot.shot_id, ()), stay, asked))
        return AnimatorDraft(shots=tuple(stagings))

    def refine(self, draft: AnimatorDraft, critique: Critique, view: AnimatorView) -> AnimatorDraft:
        """Return the draft with every mark that the critic names moved to its fix, in all shots that use it.

        Args:
            draft: The staging.
            critique: Its faults, with ``x``, ``y``, ``to_x`` and ``to_y`` as fixes.
            view: The scene.
        """
        moves: dict[tuple[str, float, float], tuple[float, float]] = {}
        decided = {mark for shot in view.shots for mark in set_marks(shot)}
        for fault in critique.faults:
            if {"x", "y", "to_x", "to_y"} <= set(fault.fix):
                x, y, to_x, to_y = (float(fault.fix[key]) for key in ("x", "y", "to_x", "to_y"))
                if (fault.subject, x, y) not in decided:
                    moves[fault.subject, x, y] = (to_x, to_y)

        def moved(mark: Mark) -> Mark:
            goal = moves.get((mark.asset_id, mark.location[0], mark.location[1]))
            return mark if goal is None else mark.model_copy(update={"location": (*goal, mark.location[2])})

        shots = []
        for shot in draft.shots:
            blocking = tuple(
                each.model_copy(update={"start": moved(each.start), "end": moved(each.end)}) for each in shot.blocking
            )
            cues = tuple(
                cue if cue.mark is None else cue.model_copy(update={"mark": moved(cue.mark)}) for cue in shot.cues
            )
            shots.append(shot.model_copy(update={"blocking": blocking, "cues": cues}))
        return AnimatorDraft(shots=tuple(shots))

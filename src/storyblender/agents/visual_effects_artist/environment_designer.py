"""The Environment Designer: the kit and options of a scene become a set, large enough for the scene."""

from __future__ import annotations

import math
from dataclasses import dataclass

from storyblender.catalog.registry import ParamValue
from storyblender.catalog.sets import SETS, SetKit, plan_of
from storyblender.catalog.sets.period import period_of
from storyblender.memory.base import Vec2, content_hash
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.outline import SceneOutline
from storyblender.memory.scene_context import Environment, SceneSetup
from storyblender.memory.vocabulary import Age
from storyblender.reflection import Critique, Fault

_CROWD = 3
"""People for whom a kit has room at its usual size."""
_ROOM_FOR_ONE = 1.6
"""Square metres for each further person."""
_SPARE = 3.0
"""Square metres of the script's own things for which a kit's usual size has room."""
_BESIDE, _SHARE_BESIDE = 3.0, 0.6
"""Metres of width beside the longest thing; at most this share of a small kit's usual width."""
_ROOM_TO_WALK = 2.2
"""Metres beyond the longest walk of a shot."""


@dataclass(frozen=True)
class EnvironmentDesignerView:
    """What the Environment Designer sees of a scene.

    Attributes:
        setup: The place, with its kit and options.
        footprints: Width and depth in metres of the scene's own objects.
        people: Number of people on stage at once.
        travel: Metres of the longest walk in one shot.
        reference: Environment of the earlier scene in the same place; None if there is none.
        age: Age of the story; None if its words do not tell it.
        outline: The words of the scene, which only a language model reads.
    """

    setup: SceneSetup
    footprints: tuple[Vec2, ...] = ()
    people: int = 2
    travel: float = 0.0
    reference: Environment | None = None
    age: Age | None = None
    outline: SceneOutline | None = None


def environment_designer_view(graph: ContinuityMemoryGraph, scene_id: int) -> EnvironmentDesignerView:
    """Return the Environment Designer's projection of the graph.

    Args:
        graph: The graph, with the Director's plan and the script's own assets.
        scene_id: Number of the scene.
    """
    scene = graph.scene(scene_id)
    reference = scene.setup.reference_scene_id
    things = graph.own_objects_of(scene_id)
    walks = (action.distance or 0.0 for shot in graph.shots_of(scene_id) for action in shot.character_actions)
    return EnvironmentDesignerView(
        setup=scene.decided_setup,
        footprints=tuple(asset.canonical.dimensions[:2] for asset in things if asset.canonical is not None),
        people=graph.people_in(scene_id),
        travel=max(walks, default=0.0),
        reference=graph.scene(reference).environment if reference is not None else None,
        age=graph.age,
        outline=graph.outline_of(scene_id),
    )


class RulesEnvironmentDesigner:
    """Furnishes the kit for the age of the story; chooses its size by what must fit."""

    def propose(self, view: EnvironmentDesignerView) -> Environment:
        """Return the environment of a scene; the same place as before gets the same one, with or without snow."""
        setup = view.setup
        ground: dict[str, ParamValue] = {"snow": True} if setup.snow else {}
        if view.reference is not None:
            params = {name: value for name, value in view.reference.params.items() if name != "snow"} | ground
            return view.reference.model_copy(update={"params": params})
        kit = SETS[setup.kit]
        period = period_of(kit, view.age)
        params: dict[str, ParamValue] = {"width": kit.width.usual, "depth": kit.depth.usual}
        if period != kit.period:
            params["period"] = period
        params |= dict.fromkeys(setup.set_options, True) | ground
        seed = int(content_hash(setup.place.upper(), kit.key), 16) % 100_000
        return with_size(Environment(kit=kit.key, params=params, seed=seed), *needed_size(view, kit))

    def refine(self, draft: Environment, critique: Critique, view: EnvironmentDesignerView) -> Environment:
        """Return the environment at the size that the critic computed.

        Args:
            draft: The environment.
            critique: Its faults, with ``width`` and ``depth`` in metres as fixes.
            view: The scene.
        """
        for fault in critique.faults:
            if "width" in fault.fix:
                draft = with_size(draft, float(fault.fix["width"]), float(fault.fix["depth"]))
        return draft


class EnvironmentDesignerCritic:
    """Checks that everything fits into the set, and that it is indoors or outdoors as the scene is."""

    def judge(self, draft: Environment, view: EnvironmentDesignerView) -> Critique:
        """Return the critique of an environment: too small, indoors instead of outdoors, or too short for an object.

        Args:
            draft: The environment.
            view: The scene.
        """
        plan, faults = plan_of(draft), []
        if plan.indoor != (view.setup.scene_type == "indoor"):
            faults.append(
                Fault(kind="wrong_sort", message=f"{draft.kit} does not suit {view.setup.scene_type}", severity=4.0)
            )
        width, depth = plan.size.x - plan.size.x_negative, plan.size.y - plan.size.y_negative
        kit = SETS[draft.kit]
        want_width, want_depth = needed_size(view, kit)
        if width < kit.width.clamp(want_width) - 0.05 or depth < kit.depth.clamp(want_depth) - 0.05:
            message = f"the set is {width:.1f} x {depth:.1f} m; the scene wants {want_width:.1f} x {want_depth:.1f} m"
            fix: dict[str, float | str] = {"width": want_width, "depth": want_depth}
            faults.append(Fault(kind="too_small", message=message, severity=3.0, fix=fix))
        longest = max((max(size) for size in view.footprints), default=0.0)
        if longest + 1.5 > max(width, depth):
            message = f"an object is {longest:.1f} m long, the set {max(width, depth):.1f} m"
            faults.append(Fault(kind="does_not_fit", message=message, severity=1.5))
        return Critique.of(tuple(faults))


def needed_size(view: EnvironmentDesignerView, kit: SetKit) -> Vec2:
    """Return the width and depth in metres that the people, things and walks of a scene need in a kit.

    Args:
        view: The scene.
        kit: The kit, for its usual size; the result may be beyond its limits.
    """
    usual = kit.width.usual * kit.depth.usual
    extra = _ROOM_FOR_ONE * max(0, view.people - _CROWD)
    extra += max(0.0, 1.5 * sum(width * depth for width, depth in view.footprints) - _SPARE)
    scale = math.sqrt(1.0 + extra / usual)
    longest = max((max(size) for size in view.footprints), default=0.0)
    beside = min(_BESIDE, _SHARE_BESIDE * kit.width.usual)
    width = max(kit.width.usual * scale, view.travel + _ROOM_TO_WALK, longest + beside)
    return round(width, 1), round(kit.depth.usual * scale, 1)


def with_size(environment: Environment, width: float, depth: float) -> Environment:
    """Return an environment at a width and depth in metres, within the limits of its kit."""
    kit = SETS[environment.kit]
    size: dict[str, ParamValue] = {"width": kit.width.clamp(width), "depth": kit.depth.clamp(depth)}
    return environment.model_copy(update={"params": environment.params | size})

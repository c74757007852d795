"""Changes in a story's .blend become edits, through the one dispatcher; what cannot is told."""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import prop_of
from storyblender.edits.added_lamps import lamp_edit, looking
from storyblender.edits.blend_change import BlendChange
from storyblender.edits.conflicts import refuse_stale
from storyblender.edits.effect import with_effects
from storyblender.edits.families import effects_of
from storyblender.edits.pull_conflicts import PullConflict, conflict_of
from storyblender.errors import InputError, StaleEdit
from storyblender.memory.base import Frozen, scene_name
from storyblender.memory.blend_values import BlendValues, NodeValues, PoseValues
from storyblender.memory.camera_decision import CameraDecision, CameraPosition, FreeCamera
from storyblender.memory.edits import AssetEdit, CameraEdit, DurationEdit, Edit, LightEdit, PlaceEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import LayoutObject, Light
from storyblender.memory.scene_decision import LampDecision, LightDecision, ThingPlace
from storyblender.project import Project


class PulledEdits(Frozen):
    """What becomes of the changes in a file."""

    edits: tuple[Edit, ...]
    """In order; all of them together are one undo."""
    understood: tuple[str, ...]
    """The changes that they make, in words."""
    conflicts: tuple[PullConflict, ...]
    """Changes of what was also changed in the project since the file was compiled; none of them is made."""
    kept: tuple[str, ...]
    """Changes that no edit can express, or that cannot be; they stay in a copy of the file."""


def edits_of(project: Project, changes: Sequence[BlendChange], compiled: BlendValues) -> PulledEdits:
    """Return the edits that make the changes of a file, each tried on the story as those before it leave it.

    Args:
        project: Open.
        changes: Of the file.
        compiled: The file as it was written.
    """
    graph, edits = project.graph, list[Edit]()
    told: dict[str, list[str]] = {"understood": [], "kept": []}
    conflicts = list[PullConflict]()
    for change in _merged(changes):
        wanted = list[Edit]()
        try:
            wanted = _edits(project.graph, change, compiled)
            if not wanted:
                told["kept"].append(change.words)
                continue
            after = graph
            for edit in wanted:
                done = effects_of(after, edit)
                refuse_stale(
                    project, compiled.version, {(each.name, aspect) for each in done for aspect in each.aspects}
                )
                after = with_effects(after, done)
        except StaleEdit as error:
            conflicts.append(conflict_of(change, wanted, error.changes))
        except InputError as error:
            told["kept"].append(f"{change.words}: {error.problem}")
        else:
            graph = after
            edits += wanted
            told["understood"].append(change.words)
    return PulledEdits(
        edits=tuple(edits), conflicts=tuple(conflicts), **{name: tuple(words) for name, words in told.items()}
    )


def _merged(changes: Sequence[BlendChange]) -> list[BlendChange]:
    """Return the changes with those of one object's place and size as one, because one edit makes them."""
    found: dict[object, BlendChange] = {}
    for number, change in enumerate(changes):
        placed = change.kind in ("moved", "turned", "scaled", "lamp")
        key = (change.scene, change.subject) if placed else number
        before = found.get(key)
        words = f"{before.words}, {change.words.partition(' ')[2]}" if before else change.words
        found[key] = change.model_copy(update={"words": words})
    return list(found.values())


def _edits(graph: ContinuityMemoryGraph, change: BlendChange, compiled: BlendValues) -> list[Edit]:
    """Return the edits that make a change; none where nothing can."""
    before, after = change.before, change.after
    if change.edits:
        return list(change.edits)
    match change.kind:
        case "moved" | "turned" | "scaled" if before is not None and after is not None and before.kind == "prop":
            return _placed(graph, change.scene, before, after)
        case "moved" | "turned" | "lamp" if before is not None and after is not None and before.kind == "light":
            return _lit(graph, change.scene, before, after)
        case "added" if after is not None and after.lamp is not None:
            scene = next(each for each in compiled.scenes if each.name == change.scene)
            return [lamp_edit(graph, change, after, scene)]
        case "deleted" if before is not None and before.kind == "prop":
            return [AssetEdit(action="remove", thing=before.node_id, scene=change.scene)]
        case "deleted" if before is not None and _lamp(graph, change.scene, before.node_id) is not None:
            return [LightEdit(scene=change.scene, decision=LightDecision(lamps={before.node_id: None}))]
        case "duplicated" if before is not None and after is not None and before.kind == "prop":
            return _copied(graph, change.scene, before, after)
        case "renamed" if before is not None and after is not None and before.kind in ("prop", "character"):
            return _renamed(graph, change.scene, before, after)
        case "camera" | "lens" if after is not None:
            return _filmed(change.subject, after, lens_only=change.kind == "lens")
        case "aperture" if after is not None and after.camera is not None:
            f_number = after.camera.f_number if after.camera.blurs else 32.0
            return [CameraEdit(shot=change.subject, decision=CameraDecision(f_number=f_number))]
        case "marker":
            return [DurationEdit(shot=shot, frames=frames) for shot, frames in change.lengths.items()]
    return []


def _placed(graph: ContinuityMemoryGraph, scene: str, before: NodeValues, after: NodeValues) -> list[Edit]:
    """Return the edit that puts a thing where it is in the file; none for one that is tilted, or squeezed."""
    item = _laid_out(graph, scene, before.node_id)
    factors = {round(now / was, 3) for was, now in zip(before.scale, after.scale, strict=True) if was}
    tilted = any(abs(a - b) > 0.01 for a, b in zip(before.rotation[:2], after.rotation[:2], strict=True))
    if item is None or tilted or len(factors) != 1:
        return []
    [factor] = factors
    moved = [now - was for was, now in zip(before.location, after.location, strict=True)]
    turned = (after.rotation[2] - before.rotation[2]) % 360.0
    place = ThingPlace()
    if any(abs(each) > 1e-6 for each in moved):
        x, y, z = (round(at + by, 4) for at, by in zip(item.location, moved, strict=True))
        place = place.model_copy(update={"location": (x, y), "height": z})
    if min(turned, 360.0 - turned) > 1e-3:
        place = place.model_copy(update={"rotation": round((item.rotation[2] + turned) % 360.0, 3)})
    scale = factor if factor != 1.0 else None
    return [PlaceEdit(scene=scene, thing=before.node_id, place=place, scale=scale)]


def _copied(graph: ContinuityMemoryGraph, scene: str, before: NodeValues, after: NodeValues) -> list[Edit]:
    """Return the edit that adds one more of a thing of the library where its copy stands."""
    item, prop = _laid_out(graph, scene, before.node_id), prop_of(graph.asset(before.asset_id))
    if item is None or prop not in PROPS or before.scale != after.scale:
        return []
    x, y, z = (round(a + c - b, 4) for a, b, c in zip(item.location, before.location, after.location, strict=True))
    turned = round((item.rotation[2] + after.rotation[2] - before.rotation[2]) % 360.0, 3)
    place = ThingPlace(location=(x, y), height=z, rotation=turned)
    return [AssetEdit(action="add", scene=scene, model=prop, place=place)]


def _renamed(graph: ContinuityMemoryGraph, scene: str, before: NodeValues, after: NodeValues) -> list[Edit]:
    """Return the edit that gives a thing or a person of the story another name; furniture has none of its own."""
    name = after.name.removeprefix(f"{scene}.")[:64]
    own = graph.asset(before.asset_id).origin != "dressing"
    return [AssetEdit(action="rename", thing=before.asset_id, name=name)] if own and name else []


def _lit(graph: ContinuityMemoryGraph, scene: str, before: NodeValues, after: NodeValues) -> list[Edit]:
    """Return the edit that makes a lamp of the scene's plan what it is in the file; none for a lamp of one shot."""
    lamp = _lamp(graph, scene, before.node_id)
    if lamp is None or before.lamp is None or after.lamp is None:
        return []
    decided = LampDecision()
    if before.lamp.power and after.lamp.power != before.lamp.power:
        # The file has the lamps as the meter set them; what counts is how much brighter this one is.
        decided = decided.model_copy(update={"power": round(lamp.power * after.lamp.power / before.lamp.power, 4)})
    if after.lamp.color != before.lamp.color:
        decided = decided.model_copy(update={"color": after.lamp.color})
    if (before.location, before.rotation) != (after.location, after.rotation):
        away = math.dist(lamp.location, lamp.target) or 1.0
        aimed = zip(after.location, looking(after.rotation), strict=True)
        target = tuple(round(at + away * toward, 4) for at, toward in aimed)
        decided = decided.model_copy(update={"location": after.location, "target": target})
    return [LightEdit(scene=scene, decision=LightDecision(lamps={before.node_id: decided}))]


def _lamp(graph: ContinuityMemoryGraph, scene: str, name: str) -> Light | None:
    plan = next((each.lighting for each in graph.scenes if scene_name(each.scene_id) == scene), None)
    return next((light for light in plan.lights if light.name == name), None) if plan is not None else None


def _laid_out(graph: ContinuityMemoryGraph, scene: str, node_id: str) -> LayoutObject | None:
    layout = next((each.layout for each in graph.scenes if scene_name(each.scene_id) == scene), None)
    return next((item for item in layout.objects if item.node_id == node_id), None) if layout is not None else None


def _filmed(shot: str, after: NodeValues, *, lens_only: bool) -> list[Edit]:
    """Return the edit that takes a shot from where its camera is in the file; none for a move of more than two keys."""
    assert after.camera is not None, "a camera has the values of one"
    poses = after.camera.poses
    lenses = {round(pose.lens, 2) for pose in poses}
    if len(lenses) > 1:
        return []
    [lens] = lenses
    if lens_only:
        return [CameraEdit(shot=shot, decision=CameraDecision(lens=lens))]
    start, *rest = map(_position, poses)
    placed = FreeCamera(start=start, end=rest[-1] if rest else None)
    return [CameraEdit(shot=shot, decision=CameraDecision(lens=lens, placed=placed))]


def _position(pose: PoseValues) -> CameraPosition:
    return CameraPosition(location=pose.location, rotation=pose.rotation)

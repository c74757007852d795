"""Objects that a person made or reshaped in Blender become models of the story, where they stand in the file."""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Callable, Iterator, Sequence
from typing import Final

from storyblender.edits.blend_change import BlendChange
from storyblender.edits.effect import scenes_of_place
from storyblender.edits.targets import scene_named
from storyblender.errors import EngineError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import scene_name
from storyblender.memory.blend_values import AdoptedObject, NodeValues
from storyblender.memory.edits import AssetEdit, Edit, PlaceEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import ADOPTED
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.scene_decision import ThingPlace
from storyblender.pipeline.run import Run

_NEAR: Final = 0.002
"""Metres that a thing whose shape was changed may be from where it was, and is not placed anew."""
_PLACED: Final = ("moved", "turned", "scaled", "reshaped")
_Made = Callable[[BlendChange, NodeValues, AdoptedObject], list[Edit]]


def with_adopted(run: Run, name: str, changes: Sequence[BlendChange], *, keep: bool) -> list[BlendChange]:
    """Return the changes of a file with edits for what is new or of another shape; their models are in the project.

    Args:
        run: On a made project.
        name: Of the file.
        changes: Of the file.
        keep: Whether the models are written; False only says what would become of them.
    """
    adopter, result = _Adopter(run, name, changes, keep), list[BlendChange]()
    for change in changes:
        result += adopter.taken(change)
    return result


class _Adopter:
    def __init__(self, run: Run, name: str, changes: Sequence[BlendChange], keep: bool) -> None:
        self._run, self._name, self._keep = run, name, keep
        self._reshaped = {(change.scene, change.subject): change for change in changes if _is_reshaped(change)}
        self._replaced, self._taken_away = set[str](), set[tuple[int, str]]()

    def taken(self, change: BlendChange) -> Iterator[BlendChange]:
        """Yield a change with its edits; one that is part of a new shape is told with that."""
        key, after = (change.scene, change.subject), change.after
        if change.kind == "added" and after is not None and after.solid and after.lamp is None:
            yield self._with(change, after, self._added)
        elif key in self._reshaped and change.kind in _PLACED:
            if self._reshaped[key] is change and after is not None:
                yield self._with(change, after, self._in_place_of)
        else:
            yield change

    def _with(self, change: BlendChange, node: NodeValues, edits: _Made) -> BlendChange:
        try:
            adopted = self._run.engine.adopt_object(self._name, change.scene, node.name, keep=self._keep).result()
        except EngineError as error:
            return change.model_copy(update={"kind": "unknown", "words": f"{change.words}: {error}"})
        if self._keep:
            self._run.outputs.note(f"{ADOPTED}/{adopted.model.file}")
        made = tuple(edits(change, node, adopted))
        kind = change.kind if made else "unknown"
        return change.model_copy(update={"kind": kind, "edits": made})

    def _added(self, change: BlendChange, node: NodeValues, adopted: AdoptedObject) -> list[Edit]:
        place = _place(adopted)
        called = called_in_story(node.name, change.scene)
        return [AssetEdit(action="add", scene=change.scene, model=called, place=place, adopted=adopted.model)]

    def _in_place_of(self, change: BlendChange, node: NodeValues, adopted: AdoptedObject) -> list[Edit]:
        """Return the edits that put the new shape in place of a thing; none where others would change with it."""
        graph = self._run.graph
        item, asset = _item(graph, change.scene, node.node_id), graph.asset(node.asset_id)
        if item is None or asset.fitted_part:
            return []
        if asset.origin != "dressing":
            return self._replaced_by(change, item, asset, adopted)
        places = scenes_of_place(graph, scene_named(graph, change.scene))
        if any((scene_name(each.scene_id), change.subject) not in self._reshaped for each in places if each.layout):
            return []
        model = asset.name or node.asset_id.removeprefix("set_").replace("_", " ")
        edits: list[Edit] = []
        if (places[0].scene_id, item.node_id) not in self._taken_away:
            self._taken_away.add((places[0].scene_id, item.node_id))
            edits.append(AssetEdit(action="remove", thing=item.node_id, scene=change.scene))
        place, called = _place(adopted), called_in_story(model, change.scene)
        return [
            *edits,
            AssetEdit(action="add", scene=change.scene, model=called, place=place, adopted=adopted.model),
        ]

    def _replaced_by(self, change: BlendChange, item: LayoutObject, asset: Asset, adopted: AdoptedObject) -> list[Edit]:
        shown = {
            (scene_name(scene.scene_id), each.node_id)
            for scene in self._run.graph.scenes
            if scene.layout is not None
            for each in scene.layout.objects
            if each.asset_id == asset.asset_id
        }
        if shown - self._reshaped.keys():
            return []
        edits: list[Edit] = []
        if asset.asset_id not in self._replaced:
            self._replaced.add(asset.asset_id)
            called = called_in_story(asset.name or asset.asset_id, change.scene)
            edits.append(AssetEdit(action="replace", thing=asset.asset_id, model=called, adopted=adopted.model))
        elsewhere = math.dist(item.location, adopted.location) > _NEAR
        turned = abs((item.rotation[2] - adopted.rotation + 180) % 360 - 180) > 0.01
        if elsewhere or turned:
            edits.append(PlaceEdit(scene=change.scene, thing=item.node_id, place=_place(adopted)))
        return edits


def _is_reshaped(change: BlendChange) -> bool:
    """Return whether a thing has another mesh, or is squeezed or tilted, which only a mesh of its own can be."""
    before, after = change.before, change.after
    if before is None or after is None or before.kind != "prop" or change.kind not in _PLACED:
        return False
    if change.kind == "reshaped":
        return True
    if before.shape and before.shape != after.shape:
        return False  # the change of the shape tells it
    factors = [now / was for was, now in zip(before.scale, after.scale, strict=True) if was]
    squeezed = max(factors, default=1.0) - min(factors, default=1.0) > _NEAR
    tilted = any(abs(a - b) > 0.01 for a, b in zip(before.rotation[:2], after.rotation[:2], strict=True))
    return change.kind == ("scaled" if squeezed else "turned") and (squeezed or tilted)


def _place(adopted: AdoptedObject) -> ThingPlace:
    x, y, z = adopted.location
    return ThingPlace(location=(x, y), height=z, rotation=adopted.rotation)


def _item(graph: ContinuityMemoryGraph, scene: str, node_id: str) -> LayoutObject | None:
    layout = scene_named(graph, scene).layout
    return next((each for each in layout.objects if each.node_id == node_id), None) if layout is not None else None


def called_in_story(name: str, scene: str) -> str:
    """Return what an object is called in the story: plain letters and digits, that an id can be made from.

    Args:
        name: In the file; may be anything.
        scene: Its scene, whose name objects begin with.
    """
    plain = unicodedata.normalize("NFKD", name.removeprefix(f"{scene}.")).encode("ascii", "ignore").decode()
    words = re.sub(r"[^a-z0-9]+", " ", plain.lower()).split()
    called = " ".join(words)[:48].strip()
    return called if called[:1].isalpha() else f"thing {called}".strip()

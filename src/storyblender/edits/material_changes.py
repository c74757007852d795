"""Materials that a person changed in a story's .blend, as edits that paint just what they saw change."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import Final

from storyblender.edits.blend_change import BlendChange
from storyblender.memory.blend_values import BlendValues, NodeValues, SceneValues, SurfaceValues
from storyblender.memory.edits import PaintEdit
from storyblender.memory.paint import PaintDecision

_LEAST: Final = 0.0005
_Used = tuple[SceneValues, NodeValues]


def material_changes(compiled: BlendValues, saved: BlendValues) -> Iterator[BlendChange]:
    """Yield the materials that are otherwise in the file, then the objects that have other materials.

    Args:
        compiled: The file as it was written.
        saved: As it is; materials are known by their names.
    """
    users = _users(compiled)
    for name, before in compiled.surfaces.items():
        after = saved.surfaces.get(name)
        look = _look(before, after) if after is not None else None
        if after is None or look is None or not users[name]:
            continue
        words = f"material {name!r} is painted: {look.words}" if look.words else f"material {name!r} has other nodes"
        edits = tuple(_painted_everywhere(before.name, look, users[name], compiled.scenes)) if look.words else ()
        yield BlendChange(
            kind="material", subject=before.name, words=words, edits=edits,
            compiled=_told(before), saved=_told(after),
        )  # fmt: skip
    yield from _slot_changes(compiled, saved)


def _users(values: BlendValues) -> dict[str, list[_Used]]:
    users: dict[str, list[_Used]] = defaultdict(list)
    for scene in values.scenes:
        for node in scene.nodes:
            for name in dict.fromkeys(node.materials):
                users[name].append((scene, node))
    return users


def _look(before: SurfaceValues, after: SurfaceValues) -> PaintDecision | None:
    """Return what was changed of a material; an empty decision where no edit can say it, None for nothing."""
    if before.base == "other" and before == after:
        return None
    changed = any(abs(was - now) > _LEAST for was, now in zip(before.color, after.color, strict=True))
    unlinked = before.base == "picture" and after.base == "plain"
    if before.base != after.base and not unlinked:
        return PaintDecision()
    if before.base == "other":
        return PaintDecision() if changed else None
    look = PaintDecision(
        color=_share(after.color) if changed or unlinked else None,
        plain=True if unlinked else None,
        roughness=after.roughness if abs(before.roughness - after.roughness) > _LEAST else None,
        metallic=after.metallic if abs(before.metallic - after.metallic) > _LEAST else None,
    )
    return look if look.words else None


def _share(color: tuple[float, float, float]) -> tuple[float, float, float]:
    red, green, blue = (min(max(each, 0.0), 1.0) for each in color)
    return red, green, blue


def _painted_everywhere(
    material: str, look: PaintDecision, users: Sequence[_Used], scenes: Sequence[SceneValues]
) -> Iterator[PaintEdit]:
    """Yield the edits that paint a material in all that has it: an asset, some scenes, or the story."""
    assets = {node.asset_id for _, node in users}
    if len(assets) == 1 and "" not in assets:
        yield PaintEdit(material=material, thing=assets.pop(), look=look)
        return
    shown = sorted({scene.name for scene, _ in users})
    if len(shown) == len(scenes) > 1:
        yield PaintEdit(material=material, look=look)
        return
    for scene in shown:
        yield PaintEdit(material=material, scene=scene, look=look)


def _slot_changes(compiled: BlendValues, saved: BlendValues) -> Iterator[BlendChange]:
    """Yield the objects of which a slot has another material; an asset that has it everywhere is one change."""
    there = {(scene.name, node.origin): node for scene in saved.scenes for node in scene.nodes if node.origin}
    nodes = [(scene.name, node) for scene in compiled.scenes for node in scene.nodes if node.kind != "light"]
    found: dict[tuple[str, str, str], list[tuple[str, NodeValues]]] = defaultdict(list)
    for scene, before in nodes:
        after = there.get((scene, before.name))
        if after is None or len(after.materials) != len(before.materials):
            continue
        for was, now in dict.fromkeys(zip(before.materials, after.materials, strict=True)):
            if was != now:
                found[before.asset_id or f"{scene} {before.node_id}", was, now].append((scene, before))
    for (owner, was, now), changed in found.items():
        before, after = compiled.surfaces.get(was), saved.surfaces.get(now)
        look = _exchanged(before, after) if before is not None and after is not None else None
        if look is None:
            continue
        everywhere = sum(node.asset_id == owner for _, node in nodes) == len(changed)
        if before is not None and look.words and everywhere:
            edits = (PaintEdit(material=before.name, thing=owner, look=look),)
        elif before is not None and look.words:
            edits = tuple(
                PaintEdit(material=before.name, scene=scene, thing=node.node_id, look=look) for scene, node in changed
            )
        else:
            edits = ()
        name = owner if everywhere else ", ".join(node.name for _, node in changed)
        yield BlendChange(
            kind="material", subject=owner, scene="" if everywhere else changed[0][0], edits=edits,
            words=f"{name} has material {now!r} in place of {was!r}",
            compiled=_told(before), saved=_told(after),
        )  # fmt: skip


def _exchanged(before: SurfaceValues, after: SurfaceValues) -> PaintDecision | None:
    """Return what another material comes to; None if it looks the same."""
    if after.finish and after.finish != before.finish:
        return PaintDecision(finish=after.finish)
    if after.base == "picture" and (before.base != "picture" or before.name != after.name):
        return PaintDecision()  # a picture of its own, which no paint has
    return _look(before, after)


def _told(surface: SurfaceValues | None) -> str:
    if surface is None:
        return ""
    look = PaintDecision(color=_share(surface.color), roughness=surface.roughness, metallic=surface.metallic)
    return look.words

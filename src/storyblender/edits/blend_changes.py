"""What a person changed in a story's .blend: the file as it was compiled against the file as it is."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import Final

from storyblender.edits.blend_change import BlendChange, ChangeKind
from storyblender.edits.cut_changes import cut_changes
from storyblender.edits.material_changes import material_changes
from storyblender.memory.blend_values import (
    BlendReading,
    CurveValues,
    NodeValues,
    PoseValues,
    SceneValues,
    Vector,
)

_Said = Callable[[ChangeKind, str], "BlendChange"]
"""Makes a change of one object from its kind and what is said of it."""
_METRES: Final = 0.0005
_DEGREES: Final = 0.01
_CAMERA_DEGREES: Final = 0.05
_SHARE: Final = 0.0005
"""Less than that is no change: it is what single precision and an undo in Blender leave."""


def changes_of(reading: BlendReading) -> list[BlendChange]:
    """Return what a person changed, scene by scene; nothing of a file that does not say what it was compiled as.

    Args:
        reading: Of the file.
    """
    if reading.compiled is None:
        return []
    saved = {scene.name: scene for scene in reading.saved.scenes}
    changes: list[BlendChange] = []
    for scene in reading.compiled.scenes:
        if scene.name not in saved:
            words = "the whole scene is gone"
            changes.append(BlendChange(kind="deleted", scene=scene.name, subject=scene.name, words=words))
            continue
        changes += _scene_changes(scene, saved[scene.name])
    known = {scene.name for scene in reading.compiled.scenes}
    for name in sorted(set(saved) - known):
        changes.append(BlendChange(kind="unknown", scene=name, subject=name, words="a scene that is new"))
    changes += material_changes(reading.compiled, reading.saved)
    if reading.compiled.cut is not None and reading.saved.cut is not None:
        changes += cut_changes(reading.compiled.cut, reading.saved.cut)
    return changes


def _scene_changes(before: SceneValues, after: SceneValues) -> Iterator[BlendChange]:
    there = _by_origin(after.nodes)
    for node in before.nodes:
        same = there.pop(node.name, [])
        if not same:
            yield BlendChange(
                kind="deleted", scene=before.name, subject=_subject(node), before=node, words=f"{node.name} is deleted"
            )
            continue
        own, *copies = same
        yield from _node_changes(before.name, node, own)
        for copy in copies:
            words = f"{plain(copy.name)} is a copy of {node.name}"
            yield BlendChange(
                kind="duplicated", scene=before.name, subject=_subject(node), before=node, after=copy, words=words
            )
    for node in (node for nodes in there.values() for node in nodes):
        words = f"{plain(node.name)} is new"
        yield BlendChange(kind="added", scene=before.name, subject=node.name, after=node, words=words)
    yield from _marker_changes(before, after)


def _by_origin(nodes: Sequence[NodeValues]) -> dict[str, list[NodeValues]]:
    """Return objects by the name that they were compiled with, the one that still has it first."""
    found: dict[str, list[NodeValues]] = {}
    for node in nodes:
        found.setdefault(node.origin or f"\0{node.name}", []).append(node)
    return {origin: sorted(same, key=lambda node: node.name != origin) for origin, same in found.items()}


def _subject(node: NodeValues) -> str:
    return node.name if node.kind in ("camera", "") else node.node_id


def _node_changes(scene: str, before: NodeValues, after: NodeValues) -> Iterator[BlendChange]:
    def change(kind: ChangeKind, words: str) -> BlendChange:
        return BlendChange(
            kind=kind, scene=scene, subject=_subject(before), words=f"{before.name} {words}", before=before, after=after
        )

    if after.name != before.name:
        yield change("renamed", f"is called {plain(after.name)}")
    if before.camera is not None and after.camera is not None:
        yield from _camera_changes(before, after, change)
    elif not (before.animated or after.animated):
        if _differ(before.location, after.location, _METRES):
            x, y, z = (b - a for a, b in zip(before.location, after.location, strict=True))
            yield change("moved", f"is moved by {x:.2f}, {y:.2f}, {z:.2f} m")
        if max(map(_turn, before.rotation, after.rotation)) > _DEGREES:
            yield change("turned", f"is turned to {after.rotation[2]:.0f} degrees")
        if _differ(before.scale, after.scale, _SHARE):
            yield change("scaled", "is scaled")
    if before.shape and after.shape != before.shape:
        yield change("reshaped", "has another shape")
    if before.lamp is not None and after.lamp is not None:
        brighter = after.lamp.power / before.lamp.power if before.lamp.power else 1.0
        if abs(brighter - 1) > _SHARE or _differ(before.lamp.color, after.lamp.color, _SHARE):
            dimmed = abs(brighter - 1) > _SHARE
            yield change("lamp", f"has {brighter:.2f} times its power" if dimmed else "is of another colour")
    if before.camera is None:
        yield from _motion_changes(before, after, change)


def _camera_changes(before: NodeValues, after: NodeValues, change: _Said) -> Iterator[BlendChange]:
    was, now = before.camera, after.camera
    assert was is not None and now is not None, "both are cameras"
    if len(was.poses) != len(now.poses) or any(map(_moved, was.poses, now.poses)) or was.between != now.between:
        yield change("camera", "is taken from elsewhere")
    elif any(abs(a.lens - b.lens) > 0.005 for a, b in zip(was.poses, now.poses, strict=True)):
        yield change("lens", f"has {now.poses[0].lens:.0f} mm")
    elif was.path and was.path != now.path:
        yield change("unknown", "moves otherwise between its first and last key")
    if abs(was.f_number - now.f_number) > 0.005 or was.blurs != now.blurs:
        yield change("aperture", f"has f/{now.f_number:g}" if now.blurs else "has no depth of field")


def _moved(before: PoseValues, after: PoseValues) -> bool:
    mirrored = tuple(-part for part in after.rotation)  # the same rotation
    apart = min(math.dist(before.rotation, after.rotation), math.dist(before.rotation, mirrored))
    return _differ(before.location, after.location, _METRES) or math.degrees(4 * math.asin(apart / 2)) > _CAMERA_DEGREES


def _motion_changes(before: NodeValues, after: NodeValues, change: _Said) -> Iterator[BlendChange]:
    was, now = {strip.name: strip for strip in before.strips}, {strip.name: strip for strip in after.strips}
    for name in {**was, **now}:
        if name not in was or name not in now:
            yield change("strip", f"has strip {name} {'more' if name in now else 'no more'}")
            continue
        if (was[name].start, was[name].end) != (now[name].start, now[name].end):
            yield change("strip", f"plays {name} from frame {now[name].start:g} to {now[name].end:g}")
        yield from _curve_changes(was[name].curves, now[name].curves, f"in {name}", change)
    yield from _curve_changes(before.action, after.action, "above its strips", change)
    if before.posing and before.posing != after.posing:
        yield change("posed", "has other constraints, switches or poses at rest")


def _curve_changes(
    before: CurveValues | None, after: CurveValues | None, where: str, change: _Said
) -> Iterator[BlendChange]:
    if before == after:
        return
    if before is None or after is None or before.keys != after.keys:
        count = (after.keys if after else 0) - (before.keys if before else 0)
        yield change("keys added", f"has {abs(count)} keys {'more' if count > 0 else 'less'} {where}")
    elif before.frames != after.frames:
        yield change("keys retimed", f"has its keys at other frames {where}")
    else:
        yield change("posed", f"is posed otherwise {where}")


def _marker_changes(before: SceneValues, after: SceneValues) -> Iterator[BlendChange]:
    """Yield every marker that begins its shot elsewhere, with the lengths of the shots on both sides of it."""
    if list(_in_order(before)) != list(_in_order(after)):
        words = "markers come, go or change their order"
        yield BlendChange(kind="unknown", scene=before.name, subject=before.name, words=words)
        return
    was, now = _lengths(before), _lengths(after)
    names = list(was)
    for former, name in pairwise([None, *names]):
        if name is not None and before.markers[name] != after.markers[name]:
            both = {each: now[each] for each in (former, name) if each is not None and was[each] != now[each]}
            words = f"{name} begins at frame {after.markers[name]}"
            yield BlendChange(kind="marker", scene=before.name, subject=name, words=words, lengths=both)


def _in_order(scene: SceneValues) -> dict[str, int]:
    return dict(sorted(scene.markers.items(), key=lambda item: item[1]))


def _lengths(scene: SceneValues) -> dict[str, int]:
    starts = _in_order(scene)
    ends = [*list(starts.values())[1:], scene.end + 1]
    return {name: end - start for (name, start), end in zip(starts.items(), ends, strict=True)}


def plain(name: str) -> str:
    """Return a name from a file as it can stand in a sentence."""
    return "".join(each if each.isprintable() else " " for each in name)


def _differ(before: Vector, after: Vector, least: float) -> bool:
    return any(abs(a - b) > least for a, b in zip(before, after, strict=True))


def _turn(before: float, after: float) -> float:
    return abs((after - before + 180.0) % 360.0 - 180.0)

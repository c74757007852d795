"""Names that an edit uses: of shots, scenes and assets; a wrong one is refused with the nearest right one."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from difflib import get_close_matches
from typing import TypeVar

from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import ShotContext

Target = ShotContext | SceneContext | Asset
_MOST = 12
"""Names that a refusal lists."""
_Target = TypeVar("_Target", bound=ShotContext | SceneContext | Asset)


def shots_named(graph: ContinuityMemoryGraph, names: Sequence[str]) -> list[ShotContext]:
    """Return the shots with these names, in that order; all shots of the film if no name is given.

    Args:
        graph: The story.
        names: Such as ``SC010_SH020``, in any case.

    Raises:
        InputError: There is no shot of that name.
    """
    known = {shot_name(shot.scene_id, shot.shot_id): shot for shot in graph.shots}
    if not names:
        return list(graph.cut)
    return [_in_itself(known[_known("shot", name, name.upper(), known)]) for name in names]


def target_named(graph: ContinuityMemoryGraph, name: str) -> Target:
    """Return the shot, the scene or the asset with a name.

    Args:
        graph: The story.
        name: ``SC010_SH020``, ``SC010`` (both in any case), or an asset's id.

    Raises:
        InputError: There is none of that name.
    """
    known: dict[str, Target] = {asset.asset_id: asset for asset in graph.assets}
    known |= {scene_name(scene.scene_id): scene for scene in graph.scenes}
    known |= {shot_name(shot.scene_id, shot.shot_id): shot for shot in graph.shots}
    return _in_itself(known[_known("shot, scene or asset", name, name if name in known else name.upper(), known)])


def scene_named(graph: ContinuityMemoryGraph, name: str) -> SceneContext:
    """Return the scene with a name, or that of the shot with it.

    Args:
        graph: The story.
        name: ``SC010`` or ``SC010_SH020``, in any case.

    Raises:
        InputError: There is no such scene.
    """
    known = {scene_name(scene.scene_id): scene for scene in graph.scenes}
    return known[_known("scene", name, name.upper().partition("_")[0], known)]


def person_or_thing(graph: ContinuityMemoryGraph, name: str) -> str:
    """Return the id of an asset, which may be given by its name in the script.

    Args:
        graph: The story.
        name: An asset_id, or the name in the script, in any case.

    Raises:
        InputError: There is no such asset.
    """
    found = _asset_called(graph, name)
    if found is None:
        refuse_other(name, "person or thing", [each.asset_id for each in graph.assets if each.origin != "dressing"])
    return found or name


def person_named(graph: ContinuityMemoryGraph, name: str) -> str:
    """Return the id of a person, who may be given by their name in the script; or of the thing that is called so.

    Args:
        graph: The story.
        name: An asset_id, or the name in the script, in any case.

    Raises:
        InputError: Nobody and nothing is called that.
    """
    found = _asset_called(graph, name)
    if found is None:
        refuse_other(name, "person", [each.asset_id for each in graph.assets if each.asset_type == "character"])
    return found or name


def refuse_other(key: str, what: str, known: Collection[str]) -> None:
    """Refuse a key that is not among the known ones, with the nearest of them.

    Args:
        key: As an edit gives it.
        what: It is of, for people.
        known: Keys that there are.

    Raises:
        InputError: It is none of them.
    """
    if key in known:
        return
    near = get_close_matches(key, known, n=3, cutoff=0.6)
    several = ", ".join(near or sorted(known)[:_MOST])
    more = " ..." if len(known) > _MOST else ""
    mend = f"did you mean {several}?" if near else f"there are: {several}{more}" if several else "there is none"
    raise InputError(f"there is no {what} {key!r}", mend=mend)


def as_id(name: str) -> str:
    """Return a name in the form of an id: ``Young Anna`` is ``young_anna``."""
    return "_".join(name.lower().split())


def _asset_called(graph: ContinuityMemoryGraph, name: str) -> str | None:
    """Return the id of the asset with an id or a name, in any case; None if there is none."""
    ids = {asset.asset_id: asset.asset_id for asset in graph.assets}
    called = {as_id(asset.name): asset.asset_id for asset in graph.assets if asset.name}
    return ids.get(name) or called.get(as_id(name)) or ids.get(name.lower())


def _in_itself(target: _Target) -> _Target:
    """Return what is named; a shot that is joined to the one before it is refused."""
    if isinstance(target, ShotContext) and target.joined:
        name = shot_name(target.scene_id, target.shot_id)
        raise InputError(f"{name} is joined to the shot before it", mend="split that one where it began")
    return target


def _known(what: str, written: str, name: str, known: Collection[str]) -> str:
    if name in known:
        return name
    near = get_close_matches(name, known, n=1, cutoff=0.8)
    names = list(known)
    mend = f"did you mean {near[0]}?" if near else f"they go from {names[0]} to {names[-1]}" if names else ""
    raise InputError(f"there is no {what} {written!r}", mend=mend)

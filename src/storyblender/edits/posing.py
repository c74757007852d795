"""How a person is to sit, look or hold, as an edit says it: names become ids, and what cannot be is refused."""

from __future__ import annotations

from collections.abc import Collection
from difflib import get_close_matches

from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.agents.visual_effects_artist.poses_by_hand import WAYS
from storyblender.agents.visual_effects_artist.stage_state import HAND_SIZE
from storyblender.catalog.sets import plan_of
from storyblender.edits.effect import name_of
from storyblender.edits.targets import as_id
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Frozen
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import Layout, SceneContext
from storyblender.memory.scene_decision import PersonPlace


def as_posed(graph: ContinuityMemoryGraph, scene: SceneContext, person: str, place: PersonPlace) -> PersonPlace:
    """Return how a person is to be, with the ids of what they sit on, look at and hold.

    Args:
        graph: The story.
        scene: Where they are.
        person: Asset id.
        place: Ids or names, as a person writes them.

    Raises:
        InputError: There is no such thing, it carries nobody so, or nobody can hold it.
    """
    if not place.is_posed:
        return place
    layout, environment = scene.layout, scene.environment
    if layout is None or environment is None:
        raise InputError(f"{name_of(scene)} is not staged yet", mend="run `storyblender render` first")
    update: dict[str, object] = {}
    if place.on is not None:
        floor = Floor(layout, graph.assets_of(scene.scene_id), plan_of(environment))
        update["on"] = _support(floor, _node(graph, scene, layout, place.on), str(place.posture))
    if place.looking_at is not None and place.looking_at not in WAYS:
        update["looking_at"] = looked_at(graph, scene, person, place.looking_at)
    if place.holding is not None:
        update["holding"] = tuple(dict.fromkeys(held_thing(graph, scene, each) for each in place.holding))
    return place.model_copy(update=update)


class PoseChoices(Frozen):
    """What people of a scene can sit and lie on, and hold; names by id."""

    sit: dict[str, str]
    """Seats by node id."""
    lie: dict[str, str]
    """Beds by node id."""
    hold: dict[str, str]
    """Things of the story by asset id."""
    look: dict[str, str]
    """People by asset id, and things of the story by node id."""


def pose_choices(graph: ContinuityMemoryGraph, scene: SceneContext) -> PoseChoices:
    """Return what people of a scene can sit and lie on, hold and look at.

    Args:
        graph: The story.
        scene: One that is not staged yet offers nothing.
    """
    layout, environment = scene.layout, scene.environment
    if layout is None or environment is None:
        return PoseChoices(sit={}, lie={}, hold={}, look={})
    floor = Floor(layout, graph.assets_of(scene.scene_id), plan_of(environment))
    names = {asset.asset_id: asset.name or asset.asset_id for asset in graph.assets}
    things = {node_id: names.get(thing.asset_id, node_id) for node_id, thing in floor.things.items()}
    own = graph.own_objects_of(scene.scene_id)
    nodes = {item.asset_id: item.node_id for item in reversed(layout.objects)}
    people = [asset_id for asset_id in scene.setup.asset_ids if graph.asset(asset_id).asset_type == "character"]
    return PoseChoices(
        sit={node_id: name for node_id, name in things.items() if floor.seats(node_id)},
        lie={node_id: name for node_id, name in things.items() if floor.bed_edges(node_id)},
        hold={asset.asset_id: names[asset.asset_id] for asset in own if _fits_hands(asset)},
        look={
            **{asset_id: names[asset_id] for asset_id in people},
            **{nodes.get(asset.asset_id, asset.asset_id): names[asset.asset_id] for asset in own},
        },
    )


def _support(floor: Floor, node_id: str, posture: str) -> str:
    """Return a thing that carries a person in a posture. Raises InputError."""
    carries = {
        "sit": bool(floor.seats(node_id) or floor.seats(node_id, on_top=True)),
        "lie": bool(floor.bed_edges(node_id)),
        "lean": True,
    }[posture]
    if carries:
        return node_id
    others = [each for each in floor.things if (floor.seats(each) if posture == "sit" else floor.bed_edges(each))]
    mend = f"there are: {', '.join(others[:8])}" if others else "the set has nothing for it"
    raise InputError(f"nobody can {posture} on {node_id}", mend=mend)


def _node(graph: ContinuityMemoryGraph, scene: SceneContext, layout: Layout, name: str) -> str:
    """Return the node id of a thing of the layout by id or name; of several the first. Raises InputError."""
    wanted, called = {name, as_id(name)}, {asset.asset_id: as_id(asset.name) for asset in graph.assets}
    things = [each for each in layout.objects if graph.asset(each.asset_id).asset_type != "character"]
    found = [each.node_id for each in things if each.node_id in wanted]
    found += [each.node_id for each in things if wanted & {each.asset_id, called.get(each.asset_id, "")}]
    if not found:
        raise _unknown(name, scene, [each.node_id for each in things])
    return found[0]


def looked_at(graph: ContinuityMemoryGraph, scene: SceneContext, person: str, name: str) -> str:
    """Return the id of a person or a thing that another person looks at, or does something to.

    Args:
        graph: The story.
        scene: Where they are.
        person: Who looks; asset id.
        name: Of what they look at: an id or a name.

    Raises:
        InputError: There is none, or it is themselves.
    """
    layout = scene.layout
    if layout is None:
        raise InputError(f"{name_of(scene)} is not staged yet", mend="run `storyblender render` first")
    own = _asset(graph, scene, name)
    if own is not None and own.asset_id == person:
        raise InputError(f"{person} cannot look at themselves", mend="name another one, or a direction: left, camera")
    if own is not None and own.asset_type == "character":
        return own.asset_id
    nodes = {item.asset_id: item.node_id for item in reversed(layout.objects)}
    return nodes.get(own.asset_id, own.asset_id) if own is not None else _node(graph, scene, layout, name)


def held_thing(graph: ContinuityMemoryGraph, scene: SceneContext, name: str) -> str:
    """Return the id of a thing of the story that a hand can hold.

    Args:
        graph: The story.
        scene: Where it is.
        name: Its id or name.

    Raises:
        InputError: There is none, or it is too large.
    """
    own = _asset(graph, scene, name)
    if own is None or own.asset_type != "object":
        raise _unknown(name, scene, [asset.asset_id for asset in graph.own_objects_of(scene.scene_id)])
    if not _fits_hands(own):
        raise InputError(f"{own.asset_id} is too large for hands, or fixed", mend="name a smaller thing")
    return own.asset_id


def _fits_hands(asset: Asset) -> bool:
    """Return whether a hand can hold a thing."""
    made = asset.canonical
    grips = made is not None and any(anchor.kind == "grip" for anchor in made.anchors)
    return not asset.fitted_part and (made is None or grips or sorted(made.dimensions)[1] <= HAND_SIZE)


def _asset(graph: ContinuityMemoryGraph, scene: SceneContext, name: str) -> Asset | None:
    """Return a person or a thing of a scene that is the story's own, by id or name."""
    own = [graph.asset(asset_id) for asset_id in scene.setup.asset_ids]
    named = [each for each in own if each.asset_id == name or as_id(name) in (each.asset_id, as_id(each.name or ""))]
    return named[0] if named else None


def _unknown(name: str, scene: SceneContext, known: Collection[str]) -> InputError:
    near = get_close_matches(as_id(name), known, n=3, cutoff=0.6)
    several = ", ".join(list(known)[:12])
    mend = f"did you mean {', '.join(near)}?" if near else f"there are: {several}" if several else "there is nothing"
    return InputError(f"there is no {name!r} in {name_of(scene)}", mend=mend)

"""What lies where when a place is seen again: put down in an earlier visit, and not taken since."""

from __future__ import annotations

from storyblender.agents.director.reading import Reading
from storyblender.memory.scene_context import Relation

_LYING = ("on", "in", "under")


def left_behind(reading: Reading) -> dict[int, list[Relation]]:
    """Return, for each scene id, where things lie that an earlier scene in the same place left there.

    Args:
        reading: What the script says.
    """
    props = {thing.id for thing in reading.things if thing.kind == "prop"}
    roots: dict[int, int] = {}
    lying: dict[int, dict[str, Relation]] = {}
    found: dict[int, list[Relation]] = {}
    for index, scene in enumerate(reading.scenes):
        root = roots[scene.id] = roots.get(scene.reference or scene.id, scene.id)
        here = lying.setdefault(root, {})
        found[scene.id] = list(here.values())
        for stated, relation in reading.relations:
            if stated == index and relation.asset_id in props:
                _place(relation, here)
        last = {
            deed.prop: deed.motion for unit in reading.units if unit.scene == index for deed in unit.deeds if deed.prop
        }
        for thing, motion in last.items():
            for place in lying.values():
                if place is not here or motion != "put_down":
                    place.pop(thing, None)
    return found


def _place(relation: Relation, here: dict[str, Relation]) -> None:
    """Note where a thing lies; what is put beside another lies where that lies."""
    beside = here.get(relation.anchor_asset_id)
    if relation.kind in _LYING:
        here[relation.asset_id] = relation
    elif relation.kind == "next_to" and beside:
        here[relation.asset_id] = beside.model_copy(update={"asset_id": relation.asset_id})

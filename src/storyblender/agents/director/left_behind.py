"""What lies where when a place is seen again: put down in an earlier visit, and not taken since."""

from __future__ import annotations

from storyblender.agents.director.reading import Reading, Unit
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
    where: dict[str, set[int]] = {}
    stated_in: dict[int, list[Relation]] = {}
    for index, relation in reading.relations:
        stated_in.setdefault(index, []).append(relation)
    units_of: dict[int, list[Unit]] = {}
    for unit in reading.units:
        units_of.setdefault(unit.scene, []).append(unit)
    for index, scene in enumerate(reading.scenes):
        root = roots[scene.id] = roots.get(scene.reference or scene.id, scene.id)
        here = lying.setdefault(root, {})
        found[scene.id] = list(here.values())
        for relation in stated_in.get(index, ()):
            if relation.asset_id in props and _place(relation, here):
                where.setdefault(relation.asset_id, set()).add(root)
        last = {deed.prop: deed.motion for unit in units_of.get(index, ()) for deed in unit.deeds if deed.prop}
        for thing, motion in last.items():
            kept = where.get(thing, set()) & {root} if motion == "put_down" else set[int]()
            for other in where.get(thing, set()) - kept:
                del lying[other][thing]
            where[thing] = kept
    return found


def _place(relation: Relation, here: dict[str, Relation]) -> bool:
    """Note where a thing lies; what is put beside another lies where that lies. Return whether it lies somewhere."""
    beside = here.get(relation.anchor_asset_id)
    if relation.kind in _LYING:
        here[relation.asset_id] = relation
    elif relation.kind == "next_to" and beside:
        here[relation.asset_id] = beside.model_copy(update={"asset_id": relation.asset_id})
    else:
        return False
    return True

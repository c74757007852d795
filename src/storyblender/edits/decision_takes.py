"""Takes of a shot's blocking and of a scene's layout; the crew makes the one that is chosen anew."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeVar

from storyblender.edits.effect import Effect, name_of, refuse_locked, shot_names
from storyblender.edits.scene_edits import staged_anew
from storyblender.edits.targets import scene_named, shots_named
from storyblender.errors import InputError
from storyblender.memory.edits import TakeEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.kept_takes import BlockingTake, BlockingTakes, LayoutTake, LayoutTakes
from storyblender.memory.scene_decision import BlockingDecision, LayoutDecision

Decision = TypeVar("Decision", BlockingDecision, LayoutDecision)


def blocking_take_effects(graph: ContinuityMemoryGraph, edit: TakeEdit) -> list[Effect]:
    """Return what keeping, choosing or dropping a take of a shot's blocking does. Raises InputError."""
    [shot] = shots_named(graph, [edit.shot])
    kept = shot.blocking_takes or BlockingTakes(number=1)
    others = {take.number: take.decision for take in kept.others}
    number, decision, others = _after(edit, name_of(shot), kept.number, shot.blocking_decision, others)
    rest = tuple(BlockingTake(number=each, decision=others[each]) for each in sorted(others))
    update: dict[str, object] = {"blocking_takes": BlockingTakes(number=number, others=rest)}
    stale: tuple[str, ...] = ()
    if edit.action == "choose":
        refuse_locked(shot, "blocking")
        update |= {"blocking_decision": decision, "stale": ("motion",)}
        stale = shot_names(graph, shot.scene_id)
    return [Effect(shot.model_copy(update=update), name_of(shot), _words(edit, number), frozenset({"blocking"}), stale)]


def layout_take_effects(graph: ContinuityMemoryGraph, edit: TakeEdit) -> list[Effect]:
    """Return what keeping, choosing or dropping a take of a scene's layout does. Raises InputError."""
    scene = scene_named(graph, edit.shot)
    kept = scene.layout_takes or LayoutTakes(number=1)
    present = scene.layout_decision or LayoutDecision()
    others = {take.number: take.decision for take in kept.others}
    number, decision, others = _after(edit, name_of(scene), kept.number, _placed(present), others)
    rest = tuple(LayoutTake(number=each, decision=others[each]) for each in sorted(others))
    takes = LayoutTakes(number=number, others=rest)
    if edit.action != "choose":
        item = scene.model_copy(update={"layout_takes": takes})
        return [Effect(item, name_of(scene), _words(edit, number), frozenset({"layout"}))]
    chosen = (decision or LayoutDecision()).model_copy(update={"added": present.added, "removed": present.removed})
    return staged_anew(graph, scene, _words(edit, number), layout_decision=chosen, layout_takes=takes)


def _placed(decision: LayoutDecision) -> LayoutDecision:
    """Return what a take of a layout has: which things there are is the same in all takes."""
    return LayoutDecision(staging=decision.staging, things=decision.things)


def _after(
    edit: TakeEdit, name: str, shown: int, present: Decision | None, others: Mapping[int, Decision | None]
) -> tuple[int, Decision | None, dict[int, Decision | None]]:
    """Return number and decision of the take in the film, and the others by number, as an edit makes them."""
    rest = dict(others)
    if edit.number is None:
        return max(shown, *rest, 0) + 1, present, rest | {shown: present}
    if edit.number == shown:
        mend = "choose another one first" if edit.action == "drop" else "it needs no choosing"
        raise InputError(f"take {edit.number} of the {edit.of} of {name} is the one that the film shows", mend=mend)
    if edit.number not in rest:
        numbers = ", ".join(map(str, sorted({*rest, shown})))
        raise InputError(f"{name} has no take {edit.number} of its {edit.of}", mend=f"it has: {numbers}")
    chosen = rest.pop(edit.number)
    if edit.action == "drop":
        return shown, present, rest
    return edit.number, chosen, rest | {shown: present}


def _words(edit: TakeEdit, number: int) -> str:
    if edit.number is None:
        return f"{edit.of}: take {number} begun, the one before is kept"
    return f"{edit.of}: take {edit.number} {'chosen' if edit.action == 'choose' else 'dropped'}"

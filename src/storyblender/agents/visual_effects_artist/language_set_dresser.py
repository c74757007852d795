"""The Set Dresser played by a language model: it leaves furnishings out and adds catalogue props by relations."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from typing import Any, Final

from pydantic import Field

from storyblender.agents.asking import Asker, LanguagePolicy, Notes
from storyblender.agents.layout_artist.cleared_action import ADDED
from storyblender.agents.nearest import nearest_entries
from storyblender.agents.story_lines import story_lines
from storyblender.agents.visual_effects_artist.extra_furnishings import TOPS, At, PictureSide, Standing, find_place
from storyblender.agents.visual_effects_artist.furniture import (
    PlacedFurnishing,
    box_at,
    has_lost_support,
    size_of_asset,
)
from storyblender.agents.visual_effects_artist.set_dresser import RulesSetDresser, SetDresserDraft, SetDresserView
from storyblender.catalog.props import PROPS, PropEntry
from storyblender.catalog.props.prop_families import family_of
from storyblender.catalog.props.prop_names import prop_of
from storyblender.catalog.set_plan import Furnishing, SetPlan
from storyblender.catalog.sets import SETS
from storyblender.catalog.sets.belongings import ROOMS, STANDING
from storyblender.catalog.sets.period import existed_in
from storyblender.memory.base import Identifier, scene_name
from storyblender.ports import Answerer, Embedder
from storyblender.reflection import Policy

_PROPS = 60
"""Props near the place in meaning that a request offers, besides those that any place may have."""
_EVERYDAY: Final = {prop for prop, _ in STANDING.values()} | {
    key.rpartition(":")[2] for room in ROOMS.values() for key in room.tops
}
"""Props that people have anywhere."""
_LARGEST = 2.4
"""Metres of the largest prop that is added."""
_MOST = 8
"""Props that an answer may add."""
_BY = ("on", "next_to", "in_front_of", "behind")
"""Where a prop is put by another one."""


class ExtraProp(Notes):
    """A prop that the set gets beyond its plan."""

    prop: Identifier
    """Key of a prop in `props`, which has them by what they stand or hang on."""
    at: At
    anchor: Identifier | None = None
    """Id of the furnishing that it is on, next to, in front of or behind."""
    side: PictureSide | None = None
    """Side of the set, as the audience sees it, where it should rather be."""


class DressingNotes(Notes):
    """The dressing of a set."""

    leave_out: tuple[Identifier, ...] = ()
    """Ids of furnishings that do not belong in this story; none that are `needed`."""
    add: tuple[ExtraProp, ...] = Field(default=(), max_length=_MOST)


def language_set_dresser(
    answerer: Answerer, embedder: Callable[[], Embedder]
) -> Policy[SetDresserView, SetDresserDraft]:
    """Return the Set Dresser played by a model; a place that was dressed in an earlier scene stays as it was.

    Rules find the metres, keep the ways of people free and leave out what does not fit.

    Args:
        answerer: The model, or a person in its place.
        embedder: Likeness of meaning; chooses the props of a request.
    """
    rules = RulesSetDresser()

    def offered(view: SetDresserView) -> list[PropEntry]:
        kit = SETS[view.plan.kit]
        texts = [view.setup.place.lower(), kit.name, kit.description or ", ".join(kit.tags)]
        able = _dressing(view)
        near = {entry.key for entry in nearest_entries(able, texts, embedder(), _PROPS)}
        return [entry for entry in able if entry.key in near | _EVERYDAY]

    return LanguagePolicy(
        Asker(answerer, "set_dresser", DressingNotes),
        show=lambda view: _shown(view, rules.propose(view), offered(view)),
        check=lambda answer, view: _wrong(answer, view, rules.propose(view), {entry.key for entry in offered(view)}),
        draft_of=lambda answer, view: _dressed(answer, view, rules),
        subject=lambda view: scene_name(view.outline.scene_id) if view.outline is not None else "",
        mend=rules.refine,
        settled=lambda view: _dressed_as_before(view, rules) if view.before else None,
    )


def _dressing(view: SetDresserView) -> list[PropEntry]:
    """Return the props that can dress a set: no creatures or vehicles, nothing that the script brings."""
    told = {prop for asset in view.objects for prop in (prop_of(asset), *family_of(prop_of(asset)))}
    outdoors = () if not view.plan.indoor else ("nature", "street")
    return [
        entry for entry in PROPS.values()
        if entry.key not in told and entry.category not in outdoors and not entry.life_size
        and entry.placement != "ceiling" and max(entry.size) < _LARGEST and existed_in(entry.key, view.period)
    ]  # fmt: skip


def _dressed(answer: DressingNotes, view: SetDresserView, rules: RulesSetDresser) -> SetDresserDraft:
    """Return the rules' dressing without what an answer leaves out, with what it adds where there is room."""
    view = replace(view, plan=_without(view.plan, answer.leave_out))
    standing = _standing(rules.propose(view), view)
    added, no_room = list[Furnishing](), list[str]()
    for number, extra in enumerate(answer.add, start=1):
        node_id = f"{ADDED}{extra.prop}_{number}"
        place = find_place(view.plan, standing, extra.prop, extra.at, extra.anchor, extra.side)
        if place is None:
            no_room.append(node_id)
            continue
        location, yaw = place
        item = Furnishing(node_id=node_id, prop=extra.prop, location=location, yaw=yaw, required=False, loose=True)
        added.append(item)
        standing[node_id] = Standing(extra.prop, box_at(location, yaw, PROPS[extra.prop].size))
    draft = rules.propose(replace(view, plan=_with(view.plan, added)))
    return draft.model_copy(update={"dropped": (*draft.dropped, *answer.leave_out, *no_room)})


def _dressed_as_before(view: SetDresserView, rules: RulesSetDresser) -> SetDresserDraft:
    """Return the dressing of the earlier scene in the same place."""
    there = {item.node_id for item in view.before}
    gone = [item.node_id for item in view.plan.furnishings if not item.required and item.node_id not in there]
    added = [
        Furnishing(
            node_id=item.node_id, prop=item.asset_id.removeprefix("set_"), location=item.location,
            yaw=item.rotation[2], required=False, loose=True,
        )
        for item in view.before if item.node_id.startswith(ADDED)
    ]  # fmt: skip
    return rules.propose(replace(view, plan=_with(_without(view.plan, gone), added)))


def _without(plan: SetPlan, gone: Collection[str]) -> SetPlan:
    """Return a plan without some furnishings, and without what stood on them."""
    standing = [PlacedFurnishing.of(item, None) for item in plan.furnishings]
    left = {*gone, *(item.item.node_id for item in standing if has_lost_support(item, standing, {*gone}))}
    kept = tuple(item for item in plan.furnishings if item.node_id not in left)
    return plan.model_copy(update={"furnishings": kept})


def _with(plan: SetPlan, added: Sequence[Furnishing]) -> SetPlan:
    """Return a plan with more furnishings."""
    return plan.model_copy(update={"furnishings": (*plan.furnishings, *added)})


def _standing(draft: SetDresserDraft, view: SetDresserView) -> dict[str, Standing]:
    """Return what stands in a dressed set, by node id."""
    assets = {asset.asset_id: asset for asset in (*draft.assets, *view.objects)}
    found = ((item, assets[item.asset_id]) for item in draft.objects)
    return {
        item.node_id: Standing(prop_of(asset), box_at(item.location, item.rotation[2], size_of_asset(asset)))
        for item, asset in found
    }


def _wrong(
    answer: DressingNotes, view: SetDresserView, planned: SetDresserDraft, offered: Collection[str]
) -> Iterator[str]:
    """Yield what no schema can say of an answer: props and furnishings that do not exist, or cannot be there."""
    furnishings = {item.node_id: item for item in view.plan.furnishings}
    standing = _standing(planned, view)
    for node_id in answer.leave_out:
        item = furnishings.get(node_id)
        if item is None:
            yield f"there is no furnishing {node_id!r} to leave out"
        elif item.required:
            yield f"{node_id} is needed; leave it where it is"
    for extra in answer.add:
        base = standing.get(extra.anchor or "")
        if extra.prop not in offered:
            yield f"there is no prop {extra.prop!r} in `props`"
        elif extra.at in _BY and base is None:
            yield f"{extra.prop} is {extra.at} {extra.anchor!r}, which is no id of `furnishings`"
        elif extra.at == "on" and base is not None and base.prop not in TOPS:
            yield f"nothing can be put on {extra.anchor}; take a furnishing with a `top`, or put {extra.prop} beside it"
        elif (extra.at == "on_wall") != (PROPS[extra.prop].placement == "wall"):
            hung = "hangs on a wall" if extra.at != "on_wall" else "does not hang on a wall"
            yield f"{extra.prop} {hung}"
        elif extra.at == "on" and PROPS[extra.prop].placement != "surface":
            yield f"{extra.prop} stands on the floor, not on {extra.anchor}"


def _shown(view: SetDresserView, planned: SetDresserDraft, offered: Collection[PropEntry]) -> dict[str, Any]:
    """Return what a model is shown of a set; no metres, so that a larger set of the kit asks nothing new."""
    needed = {item.node_id for item in view.plan.furnishings if item.required}
    kit = SETS[view.plan.kit]
    return {
        "place": view.setup.place,
        "looks": kit.description or kit.name,
        "hour": view.setup.time_of_day,
        "period": view.period,
        "people_at_once": view.people,
        "story": story_lines(view.outline),
        "things_of_the_script": [
            asset.name or asset.asset_id for asset in view.objects if asset.asset_id not in view.setup.scenery
        ],
        "furnishings": [
            {"id": node_id, "prop": each.prop, "where": _where(each, view.plan)}
            | ({"needed": True} if node_id in needed or not node_id.startswith("set_") else {})
            | ({"top": True} if each.prop in TOPS else {})
            for node_id, each in _standing(planned, view).items()
        ],
        "props": {
            place: [entry.key for entry in offered if entry.placement == place]
            for place in ("floor", "surface", "wall")
        },
    }


def _where(each: Standing, plan: SetPlan) -> str:
    """Return in which part of the set a thing is: thirds across and along, and whether it is off the floor."""
    size, box = plan.size, each.box
    across = ("left", "middle", "right")[_third(box.x, size.x_negative, size.x)]
    along = ("front", "centre", "back")[_third(box.y, size.y_negative, size.y)]
    height = "" if box.z < 0.3 else " on top of something" if box.z < 1.0 else " on the wall or hanging"
    return f"{along} {across}{height}"


def _third(value: float, low: float, high: float) -> int:
    return min(2, max(0, int(3 * (value - low) / max(high - low, 1e-6))))

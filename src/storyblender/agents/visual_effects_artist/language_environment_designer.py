"""The Environment Designer played by a language model: it chooses the kit, its options and its size in metres."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

from pydantic import Field

from storyblender.agents.asking import Asker, LanguagePolicy, Notes
from storyblender.agents.nearest import nearest_entries
from storyblender.agents.story_lines import story_lines
from storyblender.agents.visual_effects_artist.environment_designer import (
    EnvironmentDesignerView,
    RulesEnvironmentDesigner,
    needed_size,
    with_size,
)
from storyblender.catalog.sets import SETS, SetKit, Span
from storyblender.catalog.sets.drawing import Period
from storyblender.catalog.sets.period import period_of
from storyblender.memory.base import Identifier, scene_name
from storyblender.memory.scene_context import Environment
from storyblender.ports import Answerer, Embedder
from storyblender.reflection import Policy

_KITS = 10
"""Kits of the catalogue that a request offers."""


class SetNotes(Notes):
    """The set of a scene. What is left out stays as the view has it in `planned`."""

    kit: Identifier | None = None
    """Key of a kit in `kits`."""
    options: tuple[Identifier, ...] | None = None
    """Options of the kit that are on; an empty list turns all of them off."""
    period: Period | None = None
    """When the place was furnished: past is before electric light, classic about 1900 to 1970."""
    snow: bool | None = None
    """Whether snow lies on the ground."""
    width: float | None = Field(default=None, gt=0)
    """Metres from left to right, within the kit's limits."""
    depth: float | None = Field(default=None, gt=0)
    """Metres from front to back, within the kit's limits."""
    height: float | None = Field(default=None, gt=0)
    """Metres to the ceiling, within the kit's limits; rooms only."""


def language_environment_designer(
    answerer: Answerer, embedder: Callable[[], Embedder]
) -> Policy[EnvironmentDesignerView, Environment]:
    """Return the Environment Designer played by a model; a place that has its set already keeps it.

    Rules fill what an answer leaves out, and apply the critic's numbers.

    Args:
        answerer: The model, or a person in its place.
        embedder: Likeness of meaning; chooses the kits of a request.
    """
    rules = RulesEnvironmentDesigner()

    def offered(view: EnvironmentDesignerView) -> dict[str, SetKit]:
        lines = [line for shot in story_lines(view.outline) for line in shot["lines"]]
        fitting = [kit for kit in SETS.values() if kit.indoor == (view.setup.scene_type == "indoor")]
        near = nearest_entries(fitting, [view.setup.place.lower(), *lines], embedder(), _KITS)
        return {kit.key: kit for kit in (SETS[view.setup.kit], *near)}

    def check(answer: SetNotes, view: EnvironmentDesignerView) -> Iterator[str]:
        kits = offered(view)
        key = answer.kit or view.setup.kit
        if key not in kits:
            yield f"there is no kit {key!r} in `kits`; take one of {', '.join(kits)}"
            return
        known = kits[key].options
        for option in answer.options or ():
            if option not in known:
                yield f"the kit {key!r} has no option {option!r}; it has: {', '.join(known) or 'none'}"

    return LanguagePolicy(
        Asker(answerer, "environment_designer", SetNotes),
        show=lambda view: _shown(view, offered(view), rules.propose(view)),
        check=check,
        draft_of=lambda answer, view: _environment(answer, view, rules),
        subject=lambda view: scene_name(view.outline.scene_id) if view.outline is not None else "",
        mend=rules.refine,
        settled=lambda view: rules.propose(view) if view.reference is not None else None,
    )


def _environment(answer: SetNotes, view: EnvironmentDesignerView, rules: RulesEnvironmentDesigner) -> Environment:
    """Return the rules' environment with what the answer says."""
    kit = SETS[answer.kit or view.setup.kit]
    told = {"kit": kit.key, "snow": answer.snow, "set_options": () if kit.key != view.setup.kit else None}
    chosen = view.setup.model_copy(update={name: value for name, value in told.items() if value is not None})
    draft = rules.propose(replace(view, setup=chosen))
    params = dict(draft.params)
    if answer.options is not None:
        params |= {name: name in answer.options for name in kit.options}
    if answer.period is not None:
        params["period"] = answer.period
    if answer.height is not None:
        params["height"] = kit.height.clamp(answer.height)
    width, depth = answer.width or float(params["width"]), answer.depth or float(params["depth"])
    return with_size(draft.model_copy(update={"params": params}), width, depth)


def _shown(view: EnvironmentDesignerView, kits: dict[str, SetKit], planned: Environment) -> dict[str, Any]:
    """Return what a model is shown of a scene; ``planned`` is the environment of the rules."""
    setup = view.setup
    width, depth = needed_size(view, SETS[setup.kit])
    return {
        "place": setup.place,
        "scene_type": setup.scene_type,
        "hour": setup.time_of_day,
        "weather": setup.weather,
        "age_of_the_story": view.age or "not told",
        "people_at_once": view.people,
        "longest_walk": view.travel,
        "story": story_lines(view.outline),
        "planned": {
            "kit": planned.kit,
            "options": list(setup.set_options),
            "period": planned.params.get("period", period_of(SETS[setup.kit], view.age)),
            "snow": setup.snow,
            "needs": {"width": width, "depth": depth},
        },
        "kits": [_shown_kit(kit) for kit in kits.values()],
    }


def _shown_kit(kit: SetKit) -> dict[str, Any]:
    """Return a kit as a model is shown it."""

    def metres(span: Span) -> str:
        return f"{span.least} to {span.most}, usually {span.usual}"

    words = dict.fromkeys((kit.name.lower(), *kit.tags[:6]))
    size = {"width": metres(kit.width), "depth": metres(kit.depth)}
    size |= {"height": metres(kit.height)} if kit.indoor else {}
    options = {"options": list(kit.options)} if kit.options else {}
    return {"key": kit.key, "looks": kit.description or ", ".join(words), "period": kit.period, **options, **size}

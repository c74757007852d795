"""Errors of 100 corrupted layouts over five turns of reflection, naive and physical (paper, table of layout errors).

The layouts are those of the examples and the working pages (``corrupted_layouts.py``). Turn 1 is the corrupted layout.

* **physical**: the critic's moves and turns, in metres and degrees, are applied by code and the layout is solved again.
* **naive**: no spatial context from the engine, as in the paper. The policy is told which thing has which kind of
  error, knows what the words mean, how large things are and where it put them itself, but neither by how much it is
  wrong nor what else is there. What a model would write down in one go is drawn at random: another quarter turn, a
  place on the named side of the anchor, a step of 0.3 to 1 m. What needs no geometry is right at once: on the floor is
  at height 0, on a table is at the height of its box.

Run it with ``python -m benchmarks layout_reflection``; ``--short`` takes the examples only.
"""

from __future__ import annotations

import argparse
import math
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from benchmarks.corrupted_layouts import (
    CorruptedLayout,
    corrupted_layouts,
    free_things,
    item_of,
    put,
)
from benchmarks.staged_scenes import EXAMPLES, PAGES, staged_scenes

from storyblender.agents.layout_artist.spatial_planner import RulesSpatialPlanner, SpatialPlannerCritic
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.geometry.relations import BEARING
from storyblender.memory.scene_context import Layout
from storyblender.reflection import Critique, Policy, Role, Typed, reflect

TURNS = 5
ERRORS: Mapping[str, frozenset[str]] = {
    "direction": frozenset({"direction"}),
    "relation": frozenset({"relationship"}),
    "overlap": frozenset({"penetration", "bounds"}),
    "contact": frozenset({"contact", "no_contact", "support", "overhang", "floor"}),
}
"""Kinds of faults of each kind of error in the paper's table; its O, occlusion, is boxes that penetrate each other."""
Count = Counter[str]


@dataclass(frozen=True)
class _FromDraft:
    """A policy whose first draft is given."""

    draft: Layout
    policy: Callable[[Layout, Critique, SpatialPlannerView], Layout]

    def propose(self, view: SpatialPlannerView) -> Layout:
        """Return the given draft."""
        return self.draft

    def refine(self, draft: Layout, critique: Critique, view: SpatialPlannerView) -> Layout:
        """Return the policy's next draft."""
        return self.policy(draft, critique, view)


@dataclass(frozen=True)
class _Counting:
    """The Spatial Planner's critic, counting errors."""

    counts: list[Count] = field(default_factory=list)

    def judge(self, draft: Layout, view: SpatialPlannerView) -> Critique:
        """Judge and count."""
        critique = SpatialPlannerCritic().judge(draft, view)
        self.counts.append(count_errors(critique))
        return critique


def count_errors(critique: Critique) -> Count:
    """Return the number of errors of each kind, and of ``other`` ones: cut off from every door, left out."""
    kind_of = {kind: error for error, kinds in ERRORS.items() for kind in kinds}
    return Counter(kind_of.get(fault.kind, "other") for fault in critique.faults)


def physical(draft: Layout, critique: Critique, view: SpatialPlannerView) -> Layout:
    """Return the draft with the critic's fixes applied, solved again."""
    return RulesSpatialPlanner().refine(draft, critique, view)


class Naive:
    """Mends what it is told without knowing by how much.

    Args:
        seed: Of what it draws.
    """

    def __init__(self, seed: int) -> None:
        self._rng = np.random.default_rng((seed, 1))

    def __call__(self, draft: Layout, critique: Critique, view: SpatialPlannerView) -> Layout:
        """Return the draft with each thing that has an error drawn anew."""
        for fault in critique.faults:
            if any(item.node_id == fault.subject for item in free_things(draft, view)):
                draft = self._mended(draft, fault.kind, fault.subject, view)
        return draft

    def _mended(self, draft: Layout, kind: str, name: str, view: SpatialPlannerView) -> Layout:
        item, rng = item_of(draft, name), self._rng
        x, y, z = item.location
        anchor = next((each for each in draft.objects if each.node_id == item.anchor_asset_id), None)
        match kind:
            case "direction":
                return put(draft, name, item.location, item.rotation[2] + float(rng.choice((90, 180, 270))))
            case "floor":
                return put(draft, name, (x, y, 0.0))
            case "support" if anchor is not None:
                return put(draft, name, (x, y, anchor.location[2] + view.measures[anchor.asset_id].dimensions[2]))
            case "overhang" if anchor is not None:
                return put(draft, name, (*anchor.location[:2], z))
            case "relationship" if anchor is not None:
                angle = BEARING[item.relationship or ""] + math.radians(float(rng.uniform(-30, 30)))
                apart = float(rng.uniform(0.5, 2.0))
                ax, ay, _ = anchor.location
                return put(draft, name, (ax + apart * math.cos(angle), ay + apart * math.sin(angle), z))
            case "contact" | "no_contact" if anchor is not None:
                angle = math.atan2(y - anchor.location[1], x - anchor.location[0])
                step = float(rng.uniform(0.1, 0.5)) * (-1 if kind == "contact" else 1)
                return put(draft, name, (x + step * math.cos(angle), y + step * math.sin(angle), z))
            case "bounds":
                step = float(rng.uniform(0.3, 1.0)) / max(math.hypot(x, y), 0.01)
                return put(draft, name, (x - x * step, y - y * step, z))
            case _:
                angle, step = float(rng.uniform(-math.pi, math.pi)), float(rng.uniform(0.3, 1.0))
                return put(draft, name, (x + step * math.cos(angle), y + step * math.sin(angle), z))


def errors_by_turn(
    broken: CorruptedLayout, policy: Callable[[Layout, Critique, SpatialPlannerView], Layout]
) -> list[Count]:
    """Return the errors of a corrupted layout at each turn; a layout that was accepted keeps its count.

    Args:
        broken: The layout.
        policy: Refines it.
    """
    critic = _Counting()
    author: Policy[SpatialPlannerView, Layout] = _FromDraft(broken.layout, policy)
    role = Role[[], SpatialPlannerView, Layout](
        "spatial_planner", lambda: broken.view, (author,), critic, Typed(Layout), 9.9, TURNS - 1
    )
    reflect(role, broken.name, broken.view)
    return [critic.counts[min(turn, len(critic.counts) - 1)] for turn in range(TURNS)]


def table(broken: Sequence[CorruptedLayout]) -> Iterator[str]:
    """Yield the lines of the table: errors a thing, by method, kind and turn."""
    things = sum(len(free_things(each.layout, each.view)) for each in broken)
    yield f"{len(broken)} layouts, {things} things; errors a thing, and layouts with any"
    yield f"{'method':<10}{'error':<12}" + "".join(f"{f'turn {turn + 1}':>9}" for turn in range(TURNS))
    for method, policy_of in (("naive", Naive), ("physical", lambda seed: physical)):
        counts = [errors_by_turn(each, policy_of(each.seed)) for each in broken]
        for error in (*ERRORS, "other"):
            sums = [sum(turns[turn][error] for turns in counts) for turn in range(TURNS)]
            yield f"{method:<10}{error:<12}" + "".join(f"{each / things:>9.3f}" for each in sums)
        left = [sum(bool(turns[turn].total()) for turns in counts) for turn in range(TURNS)]
        yield f"{method:<10}{'layouts':<12}" + "".join(f"{each:>9}" for each in left)


def main() -> None:
    """Stage the scenes, corrupt their layouts, and print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--layouts", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0, help="the first one")
    parser.add_argument("--short", action="store_true", help="only the examples")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        scripts = EXAMPLES if arguments.short else (*EXAMPLES, *PAGES)
        scenes = [scene for script in scripts for scene in staged_scenes(script, Path(folder) / script.stem)]
    for line in table(corrupted_layouts(scenes, arguments.layouts, arguments.seed)):
        print(line, flush=True)


if __name__ == "__main__":
    main()

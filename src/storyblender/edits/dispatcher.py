"""The one way in for edits: a batch is checked against the graph and becomes one commit, so one undo."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Final

from storyblender.edits.approving import approved_by, refuse_changed
from storyblender.edits.by_hand_edits import refuse_unknown_motions
from storyblender.edits.conflicts import refuse_stale
from storyblender.edits.effect import Effect, name_of, with_effects
from storyblender.edits.families import effects_of
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Frozen
from storyblender.memory.edits import AssetEdit, Edit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.plain_words import names_of, plain
from storyblender.project import Project

PRINTED: Final = frozenset({"notes", "approval", "cut", "name"})
"""Aspects that the deliverables show without a new frame."""
_GUARDED: Final = frozenset({"camera", "blocking", "layout", "duration", *PRINTED})
"""Aspects that a lock or an approval refuses to touch where the shot would look otherwise."""
_NAMED = 4
"""Most items whose names a sentence lists."""


class Applied(Frozen):
    """What a batch of edits did.

    Attributes:
        version: Of the project now; the next edit names it.
        words: What was done, as the history has it.
        stale: Names of the shots whose frames show something else now; nothing else is drawn anew.
        printed: Whether board, page and lists show something else now, such as a note, besides those frames.
        warnings: What a person should know of it, such as what a thing that they placed stands in.
    """

    version: str
    words: str
    stale: tuple[str, ...]
    printed: bool = False
    warnings: tuple[str, ...] = ()

    def followed_by(self, later: Applied) -> Applied:
        """Return what two batches did, one after the other."""
        return Applied(
            version=later.version,
            words=f"{self.words}; {later.words}",
            stale=tuple(dict.fromkeys((*self.stale, *later.stale))),
            printed=self.printed or later.printed,
            warnings=tuple(dict.fromkeys((*self.warnings, *later.warnings))),
        )


def apply_edits(project: Project, edits: Sequence[Edit], version: str | None = None, author: str = "user") -> Applied:
    """Commit a batch of edits: all of them or none.

    Args:
        project: Open.
        edits: In order; a later one sees what an earlier one did.
        version: What they were made on; None for the present one.
        author: Whose they are, for the history.

    Raises:
        InputError: An edit names what does not exist or cannot be, or what is locked.
        StaleEdit: What they touch has changed since that version.
        Rejected: The Gatekeeper refused.
    """
    refuse_unknown_motions(project, edits)
    graph, effects = project.graph, list[Effect]()
    for edit in edits:
        done = effects_of(graph, edit)
        graph = with_effects(graph, done)
        effects += done
    refuse_changed(approved_by(edits), effects)
    if version is not None:
        refuse_stale(project, version, {(each.name, aspect) for each in effects for aspect in each.aspects})
    names = names_of(project.graph) | names_of(graph)
    words = "; ".join(
        f"{_listed([names.get(each.name, each.name) for each in same])}: {plain(said, names)}"
        for said, same in groupby(effects, lambda each: each.words)
    )
    before = project.graph
    project.commit(graph, author, words)
    there = {name_of(shot) for shot in graph.shots if not shot.joined}
    stale = dict.fromkeys(name for each in effects for name in each.stale if name in there)
    printed = any(each.aspects & PRINTED for each in effects)
    said = [*_approved_and_changed(before, effects), *(each for effect in effects for each in effect.warnings)]
    warnings = tuple(dict.fromkeys(plain(each, names) for each in said))
    return Applied(version=project.version, words=words, stale=tuple(stale), printed=printed, warnings=warnings)


def given_models(graph: ContinuityMemoryGraph, edits: Sequence[Edit]) -> list[Asset]:
    """Return the things and people that edits have made from a model that they name, as they will be decided.

    Args:
        graph: The story as it is.
        edits: In order; none is made.

    Raises:
        InputError: An edit names what does not exist or cannot be, or what is locked.
    """
    files = {edit.file for edit in edits if isinstance(edit, AssetEdit) and edit.file is not None}
    if not files:
        return []
    before = {asset.asset_id: asset for asset in graph.assets}
    for edit in edits:
        graph = with_effects(graph, effects_of(graph, edit))
    changed = [asset for asset in graph.assets if asset != before.get(asset.asset_id)]
    return [asset for asset in changed if asset.decision is not None and asset.decision.file in files]


def _approved_and_changed(graph: ContinuityMemoryGraph, effects: Sequence[Effect]) -> Iterator[str]:
    """Yield what to know of shots that were approved, and get another light, set, format or look."""
    approved = {name_of(shot) for shot in graph.shots if shot.approved is not None and not shot.omitted}
    touched = dict.fromkeys(name for each in effects if not each.aspects & _GUARDED for name in each.stale)
    if changed := [name for name in touched if name in approved]:
        yield f"{_listed(changed)} {'was' if len(changed) == 1 else 'were'} approved and may look otherwise now"


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names) if len(names) <= _NAMED else f"{names[0]} to {names[-1]} ({len(names)} shots)"

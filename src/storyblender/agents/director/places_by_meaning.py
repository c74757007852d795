"""Chooses the set of a place that no word list knows, by word similarity to the set kits, and flags the guess."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np

from storyblender.agents.director.kit_choice import FALLBACK, names_a_kit
from storyblender.agents.director.kit_evidence import kit_of_things
from storyblender.agents.director.reading import Reading, SceneReading
from storyblender.agents.director.rules import rule
from storyblender.catalog.sets import SETS, SetKit
from storyblender.memory.shot_context import Flag
from storyblender.ports import Embedder

_MIN_SIMILARITY: Final = 0.43
"""Least similarity of a place to a kit; below it the plain room or open ground stays."""
_MARGIN: Final = 0.03
"""Least lead in similarity of the best kit over the second."""
_TAGS: Final = 6
"""Number of a kit's strongest tags that are compared one by one."""
_TEXT: Final = 400
"""Characters of a scene's action text that are compared."""
_WEIGHTS: Final = (0.5, 0.2, 0.5)
"""Weights of: place to nearest tag, place to kit, and scene text to kit."""


def choose_kits_by_meaning(reading: Reading, load: Callable[[], Embedder]) -> None:
    """Give each scene of unknown place the most similar set kit, and flag the guess.

    Args:
        reading: The reading; its scenes and flags are changed.
        load: Loads the sentence embedder; called only if a place is unknown.
    """
    unknown = [
        (index, scene)
        for index, scene in enumerate(reading.scenes)
        if scene.reference is None and not names_a_kit(scene)
    ]
    by_meaning = [(index, scene) for index, scene in unknown if not _choose_by_things(reading, index, scene)]
    named = [(index, scene) for index, scene in by_meaning if scene.place]
    if not named:
        return
    kits = [kit for kit in SETS.values()]
    scores = _similarities(
        kits, [scene.place for _, scene in named], [_meaning_text(reading, i) for i, _ in named], load()
    )
    for (_, scene), row in zip(named, scores, strict=True):
        indoor = scene.scene_type == "indoor"
        ranked = sorted((-score, kit.key) for score, kit in zip(row, kits, strict=True) if kit.indoor == indoor)
        (best, key), (second, _) = ranked[0], ranked[1]
        sure = -best >= _MIN_SIMILARITY and second - best >= _MARGIN
        chosen = key if sure else FALLBACK[scene.scene_type]
        if sure:
            scene.place_kind = key
        reason = f"“{scene.place}” is no place that the library knows; {SETS[chosen].name.lower()} stands in"
        reading.flags.append(Flag(topic="place", choice=chosen, reason=reason, start=scene.start, end=scene.end))
    _copy_to_same_place(reading)


@rule("place.kit_by_things", without=False)
def _choose_by_things(reading: Reading, index: int, scene: SceneReading) -> bool:
    """Choose a scene's kit by the things in it; False if they are too few."""
    indoor = scene.scene_type == "indoor"
    told = kit_of_things([_meaning_text(reading, index)], [kit.key for kit in SETS.values() if kit.indoor == indoor])
    if told is not None and not scene.place_kind:
        scene.place_kind = told
    return told is not None


def _copy_to_same_place(reading: Reading) -> None:
    """Copy the kit of a place to all scenes in the same place."""
    kinds = {scene.id: scene.place_kind for scene in reading.scenes}
    for scene in reading.scenes:
        first = kinds.get(scene.reference or 0)
        if first and not names_a_kit(scene):
            scene.place_kind = first


def _meaning_text(reading: Reading, index: int) -> str:
    """Return the words of a scene that are compared with the kits."""
    told = [unit.text for unit in reading.units if unit.scene == index and unit.kind == "action"]
    return " ".join(" ".join(told).split())[:_TEXT] or reading.scenes[index].place


def _similarities(kits: list[SetKit], places: list[str], texts: list[str], embedder: Embedder) -> np.ndarray:
    """Return the similarity of each place (row) to each kit (column)."""
    words = [(index, tag) for index, kit in enumerate(kits) for tag in (kit.name.lower(), *kit.tags[:_TAGS])]
    owners = np.array([index for index, _ in words])
    near = embedder.embed(places) @ embedder.embed([tag for _, tag in words]).T
    tags = np.stack([near[:, owners == index].max(axis=1) for index in range(len(kits))], axis=1)
    described = embedder.embed([f"{kit.name}: {', '.join(kit.tags)}" for kit in kits])
    tag, kit, text = _WEIGHTS
    return tag * tags + kit * embedder.embed(places) @ described.T + text * embedder.embed(texts) @ described.T

"""The Instructor played by a language model: it knows the words that the rules do not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from storyblender.agents.asking import Asker, LanguagePolicy
from storyblender.agents.instructor.instructor import Instruction, InstructorView
from storyblender.agents.nearest import nearest_entries
from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.props import PROPS
from storyblender.catalog.sets import SETS
from storyblender.catalog.sets.finishes import FINISHES
from storyblender.ports import Answerer, Embedder

_KITS, _PROPS = 8, 24
"""Entries of the catalogue that a request offers."""


def language_instructor(
    answerer: Answerer, embedder: Callable[[], Embedder]
) -> LanguagePolicy[InstructorView, Instruction, Instruction]:
    """Return the policy: one request for the words of a person.

    Args:
        answerer: Who answers.
        embedder: Likeness of meaning; chooses the kits and props of a request.
    """
    return LanguagePolicy(
        Asker(answerer, "instructor", Instruction), lambda view: _shown(view, embedder), lambda answer, view: answer,
        subject=lambda view: view.shots[0].name if view.shots else "",
    )  # fmt: skip


def _shown(view: InstructorView, embedder: Callable[[], Embedder]) -> dict[str, Any]:
    """Return what the model is shown: the words, shots and scenes as they are, who and what there is and could be."""
    shots = [
        {
            "shot": shot.name, "camera": shot.camera.model_dump(mode="json", exclude_defaults=True),
            "size": shot.camera.size, "angle": shot.camera.angle, "lens": round(shot.lens),
            "seconds": round(shot.frames / view.fps, 2), "on_stage": shot.on_stage,
        }
        for shot in view.shots
    ]  # fmt: skip
    scenes = [scene.model_dump(mode="json", exclude_defaults=True) for scene in view.scenes]
    shown: dict[str, Any] = {"words": view.words, "shots": shots, "people_and_things": dict(view.names)}
    if not scenes:
        return shown
    indoor = {scene.indoor for scene in view.scenes}
    kits = nearest_entries([kit for kit in SETS.values() if kit.indoor in indoor], [view.words], embedder(), _KITS)
    props = nearest_entries(PROPS.values(), [view.words], embedder(), _PROPS)
    return shown | {
        "scenes": scenes,
        "kits": {kit.key: list(kit.options) for kit in kits},
        "props": [prop.name for prop in props],
        "materials": [*FINISHES, *MATERIALS],
    }

"""The Instructor played by a language model: it knows the words that the rules do not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from storyblender.agents.asking import Asker, LanguagePolicy
from storyblender.agents.instructor.instructor import Instruction, InstructorView
from storyblender.ports import Answerer, Embedder


def language_instructor(
    answerer: Answerer, embedder: Callable[[], Embedder]
) -> LanguagePolicy[InstructorView, Instruction, Instruction]:
    """Return the policy: one request for the words of a person.

    Args:
        answerer: Who answers.
        embedder: Not needed.
    """
    return LanguagePolicy(
        Asker(answerer, "instructor", Instruction), _shown, lambda answer, view: answer,
        subject=lambda view: view.shots[0].name if view.shots else "",
    )  # fmt: skip


def _shown(view: InstructorView) -> dict[str, Any]:
    """Return what the model is shown: the words, the shots as they are, who and what there is."""
    shots = [
        {
            "shot": shot.name, "camera": shot.camera.model_dump(mode="json", exclude_defaults=True),
            "size": shot.camera.size, "angle": shot.camera.angle, "lens": round(shot.lens),
            "seconds": round(shot.frames / view.fps, 2), "on_stage": shot.on_stage,
        }
        for shot in view.shots
    ]  # fmt: skip
    return {"words": view.words, "shots": shots, "people_and_things": dict(view.names)}

"""Retakes: a frame that does not tell its lines is taken again with another camera, and the better take is kept."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Final

from storyblender.memory.base import shot_name
from storyblender.memory.shot_context import CameraDecision, ShotContext
from storyblender.memory.vocabulary import SHOT_SIZES
from storyblender.pipeline.filming import film
from storyblender.pipeline.reviewing import FrameReview, review_frames
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import shoot_frames

_WIDER: Final = ("person_missing", "people_missing", "face_out", "thing_missing", "nothing")
_TIGHTER: Final = ("person_small", "flat", "void", "dark")
_AROUND: Final = ("person_hidden", "face_hidden", "face_away", "foreground")
_UNSEEN: Final = ("person_missing", "people_missing", "thing_missing")
_GAIN: Final = 0.5
"""Least gain in score for which a retake replaces the take before it."""
_RETAKES: Final = 2
"""Most retakes of one shot."""


def retake_poor_frames(run: Run, shots: Collection[ShotContext]) -> dict[str, FrameReview]:
    """Judge frames, and retake those that another camera may fix; cameras set by the script or the user stay.

    A shot is tried once: it keeps what was changed, nothing where its first take was the best, and a later run leaves
    it as it is.

    Args:
        run: The run, with all frames drawn.
        shots: The shots to judge.

    Returns:
        The review of the kept take, by shot name.
    """
    keys = [(shot.scene_id, shot.shot_id) for shot in shots]
    reviews = review_frames(run, [run.graph.shot(*key) for key in keys])
    # In another look, or after an undo, the project is drawn without retakes.
    may_retake = run.settings.look == run.made_in_look and not run.project.has_undone
    untried = [key for key in keys if run.graph.shot(*key).camera_retake is None]
    for attempt in range(_RETAKES if may_retake else 0):
        present = [run.graph.shot(*key) for key in untried]
        again = {
            shot_name(shot.scene_id, shot.shot_id): (shot, choice)
            for shot in present
            if (choice := _another_camera(shot, reviews[shot_name(shot.scene_id, shot.shot_id)], attempt)) is not None
        }
        if again:
            reviews |= _taken_again(run, again, reviews)
    return reviews


def _taken_again(
    run: Run, again: Mapping[str, tuple[ShotContext, CameraDecision]], before: Mapping[str, FrameReview]
) -> dict[str, FrameReview]:
    """Retake shots, and restore the takes that did not get better; return the reviews of the kept takes."""
    former = [shot for shot, _ in again.values()]
    told = ", ".join(f"{name}: {choice.words}" for name, (_, choice) in again.items())
    run.commit("frame_critic", f"taken again: {told}", *(_with_camera(shot, choice) for shot, choice in again.values()))
    film(run)
    shoot_frames(run, _present(run, former))
    after = review_frames(run, _present(run, former))
    worse = [
        shot.model_copy(update={"camera_retake": shot.camera_retake or CameraDecision()})
        for name, (shot, _) in again.items()
        if after[name].score < before[name].score + _GAIN
    ]
    if worse:
        names = [shot_name(shot.scene_id, shot.shot_id) for shot in worse]
        run.commit("frame_critic", f"the take before is better: {', '.join(names)}", *worse)
        shoot_frames(run, _present(run, worse))
        after |= {name: before[name] for name in names}
    return after


def _present(run: Run, shots: Sequence[ShotContext]) -> list[ShotContext]:
    return [run.graph.shot(shot.scene_id, shot.shot_id) for shot in shots]


def _with_camera(shot: ShotContext, choice: CameraDecision) -> ShotContext:
    return shot.model_copy(
        update={
            "camera_instruction": choice.applied(shot.camera_instruction),
            "camera_retake": (shot.camera_retake or CameraDecision()).then(choice),
            "camera": None,
            "lights": (),
        }
    )


def _another_camera(shot: ShotContext, review: FrameReview, attempt: int) -> CameraDecision | None:
    """Return a camera that may fix a frame's worst fault; None if the frame passes, or its camera must not change.

    Args:
        shot: The shot as last taken.
        review: The review of that take.
        attempt: Number of retakes so far.
    """
    instruction = shot.camera_instruction
    fixed = shot.camera_decision is not None or "camera" in shot.locked
    faults = [fault for fault in review.faults if fault.kind in (*_WIDER, *_TIGHTER, *_AROUND)]
    if review.verdict == "pass" or fixed or not faults or instruction.kind == "insert":
        return None
    worst = max(faults, key=lambda fault: fault.severity).kind
    if worst in _AROUND and attempt == 0 and instruction.angle == "eye-level":
        return CameraDecision(angle="high angle")
    if instruction.explicit:
        # An ordered size stays: what does not fit in it may be seen from another side, or not at all.
        from_above = attempt == 0 and instruction.angle == "eye-level" and worst in _UNSEEN
        return CameraDecision(angle="high angle") if from_above else None
    step = (1 + attempt) * (1 if worst in _TIGHTER else -1)
    at = SHOT_SIZES.index(instruction.size) + step
    return CameraDecision(size=SHOT_SIZES[at]) if 0 <= at <= SHOT_SIZES.index("CU") else None

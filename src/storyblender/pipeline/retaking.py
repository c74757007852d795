"""Retakes: a frame that does not tell its lines is taken again until it does, and the best take is kept.

First another camera, then another moment of the shot, then a simpler shot: a plain medium shot of the
speaker or actor, or else of the subject. What still fails is on the checklist with its reasons.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Final

from storyblender.agents.frame_critic.frame_view import actions_to_see, speakers
from storyblender.memory.base import shot_name
from storyblender.memory.coverage import filmed
from storyblender.memory.shot_context import CameraRetake, ShotContext
from storyblender.memory.shot_sizes import SHOT_SIZES, SIZES, ShotSize
from storyblender.pipeline.filming import film
from storyblender.pipeline.reviewing import FrameReview, foresee_frames, review_frames
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import shoot_frames

_WIDER: Final = (
    "person_missing",
    "people_missing",
    "face_out",
    "thing_missing",
    "nothing",
    "partner_missing",
    "no_shoulder",
)
_TIGHTER: Final = ("person_small", "thing_small", "flat", "void", "dark")
_AROUND: Final = ("person_hidden", "headless", "face_hidden", "foreground", "inside")
_PASSING: Final = ("face_away", "backs", "face_hidden", "person_hidden", "person_missing", "thing_missing", "nothing")
"""Faults that may be gone at another moment of the shot."""
_CROWDED: Final = ("person_missing", "people_missing", "person_small", "person_hidden", "apart", "backs", "void",
                   "foreground", "face_hidden", "face_out", "face_away", "nothing", "inside", "headless")  # fmt: skip
"""Faults of pictures that hold too much: a simpler one has fewer of them."""
_UNSEEN: Final = ("person_missing", "people_missing", "thing_missing")
_GAIN, _GAIN_FROM_ABOVE = 0.5, 1.5
"""Least gain in points for which a retake replaces the take before it: people look worse from above."""


def retake_poor_frames(run: Run, shots: Collection[ShotContext]) -> dict[str, FrameReview]:
    """Judge frames, and retake those that fail until they pass; cameras set by the script or the user stay.

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
    for step in _STEPS if may_retake else ():
        present = [(shot, filmed(run.graph, shot)) for shot in (run.graph.shot(*key) for key in untried)]
        again = {
            shot_name(shot.scene_id, shot.shot_id): (shot, choice)
            for shot, seen in present
            if (choice := _choice(step, seen, _mendable(run, seen, reviews))) is not None
        }
        if again:
            reviews |= _taken_again(run, again, reviews)
    return reviews


def _mendable(run: Run, shot: ShotContext, reviews: Mapping[str, FrameReview]) -> FrameReview:
    """Return a shot's review without the things that no camera can show: they are not in the set, nor in a hand."""
    review = reviews[shot_name(shot.scene_id, shot.shot_id)]
    layout = run.graph.scene(shot.scene_id).layout
    there = {item.asset_id for item in layout.objects} if layout is not None else set[str]()
    there |= {state.asset_id for state in shot.prop_states if state.visible}
    faults = tuple(fault for fault in review.faults if fault.kind != "thing_missing" or fault.subject in there)
    return review.model_copy(update={"faults": faults})


def _taken_again(
    run: Run, again: Mapping[str, tuple[ShotContext, CameraRetake]], before: Mapping[str, FrameReview]
) -> dict[str, FrameReview]:
    """Retake shots, and restore the takes that did not get better; return the reviews of the kept takes.

    Only what may be better by what its camera sees is drawn.
    """
    former = [shot for shot, _ in again.values()]
    told = ", ".join(f"{name}: {choice.words}" for name, (_, choice) in again.items())
    run.commit("frame_critic", f"taken again: {told}", *(_with_camera(shot, choice) for shot, choice in again.values()))
    with run.doing(f"Setting {_counted(again, 'camera')} anew"):
        film(run)
    foreseen = foresee_frames(run, _present(run, former))
    hopeful = [shot for name, (shot, choice) in again.items() if _better(foreseen[name], before[name], choice)]
    with run.doing(f"Taking {_counted(hopeful, 'frame')} again"):
        shoot_frames(run, _present(run, hopeful))
    after = review_frames(run, _present(run, hopeful))
    worse = [
        shot.model_copy(update={"camera_retake": shot.camera_retake or CameraRetake()})
        for name, (shot, choice) in again.items()
        if name not in after or not _better(after[name], before[name], choice)
    ]
    if worse:
        names = [shot_name(shot.scene_id, shot.shot_id) for shot in worse]
        run.commit("frame_critic", f"the take before is better: {', '.join(names)}", *worse)
        with run.doing(f"Keeping the former take of {_counted(worse, 'frame')}"):
            shoot_frames(run, _present(run, worse))
        after |= {name: before[name] for name in names}
    return after


def _counted(things: Collection[object], word: str) -> str:
    return f"{len(things)} {word}{'s' * (len(things) != 1)}"


def _better(after: FrameReview, before: FrameReview, choice: CameraRetake) -> bool:
    """Return whether a retake is worth more than the take before it, also where both have the lowest score.

    One at another moment never is if an action that was seen before is not seen any more.
    """
    if choice.moment is not None and _undone(after) - _undone(before):
        return False
    return after.lost <= before.lost - (_GAIN_FROM_ABOVE if choice.angle == "high angle" else _GAIN)


def _undone(review: FrameReview) -> Counter[str]:
    """Return how many actions of each person a frame does not show."""
    return Counter(fault.subject for fault in review.faults if fault.kind == "not_done")


def _present(run: Run, shots: Sequence[ShotContext]) -> list[ShotContext]:
    return [run.graph.shot(shot.scene_id, shot.shot_id) for shot in shots]


def _with_camera(shot: ShotContext, choice: CameraRetake) -> ShotContext:
    instruction = choice.applied(shot.camera_instruction)
    if choice.focus_on_ids is not None:
        instruction = instruction.model_copy(update={"over_id": None, "axis": None})
    return shot.model_copy(
        update={
            "camera_instruction": instruction,
            "camera_retake": (shot.camera_retake or CameraRetake()).then(choice),
            "moment": choice.moment or shot.moment,
            "camera": None,
            "lights": (),
        }
    )


def _choice(step: _Step, shot: ShotContext, review: FrameReview) -> CameraRetake | None:
    """Return what a step tries for a frame; None if it passes, its camera must not change, or nothing is left to try.

    Args:
        step: One of ``_STEPS``.
        shot: The shot as last taken.
        review: The review of that take.
    """
    fixed = shot.camera_decision is not None or "camera" in shot.locked
    if review.verdict == "pass" or fixed:
        return None
    choice = step(shot, review)
    if choice is None:
        return None
    taken = _with_camera(shot, choice)
    same = taken.camera_instruction == shot.camera_instruction and taken.moment == shot.moment
    return None if same else choice


def _another_camera(shot: ShotContext, review: FrameReview) -> CameraRetake | None:
    """Return a camera from another height or the next size that may fix a frame's worst fault."""
    instruction = shot.camera_instruction
    kinds = (*_WIDER, *_TIGHTER, *_AROUND)
    faults = [fault for fault in review.faults if fault.kind in kinds]
    if not faults or instruction.kind == "insert":
        return None
    fault = max(faults, key=lambda fault: fault.severity)
    worst = fault.kind
    if worst == "partner_missing":
        return CameraRetake(size=_size_for_all(shot)) if fault.subject in shot.on_stage else None
    if worst in _WIDER and instruction.angle == "low angle" and not instruction.explicit:
        return CameraRetake(angle="eye-level")  # a head that is cut off from below
    if worst in _AROUND and instruction.angle == "eye-level":
        return CameraRetake(angle="high angle")
    if instruction.explicit:
        # An ordered size stays: what does not fit in it may be seen from another side, or not at all.
        from_above = instruction.angle == "eye-level" and worst in _UNSEEN
        return CameraRetake(angle="high angle") if from_above else None
    at = SHOT_SIZES.index(instruction.size) + (1 if worst in _TIGHTER else -1)
    return CameraRetake(size=SHOT_SIZES[at]) if 0 <= at <= SHOT_SIZES.index("CU") else None


def _size_for_all(shot: ShotContext) -> ShotSize:
    """Return the tightest size that holds all subjects as far apart as they stand, no tighter than the shot's own."""
    marks = {each.start.asset_id: each.start.location for each in shot.blocking}
    places = [marks[each] for each in shot.camera_instruction.focus_on_ids if each in marks]
    apart = max((math.dist(place[:2], places[0][:2]) for place in places), default=0.0)
    wider: tuple[ShotSize, ...] = SHOT_SIZES[: SHOT_SIZES.index(shot.camera_instruction.size)]
    holding: list[ShotSize] = [size for size in wider if SIZES[size].reach >= apart]
    return holding[-1] if holding else SHOT_SIZES[0]


def _another_moment(shot: ShotContext, review: FrameReview) -> CameraRetake | None:
    """Return the end of the shot, where the crew chose the moment and something is not seen that may be seen then."""
    if shot.moment is not None or not any(fault.kind in _PASSING for fault in review.faults):
        return None
    return CameraRetake(moment="end")


def _simpler(shot: ShotContext, review: FrameReview) -> CameraRetake | None:
    """Return a single of the speaker, or else of the first person to act, or else of the subject."""
    instruction = shot.camera_instruction
    if not _may_be_simpler(shot, review):
        return None
    told = [*speakers(shot), *(action.asset_id for action in actions_to_see(shot))]
    shown = [each for each in told if each in shot.on_stage and each != instruction.pov_id]
    if not shown:
        lead = [each for each in instruction.focus_on_ids if each in shot.on_stage] or [*instruction.focus_on_ids]
        return CameraRetake(kind="single", size="MS", angle="eye-level", focus_on_ids=(lead[0],)) if lead else None
    used = {name for deed in actions_to_see(shot) for name in (deed.prop_id, deed.target_id) if name}
    props = [each for each in instruction.focus_on_ids if each in used and each not in shot.on_stage]
    return CameraRetake(kind="single", size="MS", angle="eye-level", focus_on_ids=(shown[0], *props))


def _may_be_simpler(shot: ShotContext, review: FrameReview) -> bool:
    """Return whether a picture that the script does not order would tell more with less in it."""
    instruction = shot.camera_instruction
    ordered = instruction.explicit or instruction.kind in ("insert", "pov", "establishing")
    return not ordered and any(fault.kind in _CROWDED for fault in review.faults)


_Step = Callable[[ShotContext, FrameReview], CameraRetake | None]
_STEPS: Final[tuple[_Step, ...]] = (_another_camera, _another_moment, _simpler)
"""What is tried for a poor frame, in order; each step starts from the best take so far."""

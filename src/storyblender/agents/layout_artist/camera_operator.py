"""The Camera Operator: a first camera from the floor plan, then the paper's discrete visual servo with the viewfinder.

The paper lets a vision model name one operation a turn. Here the critic's numbers propose the operations, all of them
are looked at in one batch, and the best one is kept; update laws and step sizes are the paper's.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from storyblender.agents.layout_artist.camera_focus import with_focus
from storyblender.agents.layout_artist.camera_furniture import find_covers
from storyblender.agents.layout_artist.camera_operator_critic import CameraOperatorCritic, moments_to_judge
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView
from storyblender.agents.layout_artist.camera_scout import scout_takes, take_cost, with_hidden
from storyblender.agents.layout_artist.camera_start import placed_take, take_with_camera
from storyblender.geometry.camera_path import orbit_of
from storyblender.geometry.continuity import side_of_line
from storyblender.geometry.orbit import Orbit, dolly, orbit, pan, roll
from storyblender.memory.base import shot_name
from storyblender.memory.shot_context import CameraState, Flaw
from storyblender.memory.shot_sizes import SIZES
from storyblender.ports import Viewfinder
from storyblender.reflection import Critique, Fault, Role, Typed, reflect
from storyblender.trace import Event, Listener, silent

_ORBIT, _RISE, _PAN, _ROLL = 15.0, 10.0, 0.08, 4.0
OPERATIONS: dict[str, Callable[[Orbit], Orbit]] = {
    "orbit_left": lambda camera: orbit(camera, -_ORBIT),
    "orbit_right": lambda camera: orbit(camera, _ORBIT),
    "orbit_up": lambda camera: orbit(camera, 0.0, _RISE),
    "orbit_down": lambda camera: orbit(camera, 0.0, -_RISE),
    "pan_left": lambda camera: pan(camera, -_PAN, 0.0),
    "pan_right": lambda camera: pan(camera, _PAN, 0.0),
    "pan_up": lambda camera: pan(camera, 0.0, _PAN),
    "pan_down": lambda camera: pan(camera, 0.0, -_PAN),
    "zoom_in": lambda camera: dolly(camera, 1.0),
    "zoom_out": lambda camera: dolly(camera, -1.0),
    "roll_left": lambda camera: roll(camera, _ROLL),
    "roll_right": lambda camera: roll(camera, -_ROLL),
}
"""The paper's operations and step sizes (appendix, prompt of the Camera Operator)."""

OPERATION_WORDS: dict[str, str] = {
    "orbit_left": "goes 15 degrees around the subject, to the left", "orbit_right": "the same to the right",
    "orbit_up": "goes 10 degrees up around the subject, and looks down more", "orbit_down": "the same down",
    "pan_left": "shifts by 8 % of the picture's height to the left: what is seen moves to the right",
    "pan_right": "the same to the right: what is seen moves to the left",
    "pan_up": "the same up: what is seen moves down", "pan_down": "the same down: what is seen moves up",
    "zoom_in": "goes 15 % nearer, with the same lens", "zoom_out": "goes 15 % farther, with the same lens",
    "roll_left": "leans the horizon by 4 degrees, counter-clockwise", "roll_right": "the same clockwise",
}  # fmt: skip
"""What each operation does."""
FIX_WORDS: dict[str, str] = {
    "azimuth": "degrees around the subject, to the right", "elevation": "degrees up around the subject",
    "dolly": "steps nearer, of 15 % each; farther if below 0",
    "pan_x": "shift to the right, in heights of the picture", "pan_y": "shift up, in heights of the picture",
    "roll": "degrees that the horizon leans, counter-clockwise",
    "ops": "names of operations to try, separated by spaces",
}  # fmt: skip
"""What the fields of a camera critic's fix mean; code applies them."""

_FIRST, _FIXES, _NEXT = 3, 4, 3
"""Takes that are looked at: of the scout's list at first, of the fixes, and of the list if no fix helps."""
CAMERA_THRESHOLD = 9.25
"""Score (tau) from which a take is accepted."""
CAMERA_HORIZON = 3
"""Most refinements (T_max)."""
MODEL_HORIZON = 5
"""The same where a model names the operations or looks at pictures, the paper's."""
_LOOKS = 20
"""Most looks for one shot."""
_MISPLACED = ("inside", "below_floor")
"""Faults of a camera's place; one that a person placed stays, and they are told."""
_ANSWERED = 2
"""Number of the worst faults that one refinement fixes."""


@dataclass(frozen=True)
class RulesCameraOperator:
    """The Camera Operator without a model: greedy steps over the critic's fixes.

    Attributes:
        critic: Its critic, which remembers every look.
    """

    critic: CameraOperatorCritic
    _lists: dict[tuple[int, int], list[CameraOperatorDraft]] = field(default_factory=dict)
    _looks: dict[tuple[int, int], int] = field(default_factory=dict)
    """Looks of a policy before this one, by shot; they do not count."""

    def propose(self, view: CameraOperatorView) -> CameraOperatorDraft:
        """Return the scout's first take, or the best of the first few if that is not good enough."""
        self._looks[view.scene_id, view.shot_id] = self.critic.looks
        first = self.ranked_takes(view)[0]
        if self.critic.judge(first, view).score >= CAMERA_THRESHOLD:
            return first
        best, _ = self._best_take(self.ranked_takes(view)[:_FIRST], view)
        return best or first

    def refine(self, draft: CameraOperatorDraft, critique: Critique, view: CameraOperatorView) -> CameraOperatorDraft:
        """Return the best of the fixed takes, else of the scout's next ones, else the draft itself.

        Args:
            draft: The take so far.
            critique: Its faults with their fixes.
            view: The shot.
        """
        known = self.critic.judged(view)
        fixed = [with_other_camera(view, draft, camera) for camera in _fixed_cameras(draft, critique)]
        fixed = sorted((other for other in fixed if other not in known), key=lambda other: take_cost(view, other))
        if any(fault.kind in ("hidden", "out_of_frame") for fault in critique.faults) and (over := find_covers(view)):
            bare = with_hidden(draft, over)
            fixed = fixed if bare in known else [bare, *fixed]
        best, score = self._best_take(fixed[:_FIXES], view)
        if best is not None and score > critique.score + 0.1:
            return best
        known = self.critic.judged(view)
        best, score = self._best_take([other for other in self.ranked_takes(view) if other not in known][:_NEXT], view)
        return best if best is not None and score > critique.score + 0.02 else draft

    def ranked_takes(self, view: CameraOperatorView) -> list[CameraOperatorDraft]:
        """Return the scout's takes of a shot, computed once."""
        key = view.scene_id, view.shot_id
        if key not in self._lists:
            self._lists[key] = scout_takes(view)
        return self._lists[key]

    def _best_take(
        self, takes: list[CameraOperatorDraft], view: CameraOperatorView
    ) -> tuple[CameraOperatorDraft | None, float]:
        """Return the best of some takes and its score, within the looks left; None if there is none."""
        moments = len(moments_to_judge(view, takes))
        spent = self.critic.looks - self._looks.get((view.scene_id, view.shot_id), 0)
        takes = takes[: max(0, (_LOOKS - spent) // max(moments, 1))]
        if not takes:
            return None, 0.0
        scores = [critique.score for critique in self.critic.judge_all(takes, view)]
        index = max(range(len(takes)), key=lambda each: (scores[each], -each))
        return takes[index], scores[index]


def with_other_camera(view: CameraOperatorView, take: CameraOperatorDraft, camera: Orbit) -> CameraOperatorDraft:
    """Return a take with another camera; what it hides of its own accord stays hidden.

    Args:
        view: The shot.
        take: The take.
        camera: The camera at the story moment.
    """
    needed = take_with_camera(view, take.camera).hidden
    return with_hidden(take_with_camera(view, camera), [node for node in take.hidden if node not in needed])


def _fixed_cameras(draft: CameraOperatorDraft, critique: Critique) -> list[Orbit]:
    """Return the cameras of a critique's fixes: each numeric fix, all of them together, each named operation."""
    cameras: dict[Orbit, None] = {}
    together = draft.camera
    for fault in sorted(critique.faults, key=lambda fault: -fault.severity)[:_ANSWERED]:
        if numbers := numbers_of(fault):
            cameras[apply_numbers(draft.camera, numbers)] = None
            together = apply_numbers(together, numbers)
        for name in str(fault.fix.get("ops", "")).split():
            cameras[OPERATIONS[name](draft.camera)] = None
            cameras[OPERATIONS[name](together)] = None
    cameras[together] = None
    cameras.pop(draft.camera, None)
    return list(cameras)


def numbers_of(fault: Fault) -> dict[str, float]:
    """Return the numbers of a fault's fix."""
    return {name: value for name, value in fault.fix.items() if isinstance(value, float | int)}


def apply_numbers(camera: Orbit, numbers: Mapping[str, float]) -> Orbit:
    """Return a camera changed by the numbers of a fix.

    Args:
        camera: The camera.
        numbers: ``azimuth`` and ``elevation`` in degrees, ``dolly`` in steps, ``pan_x`` and ``pan_y`` in heights of the
            picture, ``roll`` in degrees.
    """
    camera = orbit(camera, numbers.get("azimuth", 0.0), numbers.get("elevation", 0.0))
    camera = dolly(camera, numbers.get("dolly", 0.0))
    camera = pan(camera, numbers.get("pan_x", 0.0), numbers.get("pan_y", 0.0))
    return roll(camera, numbers["roll"]) if "roll" in numbers else camera


CameraRole = Role[..., CameraOperatorView, CameraOperatorDraft]
Operator = Callable[[Viewfinder], CameraRole]
"""Builds the Camera Operator for one shot; its critic looks through the viewfinder and counts its looks."""


def rules_operator(
    viewfinder: Viewfinder, threshold: float = CAMERA_THRESHOLD, horizon: int = CAMERA_HORIZON
) -> CameraRole:
    """Return the Camera Operator without a model, for one shot.

    Args:
        viewfinder: The engine's viewfinder.
        threshold: Score from which a take is accepted (tau).
        horizon: Most refinements (T_max).
    """
    critic = CameraOperatorCritic(viewfinder)
    rules = RulesCameraOperator(critic)
    return Role("camera_operator", CameraOperatorView, (rules,), critic, Typed(CameraOperatorDraft), threshold, horizon)


def operate(
    view: CameraOperatorView, viewfinder: Viewfinder, operator: Operator = rules_operator, listener: Listener = silent
) -> CameraState:
    """Return the camera of a shot with its score and remaining flaws; a camera placed by a person keeps its place.

    Args:
        view: The shot.
        viewfinder: The engine's viewfinder.
        operator: Builds the Camera Operator.
        listener: Receives the trace.
    """
    role = operator(viewfinder)
    if view.asked.placed is not None:
        chosen = placed_take(view, view.asked.placed)
        critique = role.critic.judge(chosen, view)
        name = shot_name(view.scene_id, view.shot_id)
        for fault in critique.faults:
            if fault.kind in _MISPLACED:
                listener(Event(kind="warning", role="camera_operator", subject=name, message=fault.message))
    else:
        outcome = reflect(role, shot_name(view.scene_id, view.shot_id), view, listener)
        chosen, critique = outcome.draft, outcome.critique
    return state_of(view, chosen, critique)


def state_of(view: CameraOperatorView, take: CameraOperatorDraft, critique: Critique) -> CameraState:
    """Return a take as the camera of its shot, focused, with its score and remaining flaws.

    Args:
        view: The shot.
        take: The take.
        critique: Of the take.
    """
    residual = tuple(
        Flaw(kind=fault.kind, subject=fault.subject, weight=fault.severity, message=fault.message)
        for fault in critique.faults
    )
    f_number = SIZES[view.instruction.size].f_number
    return with_focus(view, take.state(view.duration, f_number, critique.score, residual))


def camera_side(view: CameraOperatorView, state: CameraState) -> int:
    """Return the side of the instruction's axis that a camera is on, 1 left or -1 right of the line; 0 for neither.

    Args:
        view: The shot.
        state: Its camera.
    """
    if view.axis is None or view.instruction.kind in ("pov", "insert", "establishing"):
        return 0
    first, second = view.axis
    return side_of_line(orbit_of(state.poses[0], view.film).position, first.face, second.face)

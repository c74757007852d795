"""Corrupted cameras over five turns of the Camera Operator's correction, naive and physical, in real packs.

Every shot of an example is filmed by the rules. The cameras that the critic accepts are corrupted by seed
(``corrupted_cameras.py``), and corrected from there; the viewfinder is Blender's. Turn 0 is the corrupted camera.

* **physical**: the critic's numbers and operations are applied by code, as the rules do. They keep the best of up to
  four corrected cameras, and the camera as it is if none is better by 0.1. No list of other start views is at hand, and
  the limit of looks holds for a turn, not for the shot.
* **naive**: told that the picture has a fault, and nothing else. One to three operations of the closed list are drawn
  at random, in the step sizes of the list, and what they lead to is kept.

Both end at the threshold. Run it with ``python -m benchmarks camera_servo``.
"""

from __future__ import annotations

import argparse
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from benchmarks.corrupted_cameras import CORRUPTIONS, corrupted_camera
from benchmarks.staged_scenes import EXAMPLES, open_run

from storyblender.agents.layout_artist.camera_operator import (
    CAMERA_THRESHOLD,
    OPERATIONS,
    CameraRole,
    RulesCameraOperator,
    rules_operator,
    with_other_camera,
)
from storyblender.agents.layout_artist.camera_operator_critic import CameraOperatorCritic
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView
from storyblender.memory.base import shot_name
from storyblender.pipeline.filming import film_scene, with_frames
from storyblender.pipeline.grounding import ground
from storyblender.pipeline.materializing import materialize
from storyblender.pipeline.packing import pack_scenes
from storyblender.pipeline.run import Run
from storyblender.pipeline.staging import stage
from storyblender.ports import Viewfinder
from storyblender.reflection import Critic, Critique, reflect

TURNS = 5
FAULTS: Mapping[str, frozenset[str]] = {
    "size": frozenset({"size"}),
    "headroom": frozenset({"headroom"}),
    "cut off": frozenset({"cropped", "beheaded", "squeezed", "bystander"}),
    "roll": frozenset({"roll"}),
    "away from subject": frozenset({"out_of_frame", "face_out", "empty", "placement"}),
    "wrong side": frozenset({"angle", "face_away", "apart", "no_shoulder"}),
    "hidden": frozenset({"hidden", "face_hidden", "foreground", "missing"}),
}
"""The critic's kinds of faults by the rows of the table; what is left is ``other``: void, cuts, strangers."""
Refine = Callable[[CameraOperatorDraft, Critique, CameraOperatorView], CameraOperatorDraft]


@dataclass(frozen=True)
class AcceptedShot:
    """A shot with the take that the critic accepted.

    Attributes:
        view: What the Camera Operator knows.
        take: The take.
        viewfinder: Looks into the pack of its scene.
    """

    view: CameraOperatorView
    take: CameraOperatorDraft
    viewfinder: Viewfinder


@dataclass(frozen=True)
class Start:
    """A corrupted camera.

    Attributes:
        shot: The shot.
        kind: Of corruption.
        seed: Its seed.
        take: The take with the corrupted camera; it hides what the accepted one hid.
    """

    shot: AcceptedShot
    kind: str
    seed: int
    take: CameraOperatorDraft


@dataclass(frozen=True)
class _Keeping:
    """A camera critic that keeps what it judged."""

    critic: Critic[CameraOperatorView, CameraOperatorDraft]
    judged: list[tuple[CameraOperatorView, CameraOperatorDraft, Critique]] = field(default_factory=list)

    def judge(self, draft: CameraOperatorDraft, view: CameraOperatorView) -> Critique:
        """Judge a take and keep it."""
        critique = self.critic.judge(draft, view)
        self.judged.append((view, draft, critique))
        return critique


@dataclass(frozen=True)
class _From:
    """A policy whose first take is given."""

    take: CameraOperatorDraft
    refiner: Refine

    def propose(self, view: CameraOperatorView) -> CameraOperatorDraft:
        """Return the given take."""
        return self.take

    def refine(self, draft: CameraOperatorDraft, critique: Critique, view: CameraOperatorView) -> CameraOperatorDraft:
        """Return the next take."""
        return self.refiner(draft, critique, view)


class _CorrectionOnly(RulesCameraOperator):
    """The rules without the list of other views to start from."""

    def ranked_takes(self, view: CameraOperatorView) -> list[CameraOperatorDraft]:
        """Return no take."""
        return []

    def refine(self, draft: CameraOperatorDraft, critique: Critique, view: CameraOperatorView) -> CameraOperatorDraft:
        """Return the best of the fixed takes, else the draft itself."""
        self._looks[view.scene_id, view.shot_id] = self.critic.looks
        return super().refine(draft, critique, view)


def physical(critic: CameraOperatorCritic, seed: int) -> Refine:
    """Return the correction by the critic's numbers and operations."""
    return _CorrectionOnly(critic).refine


def naive(critic: CameraOperatorCritic, seed: int) -> Refine:
    """Return the correction by operations drawn at random."""
    rng = np.random.default_rng((seed, 1))

    def refine(draft: CameraOperatorDraft, critique: Critique, view: CameraOperatorView) -> CameraOperatorDraft:
        camera = draft.camera
        for name in rng.choice([*OPERATIONS], int(rng.integers(1, 4))):
            camera = OPERATIONS[str(name)](camera)
        return with_other_camera(view, draft, camera)

    return refine


def accepted_shots(run: Run) -> list[AcceptedShot]:
    """Return the shots of a packed story whose takes by the rules the critic accepts, in order.

    Args:
        run: With the packs.
    """
    filmed: list[tuple[_Keeping, Viewfinder]] = []

    def watched(viewfinder: Viewfinder) -> CameraRole:
        role = rules_operator(viewfinder)
        filmed.append((_Keeping(role.critic), viewfinder))
        return replace(role, critic=filmed[-1][0])

    run.crew = replace(run.crew, camera_operator=watched)
    graph = with_frames(run)
    for scene in graph.scenes:
        film_scene(run, graph, scene.scene_id)
    return [
        AcceptedShot(view, take, viewfinder)
        for critic, viewfinder in filmed
        for view, take, critique in critic.judged
        if critique.score >= CAMERA_THRESHOLD
    ]


def starts(shots: Sequence[AcceptedShot], count: int, first: int = 0) -> list[Start]:
    """Return corrupted cameras, of all shots and kinds of corruption in turn.

    Args:
        shots: Accepted shots.
        count: How many.
        first: The first seed.
    """
    kinds, found = [*CORRUPTIONS], list[Start]()
    for number in range(count):
        shot, kind = shots[number % len(shots)], kinds[(number + number // len(shots)) % len(kinds)]
        camera = corrupted_camera(shot.take.camera, kind, first + number)
        found.append(Start(shot, kind, first + number, with_other_camera(shot.view, shot.take, camera)))
    return found


def critiques_by_turn(start: Start, method: Callable[[CameraOperatorCritic, int], Refine]) -> list[Critique]:
    """Return the critiques of the takes of turn 0 to 5; a take that is accepted, or not changed, keeps its own.

    Args:
        start: The corrupted camera.
        method: ``physical`` or ``naive``.
    """
    view = start.shot.view
    critic = CameraOperatorCritic(start.shot.viewfinder)
    kept = _Keeping(critic)
    role = replace(
        rules_operator(start.shot.viewfinder, horizon=TURNS),
        policies=(_From(start.take, method(critic, start.seed)),),
        critic=kept,
    )
    reflect(role, shot_name(view.scene_id, view.shot_id), view)
    critiques = [critique for _, _, critique in kept.judged]
    return [critiques[min(turn, len(critiques) - 1)] for turn in range(TURNS + 1)]


def count_faults(critique: Critique) -> Counter[str]:
    """Return the number of faults of each row of the table."""
    row_of = {kind: row for row, kinds in FAULTS.items() for kind in kinds}
    return Counter(row_of.get(fault.kind, "other") for fault in critique.faults)


def table(begun: Sequence[Start], verbose: bool = False) -> Iterator[str]:
    """Yield the lines of the table, by method and turn.

    Args:
        begun: The corrupted cameras.
        verbose: Also yield the score of each camera and what is left of its faults.
    """
    shots = len({(start.shot.view.scene_id, start.shot.view.shot_id) for start in begun})
    yield f"{len(begun)} corrupted cameras of {shots} shots"
    yield f"{'method':<10}{'':<26}" + "".join(f"{f'turn {turn}':>9}" for turn in range(TURNS + 1))
    for name, method in (("naive", naive), ("physical", physical)):
        runs = [critiques_by_turn(start, method) for start in begun]
        for start, run in zip(begun, runs, strict=True) if verbose else ():
            scores = " ".join(f"{critique.score:.1f}" for critique in run)
            left = "; ".join(fault.message for fault in run[-1].faults if run[-1].score < CAMERA_THRESHOLD)
            subject = shot_name(start.shot.view.scene_id, start.shot.view.shot_id)
            yield f"  {name} {start.seed} {subject} {start.kind}: {scores} {left}"
        for row, each in _rows(begun, runs):
            yield f"{name:<10}{row:<26}" + "".join(f"{value:>9.2f}" for value in each)


def _rows(begun: Sequence[Start], runs: Sequence[Sequence[Critique]]) -> Iterator[tuple[str, list[float]]]:
    """Yield the rows of one method: shares at the threshold, the mean score, and faults a shot."""
    turns = range(TURNS + 1)

    def good(kinds: Sequence[str]) -> list[float]:
        mine = [run for start, run in zip(begun, runs, strict=True) if start.kind in kinds]
        return [sum(run[turn].score >= CAMERA_THRESHOLD for run in mine) / max(len(mine), 1) for turn in turns]

    yield "accepted", good([*CORRUPTIONS])
    yield "mean score", [sum(run[turn].score for run in runs) / len(runs) for turn in turns]
    for row in (*FAULTS, "other"):
        yield f"faults: {row}", [sum(count_faults(run[turn])[row] for run in runs) / len(runs) for turn in turns]
    for kind in CORRUPTIONS:
        yield f"accepted if {kind}", good([kind])


def main() -> None:
    """Film an example, corrupt its cameras, and print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    casablanca = next(path for path in EXAMPLES if path.stem == "casablanca")
    parser.add_argument("--script", type=Path, default=casablanca)
    parser.add_argument("--project", type=Path, help="where to make the project; kept")
    parser.add_argument("--starts", type=int, default=48)
    parser.add_argument("--seed", type=int, default=0, help="the first one")
    parser.add_argument("--verbose", action="store_true", help="every camera")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, ExitStack() as stack:
        run = open_run(arguments.project or Path(folder) / "project", stack)
        ground(run, arguments.script)
        materialize(run)
        stage(run)
        pack_scenes(run)
        for line in table(starts(accepted_shots(run), arguments.starts, arguments.seed), arguments.verbose):
            print(line, flush=True)


if __name__ == "__main__":
    main()

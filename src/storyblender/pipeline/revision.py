"""A changed script is an edit: what a person decided stays with the words of its shot.

The new plan is matched to the old graph by the words that each shot covers. A decision goes with its words, wherever
they went; one whose words are gone is told. The crew's work stays in scenes where nothing that it rests on changed.
"""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher

from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import content_hash, scene_name, shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import Commit, replace
from storyblender.memory.locks import SCENE_LOCKS, SHOT_LOCKS, ShotLock
from storyblender.memory.outline import SceneOutline, ShotOutline
from storyblender.memory.scene_context import Environment, SceneContext
from storyblender.memory.shot_context import CameraDecision, CameraInstruction, CameraState, ShotContext
from storyblender.pipeline.kept_coverage import with_coverage
from storyblender.pipeline.kept_cut import ShotKey, with_cut
from storyblender.pipeline.kept_decisions import (
    decided_as_before,
    marks_of,
    takes_of,
    with_decided_models,
    with_scene_decisions,
)

Words = tuple[tuple[str, str], ...]
Designer = Callable[[ContinuityMemoryGraph, int], Environment]
"""The set that a scene of a graph would get."""

_DECIDED = tuple(name for name in CameraDecision.model_fields if name in CameraInstruction.model_fields)
_STAGED = (
    "blocking", "cues", "prop_states", "asset_modifications", "duration", "lighting", "frame", "camera", "lights",
    "flaws", "locked", "decided_duration", "stale", "take", "takes", "notes", "approved", "omitted",
    "blocking_decision", "motion_by_hand",
)  # fmt: skip
"""What the crew, and later a person, adds to the Director's shot."""


@dataclass(frozen=True)
class Revision:
    """A new plan with what stays of the old graph.

    Attributes:
        graph: The new plan.
        lost: Name of an old shot or scene and what was decided or locked of it, where that is not kept.
        kept_scenes: Ids, in the new plan, of the scenes that need no staging.
    """

    graph: ContinuityMemoryGraph
    lost: tuple[tuple[str, str], ...] = ()
    kept_scenes: tuple[int, ...] = ()


def with_digests(plan: ContinuityMemoryGraph) -> ContinuityMemoryGraph:
    """Return the Director's plan with the digest of every scene: all that the crew's work on it rests on."""
    digests: dict[int, str] = {}
    outline: list[SceneOutline] = []
    contexts = {scene.scene_id: scene for scene in plan.scenes}
    assets = {asset.asset_id: asset for asset in plan.assets}
    for scene in plan.outline:
        context = contexts[scene.scene_id]
        reference = digests.get(context.setup.reference_scene_id or 0, "")
        shots: list[object] = [_planned(shot) for shot in plan.shots_of(scene.scene_id)]
        cast: list[object] = [
            assets[asset_id].model_dump(mode="json", exclude={"locked", "kind"}) for asset_id in context.setup.asset_ids
        ]
        setup = context.setup.model_dump(mode="json", exclude={"reference_scene_id"})
        words = [[list(line) for line in _words(shot)] for shot in scene.shots]
        about = [plan.settings_digest, reference, scene.heading, words, setup]
        digests[scene.scene_id] = content_hash(about, shots, cast)
        outline.append(scene.model_copy(update={"plan_digest": digests[scene.scene_id]}))
    return plan.model_copy(update={"outline": tuple(outline)})


def decisions(graph: ContinuityMemoryGraph, log: Iterable[Commit]) -> dict[ShotKey, CameraDecision]:
    """Return what a person decided about the camera of each shot.

    Args:
        graph: The story.
        log: Its commits, oldest first; in those of schema 1 a decision is only found by what it changed.
    """
    found: dict[ShotKey, CameraDecision] = {}
    for commit in log:
        if commit.author == "director":
            found.clear()
        elif commit.author == "user" and not commit.digest:
            for key, decision in _changed_cameras(commit):
                found[key] = found.get(key, CameraDecision()).then(decision)
    for shot in graph.shots:
        if shot.camera_decision is not None:
            key = shot.scene_id, shot.shot_id
            found[key] = found.get(key, CameraDecision()).then(shot.camera_decision)
    return found


def revise(
    old: ContinuityMemoryGraph, plan: ContinuityMemoryGraph, log: Iterable[Commit], designer: Designer
) -> Revision:
    """Return the new plan with what a person decided, and with the crew's work where it still holds.

    Args:
        old: The graph as it is.
        plan: The Director's new plan, ``with_digests``.
        log: The commits that led to ``old``, oldest first.
        designer: Tells whether the set of a scene would come out the same.
    """
    matched = matched_shots(old.outline, plan.outline)
    decided = decisions(old, log)
    former_of = {new: decided.get(past) for new, past in matched.items()}
    graph = _with_assets(old, plan)
    shots = [_with_decision(shot, former_of.get((shot.scene_id, shot.shot_id))) for shot in graph.shots]
    pasts = {(shot.scene_id, shot.shot_id): shot for shot in old.shots}
    rate = plan.format.fps / old.format.fps
    kept_shots = {key: pasts[past] for key, past in matched.items() if past in pasts}
    shots = [_as_locked(shot, kept_shots.get((shot.scene_id, shot.shot_id)), graph, rate) for shot in shots]
    planned = {(shot.scene_id, shot.shot_id): shot for shot in graph.shots}
    takes = {
        key: takes_of(planned[key], past) | marks_of(old, plan, planned[key], past) for key, past in kept_shots.items()
    }
    shots = [shot.model_copy(update=takes.get((shot.scene_id, shot.shot_id), {})) for shot in shots]
    graph = with_scene_decisions(old, graph.model_copy(update={"shots": tuple(shots)}), matched)
    graph, matched = with_coverage(old, graph, matched)
    graph = with_cut(old, graph, matched)
    kept: dict[int, int] = {}
    for scene in graph.outline:
        former = _same_scene(old, scene, matched)
        if former is None:
            continue
        staged = _staged(old, former, graph, scene.scene_id, kept)
        if staged is not None and designer(graph, scene.scene_id) == old.scene(former).environment:
            kept[scene.scene_id] = former
            graph = staged
    there = set(matched.values())
    lost = [(shot_name(*key), decision.words) for key, decision in sorted(decided.items()) if key not in there]
    lost += [(name, words) for name, words in _lost_locks(old, graph, matched, kept) if words]
    return Revision(graph, tuple(lost), tuple(kept))


def matched_shots(old: Sequence[SceneOutline], new: Sequence[SceneOutline]) -> dict[ShotKey, ShotKey]:
    """Return which old shot covers the very words of a new one: old keys by new keys, each (scene_id, shot_id).

    Scenes with all their words are found wherever they went; the shots of the others are aligned in story order.

    Args:
        old: Outline of the former plan, in story order.
        new: Outline of the new plan, in story order.
    """
    waiting: dict[Words, deque[SceneOutline]] = defaultdict(deque)
    for scene in old:
        waiting[_scene_words(scene)].append(scene)
    pairs: dict[ShotKey, ShotKey] = {}
    changed: list[SceneOutline] = []
    for scene in new:
        same = waiting[_scene_words(scene)]
        if same:
            pairs |= _aligned([same.popleft()], [scene])
        else:
            changed.append(scene)
    left = [scene for scenes in waiting.values() for scene in scenes]
    return pairs | _aligned(sorted(left, key=lambda scene: scene.scene_id), changed)


def _aligned(old: Sequence[SceneOutline], new: Sequence[SceneOutline]) -> dict[ShotKey, ShotKey]:
    olds, news = ([(scene.scene_id, shot) for scene in scenes for shot in scene.shots] for scenes in (old, new))
    words = ([_words(shot) for _, shot in shots] for shots in (olds, news))
    pairs: dict[ShotKey, ShotKey] = {}
    for first, second, length in SequenceMatcher(None, *words, autojunk=False).get_matching_blocks():
        for (past, shot), (present, same) in zip(
            olds[first : first + length], news[second : second + length], strict=True
        ):
            pairs[present, same.shot_id] = past, shot.shot_id
    return pairs


def _words(shot: ShotOutline) -> Words:
    """Return the words of a shot; shots without any are all alike, and matched by their order among the others."""
    return tuple((line.kind, " ".join(line.text.split())) for line in shot.lines) or (("", ""),)


def _scene_words(scene: SceneOutline) -> Words:
    return (("heading", " ".join(scene.heading.split())), *(line for shot in scene.shots for line in _words(shot)))


def _changed_cameras(commit: Commit) -> Iterable[tuple[ShotKey, CameraDecision]]:
    for change in commit.changes:
        if change.layer == "shots" and change.before and change.after:
            past, present = ShotContext.model_validate(change.before), ShotContext.model_validate(change.after)
            pairs = {
                name: (getattr(past.camera_instruction, name), getattr(present.camera_instruction, name))
                for name in _DECIDED
            }
            fields = {name: after for name, (before, after) in pairs.items() if before != after and after is not None}
            yield (present.scene_id, present.shot_id), CameraDecision.model_validate(fields)


def _with_decision(shot: ShotContext, decision: CameraDecision | None) -> ShotContext:
    if decision is None:
        return shot
    instruction = decision.applied(shot.camera_instruction)
    return shot.model_copy(update={"camera_instruction": instruction, "camera_decision": decision})


def _as_locked(shot: ShotContext, past: ShotContext | None, graph: ContinuityMemoryGraph, rate: float) -> ShotContext:
    """Return a planned shot with the length that a person gave to its words, and with what they locked.

    Args:
        shot: Of the new plan.
        past: The old shot with its words.
        graph: The new plan: what is locked stays unlocked where it needs a person who is not in it.
        rate: Frames a second now, over those of the old plan.
    """
    if past is None:
        return shot
    update: dict[str, object] = {"notes": past.notes, "omitted": past.omitted}
    if past.decided_duration is not None:
        frames = max(1, round(past.decided_duration * rate))
        update |= {"duration": frames, "decided_duration": frames}
    there = {asset.asset_id for asset in graph.assets}
    used = {*past.on_stage, *past.in_frame, *past.camera_instruction.focus_on_ids}
    locked: list[ShotLock] = [lock for lock in past.locked if (lock == "duration" or used <= there) and rate == 1]
    fields = [field for lock in locked for field in SHOT_LOCKS[lock]]
    update |= {field: getattr(past, field) for field in fields} | {"locked": tuple(locked)}
    if past.approved is not None and len(locked) == len(past.locked):
        update["approved"] = past.approved
    if "camera" in locked and past.camera is not None and past.scene_id != shot.scene_id:
        update["camera"] = _renamed(past.camera, scene_name(past.scene_id), scene_name(shot.scene_id))
    return shot.model_copy(update=update)


def _lost_locks(
    old: ContinuityMemoryGraph,
    new: ContinuityMemoryGraph,
    matched: Mapping[ShotKey, ShotKey],
    kept: Mapping[int, int],
) -> Iterator[tuple[str, str]]:
    """Yield the names of old shots and scenes, and what a person locked or set of each that the new plan has not."""
    present = {matched[key]: shot for shot in new.shots if (key := (shot.scene_id, shot.shot_id)) in matched}
    for shot in old.shots:
        after = present.get((shot.scene_id, shot.shot_id))
        gone = [f"the lock of its {lock}" for lock in shot.locked if after is None or lock not in after.locked]
        if shot.decided_duration is not None and after is None:
            gone.append(f"its length of {shot.decided_duration} frames")
        if shot.blocking_decision is not None and (after is None or after.blocking_decision is None):
            gone.append(f"its marks: {shot.blocking_decision.words}")
        lost = [name for name in shot.motion_by_hand if after is None or name not in after.motion_by_hand]
        gone += [f"the motion by hand of {', '.join(lost)}"] if lost else []
        if shot.approved is not None and (after is None or after.approved is None):
            gone.append("its approval")
        if after is None:
            gone += [f"the note “{note.words}”" for note in shot.notes]
            gone += ["what was split off or added"] if shot.covers is not None else []
        if shot.joined and (after is None or not after.joined):
            gone.append("that it was joined to the shot before it")
        yield shot_name(shot.scene_id, shot.shot_id), ", ".join(gone)
    for scene in old.scenes:
        if scene.scene_id not in kept.values():
            gone = [f"the lock of its {lock}" for lock in scene.locked]
            yield scene_name(scene.scene_id), ", ".join(gone)
        if scene.scene_id not in {former for former, _ in matched.values()}:
            parts = ((part, getattr(scene, f"{part}_decision")) for part in SCENE_LOCKS)
            told = [f"{part}: {decided.words}" for part, decided in parts if decided is not None]
            yield scene_name(scene.scene_id), ", ".join(told)


def _planned(shot: ShotContext) -> dict[str, object]:
    """Return what the Director planned for a shot, without where it stands in the story and in the script."""
    people = {"camera_decision", "camera_retake", "decided_duration", "stale"}
    return shot.model_dump(mode="json", exclude={"scene_id", "shot_id", "flags", *people})


def _with_assets(old: ContinuityMemoryGraph, plan: ContinuityMemoryGraph) -> ContinuityMemoryGraph:
    """Keep the model and size of every asset that the script describes as before."""
    if old.settings_digest != plan.settings_digest:
        return with_decided_models(old, plan)
    former = {asset.asset_id: asset for asset in old.assets}
    kept: list[Asset] = []
    for asset in plan.assets:
        past = former.get(asset.asset_id)
        if past is not None and _told(past) == _told(asset):
            kept.append(past)
        elif past is not None and past.locked:
            same = {name: getattr(past, name) for name in ("look", *_MADE)}
            kept.append(asset.model_copy(update=same))
        elif past is not None:
            kept.append(decided_as_before(asset, past))
    return replace(plan, *kept)


_MADE = ("dimension", "canonical", "locked", "decision", "look_decision", "turned_down", "image_prompt")
"""Fields of an asset that neither the script nor the Director decides."""


def _told(asset: Asset) -> Asset:
    usual = {name: Asset.model_fields[name].default for name in (*_MADE, "kind")}
    return asset.model_copy(update=usual)


def _same_scene(old: ContinuityMemoryGraph, scene: SceneOutline, matched: dict[ShotKey, ShotKey]) -> int | None:
    """Return the id of the old scene with the same plan."""
    former = {matched.get((scene.scene_id, shot.shot_id), (0, 0))[0] for shot in scene.shots}
    plans = {outline.scene_id: outline.plan_digest for outline in old.outline}
    same = len(former) == 1 and scene.plan_digest and scene.plan_digest == plans.get(*former)
    return former.pop() if same else None


def _staged(
    old: ContinuityMemoryGraph, former: int, plan: ContinuityMemoryGraph, scene_id: int, kept: dict[int, int]
) -> ContinuityMemoryGraph | None:
    """Return the plan with the crew's work on one scene; None where that is not done, or rests on what changed."""
    past, present = old.scene(former), plan.scene(scene_id)
    reference = present.setup.reference_scene_id
    if past.lighting is None or past.layout is None or past.environment is None:
        return None
    if reference is not None and kept.get(reference) != past.setup.reference_scene_id:
        return None
    was, found = past.setup.found, present.setup.found
    if any(was.get(thing) != states for thing, states in found.items()) or (was.keys() > found.keys() and not found):
        return None  # an earlier scene leaves the place otherwise
    olds, news = ({asset.asset_id: asset for asset in graph.assets} for graph in (old, plan))
    wanted = {*present.setup.asset_ids, *(item.asset_id for item in past.layout.objects)}
    if any(news.get(asset_id, olds[asset_id]) != olds[asset_id] for asset_id in wanted):
        return None
    update = {name: getattr(past, name) for name in ("environment", "layout", "lighting", "locked", "stale")}
    dressing = [asset for asset in old.assets if asset.asset_id in wanted - news.keys()]
    pasts = {shot.shot_id: shot for shot in old.shots_of(former)}
    shots = [_kept_shot(pasts[shot.shot_id], shot) for shot in plan.shots_of(scene_id)]
    setup = present.setup.model_copy(update={"found": past.setup.found})
    scene: SceneContext = present.model_copy(update={**update, "setup": setup})
    return replace(plan, *dressing, scene, *shots)


def _kept_shot(past: ShotContext, plan: ShotContext) -> ShotContext:
    update = {name: getattr(past, name) for name in _STAGED}
    instruction = plan.camera_instruction
    if past.camera_retake is not None and plan.camera_decision is None:
        instruction = past.camera_retake.applied(instruction)
        update |= {"camera_instruction": instruction, "camera_retake": past.camera_retake}
        update |= {"moment": plan.moment or past.camera_retake.moment}
    if past.camera_instruction != instruction:
        update |= {"camera": None, "lights": ()}
    elif past.camera is not None and past.scene_id != plan.scene_id:
        update["camera"] = _renamed(past.camera, scene_name(past.scene_id), scene_name(plan.scene_id))
    return plan.model_copy(update=update)


def _renamed(camera: CameraState, past: str, present: str) -> CameraState:
    """Return a camera whose flaws name the shots of its scene as they are called now."""
    flaws = (
        flaw.model_copy(
            update={"message": flaw.message.replace(past, present), "subject": flaw.subject.replace(past, present)}
        )
        for flaw in camera.residual
    )
    return camera.model_copy(update={"residual": tuple(flaws)})

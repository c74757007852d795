"""The Animator played by a language model: who does what, in which order and where; rules make marks and cues of it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from itertools import pairwise
from typing import Any

from storyblender.agents.asking import Asker, LanguagePolicy, Notes
from storyblender.agents.nearest import nearest_entries
from storyblender.agents.story_lines import story_lines
from storyblender.agents.visual_effects_artist.animator import AnimatorDraft, AnimatorView, RulesAnimator
from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.agents.visual_effects_artist.rehearsal import FloorMark, ShotDirections, ShotStaging
from storyblender.agents.visual_effects_artist.speeches import SPOKEN
from storyblender.catalog.motions import MOTIONS, motion_words
from storyblender.catalog.set_plan import Piece
from storyblender.memory.base import Coordinate, Identifier, scene_name
from storyblender.memory.shot_context import BodyState, CharacterAction, ShotContext
from storyblender.ports import Answerer, Embedder
from storyblender.reflection import Policy

_MOTIONS = 70
"""Motions of the catalogue that a request offers."""
_OPENINGS = ("door", "window")
_AHEAD = ("camera", "away")
"""What a person can face besides people and things."""
_BUSINESS = 3
"""Most motions that an answer may add to a shot."""


class MoveNotes(Notes):
    """One action of a shot as it is played."""

    action: int | None = None
    """Number of an action that was read; leave it out for one that you add."""
    actor: Identifier | None = None
    """Who does an action that you add."""
    motion: Identifier | None = None
    """Key of a motion, if the one that was read is not the best."""
    target: Identifier | None = None
    """To whom or at what it is done."""
    prop: Identifier | None = None
    """With what it is done."""
    to_x: Coordinate | None = None
    """Metres to the right of the middle, where a walk ends."""
    to_y: Coordinate | None = None
    """Metres to the back of the middle, where a walk ends."""
    with_previous: bool = False
    """Begins together with the move before it in this list, not after it."""


class MarkNotes(Notes):
    """Where a person stands as a shot begins."""

    person: Identifier
    x: Coordinate
    """Metres to the right of the middle."""
    y: Coordinate
    """Metres to the back of the middle."""
    facing: Identifier | None = None
    """A person, a thing, ``camera``."""


class ShotMoves(Notes):
    """The staging of one shot. What is left out stays as planned."""

    shot: int
    moves: tuple[MoveNotes, ...] = ()
    """In the order in which they begin; an action that was read and is not listed keeps its place."""
    marks: tuple[MarkNotes, ...] = ()
    """Only of people who stand, do not come in, and are not where the shot before left them."""


class StagingNotes(Notes):
    """The staging of a scene; only the shots that should not be as planned."""

    shots: tuple[ShotMoves, ...] = ()


def language_animator(answerer: Answerer, embedder: Callable[[], Embedder]) -> Policy[AnimatorView, AnimatorDraft]:
    """Return the Animator played by a model; rules find free places, ways and the time that each thing takes.

    Args:
        answerer: The model, or a person in its place.
        embedder: Likeness of meaning; chooses the motions of a request.
    """
    rules = RulesAnimator()

    def motions(view: AnimatorView) -> dict[str, str]:
        used = {action.motion for shot in view.shots for action in shot.character_actions}
        texts = [action.action_description for shot in view.shots for action in shot.character_actions]
        near = nearest_entries(MOTIONS.values(), texts, embedder(), _MOTIONS)
        keys = {*used, *SPOKEN, *(motion.key for motion in near)}
        return {key: motion_words(key, tags=0) for key in MOTIONS if key in keys}

    return LanguagePolicy(
        Asker(answerer, "animator", StagingNotes),
        show=lambda view: _shown(view, rules.propose(view)) | {"motions": motions(view)},
        check=lambda answer, view: _wrong(answer, view, rules.propose(view), motions(view)),
        draft_of=lambda answer, view: _staged(answer, view, rules),
        subject=lambda view: scene_name(view.scene_id),
        mend=rules.refine,
        settled=lambda view: rules.propose(view) if not any(_free(shot) for shot in view.shots) else None,
    )


def _free(shot: ShotContext) -> bool:
    """Return whether there is anything to stage in a shot."""
    return bool(shot.on_stage) and "blocking" not in shot.locked


def _staged(answer: StagingNotes, view: AnimatorView, rules: RulesAnimator) -> AnimatorDraft:
    """Return the rules' staging of the moves and marks of an answer."""
    told = {notes.shot: notes for notes in answer.shots}
    shots, directions = list[ShotContext](), dict[int, ShotDirections]()
    for shot in view.shots:
        notes = told.get(shot.shot_id, ShotMoves(shot=shot.shot_id))
        played = _played(notes, shot) if _free(shot) else [(action, None) for action in shot.character_actions]
        shots.append(shot.model_copy(update={"character_actions": tuple(action for action, _ in played)}))
        directions[shot.shot_id] = _directions(notes, [move for _, move in played])
    draft = rules.stage(view.model_copy(update={"shots": tuple(shots)}), directions)
    changed = zip(draft.shots, shots, view.shots, strict=True)
    return AnimatorDraft(shots=tuple(_with_actions(staging, shot, before) for staging, shot, before in changed))


def _directions(notes: ShotMoves, moves: Sequence[MoveNotes | None]) -> ShotDirections:
    """Return what is asked of a shot beyond its actions; ``moves`` has one for each action, or None."""
    numbered = [(number, move) for number, move in enumerate(moves) if move is not None]
    return ShotDirections(
        marks={mark.person: FloorMark((mark.x, mark.y), mark.facing) for mark in notes.marks},
        goals={n: (move.to_x, move.to_y) for n, move in numbered if move.to_x is not None and move.to_y is not None},
        together=frozenset(number for number, move in numbered if number and move.with_previous),
    )


def _with_actions(staging: ShotStaging, shot: ShotContext, before: ShotContext) -> ShotStaging:
    """Return a staging with its actions, if they are not those that were read."""
    if shot.character_actions == before.character_actions:
        return staging
    return staging.model_copy(update={"character_actions": shot.character_actions})


def _played(notes: ShotMoves, shot: ShotContext) -> list[tuple[CharacterAction, MoveNotes | None]]:
    """Return the actions of a shot in the order in which they are played, each with its move if it has one."""
    read, listed = list(enumerate(shot.character_actions, start=1)), {move.action for move in notes.moves}
    waiting = [(number, action) for number, action in read if number not in listed]
    played: list[tuple[CharacterAction, MoveNotes | None]] = []
    for move in notes.moves:
        while move.action is not None and waiting and waiting[0][0] < move.action:
            played.append((waiting.pop(0)[1], None))
        told = {"motion": move.motion, "target_id": move.target, "prop_id": move.prop}
        update = {name: value for name, value in told.items() if value is not None}
        if move.action is not None:
            action = shot.character_actions[move.action - 1]
            clip = action.mocap if move.motion in (None, action.motion) else None
            played.append((action.model_copy(update={**update, "mocap": clip}), move))
        elif move.actor is not None and move.motion is not None:
            named = MOTIONS[move.motion].name
            added = CharacterAction(asset_id=move.actor, action_description=named, motion=move.motion)
            played.append((added.model_copy(update=update), move))
    return played + [(action, None) for _, action in waiting]


def _wrong(answer: StagingNotes, view: AnimatorView, planned: AnimatorDraft, motions: Collection[str]) -> Iterator[str]:
    """Yield what no schema can say of an answer: unknown shots, people, motions and things; marks that cannot be."""
    shots = {shot.shot_id: shot for shot in view.shots}
    stays = _stays(planned)
    things = {name for item in view.layout.objects for name in (item.node_id, item.asset_id)}
    known = {*things, *_OPENINGS, *(asset.asset_id for asset in view.assets)}
    known |= {*(mark.name for mark in view.plan.marks), *(piece.node_id for piece in _pieces(view))}
    known |= {hole.name for wall in view.plan.walls for hole in wall.openings}
    size = view.layout.scene_size
    if len({notes.shot for notes in answer.shots}) < len(answer.shots):
        yield "each shot may be listed once"
    for notes in answer.shots:
        shot, name = shots.get(notes.shot), f"shot {notes.shot}"
        if shot is None:
            yield f"there is no {name}"
            continue
        yield from (f"{name}: {sentence}" for sentence in _wrong_moves(notes, shot, motions, known))
        states = {state.asset_id: state for state in shot.states}
        for mark in notes.marks:
            state = states.get(mark.person)
            if mark.person not in shot.on_stage:
                yield f"{name}: {mark.person} is not on stage"
            elif (notes.shot, mark.person) in stays:
                yield f"{name}: {mark.person} is where the shot before left them; let them walk, or leave the mark out"
            elif state is not None and state.posture != "stand":
                yield f"{name}: {mark.person} does not stand ({state.posture}); leave the mark out"
            if mark.facing is not None and mark.facing not in known | {*_AHEAD}:
                yield f"{name}: there is no {mark.facing!r} to face"
            if not (size.x_negative <= mark.x <= size.x and size.y_negative <= mark.y <= size.y):
                yield f"{name}: ({mark.x}, {mark.y}) is outside the playing area"


def _stays(planned: AnimatorDraft) -> set[tuple[int, str]]:
    """Return the shots, with people, that begin where the planned shot before has left these people."""
    stays = set[tuple[int, str]]()
    for before, shot in pairwise(planned.shots):
        ends = {each.end.asset_id: each.end.location for each in before.blocking}
        starts = (each.start for each in shot.blocking if each.start.asset_id in ends)
        stays |= {(shot.shot_id, start.asset_id) for start in starts if start.location == ends[start.asset_id]}
    return stays


def _wrong_moves(
    notes: ShotMoves, shot: ShotContext, motions: Collection[str], known: Collection[str]
) -> Iterator[str]:
    """Yield what is wrong with the moves of one shot."""
    numbers, last = [move.action for move in notes.moves if move.action is not None], len(shot.character_actions)
    if len({*numbers}) < len(numbers) or not {*numbers} <= {*range(1, last + 1)}:
        yield f"actions are numbered 1 to {last}, and each may be listed once; they are {numbers}"
        return
    if len(notes.moves) - len(numbers) > _BUSINESS:
        yield f"at most {_BUSINESS} motions may be added"
    for move in notes.moves:
        read = shot.character_actions[move.action - 1] if move.action is not None else None
        key = move.motion or (read.motion if read is not None else "")
        if read is None and (move.actor not in shot.on_stage or move.motion is None):
            yield "a move without the number of an action needs an actor on stage and a motion"
        elif key not in motions:
            yield f"there is no motion {key!r}; take one of `motions`"
        elif (key in SPOKEN) != (read is not None and read.motion in SPOKEN):
            yield f"{key!r}: speeches stay speeches, and no others are added"
        elif move.to_x is not None and MOTIONS[key].speed is None:
            yield f"{key!r} does not lead anywhere; leave to_x and to_y out, or take a motion that travels"
        for name in (move.target, move.prop):
            if name is not None and name not in known:
                yield f"there is no {name!r} in the scene"


def _shown(view: AnimatorView, planned: AnimatorDraft) -> dict[str, Any]:
    """Return what a model is shown of a scene; ``planned`` is the staging of the rules."""
    floor, size = Floor(view.layout, view.assets, view.plan), view.layout.scene_size
    lines = {each["shot"]: each["lines"] for each in story_lines(view.outline)}
    stagings = {staging.shot_id: staging for staging in planned.shots}
    solid = (thing for thing in floor.things.values() if thing.solid or not thing.node_id.startswith("set_"))
    return {
        "playing_area": {"left": size.x_negative, "right": size.x, "front": size.y_negative, "back": size.y},
        "people": {
            asset.asset_id: asset.name or asset.description for asset in view.assets if asset.asset_type == "character"
        },
        "things": [
            {
                "id": thing.node_id,
                "at": [round(each, 1) for each in thing.location[:2]],
                "size": [round(each, 1) for each in thing.size],
                "seats": len(thing.anchors_of("seat", "bed")),
            }
            for thing in solid
        ],
        "parts_of_the_set": {piece.node_id: [round(each, 1) for each in piece.location[:2]] for piece in _pieces(view)},
        "places": {mark.name: [round(each, 1) for each in mark.location[:2]] for mark in view.plan.marks},
        "openings": {each.node_id: [round(at, 1) for at in each.location[:2]] for each in floor.openings},
        "shots": [_shown_shot(shot, lines.get(shot.shot_id, []), stagings[shot.shot_id], view) for shot in view.shots],
    }


def _pieces(view: AnimatorView) -> list[Piece]:
    """Return the solid parts of the set that are in the playing area."""
    size = view.layout.scene_size
    return [
        piece for piece in view.plan.pieces
        if piece.solid and piece.footprint is not None
        and size.x_negative <= piece.location[0] <= size.x and size.y_negative <= piece.location[1] <= size.y
    ]  # fmt: skip


def _shown_shot(shot: ShotContext, lines: list[str], planned: ShotStaging, view: AnimatorView) -> dict[str, Any]:
    """Return a shot as a model is shown it: lines, people with their planned places, numbered actions."""
    states = {state.asset_id: state for state in shot.states}
    actions = enumerate(shot.character_actions, start=1)
    return {
        "shot": shot.shot_id,
        "locked": not _free(shot),
        "seconds": round(shot.duration / view.fps, 1),
        "lines": lines,
        "on_stage": {
            each.start.asset_id: {
                "from": [round(at, 1) for at in each.start.location[:2]],
                "to": [round(at, 1) for at in each.end.location[:2]],
                **_shown_state(states.get(each.start.asset_id)),
            }
            for each in planned.blocking
        },
        "actions": [{"number": number, **_shown_action(action)} for number, action in actions],
        "not_possible": [flaw.message for flaw in planned.flaws],
    }


def _shown_state(state: BodyState | None) -> dict[str, Any]:
    """Return what is told of a person's body as a shot begins."""
    if state is None:
        return {}
    told = {"posture": state.posture, "on": state.support_id, "holds": list(state.held)}
    told |= {"looks_at": state.looking_at or state.gaze, "goes_on": state.activity}
    return {name: value for name, value in told.items() if value}


def _shown_action(action: CharacterAction) -> dict[str, Any]:
    """Return an action as it was read."""
    told = {"actor": action.asset_id, "motion": action.motion, "target": action.target_id, "prop": action.prop_id}
    told |= {"words": action.action_description, "mood": action.mood if action.mood != "neutral" else None}
    return {name: value for name, value in told.items() if value}

"""The rehearsal of one scene: people and props carried from shot to shot, actions turned into cues on a clock. Pure."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from storyblender.agents.visual_effects_artist.floor import BODY, Floor, SeatPlace, Thing, facing
from storyblender.catalog.motions import MOTIONS, Motion, clip_of, natural_seconds
from storyblender.geometry.paths import Vec2, path_length
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Vec3
from storyblender.memory.outline import ScriptLine
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import (
    Blocking,
    BodyState,
    CharacterAction,
    Cue,
    Mark,
    PropState,
    ShotContext,
)
from storyblender.memory.vocabulary import Hand, Mood, Posture

TALK_DISTANCE = 1.15
"""Metres between two people who talk; 1.0 to 1.4 reads as talking."""
CHEAT = math.radians(20)
"""Bodies turn this much from their partner towards the audience, so that faces read; the head makes up for it."""
PROFILE = math.radians(48)
"""Two who meet stand within this angle of the audience's plane, so that neither hides the other."""
STRETCH = 1.5
"""A shot may grow to this many times the Director's length before ways are cut short."""
REACH = 0.62
"""Metres from which a standing person handles a thing."""
SEATED: tuple[Posture, ...] = ("sit", "lie", "asleep")
SPOKEN = ("talk", "whisper", "shout")
PARENTHETICALS: tuple[tuple[str, Mood], ...] = (
    (r"angr|furious|shout|snap|cold|bitter|rage", "angry"),
    (r"smil|laugh|happ|cheer|excit|grin|joke|bright|amus", "happy"),
    (r"sad|tear|cry|sob|quiet|broken|weary|tired|mourn", "sad"),
    (r"afraid|scared|nervous|panick|trembl|whisper|urgent|alarm", "afraid"),
    (r"soft|tender|gentl|warm|lov|kind", "tender"),
)


@dataclass
class Person:
    """Somebody of the scene, as of the cue written last."""

    asset_id: str
    k: float
    place: Vec2 = (0.0, 0.0)
    yaw: float = 0.0
    posture: Posture = "stand"
    support: str | None = None
    anchor: str = ""
    held: dict[Hand, str] = field(default_factory=dict)
    present: bool = False
    busy: float = 0.0
    """Second of the shot until which the body acts."""
    acted: bool = False
    """Has moved in this shot: the start mark stands."""

    @property
    def upright(self) -> bool:
        """Can walk off without getting up."""
        return self.posture == "stand"

    def mark(self, **changes: object) -> Mark:
        """Return where this person is."""
        values: dict[str, object] = {
            "asset_id": self.asset_id,
            "location": (round(self.place[0], 3), round(self.place[1], 3), 0.0),
            "yaw": round(math.degrees(self.yaw) % 360.0, 1),
            "posture": self.posture,
            "support_id": self.support,
            "anchor_name": self.anchor,
            "held": tuple(sorted(self.held.items())),
        }
        return Mark.model_validate({**values, **changes})

    def hand_of(self, prop: str) -> Hand | None:
        """Return the hand that holds a prop."""
        return next((hand for hand, held in self.held.items() if held == prop), None)

    def free_hand(self) -> Hand | None:
        """Return an empty hand, the right one first."""
        return "R" if "R" not in self.held else "L" if "L" not in self.held else None


@dataclass(frozen=True)
class ShotPlan:
    """What the rehearsal of one shot comes to."""

    shot_id: int
    blocking: tuple[Blocking, ...]
    cues: tuple[Cue, ...]
    prop_states: tuple[PropState, ...]
    duration: int
    cheats: tuple[str, ...]


class Rehearsal:
    """A scene being staged, shot after shot.

    Args:
        floor: Where things are.
        assets: Characters with their statures, objects with their sizes.
        objects: The layout, for the people's first places.
        fps: Frames per second.
    """

    def __init__(self, floor: Floor, assets: Sequence[Asset], objects: Sequence[LayoutObject], fps: int) -> None:
        self.floor, self.fps = floor, fps
        self.assets = {asset.asset_id: asset for asset in assets}
        self.home: dict[str, tuple[Vec2, float]] = {
            item.asset_id: (item.location[:2], math.radians(item.rotation[2])) for item in reversed(objects)
        }
        self.people = {
            asset.asset_id: Person(asset.asset_id, _stature(asset) / 1.7)
            for asset in assets
            if asset.asset_type == "character"
        }
        self.lying: dict[str, Vec3] = {
            thing.asset_id: thing.location for thing in reversed(list(floor.things.values()))
        }
        """Where every prop lies that nobody holds."""
        self.touched: dict[str, None] = {}
        """Props that left their places, in order."""
        self.cues: list[Cue] = []
        self.starts: dict[str, Mark] = {}
        self.clock = 0.0
        self.cheats: list[str] = []

    # --- the shot -------------------------------------------------------------------------------------------------

    def play(self, shot: ShotContext, lines: Sequence[ScriptLine], stay: Sequence[str]) -> ShotPlan:
        """Stage one shot.

        Args:
            shot: Actions, states, length.
            lines: Its lines, for the length of speeches.
            stay: Who is still on stage in the next shot.
        """
        self.cues, self.cheats, self.clock = [], [], 0.2
        self.length = shot.duration / self.fps
        self.leaving = {name for name in shot.on_stage if name not in stay}
        cast = [self.people[name] for name in shot.on_stage if name in self.people]
        self._bring_on(shot, cast)
        self._apply_states(shot.states)
        self._place_loose_props(shot)
        self.starts = {person.asset_id: person.mark() for person in cast}
        props_at_start = self._prop_states(shot)
        seconds = self._speech_seconds(shot, lines)
        for number, action in enumerate(shot.character_actions):
            person = self.people.get(action.asset_id)
            if person is None or not person.present:
                continue
            if clip_of(action.motion).key in SPOKEN:
                self._speak(action, person, seconds.get(number, 2.0), lines, cast)
            else:
                self._act(action, person, shot.character_actions[number + 1 :])
        self._idle_looks(shot, cast)
        needed = math.ceil((max((p.busy for p in cast), default=0.0) + 0.25) * self.fps)
        duration = shot.duration
        if "duration" not in shot.locked:
            duration = min(max(duration, needed), math.ceil(STRETCH * shot.duration))
        if props_at_start != self._start_props:
            props_at_start = self._start_props
        blocking = tuple(Blocking(start=self.starts[p.asset_id], end=p.mark()) for p in cast)
        for person in cast:
            person.present = person.asset_id in stay
        return ShotPlan(
            shot.shot_id,
            blocking,
            tuple(sorted(self.cues, key=lambda cue: cue.start)),
            props_at_start,
            duration,
            tuple(self.cheats),
        )

    def keep(self, shot: ShotContext) -> None:
        """Take over the ends of a shot whose blocking the user has locked."""
        for blocking in shot.blocking:
            person = self.people.get(blocking.end.asset_id)
            if person is not None:
                person.place, person.yaw = blocking.end.location[:2], math.radians(blocking.end.yaw)
                person.posture, person.support = blocking.end.posture, blocking.end.support_id
                person.anchor, person.held, person.present = blocking.end.anchor_name, dict(blocking.end.held), True

    # --- who is where when the shot begins ------------------------------------------------------------------------

    def _bring_on(self, shot: ShotContext, cast: Sequence[Person]) -> None:
        """Put everybody who was not on stage where the shot finds them: at a door, or at their place."""
        for person in cast:
            person.busy, person.acted = 0.0, False
            if person.present:
                continue
            person.posture, person.support, person.anchor = "stand", None, ""
            others = [p.place for p in cast if p.present]
            first = next((a for a in shot.character_actions if a.asset_id == person.asset_id), None)
            place, yaw = self.home.get(person.asset_id, (self._middle(), 0.0))
            enters = first is not None and clip_of(first.motion).speed is not None and self._enter_marks()
            if enters:
                mark = min(self._enter_marks(), key=lambda spot: math.dist(spot, place))
                person.place, person.yaw = mark, facing(mark, place)
            else:
                person.place = self.floor.free_near(place, person.k, others)
                person.yaw = yaw
            person.present = True

    def _enter_marks(self) -> list[Vec2]:
        return [mark.location[:2] for mark in self.floor.marks if "enter" in mark.tags]

    def _exit_marks(self) -> list[Vec2]:
        return [mark.location[:2] for mark in self.floor.marks if "exit" in mark.tags] or self._enter_marks()

    def _middle(self) -> Vec2:
        x0, y0, x1, y1 = self.floor.bounds
        return (x0 + x1) / 2, (y0 + y1) / 2

    def _apply_states(self, states: Sequence[BodyState]) -> None:
        """Bring people into the postures and hands the script says they are in, between shots."""
        for state in states:
            person = self.people.get(state.asset_id)
            if person is None or not person.present:
                continue
            self._apply_posture(person, state)
            for hand, prop in list(person.held.items()):
                if prop not in state.held:
                    del person.held[hand]
            for prop in state.held:
                if prop in self.assets:
                    self._hand_over(person, prop)

    def _apply_posture(self, person: Person, state: BodyState) -> None:
        support = self.floor.thing(state.support_id)
        same_support = support is None or person.support == support.node_id
        if state.posture == person.posture and (same_support or person.posture == "stand"):
            return
        if state.posture == "stand":
            if not person.upright:
                self._stand_beside(person)
        elif state.posture == "sit":
            seat = self._seat_for(person, state.support_id)
            if seat is not None:
                self._take_seat(person, seat)
            else:
                person.posture, person.support, person.anchor = "sit", None, ""
        elif state.posture in ("lie", "asleep"):
            self._go_to_bed(person, state.support_id, state.posture)
        else:
            if not person.upright:
                self._stand_beside(person)
            if state.posture == "lean" and support is not None:
                self._go_to_rail(person, support)
            person.posture = state.posture

    def _stand_beside(self, person: Person) -> None:
        """Stand up by a cut: before the seat, or at the nearest free spot."""
        seats = [s for s in self.floor.seats(person.support) if math.dist(s.edge, person.place) < 0.7]
        wish = seats[0].before(person.k) if seats else person.place
        person.place = wish if seats else self.floor.free_near(wish, person.k, self._others(person))
        person.posture, person.support, person.anchor = "stand", None, ""

    def _others(self, person: Person) -> list[Vec2]:
        return [p.place for p in self.people.values() if p.present and p is not person]

    def _seat_for(self, person: Person, name: str | None) -> SeatPlace | None:
        """Return the free seat of a thing that is nearest, or the nearest free seat of the set if none is named."""
        taken = [p.place for p in self.people.values() if p.present and p is not person and p.posture in SEATED]
        names = [name] if name else [thing.node_id for thing in self.floor.things.values()]
        same = [t.node_id for t in self.floor.things.values() if name and t.asset_id == name]
        seats = [seat for each in same or names for seat in self.floor.seats(each)]
        free = [seat for seat in seats if all(math.dist(seat.edge, spot) > 0.4 for spot in taken)]
        if not name:
            free = [seat for seat in free if math.dist(seat.edge, person.place) < 4.0]
        return min(free or (seats if name else []), key=lambda seat: math.dist(seat.edge, person.place), default=None)

    def _take_seat(self, person: Person, seat: SeatPlace) -> None:
        person.place, person.yaw, person.posture = seat.edge, seat.yaw, "sit"
        person.support, person.anchor = seat.node_id, seat.anchor

    def _go_to_bed(self, person: Person, name: str | None, posture: Posture) -> None:
        beds = self.floor.beds(name)
        if beds:
            edge, _ = max(
                beds, key=lambda bed: min(0.6, self.floor.room_at(bed[0].before(person.k), (bed[0].node_id,)))
            )
            person.place, person.yaw = edge.edge, edge.yaw
            person.support, person.anchor, person.posture = edge.node_id, edge.anchor, posture
            return
        seat = self._seat_for(person, name) if name else None
        if seat is not None and posture == "asleep":
            self._take_seat(person, seat)
        else:
            person.support, person.anchor = None, ""
        person.posture = posture

    def _go_to_rail(self, person: Person, thing: Thing) -> None:
        """Stand close before a bar, a rail or a wall."""
        point = self._rail(person, thing)
        away = facing(point, person.place)
        gap = 0.16 * person.k + 0.12
        person.place = (point[0] + gap * math.sin(away), point[1] - gap * math.cos(away))
        person.yaw, person.support = facing(person.place, point), thing.node_id

    def _rail(self, person: Person, thing: Thing) -> Vec2:
        """Return the point of a thing's outline that is nearest to a person."""
        lx, ly = thing.local(person.place)
        half = thing.size[0] / 2, thing.size[1] / 2
        x, y = max(-half[0], min(half[0], lx)), max(-half[1], min(half[1], ly))
        if abs(x) < half[0] and abs(y) < half[1]:
            y = -half[1]
        return thing.world((x, y, 0.0))[:2]

    # --- props ----------------------------------------------------------------------------------------------------

    def _place_loose_props(self, shot: ShotContext) -> None:
        """Props that somebody is about to take and that the layout forgot lie on the nearest table, or are in hand."""
        for action in shot.character_actions:
            prop, person = self._prop_of(action), self.people.get(action.asset_id)
            if prop is None or person is None or not person.present or prop in self.lying or self._holder(prop):
                continue
            if clip_of(action.motion).key in ("pick_up", "take"):
                top = self.floor.nearest_top(person.place, 6.0)
                near = self.floor.top_of(top, person.place) if top else (*person.place, 0.0)
                self.lying[prop] = near if top else (near[0] + 0.35 * math.sin(person.yaw), near[1] - 0.35, 0.0)
                self.touched[prop] = None
            else:
                self._hand_over(person, prop)

    def _prop_of(self, action: CharacterAction) -> str | None:
        """Return the thing an action handles, if it is one that can be carried."""
        for name in (action.prop_id, action.target_id):
            asset = self.assets.get(name or "")
            if asset is None or asset.asset_type != "object":
                continue
            size = asset.canonical.dimensions if asset.canonical else (0.2, 0.2, 0.2)
            if sorted(size)[1] <= 0.6:
                thing = self.floor.thing(asset.asset_id)
                if name == action.prop_id or (thing is None or not thing.of_kind("seat", "bed")):
                    return asset.asset_id
        return None

    def _holder(self, prop: str) -> Person | None:
        return next((p for p in self.people.values() if p.hand_of(prop)), None)

    def _hand_over(self, person: Person, prop: str) -> Hand | None:
        """Let a person hold a prop; whoever held it does not any more."""
        already = person.hand_of(prop)
        if already:
            return already
        hand = person.free_hand()
        if hand is None:
            return None
        for other in self.people.values():
            other.held = {h: held for h, held in other.held.items() if held != prop}
        person.held[hand] = prop
        self.lying.pop(prop, None)
        self.touched[prop] = None
        return hand

    def _prop_states(self, shot: ShotContext) -> tuple[PropState, ...]:
        states = []
        for prop in self.touched:
            holder = self._holder(prop)
            place = self.lying.get(prop)
            if holder is not None:
                seen = holder.asset_id in shot.on_stage
                hand = holder.hand_of(prop)
                states.append(
                    PropState(asset_id=prop, visible=seen, held_by=holder.asset_id if seen else None, hand=hand)
                )
            else:
                location = (round(place[0], 3), round(place[1], 3), round(place[2], 3)) if place else None
                states.append(PropState(asset_id=prop, visible=place is not None, location=location))
        self._start_props = tuple(states)
        return self._start_props

    def _found_in_hand(self, person: Person, prop: str) -> None:
        """Let a person hold a prop from the shot's first frame on: a cut nobody sees."""
        hand = self._hand_over(person, prop)
        if hand is None:
            return
        start = self.starts[person.asset_id]
        if not any(held == prop for _, held in start.held):
            self.starts[person.asset_id] = start.model_copy(update={"held": (*start.held, (hand, prop))})
        kept = [state for state in self._start_props if state.asset_id != prop]
        self._start_props = (*kept, PropState(asset_id=prop, held_by=person.asset_id, hand=hand))

    # --- cues -----------------------------------------------------------------------------------------------------

    def _cue(self, person: Person, clip: str, start: float, length: float, **fields: object) -> float:
        """Write a cue and keep the body busy with it; return its end."""
        motion = MOTIONS[clip]
        duration = max(1, round(length * self.fps)) if motion.stretches else None
        values = {
            "asset_id": person.asset_id,
            "clip": clip,
            "start": max(0, round(start * self.fps)),
            "duration": duration,
        }
        self.cues.append(Cue.model_validate({**values, **fields}))
        return start + length

    def _start_of(self, person: Person, partner: Person | None = None) -> float:
        return max(self.clock, person.busy, partner.busy if partner else 0.0)

    def _done(self, person: Person, start: float, end: float, *, holds: bool = False) -> None:
        """The next action of somebody else may begin soon after this one began, or when it is over."""
        person.busy, person.acted = max(person.busy, end), True
        self.clock = max(self.clock, end if holds else start + min(0.9, end - start))

    def _rise(self, person: Person, t: float) -> float:
        if person.upright:
            return t
        end = self._cue(person, "rise", t, natural_seconds(MOTIONS["rise"], stature=1.7 * person.k))
        if person.posture in ("lie", "asleep"):
            end += 1.6
        seats = [s for s in self.floor.seats(person.support) if math.dist(s.edge, person.place) < 0.7]
        if seats:
            person.place = seats[0].before(person.k)
        elif person.posture in ("lie", "asleep") and person.support:
            x, y = person.place
            person.place = (x + 0.18 * person.k * math.sin(person.yaw), y - 0.18 * person.k * math.cos(person.yaw))
        person.posture, person.support, person.anchor, person.acted = "stand", None, "", True
        return end

    def _go(self, person: Person, goal: Vec2, yaw: float | None, t: float, clip: str = "walk") -> float:
        """Walk to a place within the time there is, starting nearer where the way is too long; return the end."""
        t = self._rise(person, t)
        motion = MOTIONS[clip]
        people = [p.place for p in self.people.values() if p.present and p is not person]
        people = [spot for spot in people if math.dist(spot, goal) > 0.5 and math.dist(spot, person.place) > 0.3]
        way = self.floor.path(person.place, goal, person.k, people) or self.floor.path(person.place, goal, person.k)
        if way is None:
            return self._cut_to(person, goal, yaw, t)
        length = path_length(way)
        if length < 0.12:
            return self._face(person, yaw, t)
        budget = max(1.8, STRETCH * self.length - t - 0.4)
        seconds = natural_seconds(motion, distance=length, stature=1.7 * person.k)
        if seconds > budget:
            speed = (motion.speed or 1.25) * math.sqrt(person.k)
            fits = max(0.8, (budget - motion.seconds) * speed)
            if person.asset_id in self.leaving and person.acted:
                way = _cut_way(way, fits)
            elif not person.acted:
                way = _cut_way(way[::-1], fits)[::-1]
                self._start_at(person, way[0], facing(way[0], way[1]))
                self.cheats.append(f"{person.asset_id} starts {length - path_length(way):.1f} m nearer")
            length = path_length(way)
            seconds = min(budget, natural_seconds(motion, distance=length, stature=1.7 * person.k))
        first = facing(way[0], way[1])
        last = facing(way[-2], way[-1])
        turn = abs(_turn(person.yaw, first)) + (abs(_turn(last, yaw)) if yaw is not None else 0.0)
        person.place, person.yaw = way[-1], last if yaw is None else yaw
        whole = seconds + (0.9 if turn > math.radians(50) else 0.0)
        end = self._cue(person, clip, t, whole, mark=person.mark(), duration=None)
        person.acted = True
        return end

    def _cut_to(self, person: Person, goal: Vec2, yaw: float | None, t: float) -> float:
        """Nobody can walk there: be there from the start of the shot, if the person has not been seen to move."""
        if not person.acted:
            self._start_at(person, goal, person.yaw if yaw is None else yaw)
            self.cheats.append(f"{person.asset_id} is there when the shot begins: there is no way to walk")
        return t

    def _start_at(self, person: Person, place: Vec2, yaw: float) -> None:
        person.place, person.yaw = place, yaw
        self.starts[person.asset_id] = person.mark(held=self.starts[person.asset_id].held)

    def _face(self, person: Person, yaw: float | None, t: float) -> float:
        if yaw is None or abs(_turn(person.yaw, yaw)) < math.radians(30) or not person.upright:
            return t
        seconds = natural_seconds(MOTIONS["turn"], turn=0.0) * min(1.0, abs(_turn(person.yaw, yaw)) / math.radians(110))
        person.yaw = yaw
        self._cue(person, "turn", t, seconds, mark=person.mark())
        person.acted = True
        return t + seconds

    def _face_person(self, person: Person, other: Person, t: float) -> float:
        """Turn to somebody, cheated towards the audience; only if they are out of a comfortable look."""
        yaw = facing(person.place, other.place)
        if abs(_turn(person.yaw, yaw)) < math.radians(55):
            return t
        return self._face(person, cheated(yaw), t)

    # --- actions --------------------------------------------------------------------------------------------------

    def _act(self, action: CharacterAction, person: Person, later: Sequence[CharacterAction]) -> None:
        motion = clip_of(action.motion)
        partner = self.people.get(action.target_id or "")
        partner = partner if partner is not None and partner.present and partner is not person else None
        prop = self._prop_of(action)
        if motion.key in ("idle", "stand"):
            if action.motion == "stand" and not person.upright:
                start = self._start_of(person)
                self._done(person, start, self._rise(person, start))
            return
        if motion.speed is not None:
            self._travel(action, motion, person, partner, later)
        elif motion.key in ("sit", "lie_down", "lean", "kneel", "crouch", "hide", "fall", "rise", "sleep"):
            self._pose(action, motion, person, partner)
        elif partner is not None and (motion.reach == "person" or motion.key in ("take", "push")):
            self._meet(action, motion, person, partner, prop)
        elif prop is not None and motion.hands:
            self._handle(action, motion, person, prop)
        elif motion.reach == "thing":
            self._at_thing(action, motion, person)
        else:
            self._sign(action, motion, person, partner)

    def _travel(
        self,
        action: CharacterAction,
        motion: Motion,
        person: Person,
        partner: Person | None,
        later: Sequence[CharacterAction],
    ) -> None:
        start = self._start_of(person)
        sits_next = any(
            a.asset_id == person.asset_id and a.target_id == action.target_id and clip_of(a.motion).key == "sit"
            for a in later
        )
        if sits_next:
            return
        goal, yaw = self._goal(action, person, partner)
        end = self._go(person, goal, yaw, start, motion.key)
        self._done(person, start, end)

    def _goal(self, action: CharacterAction, person: Person, partner: Person | None) -> tuple[Vec2, float | None]:
        """Return where a way leads: to a person, a thing, out, some metres ahead, or to one's own place."""
        others = self._others(person)
        if partner is not None:
            return self._beside(person, partner, TALK_DISTANCE)
        thing = self.floor.thing(action.target_id)
        if thing is not None:
            point = self._rail(person, thing)
            spot = self.floor.spot_at(point, person.place, person.k, others, REACH)
            spot = spot or self.floor.free_near(point, person.k, others)
            return spot, facing(spot, thing.location[:2])
        if person.asset_id in self.leaving and self._exit_marks():
            return min(self._exit_marks(), key=lambda spot: math.dist(spot, person.place)), None
        if action.distance:
            x, y = person.place
            wish = (x + action.distance * math.sin(person.yaw), y - action.distance * math.cos(person.yaw))
            return self.floor.free_near(wish, person.k, others), None
        home, yaw = self.home.get(person.asset_id, (self._middle(), 0.0))
        if math.dist(home, person.place) > 1.0:
            return self.floor.free_near(home, person.k, others), yaw
        across = (self._middle()[0] * 2 - person.place[0], person.place[1])
        step = max(-2.5, min(2.5, across[0] - person.place[0])) or 2.0
        return self.floor.free_near((person.place[0] + step, person.place[1]), person.k, others), None

    def _beside(self, person: Person, partner: Person, distance: float) -> tuple[Vec2, float]:
        """Return the free spot at a distance from somebody that reads best: to their side as the audience sees it."""
        others = [spot for spot in self._others(person) if spot != partner.place]
        x, y = partner.place
        best: tuple[float, Vec2] | None = None
        for step in range(24):
            angle = 2 * math.pi * step / 24
            spot = (x + distance * math.sin(angle), y - distance * math.cos(angle))
            room = self.floor.room_at(spot)
            if room < BODY * person.k or not self.floor.inside(spot) or any(math.dist(spot, p) < 0.6 for p in others):
                continue
            out_of_profile = max(0.0, abs(abs(_turn(0.0, angle)) - math.pi / 2) - PROFILE)
            behind = 0.0 if not partner.upright and abs(_turn(partner.yaw, angle)) < math.radians(75) else 0.6
            behind = behind if not partner.upright else 0.25 * abs(_turn(partner.yaw, angle)) / math.pi
            cost = math.dist(spot, person.place) + 1.5 * out_of_profile + 2.0 * behind
            if best is None or cost < best[0] - 1e-9:
                best = (cost, spot)
        spot = best[1] if best else self.floor.free_near((x, y), person.k, [*others, partner.place], apart=distance)
        return spot, cheated(facing(spot, partner.place))

    def _pose(self, action: CharacterAction, motion: Motion, person: Person, partner: Person | None) -> None:
        start = self._start_of(person)
        length = natural_seconds(motion, stature=1.7 * person.k)
        thing = self.floor.thing(action.target_id)
        if motion.key == "rise":
            self._done(person, start, self._rise(person, start))
            return
        if motion.key == "sit":
            self._sit(action, person, start, length)
            return
        if motion.key in ("lie_down", "sleep"):
            self._lie(action, motion, person, start, length)
            return
        t = start
        if motion.key == "lean" and thing is not None and thing.size[2] > 0.6:
            before = person.place, person.yaw
            self._go_to_rail(person, thing)
            goal, yaw = person.place, person.yaw
            person.place, person.yaw, person.support = before[0], before[1], None
            t = self._go(person, goal, yaw, t)
            person.support = thing.node_id
        elif partner is not None and motion.key == "kneel":
            spot, _ = self._beside(person, partner, 0.72)
            t = self._go(person, spot, facing(spot, partner.place), t)
        else:
            t = self._rise(person, t)
        person.posture = motion.after or person.posture
        mark = person.mark() if motion.key == "lean" else None
        end = self._cue(person, motion.key, t, length, mark=mark, mood=action.mood)
        if motion.key == "fall":
            for prop in list(person.held.values()):
                self._lay(person, prop, (*person.place, 0.0))
        self._done(person, start, end)

    def _sit(self, action: CharacterAction, person: Person, start: float, length: float) -> None:
        seat = self._seat_for(person, action.target_id if self.floor.seats(action.target_id) else None)
        if person.posture == "sit" and (seat is None or seat.node_id == person.support):
            return
        t = start
        if seat is not None:
            before = seat.before(person.k)
            blocked = self.floor.room_at(before, (seat.node_id,)) < 0.5 * BODY * person.k
            way = None if blocked else self.floor.path(person.place, before, person.k)
            if way is None and not person.acted:
                self._take_seat(person, seat)
                self.starts[person.asset_id] = person.mark(held=self.starts[person.asset_id].held)
                self.cheats.append(f"{person.asset_id} is seated when the shot begins: the seat cannot be walked to")
                return
            t = self._go(person, before, seat.yaw, t)
            self._take_seat(person, seat)
        else:
            t = self._rise(person, t)
            person.posture, person.support, person.anchor = "sit", None, ""
        self._done(person, start, self._cue(person, "sit", t, length, mark=person.mark(), target_id=person.support))

    def _lie(self, action: CharacterAction, motion: Motion, person: Person, start: float, length: float) -> None:
        asleep: Posture = "asleep" if motion.key == "sleep" else "lie"
        if person.posture in SEATED and (motion.key == "sleep" or person.posture != "sit"):
            person.posture = "asleep" if motion.key == "sleep" else person.posture
            self._done(person, start, self._cue(person, motion.key, start, 1.2))
            return
        before = person.place
        self._go_to_bed(person, action.target_id, asleep)
        bed = person.mark()
        t = start
        if person.support is not None:
            posture, support, anchor = person.posture, person.support, person.anchor
            edge = SeatPlace(support, anchor, person.place, person.yaw)
            person.place, person.posture, person.support = before, "stand", None
            t = self._go(person, edge.before(person.k), edge.yaw, t)
            person.place, person.yaw = edge.edge, edge.yaw
            person.posture, person.support, person.anchor = posture, support, anchor
        end = self._cue(person, "lie_down", t, natural_seconds(MOTIONS["lie_down"]), mark=bed)
        if motion.key == "sleep":
            end = self._cue(person, "sleep", end, length)
        self._done(person, start, end)

    def _meet(self, action: CharacterAction, motion: Motion, person: Person, partner: Person, prop: str | None) -> None:
        """Go to somebody and do something together."""
        start = self._start_of(person, partner)
        t = start
        giving = motion.key == "give"
        if giving and prop is not None and not person.hand_of(prop):
            self._found_in_hand(person, prop)
        distance = motion.distance * 0.5 * (person.k + partner.k)
        if partner.posture in SEATED:
            distance = max(distance, 0.68)
        gap = math.dist(person.place, partner.place)
        if person.posture not in SEATED and (gap > distance + 0.3 or gap < distance - 0.3):
            spot, _ = self._beside(person, partner, distance)
            t = self._go(person, spot, facing(spot, partner.place), t)
        if partner.upright:
            partner.yaw, partner.acted = facing(partner.place, person.place), True
        if person.upright:
            person.yaw = facing(person.place, partner.place)
        length = natural_seconds(motion)
        hand = person.hand_of(prop) if prop else None
        end = self._cue(
            person, motion.key, t, length, target_id=partner.asset_id, prop_id=prop, hand=hand, mood=action.mood
        )
        if prop is not None and giving:
            self._hand_over(partner, prop)
        elif prop is not None and motion.key == "take":
            self._hand_over(person, prop)
        partner.busy = max(partner.busy, end)
        self._done(person, start, end, holds=True)

    def _handle(self, action: CharacterAction, motion: Motion, person: Person, prop: str) -> None:
        """Do something with a prop, after going to it or having it in hand."""
        start = self._start_of(person)
        t, key = start, motion.key
        getting = key in ("pick_up", "take", "hold")
        holder = self._holder(prop)
        if getting and person.hand_of(prop):
            return
        if key == "take" and holder is not None and holder is not person and holder.present:
            self._meet(action, motion, person, holder, prop)
            return
        lies = self.lying.get(prop)
        if lies is not None and not person.hand_of(prop):
            near = math.dist(lies[:2], person.place)
            if person.upright and near > REACH + 0.1 and near < 5.0:
                spot = self.floor.spot_at(lies[:2], person.place, person.k, self._others(person), REACH)
                if spot is not None:
                    t = self._go(person, spot, facing(spot, lies[:2]), t)
                    near = math.dist(lies[:2], person.place)
            if near <= 1.0:
                t = self._cue(
                    person, "pick_up", t, natural_seconds(MOTIONS["pick_up"]), prop_id=prop, hand=person.free_hand()
                )
                self._hand_over(person, prop)
                if getting:
                    self._done(person, start, t)
                    return
        if not person.hand_of(prop):
            self._found_in_hand(person, prop)
            if getting:
                return
        target = action.target_id if action.target_id != prop else None
        hand = person.hand_of(prop)
        mark = None
        if key in ("put_down", "drop", "throw"):
            t, mark = self._let_go(action, person, prop, t, key)
        known = target if target in self.people or self.floor.thing(target) else None
        length = natural_seconds(motion)
        end = self._cue(person, key, t, length, target_id=known, prop_id=prop, hand=hand, mark=mark, mood=action.mood)
        self._done(person, start, end)

    def _let_go(
        self, action: CharacterAction, person: Person, prop: str, t: float, key: str
    ) -> tuple[float, Mark | None]:
        """Choose where a prop goes when it leaves the hand, and go there."""
        thing = self.floor.thing(action.target_id) if action.target_id != prop else None
        if key != "put_down":
            partner = self.people.get(action.target_id or "")
            goal = partner.place if partner is not None and partner.present else None
            ahead = 0.35 if key == "drop" else 3.0
            x, y = person.place
            landing = goal or (x + ahead * math.sin(person.yaw), y - ahead * math.cos(person.yaw))
            self._lay(person, prop, (*landing, 0.0))
            return t, None
        if thing is None or not (thing.of_kind("top") or thing.size[2] < 1.4):
            thing = self.floor.nearest_top(person.place, 2.5)
        if thing is None:
            x, y = person.place
            spot: Vec3 = (x + 0.42 * person.k * math.sin(person.yaw), y - 0.42 * person.k * math.cos(person.yaw), 0.0)
        else:
            spot = self._clear_of_props(self.floor.top_of(thing, person.place))
            if person.upright and math.dist(spot[:2], person.place) > REACH + 0.1:
                stand = self.floor.spot_at(spot[:2], person.place, person.k, self._others(person), REACH)
                if stand is not None:
                    t = self._go(person, stand, facing(stand, spot[:2]), t)
                    spot = self._clear_of_props(self.floor.top_of(thing, person.place))
        self._lay(person, prop, spot)
        rounded = (round(spot[0], 3), round(spot[1], 3), round(spot[2], 3))
        return t, Mark(asset_id=prop, location=rounded, yaw=round(math.degrees(person.yaw) % 360, 1))

    def _clear_of_props(self, spot: Vec3) -> Vec3:
        """Move a place on a top aside until nothing stands there."""
        taken = [place for place in self.lying.values() if abs(place[2] - spot[2]) < 0.1]
        for dx, dy in ((0.0, 0.0), (0.18, 0.0), (-0.18, 0.0), (0.0, 0.16), (0.0, -0.16), (0.3, 0.1), (-0.3, 0.1)):
            moved = (spot[0] + dx, spot[1] + dy, spot[2])
            if all(math.dist(moved[:2], place[:2]) > 0.15 for place in taken):
                return moved
        return spot

    def _lay(self, person: Person, prop: str, place: Vec3) -> None:
        person.held = {hand: held for hand, held in person.held.items() if held != prop}
        self.lying[prop] = place
        self.touched[prop] = None

    def _at_thing(self, action: CharacterAction, motion: Motion, person: Person) -> None:
        """Go to a door, a window, a table and work there."""
        start = self._start_of(person)
        t, thing = start, self.floor.thing(action.target_id)
        if thing is not None and person.upright:
            point = self._rail(person, thing)
            handle = next(iter(thing.of_kind("handle")), None)
            if handle is not None:
                point = thing.world(handle.location)[:2]
            if math.dist(point, person.place) > REACH:
                spot = self.floor.spot_at(point, person.place, person.k, self._others(person), 0.55)
                if spot is not None:
                    t = self._go(person, spot, facing(spot, point), t)
        target = thing.node_id if thing is not None else None
        end = self._cue(person, motion.key, t, natural_seconds(motion), target_id=target, mood=action.mood)
        self._done(person, start, end)

    def _sign(self, action: CharacterAction, motion: Motion, person: Person, partner: Person | None) -> None:
        """Looks, gestures and everything one does on the spot."""
        start = self._start_of(person)
        t = start
        thing = self.floor.thing(action.target_id)
        if partner is not None:
            t = self._face_person(person, partner, t)
        elif thing is not None and person.upright:
            yaw = facing(person.place, thing.location[:2])
            if abs(_turn(person.yaw, yaw)) > math.radians(70):
                t = self._face(person, yaw, t)
        elif motion.key == "turn":
            self._done(person, start, self._face(person, person.yaw + math.pi, t))
            return
        if motion.key == "turn":
            self._done(person, start, max(t, start + 0.3))
            return
        target = partner.asset_id if partner else thing.node_id if thing else self._prop_of(action)
        end = self._cue(person, motion.key, t, natural_seconds(motion), target_id=target, mood=action.mood)
        if motion.key == "wake" and person.posture == "asleep":
            person.posture = (
                "sit" if self.floor.seats(person.support) and not self.floor.beds(person.support) else "lie"
            )
        self._done(person, start, end)

    # --- speech ---------------------------------------------------------------------------------------------------

    def _speech_seconds(self, shot: ShotContext, lines: Sequence[ScriptLine]) -> dict[int, float]:
        """Return the length of every spoken action: its words, fitted into the shot."""
        spoken: dict[int, float] = {}
        for number, action in enumerate(shot.character_actions):
            if clip_of(action.motion).key in SPOKEN:
                line = _line(action, lines)
                words = len(re.findall(r"[\w'’-]+", line.text)) if line else 0
                spoken[number] = max(1.2, words / 2.5 + 0.4) if words else MOTIONS["talk"].seconds
        total = sum(spoken.values())
        fit = max(0.5, min(1.0, (self.length - 0.4) / total)) if total else 1.0
        return {number: seconds * fit for number, seconds in spoken.items()}

    def _speak(
        self,
        action: CharacterAction,
        person: Person,
        seconds: float,
        lines: Sequence[ScriptLine],
        cast: Sequence[Person],
    ) -> None:
        line = _line(action, lines)
        mood = action.mood if action.mood != "neutral" else mood_of(line.parenthetical if line else "")
        partner = self.people.get(action.target_id or "")
        others = [p for p in cast if p is not person and p.posture != "asleep"]
        if partner is None or not partner.present or partner is person:
            partner = min(others, key=lambda p: math.dist(p.place, person.place), default=None)
        walking = person.busy
        start = max(self.clock, walking - 0.8 if person.upright else walking)
        if partner is not None and start >= walking:
            start = self._face_person(person, partner, start)
        target = partner.asset_id if partner else None
        end = self._cue(person, clip_of(action.motion).key, start, seconds, target_id=target, mood=mood)
        for listener in others:
            if listener.busy <= start + 0.3:
                if math.dist(listener.place, person.place) < 6:
                    self._face_person(listener, person, start + 0.1)
                self._cue(listener, "listen", start + 0.15, seconds, target_id=person.asset_id)
            else:
                self._cue(listener, "look", max(start, listener.busy), 0.6, target_id=person.asset_id)
        person.acted = True
        person.busy = max(person.busy, end)
        self.clock = end

    def _idle_looks(self, shot: ShotContext, cast: Sequence[Person]) -> None:
        """Who has nothing to do at first looks where the script says, or at whoever acts."""
        looks: Mapping[str, str | None] = {state.asset_id: state.looking_at for state in shot.states}
        first = min(self.cues, key=lambda cue: cue.start, default=None)
        for person in cast:
            if person.posture == "asleep" or any(c.asset_id == person.asset_id and c.start < 12 for c in self.cues):
                continue
            wanted = looks.get(person.asset_id)
            thing = self.floor.thing(wanted)
            target = wanted if wanted in self.people and self.people[wanted].present else thing and thing.node_id
            if target is None and first is not None and first.asset_id != person.asset_id:
                target = first.asset_id
            if target is not None and target != person.asset_id:
                self.cues.append(Cue(asset_id=person.asset_id, clip="look", start=0, duration=12, target_id=target))


def cheated(yaw: float) -> float:
    """Return a facing turned some degrees towards the audience at -Y."""
    away = _turn(yaw, 0.0)
    return yaw + max(-CHEAT, min(CHEAT, away))


def mood_of(parenthetical: str) -> Mood:
    """Return the mood a parenthetical asks for."""
    words = parenthetical.lower()
    for pattern, mood in PARENTHETICALS:
        if re.search(pattern, words):
            return mood
    return "neutral"


def _turn(a: float, b: float) -> float:
    return (b - a + math.pi) % (2 * math.pi) - math.pi


def _line(action: CharacterAction, lines: Sequence[ScriptLine]) -> ScriptLine | None:
    index = action.line_index
    return lines[index] if index is not None and 0 <= index < len(lines) else None


def _cut_way(way: Sequence[Vec2], length: float) -> list[Vec2]:
    """Return the first metres of a way."""
    kept = [way[0]]
    for a, b in itertools.pairwise(way):
        step = math.dist(a, b)
        if step >= length:
            w = length / max(1e-9, step)
            return [*kept, (a[0] + (b[0] - a[0]) * w, a[1] + (b[1] - a[1]) * w)]
        kept.append(b)
        length -= step
    return kept


def _stature(asset: Asset) -> float:
    if asset.canonical is not None:
        return asset.canonical.dimensions[2]
    return (asset.look.stature if asset.look else None) or 1.7

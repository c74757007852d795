"""The cue sheet of one shot: its cues, and the walks of people in the time there is. Pure.

Times are seconds of the shot: ``now`` is when a person is ready, a returned time when they are done. Places are in
metres in the set; yaws are in radians, counter-clockwise, and 0 faces the audience at -Y.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.agents.visual_effects_artist.crossings import Crossing, find_boarding_way, vessel_at
from storyblender.agents.visual_effects_artist.floor import BODY, PERSONAL, WALK_ON_OUTDOORS, facing
from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.agents.visual_effects_artist.way_points import find_way, passed_on
from storyblender.agents.visual_effects_artist.ways import point_on_line, shorten_way, turn_towards_audience
from storyblender.catalog.motions import AIMED, MOTIONS, natural_seconds, turning_seconds
from storyblender.geometry.boxes import shortest_turn
from storyblender.geometry.paths import Vec2, path_length
from storyblender.memory.shot_context import CharacterAction, Cue, Flaw, Mark, PropState
from storyblender.memory.vocabulary import Hand

TALK_DISTANCE = 1.15
"""Metres between two people who talk; 1.0 to 1.4 reads as talking."""
PROFILE = math.radians(48)
"""Radians: largest angle between the line from person to person and the picture plane, so that both faces show."""
LONGEST_RATIO = 1.5
"""A shot may grow to this many times the Director's length before walks are cut short."""
LONGEST_EXTRA = 9.0
"""Seconds by which a shot may grow in any case before walks are cut short."""
LAST_ACTION = 8.0
"""Seconds after that limit in which the last action of a shot may still be played."""
HURRY = 1.5
"""Largest factor by which a person who is short of time walks faster."""
SLIDE = 0.75
"""Seconds to come between chair and table, or out."""
BY_IT = 1.2
"""Metres from a thing within which a person who leaves with it or through it walks on, out of the scene."""
ON_THE_MOVE = 1.6
"""Seconds of a walk without a goal in the script."""
REACH = 0.62
"""Metres from which a standing person handles a thing."""


class CueSheet:
    """The cues of one shot, while they are being written.

    Args:
        stage: People and props.
        seconds: The Director's length of the shot.
        fps: Frames per second.
        leaving: Asset ids of people who are not on stage in the next shot.
        starts: Everybody's start mark, by asset id.
        props: Where the props are when the shot begins.

    Attributes:
        clock: Second from which the next action may begin.
        cheats: Flaws that note what was cut short or moved.
    """

    def __init__(
        self,
        stage: StageState,
        seconds: float,
        fps: int,
        leaving: set[str],
        starts: dict[str, Mark],
        props: tuple[PropState, ...],
    ) -> None:
        self.stage, self.length, self.fps, self.leaving = stage, seconds, fps, leaving
        self.starts, self.start_props = starts, props
        self.cues: list[Cue] = []
        self.cheats: list[Flaw] = []
        self.clock = 0.2

    def note_cheat(self, person: StagedPerson, what: str) -> None:
        """Note how a person's action differs from the script; ``what`` follows the name: ``starts 2.0 m nearer``."""
        self.cheats.append(Flaw(kind="cheat", subject=person.asset_id, message=f"{person.asset_id} {what}"))

    @property
    def soft_limit(self) -> float:
        """Seconds to which the shot may grow before walks are cut short."""
        return max(LONGEST_RATIO * self.length, self.length + LONGEST_EXTRA)

    @property
    def hard_limit(self) -> float:
        """Seconds to which the shot may grow at most."""
        return self.soft_limit + LAST_ACTION

    def add_cue(self, person: StagedPerson, clip: str, start: float, length: float, **fields: object) -> float:
        """Write a cue; return the second of the shot at which it ends.

        Args:
            person: The person who acts.
            clip: Key of the motion.
            start: Second of the shot at which the cue starts.
            length: Seconds; the length of a motion that cannot be stretched is not written.
            fields: More fields of the cue.
        """
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

    def earliest_start(self, person: StagedPerson) -> float:
        """Return the second of the shot from which a person may begin the next action."""
        return max(self.clock, person.busy)

    def finish_action(self, person: StagedPerson, start: float, end: float, *, holds: bool = False) -> None:
        """Keep a person busy to the end of an action, and set the clock for the next action of anyone.

        Args:
            person: The person who acts.
            start: Second of the shot at which the action starts.
            end: Second of the shot at which it ends.
            holds: Whether the next action waits for the end, not only for the first 0.9 s.
        """
        person.busy, person.acted = max(person.busy, end), True
        self.clock = max(self.clock, end if holds else start + min(0.9, end - start))

    def stand_up(self, person: StagedPerson, now: float) -> float:
        """Let a person stand up from second ``now`` on, if they do not stand; return the second at which they stand."""
        if person.upright:
            return now
        end = self.add_cue(person, "rise", now, natural_seconds(MOTIONS["rise"], stature=1.7 * person.scale))
        if person.posture in ("lie", "asleep"):
            end += 1.6
        places = self.stage.floor.seats(person.support, asked=True)
        seats = [s for s in places if math.dist(s.edge, person.place) < 0.7]
        if seats:
            person.place = self.stage.floor.seat_access(seats[0], person.scale)
            end += SLIDE if math.dist(person.place, seats[0].standing_spot(person.scale)) > 0.12 else 0.0
        elif person.posture in ("lie", "asleep") and person.support:
            x, y = person.place
            person.place = (
                x + 0.18 * person.scale * math.sin(person.yaw),
                y - 0.18 * person.scale * math.cos(person.yaw),
            )
        person.posture, person.support, person.anchor, person.acted = "stand", None, "", True
        return end

    def walk_to(
        self, person: StagedPerson, goal: Vec2, yaw: float | None, now: float, clip: str = "walk", then: float = 0.0
    ) -> float:
        """Let a person walk to a place; return the second of the arrival. A walk too long for the shot starts nearer.

        Args:
            person: The person.
            goal: Place on the floor, metres in the set.
            yaw: Facing on arrival, radians; None keeps the heading.
            now: Second of the shot at which the person is ready.
            clip: Key of a motion that travels.
            then: Seconds that the person needs after arriving.
        """
        now = self._leave_or_board_boat(person, goal, self.stand_up(person, now))
        if clip == "walk" and person.pace:
            clip, person.pace = person.pace, ""
        motion = MOTIONS[clip]
        people = [p.place for p in self.stage.people.values() if p.present and p is not person]
        people = [spot for spot in people if math.dist(spot, goal) > 0.5 and math.dist(spot, person.place) > 0.3]
        floor = self.stage.floor
        if (way := find_way(floor, person, goal, people)) is None:
            return self.place_by_cut(person, goal, yaw, now)
        length = path_length(way)
        if length < 0.12:
            return self.turn_to_yaw(person, yaw, now)
        person.z = 0.0
        budget = max(1.8, self.soft_limit - now - then - 0.4)
        seconds = natural_seconds(motion, distance=length, stature=1.7 * person.scale)
        hurried = seconds > budget
        if hurried:
            speed = (motion.speed or 1.25) * math.sqrt(person.scale)
            fits = max(0.8, (budget - motion.seconds) * speed)
            if person.asset_id in self.leaving and person.acted:
                way = shorten_way(way, fits)
            elif not person.acted:
                way = shorten_way(way[::-1], fits)[::-1]
                self.move_start_mark(person, way[0], facing(way[0], way[1]))
                self.note_cheat(person, f"starts {length - path_length(way):.1f} m nearer")
            length = path_length(way)
            natural = natural_seconds(motion, distance=length, stature=1.7 * person.scale)
            seconds = min(natural, max(budget, natural / HURRY))
        first, last = facing(way[0], way[1]), facing(way[-2], way[-1])
        turns = (shortest_turn(person.yaw, first), 0.0 if yaw is None else shortest_turn(last, yaw))
        person.place, person.yaw = way[-1], last if yaw is None else yaw
        whole = seconds + sum(turning_seconds(math.degrees(turn), 1.7 * person.scale) for turn in turns)
        duration = round(whole * self.fps) if hurried else None
        via = passed_on(person, way)
        person.acted = True
        return self.add_cue(person, clip, now, whole, mark=person.mark(), duration=duration, via=via)

    def raise_arrival(self, person: StagedPerson, height: float, now: float) -> float:
        """End a person's last walk at a height in metres, such as on steps or a stage; return its end, ``now``."""
        person.z = height
        for index in range(len(self.cues) - 1, -1, -1):
            cue = self.cues[index]
            mark = cue.mark if cue.clip not in AIMED else None
            if mark is not None and cue.asset_id == person.asset_id:
                raised = mark.model_copy(update={"location": (*mark.location[:2], round(height, 3))})
                self.cues[index] = cue.model_copy(update={"mark": raised})
                break
        return now

    def cross_obstacle(self, person: StagedPerson, way: Crossing, now: float, clip: str, thing: str) -> float:
        """Let a person leap or climb over a thing (node id), from the near end of a way to its far end.

        ``clip`` is the key of the motion, ``now`` and the return value the seconds at which it starts and ends."""
        person.place, person.yaw, person.acted = way.far, facing(way.near, way.far), True
        return self.add_cue(person, clip, now, natural_seconds(MOTIONS[clip]), mark=person.mark(), target_id=thing)

    def _leave_or_board_boat(self, person: StagedPerson, goal: Vec2, now: float) -> float:
        """Let a person climb out of a boat, or into one at the goal; return the second at which that ends."""
        floor = self.stage.floor
        here, there = vessel_at(floor, person.place), vessel_at(floor, goal)
        if here is there:
            return now
        if here is not None:
            way = find_boarding_way(floor, here, person.place, goal, person.scale)
            now = self.cross_obstacle(person, way.back, now, "climb", here.node_id) if way else now
        if there is not None:
            way = find_boarding_way(floor, there, goal, person.place, person.scale)
            if way is not None:
                now = self.walk_to(person, way.near, facing(way.near, way.far), now)
                now = self.cross_obstacle(person, way, now, "climb", there.node_id)
        return now

    def place_by_cut(self, person: StagedPerson, goal: Vec2, yaw: float | None, now: float) -> float:
        """Cut a person to a goal and yaw (None keeps it), at the shot's start if they have stayed, else its end."""
        if not person.acted:
            self.move_start_mark(person, goal, person.yaw if yaw is None else yaw)
            self.note_cheat(person, "is there when the shot begins: there is no way to walk")
        elif self._has_stayed(person):
            start = self.starts[person.asset_id]
            place = (round(goal[0], 3), round(goal[1], 3), 0.0)
            self.starts[person.asset_id] = start.model_copy(update={"location": place})
            for index, cue in enumerate(self.cues):
                if cue.mark is not None and cue.mark.asset_id == person.asset_id:
                    self.cues[index] = cue.model_copy(update={"mark": cue.mark.model_copy(update={"location": place})})
            person.place = goal
            self.note_cheat(person, "is there when the shot begins: there is no way to walk")
            return self.turn_to_yaw(person, yaw, now)
        else:
            self.stage.next_places[person.asset_id] = (goal, person.yaw if yaw is None else yaw)
            self.note_cheat(person, "is there when the next shot begins: there is no way to walk")
        return now

    def _has_stayed(self, person: StagedPerson) -> bool:
        """Tell whether a person has stood on their start mark in this shot so far and has handled no prop."""
        start = self.starts[person.asset_id]
        own = [cue for cue in self.cues if cue.asset_id == person.asset_id]
        marks = [cue.mark for cue in own if cue.mark is not None]
        on_the_spot = all(mark.asset_id == person.asset_id and mark.location == start.location for mark in marks)
        handled = any(MOTIONS[cue.clip].hands and cue.prop_id for cue in own)
        return start.posture == "stand" and on_the_spot and not handled

    def move_start_mark(self, person: StagedPerson, place: Vec2, yaw: float) -> None:
        """Let a person begin the shot at another place and yaw."""
        person.place, person.yaw = place, yaw
        self.starts[person.asset_id] = person.mark(held=self.starts[person.asset_id].held)

    def turn_to_yaw(self, person: StagedPerson, yaw: float | None, now: float) -> float:
        """Turn a standing person to a yaw, if by 30 degrees or more (None: not at all); return the second it ends."""
        if yaw is None or abs(shortest_turn(person.yaw, yaw)) < math.radians(30) or not person.upright:
            return now
        seconds = turning_seconds(math.degrees(shortest_turn(person.yaw, yaw)), 1.7 * person.scale)
        person.yaw = yaw
        self.add_cue(person, "turn", now, seconds, mark=person.mark())
        person.acted = True
        return now + seconds

    def turn_to_person(self, person: StagedPerson, other: StagedPerson, now: float) -> float:
        """Turn to another person if they are over 55 degrees off; return the time in seconds at which that is done."""
        yaw = facing(person.place, other.place)
        if person.watches or abs(shortest_turn(person.yaw, yaw)) < math.radians(55):
            return now
        return self.turn_to_yaw(person, turn_towards_audience(yaw), now)

    def start_with_prop_in_hand(self, person: StagedPerson, prop: str) -> None:
        """Let a person hold a prop (asset id) from the shot's first frame on."""
        hand = self.stage.put_in_hand(person, prop)
        if hand is None:
            return
        start = self.starts[person.asset_id]
        if not any(held == prop for _, held in start.held):
            self.starts[person.asset_id] = start.model_copy(update={"held": (*start.held, (hand, prop))})
        kept = [state for state in self.start_props if state.asset_id != prop]
        self.start_props = (*kept, PropState(asset_id=prop, held_by=person.asset_id, hand=hand))

    def move_to_other_hand(self, person: StagedPerson, prop: str) -> None:
        """Change the hand that holds a prop (asset id) in the whole shot, if the other hand is free all the time."""
        hand = person.hand_of(prop)
        other: Hand = "L" if hand == "R" else "R"
        own = [cue for cue in self.cues if cue.asset_id == person.asset_id]
        if hand is None or other in person.held or any(cue.hand == other for cue in own):
            return
        person.held = {other: prop, **{side: held for side, held in person.held.items() if held != prop}}
        start = self.starts[person.asset_id]
        held = tuple((other, name) if name == prop else (side, name) for side, name in start.held)
        self.starts[person.asset_id] = start.model_copy(update={"held": held})
        in_hand = (person.asset_id, prop)
        self.start_props = tuple(
            state.model_copy(update={"hand": other})
            if (state.held_by, state.asset_id) == in_hand and state.hand is not None
            else state
            for state in self.start_props
        )
        self.cues = [
            cue.model_copy(update={"hand": other}) if (cue.asset_id, cue.prop_id) == in_hand and cue.hand else cue
            for cue in self.cues
        ]

    def start_with_prop_in_clothes(self, person: StagedPerson, prop: str) -> None:
        """Let a person carry a prop (asset id) out of sight, in no hand, from the shot's first frame on."""
        kept = [state for state in self.start_props if state.asset_id != prop]
        self.start_props = (*kept, PropState(asset_id=prop, held_by=person.asset_id))

    def find_spot_beside(self, person: StagedPerson, partner: StagedPerson, distance: float) -> tuple[Vec2, float]:
        """Return a person's free spot ``distance`` metres from a partner that shows both best, and the yaw there."""
        others = [spot for spot in self.stage.others(person) if spot != partner.place]
        x, y = partner.place
        best: tuple[float, Vec2] | None = None
        for step in range(24):
            angle = 2 * math.pi * step / 24
            spot = (x + distance * math.sin(angle), y - distance * math.cos(angle))
            room = self.stage.floor.room_at(spot)
            if (
                room < BODY * person.scale
                or not self.stage.floor.inside(spot)
                or any(math.dist(spot, p) < 0.6 for p in others)
            ):
                continue
            out_of_profile = max(0.0, abs(abs(shortest_turn(0.0, angle)) - math.pi / 2) - PROFILE)
            behind = 0.0 if not partner.upright and abs(shortest_turn(partner.yaw, angle)) < math.radians(75) else 0.6
            behind = behind if not partner.upright else 0.25 * abs(shortest_turn(partner.yaw, angle)) / math.pi
            cost = math.dist(spot, person.place) + 1.5 * out_of_profile + 2.0 * behind
            if best is None or cost < best[0] - 1e-9:
                best = (cost, spot)
        spot = (
            best[1]
            if best
            else self.stage.floor.free_spot((x, y), person.scale, [*others, partner.place], apart=distance)
        )
        return spot, turn_towards_audience(facing(spot, partner.place))

    def find_goal(
        self, action: CharacterAction, person: StagedPerson, partner: StagedPerson | None, speed: float
    ) -> tuple[Vec2, float | None]:
        """Return the goal and the final yaw of a walk to a partner, a thing, an exit, a point ahead or the own place.

        ``action`` has the thing, the exit or the metres ahead; ``speed``, in m/s, limits a walk without any of them.
        A yaw of None keeps the heading."""
        others = self.stage.others(person)
        if partner is not None:
            return self.find_spot_beside(person, partner, TALK_DISTANCE)
        leaves = person.asset_id in self.leaving and bool(self.stage.floor.exit_marks())
        thing = self.stage.floor.thing(action.target_id)
        point = thing.nearest_edge(person.place) if thing is not None else person.place
        if leaves and not self.stage.floor.inside(point):  # to a plane on the field: out, on its side
            return self._find_exit_towards(person, point, others), None
        if thing is not None and not (leaves and math.dist(point, person.place) < BY_IT):
            spot = self.stage.floor.spot_around(point, person.place, person.scale, others, REACH)
            spot = spot or self.stage.floor.free_spot(point, person.scale, others)
            return spot, facing(spot, thing.location[:2])
        up = "stairs" if action.motion == "climb" and not person.entering else None
        named = self.stage.floor.mark_of(action.target_id or up)
        if named is not None:
            return self.stage.floor.free_spot(named, person.scale, others), None
        if leaves:
            return min(self.stage.floor.exit_marks(), key=lambda spot: math.dist(spot, person.place)), None
        if action.distance:
            x, y = person.place
            wish = (x + action.distance * math.sin(person.yaw), y - action.distance * math.cos(person.yaw))
            return self.stage.floor.free_spot(wish, person.scale, others), None
        home, yaw = self.stage.home.get(person.asset_id, (self.stage.floor.middle(), 0.0))
        if math.dist(home, person.place) > 1.0:
            return self.stage.floor.free_spot(home, person.scale, others), yaw
        across = 2 * (self.stage.floor.middle()[0] - person.place[0])
        most = max(2.5, ON_THE_MOVE * speed)
        step = max(-most, min(most, across)) or 2.0
        return self.stage.floor.free_spot((person.place[0] + step, person.place[1]), person.scale, others), None

    def _find_exit_towards(self, person: StagedPerson, point: Vec2, others: Sequence[Vec2]) -> Vec2:
        """Return the spot where a person who leaves for a point off stage is last seen: on the way or at an exit."""
        floor, apart = self.stage.floor, math.dist(point, person.place)
        for part in (1.0, 0.8, 0.6) if floor.open_air else ():
            step = part * min(WALK_ON_OUTDOORS, apart - REACH)
            spot = point_on_line(person.place, point, step)
            free = (
                all(math.dist(spot, other) > PERSONAL for other in others) and floor.room_at(spot) > BODY * person.scale
            )
            if step > REACH and free and floor.inside(spot, -floor.walk_on_distance):
                return spot
        return min(self.stage.floor.exit_marks(), key=lambda spot: math.dist(spot, point))

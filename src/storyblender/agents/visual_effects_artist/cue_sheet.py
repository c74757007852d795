"""The cue sheet of one shot: cues on a clock, and where people go in the time there is. Pure."""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.agents.visual_effects_artist.company import Company
from storyblender.agents.visual_effects_artist.crossings import Crossing, aboard, vessel_at
from storyblender.agents.visual_effects_artist.floor import BODY, PERSONAL, WAY_OUT, facing
from storyblender.agents.visual_effects_artist.person import Person
from storyblender.agents.visual_effects_artist.ways import point_on_line, shorten_way, turn_towards_audience
from storyblender.catalog.motions import AIMED, MOTIONS, natural_seconds, turning_seconds
from storyblender.geometry.boxes import shortest_turn
from storyblender.geometry.paths import Vec2, path_length
from storyblender.memory.shot_context import CharacterAction, Cue, Flaw, Mark, PropState
from storyblender.memory.vocabulary import Hand

TALK_DISTANCE = 1.15
"""Metres between two people who talk; 1.0 to 1.4 reads as talking."""
PROFILE = math.radians(48)
"""Two who meet stand within this angle of the audience's plane, so that neither hides the other."""
STRETCH, EXTRA = 1.5, 9.0
"""A shot may grow to so many times the Director's length, or by so many seconds, before ways are cut short."""
LAST = 8.0
"""Seconds beyond that in which the last thing meant for a shot may still be done, or nobody would ever see it."""
HURRY = 1.5
"""Who is short of time walks up to this many times as fast."""
SLIDE = 0.75
"""Seconds to come between chair and table, or out."""
BY_IT = 1.2
"""Metres; who is that near to what they leave with or through goes on, out of the scene."""
ON_THE_MOVE = 1.6
"""Seconds of a way that leads nowhere in particular."""
REACH = 0.62
"""Metres from which a standing person handles a thing."""


class CueSheet:
    """What happens in a shot, as it is being written.

    Args:
        company: People and props.
        seconds: The Director's length of the shot.
        fps: Frames per second.
        leaving: Who is not on stage in the next shot.
        starts: Everybody's start mark.
        props: Where the props are when the shot begins.

    Attributes:
        clock: Second from which the next action may begin.
        cheats: What was cut short or moved.
    """

    def __init__(
        self,
        company: Company,
        seconds: float,
        fps: int,
        leaving: set[str],
        starts: dict[str, Mark],
        props: tuple[PropState, ...],
    ) -> None:
        self.company, self.length, self.fps, self.leaving = company, seconds, fps, leaving
        self.starts, self.start_props = starts, props
        self.cues: list[Cue] = []
        self.cheats: list[Flaw] = []
        self.clock = 0.2

    def cheat(self, person: Person, what: str) -> None:
        """Note that somebody does not do what was read as it was read, e.g. ``starts 2.0 m nearer``."""
        self.cheats.append(Flaw(kind="cheat", subject=person.asset_id, message=f"{person.asset_id} {what}"))

    @property
    def limit(self) -> float:
        """Seconds to which the shot may grow before ways are cut short."""
        return max(STRETCH * self.length, self.length + EXTRA)

    @property
    def latest(self) -> float:
        """Seconds to which the shot may grow at all."""
        return self.limit + LAST

    def cue(self, person: Person, clip: str, start: float, length: float, **fields: object) -> float:
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

    def start_of(self, person: Person) -> float:
        """Return when a person may begin the next action."""
        return max(self.clock, person.busy)

    def done(self, person: Person, start: float, end: float, *, holds: bool = False) -> None:
        """The next action of somebody else may begin soon after this one began, or when it is over."""
        person.busy, person.acted = max(person.busy, end), True
        self.clock = max(self.clock, end if holds else start + min(0.9, end - start))

    def rise(self, person: Person, t: float) -> float:
        """Stand up first, where needed; return the end."""
        if person.upright:
            return t
        end = self.cue(person, "rise", t, natural_seconds(MOTIONS["rise"], stature=1.7 * person.scale))
        if person.posture in ("lie", "asleep"):
            end += 1.6
        places = self.company.floor.seats(person.support, asked=True)
        seats = [s for s in places if math.dist(s.edge, person.place) < 0.7]
        if seats:
            person.place = self.company.floor.access(seats[0], person.scale)
            end += SLIDE if math.dist(person.place, seats[0].before(person.scale)) > 0.12 else 0.0
        elif person.posture in ("lie", "asleep") and person.support:
            x, y = person.place
            person.place = (
                x + 0.18 * person.scale * math.sin(person.yaw),
                y - 0.18 * person.scale * math.cos(person.yaw),
            )
        person.posture, person.support, person.anchor, person.acted = "stand", None, "", True
        return end

    def go(
        self, person: Person, goal: Vec2, yaw: float | None, t: float, clip: str = "walk", then: float = 0.0
    ) -> float:
        """Walk to a place within the time there is, starting nearer where the way is too long; return the end.

        Args:
            person: Who.
            goal: Where to.
            yaw: Facing on arrival, radians; None keeps the heading.
            t: Second of the shot.
            clip: How: a motion that travels.
            then: Seconds that the person needs after arriving.
        """
        t = self._over_the_side(person, goal, self.rise(person, t))
        if clip == "walk" and person.pace:
            clip, person.pace = person.pace, ""
        motion = MOTIONS[clip]
        people = [p.place for p in self.company.people.values() if p.present and p is not person]
        people = [spot for spot in people if math.dist(spot, goal) > 0.5 and math.dist(spot, person.place) > 0.3]
        floor = self.company.floor
        way = floor.path(person.place, goal, person.scale, people) or floor.path(person.place, goal, person.scale)
        if way is None:
            return self.cut_to(person, goal, yaw, t)
        length = path_length(way)
        if length < 0.12:
            return self.face(person, yaw, t)
        person.z = 0.0
        budget = max(1.8, self.limit - t - then - 0.4)
        seconds = natural_seconds(motion, distance=length, stature=1.7 * person.scale)
        hurried = seconds > budget
        if hurried:
            speed = (motion.speed or 1.25) * math.sqrt(person.scale)
            fits = max(0.8, (budget - motion.seconds) * speed)
            if person.asset_id in self.leaving and person.acted:
                way = shorten_way(way, fits)
            elif not person.acted:
                way = shorten_way(way[::-1], fits)[::-1]
                self.start_at(person, way[0], facing(way[0], way[1]))
                self.cheat(person, f"starts {length - path_length(way):.1f} m nearer")
            length = path_length(way)
            natural = natural_seconds(motion, distance=length, stature=1.7 * person.scale)
            seconds = min(natural, max(budget, natural / HURRY))
        first, last = facing(way[0], way[1]), facing(way[-2], way[-1])
        turns = (shortest_turn(person.yaw, first), 0.0 if yaw is None else shortest_turn(last, yaw))
        person.place, person.yaw = way[-1], last if yaw is None else yaw
        whole = seconds + sum(turning_seconds(math.degrees(turn), 1.7 * person.scale) for turn in turns)
        duration = round(whole * self.fps) if hurried else None
        end = self.cue(person, clip, t, whole, mark=person.mark(), duration=duration)
        person.acted = True
        return end

    def lifted(self, person: Person, height: float, t: float) -> float:
        """End a person's last walk at a height in metres, such as on steps or a stage; return its end time."""
        person.z = height
        for index in range(len(self.cues) - 1, -1, -1):
            cue = self.cues[index]
            mark = cue.mark if cue.clip not in AIMED else None
            if mark is not None and cue.asset_id == person.asset_id:
                raised = mark.model_copy(update={"location": (*mark.location[:2], round(height, 3))})
                self.cues[index] = cue.model_copy(update={"mark": raised})
                break
        return t

    def cross(self, person: Person, way: Crossing, t: float, clip: str, thing: str) -> float:
        """Leap or climb over a thing from where the way begins; return the end."""
        person.place, person.yaw, person.acted = way.far, facing(way.near, way.far), True
        return self.cue(person, clip, t, natural_seconds(MOTIONS[clip]), mark=person.mark(), target_id=thing)

    def _over_the_side(self, person: Person, goal: Vec2, t: float) -> float:
        """Leave the boat one is in, or come aboard the one where one is going; return the end."""
        floor = self.company.floor
        here, there = vessel_at(floor, person.place), vessel_at(floor, goal)
        if here is there:
            return t
        if here is not None:
            way = aboard(floor, here, person.place, goal, person.scale)
            t = self.cross(person, way.back, t, "climb", here.node_id) if way else t
        if there is not None:
            way = aboard(floor, there, goal, person.place, person.scale)
            if way is not None:
                t = self.go(person, way.near, facing(way.near, way.far), t)
                t = self.cross(person, way, t, "climb", there.node_id)
        return t

    def cut_to(self, person: Person, goal: Vec2, yaw: float | None, t: float) -> float:
        """Nobody can walk there: be there from the start of the shot, if the person has not left their place in it."""
        if not person.acted:
            self.start_at(person, goal, person.yaw if yaw is None else yaw)
            self.cheat(person, "is there when the shot begins: there is no way to walk")
        elif self._has_stayed(person):
            start = self.starts[person.asset_id]
            place = (round(goal[0], 3), round(goal[1], 3), 0.0)
            self.starts[person.asset_id] = start.model_copy(update={"location": place})
            for index, cue in enumerate(self.cues):
                if cue.mark is not None and cue.mark.asset_id == person.asset_id:
                    self.cues[index] = cue.model_copy(update={"mark": cue.mark.model_copy(update={"location": place})})
            person.place = goal
            self.cheat(person, "is there when the shot begins: there is no way to walk")
            return self.face(person, yaw, t)
        else:
            self.company.jumps[person.asset_id] = (goal, person.yaw if yaw is None else yaw)
            self.cheat(person, "is there when the next shot begins: there is no way to walk")
        return t

    def _has_stayed(self, person: Person) -> bool:
        """Tell whether all that a person has done in this shot was done standing where they stood when it began."""
        start = self.starts[person.asset_id]
        own = [cue for cue in self.cues if cue.asset_id == person.asset_id]
        marks = [cue.mark for cue in own if cue.mark is not None]
        on_the_spot = all(mark.asset_id == person.asset_id and mark.location == start.location for mark in marks)
        handled = any(MOTIONS[cue.clip].hands and cue.prop_id for cue in own)
        return start.posture == "stand" and on_the_spot and not handled

    def start_at(self, person: Person, place: Vec2, yaw: float) -> None:
        """Move the start mark: the person begins the shot there."""
        person.place, person.yaw = place, yaw
        self.starts[person.asset_id] = person.mark(held=self.starts[person.asset_id].held)

    def face(self, person: Person, yaw: float | None, t: float) -> float:
        """Turn on the spot where the turn is worth it; return the end."""
        if yaw is None or abs(shortest_turn(person.yaw, yaw)) < math.radians(30) or not person.upright:
            return t
        seconds = turning_seconds(math.degrees(shortest_turn(person.yaw, yaw)), 1.7 * person.scale)
        person.yaw = yaw
        self.cue(person, "turn", t, seconds, mark=person.mark())
        person.acted = True
        return t + seconds

    def face_person(self, person: Person, other: Person, t: float) -> float:
        """Turn to another person and a little towards the audience; only if they are more than 55 degrees aside."""
        yaw = facing(person.place, other.place)
        if abs(shortest_turn(person.yaw, yaw)) < math.radians(55):
            return t
        return self.face(person, turn_towards_audience(yaw), t)

    def found_in_hand(self, person: Person, prop: str) -> None:
        """Let a person hold a prop from the shot's first frame on: a cut nobody sees."""
        hand = self.company.hand_over(person, prop)
        if hand is None:
            return
        start = self.starts[person.asset_id]
        if not any(held == prop for _, held in start.held):
            self.starts[person.asset_id] = start.model_copy(update={"held": (*start.held, (hand, prop))})
        kept = [state for state in self.start_props if state.asset_id != prop]
        self.start_props = (*kept, PropState(asset_id=prop, held_by=person.asset_id, hand=hand))

    def change_hand(self, person: Person, prop: str) -> None:
        """Let a person have a prop in the other hand, if that is free, for as long as they have it in this shot."""
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

    def found_in_clothes(self, person: Person, prop: str) -> None:
        """Let a person have a prop on them, in no hand, from the shot's first frame on."""
        kept = [state for state in self.start_props if state.asset_id != prop]
        self.start_props = (*kept, PropState(asset_id=prop, held_by=person.asset_id))

    def beside(self, person: Person, partner: Person, distance: float) -> tuple[Vec2, float]:
        """Return the free spot at a distance from somebody that reads best: to their side as the audience sees it."""
        others = [spot for spot in self.company.others(person) if spot != partner.place]
        x, y = partner.place
        best: tuple[float, Vec2] | None = None
        for step in range(24):
            angle = 2 * math.pi * step / 24
            spot = (x + distance * math.sin(angle), y - distance * math.cos(angle))
            room = self.company.floor.room_at(spot)
            if (
                room < BODY * person.scale
                or not self.company.floor.inside(spot)
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
            else self.company.floor.free_near((x, y), person.scale, [*others, partner.place], apart=distance)
        )
        return spot, turn_towards_audience(facing(spot, partner.place))

    def goal(
        self, action: CharacterAction, person: Person, partner: Person | None, speed: float
    ) -> tuple[Vec2, float | None]:
        """Return where a way leads: to a person, a thing, out, some metres ahead, or to one's own place."""
        others = self.company.others(person)
        if partner is not None:
            return self.beside(person, partner, TALK_DISTANCE)
        leaves = person.asset_id in self.leaving and bool(self.company.exit_marks())
        thing = self.company.floor.thing(action.target_id)
        point = thing.rim(person.place) if thing is not None else person.place
        if leaves and not self.company.floor.inside(point):  # to a plane on the field: out, on its side
            return self._out_towards(person, point, others), None
        if thing is not None and not (leaves and math.dist(point, person.place) < BY_IT):
            spot = self.company.floor.spot_at(point, person.place, person.scale, others, REACH)
            spot = spot or self.company.floor.free_near(point, person.scale, others)
            return spot, facing(spot, thing.location[:2])
        up = "stairs" if action.motion == "climb" and not person.entering else None
        named = self.company.floor.mark_of(action.target_id or up)
        if named is not None:
            return self.company.floor.free_near(named, person.scale, others), None
        if leaves:
            return min(self.company.exit_marks(), key=lambda spot: math.dist(spot, person.place)), None
        if action.distance:
            x, y = person.place
            wish = (x + action.distance * math.sin(person.yaw), y - action.distance * math.cos(person.yaw))
            return self.company.floor.free_near(wish, person.scale, others), None
        home, yaw = self.company.home.get(person.asset_id, (self.company.middle(), 0.0))
        if math.dist(home, person.place) > 1.0:
            return self.company.floor.free_near(home, person.scale, others), yaw
        across = 2 * (self.company.middle()[0] - person.place[0])
        most = max(2.5, ON_THE_MOVE * speed)
        step = max(-most, min(most, across)) or 2.0
        return self.company.floor.free_near((person.place[0] + step, person.place[1]), person.scale, others), None

    def _out_towards(self, person: Person, point: Vec2, others: Sequence[Vec2]) -> Vec2:
        """Return where one is last seen who leaves for what stands off stage: on the way there, or where one goes out.

        Each has a way of their own: two who leave together do not end on one spot.
        """
        floor, apart = self.company.floor, math.dist(point, person.place)
        for part in (1.0, 0.8, 0.6) if floor.open_air else ():
            step = part * min(WAY_OUT, apart - REACH)
            spot = point_on_line(person.place, point, step)
            free = (
                all(math.dist(spot, other) > PERSONAL for other in others) and floor.room_at(spot) > BODY * person.scale
            )
            if step > REACH and free and floor.inside(spot, -floor.beyond):
                return spot
        return min(self.company.exit_marks(), key=lambda spot: math.dist(spot, point))

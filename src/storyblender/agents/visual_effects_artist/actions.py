"""Actions of the script turned into walks, postures and clips on the cue sheet. Pure."""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.agents.visual_effects_artist.company import SEATED, Company, Person, turn_between
from storyblender.agents.visual_effects_artist.crossings import across, is_vessel, seat_aboard
from storyblender.agents.visual_effects_artist.cue_sheet import REACH, SLIDE, CueSheet
from storyblender.agents.visual_effects_artist.floor import BODY, SeatPlace, facing
from storyblender.catalog.motions import MOTIONS, Motion, clip_of, natural_seconds
from storyblender.memory.base import Vec3
from storyblender.memory.shot_context import CharacterAction, Mark
from storyblender.memory.vocabulary import Posture

GETTING = frozenset({"pick_up", "take", "hold", "catch"})
"""Motions after which one has something in hand."""
SEATED_REACH = 0.45
"""Metres from a seat's edge to what its sitter can take."""
ASIDE = math.radians(60)
"""What is farther aside than this is turned to before it is handled."""


class Actions:
    """Writes the actions of one shot.

    Args:
        company: People and props.
        sheet: Where the cues go.
    """

    def __init__(self, company: Company, sheet: CueSheet) -> None:
        self.company, self.sheet = company, sheet

    def act(self, action: CharacterAction, person: Person, later: Sequence[CharacterAction]) -> None:
        """Write one action that is not a speech."""
        motion = clip_of(action.motion)
        partner = self.company.people.get(action.target_id or "")
        partner = partner if partner is not None and partner.present and partner is not person else None
        prop = self.company.prop_of(action)
        if person.entering and not person.acted and self.company.opens_a_door(action):
            return  # the door swings for who comes in
        if motion.key in ("idle", "stand"):
            if action.motion == "stand" and not person.upright:
                start = self.sheet.start_of(person)
                self.sheet.done(person, start, self.sheet.rise(person, start))
            return
        if motion.key in ("jump", "climb") and self._cross(action, motion, person):
            return
        if motion.key == "climb" and self.company.floor.thing(action.target_id) is None:
            motion = MOTIONS["walk"]  # what one would climb is not there: one goes
        if motion.key == "take" and partner is not None and prop is None:
            motion = MOTIONS["touch"]  # somebody is seized, not something
        if motion.speed is not None:
            self._travel(action, motion, person, partner, later)
        elif motion.key in ("sit", "lie_down", "lean", "kneel", "crouch", "hide", "fall", "rise", "sleep"):
            self._pose(action, motion, person, partner)
        elif partner is not None and (motion.reach == "person" or motion.key in ("take", "catch", "push")):
            self._meet(action, motion, person, partner, prop)
        elif prop is not None and motion.hands:
            self._handle(action, motion, person, prop, later)
        elif motion.reach == "thing" or motion.key == "jump":
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
        start = self.sheet.start_of(person)
        sits_next = any(
            a.asset_id == person.asset_id and a.target_id == action.target_id and clip_of(a.motion).key == "sit"
            for a in later
        )
        goes_on = any(
            a.asset_id == person.asset_id and a.target_id and clip_of(a.motion).speed is not None for a in later
        )
        own = [clip_of(a.motion) for a in later if a.asset_id == person.asset_id]
        goes_over = bool(own) and (own[0].speed is not None or own[0].key in ("jump", "climb"))
        if sits_next or (not action.target_id and (goes_over or (person.entering and goes_on))):
            person.pace = motion.key
            return
        goal, yaw = self.sheet.goal(action, person, partner, motion.speed or 0.0)
        end = self.sheet.go(person, goal, yaw, start, motion.key)
        self.sheet.done(person, start, end)

    def _cross(self, action: CharacterAction, motion: Motion, person: Person) -> bool:
        """Leap or climb over a thing, or into a boat; tell whether there is one to get over."""
        floor = self.company.floor
        thing = floor.things.get(getattr(floor.thing(action.target_id), "node_id", ""))
        if thing is None:
            return False
        start = self.sheet.start_of(person)
        if is_vessel(thing):
            self._sit(action, person, start, natural_seconds(MOTIONS["sit"], stature=1.7 * person.k))
            return True
        way = across(floor, thing, person.place, person.k, self.company.others(person))
        if way is None:
            return False
        t = self.sheet.go(person, way.near, facing(way.near, way.far), start)
        self.sheet.done(person, start, self.sheet.cross(person, way, t, motion.key, thing.node_id))
        return True

    def _pose(self, action: CharacterAction, motion: Motion, person: Person, partner: Person | None) -> None:
        start = self.sheet.start_of(person)
        length = natural_seconds(motion, stature=1.7 * person.k)
        thing = self.company.floor.thing(action.target_id)
        if motion.key == "rise":
            self.sheet.done(person, start, self.sheet.rise(person, start))
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
            self.company.go_to_rail(person, thing)
            goal, yaw = person.place, person.yaw
            person.place, person.yaw, person.support = before[0], before[1], None
            t = self.sheet.go(person, goal, yaw, t)
            person.support = thing.node_id
        elif partner is not None and motion.key == "kneel":
            spot, _ = self.sheet.beside(person, partner, 0.72)
            t = self.sheet.go(person, spot, facing(spot, partner.place), t)
        else:
            t = self.sheet.rise(person, t)
        person.posture = motion.after or person.posture
        mark = person.mark() if motion.key == "lean" else None
        end = self.sheet.cue(person, motion.key, t, length, mark=mark, mood=action.mood)
        if motion.key == "fall":
            for prop in list(person.held.values()):
                self.company.lay(person, prop, (*person.place, 0.0))
        self.sheet.done(person, start, end)

    def _sit(self, action: CharacterAction, person: Person, start: float, length: float) -> None:
        name = action.target_id if self.company.floor.seats(action.target_id) else None
        seat = self.company.seat_for(person, name, self.company.people.get(action.target_id or ""))
        if person.posture == "sit" and (seat is None or seat.node_id == person.support):
            return
        t = start
        if seat is not None:
            before = self.company.floor.access(seat, person.k)
            blocked = self.company.floor.room_at(before, (seat.node_id,)) < 0.5 * BODY * person.k
            way = None if blocked else self.company.floor.path(person.place, before, person.k)
            if way is None and not person.acted and not seat_aboard(self.company.floor, seat):
                self.company.take_seat(person, seat)
                self.sheet.starts[person.asset_id] = person.mark(held=self.sheet.starts[person.asset_id].held)
                self.sheet.cheats.append(
                    f"{person.asset_id} is seated when the shot begins: the seat cannot be walked to"
                )
                return
            length += SLIDE if math.dist(before, seat.before(person.k)) > 0.12 else 0.0
            t = self.sheet.go(person, before, seat.yaw, t, then=length)
            self.company.take_seat(person, seat)
        else:
            t = self.sheet.rise(person, t)
            person.posture, person.support, person.anchor = "sit", None, ""
        self.sheet.done(
            person, start, self.sheet.cue(person, "sit", t, length, mark=person.mark(), target_id=person.support)
        )

    def _lie(self, action: CharacterAction, motion: Motion, person: Person, start: float, length: float) -> None:
        asleep: Posture = "asleep" if motion.key == "sleep" else "lie"
        if person.posture in SEATED and (motion.key == "sleep" or person.posture != "sit"):
            person.posture = "asleep" if motion.key == "sleep" else person.posture
            self.sheet.done(person, start, self.sheet.cue(person, motion.key, start, 1.2))
            return
        before = person.place
        self.company.go_to_bed(person, action.target_id, asleep)
        bed = person.mark()
        t = start
        if person.support is not None:
            posture, support, anchor = person.posture, person.support, person.anchor
            edge = SeatPlace(support, anchor, person.place, person.yaw)
            person.place, person.posture, person.support = before, "stand", None
            t = self.sheet.go(person, edge.before(person.k), edge.yaw, t)
            person.place, person.yaw = edge.edge, edge.yaw
            person.posture, person.support, person.anchor = posture, support, anchor
        end = self.sheet.cue(person, "lie_down", t, natural_seconds(MOTIONS["lie_down"]), mark=bed)
        if motion.key == "sleep":
            end = self.sheet.cue(person, "sleep", end, length)
        self.sheet.done(person, start, end)

    def _meet(self, action: CharacterAction, motion: Motion, person: Person, partner: Person, prop: str | None) -> None:
        """Go to somebody and do something together."""
        start = self.sheet.start_of(person, partner)
        t = start
        giving = motion.key == "give"
        if giving and prop is not None and not person.hand_of(prop):
            self.sheet.found_in_hand(person, prop)
        distance = motion.distance * 0.5 * (person.k + partner.k)
        if partner.posture in SEATED:
            distance = max(distance, 0.68)
        gap = math.dist(person.place, partner.place)
        if person.posture not in SEATED and (gap > distance + 0.3 or gap < distance - 0.3):
            spot, _ = self.sheet.beside(person, partner, distance)
            t = self.sheet.go(person, spot, facing(spot, partner.place), t, then=natural_seconds(motion))
        if partner.upright:
            partner.yaw, partner.acted = facing(partner.place, person.place), True
        if person.upright:
            person.yaw = facing(person.place, partner.place)
        length = natural_seconds(motion)
        hand = person.hand_of(prop) if prop else None
        end = self.sheet.cue(
            person, motion.key, t, length, target_id=partner.asset_id, prop_id=prop, hand=hand, mood=action.mood
        )
        if prop is not None and giving:
            self.company.hand_over(partner, prop)
        elif prop is not None and motion.key == "take":
            self.company.hand_over(person, prop)
        partner.busy = max(partner.busy, end)
        self.sheet.done(person, start, end, holds=True)

    def _handle(
        self, action: CharacterAction, motion: Motion, person: Person, prop: str, later: Sequence[CharacterAction]
    ) -> None:
        """Do something with a prop, after going to it or having it in hand."""
        start = self.sheet.start_of(person)
        t, key = start, motion.key
        getting = key in GETTING
        holder = self.company.holder(prop)
        if getting and person.hand_of(prop):
            return
        if key in ("take", "catch") and holder is not None and holder is not person and holder.present:
            self._meet(action, motion, person, holder, prop)
            return
        lies = self.company.lying.get(prop)
        if lies is not None and not person.hand_of(prop):
            near = math.dist(lies[:2], person.place)
            if person.upright and REACH < near < 5.0:
                spot = self.company.floor.spot_at(lies[:2], person.place, person.k, self.company.others(person), REACH)
                if spot is not None:
                    t = self.sheet.go(person, spot, facing(spot, lies[:2]), t)
                    near = math.dist(lies[:2], person.place)
            if near <= (REACH + 0.25 if person.upright else SEATED_REACH):
                t = self._turn_to(person, lies, t)
                t = self.sheet.cue(
                    person, "pick_up", t, natural_seconds(MOTIONS["pick_up"]), prop_id=prop, hand=person.free_hand()
                )
                self.company.hand_over(person, prop)
                if getting:
                    self.sheet.done(person, start, t)
                    return
        bag = self.company.bag_for(person, prop) if getting else None
        if bag is not None:
            t = self.sheet.cue(
                person, "take", t, natural_seconds(motion), target_id=bag, prop_id=prop, hand=person.free_hand()
            )
            self.company.hand_over(person, prop)
            self.sheet.done(person, start, t)
            return
        if not person.hand_of(prop):
            self.sheet.found_in_hand(person, prop)
            if getting:
                return
        catcher = self._catcher(person, prop, later) if key == "throw" else None
        if catcher is not None:
            self._pass(person, catcher, prop, t)
            return
        target = action.target_id if action.target_id != prop else None
        hand = person.hand_of(prop)
        mark = None
        if key in ("put_down", "drop", "throw"):
            t, mark = self._let_go(action, person, prop, t, key)
        known = target if target in self.company.people or self.company.floor.thing(target) else None
        length = natural_seconds(motion)
        end = self.sheet.cue(
            person, key, t, length, target_id=known, prop_id=prop, hand=hand, mark=mark, mood=action.mood
        )
        self.sheet.done(person, start, end)

    def _catcher(self, person: Person, prop: str, later: Sequence[CharacterAction]) -> Person | None:
        """Return who catches what a person throws."""
        for action in later:
            catcher = self.company.people.get(action.asset_id)
            if catcher is None or catcher is person or self.company.prop_of(action) != prop:
                continue
            able = catcher.present and catcher.free_hand() and catcher.posture not in ("lie", "asleep")
            return catcher if able and clip_of(action.motion).key in GETTING else None
        return None

    def _pass(self, person: Person, catcher: Person, prop: str, t: float) -> None:
        """Throw something that somebody catches."""
        start = t
        t = self.sheet.face(person, facing(person.place, catcher.place), max(t, catcher.busy))
        if catcher.upright:
            t = max(t, self.sheet.face(catcher, facing(catcher.place, person.place), t))
        hand = person.hand_of(prop)
        end = self.sheet.cue(
            person, "throw", t, natural_seconds(MOTIONS["throw"]), target_id=catcher.asset_id, prop_id=prop, hand=hand
        )
        free = catcher.free_hand()
        caught = self.sheet.cue(
            catcher, "catch", t, natural_seconds(MOTIONS["catch"]), target_id=person.asset_id, prop_id=prop, hand=free
        )
        self.company.hand_over(catcher, prop)
        self.sheet.done(person, start, end)
        self.sheet.done(catcher, start, caught, holds=True)

    def _let_go(
        self, action: CharacterAction, person: Person, prop: str, t: float, key: str
    ) -> tuple[float, Mark | None]:
        """Choose where a prop goes when it leaves the hand, and go there."""
        thing = self.company.floor.thing(action.target_id) if action.target_id != prop else None
        if key != "put_down":
            partner = self.company.people.get(action.target_id or "")
            goal = partner.place if partner is not None and partner.present else None
            ahead = 0.35 if key == "drop" else 3.0
            x, y = person.place
            landing = goal or (x + ahead * math.sin(person.yaw), y - ahead * math.cos(person.yaw))
            self.company.lay(person, prop, (*landing, 0.0))
            return t, None
        if thing is None or not (thing.of_kind("top") or thing.size[2] < 1.4):
            thing = self.company.floor.nearest_top(person.place, 2.5)
        if thing is None:
            x, y = person.place
            spot: Vec3 = (x + 0.42 * person.k * math.sin(person.yaw), y - 0.42 * person.k * math.cos(person.yaw), 0.0)
        else:
            spot = self.company.clear_of_props(self.company.floor.top_of(thing, person.place))
            if person.upright and math.dist(spot[:2], person.place) > REACH:
                stand = self.company.floor.spot_at(spot[:2], person.place, person.k, self.company.others(person), REACH)
                if stand is not None:
                    t = self.sheet.go(person, stand, facing(stand, spot[:2]), t)
                    spot = self.company.clear_of_props(self.company.floor.top_of(thing, person.place))
        t = self._turn_to(person, spot, t)
        self.company.lay(person, prop, spot)
        rounded = (round(spot[0], 3), round(spot[1], 3), round(spot[2], 3))
        return t, Mark(asset_id=prop, location=rounded, yaw=round(math.degrees(person.yaw) % 360, 1))

    def _turn_to(self, person: Person, spot: Vec3, t: float) -> float:
        """Face what the hands are about to work on; return the end."""
        if math.dist(spot[:2], person.place) < 0.2:
            return t
        yaw = facing(person.place, spot[:2])
        return self.sheet.face(person, yaw, t) if abs(turn_between(person.yaw, yaw)) > ASIDE else t

    def _at_thing(self, action: CharacterAction, motion: Motion, person: Person) -> None:
        """Go to a door, a window, a table and work there."""
        start = self.sheet.start_of(person)
        t, thing = start, self.company.floor.thing(action.target_id)
        if thing is not None and person.upright:
            point = self.company.rail(person, thing)
            handle = next(iter(thing.of_kind("handle")), None)
            if handle is not None:
                point = thing.world(handle.location)[:2]
            if math.dist(point, person.place) > REACH:
                spot = self.company.floor.spot_at(point, person.place, person.k, self.company.others(person), 0.55)
                if spot is not None:
                    t = self.sheet.go(person, spot, facing(spot, point), t)
            t = self.sheet.face(person, facing(person.place, point), t)
        target = thing.node_id if thing is not None else None
        end = self.sheet.cue(person, motion.key, t, natural_seconds(motion), target_id=target, mood=action.mood)
        self.sheet.done(person, start, end)

    def _sign(self, action: CharacterAction, motion: Motion, person: Person, partner: Person | None) -> None:
        """Looks, gestures and everything one does on the spot."""
        start = self.sheet.start_of(person)
        t = start
        thing = self.company.floor.thing(action.target_id)
        if partner is not None:
            t = self.sheet.face_person(person, partner, t)
        elif thing is not None and person.upright:
            yaw = facing(person.place, thing.location[:2])
            if abs(turn_between(person.yaw, yaw)) > math.radians(70):
                t = self.sheet.face(person, yaw, t)
        elif motion.key == "turn":
            self.sheet.done(person, start, self.sheet.face(person, person.yaw + math.pi, t))
            return
        if motion.key == "turn":
            self.sheet.done(person, start, max(t, start + 0.3))
            return
        target = partner.asset_id if partner else thing.node_id if thing else self.company.prop_of(action)
        end = self.sheet.cue(person, motion.key, t, natural_seconds(motion), target_id=target, mood=action.mood)
        if motion.key == "wake" and person.posture == "asleep":
            person.posture = (
                "sit"
                if self.company.floor.seats(person.support) and not self.company.floor.beds(person.support)
                else "lie"
            )
        self.sheet.done(person, start, end)

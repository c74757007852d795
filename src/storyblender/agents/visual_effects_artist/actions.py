"""Writes the actions of a shot on the cue sheet: walks, postures, clips, and actions with props and partners."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from storyblender.agents.visual_effects_artist.action_resolver import ActionResolver
from storyblender.agents.visual_effects_artist.crossings import find_crossing, is_seat_in_vessel, is_vessel
from storyblender.agents.visual_effects_artist.cue_sheet import REACH, SLIDE, CueSheet
from storyblender.agents.visual_effects_artist.floor import BODY, facing
from storyblender.agents.visual_effects_artist.handling import Handling
from storyblender.agents.visual_effects_artist.interactions import Interactions
from storyblender.agents.visual_effects_artist.on_the_floor import find_room_on_floor
from storyblender.agents.visual_effects_artist.person import SEATED, StagedPerson
from storyblender.agents.visual_effects_artist.placed_objects import SeatPlace
from storyblender.agents.visual_effects_artist.recorded_actions import play_recorded
from storyblender.agents.visual_effects_artist.speeches import SPOKEN
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.agents.visual_effects_artist.vehicle_doors import boarding_station, leaving_station
from storyblender.catalog.acts import ACTS
from storyblender.catalog.motions import MOTIONS, STANDING, Motion, natural_seconds
from storyblender.geometry.boxes import shortest_turn
from storyblender.geometry.paths import Vec2
from storyblender.geometry.stations import Station
from storyblender.memory.shot_context import BodyState, CharacterAction
from storyblender.memory.vocabulary import Posture

DIRECTIONAL_LOOKS = frozenset(
    {"look_up", "look_down", "look_back", "look_left", "look_right", "look_away", "check_watch"}
)
"""Looks in a direction, not at a person or thing: the body does not turn."""
HANDSET_SIZE = 0.12
"""Second largest extent in metres above which a telephone stays where it stands."""
PARTNER_MOTIONS = frozenset({"take", "catch", "push", "dance"})
"""Motions that involve the other person if the script names one."""
LEAST_MOVE = 0.05
"""Metres below which nobody moves."""


class Actions:
    """Writes the actions of one shot.

    Args:
        stage: The people and props of the scene.
        sheet: The cue sheet that takes the cues.
        ends: Each person's state at the end of the shot, by asset id.
    """

    def __init__(self, stage: StageState, sheet: CueSheet, ends: Mapping[str, BodyState] | None = None) -> None:
        self.stage, self.sheet, self.ends = stage, sheet, ends or {}
        self.resolver, self.hands = ActionResolver(stage, self.ends), Handling(stage, sheet)
        self.interactions = Interactions(stage, sheet, self.hands)

    def add_action(self, action: CharacterAction, person: StagedPerson, later: Sequence[CharacterAction]) -> None:
        """Write the cues of one action that is not a speech.

        Args:
            action: The action in the script.
            person: The person who does it.
            later: Actions of the shot after this one.
        """
        if action.mocap is not None and play_recorded(self.stage, self.sheet, action, person, self.ends):
            return
        prop = self.resolver.prop_of(action, person)
        motion, partner = self.resolver.find_partner(action, person, prop)
        if person.entering and not person.acted and self.stage.opens_set_door(action):
            return  # the door swings by itself for an entrance
        if motion.key in STANDING:
            if motion.key == "stand" and not person.upright:
                start = self.sheet.earliest_start(person)
                self.sheet.finish_action(person, start, self.sheet.stand_up(person, start))
            return
        if motion.key in ("jump", "climb") and self._get_over_or_onto(action, motion, person):
            return
        if motion.key == "put_down" and partner is not None and prop is None:
            return  # a lifted person is already back on the floor
        motion = self.resolver.resolve_motion(action, motion, person, prop, partner if prop is None else None)
        if self.interactions.is_done_by_partner(motion, person, partner):
            return
        if motion.speed is not None:
            self._travel(action, motion, person, partner, later)
        elif motion.key in ("sit", "lie_down", "lean", "kneel", "crouch", "hide", "fall", "rise", "sleep"):
            self._take_posture(action, motion, person, partner)
        elif partner is not None and (motion.reach == "person" or motion.key in PARTNER_MOTIONS):
            if motion.key == "give" and prop is not None and not person.hand_of(prop):
                self.hands.fetch_prop(person, prop)
            self.interactions.act_together(action, motion, person, partner, prop, later)
        elif prop is not None and motion.hands and not self._is_worked_on_in_place(action, motion, person, prop):
            self._use_prop(action, motion, person, prop, later)
        elif motion.reach == "thing" or motion.key in ("jump", "touch"):
            self._act_at_thing(action, motion, person)
        else:
            self._act_on_the_spot(action, motion, person, partner)

    def _travel(
        self,
        action: CharacterAction,
        motion: Motion,
        person: StagedPerson,
        partner: StagedPerson | None,
        later: Sequence[CharacterAction],
    ) -> None:
        """Write a walk, ride or other way; it is left out if a later action implies it."""
        start = self.sheet.earliest_start(person)
        riding = motion.key in ("drive", "ride")
        out = None if riding else leaving_station(self.stage, person, action)
        if out is not None:
            vehicle, door = out
            person.posture, person.support, person.anchor = "stand", None, ""
            self.sheet.move_start_mark(person, (door.x, door.y), door.yaw + math.pi)
            if self.stage.floor.thing(action.target_id) is vehicle:
                self.sheet.finish_action(person, start, start + 0.8)
                return
        sits_next = any(
            a.asset_id == person.asset_id and a.target_id == action.target_id and a.motion == "sit" for a in later
        )
        goes_on = any(
            a.asset_id == person.asset_id and a.target_id and MOTIONS[a.motion].speed is not None for a in later
        )
        own = [MOTIONS[a.motion] for a in later if a.asset_id == person.asset_id]
        goes_over = bool(own) and (own[0].speed is not None or own[0].key in ("jump", "climb"))
        meets_next = bool(own) and own[0].reach == "person" and self._next_target(person, later) == action.target_id
        if (
            sits_next
            or (partner is not None and meets_next)
            or (not action.target_id and (goes_over or (person.entering and goes_on)))
        ):
            person.pace = motion.key
            return
        if partner is None and not action.target_id:
            partner = self._find_person_met_later(person, later)
        goal, yaw = self.sheet.find_goal(action, person, partner, motion.speed or 0.0)
        if person.goal is not None:
            goal, yaw = self.stage.floor.free_spot(person.goal, person.scale, self.stage.others(person)), None
        told = None if goes_on or person.goal is not None else self._station_at_end(person)
        if told is not None:
            goal, yaw = (told.x, told.y), told.yaw
        end = self.sheet.walk_to(person, goal, yaw, start, motion.key)
        if told is not None and told.z != person.z:
            end = self.sheet.raise_arrival(person, told.z, end)
        state = self.ends.get(person.asset_id)
        if told is not None and state is not None and state.posture in SEATED:
            end = self.sheet.add_cue(person, "bend", end, 0.8)  # the head first, through the open door
        self.sheet.finish_action(person, start, end)

    def _station_at_end(self, person: StagedPerson) -> Station | None:
        """Return a person's standing place at the end of the shot, if the script gives one; else None."""
        state = self.ends.get(person.asset_id)
        if state is not None and state.posture in SEATED and person.upright:
            return boarding_station(self.stage, person, state)
        if state is None or state.spot is None or state.posture in SEATED:
            return None
        person.spot = state.spot
        return self.stage.spot_finder.find_station(person, state.spot)

    def _find_person_met_later(self, person: StagedPerson, later: Sequence[CharacterAction]) -> StagedPerson | None:
        """Return the person to whom a walk without a goal leads: ``crosses the floor and embraces her``.

        A person without a layout place also walks to the one they then speak to.
        """
        homeless = person.asset_id not in self.stage.home
        for action in (each for each in later if each.asset_id == person.asset_id):
            partner, motion = self.stage.people.get(action.target_id or ""), MOTIONS[action.motion]
            if motion.speed is not None:
                return None
            meets = motion.reach == "person" or (homeless and motion.key in SPOKEN)
            if partner is not None and partner.present and meets:
                return partner
        return None

    def _next_target(self, person: StagedPerson, later: Sequence[CharacterAction]) -> str | None:
        """Return the target id of a person's next action."""
        return next((a.target_id for a in later if a.asset_id == person.asset_id), None)

    def _get_over_or_onto(self, action: CharacterAction, motion: Motion, person: StagedPerson) -> bool:
        """Climb or leap onto or over the target of an action; return whether that is possible."""
        return self._get_onto_thing(action, motion, person) or self._cross_thing(action, motion, person)

    def _get_onto_thing(self, action: CharacterAction, motion: Motion, person: StagedPerson) -> bool:
        """Climb or leap onto a thing if the person ends the shot on it; return whether they do."""
        state, floor = self.ends.get(person.asset_id), self.stage.floor
        thing = floor.thing(action.target_id, person.place)
        if state is None or state.spot is None or state.spot.relation != "on" or thing is None:
            return False
        if floor.thing(state.spot.anchor_id, person.place) is not thing:
            return False
        start = self.sheet.earliest_start(person)
        if self.stage.spot_finder.seat_of_spot(person, state) is not None:
            self._sit_down(action, person, start, natural_seconds(MOTIONS["sit"], stature=1.7 * person.scale))
            return True
        top = self.stage.spot_finder.find_station(person, state.spot)
        if top is None or top.z <= 0:
            return False
        foot = floor.free_spot(thing.nearest_edge(person.place), person.scale, self.stage.others(person))
        now = self.sheet.walk_to(person, foot, facing(foot, (top.x, top.y)), start)
        person.spot, person.place, person.yaw, person.z, person.acted = state.spot, (top.x, top.y), top.yaw, top.z, True
        seconds = natural_seconds(MOTIONS[motion.key])
        end = self.sheet.add_cue(person, motion.key, now, seconds, mark=person.mark(), target_id=thing.node_id)
        self.sheet.finish_action(person, start, end)
        return True

    def _cross_thing(self, action: CharacterAction, motion: Motion, person: StagedPerson) -> bool:
        """Leap or climb over a thing, or into a boat; return whether that is possible."""
        floor = self.stage.floor
        thing = floor.things.get(getattr(floor.thing(action.target_id), "node_id", ""))
        if thing is None:
            return False
        start = self.sheet.earliest_start(person)
        if is_vessel(thing):
            self._sit_down(action, person, start, natural_seconds(MOTIONS["sit"], stature=1.7 * person.scale))
            return True
        way = find_crossing(floor, thing, person.place, person.scale, self.stage.others(person))
        if way is None:
            return False
        now = self.sheet.walk_to(person, way.near, facing(way.near, way.far), start)
        self.sheet.finish_action(person, start, self.sheet.cross_obstacle(person, way, now, motion.key, thing.node_id))
        return True

    def _take_posture(
        self, action: CharacterAction, motion: Motion, person: StagedPerson, partner: StagedPerson | None
    ) -> None:
        """Write the cues of sitting, lying, leaning, kneeling, falling or rising, with the walk to the place."""
        start = self.sheet.earliest_start(person)
        length = natural_seconds(motion, stature=1.7 * person.scale)
        thing = self.stage.floor.thing(action.target_id)
        if motion.key == "rise":
            self.sheet.finish_action(person, start, self.sheet.stand_up(person, start))
            return
        if motion.key == "sit":
            self._sit_down(action, person, start, length)
            return
        if motion.key in ("lie_down", "sleep"):
            self._lie_down(action, motion, person, start, length)
            return
        now = start
        if motion.key == "lean" and thing is not None and thing.size[2] > 0.6:
            before = person.place, person.yaw
            self.stage.lean_at(person, thing)
            goal, yaw = person.place, person.yaw
            person.place, person.yaw, person.support = before[0], before[1], None
            now = self.sheet.walk_to(person, goal, yaw, now)
            person.support = thing.node_id
        elif partner is not None and motion.key == "kneel":
            spot, toward = self.interactions.kneeling_place(person, partner)
            now = self.sheet.walk_to(person, spot, facing(spot, toward), now)
        else:
            now = self.sheet.stand_up(person, now)
            if motion.after is not None:
                room = find_room_on_floor(
                    self.stage.floor,
                    motion.after,
                    person.place,
                    person.yaw,
                    person.scale,
                    self.stage.others(person),
                )
                now = self._move_to_room(person, *room, now)
        person.posture = motion.after or person.posture
        mark = person.mark() if motion.key == "lean" else None
        end = self.sheet.add_cue(person, motion.key, now, length, mark=mark, mood=action.mood)
        if motion.key == "fall":
            for prop in list(person.held.values()):
                self.stage.lay_down(prop, (*person.place, 0.0))
        self.sheet.finish_action(person, start, end)

    def _move_to_room(self, person: StagedPerson, place: Vec2, yaw: float, now: float) -> float:
        """Bring a person to a place with room: from the first frame, else by walking; return the end second."""
        if math.dist(place, person.place) < LEAST_MOVE and abs(shortest_turn(person.yaw, yaw)) < math.radians(5):
            return now
        if person.acted or person.entering:
            return self.sheet.walk_to(person, place, yaw, now)
        self.sheet.move_start_mark(person, place, yaw)
        return now

    def _sit_down(self, action: CharacterAction, person: StagedPerson, start: float, length: float) -> None:
        """Write the walk to a seat and the cue of sitting down (``length`` seconds), from second ``start`` on."""
        name = action.target_id if self.stage.floor.seats(action.target_id) else None
        told = self.ends.get(person.asset_id)
        seat = self.stage.spot_finder.seat_of_spot(person, told) if told is not None else None
        name = name or action.target_id or (told.support_id if told is not None and told.posture == "sit" else None)
        seat = seat or self.stage.seats.choose(person, name, self.stage.people.get(action.target_id or ""))
        person.spot = told.spot if told is not None else None
        if person.posture == "sit" and (seat is None or seat.node_id == person.support):
            return
        now = start
        if seat is not None:
            before = self.stage.floor.seat_access(seat, person.scale)
            blocked = self.stage.floor.room_at(before, (seat.node_id,)) < 0.5 * BODY * person.scale
            way = None if blocked else self.stage.floor.path(person.place, before, person.scale)
            if way is None and not person.acted and not is_seat_in_vessel(self.stage.floor, seat):
                self.stage.sit_by_cut(person, seat)
                self.sheet.starts[person.asset_id] = person.mark(held=self.sheet.starts[person.asset_id].held)
                self.sheet.note_cheat(person, "is seated when the shot begins: the seat cannot be walked to")
                return
            length += SLIDE if math.dist(before, seat.standing_spot(person.scale)) > 0.12 else 0.0
            now = self.sheet.walk_to(person, before, seat.yaw, now, then=length)
            self.stage.sit_by_cut(person, seat)
        else:
            now = self.sheet.stand_up(person, now)
            person.posture, person.support, person.anchor = "sit", None, ""
        self.sheet.finish_action(
            person, start, self.sheet.add_cue(person, "sit", now, length, mark=person.mark(), target_id=person.support)
        )

    def _lie_down(
        self, action: CharacterAction, motion: Motion, person: StagedPerson, start: float, length: float
    ) -> None:
        """Write the walk to a bed or the floor and the cues of lying down, from second ``start`` on."""
        asleep: Posture = "asleep" if motion.key == "sleep" else "lie"
        if person.posture in SEATED and (motion.key == "sleep" or person.posture != "sit"):
            person.posture = "asleep" if motion.key == "sleep" else person.posture
            self.sheet.finish_action(person, start, self.sheet.add_cue(person, motion.key, start, 1.2))
            return
        before, yaw, posture = person.place, person.yaw, person.posture
        self.stage.lie_by_cut(person, action.target_id, asleep)
        bed = person.mark()
        now = start
        if person.support is None and math.dist(before, person.place) > LEAST_MOVE:
            person.place, person.yaw, person.posture = before, yaw, posture
            now = self._move_to_room(person, bed.location[:2], math.radians(bed.yaw), now)
            person.posture = asleep
        elif person.support is not None:
            posture, support, anchor = person.posture, person.support, person.anchor
            edge = SeatPlace(support, anchor, person.place, person.yaw)
            person.place, person.posture, person.support = before, "stand", None
            now = self.sheet.walk_to(person, edge.standing_spot(person.scale), edge.yaw, now)
            person.place, person.yaw = edge.edge, edge.yaw
            person.posture, person.support, person.anchor = posture, support, anchor
        end = self.sheet.add_cue(person, "lie_down", now, natural_seconds(MOTIONS["lie_down"]), mark=bed)
        if motion.key == "sleep":
            end = self.sheet.add_cue(person, "sleep", end, length)
        self.sheet.finish_action(person, start, end)

    def _use_prop(
        self, action: CharacterAction, motion: Motion, person: StagedPerson, prop: str, later: Sequence[CharacterAction]
    ) -> None:
        """Write an action with a prop; a prop that another person holds is taken from them."""
        holder = self.stage.holder_of(prop)
        if motion.key in ("take", "catch") and holder is not None and holder is not person and holder.present:
            self.interactions.act_together(action, motion, person, holder, prop, later)
        else:
            self.hands.handle_prop(action, motion, person, prop, later)

    def _act_at_thing(self, action: CharacterAction, motion: Motion, person: StagedPerson) -> None:
        """Walk to a thing such as a door, a window or a table, and act there."""
        start = self.sheet.earliest_start(person)
        now, thing = start, self.stage.floor.thing(action.target_id, person.place)
        if thing is not None and person.upright:
            point = thing.nearest_edge(person.place)
            handle = next(iter(thing.anchors_of("handle")), None)
            if handle is not None:
                point = thing.to_world(handle.location)[:2]
            if math.dist(point, person.place) > REACH:
                others, floor = self.stage.others(person), self.stage.floor
                spot = floor.spot_around(point, person.place, person.scale, others, 0.55)
                spot = spot or floor.spot_around(point, person.place, person.scale, others, REACH)
                if spot is not None:
                    now = self.sheet.walk_to(person, spot, facing(spot, point), now)
            now = self.sheet.turn_to_yaw(person, facing(person.place, point), now)
        target = thing.node_id if thing is not None else None
        end = self.sheet.add_cue(person, motion.key, now, natural_seconds(motion), target_id=target, mood=action.mood)
        self.sheet.finish_action(person, start, end)

    def _is_worked_on_in_place(self, action: CharacterAction, motion: Motion, person: StagedPerson, prop: str) -> bool:
        """Tell whether a prop is worked on where it lies, and is not a tool: cut bread, a stirred pot."""
        size = self.stage.size_of(prop)
        desk_set = motion.key == "phone" and size is not None and size[1] > HANDSET_SIZE
        patient = action.prop_id in (None, action.target_id) and motion.reach == "thing" and motion.key in ACTS
        return (patient or desk_set) and not person.hand_of(prop) and prop in self.stage.prop_places

    def _act_on_the_spot(
        self, action: CharacterAction, motion: Motion, person: StagedPerson, partner: StagedPerson | None
    ) -> None:
        """Write looks, gestures and other actions on the spot."""
        now = start = self.sheet.earliest_start(person)
        thing = self.stage.floor.thing(action.target_id, person.place)
        if motion.key in DIRECTIONAL_LOOKS:
            partner = thing = None
        if partner is not None:
            now = self.sheet.turn_to_person(person, partner, now)
        elif thing is not None and person.upright:
            yaw = facing(person.place, thing.location[:2])
            if abs(shortest_turn(person.yaw, yaw)) > math.radians(70):
                now = self.sheet.turn_to_yaw(person, yaw, now)
        elif motion.key == "turn":
            self.sheet.finish_action(person, start, self.sheet.turn_to_yaw(person, person.yaw + math.pi, now))
            return
        if motion.key == "turn":
            self.sheet.finish_action(person, start, max(now, start + 0.3))
            return
        target = partner.asset_id if partner else thing.node_id if thing else self.stage.prop_of(action)
        end = self.sheet.add_cue(person, motion.key, now, natural_seconds(motion), target_id=target, mood=action.mood)
        if motion.key == "wake" and person.posture == "asleep":
            person.posture = (
                "sit"
                if self.stage.floor.seats(person.support) and not self.stage.floor.bed_edges(person.support)
                else "lie"
            )
        self.sheet.finish_action(person, start, end)

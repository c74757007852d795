"""The state of a scene while it is staged: where people and props are and what people hold, from shot to shot."""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.agents.visual_effects_artist.belongings import find_instrument_players, find_props_brought_along
from storyblender.agents.visual_effects_artist.floor import BODY, PERSONAL, Floor, facing
from storyblender.agents.visual_effects_artist.on_the_floor import find_room_on_floor
from storyblender.agents.visual_effects_artist.person import StagedPerson, stature_of
from storyblender.agents.visual_effects_artist.placed_objects import PlacedObject, SeatPlace
from storyblender.agents.visual_effects_artist.prop_states import find_prop_states
from storyblender.agents.visual_effects_artist.scripted_props import ScriptedProps
from storyblender.agents.visual_effects_artist.seats import Seats
from storyblender.agents.visual_effects_artist.spot_finder import SpotFinder
from storyblender.catalog.carrying import ON_BODY, two_handed
from storyblender.catalog.motions import MOTIONS, STANDING
from storyblender.geometry.paths import Vec2
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import BodyState, CharacterAction, PropState, ShotContext
from storyblender.memory.vocabulary import Grip, Hand, Posture

RUN_UP_SECONDS = 1.2
"""Least seconds of an entrance; a person who runs in is seen running."""
WAITING_DISTANCE = 1.5
"""Metres from the edge of a thing within which a person is by it."""
STICK_WIDTH = 0.2
"""Largest width in metres of a thing that a person leans on by holding it."""
HAND_SIZE = 0.6
"""Second largest extent in metres of the largest thing that a person can carry."""


class StageState:
    """Everyone and everything that moves in a scene.

    Methods that end in ``by_cut`` change a person between shots, without a walk or a cue. ``prop`` is an asset id.

    Args:
        floor: Positions of things on the floor.
        assets: Characters with their statures, objects with their sizes.
        objects: The layout, for the people's first places.

    Attributes:
        people: People by asset id.
        seats: Chooses people's seats.
        spot_finder: Finds the places of the script's spots.
        scripted_props: Moves things to the spots in the script.
        prop_places: Position in metres of every prop that nobody holds, by asset id.
        moved_props: Props that have left their places in the layout, in order.
        next_places: Place and yaw of people who are cut there before the next shot, because they could not walk.
        aside: Props that people put aside to free their hands; they stay there until taken again.
        players: Instrument of each person who holds one from the first frame on.
    """

    def __init__(self, floor: Floor, assets: Sequence[Asset], objects: Sequence[LayoutObject]) -> None:
        self.floor = floor
        self.assets = {asset.asset_id: asset for asset in assets}
        self.home: dict[str, tuple[Vec2, float]] = {
            item.asset_id: (item.location[:2], math.radians(item.rotation[2])) for item in reversed(objects)
        }
        self.people = {
            asset.asset_id: StagedPerson(asset.asset_id, stature_of(asset) / 1.7)
            for asset in assets
            if asset.asset_type == "character"
        }
        self.prop_places: dict[str, Vec3] = {
            thing.asset_id: thing.location for thing in reversed(list(floor.things.values()))
        }
        self.seats = Seats(floor, self.people, objects, self._seat_blockers)
        self.spot_finder = SpotFinder(floor, self.people, self.seats)
        sizes = {t.asset_id: t.size[:2] for t in floor.things.values()}
        self.scripted_props = ScriptedProps(self.spot_finder, self.prop_places, sizes)
        self.moved_props: dict[str, None] = {}
        self.next_places: dict[str, tuple[Vec2, float]] = {}
        self.aside: set[str] = set()
        self.players: dict[str, str] = {}

    def find_instrument_players(self, shots: Sequence[ShotContext]) -> None:
        """Find everybody who plays a carried instrument in these shots, if nobody handles it before."""
        self.players = find_instrument_players(shots, self.prop_of)

    def hide_props_brought_along(self, shots: Sequence[ShotContext]) -> None:
        """Remove from the layout the props that a person has with them before anyone sees where they come from."""
        for prop in find_props_brought_along(shots):
            if self.prop_places.pop(prop, None) is not None:
                self.moved_props[prop] = None

    def bring_on_stage(self, shot: ShotContext, cast: Sequence[StagedPerson], stay: Sequence[str]) -> None:
        """Place everybody who was not on stage: at an entrance, at the thing they wait by, or at their layout place.

        Args:
            shot: The shot that begins.
            cast: The people of the shot.
            stay: Asset ids of people who are on stage in the next shot too; others may walk off from their place.
        """
        for person in cast:
            person.busy, person.acted, person.entering = 0.0, False, False
            person.pace, person.opened = "", ""
            if person.present:
                continue
            person.posture, person.support, person.anchor = "stand", None, ""
            others = [p.place for p in cast if p.present]
            first = next((a for a in shot.character_actions if a.asset_id == person.asset_id), None)
            place, yaw = self.home.get(person.asset_id, (self.floor.middle(), 0.0))
            own = [MOTIONS[a.motion] for a in shot.character_actions if a.asset_id == person.asset_id]
            leaves = person.asset_id not in stay and all(motion.speed for motion in own)
            enters = (
                not leaves
                and first is not None
                and (self.opens_set_door(first) or MOTIONS[first.motion].speed is not None)
            )
            thing = self.floor.thing(first.target_id, place) if first is not None else None
            stairs = self.floor.mark_of("stairs") if first is not None and first.motion == "climb" else None
            if first is not None and (stairs is not None or (enters and self.floor.enter_marks())):
                mark = stairs or self._choose_entrance(place, MOTIONS[first.motion].speed or 0.0)
                crowded = any(math.dist(mark, other) < PERSONAL for other in others)
                if crowded or self.floor.room_at(mark) < 0.6 * BODY * person.scale:
                    mark = self.floor.free_spot(mark, person.scale, others)
                person.place, person.yaw, person.entering = mark, facing(mark, place), True
            elif thing is not None and first is not None and self._is_waiting_by(first, thing, place):
                self._stand_waiting_by(person, thing, place)
            else:
                person.place = self.floor.free_spot(place, person.scale, others)
                person.yaw = yaw
            person.present = True

    def _choose_entrance(self, place: Vec2, speed: float) -> Vec2:
        """Return the nearest entrance; for a run (``speed`` in m/s), the nearest one that is far enough away."""
        marks = sorted(self.floor.enter_marks(), key=lambda spot: math.dist(spot, place))
        return next(
            (mark for mark in marks if math.dist(mark, place) > RUN_UP_SECONDS * speed), marks[-1 if speed > 2 else 0]
        )

    def _is_waiting_by(self, action: CharacterAction, thing: PlacedObject, place: Vec2) -> bool:
        """Tell whether an action has a person wait by a large thing that is not at their layout place."""
        large = self.prop_of(action) is None and thing.solid and not thing.anchors_of("seat", "bed")
        idle, rim = action.motion in STANDING, thing.nearest_edge(place)
        return large and idle and math.dist(rim, place) > WAITING_DISTANCE and self.floor.inside(rim)

    def _stand_waiting_by(self, person: StagedPerson, thing: PlacedObject, place: Vec2) -> None:
        """Place a person by a thing from the first frame on, with their back to it."""
        person.place = place
        person.place = self.floor.free_spot(thing.nearest_edge(person.place), person.scale, self.others(person))
        person.yaw = facing(thing.location[:2], person.place)

    def opens_set_door(self, action: CharacterAction) -> bool:
        """Tell whether an action opens a door of the set."""
        return action.motion == "open" and self.floor.thing(action.target_id) in self.floor.openings

    def end_shot(self, stay: Sequence[str]) -> None:
        """End a shot: only the people in ``stay`` remain; those who could not walk are cut to their goal."""
        for person in self.people.values():
            person.present = person.present and person.asset_id in stay
            if person.asset_id in self.next_places:
                person.place, person.yaw = self.next_places.pop(person.asset_id)

    def apply_states(self, states: Sequence[BodyState], actions: Sequence[CharacterAction] = ()) -> None:
        """Bring people into the postures, spots and grips that the script gives them at the start of a shot.

        Args:
            states: States of people as the shot begins.
            actions: Actions of the shot; what a person takes during the shot is not in their hands before.
        """
        taken = {
            (action.asset_id, self.prop_of(action))
            for action in actions
            if action.motion in ("take", "pick_up", "catch")
        }
        by_people = [state.spot is not None and state.spot.anchor_id in self.people for state in states]
        for _, state in sorted(zip(by_people, states, strict=True), key=lambda pair: pair[0]):
            person = self.people.get(state.asset_id)
            if person is None or not person.present:
                continue
            self.apply_posture(person, self.seats.with_layout_seat(person, state))
            if self.spot_finder.settle(person, state):
                self.next_places.pop(person.asset_id, None)
            grips = dict(state.grips)
            with_them = dict.fromkeys((*state.held, *(prop for prop in grips if grips[prop] == "worn")))
            in_hand = (*with_them, *self._held_support(state))
            person.held = {hand: prop for hand, prop in person.held.items() if prop in in_hand}
            person.on_body = {prop: grip for prop, grip in person.on_body.items() if prop in in_hand}
            for prop in in_hand:
                if self._is_carriable(prop) and (state.asset_id, prop) not in taken and prop not in self.aside:
                    self.carry_as(person, prop, grips.get(prop))

    def _is_carriable(self, prop: str) -> bool:
        """Tell whether one person can carry a prop: it has a grip, or it is not too large."""
        canonical, size = self.assets[prop].canonical if prop in self.assets else None, self.size_of(prop)
        grip = canonical is not None and any(anchor.kind == "grip" for anchor in canonical.anchors)
        return prop in self.assets and (grip or size is None or size[1] <= HAND_SIZE)

    def apply_posture(self, person: StagedPerson, state: BodyState) -> None:
        """Bring a person into the posture of a state by a cut, with a seat, a bed or room on the floor for it."""
        support = self.floor.thing(state.support_id)
        same_support = support is None or person.support == support.node_id
        if state.posture == person.posture and (same_support or person.posture == "stand"):
            return
        if self._held_support(state):
            return
        if state.posture == "stand":
            if not person.upright:
                self.stand_by_cut(person)
        elif state.posture == "sit":
            if (seat := self.seats.own_seat(person, state) or self.seats.choose(person, state.support_id)) is not None:
                self.sit_by_cut(person, seat)
            else:
                person.posture, person.support, person.anchor = "sit", None, ""
        elif state.posture in ("lie", "asleep"):
            self.lie_by_cut(person, state.support_id, state.posture)
        else:
            if not person.upright:
                self.stand_by_cut(person)
            if state.posture == "lean" and support is not None:
                self.lean_at(person, support)
            self.move_to_floor_room(person, state.posture)
            person.posture = state.posture

    def _held_support(self, state: BodyState) -> tuple[str, ...]:
        """Return the prop that a leaning person holds as a support, such as a walking stick; empty if there is none."""
        size = self.size_of(state.support_id or "") if state.posture == "lean" else None
        return (str(state.support_id),) if size is not None and size[1] < STICK_WIDTH else ()

    def stand_by_cut(self, person: StagedPerson) -> None:
        """Let a person stand: in front of their seat, or at the nearest free spot."""
        places = self.floor.seats(person.support, asked=True)
        seats = [s for s in places if math.dist(s.edge, person.place) < 0.7]
        person.place = self.floor.free_spot(person.place, person.scale, self.others(person))
        person.place = self.floor.seat_access(seats[0], person.scale) if seats else person.place
        person.posture, person.support, person.anchor = "stand", None, ""

    def others(self, person: StagedPerson) -> list[Vec2]:
        """Return the floor points of everybody else on stage."""
        return [p.place for p in self.people.values() if p.present and p is not person]

    def _seat_blockers(self) -> list[Vec3]:
        """Return the positions of loose props that make a seat unusable."""
        return [place for prop, place in self.prop_places.items() if self._is_carriable(prop)]

    def sit_by_cut(self, person: StagedPerson, seat: SeatPlace) -> None:
        """Let a person sit on a seat, in this shot and the next."""
        self.next_places.pop(person.asset_id, None)
        person.place, person.yaw, person.posture, person.z = seat.edge, seat.yaw, "sit", 0.0
        person.support, person.anchor = seat.node_id, seat.anchor

    def lie_by_cut(self, person: StagedPerson, name: str | None, posture: Posture) -> None:
        """Let a person lie or sleep on the bed ``name`` (id), on the roomier side; on the floor if there is no bed."""
        beds = self.floor.bed_edges(name)
        if beds:
            edge, _ = max(
                beds,
                key=lambda bed: min(0.6, self.floor.room_at(bed[0].standing_spot(person.scale), (bed[0].node_id,))),
            )
            person.place, person.yaw = edge.edge, edge.yaw
            person.support, person.anchor, person.posture = edge.node_id, edge.anchor, posture
            return
        seat = self.seats.choose(person, name) if name else None
        if seat is not None and posture == "asleep":
            self.sit_by_cut(person, seat)
        else:
            person.support, person.anchor = None, ""
            self.move_to_floor_room(person, posture)
        person.posture = posture

    def move_to_floor_room(self, person: StagedPerson, posture: Posture) -> None:
        """Move a person to the nearest place where a body in a posture (kneel, lie, asleep) touches nothing."""
        place, yaw, others = person.place, person.yaw, self.others(person)
        person.place, person.yaw = find_room_on_floor(self.floor, posture, place, yaw, person.scale, others)

    def lean_at(self, person: StagedPerson, thing: PlacedObject) -> None:
        """Place a person close to the edge of a bar, a rail or a wall, facing it."""
        point = thing.nearest_edge(person.place)
        away = facing(point, person.place)
        gap = 0.16 * person.scale + 0.12
        person.place = (point[0] + gap * math.sin(away), point[1] - gap * math.cos(away))
        person.yaw, person.support = facing(person.place, point), thing.node_id

    def place_loose_props(self, shot: ShotContext) -> None:
        """Give every prop of the shot's actions a place, if the layout has none: on the nearest table or in the hand.

        Instruments are put into their players' hands.
        """
        held = {prop for person in self.people.values() for prop in person.held.values()}
        self.moved_props |= dict.fromkeys(self.scripted_props.settle(shot, held, self.moved_props))
        for name, prop in self.players.items():
            if self.people[name].present:
                self.put_in_hand(self.people[name], prop)
        brought_out = {change.asset_id for change in shot.asset_modifications if change.modification_type == "add"}
        for action in shot.character_actions:
            prop, person = self.prop_of(action), self.people.get(action.asset_id)
            if prop is None or person is None or not person.present or prop in self.prop_places or self.holder_of(prop):
                continue
            if prop in brought_out or (action.motion in STANDING and action.prop_id != prop):
                continue  # an idle person does not hold the thing they are at
            if action.motion in ("pick_up", "take", "catch"):
                if self.find_bag(person, prop):
                    continue
                top = self.floor.nearest_top(person.place, 6.0)
                near = self.floor.nearest_point_on_top(top, person.place) if top else (*person.place, 0.0)
                self.prop_places[prop] = near if top else (near[0] + 0.35 * math.sin(person.yaw), near[1] - 0.35, 0.0)
                self.moved_props[prop] = None
            else:
                self.put_in_hand(person, prop)

    def prop_of(self, action: CharacterAction) -> str | None:
        """Return the asset id of the prop that an action handles; None if it handles nothing that can be carried."""
        for name in (action.prop_id, action.target_id):
            asset = self.assets.get(name or "")
            if asset is None or asset.asset_type != "object":
                continue
            size = asset.canonical.dimensions if asset.canonical else (0.2, 0.2, 0.2)
            if sorted(size)[1] <= HAND_SIZE:
                thing = self.floor.thing(asset.asset_id)
                if name == action.prop_id or (thing is None or not thing.anchors_of("seat", "bed")):
                    return asset.asset_id
        return None

    def holder_of(self, prop: str) -> StagedPerson | None:
        """Return the person who has a prop in a hand or on the body; None if nobody has."""
        return next((p for p in self.people.values() if p.hand_of(prop) or prop in p.on_body), None)

    def find_bag(self, person: StagedPerson, prop: str) -> str | None:
        """Return the held or opened prop out of which a person can take a smaller one (asset ids), or None."""
        size = self.size_of(prop)
        if person.free_hand() is None or size is None:
            return None
        for held in (person.opened, *person.held.values()):
            room = self.size_of(held)
            if room is not None and all(inner < outer for inner, outer in zip(size, room, strict=True)):
                return held
        return None

    def size_of(self, prop: str) -> list[float] | None:
        """Return a prop's extents in metres, ascending; None if they are unknown."""
        asset = self.assets.get(prop)
        return sorted(asset.canonical.dimensions) if asset is not None and asset.canonical is not None else None

    def has_hands_full(self, person: StagedPerson) -> bool:
        """Tell whether a person can take nothing more: a prop in each hand, or one that needs both."""
        held = [self.assets[prop].canonical for prop in person.held.values() if prop in self.assets]
        return person.free_hand() is None or any(one and two_handed(one.dimensions, one.anchors) for one in held)

    def put_in_hand(self, person: StagedPerson, prop: str, wish: Hand = "R") -> Hand | None:
        """Put a prop (asset id) into a person's hand, ``wish`` if it is free; the person who held it before lets go.

        Returns:
            The hand that holds it; None if no hand is free.
        """
        already = person.hand_of(prop)
        if already:
            return already
        hand = person.free_hand(wish)
        if hand is None:
            return None
        for each in self.people.values():
            each.let_go(prop)
        self.players = {name: held for name, held in self.players.items() if held != prop or name == person.asset_id}
        person.held[hand] = prop
        self.prop_places.pop(prop, None)
        self.aside.discard(prop)
        self.moved_props[prop] = None
        return hand

    def carry_as(self, person: StagedPerson, prop: str, grip: Grip | None) -> None:
        """Let a person carry a prop (asset id) with a grip of the script; without a grip it is in a hand."""
        if grip in ON_BODY:
            self.put_on(prop)
        elif not self.put_in_hand(person, prop):
            return
        person.set_grip(prop, grip)

    def lay_down(self, prop: str, place: Vec3) -> None:
        """Lay a prop (asset id) at a world point in metres; nobody holds it any more."""
        self.players = {name: held for name, held in self.players.items() if held != prop}
        for each in self.people.values():
            each.let_go(prop)
        self.prop_places[prop] = place
        self.moved_props[prop] = None

    def put_on(self, prop: str) -> None:
        """Remove a prop from hands and places: it is worn, and drawn only if a body part shows it."""
        self.lay_down(prop, (0.0, 0.0, 0.0))
        del self.prop_places[prop]

    def keep_locked_blocking(self, shot: ShotContext) -> None:
        """Take over everybody's end marks from a shot whose blocking the user has locked."""
        for blocking in shot.blocking:
            person = self.people.get(blocking.end.asset_id)
            if person is not None:
                person.place, person.yaw = blocking.end.location[:2], math.radians(blocking.end.yaw)
                person.posture, person.support = blocking.end.posture, blocking.end.support_id
                person.anchor, person.held, person.present = blocking.end.anchor_name, dict(blocking.end.held), True

    def prop_states(self, shot: ShotContext) -> tuple[PropState, ...]:
        """Return the state of every prop that has left its place in the layout."""
        return find_prop_states(shot, self.moved_props, self.prop_places, self.holder_of, self.assets)

"""The company: people and props of a scene, where they are and what they hold, carried from shot to shot. Pure."""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.agents.visual_effects_artist.belongings import brought_along, players_of
from storyblender.agents.visual_effects_artist.floor import BODY, PERSONAL, Floor, facing
from storyblender.agents.visual_effects_artist.on_the_floor import room_for
from storyblender.agents.visual_effects_artist.person import Person, stature_of
from storyblender.agents.visual_effects_artist.placed_things import SeatPlace, Thing
from storyblender.agents.visual_effects_artist.places import Places
from storyblender.agents.visual_effects_artist.seats import Seats
from storyblender.agents.visual_effects_artist.told_things import ToldThings
from storyblender.agents.visual_effects_artist.whereabouts import whereabouts
from storyblender.catalog.carrying import ON_BODY, two_handed
from storyblender.catalog.motions import clip_of
from storyblender.geometry.paths import Vec2
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import BodyState, CharacterAction, PropState, ShotContext
from storyblender.memory.vocabulary import Grip, Hand, Posture

RUN_UP = 1.2
"""Seconds of the way in; who runs is seen running."""
BESIDE = 1.5
"""Metres from the edge of a thing within which one is by it."""
STICK = 0.2
"""Metres across of what one leans on by holding it."""
HAND_SIZE = 0.6
"""Metres; the second largest extent of what a person can carry."""


class Company:
    """Everyone and everything that moves in a scene.

    Args:
        floor: Positions of things on the floor.
        assets: Characters with their statures, objects with their sizes.
        objects: The layout, for the people's first places.

    Attributes:
        people: People by asset id.
        seats: Chooses people's seats.
        places: Finds the places of the script's spots.
        told_things: Moves things to the spots in the script.
        lying: Positions of all props that are not held.
        touched: Props that left their places, in order.
        jumps: Places people are cut to before the next shot, because there is no walkable way.
        aside: Things people put aside to free their hands; they stay there until taken again.
        players: People who hold an instrument from the first frame on, and the instrument.
    """

    def __init__(self, floor: Floor, assets: Sequence[Asset], objects: Sequence[LayoutObject]) -> None:
        self.floor = floor
        self.assets = {asset.asset_id: asset for asset in assets}
        self.home: dict[str, tuple[Vec2, float]] = {
            item.asset_id: (item.location[:2], math.radians(item.rotation[2])) for item in reversed(objects)
        }
        self.people = {
            asset.asset_id: Person(asset.asset_id, stature_of(asset) / 1.7)
            for asset in assets
            if asset.asset_type == "character"
        }
        self.lying: dict[str, Vec3] = {
            thing.asset_id: thing.location for thing in reversed(list(floor.things.values()))
        }
        self.seats = Seats(floor, self.people, objects, self._in_the_way_of_sitting)
        self.places = Places(floor, self.people, self.seats)
        sizes = {t.asset_id: t.size[:2] for t in floor.things.values()}
        self.told_things = ToldThings(self.places, self.lying, sizes)
        self.touched: dict[str, None] = {}
        self.jumps: dict[str, tuple[Vec2, float]] = {}
        self.aside: set[str] = set()
        self.players: dict[str, str] = {}

    def find_players(self, shots: Sequence[ShotContext]) -> None:
        """Give everybody who will play a carried instrument that instrument, unless it is handled before."""
        self.players = players_of(shots, self.prop_of)

    def put_away(self, shots: Sequence[ShotContext]) -> None:
        """Take from where the layout laid it what nobody sees before somebody has it."""
        for prop in brought_along(shots):
            if self.lying.pop(prop, None) is not None:
                self.touched[prop] = None

    def bring_on(self, shot: ShotContext, cast: Sequence[Person], stay: Sequence[str]) -> None:
        """Put everybody who was not on stage at a door, or at their place: from there goes who only leaves."""
        for person in cast:
            person.busy, person.acted, person.entering = 0.0, False, False
            person.pace, person.opened = "", ""
            if person.present:
                continue
            person.posture, person.support, person.anchor = "stand", None, ""
            others = [p.place for p in cast if p.present]
            first = next((a for a in shot.character_actions if a.asset_id == person.asset_id), None)
            place, yaw = self.home.get(person.asset_id, (self.middle(), 0.0))
            own = [clip_of(a.motion) for a in shot.character_actions if a.asset_id == person.asset_id]
            leaves = person.asset_id not in stay and all(motion.speed for motion in own)
            enters = (
                not leaves
                and first is not None
                and (self.opens_a_door(first) or clip_of(first.motion).speed is not None)
            )
            thing = self.floor.thing(first.target_id, place) if first is not None else None
            stairs = self.floor.mark_of("stairs") if first is not None and first.motion == "climb" else None
            if first is not None and (stairs is not None or (enters and self.enter_marks())):
                mark = stairs or self._entrance(place, clip_of(first.motion).speed or 0.0)
                crowded = any(math.dist(mark, other) < PERSONAL for other in others)
                if crowded or self.floor.room_at(mark) < 0.6 * BODY * person.scale:
                    mark = self.floor.free_near(mark, person.scale, others)
                person.place, person.yaw, person.entering = mark, facing(mark, place), True
            elif thing is not None and first is not None and self._waits_by(first, thing, place):
                self._wait_by(person, thing, place)
            else:
                person.place = self.floor.free_near(place, person.scale, others)
                person.yaw = yaw
            person.present = True

    def _entrance(self, place: Vec2, speed: float) -> Vec2:
        """Return where somebody comes in: nearby, or for a run from as far as a run needs."""
        marks = sorted(self.enter_marks(), key=lambda spot: math.dist(spot, place))
        return next((mark for mark in marks if math.dist(mark, place) > RUN_UP * speed), marks[-1 if speed > 2 else 0])

    def _waits_by(self, action: CharacterAction, thing: Thing, place: Vec2) -> bool:
        """Tell whether somebody is found waiting by a large thing that is not where they are."""
        large = self.prop_of(action) is None and thing.solid and not thing.of_kind("seat", "bed")
        idle, rim = clip_of(action.motion).key == "idle", thing.rim(place)
        return large and idle and math.dist(rim, place) > BESIDE and self.floor.inside(rim)

    def _wait_by(self, person: Person, thing: Thing, place: Vec2) -> None:
        """Stand by a thing from the beginning, one's back to it."""
        person.place = place
        person.place = self.floor.free_near(thing.rim(person.place), person.scale, self.others(person))
        person.yaw = facing(thing.location[:2], person.place)

    def opens_a_door(self, action: CharacterAction) -> bool:
        """Tell whether an action opens a door of the set."""
        return clip_of(action.motion).key == "open" and self.floor.thing(action.target_id) in self.floor.openings

    def leave(self, stay: Sequence[str]) -> None:
        """End a shot: who is not needed is off, who could not walk is cut to where they belong."""
        for person in self.people.values():
            person.present = person.present and person.asset_id in stay
            if person.asset_id in self.jumps:
                person.place, person.yaw = self.jumps.pop(person.asset_id)

    def enter_marks(self) -> list[Vec2]:
        """Return where people come in."""
        return [mark.location[:2] for mark in self.floor.marks if "enter" in mark.tags]

    def exit_marks(self) -> list[Vec2]:
        """Return where people go out."""
        return [mark.location[:2] for mark in self.floor.marks if "exit" in mark.tags] or self.enter_marks()

    def middle(self) -> Vec2:
        """Return the middle of the playing area."""
        x0, y0, x1, y1 = self.floor.bounds
        return (x0 + x1) / 2, (y0 + y1) / 2

    def apply_states(self, states: Sequence[BodyState], actions: Sequence[CharacterAction] = ()) -> None:
        """Bring people into the postures and hands the script says they are in, between shots.

        What somebody takes during the shot is not in their hands before.
        """
        taken = {
            (action.asset_id, self.prop_of(action))
            for action in actions
            if clip_of(action.motion).key in ("take", "pick_up", "catch")
        }
        by_people = [state.spot is not None and state.spot.anchor_id in self.people for state in states]
        for _, state in sorted(zip(by_people, states, strict=True), key=lambda pair: pair[0]):
            person = self.people.get(state.asset_id)
            if person is None or not person.present:
                continue
            self.apply_posture(person, self.seats.as_laid_out(person, state))
            if self.places.settle(person, state):
                self.jumps.pop(person.asset_id, None)
            grips = dict(state.grips)
            with_them = dict.fromkeys((*state.held, *(prop for prop in grips if grips[prop] == "worn")))
            in_hand = (*with_them, *self._stick_of(state))
            person.held = {hand: prop for hand, prop in person.held.items() if prop in in_hand}
            person.on_body = {prop: grip for prop, grip in person.on_body.items() if prop in in_hand}
            for prop in in_hand:
                if self._carriable(prop) and (state.asset_id, prop) not in taken and prop not in self.aside:
                    self.take_over(person, prop, grips.get(prop))

    def _carriable(self, prop: str) -> bool:
        """Tell whether one person can carry a thing of the sheet: it has a grip, or is not too large."""
        canonical, size = self.assets[prop].canonical if prop in self.assets else None, self.size_of(prop)
        grip = canonical is not None and any(anchor.kind == "grip" for anchor in canonical.anchors)
        return prop in self.assets and (grip or size is None or size[1] <= HAND_SIZE)

    def apply_posture(self, person: Person, state: BodyState) -> None:
        """Bring a person into a posture by a cut."""
        support = self.floor.thing(state.support_id)
        same_support = support is None or person.support == support.node_id
        if state.posture == person.posture and (same_support or person.posture == "stand"):
            return
        if self._stick_of(state):
            return
        if state.posture == "stand":
            if not person.upright:
                self.stand_beside(person)
        elif state.posture == "sit":
            if (seat := self.seats.own(person, state) or self.seat_for(person, state.support_id)) is not None:
                self.take_seat(person, seat)
            else:
                person.posture, person.support, person.anchor = "sit", None, ""
        elif state.posture in ("lie", "asleep"):
            self.go_to_bed(person, state.support_id, state.posture)
        else:
            if not person.upright:
                self.stand_beside(person)
            if state.posture == "lean" and support is not None:
                self.go_to_rail(person, support)
            self.make_room(person, state.posture)
            person.posture = state.posture

    def _stick_of(self, state: BodyState) -> tuple[str, ...]:
        """Return what one leans on by holding it, if it is that: a walking stick, a spear."""
        size = self.size_of(state.support_id or "") if state.posture == "lean" else None
        return (str(state.support_id),) if size is not None and size[1] < STICK else ()

    def stand_beside(self, person: Person) -> None:
        """Stand up by a cut: before the seat, or at the nearest free spot."""
        places = self.floor.seats(person.support, asked=True)
        seats = [s for s in places if math.dist(s.edge, person.place) < 0.7]
        person.place = self.floor.free_near(person.place, person.scale, self.others(person))
        person.place = self.floor.access(seats[0], person.scale) if seats else person.place
        person.posture, person.support, person.anchor = "stand", None, ""

    def others(self, person: Person) -> list[Vec2]:
        """Return where everybody else on stage is."""
        return [p.place for p in self.people.values() if p.present and p is not person]

    def seat_for(self, person: Person, name: str | None, beside: Person | None = None) -> SeatPlace | None:
        """Return a person's seat on or at a thing, next to ``beside``, or anywhere."""
        return self.seats.choose(person, name, beside)

    def _in_the_way_of_sitting(self) -> list[Vec3]:
        """Return the positions of things that block a seat."""
        return [place for prop, place in self.lying.items() if self._carriable(prop)]

    def take_seat(self, person: Person, seat: SeatPlace) -> None:
        """Sit on a seat by a cut, in the next shot too."""
        self.jumps.pop(person.asset_id, None)
        person.place, person.yaw, person.posture, person.z = seat.edge, seat.yaw, "sit", 0.0
        person.support, person.anchor = seat.node_id, seat.anchor

    def go_to_bed(self, person: Person, name: str | None, posture: Posture) -> None:
        """Lie on a bed by a cut, on the side with more room; on the floor where there is none."""
        beds = self.floor.beds(name)
        if beds:
            edge, _ = max(
                beds, key=lambda bed: min(0.6, self.floor.room_at(bed[0].before(person.scale), (bed[0].node_id,)))
            )
            person.place, person.yaw = edge.edge, edge.yaw
            person.support, person.anchor, person.posture = edge.node_id, edge.anchor, posture
            return
        seat = self.seat_for(person, name) if name else None
        if seat is not None and posture == "asleep":
            self.take_seat(person, seat)
        else:
            person.support, person.anchor = None, ""
            self.make_room(person, posture)
        person.posture = posture

    def make_room(self, person: Person, posture: Posture) -> None:
        """Move somebody to where they can kneel or lie on the floor without being in anything."""
        place, yaw, others = person.place, person.yaw, self.others(person)
        person.place, person.yaw = room_for(self.floor, posture, place, yaw, person.scale, others)

    def go_to_rail(self, person: Person, thing: Thing) -> None:
        """Stand close before a bar, a rail or a wall."""
        point = thing.rim(person.place)
        away = facing(point, person.place)
        gap = 0.16 * person.scale + 0.12
        person.place = (point[0] + gap * math.sin(away), point[1] - gap * math.cos(away))
        person.yaw, person.support = facing(person.place, point), thing.node_id

    def place_loose_props(self, shot: ShotContext) -> None:
        """Props that somebody is about to take and that the layout forgot lie on the nearest table, or are in hand.

        Instruments are in their players' hands.
        """
        held = {prop for person in self.people.values() for prop in person.held.values()}
        self.touched |= dict.fromkeys(self.told_things.settle(shot, held, self.touched))
        for name, prop in self.players.items():
            if self.people[name].present:
                self.hand_over(self.people[name], prop)
        brought_out = {change.asset_id for change in shot.asset_modifications if change.modification_type == "add"}
        for action in shot.character_actions:
            prop, person = self.prop_of(action), self.people.get(action.asset_id)
            if prop is None or person is None or not person.present or prop in self.lying or self.holder(prop):
                continue
            if prop in brought_out or (clip_of(action.motion).key == "idle" and action.prop_id != prop):
                continue  # what one only is at, one does not hold
            if clip_of(action.motion).key in ("pick_up", "take", "catch"):
                if self.bag_for(person, prop):
                    continue
                top = self.floor.nearest_top(person.place, 6.0)
                near = self.floor.top_of(top, person.place) if top else (*person.place, 0.0)
                self.lying[prop] = near if top else (near[0] + 0.35 * math.sin(person.yaw), near[1] - 0.35, 0.0)
                self.touched[prop] = None
            else:
                self.hand_over(person, prop)

    def prop_of(self, action: CharacterAction) -> str | None:
        """Return the thing an action handles, if it is one that can be carried."""
        for name in (action.prop_id, action.target_id):
            asset = self.assets.get(name or "")
            if asset is None or asset.asset_type != "object":
                continue
            size = asset.canonical.dimensions if asset.canonical else (0.2, 0.2, 0.2)
            if sorted(size)[1] <= HAND_SIZE:
                thing = self.floor.thing(asset.asset_id)
                if name == action.prop_id or (thing is None or not thing.of_kind("seat", "bed")):
                    return asset.asset_id
        return None

    def holder(self, prop: str) -> Person | None:
        """Return who holds a prop."""
        return next((p for p in self.people.values() if p.hand_of(prop) or prop in p.on_body), None)

    def bag_for(self, person: Person, prop: str) -> str | None:
        """Return what somebody holds or has opened that a thing can come out of: large enough, and a hand is free."""
        size = self.size_of(prop)
        if person.free_hand() is None or size is None:
            return None
        for held in (person.opened, *person.held.values()):
            room = self.size_of(held)
            if room is not None and all(inner < outer for inner, outer in zip(size, room, strict=True)):
                return held
        return None

    def size_of(self, prop: str) -> list[float] | None:
        """Return a thing's extents, the smallest first."""
        asset = self.assets.get(prop)
        return sorted(asset.canonical.dimensions) if asset is not None and asset.canonical is not None else None

    def full_handed(self, person: Person) -> bool:
        """Tell whether somebody can take nothing more: something in each hand, or one thing in both."""
        held = [self.assets[prop].canonical for prop in person.held.values() if prop in self.assets]
        return person.free_hand() is None or any(one and two_handed(one.dimensions, one.anchors) for one in held)

    def hand_over(self, person: Person, prop: str, wish: Hand = "R") -> Hand | None:
        """Let a person hold a prop, in the wished hand if it is free; whoever held it does not any more."""
        already = person.hand_of(prop)
        if already:
            return already
        hand = person.free_hand(wish)
        if hand is None:
            return None
        self._nobody_has(prop)
        self.players = {name: held for name, held in self.players.items() if held != prop or name == person.asset_id}
        person.held[hand] = prop
        self.lying.pop(prop, None)
        self.aside.discard(prop)
        self.touched[prop] = None
        return hand

    def _nobody_has(self, prop: str) -> None:
        for each in self.people.values():
            each.let_go(prop)

    def take_over(self, person: Person, prop: str, grip: Grip | None) -> None:
        """Let a person have a prop as the script says they carry it."""
        if grip in ON_BODY:
            self.lay(person, prop, (0.0, 0.0, 0.0))
            del self.lying[prop]
        elif not self.hand_over(person, prop):
            return
        person.hold_as(prop, grip)

    def lay(self, person: Person, prop: str, place: Vec3) -> None:
        """Let a prop lie somewhere; nobody holds it any more."""
        self.players = {name: held for name, held in self.players.items() if held != prop}
        self._nobody_has(prop)
        self.lying[prop] = place
        self.touched[prop] = None

    def wear(self, person: Person, prop: str) -> None:
        """Let a person have something on: it is in no hand any more, and too small to be seen."""
        self.lay(person, prop, (0.0, 0.0, 0.0))
        del self.lying[prop]

    def keep(self, shot: ShotContext) -> None:
        """Take over the ends of a shot whose blocking the user has locked."""
        for blocking in shot.blocking:
            person = self.people.get(blocking.end.asset_id)
            if person is not None:
                person.place, person.yaw = blocking.end.location[:2], math.radians(blocking.end.yaw)
                person.posture, person.support = blocking.end.posture, blocking.end.support_id
                person.anchor, person.held, person.present = blocking.end.anchor_name, dict(blocking.end.held), True

    def prop_states(self, shot: ShotContext) -> tuple[PropState, ...]:
        """Return where every prop that left its place is now."""
        return whereabouts(shot, self.touched, self.lying, self.holder, self.assets)

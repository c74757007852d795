"""Things in hands: fetched, taken out, used, passed on, put down. Pure."""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.agents.visual_effects_artist.company import Company
from storyblender.agents.visual_effects_artist.cue_sheet import REACH, CueSheet
from storyblender.agents.visual_effects_artist.floor import TOPS, Thing, facing
from storyblender.agents.visual_effects_artist.person import Person
from storyblender.catalog.carrying import hand_towards
from storyblender.catalog.hollows import OPEN_ABOVE, inside
from storyblender.catalog.motions import MOTIONS, Motion, clip_of, natural_seconds
from storyblender.geometry.boxes import turn_between
from storyblender.memory.base import Vec3
from storyblender.memory.shot_context import CharacterAction, Mark
from storyblender.memory.vocabulary import Hand

GETTING = frozenset({"pick_up", "take", "hold", "catch"})
"""Motions after which one has something in hand."""
FETCH, AT_HAND, ACROSS = 5.0, 3.0, 12.0
"""Metres one goes to get a thing, to use one, and to open one that stands; what is used and lies farther off is in hand
from the start."""
BOX = 0.18
"""Metres of the second largest extent."""
LEFT = 0.2
"""Metres to one's left from which the left hand takes a thing."""
POCKET = (0.12, 0.22, 0.36)
"""Metres: what is smaller, the smallest extent first, is carried in one's clothes and not seen there."""
SEATED_REACH = 0.45
"""Metres from a seat's edge to what its sitter can take."""
BEFORE, TO_THE_SIDE, AT_TABLE = 0.27, 0.18, 1.3
"""Metres: how far before the edge of a sitter's seat, and at most how far aside, a thing is put down for them, by who
comes that near."""
INWARD, HIPS = 0.2, 0.18
"""Metres: how far behind the edge of a seat a thing is put on it, and half of who sits there."""
FROM_SEAT, AT_MOST, AHEAD = 0.9, 1.0, 0.42
"""Metres within which who sits puts something down, and who stands; how far ahead of one's feet a thing is put on the
floor."""
HIGHEST, FROM_FLOOR, TOO_FAR = 1.0, 0.6, 1.25
"""Metres: the highest top on which who sits or leans puts something down, and who is on the floor; from where on they
get up and go to what the script names."""
BAG, STICK, BULK, RING, BESIDE_FOOT, AT_FEET = 0.4, 0.06, 0.2, 0.06, 0.34, 0.6
"""Metres: a bag is longer, a stick thinner, and a case thicker, a ring smaller; how far beside one a bag is put
down, and how far from others."""
ASIDE = math.radians(60)
"""What is farther aside than this is turned to before it is handled."""


class Handling:
    """Writes what people do with props.

    Args:
        company: People and props.
        sheet: Where the cues go.
    """

    def __init__(self, company: Company, sheet: CueSheet) -> None:
        self.company, self.sheet = company, sheet

    def handle(
        self, action: CharacterAction, motion: Motion, person: Person, prop: str, later: Sequence[CharacterAction]
    ) -> None:
        """Do something with a prop, after going to it or having it in hand."""
        start, getting = self.sheet.start_of(person), motion.key in GETTING
        if (getting and person.hand_of(prop)) or (motion.key == "hold" and prop in person.on_body):
            return
        t = self._hands_freed(person, prop, start) if motion.hands == 2 else start
        switched = motion.key == "press" and prop in self.company.lying
        switched = switched and not fits_in_clothes(self.company.size_of(prop))
        where_it_is = switched or (motion.key in ("open", "close", "type") and self._stands(prop))
        t = self._gone_to(person, prop, ACROSS if where_it_is else FETCH if getting else AT_HAND, t)
        lies = self._within_reach(person, prop)
        bag = self.company.bag_for(person, prop) if getting else None
        if switched:
            at = self.company.lying[prop]
            t = self.turn_to(person, at, t) if person.upright else t
            thing = self.company.floor.thing(prop)
            target = thing.node_id if thing is not None else prop
            end = self.sheet.cue(person, motion.key, t, natural_seconds(motion), target_id=target, mood=action.mood)
            self.sheet.done(person, start, end)
            return
        if lies is not None and where_it_is:
            self._open_where_it_stands(person, motion, prop, start, self.turn_to(person, lies, t))
            return
        if lies is not None:
            t = self._picked_up(person, prop, lies, t)
        elif bag is not None:
            t = self._taken(person, MOTIONS["take"], prop, t, bag)
        elif getting and self._in_clothes(person, prop):
            self.sheet.found_in_clothes(person, prop)
            t = self._taken(person, MOTIONS["take"], prop, t, person.asset_id)
        elif not person.hand_of(prop):
            self.sheet.found_in_hand(person, prop)
            if getting:
                self._shown(person, motion, prop, start, t)
                return
        if getting:
            self.sheet.done(person, start, t)
            return
        catcher = self._catcher(person, prop, later) if motion.key == "throw" else None
        if catcher is not None:
            self._pass(person, catcher, prop, t)
        else:
            self._use(action, motion, person, prop, start, t)

    def _shown(self, person: Person, motion: Motion, prop: str, start: float, t: float) -> None:
        """Look at what was just taken from where nobody sees it, held up: it has to be seen that it is there now."""
        hand = person.hand_of(prop)
        if hand is not None and motion.key != "hold" and not self._is_bag(prop):
            end = self.sheet.cue(person, "show", t, natural_seconds(MOTIONS["show"]), prop_id=prop, hand=hand)
            self.sheet.done(person, start, end)

    def fetch(self, person: Person, prop: str) -> None:
        """Have a prop in hand that lies somewhere near."""
        start = self.sheet.start_of(person)
        t = self._gone_to(person, prop, FETCH, start)
        lies = self._within_reach(person, prop)
        if lies is not None and person.free_hand() is not None:
            t = self._picked_up(person, prop, lies, t)
            self.sheet.done(person, start, t, holds=True)

    def _hands_freed(self, person: Person, prop: str, t: float) -> float:
        """Put a bag on the floor beside one before both hands do something; return the end."""
        return self.put_aside(person, [held for held in person.held.values() if held != prop and self._is_bag(held)], t)

    def _is_bag(self, prop: str, bulk: float = 0.0) -> bool:
        """Tell whether a thing is as long as a bag, and as thick: what is bulky stands on the floor, not on a table.

        A stick is as long and no bag: it stays in the hand.
        """
        size = self.company.size_of(prop)
        return size is not None and size[2] >= BAG and size[1] >= STICK and size[0] >= bulk

    def put_aside(self, person: Person, props: Sequence[str], t: float) -> float:
        """Put what is in somebody's hands on the floor beside them, if they stand; return the end.

        They do not have it in hand again because the script has not said that they put it down.
        """
        for prop in props:
            hand = person.hand_of(prop)
            spot = self._free_beside(person, prop, hand) if person.upright else None
            if spot is None:
                continue
            across = hand == "R" and hand_towards(person.place, person.yaw, spot[:2], LEFT) == "L"
            t = self.sheet.face(person, facing(person.place, spot[:2]), t) if across else self.turn_to(person, spot, t)
            length = natural_seconds(MOTIONS["put_down"])
            mark = _mark_of(person, prop, spot)
            t = self.sheet.cue(person, "put_down", t, length, prop_id=prop, hand=hand, mark=mark)
            self.company.lay(person, prop, spot)
            self.company.aside.add(prop)
        return t

    def _free_beside(self, person: Person, prop: str, hand: Hand | None) -> Vec3 | None:
        """Return where on the floor by somebody a thing has room: ahead first, on the side of the hand."""
        half = (self.company.size_of(prop) or [0.2])[1] / 2
        away = BESIDE_FOOT * person.k + max(0.0, half - 0.1)
        side = 1 if hand == "L" else -1
        others = self.company.others(person)
        for turn in (50, -50, 90, -90, 130, -130):  # what is ahead needs no turn
            yaw = person.yaw + side * math.radians(turn)
            spot = (person.place[0] + away * math.sin(yaw), person.place[1] - away * math.cos(yaw))
            clear = all(math.dist(spot, place) > AT_FEET for place in others)
            if clear and self.company.floor.room_at(spot) > half and self._clear_of_props((*spot, 0.0)) == (*spot, 0.0):
                return (*spot, 0.0)
        return None

    def _gone_to(self, person: Person, prop: str, farthest: float, t: float) -> float:
        """Go to where a prop lies, if that is no farther; return the end."""
        lies = None if person.hand_of(prop) else self.company.lying.get(prop)
        if lies is None or not person.upright or not REACH < math.dist(lies[:2], person.place) < farthest:
            return t
        spot = self.company.floor.spot_at(lies[:2], person.place, person.k, self.company.others(person), REACH)
        return t if spot is None else self.sheet.go(person, spot, facing(spot, lies[:2]), t)

    def _within_reach(self, person: Person, prop: str) -> Vec3 | None:
        """Return where a prop lies if a person can take it from where they are."""
        lies = None if person.hand_of(prop) else self.company.lying.get(prop)
        reach = REACH + 0.25 if person.upright else SEATED_REACH
        return lies if lies is not None and math.dist(lies[:2], person.place) <= reach else None

    def _in_clothes(self, person: Person, prop: str) -> bool:
        """Tell whether a thing is small enough to come out of somebody's clothes, by a free hand."""
        return (
            fits_in_clothes(self.company.size_of(prop))
            and self.company.holder(prop) is None
            and person.free_hand() is not None
        )

    def _picked_up(self, person: Person, prop: str, lies: Vec3, t: float) -> float:
        """Take a prop from where it lies, with the left hand what is on the left; return the end."""
        t = self.turn_to(person, lies, t)
        wish = hand_towards(person.place, person.yaw, lies[:2], LEFT)
        return self._taken(person, MOTIONS["pick_up"], prop, t, wish=wish)

    def _taken(
        self, person: Person, motion: Motion, prop: str, t: float, source: str | None = None, wish: Hand = "R"
    ) -> float:
        """Take a prop, out of a bag or out of clothes if they are named; return the end."""
        hand = person.free_hand(wish)
        t = self.sheet.cue(person, motion.key, t, natural_seconds(motion), target_id=source, prop_id=prop, hand=hand)
        self.company.hand_over(person, prop, wish)
        return t

    def _open_where_it_stands(self, person: Person, motion: Motion, prop: str, start: float, t: float) -> None:
        end = self.sheet.cue(person, motion.key, t, natural_seconds(motion), prop_id=prop, hand=person.free_hand())
        person.opened = prop if motion.key == "open" else ""
        self.sheet.done(person, start, end)

    def _use(self, action: CharacterAction, motion: Motion, person: Person, prop: str, start: float, t: float) -> None:
        """Do something with a prop that is in hand."""
        target = action.target_id if action.target_id != prop else None
        hand = person.hand_of(prop)
        mark = None
        if motion.key in ("put_down", "drop", "throw"):
            t, mark, hand = self._let_go(action, person, prop, t, motion.key)
        known = target if target in self.company.people or self.company.floor.thing(target) else None
        length = natural_seconds(motion)
        end = self.sheet.cue(
            person, motion.key, t, length, target_id=known, prop_id=prop, hand=hand, mark=mark, mood=action.mood
        )
        self.sheet.done(person, start, end)
        size = self.company.size_of(prop)
        if motion.key == "dress" and size is not None and size[2] < RING:
            self.company.wear(person, prop)

    def _stands(self, prop: str) -> bool:
        """Tell whether a thing is opened or typed on where it stands, not in the hand: a box, a case, a laptop."""
        size = self.company.size_of(prop)
        return size is not None and size[1] > BOX

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
    ) -> tuple[float, Mark | None, Hand | None]:
        """Choose where a prop goes when it leaves the hand, and go there; return the end, the place and the hand."""
        hand = person.hand_of(prop)
        thing = self.company.floor.thing(action.target_id) if action.target_id != prop else None
        if key != "put_down":
            partner = self.company.people.get(action.target_id or "")
            goal = partner.place if partner is not None and partner.present else None
            ahead = 0.35 if key == "drop" else 3.0
            x, y = person.place
            landing = goal or (x + ahead * math.sin(person.yaw), y - ahead * math.cos(person.yaw))
            self.company.lay(person, prop, (*landing, 0.0))
            return t, None, hand
        spot: Vec3 | None = None
        hollow = thing is not None and self.company.floor.kinds.get(thing.asset_id) in OPEN_ABOVE
        if thing is None or not (hollow or thing.of_kind("top") or thing.size[2] < 1.4):
            near = 0.0 if self._is_bag(prop, BULK) else 2.5 if person.upright else FROM_SEAT
            highest = TOPS[1] if person.upright else HIGHEST if person.support else FROM_FLOOR
            thing = self.company.floor.nearest_top(person.place, near, highest)
        if thing is not None:
            spot = self._spot_on(thing, person, prop)
            if math.dist(spot[:2], person.place) > (REACH if person.upright else TOO_FAR):
                stand = self.company.floor.spot_at(spot[:2], person.place, person.k, self.company.others(person), REACH)
                if stand is not None:
                    t = self.sheet.go(person, stand, facing(stand, spot[:2]), t)
                    spot = self._spot_on(thing, person, prop)
        if spot is None or (person.upright and math.dist(spot[:2], person.place) > AT_MOST):
            x, y = person.place
            ahead = AHEAD * person.k
            spot = (x + ahead * math.sin(person.yaw), y - ahead * math.cos(person.yaw), 0.0)
        t = self.turn_to(person, spot, t)
        if not person.upright and hand_towards(person.place, person.yaw, spot[:2], LEFT) != hand:
            self.sheet.change_hand(person, prop)
            hand = person.hand_of(prop)
        self.company.lay(person, prop, spot)
        return t, _mark_of(person, prop, spot), hand

    def _spot_on(self, thing: Thing, person: Person, prop: str) -> Vec3:
        """Return where something is put on a top: before who sits at it, towards who puts it there; else nearest.

        Beside who sits on it; on the side of the hand that holds something there is less room.
        """
        floor = self.company.floor
        key, (low, middle, long) = floor.kinds.get(thing.asset_id), self.company.size_of(prop) or (0.1, 0.1, 0.1)
        if key in OPEN_ABOVE and (place := inside(key, thing.size, (long, middle, low))) is not None:
            return thing.world(place)
        sitters = [p for p in self.company.people.values() if p.present and p.posture == "sit"]
        if (beside := self._beside_sitters(thing, person, prop, sitters)) is not None:
            return beside
        for sitter in sorted(sitters, key=lambda each: math.dist(each.place, person.place)):
            (x, y), yaw = sitter.place, sitter.yaw
            away = (person.place[0] - x) * math.cos(yaw) + (person.place[1] - y) * math.sin(yaw)
            most = 0.5 * TO_THE_SIDE if ("L" if away > 0 else "R") in sitter.held else TO_THE_SIDE
            aside = max(-most, min(most, away))
            ahead = (x + BEFORE * math.sin(yaw), y - BEFORE * math.cos(yaw))
            spot = floor.on_top(thing, (ahead[0] + aside * math.cos(yaw), ahead[1] + aside * math.sin(yaw)))
            if spot is not None and math.dist(spot[:2], person.place) < AT_TABLE:
                return self._clear_of_props(spot)
        return self._clear_of_props(floor.top_of(thing, person.place))

    def _beside_sitters(self, thing: Thing, person: Person, prop: str, sitters: Sequence[Person]) -> Vec3 | None:
        """Return the free place on a seat: between two who sit there, else beside the one; None if nobody does."""
        there = [each for each in sitters if each.support == thing.node_id]
        if not there:
            return None
        there.sort(key=lambda each: math.dist(each.place, person.place))
        (x, y), yaw = there[0].place, there[0].yaw
        left = (math.cos(yaw), math.sin(yaw))
        along = [(each.place[0] - x) * left[0] + (each.place[1] - y) * left[1] for each in there]
        wish = sum(along[:2]) / len(along[:2])
        half = (self.company.size_of(prop) or [0.2])[-1] / 2
        full = person is there[0] and person.free_hand() is None  # then the other hand cannot take it across
        free: list[tuple[float, Vec3]] = []
        for step in range(-24, 25):
            s = 0.05 * step
            spot = self.company.floor.on_top(
                thing, (x + s * left[0] - INWARD * math.sin(yaw), y + s * left[1] + INWARD * math.cos(yaw))
            )
            clear = all(abs(s - at) > HIPS * each.k + half for at, each in zip(along, there, strict=True))
            if spot is not None and clear and self._clear_of_props(spot) == spot:
                across = full and (s > 0) == (person.hand_of(prop) == "R")
                free.append((abs(s - wish) + across, spot))
        return min(free)[1] if free else None

    def _clear_of_props(self, spot: Vec3) -> Vec3:
        """Move a place on a top aside until nothing stands there."""
        taken = [place for place in self.company.lying.values() if abs(place[2] - spot[2]) < 0.1]
        for dx, dy in ((0.0, 0.0), (0.18, 0.0), (-0.18, 0.0), (0.0, 0.16), (0.0, -0.16), (0.3, 0.1), (-0.3, 0.1)):
            moved = (spot[0] + dx, spot[1] + dy, spot[2])
            if all(math.dist(moved[:2], place[:2]) > 0.15 for place in taken):
                return moved
        return spot

    def turn_to(self, person: Person, spot: Vec3, t: float) -> float:
        """Face what the hands are about to work on; return the end."""
        if math.dist(spot[:2], person.place) < 0.2:
            return t
        yaw = facing(person.place, spot[:2])
        return self.sheet.face(person, yaw, t) if abs(turn_between(person.yaw, yaw)) > ASIDE else t


def fits_in_clothes(size: Sequence[float] | None) -> bool:
    """Tell whether a thing is small enough for somebody's clothes, by its extents, the smallest first."""
    return size is not None and all(side < room for side, room in zip(size, POCKET, strict=True))


def _mark_of(person: Person, prop: str, spot: Vec3) -> Mark:
    rounded = (round(spot[0], 3), round(spot[1], 3), round(spot[2], 3))
    return Mark(asset_id=prop, location=rounded, yaw=round(math.degrees(person.yaw) % 360, 1))

"""Cues of people who handle props: fetch, take, use, throw and put down. Pure.

Times are seconds of the shot. Places are in metres in the set; yaws are in radians, counter-clockwise, and 0 faces the
audience at -Y. A prop is named by its asset id.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from storyblender.agents.visual_effects_artist.cue_sheet import REACH, CueSheet
from storyblender.agents.visual_effects_artist.floor import facing
from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.placed_objects import TOPS, is_put_on
from storyblender.agents.visual_effects_artist.prop_spots import PropSpots
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.catalog.carrying import hand_towards
from storyblender.catalog.hollows import OPEN_ABOVE
from storyblender.catalog.motions import MOTIONS, Motion, natural_seconds
from storyblender.geometry.boxes import shortest_turn
from storyblender.memory.base import Vec3
from storyblender.memory.shot_context import CharacterAction, Mark, PropState
from storyblender.memory.vocabulary import Hand

TAKING_MOTIONS = frozenset({"pick_up", "take", "hold", "catch"})
"""Motions after which a person has the prop in hand."""
WRITING = frozenset({"write", "draw", "cross_out"})
"""Motions with a tool on a page."""
FETCH_DISTANCE = 5.0
"""Metres from which a person walks to a prop to take it."""
USE_DISTANCE = 3.0
"""Metres from which a person walks to a prop to use it; a prop that lies farther off is in hand from the start."""
WORK_DISTANCE = 12.0
"""Metres from which a person walks to a prop that is opened, typed on or pressed where it stands."""
BOX_WIDTH = 0.18
"""Metres: a prop whose second largest extent is greater is opened where it stands, not in the hand."""
LEFT_HAND_OFFSET = 0.2
"""Metres to a person's left from which the left hand takes a prop."""
POCKET_SIZE = (0.12, 0.22, 0.36)
"""Extents in metres, ascending: a prop smaller in all three fits into a pocket."""
SEATED_REACH = 0.45
"""Metres from the place of a sitting person to the props they can take."""
SEATED_TOP_DISTANCE = 0.9
"""Metres within which a person who does not stand looks for a top to put a prop on."""
STANDING_REACH = 1.0
"""Metres from a standing person to the farthest spot on which they put a prop down."""
AHEAD_OF_FEET = 0.42
"""Metres ahead of a person at which a prop is put on the floor, times stature over 1.7."""
HIGHEST_TOP_SEATED = 1.0
"""Metres above the floor: the highest top on which a sitting or leaning person puts a prop."""
HIGHEST_TOP_FROM_FLOOR = 0.6
"""Metres above the floor: the highest top on which a person who sits or lies on the floor puts a prop."""
SEATED_FARTHEST = 1.25
"""Metres to a spot beyond which a person who does not stand gets up and goes there."""
CASE_DEPTH = 0.2
"""Metres: a bag whose smallest extent is at least this stands on the floor, not on a table."""
RING_SIZE = 0.06
"""Metres: a prop whose largest extent is less is worn once a person has put it on."""
TURN_ANGLE = math.radians(60)
"""Radians: a person turns to a spot that is farther than this from straight ahead before they handle a prop there."""


class Release(NamedTuple):
    """The release of a prop from a hand.

    Attributes:
        second: Second of the shot at which the person can let go.
        mark: Where the prop is put down; None if it is dropped or thrown.
        hand: The hand that holds the prop.
    """

    second: float
    mark: Mark | None
    hand: Hand | None


class Handling:
    """Writes the cues of people who handle props.

    Args:
        stage: People and props of the scene.
        sheet: The cue sheet that takes the cues.
    """

    def __init__(self, stage: StageState, sheet: CueSheet) -> None:
        self.stage, self.sheet, self.spots = stage, sheet, PropSpots(stage)

    def handle_prop(
        self, action: CharacterAction, motion: Motion, person: StagedPerson, prop: str, later: Sequence[CharacterAction]
    ) -> None:
        """Write the cues of one action on a prop, including the walk to the prop and taking it in hand.

        Args:
            action: The action in the script.
            motion: The motion that plays the action.
            person: The person who acts.
            prop: Asset id of the prop.
            later: The actions that follow in the shot; the first one on the prop tells who catches it.
        """
        start, getting = self.sheet.earliest_start(person), motion.key in TAKING_MOTIONS
        if (getting and person.hand_of(prop)) or (motion.key == "hold" and prop in person.on_body):
            return
        now = self._put_bags_down(person, prop, start) if motion.hands == 2 else start
        switched = motion.key == "press" and prop in self.stage.prop_places
        switched = switched and not fits_in_clothes(self.stage.size_of(prop))
        where_it_is = switched or (motion.key in ("open", "close", "type") and self._is_used_in_place(prop))
        farthest = WORK_DISTANCE if where_it_is else FETCH_DISTANCE if getting else USE_DISTANCE
        now = self._go_to_prop(person, prop, farthest, now)
        lies = self._location_in_reach(person, prop)
        bag = self.stage.find_bag(person, prop) if getting else None
        if switched:
            at = self.stage.prop_places[prop]
            now = self.turn_to_spot(person, at, now) if person.upright else now
            thing = self.stage.floor.thing(prop)
            target = thing.node_id if thing is not None else prop
            end = self.sheet.add_cue(
                person, motion.key, now, natural_seconds(motion), target_id=target, mood=action.mood
            )
            self.sheet.finish_action(person, start, end)
            return
        if lies is not None and where_it_is:
            self._work_in_place(person, motion, prop, start, self.turn_to_spot(person, lies, now))
            return
        if lies is not None:
            now = self._pick_up(person, prop, lies, now)
        elif bag is not None:
            now = self._take(person, MOTIONS["take"], prop, now, bag)
        elif getting and self._comes_out_of_clothes(person, prop):
            self.sheet.start_with_prop_in_clothes(person, prop)
            now = self._take(person, MOTIONS["take"], prop, now, person.asset_id)
        elif not person.hand_of(prop):
            self.sheet.start_with_prop_in_hand(person, prop)
            if getting:
                self._show_taken_prop(person, motion, prop, start, now)
                return
        if getting:
            self.sheet.finish_action(person, start, now)
            return
        catcher = self._find_catcher(person, prop, later) if motion.key == "throw" else None
        if catcher is not None:
            self._throw_to_catcher(person, catcher, prop, now)
        else:
            self._use_held_prop(action, motion, person, prop, start, now)

    def _show_taken_prop(self, person: StagedPerson, motion: Motion, prop: str, start: float, now: float) -> None:
        """Write a cue in which a person holds up a prop taken from out of sight, so that the audience sees it.

        Args:
            person: The person who holds the prop.
            motion: The motion that took the prop; nothing is shown after ``hold``.
            prop: Asset id of the prop; a bag is not shown.
            start: Second of the shot at which the action began.
            now: Second of the shot at which the prop is held up.
        """
        hand = person.hand_of(prop)
        if hand is not None and motion.key != "hold" and not self.spots.is_bag(prop):
            end = self.sheet.add_cue(person, "show", now, natural_seconds(MOTIONS["show"]), prop_id=prop, hand=hand)
            self.sheet.finish_action(person, start, end)

    def fetch_prop(self, person: StagedPerson, prop: str) -> None:
        """Let a person walk to a prop (asset id) that lies nearby and pick it up, if they have a free hand."""
        start = self.sheet.earliest_start(person)
        now = self._go_to_prop(person, prop, FETCH_DISTANCE, start)
        lies = self._location_in_reach(person, prop)
        if lies is not None and person.free_hand() is not None:
            now = self._pick_up(person, prop, lies, now)
            self.sheet.finish_action(person, start, now, holds=True)

    def _put_bags_down(self, person: StagedPerson, prop: str, now: float) -> float:
        """Put down all held bags but ``prop`` from second ``now`` on; return the second at which that ends."""
        bags = [held for held in person.held.values() if held != prop and self.spots.is_bag(held)]
        return self.put_props_aside(person, bags, now)

    def put_props_aside(self, person: StagedPerson, props: Sequence[str], now: float) -> float:
        """Put held props on the floor beside a standing person; they stay there until the script has them taken again.

        Args:
            person: The person; nothing happens if they do not stand.
            props: Asset ids of props in the person's hands.
            now: Second of the shot at which the person begins.

        Returns:
            Second of the shot at which the last prop is down; ``now`` if none was put down.
        """
        for prop in props:
            hand = person.hand_of(prop)
            spot = self.spots.find_beside(person, prop, hand) if person.upright else None
            if spot is None:
                continue
            across = hand == "R" and hand_towards(person.place, person.yaw, spot[:2], LEFT_HAND_OFFSET) == "L"
            yaw = facing(person.place, spot[:2])
            now = self.sheet.turn_to_yaw(person, yaw, now) if across else self.turn_to_spot(person, spot, now)
            length = natural_seconds(MOTIONS["put_down"])
            mark = _prop_mark(person, prop, spot)
            now = self.sheet.add_cue(person, "put_down", now, length, prop_id=prop, hand=hand, mark=mark)
            self.stage.lay_down(prop, spot)
            self.stage.aside.add(prop)
        return now

    def _go_to_prop(self, person: StagedPerson, prop: str, farthest: float, now: float) -> float:
        """Walk to a prop that lies less than ``farthest`` metres away; return the second of the shot of the arrival."""
        lies = None if person.hand_of(prop) else self.stage.prop_places.get(prop)
        if lies is None or not person.upright or not REACH < math.dist(lies[:2], person.place) < farthest:
            return now
        spot = self.stage.floor.spot_around(lies[:2], person.place, person.scale, self.stage.others(person), REACH)
        return now if spot is None else self.sheet.walk_to(person, spot, facing(spot, lies[:2]), now)

    def _location_in_reach(self, person: StagedPerson, prop: str) -> Vec3 | None:
        """Return the position of a lying prop, in metres in the set, if the person can take it without walking."""
        lies = None if person.hand_of(prop) else self.stage.prop_places.get(prop)
        reach = REACH + 0.25 if person.upright else SEATED_REACH
        return lies if lies is not None and math.dist(lies[:2], person.place) <= reach else None

    def _comes_out_of_clothes(self, person: StagedPerson, prop: str) -> bool:
        """Tell whether a person can take a prop out of their clothes: it fits, nobody has it, and a hand is free."""
        return (
            fits_in_clothes(self.stage.size_of(prop))
            and self.stage.holder_of(prop) is None
            and person.free_hand() is not None
        )

    def _pick_up(self, person: StagedPerson, prop: str, lies: Vec3, now: float) -> float:
        """Turn to a prop at the position ``lies`` and pick it up with the hand on its side; return the end second."""
        now = self.turn_to_spot(person, lies, now)
        wish = hand_towards(person.place, person.yaw, lies[:2], LEFT_HAND_OFFSET)
        return self._take(person, MOTIONS["pick_up"], prop, now, wish=wish)

    def _take(
        self, person: StagedPerson, motion: Motion, prop: str, now: float, source: str | None = None, wish: Hand = "R"
    ) -> float:
        """Write the cue in which a person takes a prop.

        Args:
            person: The person.
            motion: The motion that takes the prop.
            prop: Asset id of the prop.
            now: Second of the shot at which the cue starts.
            source: Asset id of the bag, or of the person in whose clothes the prop is; None if it lies in the open.
            wish: The hand that takes the prop if it is free.

        Returns:
            Second of the shot at which the cue ends.
        """
        hand = person.free_hand(wish)
        now = self.sheet.add_cue(
            person, motion.key, now, natural_seconds(motion), target_id=source, prop_id=prop, hand=hand
        )
        self.stage.put_in_hand(person, prop, wish)
        return now

    def _work_in_place(self, person: StagedPerson, motion: Motion, prop: str, start: float, now: float) -> None:
        """Open, close or type on a prop where it stands, from second ``now`` of an action begun at ``start``."""
        end = self.sheet.add_cue(
            person, motion.key, now, natural_seconds(motion), prop_id=prop, hand=person.free_hand()
        )
        person.opened = prop if motion.key == "open" else ""
        self.sheet.finish_action(person, start, end)

    def _use_held_prop(
        self, action: CharacterAction, motion: Motion, person: StagedPerson, prop: str, start: float, now: float
    ) -> None:
        """Write the cue of a motion with a held prop, from second ``now`` of an action begun at second ``start``."""
        target = action.target_id if action.target_id != prop else None
        if target is not None and motion.key in WRITING:
            now = self._come_to_page(person, target, now)
        hand = person.hand_of(prop)
        mark = None
        if motion.key in ("put_down", "drop", "throw"):
            now, mark, hand = self._prepare_release(action, person, prop, now, motion.key)
        held = target is not None and self.stage.holder_of(target) is not None
        known = target if held or target in self.stage.people or self.stage.floor.thing(target) else None
        length = natural_seconds(motion)
        end = self.sheet.add_cue(
            person, motion.key, now, length, target_id=known, prop_id=prop, hand=hand, mark=mark, mood=action.mood
        )
        self.sheet.finish_action(person, start, end)
        size = self.stage.size_of(prop)
        if motion.key == "dress" and size is not None and size[2] < RING_SIZE:
            self.stage.put_on(prop)

    def _come_to_page(self, person: StagedPerson, page: str, now: float) -> float:
        """Go to the page (asset id) that is written on; before a sitter it lies within reach as the shot begins."""
        lies = self.stage.prop_places.get(page)
        if lies is None or person.upright:
            return self._go_to_prop(person, page, USE_DISTANCE, now)
        top = self.stage.floor.nearest_top(person.place, SEATED_TOP_DISTANCE, HIGHEST_TOP_SEATED)
        if top is not None and SEATED_REACH < math.dist(lies[:2], person.place) < USE_DISTANCE:
            spot = self.spots.find_on(top, person, page)
            self.stage.lay_down(page, spot)
            kept = [state for state in self.sheet.start_props if state.asset_id != page]
            self.sheet.start_props = (*kept, PropState(asset_id=page, location=_prop_mark(person, page, spot).location))
        return now

    def _is_used_in_place(self, prop: str) -> bool:
        """Tell whether a prop is too wide to be opened or typed on in the hand, such as a case or a laptop."""
        size = self.stage.size_of(prop)
        return size is not None and size[1] > BOX_WIDTH

    def _find_catcher(self, person: StagedPerson, prop: str, later: Sequence[CharacterAction]) -> StagedPerson | None:
        """Return the person who catches a thrown prop in the next of the ``later`` actions; None if nobody does."""
        for action in later:
            catcher = self.stage.people.get(action.asset_id)
            if catcher is None or catcher is person or self.stage.prop_of(action) != prop:
                continue
            able = catcher.present and catcher.free_hand() and catcher.posture not in ("lie", "asleep")
            return catcher if able and action.motion in TAKING_MOTIONS else None
        return None

    def _throw_to_catcher(self, person: StagedPerson, catcher: StagedPerson, prop: str, now: float) -> None:
        """Write the cues of a throw and its catch; both begin at second ``now``, or later when both people are free."""
        start = now
        now = self.sheet.turn_to_yaw(person, facing(person.place, catcher.place), max(now, catcher.busy))
        if catcher.upright:
            now = max(now, self.sheet.turn_to_yaw(catcher, facing(catcher.place, person.place), now))
        hand = person.hand_of(prop)
        end = self.sheet.add_cue(
            person, "throw", now, natural_seconds(MOTIONS["throw"]), target_id=catcher.asset_id, prop_id=prop, hand=hand
        )
        free = catcher.free_hand()
        caught = self.sheet.add_cue(
            catcher, "catch", now, natural_seconds(MOTIONS["catch"]), target_id=person.asset_id, prop_id=prop, hand=free
        )
        self.stage.put_in_hand(catcher, prop)
        self.sheet.finish_action(person, start, end)
        self.sheet.finish_action(catcher, start, caught, holds=True)

    def _prepare_release(
        self, action: CharacterAction, person: StagedPerson, prop: str, now: float, key: str
    ) -> Release:
        """Choose where a prop goes when it leaves the hand, lay it there, and bring the person to that spot.

        Args:
            action: The action in the script; its target is what the prop is put on or thrown to.
            person: The person who holds the prop.
            prop: Asset id of the prop.
            now: Second of the shot at which the person is ready.
            key: Key of the motion: ``put_down``, ``drop`` or ``throw``.
        """
        hand = person.hand_of(prop)
        thing = self.stage.floor.thing(action.target_id) if action.target_id != prop else None
        if key != "put_down":
            partner = self.stage.people.get(action.target_id or "")
            goal = partner.place if partner is not None and partner.present else None
            ahead = 0.35 if key == "drop" else 3.0
            x, y = person.place
            landing = goal or (x + ahead * math.sin(person.yaw), y - ahead * math.cos(person.yaw))
            self.stage.lay_down(prop, (*landing, 0.0))
            return Release(now, None, hand)
        spot: Vec3 | None = None
        hollow = thing is not None and self.stage.floor.kinds.get(thing.asset_id) in OPEN_ABOVE
        if thing is None or not (hollow or is_put_on(thing)):
            near = (
                0.0 if self.spots.is_bag(prop, min_depth=CASE_DEPTH) else 2.5 if person.upright else SEATED_TOP_DISTANCE
            )
            highest = TOPS[1] if person.upright else HIGHEST_TOP_SEATED if person.support else HIGHEST_TOP_FROM_FLOOR
            thing = self.stage.floor.nearest_top(person.place, near, highest)
        if thing is not None:
            spot = self.spots.find_on(thing, person, prop)
            if math.dist(spot[:2], person.place) > (REACH if person.upright else SEATED_FARTHEST):
                stand = self.stage.floor.spot_around(
                    spot[:2], person.place, person.scale, self.stage.others(person), REACH
                )
                if stand is not None:
                    now = self.sheet.walk_to(person, stand, facing(stand, spot[:2]), now)
                    spot = self.spots.find_on(thing, person, prop)
        if spot is None or (person.upright and math.dist(spot[:2], person.place) > STANDING_REACH):
            x, y = person.place
            ahead = AHEAD_OF_FEET * person.scale
            spot = (x + ahead * math.sin(person.yaw), y - ahead * math.cos(person.yaw), 0.0)
        now = self.turn_to_spot(person, spot, now)
        if not person.upright and hand_towards(person.place, person.yaw, spot[:2], LEFT_HAND_OFFSET) != hand:
            self.sheet.move_to_other_hand(person, prop)
            hand = person.hand_of(prop)
        self.stage.lay_down(prop, spot)
        return Release(now, _prop_mark(person, prop, spot), hand)

    def turn_to_spot(self, person: StagedPerson, spot: Vec3, now: float) -> float:
        """Turn a person, from second ``now`` on, to a world point far to their side; return the second it ends."""
        if math.dist(spot[:2], person.place) < 0.2:
            return now
        yaw = facing(person.place, spot[:2])
        return self.sheet.turn_to_yaw(person, yaw, now) if abs(shortest_turn(person.yaw, yaw)) > TURN_ANGLE else now


def fits_in_clothes(size: Sequence[float] | None) -> bool:
    """Tell whether a prop fits into clothes; ``size`` has its extents in metres, ascending, or is None if unknown."""
    return size is not None and all(side < room for side, room in zip(size, POCKET_SIZE, strict=True))


def _prop_mark(person: StagedPerson, prop: str, spot: Vec3) -> Mark:
    """Return the mark of a prop that a person puts on a spot, turned as the person is."""
    rounded = (round(spot[0], 3), round(spot[1], 3), round(spot[2], 3))
    return Mark(asset_id=prop, location=rounded, yaw=round(math.degrees(person.yaw) % 360, 1))

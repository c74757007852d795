"""Animals that walk or fly: where they are, what they turn to and where they go, from shot to shot."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from storyblender.agents.visual_effects_artist.floor import facing
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.agents.visual_effects_artist.ways import point_on_line
from storyblender.catalog.motions import MOTIONS
from storyblender.geometry.boxes import shortest_turn
from storyblender.geometry.paths import Vec2
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import CharacterAction, Cue, Mark, PropState, ShotContext

GOAL_GAP = 0.5
"""Metres between an animal and the side of its goal."""
DEFAULT_STEP = 2.4
"""Metres an animal goes if the script gives no goal, and from which it enters."""
SECONDS_PER_METRE = 1.1
"""Seconds per metre of walk, divided by the square root of the animal's length in metres: small ones are slower."""
START_DELAY = 0.3
"""Seconds of the shot before the first animal acts."""
LEAST_TURN = math.radians(15)
"""Least turn in radians that is animated."""
_FLIGHT_HEIGHT = 1.6
"""Metres above the floor at which a bird flies."""


@dataclass
class _Animal:
    """An animal as of its last cue: world position, yaw in radians, length in metres."""

    place: Vec3
    yaw: float
    length: float
    seen: bool = False
    moved: bool = False
    home: Vec2 | None = None
    """Floor point to which an entering animal goes."""


class Animals:
    """The animals of a scene that are catalog props and move.

    Args:
        stage: The people of the scene, as goals of the animals.
        assets: Assets of the scene.
        objects: The layout, for the animals' first places.
    """

    def __init__(self, stage: StageState, assets: Sequence[Asset], objects: Sequence[LayoutObject]) -> None:
        self.stage = stage
        animals = {
            asset.asset_id: asset.canonical.dimensions
            for asset in assets
            if asset.asset_type == "object" and "animal" in asset.tags and asset.canonical is not None
        }
        self.animals = {
            item.asset_id: _Animal(item.location, math.radians(item.rotation[2]), max(animals[item.asset_id][:2]))
            for item in reversed(objects)
            if item.asset_id in animals
        }

    def play(self, shot: ShotContext, fps: int, frames: int) -> tuple[tuple[Cue, ...], tuple[PropState, ...]]:
        """Return the animals' cues of a shot, and the states of those that have moved when it begins.

        Args:
            shot: The shot with its actions.
            fps: Frames per second.
            frames: Length of the shot in frames.
        """
        cues: list[Cue] = []
        states: list[PropState] = []
        for name, animal in self.animals.items():
            own = [action for action in shot.character_actions if action.asset_id == name]
            if own and not animal.seen and MOTIONS[own[0].motion].speed and own[0].target_id is None:
                self._start_at_entrance(animal)
            if animal.moved or own:
                states.append(_prop_state(name, animal))
            clock = round(START_DELAY * fps)
            for action in own:
                cue = self._make_cue(name, animal, action, clock, fps, frames)
                if cue is not None:
                    cues.append(cue)
                    clock = min(frames - 2, cue.start + (cue.duration or 0))
            animal.seen = animal.seen or bool(own)
        return tuple(cues), tuple(states)

    def _start_at_entrance(self, animal: _Animal) -> None:
        """Start an animal some steps from its place, on the side where people enter, and end at its place."""
        doors = self.stage.floor.enter_marks()
        home = (animal.place[0], animal.place[1])
        door = min(doors, key=lambda spot: math.dist(spot, home)) if doors else (home[0] - DEFAULT_STEP, home[1])
        start = point_on_line(home, door, min(DEFAULT_STEP, math.dist(home, door)))
        animal.yaw = facing(start, home) if math.dist(start, home) > 0.1 else animal.yaw
        animal.place = (start[0], start[1], animal.place[2])
        animal.home = home

    def _make_cue(
        self, name: str, animal: _Animal, action: CharacterAction, start: int, fps: int, frames: int
    ) -> Cue | None:
        """Return the cue of an action from frame ``start`` on, and move the animal; None if it stays as it is."""
        here = (animal.place[0], animal.place[1])
        motion = MOTIONS[action.motion]
        target = self._find_place(action.target_id)
        goal, yaw = here, animal.yaw
        if motion.speed:
            goal = self._walk_goal(animal, action, target)
            yaw = facing(here, goal) if math.dist(here, goal) > 0.1 else yaw
        if target is not None and math.dist(goal, target) > 0.05:
            yaw = facing(goal, target)
        if math.dist(here, goal) < 0.1 and abs(shortest_turn(animal.yaw, yaw)) < LEAST_TURN and not action.flies:
            return None
        way = math.dist(here, goal)
        seconds = 0.5 + SECONDS_PER_METRE * way / math.sqrt(max(0.2, animal.length)) * (
            0.45 if motion.key == "run" else 1.0
        )
        animal.place = (round(goal[0], 3), round(goal[1], 3), _FLIGHT_HEIGHT if action.flies else animal.place[2])
        animal.yaw, animal.moved = yaw, True
        mark = Mark(asset_id=name, location=animal.place, yaw=round(math.degrees(yaw), 2))
        length = max(2, min(round(seconds * fps), frames - start - 1))
        clip = motion.key if way > 0.1 else "turn"
        return Cue(
            asset_id=name, clip=clip, start=max(0, start), duration=length, mark=mark, target_id=action.target_id
        )

    def _walk_goal(self, animal: _Animal, action: CharacterAction, target: Vec2 | None) -> Vec2:
        """Return the end of a walk: beside its target, at its place in the set, or some steps ahead."""
        here, floor = (animal.place[0], animal.place[1]), self.stage.floor
        people = [person.place for person in self.stage.people.values() if person.present]
        if target is not None:
            apart = GOAL_GAP + animal.length / 2
            return floor.free_spot(point_on_line(target, here, apart), 0.5, people, apart=0.35)
        if animal.home is not None and not animal.seen:
            return animal.home
        step = action.distance or DEFAULT_STEP
        wish = (here[0] + step * math.sin(animal.yaw), here[1] - step * math.cos(animal.yaw))
        return floor.free_spot(wish, 0.5, people)

    def _find_place(self, name: str | None) -> Vec2 | None:
        """Return the floor point of a person, an animal or a thing; None if it is unknown."""
        person = self.stage.people.get(name or "")
        if person is not None and person.present:
            return person.place
        animal = self.animals.get(name or "")
        if animal is not None:
            return (animal.place[0], animal.place[1])
        thing = self.stage.floor.thing(name)
        return None if thing is None else (thing.location[0], thing.location[1])


def _prop_state(name: str, animal: _Animal) -> PropState:
    x, y, z = animal.place
    return PropState(
        asset_id=name,
        location=(round(x, 3), round(y, 3), round(z, 3)),
        rotation=(0.0, 0.0, round(math.degrees(animal.yaw), 2)),
    )

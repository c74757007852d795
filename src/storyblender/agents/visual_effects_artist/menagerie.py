"""Animals on their own feet: where they stand, what they turn to and where they go, from shot to shot. Pure."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from storyblender.agents.visual_effects_artist.company import Company
from storyblender.agents.visual_effects_artist.floor import facing
from storyblender.catalog.motions import clip_of
from storyblender.geometry.boxes import shortest_turn
from storyblender.geometry.paths import Vec2
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import CharacterAction, Cue, Mark, PropState, ShotContext

BESIDE = 0.5
"""Metres between an animal and the side of its goal."""
AHEAD = 2.4
"""Metres an animal goes if the script gives no goal, and from which it enters."""
PACE = 1.1
"""Seconds per metre of walk, divided by the square root of the animal's length in metres: small ones are slower."""
AT_ONCE = 0.3
"""Seconds before the first animal acts."""
WORTH = math.radians(15)
"""Least turn in radians that is played."""
_FLIGHT = ("flies", "flew", "flying", "fly ", "soars", "swoops", "flutters", "hovers", "takes off")
_HEIGHT = 1.6
"""Metres above the floor at which a bird flies."""


@dataclass
class _Beast:
    place: Vec3
    yaw: float
    length: float
    seen: bool = False
    moved: bool = False
    home: Vec2 | None = None
    """Floor point to which an entering animal goes."""


class Menagerie:
    """The animals of a scene that are catalog props and move.

    Args:
        company: The people of the scene, as goals of the animals.
        assets: Assets of the scene.
        objects: The layout, for the animals' first places.
    """

    def __init__(self, company: Company, assets: Sequence[Asset], objects: Sequence[LayoutObject]) -> None:
        self.company = company
        animals = {
            asset.asset_id: asset.canonical.dimensions
            for asset in assets
            if asset.asset_type == "object" and "animal" in asset.tags and asset.canonical is not None
        }
        self.beasts = {
            item.asset_id: _Beast(item.location, math.radians(item.rotation[2]), max(animals[item.asset_id][:2]))
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
        for name, beast in self.beasts.items():
            own = [action for action in shot.character_actions if action.asset_id == name]
            if own and not beast.seen and clip_of(own[0].motion).speed and own[0].target_id is None:
                self._comes_in(beast)
            if beast.moved or own:
                states.append(_state(name, beast))
            clock = round(AT_ONCE * fps)
            for action in own:
                cue = self._cue(name, beast, action, clock, fps, frames)
                if cue is not None:
                    cues.append(cue)
                    clock = min(frames - 2, cue.start + (cue.duration or 0))
            beast.seen = beast.seen or bool(own)
        return tuple(cues), tuple(states)

    def _comes_in(self, beast: _Beast) -> None:
        """Start an animal some steps from its place, on the side where people enter, and end at its place."""
        doors = self.company.enter_marks()
        home = (beast.place[0], beast.place[1])
        door = min(doors, key=lambda spot: math.dist(spot, home)) if doors else (home[0] - AHEAD, home[1])
        start = _towards(home, door, min(AHEAD, math.dist(home, door)))
        beast.yaw = facing(start, home) if math.dist(start, home) > 0.1 else beast.yaw
        beast.place = (start[0], start[1], beast.place[2])
        beast.home = home

    def _cue(self, name: str, beast: _Beast, action: CharacterAction, start: int, fps: int, frames: int) -> Cue | None:
        here = (beast.place[0], beast.place[1])
        motion = clip_of(action.motion)
        target = self._where(action.target_id)
        goal, yaw = here, beast.yaw
        if motion.speed:
            goal = self._goal(beast, action, target)
            yaw = facing(here, goal) if math.dist(here, goal) > 0.1 else yaw
        if target is not None and math.dist(goal, target) > 0.05:
            yaw = facing(goal, target)
        flies = any(word in f"{action.action_description.lower()} " for word in _FLIGHT)
        if math.dist(here, goal) < 0.1 and abs(shortest_turn(beast.yaw, yaw)) < WORTH and not flies:
            return None
        way = math.dist(here, goal)
        seconds = 0.5 + PACE * way / math.sqrt(max(0.2, beast.length)) * (0.45 if motion.key == "run" else 1.0)
        beast.place = (round(goal[0], 3), round(goal[1], 3), _HEIGHT if flies else beast.place[2])
        beast.yaw, beast.moved = yaw, True
        mark = Mark(asset_id=name, location=beast.place, yaw=round(math.degrees(yaw), 2))
        length = max(2, min(round(seconds * fps), frames - start - 1))
        clip = motion.key if way > 0.1 else "turn"
        return Cue(
            asset_id=name, clip=clip, start=max(0, start), duration=length, mark=mark, target_id=action.target_id
        )

    def _goal(self, beast: _Beast, action: CharacterAction, target: Vec2 | None) -> Vec2:
        """Return the end of a walk: beside its target, at its place in the set, or some steps ahead."""
        here, floor = (beast.place[0], beast.place[1]), self.company.floor
        people = [person.place for person in self.company.people.values() if person.present]
        if target is not None:
            apart = BESIDE + beast.length / 2
            return floor.free_near(_towards(target, here, apart), 0.5, people, apart=0.35)
        if beast.home is not None and not beast.seen:
            return beast.home
        step = action.distance or AHEAD
        wish = (here[0] + step * math.sin(beast.yaw), here[1] - step * math.cos(beast.yaw))
        return floor.free_near(wish, 0.5, people)

    def _where(self, name: str | None) -> Vec2 | None:
        """Return the current floor point of a person or thing."""
        person = self.company.people.get(name or "")
        if person is not None and person.present:
            return person.place
        beast = self.beasts.get(name or "")
        if beast is not None:
            return (beast.place[0], beast.place[1])
        thing = self.company.floor.thing(name)
        return None if thing is None else (thing.location[0], thing.location[1])


def _towards(start: Vec2, goal: Vec2, length: float) -> Vec2:
    """Return the point ``length`` metres from ``start`` on the way to ``goal``."""
    share = length / max(math.dist(start, goal), 1e-6)
    return (start[0] + share * (goal[0] - start[0]), start[1] + share * (goal[1] - start[1]))


def _state(name: str, beast: _Beast) -> PropState:
    x, y, z = beast.place
    return PropState(
        asset_id=name,
        location=(round(x, 3), round(y, 3), round(z, 3)),
        rotation=(0.0, 0.0, round(math.degrees(beast.yaw), 2)),
    )

"""How many random rooms the layout solver solves, and how fast: ``python benchmarks/layout_solver.py [first seed]``.

A room is drawn valid, its relations are written down, then everything is thrown about (1.3 m, any yaw, some in the
air). The solver sees only the relations. Time is processor time, so that other work on the machine does not count.
"""

from __future__ import annotations

import math
import statistics
import sys
import time

import numpy as np

from storyblender.geometry.boxes import Box, wrap_angle, yaw_along
from storyblender.geometry.relations import BEARING, DIRECTION_TURN, LayoutThing, PlayingArea, slide_to_gap, violations
from storyblender.geometry.solver import solve

ROOMS = 200


def random_room(seed: int) -> tuple[list[LayoutThing], PlayingArea]:
    """Return a valid layout of 8 to 25 boxes."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(8, 26))
    half = float(rng.uniform(3.2, 5.5) if count > 14 else rng.uniform(2.5, 4.5))
    room = PlayingArea(-half, half, -half, half)
    things: list[LayoutThing] = []
    for index in range(count):
        for _ in range(300):
            thing = _draw(f"thing_{index}", things, room, rng)
            if not violations([*things, thing], room):
                things.append(thing)
                break
    return things, room


def _draw(name: str, things: list[LayoutThing], room: PlayingArea, rng: np.random.Generator) -> LayoutThing:
    low = [t for t in things if 0.4 < t.box.height < 1.1 and t.box.width * t.box.depth > 0.5 and t.box.z == 0]
    if low and rng.random() < 0.25:
        anchor = low[int(rng.integers(len(low)))]
        x, y = anchor.box.to_world(*(rng.uniform(-0.4, 0.4, 2) * (anchor.box.width, anchor.box.depth)))
        size = rng.uniform((0.08, 0.08, 0.08), (0.3, 0.25, 0.4))
        yaw = anchor.box.yaw + math.radians(float(rng.choice((0, 0, 15, -30))))
        box = Box(float(x), float(y), anchor.box.height, *map(float, size), yaw)
        return LayoutThing(name, box, anchor.name, "on_top_of", True, mass=0.3)
    sort = rng.choice(("person", "person", "furniture", "furniture", "stool"))
    size, mass = {
        "person": ((0.55, 0.4, rng.uniform(1.55, 1.9)), 1.0),
        "furniture": (tuple(rng.uniform((0.8, 0.5, 0.45), (2.1, 1.1, 1.9))), 4.0),
        "stool": (tuple(rng.uniform((0.3, 0.3, 0.3), (0.6, 0.6, 0.9))), 1.5),
    }[str(sort)]
    yaw = float(rng.uniform(-math.pi, math.pi)) if sort == "person" else math.radians(float(rng.choice((0, 90, 270))))
    x, y = rng.uniform((room.x_min, room.y_min), (room.x_max, room.y_max))
    thing = LayoutThing(name, Box(float(x), float(y), 0.0, *map(float, size), yaw), mass=mass)
    beside = [other for other in things if other.box.z == 0]
    if beside and rng.random() < 0.7:
        _relate(thing, beside[int(rng.integers(len(beside)))], rng)
    return thing


def _relate(thing: LayoutThing, anchor: LayoutThing, rng: np.random.Generator) -> None:
    box, base = thing.box, anchor.box
    if rng.random() < 0.5:
        angle = math.radians(float(rng.choice((0, 90, 180, 270))) + float(rng.uniform(-15, 15)))
        box.x, box.y = base.x + math.cos(angle), base.y + math.sin(angle)
        box.x, box.y = slide_to_gap(box, base, 0.02, angle)
        thing.contact = True
    else:
        thing.contact = (False, None)[int(rng.integers(2))]
    bearing = math.atan2(box.y - base.y, box.x - base.x)
    thing.relationship = min(BEARING, key=lambda name: abs(wrap_angle(bearing - BEARING[name])))
    thing.anchor = anchor.name
    if rng.random() < 0.5:
        thing.direction = str(rng.choice(list(DIRECTION_TURN)))
        ideal = yaw_along(base.x - box.x, base.y - box.y) + DIRECTION_TURN[thing.direction]
        box.turn_to(ideal + math.radians(float(rng.uniform(-20, 20))))


def thrown_about(things: list[LayoutThing], seed: int) -> list[LayoutThing]:
    """Return the things displaced: their relations now hold only by luck."""
    rng = np.random.default_rng(seed + 999)
    moved = [thing.copy() for thing in things]
    for thing in moved:
        thing.box.x += float(rng.normal(0, 1.3))
        thing.box.y += float(rng.normal(0, 1.3))
        thing.box.z = float(rng.choice((0, 0, 0, rng.uniform(0, 1))))
        turn = rng.choice((0, 90, -90, 180, rng.uniform(-180, 180)))
        thing.box.turn_to(thing.box.yaw + math.radians(float(turn)))
    return moved


def main() -> None:
    """Print solved rooms, broken constraints before, passes and milliseconds."""
    first = int(sys.argv[1]) if len(sys.argv) > 1 else 5000
    solved, before, passes, spent = 0, [], [], []
    for seed in range(first, first + ROOMS):
        things, room = random_room(seed)
        thrown = thrown_about(things, seed)
        before.append(len(violations(thrown, room)))
        started = time.process_time()
        solution = solve(thrown, room, seed=seed)
        spent.append((time.process_time() - started) * 1e3)
        passes.append(solution.passes)
        solved += solution.solved
        if not solution.solved:
            print(f"seed {seed}: {len(things)} things, left {[tuple(v[:4]) for v in solution.residual]}")
    spent.sort()
    passes.sort()
    print(f"solved {solved}/{ROOMS}, violations before {statistics.mean(before):.1f} on average")
    print(f"passes median {passes[ROOMS // 2]}, p90 {passes[ROOMS * 9 // 10]}, max {passes[-1]}")
    print(f"ms median {spent[ROOMS // 2]:.1f}, p90 {spent[ROOMS * 9 // 10]:.1f}, max {spent[-1]:.1f}")


if __name__ == "__main__":
    main()

"""Two places cut together in a reading: units that go to and fro between two scenes become a scene for each run."""

from __future__ import annotations

from dataclasses import replace
from itertools import groupby

from storyblender.agents.director.reading import Reading, SceneReading, Unit


def in_story_order(reading: Reading) -> Reading:
    """Return the reading with its scenes in the order of its units, a scene that is cut away from in several parts.

    The parts keep the number that the script gives their scene, and share its set.

    Args:
        reading: Left as it is. A scene without units stays where it is only if no scene is cut up.
    """
    runs = [list(run) for _, run in groupby(reading.units, key=lambda unit: unit.scene)]
    order = [run[0].scene for run in runs]
    if order == sorted(set(order)):
        return reading
    scenes: list[SceneReading] = []
    units: list[Unit] = []
    first: dict[int, int] = {}
    for index, run in enumerate(runs):
        scene = reading.scenes[run[0].scene]
        end = runs[index + 1][0].start if index + 1 < len(runs) else max(scene.end, run[-1].end)
        earlier = first.get(scene.id)
        reference = scenes[earlier].id if earlier is not None else _moved(scene.reference, first)
        first.setdefault(scene.id, index)
        scenes.append(replace(scene, id=index + 1, start=run[0].start, end=end, reference=reference))
        units += [replace(unit, scene=index) for unit in run]
    part = {run[0].scene: index for index, run in reversed([*enumerate(runs)])}
    relations = [(part[scene], relation) for scene, relation in reading.relations if scene in part]
    return replace(reading, scenes=scenes, units=units, relations=relations)


def _moved(reference: int | None, first: dict[int, int]) -> int | None:
    """Return the new id of the earlier scene in the same place."""
    return first[reference] + 1 if reference in first else None

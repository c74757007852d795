"""Coverage of a story: what every scene's coverage needs to know of the whole reading."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from storyblender.agents.director.directions import NameFinder
from storyblender.agents.director.draft import ShotDraft
from storyblender.agents.director.fixtures import is_fixture
from storyblender.agents.director.reading import CameraNote, Reading, SceneReading, Unit
from storyblender.agents.director.scene_coverage import SceneCoverage


class Coverage:
    """Finds the shots that the scenes of a reading call for."""

    def __init__(self, reading: Reading) -> None:
        self.text = reading.screenplay.text
        self.names = NameFinder(reading)
        self.props = {thing.id for thing in reading.things if thing.kind == "prop"}
        self.things = {thing.id for thing in reading.things if not is_fixture(thing)}
        self._scenes = {scene.id: scene for scene in reading.scenes}

    def shots(self, scene: SceneReading, units: Sequence[Unit], notes: Mapping[int, CameraNote]) -> list[ShotDraft]:
        """Return every shot a scene calls for, in order.

        Args:
            scene: The scene.
            units: Its units.
            notes: Camera directions by index into ``units``.
        """
        return SceneCoverage(self, scene, units, notes).shots()

    def is_new(self, scene: SceneReading) -> bool:
        """Whether the audience has not seen the place of a scene at this time of day."""
        earlier = self._scenes.get(scene.reference or 0)
        return earlier is None or earlier.time != scene.time

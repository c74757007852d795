"""What the studio asks of the engine and what it answers: one request and one report per tool.

Paths are relative to the project folder the worker was started on; the worker refuses any that leave it.
A render job is a pure function of (pack, shot, lighting, settings), so it can run anywhere.
"""

from __future__ import annotations

from pathlib import PurePosixPath
from typing import Any, Literal

from pydantic import Field

from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Frozen, Vec3, content_hash, scene_name
from storyblender.memory.graph import ProjectFormat
from storyblender.memory.motion_by_hand import HandMotion
from storyblender.memory.outline import SceneOutline
from storyblender.memory.paint import Paint
from storyblender.memory.scene_context import Light, Lighting, SceneContext
from storyblender.memory.shot_context import Flaw, ShotContext
from storyblender.memory.thing_states import Condition

Look = Literal["board", "fast", "pencil", "render"]

GEOMETRY_VERSION = 9
"""Raised when builders change shape: old caches are then built anew."""
MODEL_VERSION = 4
"""Raised when users' models are read otherwise: only what was built from them is then built anew."""
DRAWING_VERSION = 5
"""Raised when the same request is drawn otherwise, as when the golden pictures change: old projects draw anew."""


ASSETS = "assets"
"""Folder of the built assets, each named by its digest."""
ADOPTED = "adopted"
"""Folder of the models that a person made in Blender."""
GIVEN = "models"
"""Folder of the models that a person gave for this project, from their disk."""
FETCHED = "build/models"
"""Folder of the model files that an asset source fetched from elsewhere."""


def asset_suffixes(asset: Asset) -> tuple[str, ...]:
    """Return how the names of the files with an asset's geometry end: of people also what their motion needs."""
    return (".blend", ".npz") if asset.asset_type == "character" else (".blend",)


class AssetJob(Frozen):
    """Build one canonical asset and measure it."""

    asset: Asset

    @property
    def digest(self) -> str:
        """Names the cached geometry: the same recipe gives the same digest, and the same geometry."""
        asset = self.asset
        canonical = asset.canonical
        return content_hash(
            GEOMETRY_VERSION,
            asset.asset_id if asset.asset_type == "character" else "",
            look.model_dump(mode="json") if (look := asset.decided_look) else None,
            asset.dimension.model_dump(mode="json") if asset.dimension else None,
            None if canonical is None else f"{canonical.source}:{canonical.key}",
            *([MODEL_VERSION] if canonical is not None and canonical.source == "file" else []),
            dict(canonical.params) if canonical else None,
            asset.name if canonical and canonical.source == "stand_in" else "",
        )


class AssetInState(Frozen):
    """An asset as it looks in some states, or something that is seen with it."""

    condition: Condition
    """All states that it is in."""
    asset: Asset
    added: bool = False
    """Whether it is seen together with the asset as it was at first, and not in its place."""
    location: Vec3 = (0.0, 0.0, 0.0)
    """Of what is added, in metres from the asset's own origin."""
    lying: bool = False
    """Whether it stays level under an asset that lies on its side."""


_NOT_PACKED = {
    "lighting",
    "locked",
    "offered_panorama",
    "light_decision",
    "set_decision",
    "layout_decision",
    "stale",
    "omitted",
    "shot_order",
}
"""Fields of a scene that its geometry and motion do not depend on: what was decided is in set and layout by then."""


class SceneJob(Frozen):
    """Pack one scene: set, objects, people and the motion of every shot; no cameras, no face lights."""

    scene: SceneContext
    shots: tuple[ShotContext, ...]
    assets: tuple[Asset, ...]
    fps: int = 24
    in_states: tuple[AssetInState, ...] = ()
    """Built things of the scene as they look in the states that its shots bring them to."""
    paints: tuple[Paint, ...] = ()
    """What a person decided about materials that it may show."""
    by_hand: tuple[HandMotion, ...] = ()
    """What a person animated by hand in it."""

    @property
    def digest(self) -> str:
        """Names the pack: everything that the scene's geometry and motion depend on."""
        scene = self.scene.model_dump(mode="json", exclude=_NOT_PACKED)
        scene["setup"] = None
        shots = [
            shot.model_dump(
                mode="json", include={"shot_id", "blocking", "cues", "prop_states", "duration", "asset_modifications"}
            )
            for shot in self.shots
        ]
        geometry = [asset.canonical.digest if asset.canonical else asset.asset_id for asset in self.assets]
        geometry += [
            f"{' + '.join(each.condition.labels)}:{each.asset.canonical.digest}:{each.location}"
            for each in self.in_states
            if each.asset.canonical
        ]
        found: dict[str, object] = {name: [*each.labels] for name, each in self.scene.setup.found.items()}
        further: list[dict[str, object] | list[object]] = [found] if found else []
        if self.paints:
            further.append([paint.model_dump(mode="json") for paint in self.paints])
        if self.by_hand:
            further.append([[each.shot_id, each.asset_id, each.motion.digest] for each in self.by_hand])
        return content_hash(GEOMETRY_VERSION, scene, list(shots), list(geometry), self.fps, *further)

    @property
    def out(self) -> str:
        """Path of the pack."""
        return f"build/scenes/{scene_name(self.scene.scene_id)}-{self.digest}.blend"

    @property
    def record(self) -> str:
        """Path of the pack's reference, written when the pack is whole."""
        return f"{self.out.removesuffix('.blend')}.json"


class PlayedCue(Frozen):
    """Actual timing of a cue: characters wait, approach and turn before they act."""

    shot_id: int
    asset_id: str
    clip: str
    start: int
    """Planned start frame of the cue."""
    began: int
    over: int
    """Frames from the shot's start."""


class PackRef(Frozen):
    """A packed scene."""

    scene_id: int
    path: str
    starts: tuple[tuple[int, int], ...]
    """Shot id and its first frame on the scene's timeline."""
    problems: tuple[Flaw, ...] = ()
    """What could not be staged as asked."""
    timing: tuple[PlayedCue, ...] = ()
    covering: tuple[tuple[int, int], ...] = Field(default=(), exclude_if=lambda value: not value)
    """The same as ``starts``, of shots that a person split off or added; the pack itself does not depend on them."""

    def played(self, shot_id: int) -> tuple[PlayedCue, ...]:
        """Return the actual timing of the cues of a shot."""
        return tuple(each for each in self.timing if each.shot_id == shot_id)

    @property
    def record(self) -> str:
        """Path of this reference on disk, written when the pack is whole."""
        return f"{self.path.removesuffix('.blend')}.json"

    def start_of(self, shot_id: int) -> int:
        """Return the first frame of a shot on the scene's timeline."""
        return dict((*self.starts, *self.covering))[shot_id]


def _drawn(shot: ShotContext, *fields: str) -> dict[str, Any]:
    """Return what a drawing depends on of a shot; what is new since older projects counts only where it is used."""
    values = shot.model_dump(mode="json", include=set(fields))
    if values["camera"] and not values["camera"]["focus"]:
        del values["camera"]["focus"]
    return values | ({"soft_focus": True} if shot.camera_instruction.soft_focus else {})


class FrameJob(Frozen):
    """Render the board frame of one shot."""

    pack: PackRef
    shot: ShotContext
    lighting: Lighting
    format: ProjectFormat
    look: Look
    frame: int
    """From the start of the shot."""
    out: str
    draft: bool = False
    """Whether it is drawn in half the time, for a preview: coarse lines, and only the strongest lamps cast shadows."""

    @property
    def digest(self) -> str:
        """Equal digests, equal pixels."""
        shot = _drawn(self.shot, "camera", "in_frame")
        lighting = self.lighting.model_dump(mode="json")
        start = self.pack.start_of(self.shot.shot_id)
        through = self.shot.camera_instruction.through
        parts = (DRAWING_VERSION, self.pack.path, start, shot, lighting, self.format, self.look, self.frame)
        return content_hash(*parts, *([through] if through else []), *(["draft"] if self.draft else []))


class FrameReport(Frozen):
    """A rendered board frame."""

    out: str
    lights: tuple[Light, ...] = ()
    face_luminance: float | None = None
    void: float = 0.0
    visible: tuple[str, ...] = ()
    """Characters that cover pixels of the frame."""


class MomentJob(Frozen):
    """Write what a scene looks like at one moment as glTF, for a viewer."""

    pack: PackRef
    frame: int
    """On the scene's timeline."""

    @property
    def out(self) -> str:
        """The file, named by all that it depends on."""
        return f"build/moments/{PurePosixPath(self.pack.path).stem}-{self.frame}.glb"


class MotionJob(Frozen):
    """Render the moving frames of one shot for the animatic."""

    pack: PackRef
    shot: ShotContext
    lighting: Lighting
    format: ProjectFormat
    width: int
    step: int
    """2 renders on twos."""
    folder: str

    @property
    def digest(self) -> str:
        """Equal digests, equal frames."""
        shot = _drawn(self.shot, "camera", "lights", "duration")
        lighting = self.lighting.model_dump(mode="json")
        start = self.pack.start_of(self.shot.shot_id)
        through = self.shot.camera_instruction.through
        parts = (DRAWING_VERSION, self.pack.path, start, shot, lighting, self.format, self.width, self.step)
        return content_hash(*parts, *([through] if through else []))


Cut = tuple[tuple[int, int], ...]
"""Scene id and shot id of each shot of a film."""


class StoryJob(Frozen):
    """Compile a .blend from packed scenes: the whole story, or one sequence of it."""

    format: ProjectFormat
    outline: tuple[SceneOutline, ...]
    assets: tuple[Asset, ...]
    scenes: tuple[SceneContext, ...]
    shots: tuple[ShotContext, ...]
    packs: tuple[PackRef, ...]
    cut: Cut = Field(default=(), exclude_if=lambda value: not value)
    """The shots of the film in its order; empty where that is all of them in the order of the script."""
    paints: tuple[Paint, ...] = Field(default=(), exclude_if=lambda value: not value)
    """What a person decided about materials."""
    beside: Cut = Field(default=(), exclude_if=lambda value: not value)
    """Shots that are other cameras on the time of another shot: they have no marker on the timeline."""
    changed: tuple[int, ...] | None = None
    """Scenes to put in anew; the others stay in the file as they are. None compiles it whole."""
    out: str
    version: str = ""
    """Of the project; the file carries it, so that edits made in the file are edits of that version."""
    former: tuple[int, int] | None = None
    """The file that this one replaces: time of its last change in ns, and bytes. Saved since, it is not replaced."""


class SequenceFile(Frozen):
    """A .blend that holds some of the story's scenes."""

    path: str
    scene_ids: tuple[int, ...]


class CutJob(Frozen):
    """Compile the .blend of a long story: its scenes linked from the files of the sequences, its cut and its assets."""

    format: ProjectFormat
    assets: tuple[Asset, ...]
    shots: tuple[ShotContext, ...]
    packs: tuple[PackRef, ...]
    cut: Cut = Field(default=(), exclude_if=lambda value: not value)
    """As of a story."""
    paints: tuple[Paint, ...] = Field(default=(), exclude_if=lambda value: not value)
    """As of a story."""
    sequences: tuple[SequenceFile, ...]
    """In order; they need not be there yet."""
    out: str
    version: str = ""
    """As of a story."""
    former: tuple[int, int] | None = None
    """The file that this one replaces: time of its last change in ns, and bytes. Saved since, it is not replaced."""


class ExportJob(Frozen):
    """Write one scene in an exchange format."""

    story: str
    """The .blend that holds the scene."""
    scene_id: int
    format: Literal["glb", "usd"]
    out: str

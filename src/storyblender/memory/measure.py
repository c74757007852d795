"""What the engine measures and hands back: shapes of assets, ID-mask views of a camera. Plain numbers."""

from __future__ import annotations

from storyblender.memory.asset_sheet import Anchor, Credit
from storyblender.memory.base import Frozen, Identifier, Vec2, Vec3
from storyblender.memory.shot_context import CameraPose
from storyblender.memory.vocabulary import AssetType


class AssetMeasure(Frozen):
    """The built asset as Blender sees it."""

    asset_id: str
    digest: str
    geometry_hash: str
    dimensions: Vec3
    anchors: tuple[Anchor, ...] = ()
    """Declared by the builder, plus every ``top`` found by ray-casting the mesh."""
    faces: int = 0
    asset_type: AssetType = "object"
    """A character takes the floor of a standing person, not of its rest pose."""
    notes: tuple[str, ...] = ()
    """Sentences for the user: what a model from a file was changed by, and what of it was left out."""
    credit: Credit = Credit()
    """Of a model from a file."""


class AssetRecord(Frozen):
    """The record beside a built asset; it is written last."""

    measure: AssetMeasure
    files: dict[str, str]
    """Digest by suffix of the files with its geometry."""


class AssetViews(Frozen):
    """What an object looks like."""

    digest: str
    """Of what it was drawn from."""
    dimensions: Vec3
    """Width, depth and height in metres, front -Y."""
    pictures: dict[str, bytes]
    """PNG by ``ModelSide``, and ``portrait``."""


class SubjectView(Frozen):
    """How one node appears in an ID-mask preview. Screen coordinates 0..1, origin top left, x right, y down."""

    node_id: str
    visible_fraction: float
    """Pixels of it that are seen / pixels it would have alone and uncropped."""
    in_frame_fraction: float
    """Share of its projection inside the frame, ignoring occluders."""
    box: tuple[float, float, float, float] | None = None
    """Left, top, right, bottom of its visible pixels."""
    pixels: float = 0.0
    """Share of the frame it covers."""
    face: Vec2 | None = None
    """Projected face centre (people)."""
    face_visible: float = 0.0
    """Share of the head's projected points that are not hidden."""
    head_height: float = 0.0
    """Crown to chin / frame height."""
    face_angle: float = 0.0
    """Degrees between where the face looks and the direction to the camera; 0 is full face."""
    head_top: float | None = None
    """Screen y of the crown."""


class CameraView(Frozen):
    """What one camera pose sees."""

    subjects: tuple[SubjectView, ...]
    void: float
    """Share of pixels that show neither set nor sky card nor intended sky."""
    sky: float = 0.0
    foreground: float = 0.0
    """Share of pixels nearer than half the focus distance that belong to no focus node."""
    inside: tuple[str, ...] = ()
    """node_ids of solids that contain the camera or are closer than 0.25 m."""
    below_floor: bool = False


class ViewRequest(Frozen):
    """One look through the viewfinder at one moment of one shot."""

    scene_id: int
    shot_id: int
    frame: int
    """From the start of the shot."""
    pose: CameraPose
    sensor_width: float = 36.0
    hidden_node_ids: tuple[Identifier, ...] = ()
    focus_ids: tuple[str, ...] = ()
    """node_ids the shot is about."""
    other_ids: tuple[str, ...] = ()
    """node_ids that are measured as well but are not the subject of the shot."""


class Collision(Frozen):
    """A person who intersects an object or another person."""

    shot: str
    frame: int
    """From the start of the shot."""
    asset_id: str
    node_id: str
    depth: float
    """Metres of the deepest point of the skin."""

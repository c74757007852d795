"""Everything a render changes in the file, changed inside ``with`` and put back after: renders leave no trace."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor, Future
from contextlib import ExitStack, contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, TypeVar

import bpy
import numpy as np
from mathutils import Matrix
from numpy.typing import NDArray

from storyblender.blender.hiding import out_of_picture
from storyblender.blender.render.exr import Channels, read_channels
from storyblender.blender.sections import is_hidden_by
from storyblender.look.gbuffer import View
from storyblender.look.optics import Lens
from storyblender.look.raster import Window
from storyblender.look.surface import Surface

Result = TypeVar("Result")
_STILL = {
    "pixel_aspect_x": 1.0,
    "pixel_aspect_y": 1.0,
    "resolution_percentage": 100,
    "use_border": False,
    "use_compositing": False,
    "use_sequencer": False,
    "use_multiview": False,
    "use_motion_blur": False,
    "use_freestyle": False,
    "use_stamp": False,
    "dither_intensity": 0.0,
    "use_file_extension": False,
    "use_overwrite": True,
}
_EXR = {"file_format": "OPEN_EXR_MULTILAYER", "color_depth": "16", "exr_codec": "NONE"}
"""Colours as 16 bit floats; depth is always 32 bit."""
_SCRATCH = "storyblender_"
"""How the folders begin in which pictures lie until they are read."""


@contextmanager
def changed(owner: Any, values: Mapping[str, Any]) -> Iterator[None]:
    """Set attributes of a Blender struct and set them back, in the same order.

    The order matters where one enumeration decides what another may hold: file format before colour depth.

    Args:
        owner: The struct.
        values: Attribute to value.
    """
    before = {name: _copied(getattr(owner, name)) for name in values}
    try:
        for name, value in values.items():
            setattr(owner, name, value)
        yield
    finally:
        for name, value in before.items():
            if value != "":  # an enumeration without a valid item reads as the empty string
                setattr(owner, name, value)


def _copied(value: Any) -> Any:
    """Vectors and colours are read as views on Blender's memory; keep their values instead."""
    return tuple(value) if hasattr(value, "__len__") and not isinstance(value, str) else value


class RenderSession:
    """One scene made the context's scene, at one frame, for its renders. A context manager.

    Args:
        scene: What to render.
        camera: A camera object of the scene.
        frame: Timeline frame; None stays where the scene is.
        hidden_node_ids: Nodes left out of every picture (wild walls).
        smoke: Whether smoke is drawn as a surface, to measure where it is; else it is left to the air.
    """

    def __init__(
        self,
        scene: bpy.types.Scene,
        camera: bpy.types.Object,
        frame: int | None = None,
        hidden_node_ids: Sequence[str] = (),
        *,
        smoke: bool = False,
    ) -> None:
        self.scene = scene
        self.camera = camera
        self._frame = frame
        self._hidden = frozenset(hidden_node_ids)
        self._smoke = smoke
        self.hidden_objects: list[bpy.types.Object] = []
        self.smoke_objects: list[bpy.types.Object] = []
        """Smoke that is seen in this frame, and left to the air."""
        self._focused = bool(camera.data.dof.use_dof)
        self._stack = ExitStack()

    def __enter__(self) -> RenderSession:
        stack = self._stack.__enter__()
        try:
            stack.enter_context(changed(bpy.context.window, {"scene": self.scene}))
            stack.enter_context(changed(self.scene, {"camera": self.camera}))
            # Passes are sharp: what is out of focus is blurred in the picture (look.lens_blur).
            stack.enter_context(changed(self.camera.data.dof, {"use_dof": False}))
            start = self.scene.frame_current
            stack.callback(lambda: self.go_to(start))
            if self._frame is not None:
                self.go_to(self._frame)
            for obj in self.scene.objects:
                if obj.type not in DRAWN or obj.hide_render:
                    continue
                if is_hidden_by(obj, self._hidden):
                    self.hidden_objects.append(obj)
                elif obj.get("surface") == int(Surface.SMOKE) and not self._smoke:
                    self.hidden_objects.append(obj)
                    self.smoke_objects.append(obj)
            stack.enter_context(out_of_picture(self.hidden_objects))
            self.scene.view_layers[0].update()
        except BaseException:
            stack.close()
            raise
        return self

    def __exit__(self, *error: object) -> None:
        self._stack.close()

    def go_to(self, frame: int) -> None:
        """Move the timeline; it goes back to where it was when the session ends."""
        if frame != self.scene.frame_current:
            self.scene.frame_set(frame)

    def visible_objects(self) -> list[bpy.types.Object]:
        """Return what renders, in the scene's order."""
        return [obj for obj in self.scene.objects if obj.type in DRAWN and not obj.hide_render]

    def view(self, width: int, height: int, camera: bpy.types.Object | None = None) -> View:
        """Return the pinhole of a camera at the current frame.

        Args:
            width: Of the picture, pixels.
            height: Of the picture, pixels.
            camera: The session's, if None.
        """
        depsgraph = self.scene.view_layers[0].depsgraph
        camera = camera or self.camera
        projection = np.array(camera.calc_matrix_camera(depsgraph, x=width, y=height))
        world = np.array(camera.evaluated_get(depsgraph).matrix_world.normalized())
        return View(
            eye=world[:3, 3].copy(),
            axes=world[:3, :3].copy(),
            width=width,
            height=height,
            half_width=1 / projection[0, 0],
            half_height=1 / projection[1, 1],
            shift=(float(projection[0, 2]), float(projection[1, 2])),
        )

    def lens(self) -> Lens | None:
        """Return the camera's lens as it is set at the frame; None where everything is sharp."""
        data = self.camera.evaluated_get(self.scene.view_layers[0].depsgraph).data
        if not self._focused:
            return None
        return Lens(data.lens, data.dof.aperture_fstop, data.dof.focus_distance, data.sensor_width)

    def exr(self, width: int, height: int, *, depth: bool = False) -> Channels:
        """Render with the engine that is set and return the channels of the multilayer EXR.

        Args:
            width: Pixels.
            height: Pixels.
            depth: Also write the depth pass.
        """
        with TemporaryDirectory(prefix=_SCRATCH) as folder:
            return read_channels(self._rendered(folder, width, height, depth))

    def exr_read_aside(
        self, aside: Executor, read: Callable[[Channels], Result], width: int, height: int, *, depth: bool = False
    ) -> Future[Result]:
        """Render as ``exr`` does and let another thread read the picture, so that Blender can go on to the next.

        Args:
            aside: The other thread.
            read: What it makes of the channels; no Blender in there.
            width: Pixels.
            height: Pixels.
            depth: Also write the depth pass.
        """
        folder = TemporaryDirectory(prefix=_SCRATCH)
        path = self._rendered(folder.name, width, height, depth)

        def read_it() -> Result:
            with folder:
                return read(read_channels(path))

        return aside.submit(read_it)

    def _rendered(self, folder: str, width: int, height: int, depth: bool) -> Path:
        render = self.scene.render
        path = Path(folder) / "picture.exr"
        size = {"resolution_x": width, "resolution_y": height, "filepath": str(path)}
        with (
            changed(render, size | _STILL),
            changed(render.image_settings, _EXR),
            changed(self.scene.view_layers[0], {"use_pass_z": depth}),
        ):
            bpy.ops.render.render(write_still=True)
        return path

    def exr_frames(
        self, frames: Sequence[int], width: int, height: int, *, depth: bool = False, window: Window | None = None
    ) -> list[Channels]:
        """Render frames of the timeline with the engine that is set; what is evenly spaced goes in one call.

        Args:
            frames: Forwards.
            width: Pixels of the whole picture.
            height: Pixels of the whole picture.
            depth: Also write the depth pass.
            window: The part to render and return; None is all.
        """
        render = self.scene.render
        border = _border(window, width, height) if window else {}
        with (
            TemporaryDirectory(prefix=_SCRATCH) as folder,
            changed(render, {"resolution_x": width, "resolution_y": height, "filepath": f"{folder}/#####.exr"}),
            changed(render, _STILL | border),
            changed(render.image_settings, _EXR),
            changed(self.scene.view_layers[0], {"use_pass_z": depth}),
            changed(self.scene, {"frame_start": 0, "frame_end": 0, "frame_step": 1}),
        ):
            for run in evenly(frames):
                self.scene.frame_start, self.scene.frame_end, self.scene.frame_step = run[0], run[-1], run.step
                bpy.ops.render.render(animation=True)
            return [read_channels(Path(folder) / f"{number:05d}.exr") for number in frames]


def evenly(numbers: Sequence[int]) -> list[range]:
    """Return ascending numbers as the fewest runs of even steps, each as long as it goes."""
    runs: list[range] = []
    for number in numbers:
        run = runs[-1] if runs else None
        if run is not None and (len(run) == 1 or number - run[-1] == run.step):
            step = number - run[-1]
            runs[-1] = range(run[0], number + 1, step)
        else:
            runs.append(range(number, number + 1))
    return runs


def _border(window: Window, width: int, height: int) -> dict[str, Any]:
    """Return the render border of a window; Blender rounds its edges down to pixels, so they lie a little inside."""
    return {
        "use_border": True,
        "use_crop_to_border": True,
        "border_min_x": (window.left + 0.2) / width,
        "border_max_x": (window.right + 0.2) / width,
        "border_min_y": (height - window.bottom + 0.2) / height,
        "border_max_y": (height - window.top + 0.2) / height,
    }


@contextmanager
def temporary_camera(scene: bpy.types.Scene, matrix: NDArray, **settings: Any) -> Iterator[bpy.types.Object]:
    """Add a camera, make it the scene's camera, and take it away after.

    Args:
        scene: The scene.
        matrix: (4, 4) world matrix, metres.
        **settings: Attributes of the camera data-block, for example ``clip_end``.
    """
    data = bpy.data.cameras.new("temporary")
    for name, value in settings.items():
        setattr(data, name, value)
    obj = bpy.data.objects.new("temporary", data)
    scene.collection.objects.link(obj)
    obj.matrix_world = Matrix(matrix.tolist())
    try:
        with changed(scene, {"camera": obj}):
            scene.view_layers[0].update()
            yield obj
    finally:
        bpy.data.cameras.remove(data)


DRAWN = frozenset({"MESH", "CURVE", "SURFACE", "FONT", "META"})
"""Types of objects that show in a picture."""

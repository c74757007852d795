"""Packed scenes of a bare stage, and the job that compiles them: what a story's file is tested with."""

from __future__ import annotations

from pathlib import Path

import bpy
import camera_stage

from storyblender.blender.hiding import key_hidden
from storyblender.memory.base import scene_name
from storyblender.memory.graph import ProjectFormat
from storyblender.memory.jobs import PackRef, StoryJob
from storyblender.memory.outline import SceneOutline
from storyblender.memory.scene_context import Light, Lighting, SceneContext, SceneSetup, Sky
from storyblender.memory.shot_context import CameraInstruction, CameraPose, CameraState, ShotContext

LENGTH = 10
"""Frames of every shot."""
SKY = Sky(zenith=(0.1,) * 3, horizon=(0.2,) * 3, ground=(0.05,) * 3)


def lamp(name: str, role: str = "key") -> Light:
    """Return a spot over the stage."""
    return Light(name=name, kind="SPOT", role=role, location=(0, -1, 2.5), target=(0, 0, 1), power=50)


def shot(scene_id: int, shot_id: int, *, hidden: tuple[str, ...] = (), lights: tuple[Light, ...] = ()) -> ShotContext:
    """Return a shot from the front."""
    pose = CameraPose(pivot=(0, 0, 1.5), rotation=(0.7071, 0.7071, 0, 0), distance=2.5, lens=35)
    return ShotContext(
        scene_id=scene_id,
        shot_id=shot_id,
        duration=LENGTH,
        camera_instruction=CameraInstruction(size="MS"),
        camera=CameraState(poses=(pose,), hidden_node_ids=hidden),
        lights=lights,
    )


def pack(root: Path, scene_id: int, shots: int, enters: dict[str, int] | None = None) -> PackRef:
    """Write a scene's pack; in the second shot the table turns like a door.

    Args:
        root: The project folder.
        scene_id: Of the scene.
        shots: How many.
        enters: Who is there, and the number of the shot with which they come on; they stay.
    """
    bpy.ops.wm.read_factory_settings(use_empty=True)
    enters = enters or {"ada": 1}
    scene = camera_stage.build({name: (index, 0, 0) for index, name in enumerate(enters)})
    name = scene.name = scene_name(scene_id)
    starts = tuple((number, 1 + LENGTH * (number - 1)) for number in range(1, shots + 1))
    scene.frame_end = LENGTH * shots
    door = scene.objects["table"]
    for frame, turn in ((LENGTH + 2, 0.0), (LENGTH + 5, 1.5)):
        door.rotation_euler[2] = turn
        door.keyframe_insert("rotation_euler", frame=frame)
    for obj in scene.objects:
        obj.name = f"{name}.{obj.name}"
        entrance = enters.get(str(obj.get("node_id")))
        if entrance is not None:
            key_hidden(obj, [(start, number >= entrance) for number, start in starts])
    for other in [other for other in bpy.data.scenes if other != scene]:
        bpy.data.scenes.remove(other)
    path = f"build/scenes/{name}.blend"
    (root / path).parent.mkdir(parents=True, exist_ok=True)
    bpy.ops.wm.save_as_mainfile(filepath=str(root / path), compress=True)
    return PackRef(scene_id=scene_id, path=path, starts=starts)


def story(packs: list[PackRef], shots: list[ShotContext], plan: Lighting | None = None) -> StoryJob:
    """Return the job that compiles the packs to ``story.blend``."""
    plan = plan or Lighting(sky=SKY)
    scenes = [SceneContext(scene_id=pack.scene_id, setup=SceneSetup(), lighting=plan) for pack in packs]
    outline = [SceneOutline(scene_id=pack.scene_id, scene_description="", heading="INT. STAGE - DAY") for pack in packs]
    return StoryJob(
        format=ProjectFormat(width=320),
        outline=tuple(outline),
        assets=(),
        scenes=tuple(scenes),
        shots=tuple(shots),
        packs=tuple(packs),
        out="story.blend",
    )

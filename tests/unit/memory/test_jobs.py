"""What names a picture: everything it depends on, and the way in which it is drawn."""

import hashlib
from pathlib import Path

import pytest

from storyblender.memory import jobs
from storyblender.memory.graph import ProjectFormat
from storyblender.memory.jobs import DRAWING_VERSION, FrameJob, MotionJob, PackRef
from storyblender.memory.scene_context import Lighting, Sky
from storyblender.memory.shot_context import CameraInstruction, ShotContext

GOLDEN = Path(__file__).parents[2] / "golden"
SHARED = {
    "pack": PackRef(scene_id=1, path="build/scenes/SC010-0.blend", starts=((1, 1),)),
    "shot": ShotContext(scene_id=1, shot_id=1, duration=24, camera_instruction=CameraInstruction(size="MS")),
    "lighting": Lighting(sky=Sky(zenith=(0.1, 0.2, 0.4), horizon=(0.4, 0.4, 0.4), ground=(0.1, 0.1, 0.1))),
    "format": ProjectFormat(),
}
FRAME = FrameJob(**SHARED, look="board", frame=3, out="")
MOTION = MotionJob(**SHARED, width=480, step=1, folder="")


@pytest.mark.parametrize("job", [FRAME, MOTION])
def test_another_way_of_drawing_is_another_picture(job, monkeypatch):
    before = job.digest
    assert job.digest == before
    monkeypatch.setattr(jobs, "DRAWING_VERSION", DRAWING_VERSION + 1)
    assert job.digest != before


def test_a_frame_is_named_by_its_look_and_moment_not_by_its_place_on_disk():
    assert FRAME.model_copy(update={"look": "fast"}).digest != FRAME.digest
    assert FRAME.model_copy(update={"frame": 4}).digest != FRAME.digest
    assert FRAME.model_copy(update={"out": "elsewhere.png"}).digest == FRAME.digest


@pytest.mark.parametrize("job", [FRAME, MOTION])
def test_what_a_point_of_view_looks_through_is_another_picture(job):
    instruction = CameraInstruction(size="MS", kind="pov", through="keyhole")
    assert job.model_copy(update={"shot": job.shot.model_copy(update={"camera_instruction": instruction})}).digest != (
        job.digest
    )


def test_new_golden_pictures_raise_the_drawing_version():
    """``golden/drawn_by.txt`` says which version drew them: raise it in ``memory/jobs.py``, then write both here."""
    version, digest = (GOLDEN / "drawn_by.txt").read_text().split()
    pictures = hashlib.sha256(b"".join(path.read_bytes() for path in sorted(GOLDEN.glob("*.png"))))
    assert (int(version), digest) == (DRAWING_VERSION, pictures.hexdigest()[:16])

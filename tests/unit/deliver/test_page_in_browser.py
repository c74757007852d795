"""The page in a real browser: pictures enlarge and are paged by keys, a shot plays the film from where it begins."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from html import unescape
from pathlib import Path

import av
import pytest
from PIL import Image

from storyblender.deliver.page import write_page
from storyblender.memory.graph import ContinuityMemoryGraph, ProjectFormat
from storyblender.memory.outline import SceneOutline, ScriptLine, ShotOutline, SourceSpan
from storyblender.memory.scene_context import SceneContext, SceneSetup
from storyblender.memory.shot_context import CameraInstruction, ShotContext

BROWSER = shutil.which("chromium") or shutil.which("google-chrome")

pytestmark = [pytest.mark.slow, pytest.mark.skipif(BROWSER is None, reason="needs Chromium")]

ASK = """<script>
const told = {}, key = (name) => large.dispatchEvent(new KeyboardEvent("keydown", { key: name }));
const slate = () => large.querySelector(".slate").textContent;
document.querySelector(".picture").click();
told.opened = [large.open, slate()];
key("ArrowRight");
told.next = slate();
key("ArrowRight");
told.last = slate();
large.click();
told.closed = !large.open;
film.play = () => { told.played = film.currentTime; };
document.querySelectorAll("button.play")[1].click();
told.wide = document.documentElement.scrollWidth <= innerWidth;
told.cues = [...film.textTracks[0].cues].map((cue) => cue.getCueAsHTML().textContent);
told.dead = [...document.querySelectorAll('a[href^="#"]')].filter((a) => !document.querySelector(a.hash)).length;
document.body.append(Object.assign(document.createElement("pre"), { id: "told", textContent: JSON.stringify(told) }));
</script></body>"""


def project(folder: Path) -> Path:
    """Write a page of two scenes with a shot each, frames and a film of four seconds."""
    line = ScriptLine(kind="dialogue", text="Go <b>now</b> & run.", span=SourceSpan(start=0, end=8), speaker_name="Ada")
    scenes = tuple(
        SceneOutline(
            scene_id=number,
            scene_description="",
            heading=f"INT. ROOM {number} WITH A VERY LONG NAME THAT GOES ON AND ON - NIGHT",
            shots=(ShotOutline(shot_id=1, lines=(line,)),),
        )
        for number in (1, 2)
    )
    graph = ContinuityMemoryGraph(
        format=ProjectFormat(fps=12),
        outline=scenes,
        scenes=tuple(SceneContext(scene_id=number, setup=SceneSetup()) for number in (1, 2)),
        shots=tuple(
            ShotContext(scene_id=number, shot_id=1, duration=24, camera_instruction=CameraInstruction())
            for number in (1, 2)
        ),
    )
    frames = {name: folder / f"{name}.png" for name in ("SC010_SH010", "SC020_SH010")}
    for path in frames.values():
        Image.new("RGB", (64, 36), (90, 60, 60)).save(path)
    with av.open(str(folder / "animatic.mp4"), "w") as film:
        stream = film.add_stream("libx264", 12)
        stream.width, stream.height = 64, 36
        for _ in range(48):
            film.mux(stream.encode(av.VideoFrame.from_image(Image.new("RGB", (64, 36)))))
        film.mux(stream.encode())
    write_page(graph, frames, folder / "index.html", folder)
    return folder / "index.html"


@pytest.mark.parametrize("width", [390, 1280])
def test_the_page_works_in_a_browser(tmp_path: Path, width: int) -> None:
    page = project(tmp_path)
    page.write_text(page.read_text("utf-8").replace("</body>", ASK), "utf-8")
    command = [
        str(BROWSER), "--headless=new", "--no-sandbox", "--disable-gpu", f"--window-size={width},800",
        f"--user-data-dir={tmp_path / 'profile'}", "--virtual-time-budget=2000", "--dump-dom", page.as_uri(),
    ]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    found = re.search(r'<pre id="told">(.*?)</pre>', done.stdout, re.DOTALL)
    assert found, done.stderr[-2000:]
    told = json.loads(unescape(found[1]))
    assert told["opened"] == [True, "SC010_SH0102.0 s"]
    assert told["next"] == told["last"] == "SC020_SH0102.0 s", "the last picture has none after it"
    assert told["closed"] and told["wide"] and told["dead"] == 0
    assert told["played"] == pytest.approx(2.0, abs=0.05)
    assert told["cues"][0] == "Ada: Go <b>now</b> & run."

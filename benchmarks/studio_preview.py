"""How soon a preview follows an edit in the studio: seconds from the edit to the picture of the shot looked at.

The project is copied and opened as the page opens it; shots are looked at and edited, family by family, with a rest
between the edits in which the studio draws what it draws then. With ``--against`` the same edits are made by turns with
the code of another source folder, on a copy of its own; who is not measured is stopped meanwhile.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import math
import os
import random
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

FAMILIES = ("camera", "marks", "layout", "light")
PATIENCE = 120.0
"""Seconds after which a preview counts as never."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("project", type=Path, help="a finished project; it stays as it is")
    parser.add_argument("--edits", type=int, default=8, help="of each family")
    parser.add_argument("--rest", type=float, default=3.0, help="seconds between a preview and the next edit")
    parser.add_argument("--against", type=Path, help="src folder of other code to take turns with")
    parser.add_argument("--child", action="store_true", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.child:
        asyncio.run(obey(arguments.project))
        os._exit(0)  # Blender's threads need no goodbye
    sources: dict[str, Path | None] = {"this": None}
    if arguments.against is not None:
        sources["other"] = arguments.against
    with tempfile.TemporaryDirectory() as folder:
        studios = {name: Child(arguments.project, Path(folder) / name, source) for name, source in sources.items()}
        try:
            measured = take_turns(studios, arguments.edits, arguments.rest)
        finally:
            for studio in studios.values():
                studio.end()
    report(measured)


class Child:
    """The studio in a process of its own, on a copy of the project.

    Args:
        project: To copy.
        room: Where to.
        source: Folder of the code; None for that of this process.
    """

    def __init__(self, project: Path, room: Path, source: Path | None) -> None:
        shutil.copytree(project, room / project.name)
        paths = [str(source)] if source is not None else []
        paths += [str(Path(__file__).parent.parent), os.environ.get("PYTHONPATH", "")]
        command = [sys.executable, __file__, "--child", str(room / project.name)]
        environment = os.environ | {"PYTHONPATH": os.pathsep.join(paths)}
        self._process = subprocess.Popen(
            command, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, start_new_session=True
        )
        self.shots: list[str] = self._heard()["shots"]

    def ask(self, family: str, shot: str, number: int) -> dict[str, Any]:
        """Look at a shot, make an edit of a family, and return how long its preview took."""
        self._say({"family": family, "shot": shot, "number": number})
        return self._heard()

    def stop(self) -> None:
        """Stop it and its workers where they are."""
        os.killpg(self._process.pid, signal.SIGSTOP)

    def go_on(self) -> None:
        """Let it go on."""
        os.killpg(self._process.pid, signal.SIGCONT)

    def end(self) -> None:
        """End it and its workers."""
        os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()

    def _say(self, what: dict[str, Any]) -> None:
        assert self._process.stdin is not None, "a pipe"
        print(json.dumps(what), file=self._process.stdin, flush=True)

    def _heard(self) -> dict[str, Any]:
        assert self._process.stdout is not None, "a pipe"
        line = self._process.stdout.readline()
        if not line:
            raise SystemExit("the studio ended")
        return json.loads(line)


def take_turns(studios: dict[str, Child], edits: int, rest: float) -> dict[str, dict[str, list[dict[str, Any]]]]:
    """Return what was measured, by code and family; every edit is made by all codes, one after the other."""
    chance = random.Random(1)
    shots = next(iter(studios.values())).shots
    measured: dict[str, dict[str, list[dict[str, Any]]]] = {}
    for studio in studios.values():
        studio.stop()
    for number in range(edits):
        for family in FAMILIES:
            shot = chance.choice(shots)
            for name, studio in studios.items():
                studio.go_on()
                found = studio.ask(family, shot, number)
                time.sleep(rest)
                studio.stop()
                measured.setdefault(name, {}).setdefault(family, []).append(found)
                load = os.getloadavg()[0]
                parts = " ".join(f"{tool} {spent:.2f}" for tool, spent in found["parts"].items())
                print(f"{name:>6} {family:>7} {shot} {found['seconds']:6.2f} s  load {load:.1f}  {parts}", flush=True)
    return measured


def report(measured: dict[str, dict[str, list[dict[str, Any]]]]) -> None:
    """Print median and 95th percentile by family, and how codes compare."""
    print(f"\n{'code':>6} {'family':>7} {'edits':>6} {'median':>7} {'95 %':>7} {'longest':>8}")
    for name, families in measured.items():
        for family, found in families.items():
            seconds = sorted(each["seconds"] for each in found)
            high = seconds[min(len(seconds) - 1, math.ceil(0.95 * len(seconds)) - 1)]
            row = f"{name:>6} {family:>7} {len(seconds):>6} {statistics.median(seconds):>7.2f}"
            print(f"{row} {high:>7.2f} {seconds[-1]:>8.2f}")
    if "other" in measured:
        for family, found in measured["this"].items():
            pairs = zip(found, measured["other"][family], strict=True)
            ratio = statistics.median(mine["seconds"] / theirs["seconds"] for mine, theirs in pairs)
            print(f"{family:>7}: {ratio:.2f} of the other code's time, median of the pairs")


async def obey(project: Path) -> None:
    """Open a project as the page does and make the edits that are asked for on standard input."""
    from storyblender.web_studio.hub import Hub

    spent = watch_workers()
    hub = Hub(project.parent)
    news = hub.join()
    page = Page(hub, news)
    await asyncio.to_thread(hub.open, project.name)
    await page.settled()
    drawable = [name for name in page.shots() if page.family_edits("marks", name, 0)]
    say({"shots": drawable or page.shots()})
    while line := await asyncio.to_thread(sys.stdin.readline):
        asked = json.loads(line)
        await page.call("shot", shot=asked["shot"])
        await asyncio.sleep(2)  # a person looks at it first
        edits = page.family_edits(asked["family"], asked["shot"], asked["number"])
        spent.clear()
        start = time.perf_counter()
        seconds = await page.preview_after(edits, asked["shot"])
        parts = parts_of(spent, start, seconds)
        say({"seconds": seconds, "parts": parts})


def say(what: dict[str, Any]) -> None:
    """Answer the parent."""
    print(json.dumps(what), flush=True)


def parts_of(spent: list[tuple[str, float, float]], start: float, seconds: float) -> dict[str, float]:
    """Return seconds by tool of the workers until the preview was there, and those in which no worker was asked."""
    parts: dict[str, float] = {}
    end, busy = start + seconds, 0.0
    for tool, began, over in sorted(spent, key=lambda each: each[1]):
        over = min(over, end)
        if began < end:
            parts[tool] = parts.get(tool, 0.0) + over - began
    covered = start
    for _, began, over in sorted(spent, key=lambda each: each[1]):
        over = min(over, end)
        if over > covered:
            busy += over - max(began, covered)
            covered = over
    return {name: round(value, 3) for name, value in {**parts, "client": seconds - busy}.items()}


def watch_workers() -> list[tuple[str, float, float]]:
    """Return a list that grows with every call to a worker: tool, begin and end."""
    from storyblender.engine.worker import Worker

    spent: list[tuple[str, float, float]] = []
    call = Worker.call

    def timed(self: Worker, tool: str, *arguments: Any) -> Any:
        begin = time.perf_counter()
        try:
            return call(self, tool, *arguments)
        finally:
            spent.append((tool, begin, time.perf_counter()))

    Worker.call = timed  # type: ignore[method-assign]
    return spent


class Page:
    """What the page does, without a browser.

    Args:
        hub: The studio.
        news: Of this page.
    """

    def __init__(self, hub: Any, news: asyncio.Queue[Any]) -> None:
        self._hub, self._news, self._number = hub, news, 0

    @property
    def _graph(self) -> Any:
        return self._hub.place.session.graph

    async def call(self, call: str, **values: Any) -> Any:
        """Make a call over the wire's own types."""
        from storyblender.web_studio.messages import CALLS

        self._number += 1
        answer = await self._hub.answer(CALLS.validate_python({"id": self._number, "call": call, **values}))
        if not answer.ok:
            raise SystemExit(f"{call}: {answer.error}")
        return answer.value

    def shots(self) -> list[str]:
        """Return the names of the shots of the film."""
        from storyblender.memory.base import shot_name

        return [shot_name(shot.scene_id, shot.shot_id) for shot in self._graph.cut]

    async def settled(self) -> None:
        """Wait until every frame shows the story as it is."""
        while True:
            board = await self.call("board")
            if all(card.state == "fresh" for scene in board.scenes for card in scene.shots):
                return
            await asyncio.sleep(0.5)

    async def preview_after(self, edits: list[dict[str, Any]], shot: str) -> float:
        """Make edits and return the seconds until the shot's picture is new."""
        while not self._news.empty():
            self._news.get_nowait()
        start = time.perf_counter()
        revision = (await self.call("apply", edits=edits))["version"]
        while time.perf_counter() - start < PATIENCE:
            try:
                heard = await asyncio.wait_for(self._news.get(), 1.0)
            except TimeoutError:
                continue
            if heard.news == "frames" and shot in heard.shots:
                return time.perf_counter() - start
        raise SystemExit(f"no preview of {shot} within {PATIENCE:g} s after {revision}")

    def family_edits(self, family: str, shot: str, number: int) -> list[dict[str, Any]]:
        """Return an edit of a family that changes a shot; empty where it has nothing of the kind."""
        scene = shot.partition("_")[0]
        found = next(each for each in self._graph.cut if shot == name_of(each))
        match family:
            case "camera":
                azimuth = {"lens": (28, 35, 40, 50, 65)[number % 5]}
                return [{"kind": "camera", "shot": shot, "decision": azimuth}]
            case "marks":
                return next(self._marks(shot, found, number), [])
            case "layout":
                return next(self._places(scene, found, number), [])
            case _:
                brightness = (0.7, 1.3, 0.8, 1.2, 0.9)[number % 5]
                return [{"kind": "light", "scene": scene, "decision": {"brightness": brightness}}]

    def _marks(self, shot: str, found: Any, number: int) -> Iterator[list[dict[str, Any]]]:
        """Yield a step of 10 cm of a person who stands."""
        for blocking in found.blocking:
            if blocking.start.posture == "stand" and found.covers is None:
                x, y, _ = blocking.start.location
                place = {"location": (x + (0.1 if number % 2 else -0.1), y)}
                marks = {"start": place, "end": place}
                yield [{"kind": "blocking", "shot": shot, "person": blocking.start.asset_id, "marks": marks}]

    def _places(self, scene: str, found: Any, number: int) -> Iterator[list[dict[str, Any]]]:
        """Yield a quarter turn of a chair, or of another thing on the floor."""
        objects = self._graph.scene(found.scene_id).layout.objects
        people = {asset.asset_id for asset in self._graph.assets if asset.asset_type == "character"}
        floor = [item for item in objects if item.asset_id not in people and item.location[2] < 0.05]
        for item in sorted(floor, key=lambda item: "chair" not in item.node_id)[:1]:
            place = {"rotation": (item.rotation[2] + 15 * (1 + number % 3)) % 360}
            yield [{"kind": "place", "scene": scene, "thing": item.node_id, "place": place}]


def name_of(shot: Any) -> str:
    """Return the name of a shot."""
    from storyblender.memory.base import shot_name

    return shot_name(shot.scene_id, shot.shot_id)


if __name__ == "__main__":
    main()

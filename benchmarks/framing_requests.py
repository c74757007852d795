"""Forty framing requests to a finished Casablanca, sent by an MCP client that is not ours; each frame is judged twice.

Once by what can be measured of it (``framing_measures``), once by the Frame Critic, as the server reports it. Every
request starts from the storyboard as it was made: it is undone before the next. Half are words, half typed edits.
"""

from __future__ import annotations

import argparse
import asyncio
import base64
import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from benchmarks.framing_measures import Wanted, misses
from mcp import ClientSession, StdioServerParameters
from mcp.client.stdio import stdio_client

from storyblender.memory.base import shot_name

SCRIPT = Path(__file__).parent.parent / "examples" / "casablanca.fountain"
RICK, ILSA, SAM, UGARTE, LASZLO = "rick_blaine", "ilsa_lund", "sam", "ugarte", "victor_laszlo"
STRASSER, GUITARIST = "major_strasser", "guitarist"


@dataclass(frozen=True)
class Request:
    """A request: a shot, words or a decision, and what they mean."""

    shot: str
    asked: str | dict[str, Any]
    wanted: Wanted


@dataclass(frozen=True)
class Outcome:
    """What became of a request.

    Attributes:
        request: The request.
        refused: The sentence of the server, if it refused.
        missed: What of it cannot be measured in the frame.
        verdict: Of the Frame Critic.
        faults: What the Frame Critic says, without what it said of the frame before: no camera mends that.
        known: What it said of the frame before as well.
        picture: The frame as PNG.
    """

    request: Request
    refused: str = ""
    missed: tuple[str, ...] = ()
    verdict: str = ""
    faults: tuple[str, ...] = ()
    known: tuple[str, ...] = ()
    picture: bytes = b""

    @property
    def as_asked(self) -> bool:
        """Whether all that was asked can be measured in the frame."""
        return not self.refused and not self.missed

    @property
    def passes(self) -> bool:
        """Whether the Frame Critic passes the frame, but for what it said of the frame before as well."""
        return self.verdict == "pass" or (bool(self.verdict) and not self.faults)


def _on(kind: str, size: str, *focus: str, **more: Any) -> dict[str, Any]:
    return {"kind": kind, "size": size, "focus_on_ids": list(focus), **more}


REQUESTS: tuple[Request, ...] = (
    Request("SC010_SH010", "bird's-eye view", Wanted(angle="bird's-eye", people=(RICK,))),
    Request("SC010_SH010", "pan left, 24 mm", Wanted(move="pan left", lens=24)),
    Request("SC010_SH020", "low angle, 35 mm", Wanted(angle="low angle", lens=35, people=(UGARTE,))),
    Request("SC010_SH020", "wide shot of Ugarte, hold still", Wanted(size="WS", move="static", people=(UGARTE,))),
    Request("SC010_SH030", "closer", Wanted(steps=1, people=(UGARTE,))),
    Request("SC010_SH030", "over Rick's shoulder on Ugarte", Wanted(over=RICK, people=(UGARTE,))),
    Request("SC010_SH030", "over Ugarte's shoulder on Rick", Wanted(over=UGARTE, people=(RICK,))),
    Request("SC010_SH030", "close-up of Rick", Wanted(size="CU", people=(RICK,))),
    Request("SC010_SH040", "insert of the envelope", Wanted(things=("envelope",))),
    Request("SC020_SH010", "two-shot of Sam and Ilsa, eye level", Wanted(angle="eye-level", people=(SAM, ILSA))),
    Request("SC020_SH020", "over Sam's shoulder on Ilsa", Wanted(over=SAM, people=(ILSA,))),
    Request("SC020_SH020", "longer lens and slow push in", Wanted(lens=70, move="push in", people=(ILSA, SAM))),
    Request("SC020_SH030", "high angle", Wanted(angle="high angle", people=(SAM,))),
    Request("SC020_SH030", "medium shot of Rick, 50 mm", Wanted(size="MS", lens=50, people=(RICK,))),
    Request("SC020_SH040", "wider, hold still", Wanted(steps=-1, move="static", people=(ILSA,))),
    Request("SC020_SH040", "extreme close-up, 100 mm", Wanted(size="ECU", lens=100, people=(ILSA,))),
    Request("SC030_SH010", "medium close-up of Major Strasser, low angle",
            Wanted(size="MCU", angle="low angle", people=(STRASSER,))),
    Request("SC030_SH020", "two-shot of Laszlo and the Guitarist", Wanted(people=(LASZLO, GUITARIST))),
    Request("SC030_SH030", "eye level, 85 mm, f/2", Wanted(angle="eye-level", lens=85, f_number=2, people=(LASZLO,))),
    Request("SC040_SH020", "over Rick's shoulder on Ilsa, 50 mm", Wanted(over=RICK, lens=50, people=(ILSA,))),
    Request("SC040_SH020", "rack focus from Rick to Ilsa", Wanted(rack=(RICK, ILSA), people=(RICK, ILSA))),
    Request("SC040_SH030", "Ilsa's point of view on Rick", Wanted(pov=ILSA, people=(RICK,))),
    Request("SC050_SH020", "much closer, f/2", Wanted(steps=2, f_number=2, people=(RICK,))),
    Request("SC050_SH060", "full shot, eye level", Wanted(size="FS", angle="eye-level", people=(RICK,))),
    Request("SC010_SH020", _on("single", "MCU", UGARTE), Wanted(size="MCU", people=(UGARTE,))),
    Request("SC010_SH030", _on("two_shot", "MWS", RICK, UGARTE, angle="low angle"),
            Wanted(size="MWS", angle="low angle", people=(RICK, UGARTE))),
    Request("SC020_SH020", _on("ots", "MCU", SAM, over_id=ILSA), Wanted(size="MCU", over=ILSA, people=(SAM,))),
    Request("SC020_SH020", _on("insert", "CU", "piano"), Wanted(things=("piano",))),
    Request("SC030_SH020", _on("group", "WS", LASZLO, GUITARIST, STRASSER, angle="high angle"),
            Wanted(size="WS", angle="high angle", people=(LASZLO, GUITARIST, STRASSER))),
    Request("SC030_SH030", {"angle": "worm's-eye"}, Wanted(angle="worm's-eye", people=(LASZLO,))),
    Request("SC030_SH040", _on("single", "MS", STRASSER, angle="eye-level"),
            Wanted(size="MS", angle="eye-level", people=(STRASSER,))),
    Request("SC040_SH010", {"movement": "push in"}, Wanted(move="push in", people=(RICK, ILSA))),
    Request("SC040_SH020", _on("reaction", "CU", ILSA, lens=85, f_number=1.8),
            Wanted(size="CU", lens=85, f_number=1.8, people=(ILSA,))),
    Request("SC040_SH030", _on("insert", "CU", "pistol"), Wanted(things=("pistol",))),
    Request("SC040_SH030", {"angle": "dutch", "size": "MS"}, Wanted(size="MS", angle="dutch", people=(ILSA, RICK))),
    Request("SC040_SH040", {"size": "MCU", "lens": 65}, Wanted(size="MCU", lens=65, people=(RICK, ILSA))),
    Request("SC050_SH010", _on("group", "FS", RICK, ILSA, LASZLO), Wanted(size="FS", people=(RICK, ILSA, LASZLO))),
    Request("SC050_SH030", _on("ots", "MS", ILSA, over_id=RICK), Wanted(size="MS", over=RICK, people=(ILSA,))),
    Request("SC050_SH040", _on("single", "MCU", LASZLO, angle="low angle"),
            Wanted(size="MCU", angle="low angle", people=(LASZLO,))),
    Request("SC050_SH060", {"movement": "orbit"}, Wanted(move="orbit", people=(RICK,))),
)  # fmt: skip


async def outcomes(folder: Path, project: str, requests: Sequence[Request], width: int = 480) -> list[Outcome]:
    """Send requests to the server for a folder and return what became of them; each is undone.

    Args:
        folder: Where the project is.
        project: Its folder name.
        requests: In order.
        width: Pixels of the pictures that are looked at.
    """
    command = ["-m", "storyblender", "mcp", str(folder)]
    server = StdioServerParameters(command=sys.executable, args=command, env=dict(os.environ))
    async with stdio_client(server) as (read, write), ClientSession(read, write) as client:
        await client.initialize()
        await client.call_tool("open_project", {"project": project})
        found = ((await client.call_tool("check", {})).structured_content or {})["findings"]
        return [await _outcome(client, request, width, found) for request in requests]


async def _outcome(client: ClientSession, request: Request, width: int, found: Sequence[str]) -> Outcome:
    """Send a request and return what became of it; ``found`` is what the server found in the project before."""
    before = await _shot(client, request.shot)
    if isinstance(request.asked, str):
        done = await client.call_tool("instruct", {"words": f"{request.shot}: {request.asked}"})
    else:
        edit = {"kind": "camera", "shot": request.shot, "decision": request.asked}
        done = await client.call_tool("edit", {"edits": [edit]})
    if done.is_error:
        return Outcome(request, refused=getattr(done.content[0], "text", ""))
    [frame] = (done.structured_content or {})["frames"]
    seen = {each["who"]: each for each in frame["seen"]}
    missed = misses(request.wanted, before, await _shot(client, request.shot), seen)
    [picture] = (await client.call_tool("look", {"shot": request.shot, "width": width})).content
    await client.call_tool("undo", {})
    pixels = base64.b64decode(getattr(picture, "data", ""))
    said = " ".join(each for each in found if each.startswith(f"{request.shot}: scores"))
    known = tuple(fault for fault in frame["faults"] if fault in said)
    faults = tuple(fault for fault in frame["faults"] if fault not in known)
    return Outcome(request, "", tuple(missed), frame["verdict"], faults, known, pixels)


async def _shot(client: ClientSession, name: str) -> dict[str, Any]:
    """Return a shot as the graph has it, defaults filled in."""
    [graph] = (await client.read_resource("storyblender://graph")).contents
    shots = json.loads(getattr(graph, "text", ""))["shots"]
    found = next(shot for shot in shots if shot_name(shot["scene_id"], shot["shot_id"]) == name)
    found["camera_instruction"].setdefault("size", "MS")
    return found


def main() -> None:
    """Make the project unless one is given, send all requests and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--project", type=Path, help="a finished project of examples/casablanca.fountain; it is copied")
    parser.add_argument("--frames", type=Path, help="folder for the frames")
    parser.add_argument("--only", help="numbers of requests, such as 3,17")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        project = Path(folder) / "casablanca.storyboard"
        if arguments.project:
            shutil.copytree(arguments.project, project)
        else:
            options = ["--out", str(project), "--look", "fast", "--width", "480", "--no-animatic", "--quiet"]
            subprocess.run([sys.executable, "-m", "storyblender", "make", str(SCRIPT), *options], check=True)
        chosen = (
            [int(number) for number in arguments.only.split(",")] if arguments.only else range(1, len(REQUESTS) + 1)
        )
        results = asyncio.run(outcomes(project.parent, project.name, [REQUESTS[number - 1] for number in chosen]))
    for number, outcome in zip(chosen, results, strict=True):
        print(f"{number:>2} {_row(outcome)}")
        if arguments.frames and outcome.picture:
            arguments.frames.mkdir(parents=True, exist_ok=True)
            (arguments.frames / f"{number:02}.png").write_bytes(outcome.picture)
    asked, passed = sum(each.as_asked for each in results), sum(each.passes for each in results)
    both = sum(each.as_asked and each.passes for each in results)
    print(f"of {len(results)}: {asked} measured as asked, {passed} pass the critic, {both} both")


def _row(outcome: Outcome) -> str:
    """Return what became of a request in a line; ``pass*``: but for what was wrong before."""
    asked = outcome.request.asked
    words = asked if isinstance(asked, str) else ", ".join(f"{key} {value}" for key, value in asked.items())
    told = outcome.refused or "; ".join((*outcome.missed, *(f"critic: {fault}" for fault in outcome.faults)))
    measured = "refused" if outcome.refused else "as asked" if outcome.as_asked else "no"
    verdict = "pass*" if outcome.passes and outcome.verdict != "pass" else outcome.verdict
    return f"{outcome.request.shot} {words[:60]:60} {measured:8} {verdict:6} {told}"


if __name__ == "__main__":
    main()

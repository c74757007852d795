"""Surfaces and skies of the crew come from a catalogue or the user's library, once for a place."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from storyblender.edits.words import edits_of
from storyblender.library.panorama_file import radiance_file
from storyblender.library.shared.place import library_folder
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.panorama import Panorama, panorama_file
from storyblender.project import read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio
from storyblender.trace import Event
from tests.panoramas import sky
from tests.services.catalogue_sites import Haven, open_poly_haven
from tests.services.site import Reply, Site, serving
from tests.stand_in_engine import StandInEngine
from tests.textures import boards

SCRIPT = """INT. BARN - DAY

ANN (40) waits.

EXT. SQUARE - DAY

ANN waits.

INT. BARN - NIGHT

ANN waits.

EXT. SQUARE - NIGHT

ANN waits.

EXT. SQUARE - DAY

ANN waits.
"""


def png(picture: Image.Image) -> bytes:
    picture.save(out := io.BytesIO(), "PNG")
    return out.getvalue()


def texture(id: str, name: str, *tags: str, color: tuple[int, int, int] | None = None) -> Haven:
    shown = boards() if color is None else Image.new("RGB", (64, 64), color)
    maps = {"Diffuse": png(shown), "nor_gl": png(Image.new("RGB", (64, 64), (128, 128, 255)))}
    maps["Rough"] = png(Image.new("L", (64, 64), 128))
    return Haven(id, name, tags, "textures", pictures=maps, metres=1.5)


def panorama(id: str, name: str, *tags: str) -> Haven:
    return Haven(id, name, tags, "hdris", pictures={"hdr": radiance_file(sky())})


WOOD = texture("barn_planks", "Barn Planks", "wood", "planks", "wall", "old", "boards")
ROOF = texture("wood_shingles", "Wood Shingles Planks", "wood", "roof", "planks")
COBBLE = texture("cobblestone_05", "Cobblestone 05", "cobblestone", "ground", "road", "outdoor", color=(90, 90, 90))
MARBLE = texture("marble_01", "Marble 01", "marble", "floor", color=(200, 200, 200))
TOWN = panorama("city_square", "City Square", "outdoor", "urban", "midday", "partly cloudy", "natural light")
DARK = panorama("town_night", "Town Square Night", "outdoor", "urban", "night", "clear")
HALL = panorama("market_hall", "Market Hall Square", "indoor", "urban", "midday", "clear")
GREY = panorama("grey_field", "Square Field", "outdoor", "nature", "midday", "overcast")
EVERYTHING = (WOOD, ROOF, COBBLE, MARBLE, TOWN, DARK, HALL, GREY)


@pytest.fixture
def site() -> Iterator[Site]:
    with serving() as site:
        open_poly_haven(site, EVERYTHING)
        yield site


@pytest.fixture(autouse=True)
def _without_blender(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)


def made(folder: Path, site: Site | None, told: list[Event] | None = None, **given: Any) -> ContinuityMemoryGraph:
    folder.mkdir(exist_ok=True)
    script, project = folder / "a.fountain", folder / "a.storyboard"
    script.write_text(SCRIPT)
    services = {"services": f"poly_haven@{site.address}"} if site is not None else {}
    settings = Settings.model_validate({"width": 160, "look": "fast", "animatic": False, **services, **given})
    Studio(settings, told.append if told is not None else lambda event: None).make(script, project)
    return read_project_graph(project)


def warnings(told: list[Event]) -> list[str]:
    return [event.message for event in told if event.kind == "warning"]


def shown(graph: ContinuityMemoryGraph) -> list[tuple[str, str]]:
    """Return the places of the pictures of walls and ground, scene by scene."""
    sets = [scene.environment for scene in graph.scenes if scene.environment is not None]
    return [
        (
            each.wall_texture.provenance.file if each.wall_texture else "",
            each.ground_texture.provenance.file if each.ground_texture else "",
        )
        for each in sets
    ]


def test_surfaces_and_sky_are_found_by_what_they_are_and_kept_for_the_place(tmp_path: Path, site: Site) -> None:
    told: list[Event] = []
    graph = made(tmp_path / "a", site, told)
    barn, square, barn_again, square_night, square_again = shown(graph)
    assert barn == barn_again and barn[0] == "poly_haven/barn_planks-1k"
    assert square == square_night == square_again == ("", "poly_haven/cobblestone_05-1k")
    environment = graph.scene(1).environment
    assert environment is not None and environment.wall_texture is not None
    assert environment.wall_texture.metres == 1.5 and environment.wall_texture.maps == ("color", "normal", "roughness")
    offered = [scene.offered_panorama for scene in graph.scenes]
    assert [each and each.provenance.file for each in offered] == [
        None, "poly_haven/city_square-2k", None, None, "poly_haven/city_square-2k",
    ]  # fmt: skip
    lit = [scene.lighting.panorama is not None for scene in graph.scenes if scene.lighting is not None]
    assert lit == [False, True, False, False, True]
    project = tmp_path / "a" / "a.storyboard"
    assert all((project / name).is_file() for each in graph.textures for name in each.files)
    credits = (project / "credits.md").read_text()
    for word in ("barn_planks", "cobblestone_05", "city_square", "Greg Zaal", "CC0"):
        assert word in credits
    assert not warnings(told)


def test_the_next_story_takes_them_from_the_library_and_asks_nobody(tmp_path: Path, site: Site) -> None:
    first = made(tmp_path / "a", site)
    site.pages.clear()
    second = made(tmp_path / "b", None)
    assert shown(second) == shown(first)
    kinds = {entry.kind for entry in SharedLibrary.open(library_folder()).find()}
    assert kinds == {"texture", "panorama"}


def test_what_is_lost_is_prepared_again(tmp_path: Path, site: Site) -> None:
    graph = made(tmp_path / "a", site)
    project = tmp_path / "a" / "a.storyboard"
    light = next(scene.offered_panorama for scene in graph.scenes if scene.offered_panorama is not None)
    assert isinstance(light, Panorama)
    lost = [*graph.textures[0].files, panorama_file(light.provenance.digest)]
    for name in lost:
        (project / name).unlink()
    Studio(Settings.load(project=project)).render(project)
    assert all((project / name).is_file() for name in lost)


def test_what_a_person_decided_is_never_overruled(tmp_path: Path, site: Site) -> None:
    made(tmp_path / "a", site)
    project = tmp_path / "a" / "a.storyboard"
    with Studio(Settings.load(project=project)).open(project) as session:
        decided = {"kind": "set", "scene": "SC010", "decision": {"walls": "brick", "width": 9.0}}
        light = {"kind": "light", "scene": "SC020", "decision": {"panorama": "none"}}
        session.draw(session.apply(edits_of([decided, light])))
        graph = session.graph
    assert [shown(graph)[index][0] for index in (0, 2)] == ["", ""] and graph.scene(1).environment is not None
    plan = graph.scene(2).lighting
    assert plan is not None and plan.panorama is None


@pytest.mark.parametrize("fault", ["list", "files", "torn", "hostile"])
def test_when_the_service_fails_the_place_stays_as_it_is_drawn(tmp_path: Path, site: Site, fault: str) -> None:
    if fault == "list":
        site.pages["/assets"] = Reply(b"oh no", 404)
    elif fault == "files":
        for asset in EVERYTHING:
            site.pages[f"/files/{asset.id}"] = Reply(b"gone", 404)
    else:
        hostile = b"<svg><script>alert(1)</script></svg>"
        broken = [
            Haven(each.id, each.name, each.tags, each.kind, pictures={
                name: hostile if fault == "hostile" else data[: len(data) // 2] for name, data in each.pictures.items()
            })
            for each in EVERYTHING
        ]  # fmt: skip
        open_poly_haven(site, broken)
    told: list[Event] = []
    graph = made(tmp_path / "a", site, told, library=False)
    assert shown(graph) == [("", "")] * 5 and not graph.panoramas
    heard = [each for each in warnings(told) if "stay as" in each or "left out" in each]
    assert heard and len(heard) == len(set(heard)), "each fault is said once"
    assert len(heard) <= (3 if fault in ("torn", "hostile") else 1)
    assert not (tmp_path / "a" / "a.storyboard" / "credits.md").exists()

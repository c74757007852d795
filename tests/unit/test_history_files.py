"""A damaged or incomplete project: what is missing is rebuilt, what is damaged is refused with advice that is true."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from storyblender.catalog.liquids import LIQUIDS
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.scene_context import SceneContext, SceneSetup
from storyblender.memory.shot_context import BodyState, CameraInstruction, CharacterAction, ShotContext
from storyblender.project import Project, read_project_graph

NAMES = ("cup", "key", "hat", "box", "pen")


def asset(name: str, description: str = "") -> Asset:
    return Asset(asset_id=name, asset_type="object", description=description)


def make(folder: Path, names: tuple[str, ...] = NAMES) -> ContinuityMemoryGraph:
    with Project(folder) as project:
        for name in names:
            project.commit(replace(project.graph, asset(name)), "user", f"adds {name}")
        return project.graph


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("whole") / "p"
    make(folder)
    return folder


@pytest.fixture
def folder(whole: Path, tmp_path: Path) -> Path:
    return shutil.copytree(whole, tmp_path / "p")


def files(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def names_at(folder: Path) -> tuple[str, ...]:
    with Project(folder) as project:
        return tuple(item.asset_id for item in project.graph.assets)


def refusal(folder: Path) -> InputError:
    before = files(folder)
    with pytest.raises(InputError) as caught:
        Project(folder)
    assert files(folder) == before
    with pytest.raises(InputError):
        read_project_graph(folder)
    return caught.value


def delete(*names: str) -> Callable[[Path], None]:
    return lambda folder: [(folder / name).unlink() for name in names] and None


def write(name: str, text: str) -> Callable[[Path], None]:
    return lambda folder: (folder / name).write_text(text) and None


def edit(name: str, old: str, new: str) -> Callable[[Path], None]:
    def change(folder: Path) -> None:
        text = (folder / name).read_text()
        assert old in text
        (folder / name).write_text(text.replace(old, new, 1))

    return change


@pytest.mark.parametrize(
    ("damage", "says"),
    [
        (delete("history/HEAD"), ["history/HEAD was missing"]),
        (delete("graph.json"), []),
        (delete("graph.json", "history/HEAD"), ["history/HEAD was missing"]),
        (delete("history/000002.json"), []),
        (lambda folder: shutil.rmtree(folder / "history"), ["cannot be undone", "HEAD was missing"]),
        (write("history/000006.json", '{"revision": 6, "auth'), []),
        (write("history/12 monkeys.json", "x"), []),
    ],
)
def test_what_is_missing_is_rebuilt(folder: Path, damage: Callable[[Path], None], says: list[str]) -> None:
    damage(folder)
    assert {item.asset_id for item in read_project_graph(folder).assets} == set(NAMES)
    with Project(folder) as project:
        assert [item.asset_id for item in project.graph.assets] == list(NAMES) and project.revision == 5
        assert len(project.notices) == len(says)
        assert all(words in told for words, told in zip(says, project.notices, strict=True))
    with Project(folder) as project:
        assert not [told for told in project.notices if "HEAD" in told] and project.revision == 5
        project.commit(replace(project.graph, asset("new")), "user", "adds new")
    assert names_at(folder) == (*NAMES, "new")


@pytest.mark.parametrize(
    "damage",
    [
        write("graph.json", ""),
        write("graph.json", '{\n "digest": "00'),
        write("graph.json", "[" * 100_000),
        write("graph.json", '{"a":' * 100_000),
        write("graph.json", '{"schema_version": 0}'),
        write("graph.json", '{"schema_version": 1e999}'),
        write("graph.json", '{"schema_version": 2, "revision": 5, "format": {"fps": NaN}}'),
        edit("graph.json", '"hat"', '"tie"'),
        edit("graph.json", '"revision": 5', '"revision": 4'),
        write("history/HEAD", ""),
        write("history/HEAD", "one"),
        write("history/HEAD", "-2"),
        write("history/HEAD", "3"),
        write("history/HEAD", "5 0123456789abcdef"),
        write("history/HEAD", "7 0123456789abcdef"),
        write("history/HEAD", "9" * 5000),
    ],
)
def test_a_damaged_file_is_refused_and_its_advice_is_true(folder: Path, damage: Callable[[Path], None]) -> None:
    damage(folder)
    error = refusal(folder)
    assert "delete this file" in error.mend and error.path is not None
    Path(error.path).unlink()
    assert names_at(folder) == NAMES


def test_a_newer_project_is_not_called_damaged(folder: Path) -> None:
    (folder / "graph.json").write_text('{"schema_version": 99}')
    assert "newer StoryBlender" in str(refusal(folder))


def test_a_graph_of_another_project_is_refused(folder: Path, tmp_path: Path) -> None:
    for others in (("sun", "moon", "star", "sky", "sea"), ("sun",), (*NAMES[:4], "sea")):
        make(tmp_path / others[-1], others)
        shutil.copy(tmp_path / others[-1] / "graph.json", folder / "graph.json")
        error = refusal(folder)
        assert error.path == folder / "graph.json" and "delete this file" in error.mend
    (folder / "graph.json").unlink()
    assert names_at(folder) == NAMES


def test_an_older_graph_of_this_project_is_brought_up_to_the_last_change(tmp_path: Path) -> None:
    make(tmp_path / "p", NAMES[:2])
    old = (tmp_path / "p" / "graph.json").read_bytes()
    make(tmp_path / "p", NAMES[2:])
    (tmp_path / "p" / "graph.json").write_bytes(old)
    assert names_at(tmp_path / "p") == NAMES


@pytest.mark.parametrize("content", ["", "{", "[]", "null", "[" * 5000, '{"revision": 3}'])
@pytest.mark.parametrize("number", [1, 3, 5])
def test_a_damaged_commit_is_met_by_who_needs_it(folder: Path, number: int, content: str) -> None:
    name = f"history/{number:06d}.json"
    (folder / name).write_text(content)
    with Project(folder) as project:  # graph.json is whole
        assert project.revision == 5
        with pytest.raises(InputError, match=rf"{number:06d}.json: the history is damaged here; restore it"):
            project.log()
    (folder / "graph.json").unlink()
    assert re.search(rf"{number:06d}.json.*restore it from a copy", str(refusal(folder)))


def test_the_content_of_a_commit_is_what_was_written(folder: Path) -> None:
    edit("history/000003.json", '"adds hat"', '"adds tie"')(folder)
    (folder / "graph.json").unlink()
    assert "000003.json" in str(refusal(folder))
    edit("history/000003.json", '"adds tie"', '"adds hat"')(folder)
    assert names_at(folder) == NAMES


def test_a_commit_in_the_place_of_another(folder: Path) -> None:
    shutil.copy(folder / "history/000002.json", folder / "history/000004.json")
    (folder / "graph.json").unlink()
    assert "000004.json" in str(refusal(folder))


def test_missing_commits_are_named(folder: Path) -> None:
    (folder / "graph.json").unlink()
    (folder / "history/000003.json").unlink()
    assert "000003.json: this part of the history is missing" in str(refusal(folder))
    (folder / "history/HEAD").unlink()
    assert "000003.json: this part of the history is missing" in str(refusal(folder))


def test_the_end_of_the_history_is_missing(tmp_path: Path) -> None:
    make(tmp_path / "p", NAMES[:3])
    old = (tmp_path / "p" / "graph.json").read_bytes()
    make(tmp_path / "p", NAMES[3:])
    (tmp_path / "p" / "graph.json").write_bytes(old)
    (tmp_path / "p" / "history" / "000005.json").unlink()
    error = refusal(tmp_path / "p")
    assert "names change 5, and the last one here is 4" in error.problem and "go on from change 4" in error.mend
    (tmp_path / "p" / "history" / "HEAD").unlink()
    assert names_at(tmp_path / "p") == NAMES[:4]


@pytest.mark.parametrize("name", ["graph.json", "history/HEAD", "history/000005.json"])
def test_a_folder_in_place_of_a_file(folder: Path, name: str) -> None:
    (folder / name).unlink()
    (folder / name).mkdir()
    try:
        names_at(folder)
    except InputError as error:
        assert name in str(error)


def test_undo_checks_that_the_graph_is_the_one_that_the_commit_led_to(folder: Path) -> None:
    body = json.loads((folder / "graph.json").read_text())
    del body["digest"]  # as a person writes it
    body["assets"][4]["description"] = "a pen"
    (folder / "graph.json").write_text(json.dumps(body))
    before = files(folder)
    with Project(folder) as project, pytest.raises(InputError, match=r"graph.json: does not belong to the history"):
        project.go_to(project.revision - 1)
    assert files(folder)["history/HEAD"] == before["history/HEAD"]


def test_the_order_of_the_cast_comes_back(tmp_path: Path) -> None:
    with Project(tmp_path / "p") as project:
        first = ContinuityMemoryGraph(assets=tuple(asset(name) for name in NAMES))
        project.commit(first, "director", "plans")
        project.commit(ContinuityMemoryGraph(assets=(asset("pen"), asset("new"), asset("cup"))), "director", "plans")
        assert [item.asset_id for item in project.graph.assets] == ["pen", "new", "cup"]
        project.go_to(1)
        assert project.graph == first
        project.go_to(2)
    (tmp_path / "p" / "graph.json").unlink()
    assert names_at(tmp_path / "p") == ("pen", "new", "cup")


def test_words_for_motions_and_liquids_of_schema_5_become_values_in_graph_and_commits(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    words = ("stand_up", "leaning over", "photosynthesise", "walk")
    actions = tuple(CharacterAction(asset_id="ada", action_description="", motion=word) for word in words)
    shot = ShotContext(
        scene_id=1,
        shot_id=1,
        states=(BodyState(asset_id="ada", activity="play_music"), BodyState(asset_id="ada")),
        character_actions=actions,
        camera_instruction=CameraInstruction(),
    )
    ada = Asset(asset_id="ada", asset_type="character", description="")
    glass = asset("glass", "a glass of milk")
    with monkeypatch.context() as old, Project(tmp_path / "p") as project:
        old.setattr("storyblender.project.MOTIONS", None)
        project.commit(
            ContinuityMemoryGraph(assets=(ada, glass), scenes=(SceneContext(scene_id=1, setup=SceneSetup()),)),
            "director",
            "plans",
        )
        project.commit(replace(project.graph, shot), "director", "plans")
    body = json.loads((tmp_path / "p" / "graph.json").read_text())
    del body["digest"]
    (tmp_path / "p" / "graph.json").write_text(json.dumps(body | {"schema_version": 5}))
    with Project(tmp_path / "p") as project:
        found = project.graph.shot(1, 1)
        assert [action.motion for action in found.character_actions] == ["rise", "lean_over", "idle", "walk"]
        assert [state.activity for state in found.states] == ["play_piano", ""]
        assert [each.liquid for each in project.graph.assets] == ["", LIQUIDS["milk"]]
        latest = project.graph
        project.go_to(1)
        project.go_to(2)
        assert project.graph == latest
    (tmp_path / "p" / "graph.json").unlink()
    assert read_project_graph(tmp_path / "p") == latest

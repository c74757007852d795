"""A thing of the story gets a size, its front and top, another model, or is chosen anew; and it goes back."""

from __future__ import annotations

import re
from collections.abc import Iterator
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import pytest
from tests.every import every
from tests.home import SETTINGS
from tests.model_files import write_cabinet
from tests.stand_in_engine import StandInEngine

from storyblender.edits.words import edits_of
from storyblender.errors import EngineError, InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.jobs import AssetJob
from storyblender.memory.measure import AssetMeasure
from storyblender.session import Session
from storyblender.studio import Studio


def apply(session: Session, *edits: dict[str, Any]) -> tuple[str, ...]:
    applied = session.apply(edits_of(list(edits)))
    session.draw(applied)
    return applied.stale


def thing(action: str, name: str = "letter", **said: Any) -> dict[str, Any]:
    return {"kind": "asset", "action": action, "thing": name, **said}


def letter(session: Session) -> Asset:
    return session.graph.asset("letter")


@pytest.fixture
def with_models(folder: Path, tmp_path: Path) -> Iterator[Session]:
    """The project with a folder of the user's models."""
    models = tmp_path / "models"
    models.mkdir()
    write_cabinet(models)
    with Studio(SETTINGS.model_copy(update={"models": (models,)})).open(folder) as session:
        yield session


def test_one_side_keeps_the_proportions_and_the_layout(session: Session) -> None:
    before = letter(session).canonical
    assert before is not None
    stale = apply(session, thing("resize", dimension={"width": before.dimensions[0] * 2}))
    after = letter(session).canonical
    assert after is not None and {name[:5] for name in stale} == {"SC010", "SC030"}, "not the park"
    assert after.dimensions == pytest.approx([side * 2 for side in before.dimensions])


def test_several_sides_are_as_they_are_said(session: Session) -> None:
    apply(session, thing("resize", dimension={"width": 0.4, "depth": 0.2, "height": 0.1}))
    made = letter(session).canonical
    assert made is not None and made.dimensions == (0.4, 0.2, 0.1)


def test_what_is_chosen_anew_is_not_what_it_was_and_unlock_gives_it_back(session: Session) -> None:
    before = letter(session)
    assert before.canonical is not None
    apply(session, thing("regenerate"))
    once = letter(session)
    assert once.canonical is not None and once.canonical.key != before.canonical.key
    apply(session, thing("regenerate"))
    twice = letter(session)
    assert twice.canonical is not None
    assert twice.canonical.key not in (before.canonical.key, once.canonical.key)
    assert twice.turned_down == (before.canonical.key, once.canonical.key)
    apply(session, {"kind": "unlock", "target": "letter"})
    assert letter(session) == before


def test_a_thing_is_made_from_a_file_of_the_user_and_turned(with_models: Session) -> None:
    session = with_models
    before = session.graph
    apply(session, thing("replace", "table", file="radio.obj"))
    made = session.graph.asset("table").canonical
    assert made is not None and (made.source, made.key) == ("file", "radio.obj")
    assert made.provenance is not None and made.provenance.digest
    apply(session, thing("turn", "table", pose={"front": "left", "top": "top"}))
    turned = session.graph.asset("table").canonical
    assert turned is not None and (turned.params["front"], turned.params["top"]) == ("left", "top")
    apply(session, thing("resize", "table", dimension={"height": 0.3}))
    small = session.graph.asset("table")
    assert small.canonical is not None and small.canonical.params["front"] == "left" and small.decision is not None
    for _ in range(3):
        session.undo()
    assert session.graph.model_dump_json() == before.model_dump_json()


def test_files_are_told_as_they_are_called(with_models: Session, tmp_path: Path) -> None:
    write_cabinet(tmp_path / "models", "old_radio")
    for name in ("table", "tom"):
        applied = with_models.apply(edits_of([thing("replace", name, file="old_radio.obj")]))
        with_models.draw(applied)
        assert applied.words.endswith("is made from old_radio.obj")
    assert with_models.apply(edits_of([thing("regenerate", "table")])).words.endswith("not from old_radio.obj")


def test_the_same_model_is_not_chosen_twice_unless_its_file_was_changed(with_models: Session, tmp_path: Path) -> None:
    for name, said in (
        ("table", "table is made from radio.obj already"),
        ("tom", "Tom is made from radio.obj already"),
    ):
        chosen = thing("replace", name, file="radio.obj")
        apply(with_models, chosen)
        before = with_models.revision
        with pytest.raises(InputError, match=f"^{re.escape(said)}$"):
            with_models.apply(edits_of([chosen]))
        assert with_models.revision == before
        path = tmp_path / "models" / "radio.obj"
        path.write_text(path.read_text() + f"# changed for {name}\n")
        apply(with_models, chosen)
        assert with_models.revision != before


def test_a_model_becomes_as_high_as_is_said_and_an_odd_size_is_told(with_models: Session) -> None:
    session = with_models
    apply(session, thing("replace", "table", file="radio.obj"))
    made = session.graph.asset("table").canonical
    assert made is not None
    wanted = made.dimensions[2] * 9
    applied = session.apply(edits_of([thing("resize", "table", dimension={"height": wanted})]))
    assert applied.warnings == ("the table is 9 times as large as it was",)
    table = session.graph.asset("table")
    assert table.canonical is not None and table.canonical.dimensions[2] == pytest.approx(wanted)
    sides = dict(zip(("width", "depth", "height"), table.canonical.dimensions, strict=True))
    (told,) = [(side, length) for side, length in table.dimension or () if length is not None]
    assert told[1] == pytest.approx(sides[told[0]]), "what it is built in is the size of the model, not the usual one"
    again = session.apply(edits_of([thing("resize", "table", dimension={"height": wanted * 1.5})]))
    assert not again.warnings


def test_a_character_is_made_from_a_file_of_the_user_until_given_back(with_models: Session) -> None:
    session, before = with_models, with_models.graph.asset("tom")
    applied = session.apply(edits_of([thing("replace", "tom", file="radio.obj")]))
    session.draw(applied)
    made = session.graph.asset("tom").canonical
    assert made is not None and (made.source, made.key) == ("file", "radio.obj")
    apply(session, thing("turn", "tom", pose={"front": "right", "top": "top"}))
    made = session.graph.asset("tom").canonical
    assert made is not None and made.params["front"] == "right"
    apply(session, {"kind": "unlock", "target": "tom"})
    assert session.graph.asset("tom") == before


def test_a_model_is_given_and_turned_at_once(with_models: Session) -> None:
    pose = {"front": "back", "top": "top"}
    edits = [thing("replace", "tom", file="radio.obj"), thing("turn", "tom", pose=pose)]
    with_models.apply(edits_of(edits))
    decision = with_models.graph.asset("tom").decision
    assert decision is not None and (decision.file, decision.params) == ("radio.obj", pose)


def test_where_a_file_is_gone_something_else_stands_in(with_models: Session, tmp_path: Path) -> None:
    applied = with_models.apply(edits_of([thing("replace", file="radio.obj")]))
    (tmp_path / "models" / "radio.obj").unlink()
    with_models.draw(applied)
    made = letter(with_models).canonical
    assert made is not None and made.source != "file"


@every(
    "named told",
    [
        ("nope.obj", "no folder of models and no library has 'nope.obj'; there are: radio.obj"),
        ("models/radio.obj", "name it by its path in the folder: radio.obj"),
    ],
)
def test_a_model_that_there_is_not_is_refused_at_once(with_models: Session, named: str, told: str) -> None:
    before = with_models.revision
    for name in ("letter", "tom"):
        with pytest.raises(InputError, match=re.escape(told)):
            with_models.apply(edits_of([thing("replace", name, file=named)]))
    assert with_models.revision == before


def test_a_model_that_cannot_be_read_is_refused_at_once(
    with_models: Session, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(_: StandInEngine, job: AssetJob) -> Future[AssetMeasure]:
        future: Future[AssetMeasure] = Future()
        wrong = f"build_asset: {tmp_path / 'models' / 'radio.obj'}: the model cannot be used: it is empty"
        future.set_exception(EngineError(wrong))
        return future

    before = with_models.revision
    monkeypatch.setattr(StandInEngine, "build_asset", refused)
    for name in ("letter", "tom"):
        with pytest.raises(InputError, match=r"^radio\.obj: the model cannot be used: it is empty$"):
            with_models.apply(edits_of([thing("replace", name, file="radio.obj")]))
    assert with_models.revision == before


def test_what_was_decided_of_a_thing_stays_when_the_script_tells_more_of_it(with_models: Session, folder: Path) -> None:
    script = folder.parent / "home.fountain"
    apply(with_models, thing("replace", "table", file="radio.obj"))
    script.write_text(script.read_text().replace("on the table", "on the old table"))
    with_models.make(script)
    made = with_models.graph.asset("table").canonical
    assert made is not None and made.key == "radio.obj"


@every(
    "wrong",
    [
        (thing("resize", dimension={}), "is not known"),
        (thing("resize", dimension={"height": 5000.0}), "cannot be"),
        (thing("turn", pose={"front": "front", "top": "top"}), "no model of yours"),
        (thing("resize", "nothing", dimension={"height": 1.0}), "no thing"),
        (thing("regenerate", "tom"), "is a person"),
        (thing("regenerate", "armchair"), "no thing"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused_in_a_sentence(wrong: tuple[dict[str, Any], str], session: Session) -> None:
    before = session.graph
    with pytest.raises(InputError, match=wrong[1]):
        apply(session, wrong[0])
    assert session.graph == before

"""A character is drawn and made by services, and gets that model as one from a folder; or nothing changes."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Future
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from storyblender.cli import app
from storyblender.errors import EngineError, InputError
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.jobs import AssetJob
from storyblender.memory.measure import AssetMeasure
from storyblender.project import read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio
from tests.services.makers import SECRET, HunyuanWire, model, openai_draws
from tests.services.quick_runs import hurry
from tests.services.site import Reply, Site, said, serving
from tests.stand_in_engine import StandInEngine

SCRIPT = """INT. WORKSHOP - DAY

ADA (30, green coat) stands beside the table.

ADA
It still turns.
"""


@pytest.fixture
def site(monkeypatch: pytest.MonkeyPatch) -> Iterator[Site]:
    hurry(monkeypatch)
    with serving() as site:
        openai_draws(site, "")
        HunyuanWire(site).open()
        yield site


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A story that is planned, with Ada in it."""
    script = tmp_path / "workshop.fountain"
    script.write_text(SCRIPT)
    Studio(Settings()).plan(script, tmp_path / "p")
    return tmp_path / "p"


def cast(project: Path, site: Site | None, *words: str) -> Result:
    services = ["--services", f"openai@{site.address},hunyuan3d@{site.address}"] if site is not None else []
    return CliRunner().invoke(app, ["cast", str(project), "ada", *words, *services, "--no-render", "--quiet"])


def ada(project: Path) -> Asset:
    return read_project_graph(project).asset("ada")


def test_a_character_gets_the_model_that_services_made_of_their_look(site: Site, project: Path) -> None:
    made = cast(project, site, "--make")
    assert made.exit_code == 0, made.output
    decision = ada(project).decision
    assert decision is not None and decision.file.startswith("hunyuan3d/")
    (prompt,) = [hit.json["prompt"] for hit in site.hits if hit.path == "/images/generations"]
    assert "green coat" in prompt and "A-pose" in prompt
    (entry,) = SharedLibrary.open().find(kind="character")
    assert entry.key == decision.file and not SharedLibrary.open().find(kind="model"), "no thing is made from it"

    Studio(Settings()).undo(project)
    assert ada(project).decision is None
    assert cast(project, site, "--make").exit_code == 0
    assert ada(project).decision == decision
    assert (site.count("/images"), site.count("/send")) == (1, 1), "the same look is paid for once"

    assert cast(project, None, "--wear", "red hat").exit_code == 0
    assert cast(project, site, "--make").exit_code == 0
    assert (site.count("/images"), site.count("/send")) == (2, 2), "another look is another picture"


@pytest.fixture
def rigging(site: Site, monkeypatch: pytest.MonkeyPatch) -> Site:
    """Meshy's rigging."""
    host = site.address.removeprefix("http://").replace(".", "_").replace(":", "_")
    monkeypatch.setenv(f"STORYBLENDER_KEY_{host}", SECRET)
    result = {"rigged_character_glb_url": f"{site.address}/rigged"}
    site.pages |= {
        "/v1/rigging": said({"result": "rig-1"}, 202),
        "/v1/rigging/rig-1": said({"status": "SUCCEEDED", "progress": 100, "result": result}),
        "/rigged": Reply(model(b"rigged")),
    }
    return site


def rig(project: Path, site: Site) -> Result:
    services = ",".join(f"{name}@{site.address}" for name in ("openai", "hunyuan3d", "meshy"))
    return cast(project, None, "--make", "--services", services)


def test_a_service_that_rigs_puts_a_skeleton_into_the_model(rigging: Site, project: Path) -> None:
    for _ in range(2):
        assert rig(project, rigging).exit_code == 0
        decision = ada(project).decision
        assert decision is not None and decision.file == "meshy/rig-1/model.glb"
    assert rigging.count("/send") == 1
    (asked,) = [hit.json for hit in rigging.hits if hit.path == "/v1/rigging"]
    assert asked["height_meters"] == pytest.approx(1.65, abs=0.1)
    entry = SharedLibrary.open().told("meshy/rig-1/model.glb")
    assert entry is not None and entry.kind == "character"
    assert entry.credit.author.startswith("hunyuan3d") and entry.credit.author.endswith("meshy (rigging)")
    assert "Tencent" in entry.credit.license and "Meshy" in entry.credit.license


def test_a_model_that_is_not_rigged_is_used_as_it_came(rigging: Site, project: Path) -> None:
    rigging.pages["/v1/rigging"] = Reply(status=403)
    assert rig(project, rigging).exit_code == 0
    decision = ada(project).decision
    assert decision is not None and decision.file.startswith("hunyuan3d/")


def test_they_are_as_tall_as_before_in_the_frames(site: Site, tmp_path: Path) -> None:
    script, project = tmp_path / "workshop.fountain", tmp_path / "p"
    script.write_text(SCRIPT)
    settings = Settings(width=160, look="fast", animatic=False, jobs=1)
    Studio(settings).make(script, project)
    before = ada(project).dimension
    assert cast(project, site, "--make").exit_code == 0
    Studio(settings).render(project)
    canonical = ada(project).canonical
    assert canonical is not None and canonical.source == "file" and canonical.params["told"] is True
    assert ada(project).dimension == before


@pytest.mark.parametrize("path", ["/images/generations", "/send"])
def test_where_a_service_fails_nothing_changes_and_one_sentence_says_why(site: Site, project: Path, path: str) -> None:
    before = ada(project)
    site.pages[path] = Reply(status=403)
    made = cast(project, site, "--make")
    assert made.exit_code == 2
    assert made.stderr.startswith("storyblender: no model of Ada was made") and len(made.stderr.splitlines()) == 1
    assert "paid" not in made.stderr, "servers of one's own cost nothing"
    assert ada(project) == before


def test_a_model_that_is_no_human_figure_is_refused(site: Site, project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(engine: StandInEngine, job: AssetJob) -> Future[AssetMeasure]:
        done: Future[AssetMeasure] = Future()
        done.set_exception(EngineError("model.glb cannot be a character: no human figure"))
        return done

    monkeypatch.setattr(StandInEngine, "build_asset", refused)
    made = cast(project, site, "--make")
    assert made.exit_code == 2 and "no human figure" in made.stderr
    assert ada(project).decision is None


def test_a_locked_character_is_not_paid_for(site: Site, project: Path) -> None:
    assert CliRunner().invoke(app, ["lock", str(project), "ada"]).exit_code == 0
    made = cast(project, site, "--make")
    assert made.exit_code == 2 and "locked" in made.stderr
    assert not site.hits


def test_a_job_that_was_not_waited_for_is_taken_over(site: Site, project: Path) -> None:
    wire = HunyuanWire(site)
    wire.polls = 10_000
    wire.open()
    services = f"openai@{site.address},hunyuan3d@{site.address}"
    with pytest.raises(InputError, match=r"limit of 0\.02 minutes"):
        Studio(Settings(services=services, service_limits={"minutes": 0.02})).make_person(project, "Ada")
    (job,) = SharedLibrary.open().jobs.unfinished()
    wire.jobs[job.remote_id] = 0
    assert cast(project, site, "--make").exit_code == 0
    assert ada(project).decision is not None
    assert (site.count("/images"), site.count("/send")) == (1, 1)


def test_what_is_missing_in_the_settings_is_said(site: Site, project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("keyring.get_password", lambda *_: None)
    monkeypatch.delenv("OPENAI_API_KEY", raising=False)
    words = ["cast", str(project), "ada", "--make", "--services"]
    for services, told in {
        f"hunyuan3d@{site.address}": "none of hunyuan3d draws pictures; name one that draws (gemini, openai) and",
        f"openai@{site.address}": "none of openai makes models of pictures; name one that draws",
        "poly_haven": "none of poly_haven draws pictures",
        f"openai,hunyuan3d@{site.address}": "there is no key for openai",
    }.items():
        refused = CliRunner().invoke(app, [*words, services])
        assert refused.exit_code == 2 and told in refused.stderr, refused.stderr
    assert "no service is named that draws pictures" in cast(project, None, "--make").stderr
    assert not site.hits


@pytest.mark.parametrize("words", ["--make --dry-run", "--services openai,meshy", "--age 30", "--file knight.glb"])
def test_who_is_not_named_is_not_changed(words: str, project: Path) -> None:
    refused = CliRunner().invoke(app, ["cast", str(project), *words.split()])
    assert refused.exit_code == 2 and "nobody is named" in refused.stderr
    assert CliRunner().invoke(app, ["cast", str(project)]).exit_code == 0


def test_the_price_is_told_without_asking_anybody(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OPENAI_API_KEY", "one")
    monkeypatch.setenv("MESHY_API_KEY", "two")
    told = CliRunner().invoke(app, ["cast", str(project), "ada", "--make", "--dry-run", "--services", "openai,meshy"])
    assert told.exit_code == 0 and "Ada" in told.output and "$0.74 at most" in told.output
    monkeypatch.setattr("keyring.get_password", lambda *_: None)
    monkeypatch.delenv("OPENAI_API_KEY")
    told = CliRunner().invoke(app, ["cast", str(project), "ada", "--make", "--dry-run", "--services", "openai,meshy"])
    assert told.exit_code == 0 and "$0.74 at most" in told.output and "not asked: openai (" in told.output
    assert ada(project).decision is None
    assert cast(project, None, "--dry-run").exit_code == 2, "it is no dry run of other changes"

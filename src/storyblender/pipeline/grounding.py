"""Semantic-spatial grounding: script -> skeleton of the graph (paper, section 3.2)."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path

from storyblender.agents.director.reader.reasons import Reason, reasons_of
from storyblender.agents.director.reading import Reading
from storyblender.agents.director.reading_file import is_reading_of, read_reading, write_reading
from storyblender.agents.director.rules import Ledger, using_ledger
from storyblender.agents.director.settings import DirectorSettings
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.memory.base import content_hash
from storyblender.memory.graph import ContinuityMemoryGraph, ProjectFormat
from storyblender.memory.history import Commit
from storyblender.memory.picture_format import FormatDecision
from storyblender.pipeline.reframing import reframed, with_decision
from storyblender.pipeline.revision import Revision, revise, with_digests
from storyblender.pipeline.run import Run
from storyblender.pipeline.staging import design
from storyblender.project import KEPT_READING, SCRIPTS, reading_copy
from storyblender.screenplay.model import Screenplay
from storyblender.screenplay.source import load
from storyblender.trace import Event


def ground(run: Run, script: Path, reading: Path | None = None) -> None:
    """Read the script and commit the plan, unless this very plan is in the graph already, with a kit for every scene.

    Args:
        run: The run.
        script: The file; a copy is kept in the project so that every shot's words can be found again.
        reading: A corrected reading of it, used instead of the rules' own; the project keeps a copy and uses it again.

    Raises:
        InputError: The script, or the reading, cannot be read.
    """
    run.progress("ground", 0, 1, script.name)
    screenplay = load(script)
    corrected = reading or _kept_reading(run, screenplay)
    digest = _plan_digest(run, screenplay, corrected)
    sources = {f"script{script.suffix}": script.read_bytes()}
    if corrected is not None:
        sources[KEPT_READING] = corrected.read_bytes()
    kits_decided = all(scene.setup.kit for scene in run.graph.scenes)  # or a half-made project of schema 5
    if run.graph.plan_digest != digest or not kits_decided:
        graph = _revised(run, _plan(run, script, _understood(run, screenplay, corrected), digest))
        _keep(run, digest, sources)
        run.project.commit(graph, "director", f"plans {script.name}")
        for shot in graph.shots:
            for flag in shot.flags:
                run.tell(Event(kind="propose", role="director", subject=flag.topic, message=flag.reason))
    else:
        _keep(run, digest, sources)
        _take_over_format(run)
    counts = ((len(run.graph.scenes), "scene"), (len(run.graph.shots), "shot"))
    run.progress("ground", 1, 1, ", ".join(f"{count} {word}{'s' * (count != 1)}" for count, word in counts))


def planned_revision(run: Run, script: Path, reading: Path | None = None) -> Revision:
    """Return the plan of a script with what stays of the plan before it; nothing is committed.

    Args:
        run: On a project that is planned.
        script: As it is revised.
        reading: A corrected reading of it; that which the project keeps, if it fits, where none is given.

    Raises:
        InputError: The script, or the reading, cannot be read.
    """
    screenplay = load(script)
    corrected = reading or _kept_reading(run, screenplay)
    digest = _plan_digest(run, screenplay, corrected)
    return _revision(run, _plan(run, script, _understood(run, screenplay, corrected), digest))


def _revision(run: Run, plan: ContinuityMemoryGraph) -> Revision:
    designer = partial(design, run)
    revision = revise(run.graph, with_digests(plan), _log(run), designer)
    return replace(revision, graph=reframed(revision.graph, run.graph.format))


def _revised(run: Run, plan: ContinuityMemoryGraph) -> ContinuityMemoryGraph:
    """Return a plan with what stays of the plan before it, and say what a person decided that does not."""
    if not run.graph.shots:
        return with_digests(plan)
    revision = _revision(run, plan)
    for name, decided in revision.lost:
        message = f"{decided} is not kept: the words under it changed; `undo` brings all back"
        run.tell(Event(kind="warning", role="director", subject=name, message=message))
    kept = f"{len(revision.kept_scenes)} of {len(plan.scenes)} scenes stay as they were staged"
    run.tell(Event(kind="propose", role="director", subject="changed script", message=kept))
    return revision.graph


def export_reading(run: Run, script: Path, out: Path) -> None:
    """Write what was understood of a script as a file that a person can correct.

    Args:
        run: With the script grounded.
        script: The script.
        out: The JSON file.

    Raises:
        InputError: The file cannot be written.
    """
    screenplay = load(script)
    Folder(out.parent).write(out.name, write_reading(_understood(run, screenplay, _kept_reading(run, screenplay))))


def explain(run: Run, script: Path) -> list[Reason]:
    """Return why the rules read a script as they do: each decision with its rule and the words it stands on.

    Args:
        run: With the script grounded.
        script: The script.

    Raises:
        InputError: The script was read by a person, not by rules.
    """
    screenplay = load(script)
    if _kept_reading(run, screenplay) is not None:
        raise InputError("was read by a person, not by rules", mend="leave out --why", path=script)
    with using_ledger(Ledger()) as ledger:
        return reasons_of(_understood(run, screenplay, None), ledger)


def _understood(run: Run, screenplay: Screenplay, corrected: Path | None) -> Reading:
    if corrected is not None:
        return read_reading(corrected, screenplay)
    return run.reflect(run.crew.director, screenplay.title or "script", screenplay).draft


def _keep(run: Run, digest: str, sources: Mapping[str, bytes]) -> None:
    """Copy what a plan was made from into the project: once for people, once by the plan's digest for ``undo``."""
    for name, content in sources.items():
        if run.outputs.digest(name) != hashlib.sha256(content).hexdigest() or not run.outputs.whole(name):
            run.copy_aside_if_known(name)
            run.outputs.write(name, content)
        copy = f"{SCRIPTS}/{digest}{name.removeprefix('script')}" if name != KEPT_READING else reading_copy(digest)
        if not run.project.path(copy).exists():
            run.project.files.write(copy, content)


def _kept_reading(run: Run, screenplay: Screenplay) -> Path | None:
    """Return the corrected reading that the project keeps, if it is one of these very words."""
    kept = run.project.files.path(KEPT_READING)
    if not kept.exists():
        return None
    if is_reading_of(kept, screenplay):
        return kept
    message = "is of other words, so the script is read anew; give a corrected one with --reading"
    run.tell(Event(kind="warning", role="director", subject=KEPT_READING, message=message))
    return None


def _log(run: Run) -> list[Commit]:
    """Return the commits that can be read, oldest first."""
    commits: list[Commit] = []
    try:
        for commit in run.project.backwards():
            commits.append(commit)
    except InputError as error:
        message = f"{error.problem}; what was decided about cameras before version 2 of the format is not found"
        run.tell(Event(kind="warning", role="project", subject=str(error.path or ""), message=message))
    return commits[::-1]


def _plan(run: Run, script: Path, reading: Reading, digest: str) -> ContinuityMemoryGraph:
    settings = DirectorSettings(shots_per_scene=run.settings.shots_per_scene, fps=run.settings.fps)
    board = run.reflect(run.crew.shot_director, script.name, reading, settings).draft
    return ContinuityMemoryGraph(
        title=reading.screenplay.title or script.stem.replace("_", " ").title(),
        script_name=script.name,
        edition=reading.screenplay.edition,
        plan_digest=digest,
        settings_digest=content_hash(_plan_settings(run)),
        format=_format(run),
        format_decision=_format_decision(run),
        story_summary=board.story_summary,
        age=board.age,
        panorama=run.panorama and run.panorama[0],
        outline=board.storyboard_outline,
        assets=board.asset_sheet,
        scenes=board.scene_details,
        shots=board.shot_details,
    )


def _take_over_format(run: Run) -> None:
    """A new width asks for new pictures, not for a new plan."""
    graph = run.graph.model_copy(update={"format": _format(run), "format_decision": _format_decision(run)})
    run.project.commit(reframed(graph, run.graph.format), "user", "picture size")


def _format(run: Run) -> ProjectFormat:
    """Return the format of the settings, with what a person decided of it."""
    settings = run.settings
    told = ProjectFormat(
        fps=settings.fps,
        aspect=settings.aspect,
        width=settings.width // 4 * 4,
        sensor_width=settings.sensor_width,
        seed=settings.seed,
    )
    return with_decision(told, _format_decision(run) or FormatDecision())


def _format_decision(run: Run) -> FormatDecision | None:
    """Return what a person decided of the format before, without what the command line says otherwise now."""
    if run.graph.format_decision is None:
        return None
    told = run.graph.format_decision.told
    kept = {name: value for name, value in told.items() if name not in run.settings.ordered_format}
    return FormatDecision(**kept) if kept else None


def _plan_digest(run: Run, screenplay: Screenplay, corrected: Path | None) -> str:
    words = [screenplay.text, screenplay.format, _plan_settings(run)]
    if corrected is not None:
        if not corrected.is_file():
            raise InputError("there is no such file", mend="check the name", path=corrected)
        words.append(hashlib.sha256(corrected.read_bytes()).hexdigest())
    return content_hash(*words)


def _plan_settings(run: Run) -> dict[str, object]:
    """Return the settings that the plan and the crew's work on it depend on."""
    settings = run.settings.model_dump(
        mode="json", include={"shots_per_scene", "fps", "aspect", "sensor_width", "lens_kit", "seed"}
    )
    settings["crew"] = run.settings.language_roles or "rules"
    offered = {source.name: dict(source.inventory()) for source in run.sources}
    settings["models"] = {name: found for name, found in offered.items() if found} or None
    if run.panorama is not None:
        settings["panorama"] = run.panorama[0].model_dump(mode="json")
    return settings

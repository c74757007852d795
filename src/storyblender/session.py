"""A session: everything that can be done with an open project, one call at a time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from storyblender.edits.approving import approved_by, refuse_undrawn
from storyblender.edits.asset_edits import asset_effects
from storyblender.edits.dispatcher import Applied, apply_edits, given_models
from storyblender.edits.own_motions import with_own_motions
from storyblender.edits.pull_conflicts import waiting
from storyblender.edits.pulling import UNDECIDED, Choice, Pulled, pull
from storyblender.edits.targets import person_named, shots_named
from storyblender.edits.undo import next_steps, redo_edit, undo_edit
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.board_layout import BoardLayout
from storyblender.memory.edits import AssetEdit, Edit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import TRIAL, Commit
from storyblender.memory.panorama import Panorama
from storyblender.memory.plain_words import names_of, plain
from storyblender.memory.texture import Texture
from storyblender.pipeline.chosen_models import refuse_unusable
from storyblender.pipeline.compiling import story_files
from storyblender.pipeline.drawing import draw_frames, draw_shots
from storyblender.pipeline.filming import cuts_made_wrong, film
from storyblender.pipeline.given_models import take_in_model
from storyblender.pipeline.library_pictures import take_panorama, take_texture
from storyblender.pipeline.offered_models import take_offer
from storyblender.pipeline.packing import pack_scenes
from storyblender.pipeline.panorama import keep_panoramas, take_in_panorama
from storyblender.pipeline.shooting import undrawn_shots
from storyblender.pipeline.shown import note_shown
from storyblender.pipeline.textures import keep_textures, take_in_texture
from storyblender.pipeline.updating import bring_up_to_date
from storyblender.results import Delivery
from storyblender.settings import REMEMBERED, Settings
from storyblender.trace import Event
from storyblender.viewed_project import ViewedProject

if TYPE_CHECKING:
    from storyblender.pipeline.estimating import Expected
    from storyblender.pipeline.script_changes import ScriptChanges


class Session(ViewedProject):
    """An open project with all that can be done with it; ``Studio.open`` returns one."""

    def plan(self, script: Path, reading: Path | None = None, export: Path | None = None, *, why: bool) -> Delivery:
        """Read a script into the graph, as ``Studio.plan``."""
        from storyblender.pipeline.grounding import explain, export_reading, ground

        if export is not None and export.exists():
            raise InputError("is there already", mend="give --write-reading another name, or delete it", path=export)
        with self._call() as run:
            ground(run, script, reading)
            if export is not None:
                export_reading(run, script, export)
            reasons = explain(run, script) if why else []
            return Delivery(self.folder, ["graph.json"], run.graph, reasons)

    def estimate(self) -> Expected:
        """Return what the things of the planned story would be made from, and what that takes; nothing is fetched."""
        from storyblender.pipeline.estimating import expected_assets

        with self._call() as run:
            return expected_assets(run)

    def make(self, script: Path, reading: Path | None = None) -> Delivery:
        """Turn a script into everything, as ``Studio.make``; of a changed script only what changed is made anew."""
        from storyblender.pipeline.grounding import ground
        from storyblender.pipeline.late_models import take_late_models
        from storyblender.pipeline.materializing import materialize
        from storyblender.pipeline.restaging import make_stale_anew
        from storyblender.pipeline.shared_assets import count_places
        from storyblender.pipeline.staging import stage

        with self._call() as run:
            if self.made:
                pull(run)
            ground(run, script, reading)
            run.project.files.write(REMEMBERED, self._settings.remembered(self.folder))
            keep_panoramas(run)
            keep_textures(run)
            take_late_models(run)
            materialize(run)
            stage(run)
            make_stale_anew(run)
            count_places(run)
            pack_scenes(run)
            film(run)
            files, reviews = draw_shots(run, run.graph.cut)
            return Delivery(self.folder, files, run.graph, reviews=reviews)

    def make_person(self, name: str) -> str:
        """Have services make a model of a character, and return what an edit names it by; the story stays as it is.

        Args:
            name: Their id or name.

        Raises:
            InputError: There is no such person, they or a scene of theirs are locked, a setting is missing, or no
                model was made that can be used.
            Cancelled: ``cancel`` was called; the same call again goes on.
        """
        from storyblender.pipeline.made_people import made_person

        with self._call() as run:
            return made_person(run, self._person_to_make(name))

    def expect_person(self, name: str) -> Expected:
        """Return what ``make_person`` would cost at most; nothing is asked for. Raises as it does."""
        from storyblender.pipeline.made_people import expected_person

        with self._call() as run:
            return expected_person(run, self._person_to_make(name))

    def _person_to_make(self, name: str) -> Asset:
        """Return a character who may get another model. Raises InputError."""
        person = self.graph.asset(person_named(self.graph, name))
        if person.asset_type != "character":
            raise InputError(f"{person.asset_id} is a thing", mend="things are made by services in `storyblender make`")
        asset_effects(self.graph, AssetEdit(thing=person.asset_id, action="replace", file="model.glb"))
        return person

    def compare(self, script: Path, reading: Path | None = None) -> ScriptChanges:
        """Return what a revised script would change; nothing is changed. Raises InputError."""
        from storyblender.pipeline.script_changes import script_changes

        with self._call() as run:
            return script_changes(run, script, reading)

    def apply(self, edits: Sequence[Edit], revision: str | None = None) -> Applied:
        """Commit a batch of edits, all or none, as one undo; ``draw`` then draws what they made stale.

        Args:
            edits: In order.
            revision: What they were made on, as ``revision`` was then; None for the present one.

        Raises:
            InputError: An edit names what does not exist or cannot be used, is locked, or approves what is not drawn.
            StaleEdit: What they touch has changed since that revision.
        """
        with self._alone():
            if names := approved_by(edits):
                with self._call() as run:
                    refuse_undrawn(run, names)
            edits = with_own_motions(self._project, self._settings.motions, edits)
            if given := given_models(self.graph, edits):
                with self._call() as run:
                    refuse_unusable(run, given)
            applied = apply_edits(self._project, edits, revision)
            self._tell(Event(kind="commit", role="user", message=applied.words, turn=self._project.revision))
            return applied

    @contextmanager
    def trying(self, edits: Sequence[Edit]) -> Iterator[None]:
        """Have the story as a batch of edits would make it, to look at; after that it is as it was, undo and redo too.

        Args:
            edits: As for ``apply``, which says what is raised.
        """
        with self._alone():
            before = self._project.revision
            edits = with_own_motions(self._project, self._settings.motions, edits)
            apply_edits(self._project, edits, author=TRIAL)
            try:
                yield
            finally:
                self._project.drop(before)

    def instruct(self, words: str, revision: str | None = None) -> Applied:
        """Let the Instructor turn words into edits and commit them, as ``apply``.

        Args:
            words: Shots or scenes, a colon, and what is wanted: ``SC020_SH010: closer, shallow focus``.
            revision: What they were said of; None for the present one.

        Raises:
            InputError: A word is not understood, so nothing is done; or an edit cannot be.
            StaleEdit: What they touch has changed since that revision.
        """
        with self._call() as run:
            meant = run.reflect(run.crew.instructor, words.partition(":")[0], run.graph, words)
            if meant.draft.unclear or not meant.accepted:
                said = meant.draft.unclear or tuple(fault.message for fault in meant.critique.faults)
                mend = "say it in other words (docs/edits.md), or let a language model understand it with --crew"
                raise InputError(f"not understood: {'; '.join(said)}", mend=mend)
            return self.apply(meant.draft.edits, revision)

    @property
    def saved_in_blender(self) -> tuple[str, ...]:
        """Names of the story's .blend files that are not as they were written: a person saved them in Blender."""
        outputs = self._project.outputs
        return tuple(name for name in story_files(self.graph) if outputs.known(name) and outputs.changed(name))

    @property
    def waiting_conflicts(self) -> int:
        """How many changes in Blender wait for a person to choose between them and the project."""
        return len(waiting(self._project))

    def pull(self, *, apply: bool = True, choice: Choice = UNDECIDED) -> Pulled:
        """Take over what a person changed and saved in ``story.blend``, as one undo; ``draw`` then draws it.

        Args:
            apply: False only tells what was changed.
            choice: Which side is taken where the project was changed as well; the project stands until then.

        Raises:
            InputError: It names a conflict that there is not.
        """
        with self._call() as run:
            self._refuse_unmade()
            return pull(run, apply=apply, choice=choice)

    def draw(self, applied: Applied) -> Delivery | None:
        """Draw and write what edits made stale; None where that is nothing, or where the project is only planned."""
        return self.render(applied.stale) if (applied.stale or applied.printed) and self.made else None

    def render(self, names: Sequence[str] = ()) -> Delivery:
        """Draw again what changed.

        Args:
            names: Shots to draw, such as ``SC010_SH020``; all if empty.

        Raises:
            InputError: No such shot, or a project that is only planned.
            Cancelled: ``cancel`` was called.
        """
        with self._call() as run:
            shots_named(run.graph, names)
            self._refuse_unmade()
            pulled = pull(run).applied
            shots = shots_named(run.graph, [*names, *pulled.stale] if names and pulled is not None else names)
            bring_up_to_date(run)
            new = [shot for shot in run.graph.shots if shot.camera is None]
            film(run)
            wrong = cuts_made_wrong(run, new)
            for flaw in wrong:
                run.tell(Event(kind="warning", role="camera_operator", subject=flaw.shot, message=flaw.message))
            files, reviews = draw_shots(run, [run.graph.shot(shot.scene_id, shot.shot_id) for shot in shots])
            told = {
                "followed": tuple(plain(each, names_of(run.graph)) for each in run.followed),
                "wrong_cuts": tuple(wrong),
                "reviews": reviews,
            }
            return Delivery(self.folder, files, run.graph, **told)

    def print_board(self, layout: BoardLayout) -> Delivery:
        """Write the board in a layout that the project keeps; shots that look otherwise are drawn first.

        Args:
            layout: Of its pages.

        Raises:
            InputError: The project is only planned.
            Cancelled: ``cancel`` was called.
        """
        from storyblender.pipeline.delivery import BOARD, BOARD_SINGLE, frame_paths, write_boards

        with self._filming() as run:
            draw_frames(run, shots_named(run.graph, stale) if (stale := undrawn_shots(run)) else ())
            run.settings = self._settings = self._settings.model_copy(update=layout.model_dump())
            kept = Settings.load(project=self.folder, **layout.model_dump())
            run.project.files.write(REMEMBERED, kept.remembered(self.folder))
            write_boards(run, frame_paths(run))
            for name in (BOARD, BOARD_SINGLE):
                note_shown(run.outputs, run.graph, name)
            return Delivery(self.folder, [BOARD, BOARD_SINGLE], run.graph)

    def render_film(self) -> Delivery:
        """Make the animatic, and write all else that shows something else now; raises as ``render``."""
        with self._alone():
            usual = self._settings
            self._settings = usual.model_copy(update={"animatic": True})
            try:
                return self.render()
            finally:
                self._settings = usual

    @property
    def next_steps(self) -> tuple[str, str]:
        """What undo would take back and what redo would make again, in words."""
        return next_steps(self._project)

    def undo(self) -> list[Commit]:
        """Take back the last change and what followed from it; the next render draws only what that changes.

        Raises InputError if there is nothing to undo.
        """
        with self._alone():
            return undo_edit(self._project)

    def redo(self) -> list[Commit]:
        """Make the change again that was undone last. Raises InputError if there is none."""
        with self._alone():
            return redo_edit(self._project)

    def take_offer(self, key: str) -> None:
        """Fetch a model that ``offers`` told into the project and the library; an edit then names it as a file.

        Args:
            key: Of the model.

        Raises:
            InputError: It is not offered any more, the service cannot give it, or the library is turned off.
        """
        with self._call() as run:
            take_offer(run, key)

    def take_in_model(self, asset_id: str, files: Mapping[str, Path]) -> str:
        """Keep a model from a person's disk in the project, once it can be read, and return how an edit names it.

        Args:
            asset_id: The thing that is to be made from it.
            files: The model and what it names, by name, in one folder.

        Raises:
            InputError: It cannot be read, or names a file that is not given.
        """
        with self._call() as run:
            return take_in_model(run, asset_id, files)

    def take_in_panorama(self, file: Path) -> Panorama:
        """Keep the picture of a user's panorama in the project, and return what an edit of light names it by.

        Args:
            file: An .hdr or .exr, twice as wide as high.

        Raises:
            InputError: It is missing, broken or of another shape.
        """
        with self._call() as run:
            return take_in_panorama(run, file)

    def take_in_texture(self, path: Path, metres: float | None = None) -> Texture:
        """Keep the pictures of a user's surface in the project, and return what an edit of a set names it by.

        Args:
            path: A colour picture, or a folder with the maps of one surface.
            metres: Width of the picture on the wall; None for the usual.

        Raises:
            InputError: It is missing, broken, or no surface.
        """
        with self._call() as run:
            return take_in_texture(run, path, metres)

    def take_library_texture(self, digest: str, metres: float | None = None) -> Texture:
        """Keep a surface of the library in the project, and return what an edit of a set names it by.

        Args:
            digest: Of the entry.
            metres: Width of the picture on the wall; None for what the library says, or the usual.

        Raises:
            InputError: It is gone or damaged, or no surface.
        """
        with self._call() as run:
            return take_texture(run, digest, metres)

    def take_library_panorama(self, digest: str) -> Panorama:
        """Keep a panorama of the library in the project, and return what an edit of light names it by.

        Args:
            digest: Of the entry.

        Raises:
            InputError: It is gone or damaged, or no panorama.
        """
        with self._call() as run:
            return take_panorama(run, digest)

    def export(self, kinds: Sequence[str]) -> Delivery:
        """Write scenes as glTF or USD, the timeline as EDL or FCPXML.

        Raises:
            InputError: The project has no story.blend yet, or an adapter is missing.
            Cancelled: ``cancel`` was called.
        """
        from storyblender.pipeline.exporting import export

        with self._call() as run:
            return Delivery(self.folder, export(run, kinds), run.graph)

    def draw_sample(self, story: ContinuityMemoryGraph, reason: str) -> None:
        """Stage and draw a story that was written by hand into an empty project; nothing is delivered.

        Args:
            story: Scenes and shots as a Director plans them.
            reason: For the history.
        """
        from storyblender.pipeline.sampling import draw_story

        with self._call() as run:
            draw_story(run, story, reason)

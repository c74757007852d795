"""What can be looked at of an open project: pictures, moments in 3D, reasons, faults; the story stays as it is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from storyblender.deliver.contact_sheet import write_contact_sheet
from storyblender.edits.effect import name_of
from storyblender.edits.own_motions import offered_clips
from storyblender.edits.targets import shots_named
from storyblender.errors import InputError
from storyblender.inspection import Inspection, inspect
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import content_hash
from storyblender.memory.board_layout import BoardLayout
from storyblender.open_project import OpenProject
from storyblender.pipeline.asset_pictures import built_asset, candidates_for, view_of
from storyblender.pipeline.compiling import story_files
from storyblender.pipeline.drawing import DELIVERED, draw_frames
from storyblender.pipeline.filming import with_cuts_judged
from storyblender.pipeline.library_pictures import draw_library_picture, library_pictures
from storyblender.pipeline.offered_models import OfferedModels, catalogues_of, offered_models, picture_of_offer
from storyblender.pipeline.previewing import moment_of, preview_shot
from storyblender.pipeline.rehearsing import CamerasToMatch, rehearse
from storyblender.pipeline.reviewing import FrameReview, review_frames
from storyblender.pipeline.shooting import (
    drawn_shots,
    pictures_of_takes,
    shoot_frames,
    undrawn_shots,
)
from storyblender.pipeline.shown import shows
from storyblender.pipeline.updating import bring_scene_up_to_date, bring_up_to_date

if TYPE_CHECKING:
    from storyblender.library.pictures import PictureKind
    from storyblender.library.shared.entries import LibraryEntry
    from storyblender.pipeline.shot_reasons import ShotReasons


class ViewedProject(OpenProject):
    """An open project with all that it can be asked to show; a session changes it, too."""

    def shoot(self, names: Sequence[str]) -> None:
        """Draw the frames of shots; ``render`` writes what is delivered later. Raises as it does."""
        with self._filming() as run:
            draw_frames(run, shots_named(run.graph, names))

    @property
    def delivered(self) -> bool:
        """Whether board, lists and story.blend show the project as it is now."""
        return self._project.outputs.read(DELIVERED, bytes.decode) == content_hash(self.graph)

    def shows_story(self, name: str) -> bool:
        """Return whether a file that was written on request, such as the film, shows the story as it is."""
        known = shows(self._project.outputs, self.graph, name)
        return self.delivered if known is None else known

    @property
    def makes_film(self) -> bool:
        """Whether the film is made as the story is."""
        return self._settings.animatic

    @property
    def board_layout(self) -> BoardLayout:
        """How the pages of the board are laid out."""
        return self._settings.board_layout

    def preview(self, names: Sequence[str]) -> dict[str, Path]:
        """Draw shots small and quickly, to see what an edit did, and return the pictures; raises as ``render``.

        Only their scenes are made anew, and of these only what these shots show.
        """
        with self._call() as run:
            self._refuse_unmade()
            shots = shots_named(run.graph, names)
            matching = self._matching or CamerasToMatch(run)
            return {name_of(shot): preview_shot(run, shot, matching) for shot in shots}

    def rehearse(self, name: str) -> None:
        """Have Blender stand ready to preview edits of a shot that a person looks at; raises as ``render``."""
        with self._call() as run:
            self._refuse_unmade()
            [shot] = shots_named(run.graph, [name])
            bring_scene_up_to_date(run, shot.scene_id)
            rehearse(run.in_front(), shot)

    def moment(self, name: str, frame: int | None = None) -> tuple[Path, int]:
        """Return what a shot's scene looks like at one moment as glTF, and that moment; raises as ``render``.

        Cameras need not be set, so that people and things are seen where an edit put them before the cameras follow.

        Args:
            name: The shot, such as ``SC010_SH020``.
            frame: From its start; the one that the board shows if not given.
        """
        with self._call() as run:
            self._refuse_unmade()
            [shot] = shots_named(run.graph, [name])
            bring_scene_up_to_date(run, shot.scene_id)
            rehearse(front := run.in_front(), shot)
            return moment_of(front, run.graph.shot(shot.scene_id, shot.shot_id), frame)

    def asset_view(self, asset: Asset, kind: Literal["png", "glb"]) -> Path:
        """Return a person or a thing, or a candidate for one, as a small picture or as glTF; each is made once."""
        with self._call() as run:
            return view_of(run, asset, kind)

    def built_asset(self, asset_id: str) -> Asset:
        """Return a person or a thing of the story, built if an edit changed it; raises as ``render``."""
        with self._call() as run:
            return built_asset(run, asset_id)

    def candidates(self, asset_id: str, words: str = "") -> list[Asset]:
        """Return what a thing of the story could be made from instead, best first: from the library and all folders.

        Args:
            asset_id: The thing.
            words: What is looked for; what the script says of it if empty.
        """
        with self._call() as run:
            return candidates_for(run, asset_id, words)

    def offers(self, asset_id: str, words: str = "") -> OfferedModels:
        """Return what the catalogues of services offer for a thing so far; nothing is fetched, and none waited for.

        Args:
            asset_id: The thing.
            words: What is looked for; what the script says of it if empty.
        """
        with self._call() as run:
            return offered_models(run, asset_id, words)

    def offer_picture(self, key: str) -> Path | None:
        """Return the picture of a model that ``offers`` told, asked for once; None where there is none.

        Args:
            key: Of the model.

        Raises:
            InputError: It is not offered any more.
        """
        with self._call() as run:
            return picture_of_offer(run, key)

    def library_pictures(self, kind: PictureKind, words: str = "") -> list[LibraryEntry]:
        """Return the surfaces or the panoramas of the user's library that this story may use, the newest first.

        Args:
            kind: What is wanted.
            words: All of them are in name, tags, author or licence; empty for all.

        Raises:
            InputError: The library cannot be read.
        """
        with self._call() as run:
            return library_pictures(run, kind, words)

    def draw_library_picture(self, digest: str) -> None:
        """Draw the picture of a model of the user's library, and keep it there.

        Args:
            digest: Of the entry.

        Raises:
            InputError: It is gone or damaged, or no model.
            EngineError: It cannot be read.
        """
        with self._call() as run:
            draw_library_picture(run, digest)

    @property
    def catalogues(self) -> tuple[str, ...]:
        """Names of the services that offer models, textures and panoramas."""
        return tuple(source.name for source in catalogues_of(self._sources))

    @property
    def own_motions(self) -> dict[str, str]:
        """The user's motion clips that edits can name, with what each shows."""
        return offered_clips(self.graph, self._settings.motions)

    def stale_frames(self) -> list[str]:
        """Return the names of the shots whose frames do not show the story as it is; raises as ``render``."""
        with self._filming() as run:
            return undrawn_shots(run)

    def check(self) -> Inspection:
        """Inspect a finished project: layout, framing, continuity, collisions, people in frame.

        Raises:
            InputError: A project that is only planned, or that was stopped before its cameras were set.
            Cancelled: ``cancel`` was called.
        """
        with self._call() as run:
            self._refuse_unmade()
            items = (*run.graph.scenes, *run.graph.shots)
            if any(item.stale for item in items) or any(shot.camera is None for shot in run.graph.cut):
                mend = "run `storyblender render` first: it goes on where it was stopped"
                raise InputError("has shots that are not up to date", mend=mend, path=self.folder)
            bring_up_to_date(run)
            reviews = review_frames(run, drawn_shots(run))
            report = inspect(
                with_cuts_judged(run), run.engine, list(run.packs.values()), reviews, partial(run.progress, "check")
            )
            return report.with_story([name for name in story_files(run.graph) if run.outputs.changed(name)])

    def takes(self, shot: str) -> dict[int, Path]:
        """Return the pictures of a shot's takes that are drawn, by number; that of the film is in ``frames``.

        Raises:
            InputError: No such shot, or a project that is only planned.
        """
        with self._call() as run:
            [found] = shots_named(run.graph, [shot])
            self._refuse_unmade()
            bring_up_to_date(run)
            names = pictures_of_takes(run, run.graph.shot(found.scene_id, found.shot_id))
            return {number: self.folder / name for number, name in names.items() if run.outputs.whole(name)}

    def keep_sheet(self, name: str, pictures: Mapping[str, Path]) -> str:
        """Write pictures side by side into the project, and return the file's name.

        Args:
            name: A JPEG.
            pictures: By what is written under each; at least one.
        """
        with self._call() as run:
            with run.delivering(name) as part:
                write_contact_sheet(pictures, part)
            return name

    def why(self, shot: str) -> ShotReasons:
        """Return why a shot is as it is: who decided what, how it was judged, which words it stands on.

        Raises InputError if there is no such shot.
        """
        from storyblender.pipeline.shot_reasons import shot_reasons

        with self._call() as run:
            [found] = shots_named(run.graph, [shot])
            return shot_reasons(run, found)

    def evaluate(self) -> list[FrameReview]:
        """Return what the Frame Critic finds in every frame of a finished project; raises as ``render``."""
        with self._filming() as run:
            shoot_frames(run, run.graph.cut)
            return list(review_frames(run, run.graph.cut).values())

"""The shot breakdown: cuts a reading into shots and lays out the Continuity Memory Graph (paper, section 3.2)."""

from __future__ import annotations

from collections.abc import Collection

from storyblender.agents.director.assembly import Assembly
from storyblender.agents.director.coverage import Coverage
from storyblender.agents.director.cutting import alternate_speakers, avoid_jump_cuts, push_in_on_long_speeches
from storyblender.agents.director.directions import camera_notes_by_unit
from storyblender.agents.director.draft import ShotDraft
from storyblender.agents.director.economy import economise
from storyblender.agents.director.extras import expand_groups
from storyblender.agents.director.fitted_parts import FittedParts
from storyblender.agents.director.reading import Reading
from storyblender.agents.director.reading_passes import copy_shared_things, use_directed_motions
from storyblender.agents.director.settings import DirectorSettings
from storyblender.agents.director.shot_details import ScriptFlags, ShotDetails
from storyblender.agents.director.story_assets import StoryAssets
from storyblender.agents.director.wording import one_line
from storyblender.agents.director.writing import add_writing_changes
from storyblender.memory.camera_words import listed
from storyblender.memory.graph import Storyboard


def storyboard(reading: Reading, settings: DirectorSettings | None = None) -> Storyboard:
    """Return the storyboard of a reading.

    Every unit of the script is covered by one shot, or by the two that share a long speech, in the order of the script.
    Directions written in the script are always obeyed.

    Args:
        reading: The reading of the script.
        settings: How finely to cut; None for the defaults.
    """
    settings = settings or DirectorSettings()
    reading = add_writing_changes(copy_shared_things(expand_groups(use_directed_motions(reading))))
    fitted = FittedParts.of(reading)
    reading = fitted.rewritten(reading)
    story = StoryAssets(reading, fitted.whole)
    summary = _summary(reading, story)
    assembly = Assembly(reading, story, summary)
    coverage = Coverage(reading)
    notes, flags = camera_notes_by_unit(reading), ScriptFlags(reading.flags)
    units_of: dict[int, list[int]] = {}
    for number, unit in enumerate(reading.units):
        units_of.setdefault(unit.scene, []).append(number)
    outline, details, shots = [], [], []
    for index, scene in enumerate(reading.scenes):
        numbers = units_of.get(index, [])
        units = [reading.units[number] for number in numbers]
        own_notes = {place: notes[number] for place, number in enumerate(numbers) if number in notes}
        drafts = cut(coverage.shots(scene, units, own_notes), coverage.names.people, reading.screenplay.text, settings)
        outline.append(assembly.scene_outline(scene, drafts))
        details.append(assembly.scene_context(scene, units, outline[-1]))
        shots += ShotDetails(reading.screenplay.text, story, details[-1], units, flags).write(drafts, settings.fps)
    return Storyboard(
        story_summary=summary,
        age=reading.age,
        storyboard_outline=tuple(outline),
        asset_sheet=assembly.asset_sheet(),
        scene_details=tuple(details),
        shot_details=tuple(shots),
    )


def cut(drafts: list[ShotDraft], people: Collection[str], text: str, settings: DirectorSettings) -> list[ShotDraft]:
    """Return the final cut of a scene: within its budget, alternating between speakers, without jump cuts.

    Args:
        drafts: Full coverage of the scene.
        people: Ids of people, to tell faces from things in a focus.
        text: The script.
        settings: How finely to cut.
    """
    kept = economise(drafts, people, text, settings)
    alternate_speakers(kept)
    avoid_jump_cuts(kept)
    push_in_on_long_speeches(kept, text)
    return kept


def _summary(reading: Reading, story: StoryAssets) -> str:
    """Return the writer's own synopses, or the title, the cast and the first sentence."""
    synopses = [one_line(element.text) for element in reading.screenplay.elements if element.kind == "synopsis"]
    if synopses:
        return " ".join(synopses[:6])
    title = one_line(reading.screenplay.title)
    cast = listed([story.names[person.id] for person in story.people[:5] if person.id in story.actors])
    first = next((one_line(unit.text) for unit in reading.units if unit.kind == "action"), "")
    places = len({scene.place for scene in reading.scenes})
    opening = f"{title}: " if title else ""
    return f"{opening}{cast or 'a story'}, in {places} place{'s' if places != 1 else ''}. {first}".strip()

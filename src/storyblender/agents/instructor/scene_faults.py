"""What cannot be of an edit of a scene: said to who made it, before the dispatcher refuses it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from storyblender.agents.instructor.scene_view import SceneNow
from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import kind_named, prop_named
from storyblender.catalog.sets import SETS
from storyblender.catalog.sets.finishes import FINISHES
from storyblender.memory.edits import AssetEdit, Edit, LayoutEdit, LightEdit, PlaceEdit, SetEdit
from storyblender.memory.scene_decision import SetDecision
from storyblender.memory.texture import Texture
from storyblender.reflection import UNUSABLE, Fault


def scene_faults(edit: Edit, scenes: Sequence[SceneNow]) -> Iterator[Fault]:
    """Yield what is wrong with an edit of a scene: the scene itself, or what the catalogue does not have.

    Args:
        edit: Any.
        scenes: Those that the words are about.
    """
    if not isinstance(edit, LightEdit | SetEdit | LayoutEdit | AssetEdit | PlaceEdit):
        return
    named = (edit.scene or "").upper().partition("_")[0]
    scene = next((each for each in scenes if each.name == named), None)
    if edit.scene is not None and scene is None:
        yield _fault(edit.scene, f"{edit.scene} is not among the scenes that were named")
    elif isinstance(edit, SetEdit) and scene is not None:
        yield from _set_faults(edit.decision, scene)
    elif isinstance(edit, AssetEdit):
        yield from _asset_faults(edit, scene)


def _set_faults(decision: SetDecision, scene: SceneNow) -> Iterator[Fault]:
    kit = SETS.get(decision.kit or scene.kit)
    if decision.kit is not None and (kit is None or kit.indoor != scene.indoor):
        yield _fault(decision.kit, f"{decision.kit!r} is no kit for this scene; take one of `kits`")
    for option in decision.options:
        if kit is not None and option not in kit.options:
            yield _fault(option, f"{kit.key} has no option {option!r}; it has: {', '.join(kit.options) or 'none'}")
    for surface in ("walls", "ground"):
        finish = getattr(decision, surface)
        if finish is not None and finish not in FINISHES and finish not in MATERIALS:
            yield _fault(finish, f"there is no material {finish!r}; take one of `materials`")
    if isinstance(decision.wall_texture, Texture) or isinstance(decision.ground_texture, Texture):
        yield _fault("texture", "pictures of a surface are taken in by the person who has the files")
    if decision.furniture:
        yield _fault("furniture", "furniture is changed by edits of kind `asset`")


def _asset_faults(edit: AssetEdit, scene: SceneNow | None) -> Iterator[Fault]:
    if edit.model is not None and edit.model not in PROPS and prop_named(edit.model) is None:
        yield _fault(edit.model, f"the library has no {edit.model!r}; take one of `props`, with a colour if you like")
    if edit.thing is None or scene is None:
        return
    kinds = {*scene.furniture.values(), *scene.things.values()}
    if edit.thing not in {*scene.things, *scene.furniture} and kind_named(edit.thing.replace("_", " ")) not in kinds:
        yield _fault(edit.thing, f"there is no {edit.thing!r} in {scene.name}; take one of its `things` or `furniture`")


def _fault(subject: str, message: str) -> Fault:
    return Fault(kind="scene", subject=subject, message=message, severity=UNUSABLE)

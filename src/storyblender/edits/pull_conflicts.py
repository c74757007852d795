"""What was changed both in Blender and in the project: it waits in the project until a person chooses."""

from __future__ import annotations

from collections.abc import Sequence

from pydantic import TypeAdapter, ValidationError

from storyblender.edits.blend_change import BlendChange
from storyblender.memory.base import Frozen
from storyblender.memory.blend_values import NodeValues
from storyblender.memory.edits import Edit
from storyblender.project import Project

WAITING = "blender_conflicts.json"
"""File of the project with the conflicts that nobody has decided."""


class PullConflict(Frozen):
    """A change in Blender of what was changed in the project as well since the file was written."""

    id: str
    """Names it, as long as it waits: ``SC010_SH020.lens``."""
    words: str
    """What was done in Blender."""
    project: tuple[str, ...]
    """What was done in the project."""
    compiled: str = ""
    """What it was when the file was written, where the words do not tell."""
    saved: str = ""
    """What it is in Blender."""
    edits: tuple[Edit, ...]
    """What takes Blender's side."""

    @property
    def sentence(self) -> str:
        """Both sides, as a person reads them."""
        return f"{self.words}; in the project: {'; '.join(self.project)}"


_CONFLICTS: TypeAdapter[tuple[PullConflict, ...]] = TypeAdapter(tuple[PullConflict, ...])


def conflict_of(change: BlendChange, edits: Sequence[Edit], project: Sequence[str]) -> PullConflict:
    """Return a change that conflicts with the project.

    Args:
        change: In Blender.
        edits: That make it.
        project: What was done in the project, one sentence each.
    """
    where = "" if change.subject.startswith(change.scene) else f"{change.scene}."
    return PullConflict(
        id="_".join(f"{where}{change.subject}.{change.kind}".split()),
        words=change.words, project=tuple(project), edits=tuple(edits),
        compiled=change.compiled or _told(change, change.before), saved=change.saved or _told(change, change.after),
    )  # fmt: skip


def _told(change: BlendChange, node: NodeValues | None) -> str:
    """Return the value of an object that a change is about, in short; empty where there is none."""
    if node is None:
        return ""
    camera = node.camera
    match change.kind:
        case "lens" if camera is not None:
            return f"{camera.poses[0].lens:g} mm"
        case "aperture" if camera is not None:
            return f"f/{camera.f_number:g}" if camera.blurs else "no depth of field"
        case "lamp" if node.lamp is not None:
            return f"{node.lamp.power:g} W"
        case "moved" | "turned" | "scaled":
            return f"at {', '.join(f'{each:.2f}' for each in node.location)}, {node.rotation[2]:.0f} degrees"
        case _:
            return ""


def waiting(project: Project) -> tuple[PullConflict, ...]:
    """Return the conflicts of a project that nobody has decided."""
    try:
        return _CONFLICTS.validate_json(project.path(WAITING).read_bytes())
    except (OSError, ValidationError):
        return ()


def let_wait(project: Project, conflicts: Sequence[PullConflict]) -> None:
    """Keep the conflicts that nobody has decided; a newer one of the same name takes the place of an older one."""
    newest = tuple({conflict.id: conflict for conflict in conflicts}.values())
    if newest or project.path(WAITING).exists():
        project.files.write(WAITING, _CONFLICTS.dump_json(newest, indent=1))

"""A second crew: it answers each view with the draft accepted for it in an earlier run, and knows no rules."""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

from storyblender.crew import Crew
from storyblender.project import DRAFTS, TRACE
from storyblender.reflection import Critique, Role, view_digest


@dataclass(frozen=True)
class RecordedPolicy:
    """Answers from a record.

    Attributes:
        role: Whose drafts they are.
        drafts: JSON by digest of the view.
    """

    role: Role[..., Any, Any]
    drafts: Mapping[str, str]

    def propose(self, view: object) -> object:
        """Return the draft that was accepted for this very view. Raises KeyError where there was none."""
        return self.role.drafts.read(self.drafts[view_digest(view)], view)

    def refine(self, draft: object, critique: Critique, view: object) -> object:
        """Return the draft: nobody is there to better it."""
        return draft


def recorded_crew(crew: Crew, folder: Path) -> Crew:
    """Return a crew with its own critics and the drafts of a project in place of its policies.

    Args:
        crew: Whose projections and critics stay.
        folder: A project that was made.
    """
    texts = {line["digest"]: line["draft"] for line in map(json.loads, (folder / DRAFTS).read_text().splitlines())}
    accepted: dict[str, dict[str, str]] = defaultdict(dict)
    for event in map(json.loads, (folder / TRACE).read_text().splitlines()):
        if event["kind"] == "accept":
            accepted[event["role"]][event["view"]] = texts[event["draft"]]

    def recorded(role: Role[..., Any, Any]) -> Role[..., Any, Any]:
        return replace(role, policies=(RecordedPolicy(role, accepted[role.name]),))

    roles = {field.name: getattr(crew, field.name) for field in fields(crew)}
    operator = roles.pop("camera_operator")
    return Crew(
        **{name: recorded(role) for name, role in roles.items()},
        camera_operator=lambda viewfinder: recorded(operator(viewfinder)),
    )

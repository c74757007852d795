"""Which services assets may come from, as ``--services`` says it.

``poly_haven`` · ``poly_haven,sketchfab`` · ``openai:gpt-image-1,meshy`` · ``hunyuan3d@http://127.0.0.1:8081``
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Final, Literal, get_args

ServiceName = Literal["poly_haven", "sketchfab", "gemini", "openai", "hunyuan3d", "trellis", "meshy"]
"""Catalogues of assets, then image models, then what makes a model of an image; ``meshy`` also rigs and animates."""
MAKERS: Final[frozenset[str]] = frozenset(("hunyuan3d", "trellis", "meshy"))
"""Those that make models of pictures: such a model is of no size."""
LicenceFilter = Literal["any", "commercial", "free"]
"""Which licences an asset from outside may have: any that lets it be used, those for commercial use too, only works
given to the public domain."""

ServiceLimit = Literal["dollars", "megabytes", "minutes"]
SERVICE_LIMITS: Final[dict[ServiceLimit, float]] = {"dollars": 5, "megabytes": 500, "minutes": 30}
"""The most that a run spends on services in all: US dollars, downloads, waiting for what they make."""

_CHOICE = re.compile(r"([a-z0-9_]+)(?::([^@\s]+))?(?:@(https?://[^\s@?#]+))?")


@dataclass(frozen=True)
class ServiceChoice:
    """A service that a run may ask.

    Attributes:
        name: Of the service.
        model: Which of its models; empty for the usual one.
        address: URL of the server, if it is not the service's own. It has no password or key in it, because a project
            remembers it.
    """

    name: ServiceName
    model: str = ""
    address: str = ""


def services_in(setting: str) -> tuple[ServiceChoice, ...]:
    """Return the services that a run may ask, in the order in which they are preferred.

    Args:
        setting: As ``--services`` has it: ``NAME``, ``NAME:MODEL`` or ``NAME@ADDRESS``, with commas.

    Raises:
        ValueError: It names no such service, or one twice.
    """
    choices = [_choice(part) for each in setting.split(",") if (part := each.strip())]
    names = [choice.name for choice in choices]
    if twice := next((name for name in names if names.count(name) > 1), None):
        raise ValueError(f"the service {twice} is named twice")
    return tuple(choices)


def _choice(text: str) -> ServiceChoice:
    """Return a service as it is written. Raises ValueError."""
    found = _CHOICE.fullmatch(text)
    name = next((each for each in get_args(ServiceName) if found is not None and each == found[1]), None)
    if found is None or name is None:
        raise ValueError(f"there is no service {text!r}; it is one of {', '.join(get_args(ServiceName))}")
    return ServiceChoice(name, found[2] or "", found[3] or "")

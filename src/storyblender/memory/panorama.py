"""A user's high-dynamic-range panorama: what the graph knows of it, and how a light plan uses it."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from storyblender.memory.asset_sheet import Provenance
from storyblender.memory.base import Digest, Frozen, Vec3

PANORAMAS = "assets"
"""Folder of the panoramas that the engine reads, each named by its digest."""
Irradiance = Annotated[tuple[Vec3, ...], Field(min_length=9, max_length=9)]
"""Nine spherical-harmonics coefficients of irradiance / pi, each red, green, blue (``look.irradiance``)."""


class Panorama(Frozen):
    """A panorama that is offered to the Lighting Arranger."""

    provenance: Provenance
    irradiance: Irradiance
    """In units of the picture, which looks along +X in its middle."""
    sun: Vec3 | None = None
    """Unit vector to its sun, in its own frame; None where it has none, as under clouds."""


class PanoramaLight(Frozen):
    """A panorama in a light plan, in the place of the light that the gradient sky gives."""

    digest: Digest
    """SHA-256 of the user's file."""
    yaw: float = Field(default=0.0, ge=-360, le=360)
    """Degrees that it is turned by about Z, counter-clockwise from above."""
    strength: float = Field(ge=0, le=1e9)
    """Factor on the picture where light is traced."""
    irradiance: Irradiance
    """In the world, at the plan's level: the light by normal where light is not traced."""

    @property
    def file(self) -> str:
        """Path of the prepared picture in the project."""
        return panorama_file(self.digest)

    def scaled(self, gain: float) -> PanoramaLight:
        """Return it ``gain`` times as bright."""
        coefficients = tuple((red * gain, green * gain, blue * gain) for red, green, blue in self.irradiance)
        return self.model_copy(update={"strength": self.strength * gain, "irradiance": coefficients})


def panorama_file(digest: str) -> str:
    """Return the path, in a project, of the prepared picture of the user's file with this SHA-256."""
    return f"{PANORAMAS}/{digest[:16]}.hdr"

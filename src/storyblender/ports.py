"""The protocols between the crew and the world outside it. Agents get ports from Studio, never adapters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from storyblender.memory.base import Frozen, Identifier
from storyblender.memory.measure import CameraView
from storyblender.memory.shot_context import CameraPose


class ViewRequest(Frozen):
    """One look through the viewfinder at one moment of one shot."""

    scene_id: int
    shot_id: int
    frame: int
    """From the start of the shot."""
    pose: CameraPose
    sensor_width: float = 36.0
    hidden_node_ids: tuple[Identifier, ...] = ()
    focus_ids: tuple[str, ...] = ()
    """node_ids the shot is about."""


class Viewfinder(Protocol):
    """The engine's eye: renders an ID mask and returns what is seen, as numbers."""

    def look(self, requests: Sequence[ViewRequest]) -> list[CameraView]:
        """Return one view per request, in order."""
        ...


class Embedder(Protocol):
    """Turns texts into vectors whose dot product is likeness of meaning."""

    def embed(self, texts: Sequence[str]) -> NDArray[np.float32]:
        """Return (n, d) unit vectors."""
        ...

"""The protocols between the crew and the world outside it. Agents get ports from Studio, never adapters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from storyblender.memory.measure import CameraView, ViewRequest

__all__ = ["Embedder", "ViewRequest", "Viewfinder"]


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

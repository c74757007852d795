"""Which services failed lately, so that an outage is told once, whoever meets it."""

from __future__ import annotations

import threading
import time
from typing import Final

QUIET: Final = 300.0
"""Seconds after which a service that fails is told of again."""


class Outages:
    """The outages that a run has met. Safe to use from several threads."""

    def __init__(self) -> None:
        self._told: dict[str, float] = {}
        self._why: dict[str, str] = {}
        self._lock = threading.Lock()

    @property
    def met(self) -> dict[str, str]:
        """Why services failed, as they did first, by their names."""
        with self._lock:
            return dict(self._why)

    def is_news(self, service: str, why: str) -> bool:
        """Note that a service failed, and return whether that is still to be told.

        Args:
            service: Its name.
            why: The sentence of its failure.
        """
        now = time.monotonic()
        with self._lock:
            self._why.setdefault(service, why)
            if now - self._told.get(service, -QUIET) < QUIET:
                return False
            self._told[service] = now
            return True

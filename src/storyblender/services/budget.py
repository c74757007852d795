"""What a run may spend on services in all, and what it has spent so far."""

from __future__ import annotations

import threading
from collections.abc import Mapping

from storyblender.errors import ServiceFailure
from storyblender.service_setting import SERVICE_LIMITS, ServiceLimit


class ServiceBudget:
    """US dollars, megabytes of downloads and minutes of waiting, shared by all services and threads of a run.

    Args:
        limits: The most of each, where it is not that of ``SERVICE_LIMITS``.
    """

    def __init__(self, limits: Mapping[ServiceLimit, float] | None = None) -> None:
        self._limits = {**SERVICE_LIMITS, **(limits or {})}
        self._spent: dict[ServiceLimit, float] = dict.fromkeys(SERVICE_LIMITS, 0.0)
        self._lock = threading.Lock()

    def spent(self, kind: ServiceLimit) -> float:
        """Return what was used so far."""
        with self._lock:
            return self._spent[kind]

    def left(self, kind: ServiceLimit) -> float:
        """Return what may still be used, 0 or more."""
        with self._lock:
            return max(0.0, self._limits[kind] - self._spent[kind])

    def ask(self, kind: ServiceLimit, amount: float) -> None:
        """Ask whether so much may be used, without using it.

        Raises:
            ServiceFailure: It is more than what is left.
        """
        with self._lock:
            self._refuse(kind, amount)

    def spend(self, kind: ServiceLimit, amount: float) -> None:
        """Use so much, if it may be; ask before anything is paid or sent.

        Raises:
            ServiceFailure: It is more than what is left, and nothing was used.
        """
        with self._lock:
            self._refuse(kind, amount)
            self._spent[kind] += amount

    def give_back(self, kind: ServiceLimit, amount: float) -> None:
        """Take back what was used and not needed, such as the price of what was refused."""
        with self._lock:
            self._spent[kind] = max(0.0, self._spent[kind] - amount)

    def _refuse(self, kind: ServiceLimit, amount: float) -> None:
        if self._spent[kind] + amount > self._limits[kind] * (1 + 1e-9):
            mend = f"a higher `{kind}` under [service_limits] in storyblender.toml lets services go on"
            raise ServiceFailure(f"the limit of {self._limits[kind]:g} {kind} for services is reached", mend=mend)

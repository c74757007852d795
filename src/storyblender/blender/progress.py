"""Progress from inside a job: MCP's progress notifications, for a client that asked for them."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import BinaryIO

Report = Callable[[int, int], None]
"""Called with the steps of the job that are done, and their total."""


def ignore(step: int, total: int) -> None:
    """Report to nobody."""


class Progress:
    """Reports the running job's progress.

    Args:
        wire: Where messages to the client go, one a line.

    Attributes:
        token: What the client called the running job; None where it did not ask for its progress.
    """

    def __init__(self, wire: BinaryIO) -> None:
        self._wire = wire
        self.token: str | int | None = None

    def __call__(self, step: int, total: int) -> None:
        """Tell the client that so many steps of the job are done, of so many."""
        if self.token is not None:
            parameters = {"progressToken": self.token, "progress": step, "total": total}
            message = {"jsonrpc": "2.0", "method": "notifications/progress", "params": parameters}
            self._wire.write(json.dumps(message).encode() + b"\n")
            self._wire.flush()

"""Progress of a running job: MCP's progress notifications, for clients that asked for them."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import BinaryIO

Report = Callable[[int, int], None]
"""Called with the number of steps done and their total."""


def ignore(step: int, total: int) -> None:
    """Ignore that ``step`` of ``total`` steps are done: the default for jobs whose progress no client asked for."""


class Progress:
    """Sends the running job's progress to the client.

    Args:
        wire: Receives the messages, one a line.

    Attributes:
        token: The client's token of the running job; None if it did not ask for progress.
    """

    def __init__(self, wire: BinaryIO) -> None:
        self._wire = wire
        self.token: str | int | None = None

    def __call__(self, step: int, total: int) -> None:
        """Report that ``step`` of ``total`` steps are done."""
        if self.token is not None:
            parameters = {"progressToken": self.token, "progress": step, "total": total}
            message = {"jsonrpc": "2.0", "method": "notifications/progress", "params": parameters}
            self._wire.write(json.dumps(message).encode() + b"\n")
            self._wire.flush()

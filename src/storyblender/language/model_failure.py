"""Why a request to a model brought no answer, and what may help."""

from __future__ import annotations


class ModelFailure(Exception):
    """One request that failed.

    Args:
        reason: Why, one clause without any key.
        tries: How often the same request is sent in all.
        other_form: Whether asking for the answer in another form may help.
        retry_after: Seconds that the server asks to wait.
    """

    def __init__(self, reason: str, tries: int = 1, other_form: bool = False, retry_after: float = 0.0) -> None:
        super().__init__(reason)
        self.tries, self.other_form, self.retry_after = tries, other_form, retry_after

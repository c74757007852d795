"""No frame of these tests is taken again."""

from tests.no_retakes import no_retakes  # noqa: F401

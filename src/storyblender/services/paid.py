"""Requests that cost: sent once, and what came of them is either known or said to be unknown."""

from __future__ import annotations

from typing import Any

from storyblender.errors import ServiceFailure
from storyblender.services.offers import is_id
from storyblender.services.web import Web


def paid_answer(web: Web, path: str, body: Any = None, **more: Any) -> dict[str, Any]:
    """Return what a service answers to a request that costs.

    Args:
        web: HTTP with the service.
        path: Below its address.
        body: Sent as JSON, if not None.
        more: As ``Web.post`` takes them.

    Raises:
        ServiceFailure: It was refused; ``uncertain`` if it may have been done and paid all the same.
    """
    answer = web.post(path, body, paid=True, **more)
    try:
        said = answer.json
    except ServiceFailure as error:
        raise ServiceFailure(error.problem, uncertain=True) from error
    if not isinstance(said, dict):
        raise ServiceFailure(f"{web.service}: its answer is not of the form that it should have", uncertain=True)
    return said


def job_in(said: dict[str, Any], name: str, web: Web) -> str:
    """Return the id of a job in the answer to a request that costs.

    Args:
        said: The answer.
        name: Of the field.
        web: HTTP with the service.

    Raises:
        ServiceFailure: There is none, though the job may have been begun.
    """
    job = said.get(name)
    if not is_id(job):
        raise ServiceFailure(f"{web.service}: its answer has no id of a job", uncertain=True)
    return str(job)

"""What a process does that has a picture drawn and a model made of it, and that dies at one step of the ledger."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import httpx2
import tenacity

from storyblender.errors import ServiceFailure
from storyblender.library.commissions import Commissions, Wanted
from storyblender.library.shared import index
from storyblender.library.shared.entries import LibraryEntry
from storyblender.library.shared.jobs import Job, JobLedger
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.services.budget import ServiceBudget
from storyblender.services.making import ModelMaker
from storyblender.services.openai import OpenAIImages
from storyblender.services.web import Web
from tests.services.makers import SECRET, WIRES
from tests.services.site import QUICK, Site

LOADED = (httpx2, tenacity, index)
"""A process that was forked must not load these while a thread of its parent does."""
STEPS = (
    "before begin 1", "after begin 1", "after draw 1", "after add 1", "after finished 1", "after begin 2",
    "after send 2", "after submitted 2", "after poll 2", "after fetch 2", "after add 2", "after finished 2",
)  # fmt: skip
"""What has just happened, and to what: the picture is 1, the model 2."""


def pay(address: str, kind: str, step: str = "") -> str:
    """Have a picture drawn and a model made of it, and return what came of it.

    Args:
        address: Of the site with the services.
        kind: Of the maker's wire.
        step: When to die; empty for never.
    """
    patience = replace(QUICK, silence=10, answer=20)
    library, budget = SharedLibrary.open(), ServiceBudget()
    draws = OpenAIImages(Web("openai", address, {"authorization": SECRET}, budget, patience))
    headers = {"authorization": f"Bearer {SECRET}"}
    maker = WIRES[kind](Site()).adapter(Web(kind, address, headers, budget, patience))
    _die_at(step, draws, maker, library)
    commissions = Commissions(library, budget)
    wanted = Wanted("samovar", "a samovar")
    (drawn,) = commissions.pictures(draws, [wanted]).values()
    if isinstance(drawn, ServiceFailure):
        return f"no picture: {drawn}"
    try:
        made = commissions.model(maker, drawn)
        while isinstance(made, Job):
            looked = commissions.look(maker, made, wanted)
            made = looked if isinstance(looked, LibraryEntry) else made
            time.sleep(0.01)
    except ServiceFailure as error:
        return f"no model: {error}"
    return f"made {made.digest}"


def _die_at(step: str, draws: OpenAIImages, maker: ModelMaker, library: SharedLibrary) -> None:
    """Arrange to be killed, as by ``kill -9``, when a step has happened."""
    count = dict[str, int]()

    def after(owner: Any, name: str, told: str) -> None:
        real: Callable[..., Any] = getattr(owner, name)

        def passed(*args: Any, **more: Any) -> Any:
            count[told] = count.get(told, 0) + 1
            number = count[told] if told in ("begin", "add", "finished") else {"draw": 1}.get(told, 2)
            if step == f"before {told} {number}":
                os.kill(os.getpid(), signal.SIGKILL)
            result = real(*args, **more)
            if step == f"after {told} {number}":
                os.kill(os.getpid(), signal.SIGKILL)
            return result

        setattr(owner, name, passed)

    for name in ("begin", "submitted", "finished"):
        after(JobLedger, name, name)
    after(library, "add", "add")
    after(draws, "draw", "draw")
    after(maker, "begin", "send")
    after(maker, "poll", "poll")
    after(maker, "fetch", "fetch")

"""Every provider against every way in which a service answers or fails."""

from __future__ import annotations

import base64
import json
import threading
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest
from pydantic import BaseModel

from storyblender.agents.asking import Asker
from storyblender.errors import Cancelled, NoAnswer
from storyblender.language.budget import Budget
from storyblender.memory.base import Frozen
from storyblender.reflection import Critique, Role, Typed, reflect
from storyblender.trace import Event
from tests.wire.conftest import PNG, SCHEMA, request_of
from tests.wire.loopback import Act, Cut, Fail, Late, Raw, Say, serving
from tests.wire.wires import SERVICES, Service

every_service = pytest.mark.parametrize("service", SERVICES.values(), ids=SERVICES)
Make = Callable[..., Any]
GOOD = Say('{"number": 3}')
NATIVE, TOOL = ("native",), ("native", "tool")


class Count(BaseModel):
    """A number."""

    number: int


@every_service
@pytest.mark.parametrize("refused", [(), NATIVE, TOOL], ids=["none", "native", "native and tool"])
def test_the_form_falls_where_the_server_refuses_it_and_stays_there(
    service: Service, refused: Sequence[str], provider: Make
) -> None:
    form = next(form for form in service.forms if form not in refused)
    with serving(service.wire, Fail(400, "no such form", tuple(refused)), GOOD) as server:
        asks = provider(service, server)
        assert asks.answer(request_of()) == asks.answer(request_of()) == GOOD.text
    expected = [*(each for each in service.forms if each in refused), form, form]
    assert server.forms == expected


@every_service
@pytest.mark.parametrize("refused", [(), NATIVE, TOOL], ids=["native", "tool", "prompted"])
def test_the_request_arrives_whole_in_every_form(service: Service, refused: Sequence[str], provider: Make) -> None:
    with serving(service.wire, Fail(400, "no such form", tuple(refused)), GOOD) as server:
        provider(service, server).answer(request_of(previous='{"number": 2}', feedback=("one door is missing",)))
    last = server.asked[-1]
    for words in ("Count the doors.", "MARKED WORDS", "one door is missing"):
        assert words in last.words
    (picture,) = last.pictures
    assert "Picture `plan`:" in last.words
    data = picture[1].replace("-", "+").replace("_", "/")
    assert (picture[0], base64.b64decode(data + "=" * (-len(data) % 4))) == ("image/png", PNG)


@every_service
@pytest.mark.parametrize(
    "answer",
    [
        Say('```json\n{"number": 3}\n```'),
        Say('{"num', "length"),
        Say(SCHEMA),
        Say('{"number": "three"}'),
        Say("I would rather not."),
    ],
    ids=["fenced", "truncated", "schema echoed", "wrong type", "words"],
)
def test_a_wrong_answer_reaches_the_asker_as_it_was_given_and_is_repaired(
    service: Service, answer: Say, provider: Make
) -> None:
    with serving(service.wire, Fail(400, "no", TOOL), answer, GOOD) as server:
        asks = provider(service, server)
        assert asks.answer(request_of()) == answer.text
    with serving(service.wire, answer, GOOD) as server:
        asker = Asker(provider(service, server), "director", Count)
        assert asker.ask("SC010", {"walls": 4}).number == 3


@every_service
def test_a_model_that_talks_where_it_is_given_a_tool_is_asked_in_words(service: Service, provider: Make) -> None:
    talk = Say("Let me see: there are three.", calls=False)
    with serving(service.wire, Fail(400, "no such form", NATIVE), talk, GOOD) as server:
        assert provider(service, server).answer(request_of()) == GOOD.text
    assert server.forms == list(service.forms)
    with serving(service.wire, Fail(400, "no such form", NATIVE), Say(GOOD.text, calls=False)) as server:
        assert provider(service, server).answer(request_of()) == GOOD.text, "an answer without a call is one"


def test_words_alone_are_sent_as_text(provider: Make) -> None:
    """Chat templates of small servers join texts, and fail where there is a list."""
    service = SERVICES["openai_chat"]
    with serving(service.wire, GOOD) as server:
        provider(service, server).answer(request_of(pictures=()))
    assert isinstance(server.bodies[0]["messages"][-1]["content"], str)


def _hurry(act: Act) -> dict[str, float]:
    """Return how long to wait for a server: not long for one that never answers."""
    return {"timeout": 0.5} if isinstance(act, Late) else {}


TRANSIENT: dict[str, Act] = {
    "429": Fail(429, "slow down", headers=(("retry-after", "7"),)), "500": Fail(500, "oh"), "502": Fail(502, "oh"),
    "503": Fail(503, "oh"), "529": Fail(529, "oh"), "cut": Cut(), "timeout": Late(30), "empty": Say(""),
    "not JSON": Raw(b"<html>", "text/html"), "not of the wire": Raw(b'{"what": 1}'), "a list": Raw(b"[1]"),
    "oversize": Say("x" * 5_100_000),
}  # fmt: skip


@every_service
@pytest.mark.parametrize("act", TRANSIENT.values(), ids=TRANSIENT)
def test_what_may_pass_is_tried_again_and_answered(service: Service, act: Act, provider: Make) -> None:
    with serving(service.wire, act, GOOD) as server:
        assert provider(service, server, **_hurry(act)).answer(request_of()) == GOOD.text
    assert server.forms == [service.forms[0]] * 2, "it is asked in the same form"


@pytest.mark.parametrize("kind", ["overloaded_error", "api_error", "rate_limit_error"])
def test_an_error_inside_a_stream_is_tried_again(kind: str, provider: Make) -> None:
    error = {"type": "error", "error": {"type": kind, "message": "later"}}
    act = Raw(f"event: error\ndata: {json.dumps(error)}\n\n".encode(), "text/event-stream")
    service = SERVICES["anthropic"]
    with serving(service.wire, act, GOOD) as server:
        assert provider(service, server).answer(request_of()) == GOOD.text
    assert server.forms == ["native"] * 2


REFUSED: dict[str, tuple[Act, str]] = {
    "400": (Fail(400, "what is that"), "refuses the request"), "401": (Fail(401, "who are you"), "not accept the key"),
    "403": (Fail(403, "not you"), "not accept the key"), "404": (Fail(404, "where"), "no such model"),
    "refusal": (Say("I must not", "refusal"), "refuses to answer"),
}  # fmt: skip
LASTING = REFUSED | {
    "429": (Fail(429, "slow"), "too often"), "500": (Fail(500, "oh"), "server failed"), "cut": (Cut(), "connection"),
    "timeout": (Late(30), "no answer in 0.5 seconds"), "empty": (Say(""), ""),
    "not JSON": (Raw(b"<html>", "text/html"), "cannot be read"), "a list": (Raw(b"[1]"), ""),
    "oversize": (Say("x" * 5_100_000), "too long"),
}  # fmt: skip


@every_service
@pytest.mark.parametrize(("act", "words"), LASTING.values(), ids=LASTING)
def test_what_lasts_ends_in_one_clear_sentence_and_rules_take_over(
    service: Service, act: Act, words: str, provider: Make
) -> None:
    with serving(service.wire, act) as server:
        asks = provider(service, server, **_hurry(act))
        with pytest.raises(NoAnswer) as caught:
            asks.answer(request_of())
    said = str(caught.value)
    assert words in said and said.startswith(f"{service.provider}:{service.model} did not answer: ")
    assert "\n" not in said and len(said) < 400 and "pydantic" not in said
    assert len(server.asked) <= 4 * len(service.forms)


@every_service
def test_a_model_that_keeps_failing_is_not_asked_for_ever(service: Service, provider: Make) -> None:
    with serving(service.wire, Fail(401, "who are you")) as server:
        asks = provider(service, server)
        for _ in range(6):
            with pytest.raises(NoAnswer, match="key"):
                asks.answer(request_of())
    assert len(server.asked) == 3


@every_service
def test_nobody_there_is_no_answer(service: Service, provider: Make) -> None:
    with serving(service.wire, GOOD) as server:
        pass
    with pytest.raises(NoAnswer, match="connection failed"):
        provider(service, server).answer(request_of())


@pytest.mark.parametrize(
    ("limits", "answered"), [({"requests": 2}, 2), ({"tokens": 45}, 2), ({"dollars": 0.0002}, 2), ({}, 5)], ids=str
)
def test_a_limit_of_the_run_ends_in_no_answer(limits: dict[Any, float], answered: int, provider: Make) -> None:
    service, budget, given = SERVICES["openai_chat"], Budget(limits), 0
    with serving(service.wire, GOOD) as server:
        for _ in range(5):
            try:
                provider(service, server, budget).answer(request_of())
                given += 1
            except NoAnswer as error:
                assert f"the limit of {next(iter(limits.values())):g} {next(iter(limits))}" in str(error)
    assert given == len(server.asked) == answered


def test_every_try_counts_as_a_request(provider: Make) -> None:
    service, budget = SERVICES["openai_chat"], Budget({"requests": 3})
    with serving(service.wire, Fail(500, "oh")) as server, pytest.raises(NoAnswer, match="limit of 3 requests"):
        provider(service, server, budget).answer(request_of())
    assert len(server.asked) == 3


@every_service
def test_a_cancelled_run_does_not_wait_for_the_model(service: Service, provider: Make) -> None:
    cancelled = threading.Event()
    with serving(service.wire, Late(60)) as server:
        asks = provider(service, server, cancelled=cancelled, timeout=60.0)
        threading.Thread(target=lambda: server.arrived.wait(30) and cancelled.set()).start()
        began = time.monotonic()
        with pytest.raises(Cancelled):
            asks.answer(request_of())
    assert time.monotonic() - began < 30


def test_several_threads_ask_at_once(provider: Make) -> None:
    service = SERVICES["openai_chat"]
    with serving(service.wire, Fail(400, "no such form", NATIVE), GOOD) as server:
        asks = provider(service, server)
        with ThreadPoolExecutor(8) as threads:
            answers = list(threads.map(lambda number: asks.answer(request_of(subject=f"SC{number}")), range(24)))
    assert answers == [GOOD.text] * 24 and asks.form == "tool"


def test_the_pause_grows_to_the_longest_and_listens_to_the_server(provider: Make) -> None:
    service = SERVICES["openai_chat"]
    with serving(service.wire, Fail(429, "wait", headers=(("retry-after", "1"),)), GOOD) as server:
        asks = provider(service, server, pause=30.0)
        began = time.monotonic()
        asks.answer(request_of())
    assert 1 <= time.monotonic() - began < 10


class _Guess(Frozen):
    """What the role of this test decides."""

    number: int


class _Asks:
    """A policy that asks a model."""

    def __init__(self, asker: Asker[Count]) -> None:
        self._asker = asker

    def propose(self, view: str) -> _Guess:
        return _Guess(number=self._asker.ask(view, {}).number)

    def refine(self, draft: _Guess, critique: Critique, view: str) -> _Guess:
        return draft


class _Rules:
    """A policy that knows."""

    def propose(self, view: str) -> _Guess:
        return _Guess(number=7)

    def refine(self, draft: _Guess, critique: Critique, view: str) -> _Guess:
        return draft


class _Content:
    """A critic that accepts everything."""

    def judge(self, draft: _Guess, view: str) -> Critique:
        return Critique(score=10)


@pytest.mark.parametrize(("act", "words"), REFUSED.values(), ids=REFUSED)
def test_a_role_whose_model_fails_is_played_by_rules(act: Act, words: str, provider: Make) -> None:
    service, events = SERVICES["gemini"], list[Event]()
    with serving(service.wire, act) as server:
        policies = (_Asks(Asker(provider(service, server), "director", Count)), _Rules())
        role = Role("director", str, policies, _Content(), Typed(_Guess))
        outcome = reflect(role, "SC010", "view", events.append)
    assert outcome.draft.number == 7 and outcome.handed_over
    assert any(event.kind == "warning" and words in event.message for event in events)


NO_PICTURES = Fail(400, "this model reads text", pictures=True)


@every_service
def test_a_model_that_refuses_pictures_is_asked_in_words_alone_from_then_on(service: Service, provider: Make) -> None:
    with serving(service.wire, NO_PICTURES, GOOD) as server:
        asks = provider(service, server)
        assert [asks.answer(request_of()) for _ in range(2)] == [GOOD.text] * 2
        assert [bool(each.pictures) for each in server.asked] == [True] * len(service.forms) + [False, False]
        with pytest.raises(NoAnswer, match="does not see pictures"):
            asks.answer(request_of(pictures_needed=True))
    assert len(server.asked) == len(service.forms) + 2, "a critic who cannot see is not asked"


def test_a_critic_who_cannot_see_does_not_silence_the_model_for_others(provider: Make) -> None:
    service = SERVICES["openai_chat"]
    with serving(service.wire, NO_PICTURES, GOOD) as server:
        asks = provider(service, server)
        for _ in range(5):
            with pytest.raises(NoAnswer, match="does not see pictures"):
                asks.answer(request_of(pictures_needed=True))
        assert asks.answer(request_of()) == asks.answer(request_of(pictures=())) == GOOD.text


def test_a_model_that_refuses_everything_is_not_taken_for_blind(provider: Make) -> None:
    service = SERVICES["openai_chat"]
    with serving(service.wire, Fail(400, "no")) as server:
        asks = provider(service, server)
        with pytest.raises(NoAnswer, match="refuses the request"):
            asks.answer(request_of())
        assert not asks.blind

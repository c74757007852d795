"""The wires of the providers: how each writes a request and a response."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Final

from storyblender.crew_setting import Player
from tests.wire.loopback import Asked, Say, Wire


def _texts(value: Any) -> Iterator[str]:
    """Yield every text in a request."""
    if isinstance(value, dict):
        yield from (value["text"] for _ in (0,) if isinstance(value.get("text"), str))
        for inner in value.values():
            yield from _texts(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from _texts(inner)
    elif isinstance(value, str):
        yield value


def _asked(body: dict[str, Any], native: bool, pictures: list[tuple[str, str]]) -> Asked:
    form = "native" if native else "tool" if body.get("tools") else "prompted"
    return Asked(form, "\n".join(_texts(body)), tuple(pictures))


def _of_data_url(url: str) -> tuple[str, str]:
    kind, _, data = url.removeprefix("data:").partition(";base64,")
    return kind, data


def _as_arguments(text: str) -> dict[str, Any]:
    """Return an answer as the arguments of a call, for wires that have no text there."""
    try:
        value = json.loads(text)
    except ValueError:
        value = {"cut": text}
    return value if isinstance(value, dict) else {"value": value}


class Chat:
    """OpenAI's chat completions; Ollama, vLLM, LM Studio and llama.cpp speak it too."""

    def read(self, body: dict[str, Any]) -> Asked:
        parts = [part for each in body["messages"] if isinstance(each["content"], list) for part in each["content"]]
        pictures = [_of_data_url(part["image_url"]["url"]) for part in parts if part["type"] == "image_url"]
        return _asked(body, body.get("response_format", {}).get("type") == "json_schema", pictures)

    def write(self, say: Say, asked: Asked, body: dict[str, Any]) -> tuple[str, bytes]:
        message: dict[str, Any] = {"role": "assistant", "content": say.text, "refusal": None}
        if say.end == "refusal":
            message |= {"content": None, "refusal": say.text}
        elif asked.form == "tool" and say.calls and say.text:
            call = {"id": "call_1", "type": "function", "function": {"name": "answer", "arguments": say.text}}
            message |= {"content": None, "tool_calls": [call]}
        end = {"refusal": "stop"}.get(say.end, say.end)
        used = {"prompt_tokens": say.tokens[0], "completion_tokens": say.tokens[1], "total_tokens": sum(say.tokens)}
        choice = {"index": 0, "message": message, "finish_reason": end, "logprobs": None}
        response = {"id": "chatcmpl-1", "object": "chat.completion", "created": 1, "model": body["model"]}
        return "application/json", json.dumps({**response, "choices": [choice], "usage": used}).encode()

    def error(self, status: int, message: str) -> dict[str, Any]:
        return {"error": {"message": message, "type": "server_error", "param": None, "code": None}}


class Responses:
    """OpenAI's responses."""

    def read(self, body: dict[str, Any]) -> Asked:
        items = [item for item in body["input"] if isinstance(item.get("content"), list)]
        parts = [part for item in items for part in item["content"]]
        pictures = [_of_data_url(part["image_url"]) for part in parts if part["type"] == "input_image"]
        return _asked(body, body.get("text", {}).get("format", {}).get("type") == "json_schema", pictures)

    def write(self, say: Say, asked: Asked, body: dict[str, Any]) -> tuple[str, bytes]:
        cut = say.end == "length"
        status = "incomplete" if cut else "completed"
        if asked.form == "tool" and say.calls and say.text and say.end != "refusal":
            item: dict[str, Any] = {
                "type": "function_call", "id": "fc_1", "call_id": "call_1", "name": "answer", "arguments": say.text,
                "status": status,
            }  # fmt: skip
        else:
            part = {"type": "output_text", "text": say.text, "annotations": []}
            if say.end == "refusal":
                part = {"type": "refusal", "refusal": say.text}
            item = {"type": "message", "id": "msg_1", "role": "assistant", "status": status, "content": [part]}
        details = {"input_tokens_details": {"cached_tokens": 0}, "output_tokens_details": {"reasoning_tokens": 0}}
        response = {
            "id": "resp_1", "object": "response", "created_at": 1, "model": body["model"], "status": status,
            "output": [item], "error": None, "incomplete_details": {"reason": "max_output_tokens"} if cut else None,
            "parallel_tool_calls": True, "tool_choice": "auto", "tools": [], "instructions": None, "metadata": {},
            "temperature": 1.0, "top_p": 1.0,
            "usage": {"input_tokens": say.tokens[0], "output_tokens": say.tokens[1], "total_tokens": sum(say.tokens)}
            | details,
        }  # fmt: skip
        return "application/json", json.dumps(response).encode()

    def error(self, status: int, message: str) -> dict[str, Any]:
        return {"error": {"message": message, "type": "server_error", "param": None, "code": None}}


class Gemini:
    """Google's generateContent."""

    def read(self, body: dict[str, Any]) -> Asked:
        parts = [part for each in body["contents"] for part in each["parts"]]
        found = [part["inlineData"] for part in parts if "inlineData" in part]
        pictures = [(each.get("mimeType") or each["mime_type"], each["data"]) for each in found]
        config = body.get("generationConfig", {})
        return _asked(body, "responseJsonSchema" in config or "responseSchema" in config, pictures)

    def write(self, say: Say, asked: Asked, body: dict[str, Any]) -> tuple[str, bytes]:
        part: dict[str, Any] = {"text": say.text}
        if asked.form == "tool" and say.calls and say.text:
            part = {"functionCall": {"name": "answer", "args": _as_arguments(say.text)}}
        end = {"stop": "STOP", "length": "MAX_TOKENS", "refusal": "SAFETY"}[say.end]
        content = {"role": "model", "parts": [part] if say.text and say.end != "refusal" else []}
        used = {
            "promptTokenCount": say.tokens[0],
            "candidatesTokenCount": say.tokens[1],
            "totalTokenCount": sum(say.tokens),
        }
        candidate = {"content": content, "finishReason": end, "index": 0}
        response = {"candidates": [candidate], "usageMetadata": used, "modelVersion": "gemini-3-pro-preview"}
        return "application/json", json.dumps(response).encode()

    def error(self, status: int, message: str) -> dict[str, Any]:
        return {"error": {"code": status, "message": message, "status": "UNKNOWN"}}


class Anthropic:
    """Anthropic's messages, whole or as a stream of server-sent events."""

    def read(self, body: dict[str, Any]) -> Asked:
        parts = [part for each in body["messages"] if isinstance(each["content"], list) for part in each["content"]]
        pictures = [(part["source"]["media_type"], part["source"]["data"]) for part in parts if part["type"] == "image"]
        native = "output_format" in body or "format" in body.get("output_config", {})
        return _asked(body, native, pictures)

    def write(self, say: Say, asked: Asked, body: dict[str, Any]) -> tuple[str, bytes]:
        tool = asked.form == "tool" and say.calls and say.text and say.end != "refusal"
        end = {"stop": "tool_use" if tool else "end_turn", "length": "max_tokens", "refusal": "refusal"}[say.end]
        message: dict[str, Any] = {
            "id": "msg_1", "type": "message", "role": "assistant", "model": body["model"], "content": [],
            "stop_reason": None, "stop_sequence": None,
            "usage": {"input_tokens": say.tokens[0], "output_tokens": 1},
        }  # fmt: skip
        call = {"type": "tool_use", "id": "toolu_1", "name": "answer"}
        used = {"input_tokens": say.tokens[0], "output_tokens": say.tokens[1]}
        shown = say.text if say.end != "refusal" else ""
        if not body.get("stream"):
            whole = call | {"input": _as_arguments(say.text)} if tool else {"type": "text", "text": shown}
            content = [whole] if shown else []
            return "application/json", json.dumps(
                message | {"content": content, "stop_reason": end, "usage": used}
            ).encode()
        events: list[dict[str, Any]] = [{"type": "message_start", "message": message}]
        if shown:
            block = call | {"input": {}} if tool else {"type": "text", "text": ""}
            events.append({"type": "content_block_start", "index": 0, "content_block": block})
            for piece in (shown[: len(shown) // 2], shown[len(shown) // 2 :]):
                delta = (
                    {"type": "input_json_delta", "partial_json": piece}
                    if tool
                    else {"type": "text_delta", "text": piece}
                )
                events.append({"type": "content_block_delta", "index": 0, "delta": delta})
            events.append({"type": "content_block_stop", "index": 0})
        ended = {"stop_reason": end, "stop_sequence": None}
        events += [{"type": "message_delta", "delta": ended, "usage": used}, {"type": "message_stop"}]
        stream = "".join(f"event: {event['type']}\ndata: {json.dumps(event)}\n\n" for event in events)
        return "text/event-stream", stream.encode()

    def error(self, status: int, message: str) -> dict[str, Any]:
        return {"type": "error", "error": {"type": "api_error", "message": message}}


@dataclass(frozen=True)
class Service:
    """A provider with a model of a name that pydantic-ai knows.

    Attributes:
        provider: As the setting names it.
        model: Of the provider.
        wire: What it speaks.
        path: Of its address.
        forms: How it can be asked for the form of an answer, the best first.
    """

    provider: str
    model: str
    wire: Wire
    path: str = ""
    forms: tuple[str, ...] = ("native", "tool", "prompted")

    def player(self, address: str) -> Player:
        return Player("model", self.provider, self.model, address + self.path)


SERVICES: Final = {
    "openai_chat": Service("openai-chat", "gpt-4o", Chat(), "/v1"),
    "openai_responses": Service("openai", "gpt-5", Responses(), "/v1"),
    "gemini": Service("google", "gemini-3-pro-preview", Gemini()),
    "anthropic": Service("anthropic", "claude-opus-4-6", Anthropic()),
    "anthropic_whole": Service("anthropic", "some-claude", Anthropic(), forms=("tool", "prompted")),
    "ollama": Service("ollama", "qwen3:8b", Chat(), "/v1"),
    "vllm": Service("vllm", "some-model", Chat(), "/v1"),
}
"""By the name in the tests."""

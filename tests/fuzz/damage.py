"""Ways to damage a file, chosen by a random generator with a fixed seed: as bytes, and as JSON."""

from __future__ import annotations

import hashlib
import json
import random
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

from storyblender.memory.history import Commit

ODD: tuple[Callable[[random.Random], Any], ...] = (
    lambda rng: None,
    lambda rng: rng.choice([True, False]),
    lambda rng: rng.choice([0, -1, 1, 2**31, 2**63, 10**30, -(10**9)]),
    lambda rng: rng.choice([0.0, -0.0, 1e-300, 1e308, float("nan"), float("inf"), -float("inf"), 0.5]),
    lambda rng: rng.choice(["", " ", "\0", "x" * 5000, "../../etc/passwd", "/", "nobody", "idle", "1", "\ud7ff\u202e"]),
    lambda rng: [],
    lambda rng: {},
    lambda rng: [1] * 1000,
    lambda rng: {"x": 1},
    lambda rng: nested(rng.choice([10, 150, 400])),
)
"""Values that may stand in place of any other."""


def nested(depth: int) -> Any:
    """Return a list in a list in a list."""
    value: Any = []
    for _ in range(depth):
        value = [value]
    return value


def damage(folder: Path, rng: random.Random) -> str:
    """Damage one file of a project, or a few, and return what was done."""
    files = sorted(path for path in folder.rglob("*") if path.is_file() and path.name != ".lock")
    likely = [path for path in files if path.suffix in (".json", ".jsonl", "") and "assets" not in path.parts]
    graph, head = folder / "graph.json", folder / "history" / "HEAD"
    told: list[str] = []
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        path = rng.choice([graph, graph, graph, head, rng.choice(likely), rng.choice(likely), rng.choice(files)])
        if path.exists():
            ways = [_as_bytes, _as_json, _as_json, _as_json] if path.suffix == ".json" else [_as_bytes]
            told.append(f"{path.relative_to(folder)}: {rng.choice(ways)(path, rng)}")
    return "; ".join(told)


def _as_bytes(path: Path, rng: random.Random) -> str:
    if path.is_dir():
        return "is a folder already"
    data = bytearray(path.read_bytes())
    start, end = sorted((rng.randrange(len(data) + 1), rng.randrange(len(data) + 1)))
    way = rng.choice(["flip", "cut", "drop", "repeat", "noise", "empty", "delete", "folder", "deep", "swap"])
    if way == "flip" and data:
        for _ in range(rng.choice([1, 1, 5])):
            data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
    elif way == "cut":
        del data[start:]
    elif way == "drop":
        del data[start:end]
    elif way == "repeat":
        data[start:start] = data[start:end]
    elif way == "noise":
        data[start:start] = rng.randbytes(20)
    elif way == "empty":
        data.clear()
    elif way == "deep":
        data[:] = rng.choice([b"[", b'{"a":']) * rng.choice([100, 300, 100_000])
    elif way == "swap":
        others = sorted(other for other in path.parent.iterdir() if other.is_file() and other != path)
        if others:
            data[:] = rng.choice(others).read_bytes()
    elif way in ("delete", "folder"):
        path.unlink()
        if way == "folder":
            path.mkdir()
        return way
    path.write_bytes(data)
    return way


def _as_json(path: Path, rng: random.Random) -> str:
    """Change the structure of a JSON file, often with a digest that fits: as a fault of ours would write it."""
    try:
        body = json.loads(path.read_text("utf-8"))
    except (OSError, ValueError, RecursionError):
        return "cannot be read any more"
    told = [_changed(body, rng) for _ in range(rng.choice([1, 1, 1, 3]))]
    seal = rng.random() < 0.8
    path.write_text(
        _sealed(path.name, body) if seal and isinstance(body, dict) else json.dumps(body, indent=1), "utf-8"
    )
    return f"{', '.join(told)}{' (sealed)' if seal else ''}"


def _changed(body: Any, rng: random.Random) -> str:
    """Change one place of a JSON value."""
    holder, trail = body, ""
    while True:
        keys = list(holder) if isinstance(holder, dict) else list(range(len(holder)))
        if not keys:
            return f"nothing at {trail}"
        key = rng.choice(keys)
        trail += f".{key}"
        inner = holder[key]
        if not isinstance(inner, dict | list) or not inner or rng.random() < 0.15:
            break
        holder = inner
    way = rng.choice(["odd", "odd", "number", "drop", "twice", "borrow", "borrow", "rename"])
    if way == "odd":
        holder[key] = rng.choice(ODD)(rng)
    elif way == "number" and isinstance(inner, int | float) and not isinstance(inner, bool):
        holder[key] = rng.choice([-inner, inner + 1, inner * 1e6, inner / 7, inner * 1000])
    elif way == "drop":
        del holder[key]
    elif way == "twice" and isinstance(holder, list):
        holder.insert(key, json.loads(json.dumps(inner)))
    elif way == "borrow":
        holder[key] = _somewhere(body, rng, type(inner))
    elif way == "rename" and isinstance(holder, dict):
        holder[f"{key}_"] = holder.pop(key)
    return f"{way} {trail}"


def _somewhere(body: Any, rng: random.Random, kind: type) -> Any:
    """Return a value of the same kind from somewhere else: an id of another thing, a number of another sort."""
    found: list[Any] = []
    waiting = [body]
    while waiting and len(found) < 3000:
        value = waiting.pop()
        if isinstance(value, kind):
            found.append(value)
        if isinstance(value, dict | list):
            waiting.extend(value.values() if isinstance(value, dict) else value)
    return json.loads(json.dumps(rng.choice(found))) if found else None


def _sealed(name: str, body: dict[str, Any]) -> str:
    """Return the text of a file with the digest that StoryBlender would have written."""
    if name == "graph.json" and "digest" in body:
        rest = json.dumps({key: value for key, value in body.items() if key != "digest"}, indent=1).removeprefix("{\n")
        return f'{{\n "digest": "{hashlib.sha256(rest.encode()).hexdigest()[:16]}",\n{rest}'
    if name[:6].isdigit() and body.get("digest"):
        try:
            return Commit.model_validate(body).sealed().model_dump_json()
        except (ValueError, RecursionError):
            pass
    return json.dumps(body, indent=1)


def copied(source: Path, target: Path) -> Path:
    """Return a fresh copy of a project."""
    shutil.rmtree(target, ignore_errors=True)
    return shutil.copytree(source, target)

"""Lines that are almost messages, from a seed: valid ones with parts replaced, bytes turned over, cut or doubled."""

from __future__ import annotations

import copy
import json
import random
from collections.abc import Iterator
from typing import Any

ODD = (
    None, True, False, 0, -1, 5, 1.5, 1e308, 10**30, "", "tools/call", "\u0000", "\ud800", "x" * 5000, [], [[]],
    [1, "a"], {}, {"id": 1}, {"": None}, {"result": {}}, float("nan"), float("inf"),
)  # fmt: skip
RAW = (
    b"", b"\n", b"5", b"null", b"[]", b'""', b"{", b"}", b"[" * 100_000, b'{"a":' * 50_000, b"\xff\xfe", b"\x00" * 10,
    "{}".encode("utf-16"), b"1" * 10_000, b'{"id":' + b"9" * 5000 + b"}", b"\xef\xbb\xbf{}", b'{"id":1,"id":2}',
)  # fmt: skip


def lines(seed: int, count: int, samples: list[dict[str, Any]]) -> Iterator[bytes]:
    """Yield lines, each with its end.

    Args:
        seed: The same seed gives the same lines.
        count: How many.
        samples: Valid messages that they are made from.
    """
    chance = random.Random(seed)
    for _ in range(count):
        kind = chance.random()
        if kind < 0.05:
            line = chance.choice(RAW)
        else:
            message = _altered(chance, copy.deepcopy(chance.choice(samples)))
            line = json.dumps(message, ensure_ascii=chance.random() < 0.9).encode("utf-8", "surrogatepass")
            if kind < 0.3:
                line = _damaged(chance, line)
        yield line.replace(b"\n", b" ") + b"\n"


def _altered(chance: random.Random, message: Any) -> Any:
    """Replace, remove or add something at up to three places."""
    for _ in range(chance.randint(0, 3)):
        if chance.random() < 0.05:
            return _odd(chance)
        part = message
        while isinstance(part, dict) and part:
            key = chance.choice(sorted(part))
            if isinstance(part[key], dict) and part[key] and chance.random() < 0.6:
                part = part[key]
                continue
            change = chance.random()
            if change < 0.6:
                part[key] = _odd(chance)
            elif change < 0.8:
                del part[key]
            else:
                part[chance.choice(("id", "method", "error", "result", "params", "extra"))] = _odd(chance)
            break
    return message


def _damaged(chance: random.Random, line: bytes) -> bytes:
    place = chance.randrange(len(line)) if line else 0
    match chance.randrange(4):
        case 0:
            return line[:place]
        case 1:
            return line[:place] + bytes([chance.randrange(256)]) + line[place + 1 :]
        case 2:
            return line[:place] + line
        case _:
            return line[:place] + bytes(chance.randrange(256) for _ in range(5)) + line[place:]


def _odd(chance: random.Random) -> Any:
    return copy.deepcopy(chance.choice(ODD))

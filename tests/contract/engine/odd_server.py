"""A server that says whatever it is told to: the client must live with all of it. Needs nothing but Python itself."""

from __future__ import annotations

import json
import os
import sys
import time

WELCOME = {"protocolVersion": "2025-06-18", "capabilities": {}, "serverInfo": {"name": "odd", "version": "1"}}


def say(text: str) -> None:
    sys.stdout.buffer.write(text.encode("latin-1"))
    sys.stdout.buffer.flush()


def answer(number: int, result: object) -> None:
    say(json.dumps({"jsonrpc": "2.0", "id": number, "result": result}) + "\n")


def act(number: int, name: str, arguments: dict[str, str]) -> None:
    if name == "echo":
        answer(number, {"structuredContent": {"result": arguments["word"]}})
    elif name == "say":
        say(arguments["text"].replace("NUMBER", str(number)))
    elif name == "say_and_end":
        say(arguments["text"])
        sys.exit(3)
    elif name == "flood":
        while True:
            say('{"jsonrpc": "2.0", "method": "notifications/progress"}\n' * 1000)
    elif name == "one_long_line":
        while True:
            say("x" * 65536)
    elif name == "close":
        os.close(1)
        time.sleep(60)


def main() -> None:
    for line in sys.stdin:
        message = json.loads(line)
        if message["method"] == "initialize":
            answer(message["id"], WELCOME)
            if sys.argv[1:] == ["deaf"]:
                time.sleep(60)
        elif message["method"] == "tools/call":
            act(message["id"], message["params"]["name"], message["params"]["arguments"])


if __name__ == "__main__":
    main()

"""Visibility of objects in each shot, written into a .glb: glTF hides a node by a scale of zero.

The specification allows it and every viewer shows it; ``KHR_node_visibility`` and ``KHR_animation_pointer`` would be
cleaner, but few viewers know them. Outside the animations a node is as in the first shot, but never of zero size:
Blender's importer divides by the scale of a rig.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

_JSON, _BIN = 0x4E4F534A, 0x004E4942
_FLOAT = 5126
_HIDDEN_SCALE = 0.001
"""Rest scale of a node that is hidden at the start: a person is two millimetres tall."""


def hide_nodes(part: Path, shots: Sequence[tuple[str, float]], shown: Mapping[str, Sequence[bool]]) -> None:
    """Add to each shot's animation which nodes are visible; a shot without motion gets an animation.

    Args:
        part: A .glb whose animations are named like the shots; it is rewritten.
        shots: Name and seconds of each shot, in order.
        shown: Node name -> whether it is visible, shot by shot; other nodes are always visible.
    """
    scene, buffer = _read(part)
    nodes = {
        index: shown[node["name"]] for index, node in enumerate(scene["nodes"]) if _changes_visibility(node, shown)
    }
    if nodes:
        writer = _BufferWriter(scene, buffer)
        animations = {animation["name"]: animation for animation in scene.setdefault("animations", [])}
        for number, (name, seconds) in enumerate(shots):
            if name not in animations:
                animations[name] = {"name": name, "channels": [], "samplers": []}
                scene["animations"].append(animations[name])
            times = writer.accessor([0.0, seconds], "SCALAR", bounds=True)
            for index, seen in nodes.items():
                scale = scene["nodes"][index].get("scale", [1.0, 1.0, 1.0]) if seen[number] else [0.0, 0.0, 0.0]
                _set_scale(animations[name], index, times, writer.accessor([*scale, *scale], "VEC3"))
        for index, seen in nodes.items():
            if not seen[0]:
                scene["nodes"][index]["scale"] = [_HIDDEN_SCALE, _HIDDEN_SCALE, _HIDDEN_SCALE]
        scene["buffers"][0]["byteLength"] = len(buffer)
    _write(part, scene, buffer)


def _changes_visibility(node: Mapping[str, Any], shown: Mapping[str, Sequence[bool]]) -> bool:
    """Return whether a node is hidden in some shot; a skinned mesh follows the joints of its rig."""
    return "skin" not in node and not all(shown.get(node.get("name", ""), ()))


def _set_scale(animation: dict[str, Any], node: int, times: int, values: int) -> None:
    """Set the scale of a node in an animation, by the indices of two accessors."""
    channels = animation["channels"]
    target = {"node": node, "path": "scale"}
    channels[:] = [channel for channel in channels if channel["target"] != target]
    animation["samplers"].append({"input": times, "output": values, "interpolation": "STEP"})
    channels.append({"sampler": len(animation["samplers"]) - 1, "target": target})


class _BufferWriter:
    """Appends numbers to the buffer of a .glb; equal numbers are written once."""

    def __init__(self, scene: dict[str, Any], buffer: bytearray) -> None:
        self._scene, self._buffer = scene, buffer
        self._known: dict[tuple[float, ...], int] = {}

    def accessor(self, values: Sequence[float], kind: str, *, bounds: bool = False) -> int:
        """Return an accessor of two elements of a glTF ``kind``; glTF requires ``bounds`` for times."""
        key = tuple(values)
        if key not in self._known:
            views, accessors = self._scene["bufferViews"], self._scene["accessors"]
            data = struct.pack(f"<{len(values)}f", *values)
            self._buffer.extend(b"\0" * (-len(self._buffer) % 4))
            views.append({"buffer": 0, "byteOffset": len(self._buffer), "byteLength": len(data)})
            self._buffer.extend(data)
            limits = {"min": [_single(min(values))], "max": [_single(max(values))]} if bounds else {}
            view = {"bufferView": len(views) - 1, "componentType": _FLOAT, "count": 2, "type": kind}
            accessors.append(view | limits)
            self._known[key] = len(accessors) - 1
        return self._known[key]


def _single(value: float) -> float:
    """Return a number rounded to single precision, as it is stored."""
    return struct.unpack("<f", struct.pack("<f", value))[0]


def _read(path: Path) -> tuple[dict[str, Any], bytearray]:
    """Return the JSON and the binary buffer of a .glb."""
    data = path.read_bytes()
    chunks: dict[int, bytes] = {}
    offset = 12
    while offset < len(data):
        length, kind = struct.unpack_from("<II", data, offset)
        chunks[kind] = data[offset + 8 : offset + 8 + length]
        offset += 8 + length
    scene = json.loads(chunks[_JSON])
    return scene, bytearray(chunks.get(_BIN, b""))[: scene["buffers"][0]["byteLength"]]


def _write(part: Path, scene: dict[str, Any], buffer: bytearray) -> None:
    """Write a .glb."""
    text = json.dumps(scene, separators=(",", ":"), ensure_ascii=False).encode()
    text += b" " * (-len(text) % 4)
    binary = bytes(buffer) + b"\0" * (-len(buffer) % 4)
    body = struct.pack("<II", len(text), _JSON) + text + struct.pack("<II", len(binary), _BIN) + binary
    part.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)

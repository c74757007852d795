"""No code but ``folder`` writes or deletes by itself: what is written and where is decided in one place.

A library that writes a file gets a path called ``part``, which comes from ``Folder.writing``.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import storyblender

ROOT = Path(storyblender.__file__).parent

ALWAYS = {
    "write_text", "write_bytes", "unlink", "rmtree", "rmdir", "removedirs", "rename", "renames", "touch", "mkdir",
    "makedirs", "mkfifo", "symlink", "symlink_to", "hardlink_to", "truncate", "ftruncate", "copyfile", "copy2",
    "copytree", "savez", "savez_compressed", "savetxt", "tofile", "save", "save_as_mainfile", "write_to_file",
    "save_render", "usd_export", "NamedTemporaryFile", "mkstemp", "Canvas", "FileIO", "chmod", "utime",
}  # fmt: skip
"""Names of functions that write or delete, whoever owns them."""

ELSEWHERE = {
    ("doctor.py", "save"): "into memory",
    ("look/viewfinder_picture.py", "save"): "into memory",
    ("services/made_files.py", "save"): "into memory",
    ("library/small_picture.py", "save"): "into memory",
    ("library/panorama_file.py", "save"): "into memory",
    ("mcp_server/server.py", "save"): "into memory",
    ("library/body_data.py", "mkdir"): "data of the program, in no project",
    ("library/body_data.py", "NamedTemporaryFile"): "data of the program, in no project",
    ("library/body_data.py", "replace"): "data of the program, in no project",
    ("library/body_data.py", "savez"): "into memory",
    ("geometry/mocap.py", "savez_compressed"): "into memory",
    ("library/mocap/folders.py", "save"): "into memory",
    ("blender/server.py", "fdopen"): "the pipe to the client",
    ("engine/worker.py", "FileIO"): "nowhere: the disk has no room for the log",
    ("shell.py", "open"): "nowhere: who read what we say is gone",
    ("deliver/board.py", "save"): "the canvas has its path already",
    ("pipeline/prints.py", "save"): "into memory",
    ("library/texture_file.py", "save"): "into memory",
    ("blender/models/fbx_motion.py", "savez"): "into a temporary folder, by a process that reads a clip",
    ("blender/models/fbx_motion.py", "write_text"): "into that temporary folder",
    ("blender/models/blend_reader.py", "save"): "into a temporary folder, by a process that reads a user's model",
    ("blender/models/blend_reader.py", "write_text"): "into that temporary folder",
    ("blender/models/plain.py", "savez"): "into that temporary folder",
    ("blender/models/plain.py", "write_text"): "into that temporary folder",
    ("blender/models/plain.py", "write_bytes"): "into that temporary folder",
    ("blender/models/usd.py", "mkdir"): "in a temporary folder, by a process that reads a user's model",
    ("blender/models/usd.py", "open"): "in that temporary folder",
    ("blender/models/palette.py", "save"): "into memory",
    ("blender/models/pictures.py", "save"): "into memory",
    ("blender/render/motion_frames.py", "copyfile"): "from picture to picture of a private folder",
    ("blender/cut.py", "save_as_mainfile"): "a file of a temporary folder, which gives links their start",
}
"""Module and function that write somewhere else than into a project."""


def writers(tree: ast.AST) -> Iterator[ast.Call]:
    """Yield the calls that write to a path, or delete one, but for those to a ``part``."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and _writes(node) and not _to_part(node):
            yield node


def _writes(call: ast.Call) -> bool:
    name, arguments = _name(call), len(call.args) + len(call.keywords)
    if name in ("open", "fdopen"):
        given = [*call.args, *(word.value for word in call.keywords)]
        modes = [arg.value for arg in given if isinstance(arg, ast.Constant) and isinstance(arg.value, str)]
        return _owner(call) == "os" or any(set(mode) & set("wax+") and len(mode) <= 3 for mode in modes)
    if name == "replace":  # a path has one argument, a text has two
        return _owner(call) == "os" or (isinstance(call.func, ast.Attribute) and arguments == len(call.args) == 1)
    if name in ("write", "remove", "link"):
        return _owner(call) in ("os", "libraries")
    if name == "rename":  # people are renamed too
        return arguments == 1 or _owner(call) == "os"
    if name in ("move", "gltf"):
        return _owner(call) in ("shutil", "export_scene")
    return name in ALWAYS


def _to_part(call: ast.Call) -> bool:
    words = [*call.args, *(word.value for word in call.keywords), call.func]
    return any(isinstance(node, ast.Name) and node.id == "part" for word in words for node in ast.walk(word))


def _name(call: ast.Call) -> str:
    return call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")


def _owner(call: ast.Call) -> str:
    owner = call.func.value if isinstance(call.func, ast.Attribute) else None
    return getattr(owner, "id", "") or getattr(owner, "attr", "")


def test_only_the_folder_writes_and_deletes() -> None:
    found: set[tuple[str, str]] = set()
    for path in sorted(ROOT.rglob("*.py")):
        module = path.relative_to(ROOT).as_posix()
        if module == "folder.py":
            continue
        for call in writers(ast.parse(path.read_text(encoding="utf-8"))):
            found.add((module, _name(call)))
            assert (module, _name(call)) in ELSEWHERE, (
                f"{module}:{call.lineno} writes or deletes; use storyblender.folder"
            )
    assert found == set(ELSEWHERE), "an exception is needed no more"


@pytest.mark.parametrize(
    "line",
    [
        "path.write_text('x')", "open(path, 'w')", "path.open('ab')", "Path(a).unlink()", "shutil.rmtree(a)",
        "os.replace(a, b)", "a.replace(b)", "os.open(a, 1)", "bpy.ops.wm.save_as_mainfile(filepath=str(a))",
        "bpy.data.libraries.write(str(a), {c})", "av.open(str(a), 'w', format='mp4')", "image.save(a)", "os.remove(a)",
        "a.mkdir()", "bpy.ops.export_scene.gltf(filepath=str(out))", "open(mode='x', file=a)",
    ],
)  # fmt: skip
def test_a_raw_writer_is_found(line: str) -> None:
    assert list(writers(ast.parse(line)))


@pytest.mark.parametrize(
    "line", ["open(path)", "a.replace('x', 'y')", "replace(graph, shot)", "image.save(part)", "part.write_text('x')"]
)
def test_what_reads_or_writes_to_a_part_is_let_pass(line: str) -> None:
    assert not list(writers(ast.parse(line)))

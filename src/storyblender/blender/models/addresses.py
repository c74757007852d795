"""Addresses in a model: only files inside the user's folder of models are read, wherever a model points."""

from __future__ import annotations

import re
from pathlib import Path, PureWindowsPath
from urllib.parse import unquote

from storyblender.blender.models.limits import FILE_BYTES, MIB
from storyblender.errors import InputError

_SCHEME = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:")


def inside(folder: Path, base: Path, address: str, *, quoted: bool = False) -> Path:
    """Return the file that an address in a model means.

    Args:
        folder: The folder of models; nothing outside it is read, also through links.
        base: The folder that the address is relative to.
        address: As written in the model.
        quoted: Whether ``%20`` stands for a space, as in a URI.

    Raises:
        InputError: It is a web or absolute address, leads out of the folder, or to no file.
    """
    written = unquote(address) if quoted else address
    shown = repr(address if len(address) <= 80 else address[:77] + "...")
    if not written.strip() or "\0" in written:
        raise InputError(f"it names a file without a name ({shown})")
    windows = PureWindowsPath(written)
    if _SCHEME.match(written) or windows.drive or windows.root or Path(written).is_absolute():
        raise InputError(f"it names {shown}, which is not an address within the folder of models")
    path = base / written.replace("\\", "/")
    return readable(folder, path, shown)


def readable(folder: Path, path: Path, shown: str = "") -> Path:
    """Return the real path of a file within the folder of models, of a size that can be read.

    Args:
        folder: The folder of models.
        path: The file; links are followed.
        shown: Its name for messages; by default the last part of the path, quoted.

    Raises:
        InputError: It leads out of the folder, is no file, or is too large.
    """
    shown = shown or repr(path.name)
    try:
        real = path.resolve()
        if not real.is_relative_to(folder.resolve()):
            raise InputError(f"it names {shown}, which is outside the folder of models")
        if not real.is_file():
            raise InputError(f"it names {shown}, and there is no such file")
        size = real.stat().st_size
    except (OSError, RuntimeError, ValueError) as error:
        raise InputError(f"it names {shown}, which cannot be read ({type(error).__name__})") from error
    if size > FILE_BYTES:
        raise InputError(f"it names {shown}, which has {size // MIB} MiB; at most {FILE_BYTES // MIB} are read")
    return real

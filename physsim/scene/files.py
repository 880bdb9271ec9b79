"""Files that a scene names: meshes, found relative to the scene file."""

from __future__ import annotations

import stat
from pathlib import Path

from physsim.errors import FileTrouble
from physsim.scene.suggest import did_you_mean

MAX_MESH_BYTES = 200 * 10**6


def resolve_file(folder: Path, file: str) -> Path:
    """The path of `file`, relative to `folder` unless it is absolute; no patterns, no addresses.

    Raises FileTrouble, whose text is the reason alone, when it is no regular file of at most 200 MB.
    """
    if "://" in file:
        raise FileTrouble("is an address; a mesh must be a file on this machine")
    path = folder / file
    try:
        status = path.stat()
    except FileNotFoundError:
        raise FileTrouble(f"there is no such file in {folder}{_near(path)}") from None
    except (OSError, ValueError) as error:
        raise FileTrouble(f"cannot be read: {getattr(error, 'strerror', None) or error}") from None
    if not stat.S_ISREG(status.st_mode):
        raise FileTrouble("is not a regular file")
    if status.st_size > MAX_MESH_BYTES:
        raise FileTrouble(f"is larger than {MAX_MESH_BYTES // 10**6} MB")
    return path


def _near(path: Path) -> str:
    try:
        hint = did_you_mean(path.name, (entry.name for entry in path.parent.iterdir()))
    except OSError:
        return ""
    return f"; {hint}" if hint else ""

"""The scene file -> text: what cannot be a scene is refused with a plain word before anything reads it."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from physsim.errors import FileTrouble, Problem, SceneError
from physsim.scene.suggest import did_you_mean

MAX_BYTES = 16 * 2**20
_UTF8_MARK = b"\xef\xbb\xbf"
_OTHER_MARKS = {b"\xff\xfe": "UTF-16", b"\xfe\xff": "UTF-16"}


def read_source(path: Path) -> str:
    """The text of a scene file in UTF-8, without a byte order mark.

    Raises FileTrouble when there is no such file or it cannot be read, SceneError when it holds no text.
    """
    data = _bytes_of(path)
    if len(data) > MAX_BYTES:
        raise _no_scene(path, f"is larger than {MAX_BYTES // 2**20} MiB, the most for a scene")
    return decoded(data, path)


def decoded(data: bytes, path: Path) -> str:
    """Bytes as text. Raises SceneError for UTF-16, binary data, and anything else that is not UTF-8."""
    for mark, name in _OTHER_MARKS.items():
        if data.startswith(mark):
            raise _no_scene(path, f"is written in {name}; save it as UTF-8")
    data = data.removeprefix(_UTF8_MARK)
    at = data.find(b"\0")
    if at >= 0:
        raise _no_scene(path, "is a binary file (it holds a NUL byte), not a scene in YAML", data[:at])
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        message = f"is not UTF-8 (byte 0x{data[error.start]:02x} cannot be read); save it as UTF-8"
        raise _no_scene(path, message, data[: error.start]) from None


def _bytes_of(path: Path) -> bytes:
    try:
        mode = path.stat().st_mode
        if stat.S_ISDIR(mode):
            raise FileTrouble(f"{path}: is a directory, not a scene file{_scenes_in(path)}")
        if not stat.S_ISREG(mode):
            raise FileTrouble(f"{path}: is not a regular file")
        with path.open("rb") as file:
            return file.read(MAX_BYTES + 1)
    except FileNotFoundError:
        raise FileTrouble(f"{path}: there is no such file{_near(path)}") from None
    except (OSError, ValueError) as error:
        reason = os.strerror(error.errno) if isinstance(error, OSError) and error.errno else str(error)
        raise FileTrouble(f"{path}: cannot be read: {reason}") from None


def _names_in(folder: Path) -> list[str]:
    try:
        return sorted(entry.name for entry in os.scandir(folder))
    except OSError:
        return []


def _near(path: Path) -> str:
    hint = did_you_mean(path.name, _names_in(path.parent))
    return f"; {hint}" if hint else ""


def _scenes_in(folder: Path) -> str:
    scenes = [name for name in _names_in(folder) if name.endswith((".yaml", ".yml"))]
    return f"; it holds {', '.join(scenes[:5])}" if scenes else ""


def _no_scene(path: Path, message: str, before: bytes | None = None) -> SceneError:
    """The error, at the position behind the bytes `before` when there is one."""
    if before is None:
        return SceneError([Problem((), message)], str(path))
    lines = before.decode("utf-8", errors="replace").split("\n")
    return SceneError([Problem((), message, line=len(lines), column=len(lines[-1]) + 1)], str(path))

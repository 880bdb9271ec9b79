"""Files take their name when they are whole: never half a file in the place of an old one."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from physsim.errors import FileTrouble
from physsim.recording.target import part_of, plain


def check_name(path: Path, *, force: bool) -> None:
    """Raises FileTrouble when `path` is taken and `force` is not given, or when it is in no folder."""
    if path.is_dir():
        raise FileTrouble(f"{path}: is a folder; name a file in it")
    if path.exists() and not force:
        raise FileTrouble(f"{path}: exists already; --force replaces it, -o names another file")
    if not path.parent.is_dir():
        raise FileTrouble(f"{path}: the folder {path.parent} does not exist")


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """Gives the name to write under, PATH.part, which takes the name `path` at the end; after an error it is
    removed, and what stood under `path` is still there. Raises FileTrouble when it cannot be written.
    """
    part = part_of(path)
    try:
        yield part
        part.replace(path)
    except OSError as error:
        part.unlink(missing_ok=True)
        raise FileTrouble(f"{path}: cannot be written: {plain(error)}") from error
    except BaseException:
        part.unlink(missing_ok=True)
        raise


def written(path: Path, data: bytes) -> Path:
    """`path`, with `data` in it. Raises FileTrouble when it cannot be written."""
    with whole_file(path) as part:
        part.write_bytes(data)
    return path

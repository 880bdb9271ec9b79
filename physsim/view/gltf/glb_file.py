"""The container of binary glTF 2.0: accessors over one binary chunk, and the JSON before it.

Khronos Group, "glTF 2.0 Specification" (2021), sections 3.6 (accessors), 3.6.2.4 (alignment), 4 (GLB).
"""

from __future__ import annotations

import json
import shutil
import struct
from pathlib import Path
from typing import IO, Any

import numpy as np
import numpy.typing as npt

from physsim.errors import FileTrouble

MOST_BYTES = (1 << 31) - 1
"""Players and browsers hold a file in one buffer of less than 2 GiB."""

TOO_LARGE = (
    "the file would be larger than 2 GiB, more than players of glTF take; --fps, --from, --until or "
    "--tolerance makes it smaller"
)

VERTICES, INDICES = 34962, 34963
"""What a view of the chunk is for: ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER."""

_COMPONENTS = {"float32": 5126, "uint16": 5123, "uint32": 5125}
_KINDS = {(): "SCALAR", (3,): "VEC3", (4,): "VEC4"}


class Binary:
    """The binary chunk as it grows in a file: arrays one after the other, in views of one purpose each."""

    def __init__(self, file: IO[bytes]) -> None:
        self.file = file
        self.size = 0
        self.views: list[dict[str, Any]] = []
        self._next: dict[str, Any] | None = None
        self.accessors: list[dict[str, Any]] = []

    def begin_view(self, target: int | None = None) -> None:
        """The arrays added from now on serve `target`; None: no vertices and no indices, but key frames.

        A view of nothing is not made: glTF forbids it.
        """
        purpose = {} if target is None else {"target": target}
        stride = {"byteStride": 12} if target == VERTICES else {}
        self._next = {"buffer": 0, "byteOffset": self.size, "byteLength": 0, **stride, **purpose}

    def add(self, array: npt.NDArray[Any], *, bounds: bool = False) -> int:
        """The number of the accessor of an array (n), (n, 3) or (n, 4) of 32-bit floats or unsigned integers.

        bounds: whether the accessor tells smallest and largest, as vertices and times must. Raises
        FileTrouble when the chunk grows past what players take.
        """
        if self._next is not None:
            self.views.append(self._next)
            self._next = None
        view = self.views[-1]
        data = array.tobytes()
        padding = -len(data) % 4
        if self.size + len(data) > MOST_BYTES:
            raise FileTrouble(TOO_LARGE)
        accessor = {
            "bufferView": len(self.views) - 1,
            "byteOffset": self.size - view["byteOffset"],
            "componentType": _COMPONENTS[array.dtype.name],
            "count": len(array),
            "type": _KINDS[array.shape[1:]],
        }
        if bounds:
            accessor["min"] = np.atleast_1d(array.min(axis=0)).tolist()
            accessor["max"] = np.atleast_1d(array.max(axis=0)).tolist()
        self.file.write(data + bytes(padding))
        self.size += len(data) + padding
        view["byteLength"] = self.size - view["byteOffset"]
        self.accessors.append(accessor)
        return len(self.accessors) - 1


def write_glb(path: Path, document: dict[str, Any], binary: Binary) -> int:
    """Writes the file and returns its size in bytes; buffers, views and accessors are added to `document`.

    Raises FileTrouble when it would be larger than players take.
    """
    buffers = {
        "buffers": [{"byteLength": binary.size}],
        "bufferViews": binary.views,
        "accessors": binary.accessors,
    }
    text = json.dumps(
        document | (buffers if binary.size else {}),
        ensure_ascii=False,
        allow_nan=False,
        separators=(",", ":"),
    ).encode()
    text += b" " * (-len(text) % 4)
    size = 12 + 8 + len(text) + (8 + binary.size if binary.size else 0)
    if size > MOST_BYTES:
        raise FileTrouble(TOO_LARGE)
    with path.open("wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, size))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        if binary.size:
            file.write(struct.pack("<I4s", binary.size, b"BIN\0"))
            binary.file.seek(0)
            shutil.copyfileobj(binary.file, file, 1 << 20)
    return size

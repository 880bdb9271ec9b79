"""What of a mesh file is handed to trimesh: vertices and faces, and nothing that could lead it astray.

It builds an object for each solid of an STL text, in time that grows with the square of their number: 5 MB of
small solids kept it busy for ten minutes.
"""

from __future__ import annotations

import re

from physsim.model.trouble import ShapeTrouble

MAX_PLY_HEADER = 65536
"""Bytes; a header names a dozen properties."""

MAX_TEXT_BYTES = 32_000_000
"""Bytes of OFF and PLY in text, of which trimesh makes thirty times as much memory."""

_PLY_FORMAT = 100
_STL_VERTEX = re.compile(rb"\bvertex[ \t]+[^\r\n]*", re.IGNORECASE)
_BINARY_STL_HEAD, _BINARY_STL_TRIANGLE = 84, 50


def geometry_only(data: bytes, file_type: str) -> bytes:
    """The file as one solid, without names. Raises ShapeTrouble for endless headers and very long texts."""
    if file_type == "off" or (file_type == "ply" and b"ascii" in data[:_PLY_FORMAT]):
        _require_short(data, file_type)
    if file_type == "stl" and not _is_binary_stl(data):
        return b"solid\n" + b"\n".join(_STL_VERTEX.findall(data)) + b"\nendsolid\n"
    if file_type == "ply" and b"end_header" not in data[:MAX_PLY_HEADER]:
        raise ShapeTrouble("cannot be read as PLY: its header does not end", key="file")
    return data


def _require_short(data: bytes, file_type: str) -> None:
    if len(data) > MAX_TEXT_BYTES:
        raise ShapeTrouble(
            f"is too large for a {file_type.upper()} file in text: {len(data)} bytes",
            key="file",
            allowed=f"at most {MAX_TEXT_BYTES} bytes",
            hint="save it as binary STL or PLY",
        )


def _is_binary_stl(data: bytes) -> bool:
    """Whether the length is the one that the header states; a binary file may begin with `solid` too."""
    stated = int.from_bytes(data[80:_BINARY_STL_HEAD], "little")
    return len(data) == _BINARY_STL_HEAD + _BINARY_STL_TRIANGLE * stated

"""What of a mesh file is handed to the reader: vertices and faces, and nothing that could lead it astray.

Groups, materials and solids mean nothing to mechanics, but trimesh builds an object for each, in time that
grows with the square of their number: 5 MB of small solids kept it busy for ten minutes.
"""

from __future__ import annotations

import re

from physsim.model.trouble import ShapeTrouble

MAX_PLY_HEADER = 65536
"""Bytes; a header names a dozen properties."""

_OBJ_LINE = re.compile(rb"^[ \t]*([vf][ \t][^\r\n]*)", re.MULTILINE)
_AFTER_SLASH = re.compile(rb"/[^ \t\r\n]*")
_STL_VERTEX = re.compile(rb"\bvertex[ \t]+[^\r\n]*", re.IGNORECASE)
_BINARY_STL_HEAD, _BINARY_STL_TRIANGLE = 84, 50


def geometry_only(data: bytes, file_type: str) -> bytes:
    """The file without groups, materials, texture and normal indices. Raises ShapeTrouble for an endless
    header.
    """
    if file_type == "obj":
        return _obj(data)
    if file_type == "stl" and not _is_binary_stl(data):
        return b"solid\n" + b"\n".join(_STL_VERTEX.findall(data)) + b"\nendsolid\n"
    if file_type == "ply" and b"end_header" not in data[:MAX_PLY_HEADER]:
        raise ShapeTrouble("cannot be read as PLY: its header does not end", key="file")
    return data


def _obj(data: bytes) -> bytes:
    """Lines `v x y z` and `f 1/2/3 ...`, of the latter the vertex numbers; a backslash continues a line."""
    data = data.replace(b"\r\n", b"\n").replace(b"\r", b"\n").replace(b"\\\n", b" ")
    lines = _OBJ_LINE.findall(data)
    return _AFTER_SLASH.sub(b"", b"\n".join(lines))


def _is_binary_stl(data: bytes) -> bool:
    """Whether the length is the one that the header states; a text may well begin with the same letters."""
    stated = int.from_bytes(data[80:_BINARY_STL_HEAD], "little")
    return len(data) == _BINARY_STL_HEAD + _BINARY_STL_TRIANGLE * stated

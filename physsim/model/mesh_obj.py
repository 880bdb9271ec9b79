"""Wavefront OBJ: vertices and faces, and nothing else.

A reader of our own, because trimesh counts negative indices back from the end of the file instead of from
the face (a file with two such parts comes out wrong), stumbles over a comment behind a number, builds an
object for each material, and would open the files that `mtllib` names.
"""

from __future__ import annotations

import io
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from physsim.model.polyhedron import IntArray
from physsim.model.rotation import FloatArray

MAX_LINE = 1_000_000
"""Bytes; a face of so many corners is a mistake, and its words would take fifty times the memory."""

_BYTE_ORDER_MARK = b"\xef\xbb\xbf"


def read_obj(data: bytes, most: int) -> tuple[FloatArray, IntArray]:
    """Vertices (V, 3) and triangles (T, 3), polygons cut into fans; reading stops past `most` triangles or
    three times as many vertices. Raises ValueError with the line.
    """
    vertices: list[list[float]] = []
    triangles: list[tuple[int, int, int]] = []
    for number, words in _statements(data):
        if len(triangles) > most or len(vertices) > 3 * most:
            break
        try:
            if words[0] == b"v":
                vertices.append(_vertex(words[1:]))
            else:
                corners = [_index(word, len(vertices)) for word in words[1:]]
                triangles += ((corners[0], b, c) for b, c in pairwise(corners[1:]))
        except ValueError:
            raise ValueError(f"line {number} is no vertex or face") from None
    return (
        np.array(vertices, dtype=np.float64).reshape(-1, 3),
        np.array(triangles, dtype=np.int64).reshape(-1, 3).astype(np.int32),
    )


def _statements(data: bytes) -> Iterator[tuple[int, list[bytes]]]:
    """Line numbers and words of the lines `v ...` and `f ...`; a backslash continues a line, # ends it."""
    text = data.removeprefix(_BYTE_ORDER_MARK).replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    for number, line in enumerate(io.BytesIO(text.replace(b"\\\n", b" ")), start=1):
        if len(line) > MAX_LINE:
            raise ValueError(f"line {number} is longer than {MAX_LINE} bytes")
        if line.lstrip()[:1] in (b"v", b"f"):
            words = line.partition(b"#")[0].split()
            if words and words[0] in (b"v", b"f"):
                yield number, words


def _vertex(words: list[bytes]) -> list[float]:
    """The first three numbers; a weight or a colour may follow."""
    if len(words) < 3:
        raise ValueError
    return [float(word) for word in words[:3]]


def _index(word: bytes, known: int) -> int:
    """The vertex of `3`, `3/1`, `3//2` or `3/1/2`, counted from 0; -1 is the last one so far."""
    given = int(word.partition(b"/")[0])
    index = given - 1 if given > 0 else known + given
    if given == 0 or index < 0:
        raise ValueError
    return min(index, 2**31 - 1)

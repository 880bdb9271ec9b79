"""How a run that is watched travels: from the run to the server of its page, and from there to the pages.

A message is a kind, facts that JSON can say, and arrays by name:

    4 bytes   length of the head, little-endian, a multiple of 8
    4 bytes   length of all arrays, little-endian, a multiple of 8
    head      JSON: {"kind", "facts", "arrays": [[name, type, shape], ...]}, filled up with spaces
    arrays    one after the other, little-endian, C order, each filled up to a multiple of 8 bytes

so that a browser can lay its typed arrays over a message. Numbers keep the bits that they have in the file.
"""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, BinaryIO

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]
_LENGTHS = struct.Struct("<II")
_GRAIN = 8


@dataclass(frozen=True)
class Message:
    """kind: begin, frame, end, whole or alive; facts: what JSON can say; arrays: numbers, by name."""

    kind: str
    facts: Mapping[str, Any] = field(default_factory=dict)
    arrays: Mapping[str, Array] = field(default_factory=dict)


def encoded(message: Message) -> bytes:
    """The message as bytes. Raises ValueError for facts that JSON cannot say."""
    arrays = {name: _plain(array) for name, array in message.arrays.items()}
    described = [[name, array.dtype.str, array.shape] for name, array in arrays.items()]
    said = {"kind": message.kind, "facts": message.facts, "arrays": described}
    head = json.dumps(said, allow_nan=False, separators=(",", ":")).encode()
    head += b" " * (-len(head) % _GRAIN)
    body = b"".join(_filled(array.tobytes()) for array in arrays.values())
    return _LENGTHS.pack(len(head), len(body)) + head + body


def read(stream: BinaryIO) -> tuple[Message, bytes] | None:
    """The next message of a stream, and its bytes; None at the end, also when that cuts a message."""
    lengths = stream.read(_LENGTHS.size)
    if len(lengths) < _LENGTHS.size:
        return None
    head_size, body_size = _LENGTHS.unpack(lengths)
    data = stream.read(head_size + body_size)
    if len(data) < head_size + body_size:
        return None
    said = json.loads(data[:head_size])
    return Message(said["kind"], said["facts"], _arrays(said["arrays"], data, head_size)), lengths + data


def _arrays(described: list[tuple[str, str, list[int]]], data: bytes, start: int) -> dict[str, Array]:
    arrays = {}
    for name, kind, shape in described:
        arrays[name] = np.frombuffer(data, kind, math.prod(shape), start).reshape(shape)
        start += arrays[name].nbytes + -arrays[name].nbytes % _GRAIN
    return arrays


def _plain(array: Any) -> Array:
    """Little-endian, in C order."""
    found = np.asarray(array)
    return found.astype(found.dtype.newbyteorder("<"), order="C", copy=False)


def _filled(data: bytes) -> bytes:
    return data + bytes(-len(data) % _GRAIN)

"""The end of the file, told in its first bytes ahead of time.

HDF5 writes the new end of the file last. A kill just before leaves indexes that point past the old end, and
such a file cannot be read (seen once in 150 kills of a writer that did nothing but flush). So the end that a
block can reach at most is written first.

Layout: HDF5 File Format Specification 3.0, II.A, "Disk Format: Level 0A - Format Signature and Superblock",
version 2: 44 bytes and their checksum, the end of file address at byte 28.
"""

from __future__ import annotations

import os
import struct

_BYTES = 44
_END_AT = 28
_VERSION_AT = 8
_SIZE_OF_OFFSETS_AT = 9
_MASK = 0xFFFFFFFF


def tell_end(handle: int, end: int) -> None:
    """Writes `end` [bytes] as the end of the file into the superblock, in one piece with its checksum.

    Does nothing for files of another layout than this package writes (version 2, addresses of 8 bytes).
    """
    head = bytearray(os.pread(handle, _BYTES, 0))
    if len(head) < _BYTES or head[_VERSION_AT] != 2 or head[_SIZE_OF_OFFSETS_AT] != 8:
        return
    head[_END_AT : _END_AT + 8] = end.to_bytes(8, "little")
    os.pwrite(handle, bytes(head) + lookup3(bytes(head)).to_bytes(4, "little"), 0)


def lookup3(data: bytes) -> int:
    """Checksum of HDF5 metadata: `hashlittle` with initial value 0.

    Bob Jenkins, lookup3.c (2006, public domain); HDF5 File Format Specification 3.0, appendix "Checksum".
    """
    a = b = c = (0xDEADBEEF + len(data)) & _MASK
    whole = max(len(data) - 1, 0) // 12 * 12
    for at in range(0, whole, 12):
        x, y, z = struct.unpack_from("<3I", data, at)
        a, b, c = _mixed((a + x) & _MASK, (b + y) & _MASK, (c + z) & _MASK)
    if not data:
        return c
    x, y, z = struct.unpack("<3I", data[whole:].ljust(12, b"\0"))
    return _final((a + x) & _MASK, (b + y) & _MASK, (c + z) & _MASK)


def _mixed(a: int, b: int, c: int) -> tuple[int, int, int]:
    for turn in (4, 6, 8, 16, 19, 4):
        a = ((a - c) & _MASK) ^ _turned(c, turn)
        c = (c + b) & _MASK
        a, b, c = b, c, a
    return a, b, c


def _final(a: int, b: int, c: int) -> int:
    for turn in (14, 11, 25, 16, 4, 14, 24):
        c = ((c ^ b) - _turned(b, turn)) & _MASK
        a, b, c = b, c, a
    return b


def _turned(value: int, bits: int) -> int:
    return ((value << bits) | (value >> (32 - bits))) & _MASK

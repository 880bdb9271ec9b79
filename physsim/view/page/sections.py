"""The data sections of a page: compressed bytes, and for each what the page must know to open it."""

from __future__ import annotations

import zlib
from typing import Any

import numpy as np
import numpy.typing as npt

from physsim.view.page.coding import LEVEL, Codes, encoded

_KINDS = {"f8": np.float64, "f4": np.float32, "u4": np.uint32}


class Sections:
    """Collects sections. `data` are their bytes, `heads` their descriptions, in the same order.

    {"kind": "coded", "rows": R, "length": T, "planes": P}: what `coding.encoded` makes;
    {"kind": "f8" | "f4" | "u4", "length": n}: n numbers, little-endian, all first bytes, then all
    second ones, and so on. Both are zlib streams.
    """

    def __init__(self) -> None:
        self.data: list[bytes] = []
        self.heads: list[dict[str, Any]] = []

    def copy(self) -> Sections:
        """The sections so far, to go on from."""
        new = Sections()
        new.data, new.heads = list(self.data), list(self.heads)
        return new

    @property
    def size(self) -> int:
        """Bytes of all sections."""
        return sum(map(len, self.data))

    def add_codes(self, codes: Codes, planes: int) -> int:
        """A section of whole numbers (R, T) below 256**planes; returns its number."""
        rows, length = codes.shape
        head = {"kind": "coded", "rows": rows, "length": length, "planes": planes}
        return self._add(head, encoded(codes, planes))

    def add(self, kind: str, numbers: npt.ArrayLike) -> int:
        """A section of `f8`, `f4` or `u4` numbers in the order of their memory; returns its number."""
        plain = np.ascontiguousarray(numbers, np.dtype(_KINDS[kind]).newbyteorder("<")).reshape(-1)
        bytes_of_each = plain.view(np.uint8).reshape(len(plain), plain.itemsize)
        data = zlib.compress(bytes_of_each.T.tobytes(), LEVEL)
        return self._add({"kind": kind, "length": len(plain)}, data)

    def _add(self, head: dict[str, Any], data: bytes) -> int:
        self.heads.append(head)
        self.data.append(data)
        return len(self.data) - 1

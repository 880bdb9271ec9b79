"""The data of a page, opened by the description of its format and nothing of physsim."""

from __future__ import annotations

import base64
import json
import re
import zlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

NOT_A_NUMBER = {planes: 256**planes - 1 for planes in (1, 2, 3, 4)}


def decoded(data: bytes, rows: int, length: int, planes: int) -> Any:
    """Whole numbers (rows, length): zigzag, differences taken 0 to 3 times, the lowest bytes of all first."""
    raw = np.frombuffer(zlib.decompress(data), np.uint8)
    assert len(raw) == rows + planes * rows * length
    table = raw[rows:].reshape(planes, rows, length).astype(np.int64)
    folded = sum(table[plane] * 256**plane for plane in range(planes)) if length else table[0]
    residuals = np.where(folded % 2 == 0, folded // 2, -(folded + 1) // 2)
    for row, order in enumerate(raw[:rows]):
        for _ in range(order):
            residuals[row] = np.cumsum(residuals[row]) % 2**32
    return residuals % 256**planes


@dataclass
class Opened:
    """head and sections of a page or of packed data."""

    head: dict[str, Any]
    data: list[bytes]

    def codes(self, section: int) -> Any:
        about = self.head["sections"][section]
        assert about["kind"] == "coded"
        return decoded(self.data[section], about["rows"], about["length"], about["planes"])

    def plain(self, section: int) -> Any:
        """Numbers that are stored as all first bytes, all second bytes and so on."""
        about = self.head["sections"][section]
        size = int(about["kind"][1])
        raw = np.frombuffer(zlib.decompress(self.data[section]), np.uint8).reshape(size, about["length"])
        return np.ascontiguousarray(raw.T).view("<" + about["kind"]).reshape(-1)

    def planes(self, section: int) -> int:
        return int(self.head["sections"][section]["planes"])

    def track(self, name: str) -> tuple[Any, Any]:
        """Values (T, rows, components), and the error of each row and component."""
        track = next(each for each in self.head["tracks"] if each["name"] == name)
        codes, scale = self.codes(track["codes"]), self.plain(track["scale"])
        base, step, error = scale.reshape(3, -1, 1)
        values = np.where(codes == NOT_A_NUMBER[self.planes(track["codes"])], np.nan, base + codes * step)
        shape = (-1, track["rows"], track["components"])
        return values.T.reshape(shape), error.reshape(shape[1:])

    def contacts(self) -> dict[str, Any]:
        """Columns of all points, sorted by frame and bodies."""
        head = self.head["contacts"]
        names = ("frame", "body_a", "body_b", "sliding")
        columns = {name: self.codes(head[name])[0] for name in names}
        base, step, error = self.plain(head["scale"]).reshape(3, 3, 1)
        columns["position"] = (base + self.codes(head["position"]) * step).T
        bits = self.codes(head["force"]) << 8 * (4 - self.planes(head["force"]))
        columns["force"] = bits.astype(np.uint32).view(np.float32).T
        order = np.lexsort((columns["body_b"], columns["body_a"], columns["frame"]))
        found = {name: column[order] for name, column in columns.items()}
        return found | {"error": error[:, 0], "in_file": self.codes(head["in_file"])[0]}


def opened_page(path: Path) -> Opened:
    """The page's head and sections."""
    text = path.read_text(encoding="utf-8")
    blocks = re.findall(r'<script type="application/x-physsim" id="section-\d+">([^<]*)</script>', text)
    head = re.search(r'<script type="application/json" id="head">(.*?)</script>', text, re.DOTALL)
    assert head is not None
    return Opened(json.loads(head[1]), [base64.b64decode(block) for block in blocks])

"""One HTML file that plays a trajectory: no server, no network, nothing beside it.

The page holds the viewer (assets/, built from viewer/), a JSON head and the packed sections in base64. A
content security policy allows its own script and style, by their hashes, and nothing else: whatever a scene's
texts contain, no other script runs and nothing is fetched.
"""

from __future__ import annotations

import base64
import hashlib
import html
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any

from physsim.errors import FileTrouble
from physsim.recording import Trajectory
from physsim.recording.target import in_words
from physsim.recording.whole_file import whole_file
from physsim.view.page.notes import Report
from physsim.view.page.pack import Packed, packed

DEFAULT_BYTES = 24_000_000
# Of the head: names, materials and indices of each body and solid take about so much.
HEAD_BYTES = 150
ATTEMPTS = 4
_SLOT = re.compile(r"\{\{(\w+)\}\}")
_LOADING = "Opening the recording …"


@dataclass(frozen=True)
class Page:
    """The bytes of an HTML file, in parts, and what was done to make it fit."""

    parts: list[bytes]
    report: Report

    @property
    def size(self) -> int:
        """Bytes."""
        return sum(map(len, self.parts))


def page_of(trajectory: Trajectory, most_bytes: int = DEFAULT_BYTES) -> Page:
    """The page of a trajectory, at most so large.

    Raises FileTrouble when the file is damaged or keeps no shapes, or when it does not fit.
    """
    empty = sum(map(len, assembled(trajectory.title, {}, [])))
    room = (most_bytes - empty - HEAD_BYTES * 2 * len(trajectory.body_names)) * 3 // 4
    for _ in range(ATTEMPTS):
        if room <= 0:
            break
        data = packed(trajectory, room)
        page = _page(trajectory, data)
        if page.size <= most_bytes:
            return page
        room -= page.size - most_bytes
    raise FileTrouble(
        f"{trajectory.path}: {in_words(most_bytes)} are too few for a page; --max-size allows more"
    )


def _page(trajectory: Trajectory, data: Packed) -> Page:
    title = trajectory.title or trajectory.path.name
    return Page(list(assembled(title, data.head, data.data)), data.report)


def assembled(
    title: str, head: Mapping[str, Any], sections: Sequence[bytes], connect: str = "'none'"
) -> Iterator[bytes]:
    """The parts of a page. connect: what of `connect-src` its script may talk to; "'self'" for a page that
    is fed by its server.
    """
    script, style = asset("viewer.js"), asset("viewer.css")
    slots = {
        "policy": [html.escape(policy(script, style, connect))],
        "title": [html.escape(title)],
        "loading": [_LOADING],
        "style": [style],
        "script": [script],
        "sections": _blocks(head, sections),
    }
    for number, piece in enumerate(_SLOT.split(asset("index.html"))):
        for text in slots[piece] if number % 2 else [piece]:
            yield text.encode(errors="replace")


def policy(script: str, style: str, connect: str) -> str:
    """The content security policy. Pictures are for those that the page makes itself, to be saved."""
    rules = {
        "default-src": "'none'",
        "script-src": _hash(script),
        "style-src": _hash(style),
        "img-src": "data: blob:",
        "connect-src": connect,
        "base-uri": "'none'",
        "form-action": "'none'",
    }
    return "; ".join(f"{name} {value}" for name, value in rules.items())


def asset(name: str) -> str:
    """A text of the built viewer."""
    return (files("physsim.view") / "assets" / name).read_text(encoding="utf-8")


def as_json(head: Mapping[str, Any]) -> str:
    """JSON that can stand in HTML: nothing in it ends or begins a tag."""
    text = json.dumps(head, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def write_page(page: Page, target: Path) -> None:
    """Never leaves half a page. Raises FileTrouble."""
    with whole_file(target) as part, part.open("wb") as file:
        file.writelines(page.parts)


def _blocks(head: Mapping[str, Any], sections: Sequence[bytes]) -> Iterator[str]:
    yield f'<script type="application/json" id="head">{as_json(head)}</script>\n'
    for number, data in enumerate(sections):
        text = base64.b64encode(data).decode("ascii")
        yield f'<script type="application/x-physsim" id="section-{number}">{text}</script>\n'


def _hash(text: str) -> str:
    digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode("ascii")
    return f"'sha256-{digest}'"

"""The fenced blocks of README and docs, and how each kind is tried out.

console   lines that begin with `$ ` are run in order; the last exits with `exit=N` of the fence, else with 0;
          where other lines follow a command, they are exactly what it writes
bash      syntax is checked: these are for a machine with a network, or for a whole checkout
python    run
yaml      a first line `# NAME.yaml` keeps the block under that name for the blocks below; any other block
          is a scene when it has the key `physsim`, and a part of one when it has not
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
PAGES = [
    REPOSITORY / "README.md",
    REPOSITORY / "CONTRIBUTING.md",
    *sorted((REPOSITORY / "docs").glob("*.md")),
]
FENCE = re.compile(r"^```(\w+)([^\n]*)\n(.*?)^```", re.DOTALL | re.MULTILINE)


@dataclass(frozen=True)
class Block:
    """One fenced block: its language, what else the fence says, and its text."""

    language: str
    remark: str
    text: str
    line: int

    @property
    def commands(self) -> list[tuple[str, str]]:
        """What a reader would type, and what the page shows as its output ("" where it shows none)."""
        parts = [part.partition("\n") for part in re.split(r"^\$ ", self.text, flags=re.MULTILINE)[1:]]
        return [(command, shown.strip("\n")) for command, _, shown in parts]

    @property
    def exit_code(self) -> int:
        found = re.search(r"exit=(\d+)", self.remark)
        return int(found[1]) if found else 0

    @property
    def name(self) -> str | None:
        """The file that the block is to be kept in."""
        found = re.match(r"# (\S+\.yaml)\n", self.text)
        return found[1] if found else None


def blocks(page: Path) -> list[Block]:
    """All fenced blocks of a page, in order."""
    text = page.read_text(encoding="utf-8")
    return [
        Block(found[1], found[2], found[3], text.count("\n", 0, found.start()) + 1)
        for found in FENCE.finditer(text)
    ]


def without_installation(command: str) -> str | None:
    """The part of a command that needs no network: what follows the installation, if anything."""
    parts = [
        part
        for part in command.split(" && ")
        if not re.search(r"\bpip install\b|-m venv\b|git clone\b", part)
    ]
    return " && ".join(parts) or None

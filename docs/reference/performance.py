"""Measured tables, from what `python -m benchmarks` and `python -m benchmarks.instructions` wrote."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from benchmarks.table import overview, tables

HERE = Path(__file__).parent.parent
MEASURED = HERE / "performance.json"
COUNTED = HERE.parent / "benchmarks" / "instructions.json"


def comparison() -> str:
    """Machine, versions, and all scenes in one table."""
    measured = json.loads(MEASURED.read_text(encoding="utf-8"))
    rows = measured["rows"]
    machine = "; ".join(f"{key}: {value}" for key, value in measured["machine"].items())
    versions = dict(sorted({row["peer"]: row["version"] for row in rows if "version" in row}.items()))
    named = ", ".join(f"{peer} {version}" for peer, version in versions.items())
    return f"{machine}; {named}.\n\n{overview(_of_defaults(rows))}"


def details() -> str:
    """A table for each scene, with what the steps were worth."""
    return tables(json.loads(MEASURED.read_text(encoding="utf-8"))["rows"])


def instructions() -> str:
    """Counts of every kernel."""
    record = json.loads(COUNTED.read_text(encoding="utf-8"))
    lines = [f"Compiler: {record['compiler']}.", "", "| kernel | instructions |", "| --- | ---: |"]
    lines += [f"| {name} | {count:,} |".replace(",", " ") for name, count in record["counts"].items()]
    return "\n".join(lines)


def _of_defaults(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    return [row for row in rows if row["setting"] == "default"]

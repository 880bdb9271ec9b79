"""Measures engines side by side, and prints tables; see `docs/performance.md`."""

from __future__ import annotations

import argparse
import json
import platform
import sys
from collections.abc import Sequence
from datetime import UTC, datetime
from fractions import Fraction
from pathlib import Path
from typing import Any

from benchmarks.cell import Request
from benchmarks.peers import PEERS
from benchmarks.picture import drawn
from benchmarks.rounds import Row, played
from benchmarks.scenes import SCENES, STANDARD
from benchmarks.table import name_of, tables


def arguments(given: Sequence[str]) -> argparse.Namespace:
    """What the user asked for."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    add = parser.add_argument
    add("--peers", default=",".join(PEERS), help="engines, each as NAME or NAME:SETTING (default: all)")
    add("--scenes", default=",".join(STANDARD), help=f"of {', '.join(SCENES)}")
    add("--timestep", default="1/240", help="[s] (default: 1/240)")
    add("--threads", type=int, default=1)
    add("--rounds", type=int, default=1, help="how often everything is run, interleaved")
    add("--limit", type=float, default=60.0, help="seconds after which a run is cut off")
    add("--json", type=Path, help="where the rows are written")
    add("--picture", type=Path, help="where speed against quality is drawn, .png or .svg")
    add("--table", type=Path, help="no measuring: the table of rows that were written before")
    return parser.parse_args(given)


def requests(asked: argparse.Namespace) -> list[Request]:
    """All cells of a round; physsim is always among them."""
    peers = asked.peers.split(",")
    if "physsim" not in peers:
        peers.insert(0, "physsim")
    return [_request(scene, peer, asked) for scene in asked.scenes.split(",") for peer in peers]


def _request(scene: str, peer: str, asked: argparse.Namespace) -> Request:
    name, _, setting = peer.partition(":")
    timestep, batch = float(Fraction(asked.timestep)), scene == "small"
    return Request(name, setting or "default", scene, timestep, asked.threads, asked.limit, batch)


def machine() -> dict[str, str]:
    """Where and when this was measured."""
    models = [
        line for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name")
    ]
    return {
        "processor": models[0].split(":")[1].strip() if models else platform.processor(),
        "processors": str(len(models)),
        "system": platform.platform(),
        "python": platform.python_version(),
        "when": datetime.now(UTC).isoformat(timespec="minutes"),
    }


def measure(asked: argparse.Namespace) -> dict[str, Any]:
    """Everything measured, told on stderr as it comes and written after every cell."""
    rows: list[Row] = []
    result: dict[str, Any] = {"machine": machine(), "rows": rows}
    for row in played(requests(asked), asked.rounds):
        rows.append(row)
        speed = row.get("unable") or [row.get(k) for k in ("busy", "rest", "world_steps") if row.get(k)]
        print(f"{row['scene']} {name_of(row)} {speed}", file=sys.stderr, flush=True)
        if asked.json:
            asked.json.write_text(json.dumps(result, indent=1))
    return result


def main() -> None:
    """Runs, prints, draws."""
    asked = arguments(sys.argv[1:])
    result = json.loads(asked.table.read_text()) if asked.table else measure(asked)
    rows = result["rows"]
    print("; ".join(f"{key}: {value}" for key, value in result["machine"].items()))
    versions = {row["peer"]: row["version"] for row in rows if "version" in row}
    print("versions: " + ", ".join(f"{peer} {version}" for peer, version in versions.items()))
    print(tables(rows))
    if asked.picture:
        drawn(rows, asked.picture)


if __name__ == "__main__":
    main()

"""Instructions of the engine's parts, counted by valgrind: noise of the machine cannot touch them.

    python -m benchmarks.instructions            counts beside those on record; ends with 1 if one has risen
    python -m benchmarks.instructions --record   what is counted now goes on record

The kernels are those of `engine/benches/kernels`. Counts depend on the compiler, whose version is on record
too; between different compilers nothing is compared. Needs cargo and valgrind.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

ENGINE = Path(__file__).parent.parent / "engine"
RECORD = Path(__file__).with_suffix(".json")
# A rise by more than this share is told as one.
SLACK = 0.02


def main() -> int:
    """What the process ends with."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.instructions", description=__doc__)
    parser.add_argument("--record", action="store_true", help="put the counts on record")
    asked = parser.parse_args()
    compiler = _said("rustc", "--version")
    counts = counted()
    nothing: dict[str, Any] = {"compiler": compiler, "counts": {}}
    record = json.loads(RECORD.read_text()) if RECORD.exists() else nothing
    print(table(counts, record["counts"]))
    if asked.record:
        RECORD.write_text(json.dumps({"compiler": compiler, "counts": counts}, indent=1) + "\n")
        return 0
    if record["compiler"] != compiler:
        print(f"not compared: {record['compiler']} is on record, this is {compiler}")
        return 0
    return int(any(count > (1 + SLACK) * record["counts"].get(name, count) for name, count in counts.items()))


def counted() -> dict[str, int]:
    """Instructions of one run of every kernel."""
    program = _built()
    return {name: _instructions(program, name) for name in _said(program).splitlines()}


def table(counts: dict[str, int], before: dict[str, int]) -> str:
    """In Markdown."""
    lines = ["| kernel | instructions | on record | ratio |", "| --- | --- | --- | --- |"]
    for name, count in counts.items():
        old = before.get(name)
        beside = f"{old} | {count / old:.3f}" if old else " | "
        lines.append(f"| {name} | {count} | {beside} |")
    return "\n".join(lines)


def _built() -> str:
    """The program, optimised as the engine is."""
    command = ["cargo", "bench", "--locked", "--no-run", "--bench", "instructions", "--message-format=json"]
    messages = map(json.loads, _said(*command, cwd=ENGINE).splitlines())
    return next(str(m["executable"]) for m in messages if m.get("executable"))


def _instructions(program: str, name: str) -> int:
    with tempfile.TemporaryDirectory() as folder:
        tool = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out"]
        command = [*tool, "--toggle-collect=instructions::measured", program, name]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
    found = re.search(r"Collected : (\d+)", done.stderr)
    assert found, done.stderr
    return int(found[1])


def _said(*command: str, cwd: Path | None = None) -> str:
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True, cwd=cwd).stdout.strip()


if __name__ == "__main__":
    sys.exit(main())

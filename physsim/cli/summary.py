"""How a run went: where the file is, how much there is, how fast it was, what was expected and what came."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import click

from physsim.cli import output

if TYPE_CHECKING:
    from physsim.recording import Trajectory
    from physsim.simulation import ExpectationResult

Facts = dict[str, Any]


def facts(trajectory: Trajectory, results: Sequence[ExpectationResult]) -> Facts:
    """Status, frames, times [s], speed (simulated seconds per second of the clock) and expectations."""
    simulated = float(trajectory.time[-1])
    wall = float(trajectory.provenance["wall_time"])
    return {
        "file": str(trajectory.path),
        "status": trajectory.status,
        "status_detail": trajectory.status_detail,
        "frames": trajectory.frames,
        "steps": int(trajectory.step[-1]),
        "simulated_time": simulated,
        "wall_time": wall,
        "speed": simulated / wall if wall > 0 else None,
        "impacts": trajectory.events.rows,
        "expectations": [asdict(result) | {"text": str(result)} for result in results],
    }


def as_text(facts: Facts, warnings: int) -> str:
    """The summary for people."""
    speed = f" ({facts['speed']:.3g}x real time)" if facts["speed"] else ""
    lines = [
        f"{click.style(facts['file'], bold=True)}: {facts['status']}, {facts['status_detail']}",
        f"{facts['frames']} frames, {facts['steps']} steps in {facts['wall_time']:.3g} s{speed}",
    ]
    if warnings:
        lines.append(f"{output.counted(warnings, 'warning', 'warnings')}, see above")
    expected = facts["expectations"]
    if expected:
        held = sum(result["held"] for result in expected)
        lines.append(f"expectations: {held} held, {len(expected) - held} failed")
        lines += [line(result) for result in expected]
    return "\n".join(lines)


def failures(facts: Facts) -> str:
    """The expectations that failed, one in a line."""
    return "\n".join(line(result) for result in facts["expectations"] if not result["held"])


def line(result: Facts) -> str:
    """One expectation: wanted, got, and whether it holds."""
    return "  " + click.style(result["text"], fg="green" if result["held"] else "red")

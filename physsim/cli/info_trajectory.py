"""What `physsim info` says of a trajectory: how far it came, what moves in it, energy and origin."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import click

from physsim.cli import output
from physsim.cli.table import number, table

if TYPE_CHECKING:
    from physsim.recording import Trajectory

Facts = dict[str, Any]
BODIES_SHOWN = 40


def show(file: str, as_json: bool) -> None:
    """Open and describe; raises FileTrouble for what is no trajectory, or damaged."""
    from physsim.cli import info_connections
    from physsim.recording import open_trajectory

    with open_trajectory(file) as trajectory:
        facts = {
            "file": str(trajectory.path),
            "trajectory": run_facts(trajectory),
            "bodies": body_facts(trajectory),
            "joints": info_connections.joint_facts(trajectory),
            "springs": info_connections.spring_facts(trajectory),
            "energy": energy_facts(trajectory),
            "provenance": provenance_facts(trajectory),
        }
    if as_json:
        output.document("info", 0, **facts)
    else:
        output.result(as_text(facts))


def run_facts(trajectory: Trajectory) -> Facts:
    """How the run ended and how much of it there is."""
    times = trajectory.time
    return {
        "title": trajectory.title,
        "status": trajectory.status,
        "status_detail": trajectory.status_detail,
        "being_written": trajectory.being_written,
        "frames": trajectory.frames,
        "first_time": float(times[0]) if len(times) else None,
        "last_time": float(times[-1]) if len(times) else None,
        "steps": int(trajectory.step[-1]) if len(times) else 0,
        "impacts": trajectory.events.rows,
        "seed": trajectory.seed,
    }


def body_facts(trajectory: Trajectory) -> list[Facts]:
    """Name, material and mass of each body."""
    columns = (trajectory.values(name) for name in ("material", "fixed", "mass"))
    return [
        {"name": name, "material": str(material), "fixed": bool(fixed), "mass": float(mass)}
        for name, material, fixed, mass in zip(trajectory.body_names, *columns, strict=True)
    ]


def energy_facts(trajectory: Trajectory) -> Facts | None:
    """First and last value of every row of the energy ledger [J]; None where it was not recorded."""
    from physsim.recording import NotInFile

    try:
        ledger = trajectory.energy
    except NotInFile:
        return None
    if trajectory.frames == 0:
        return None
    return {name: {"first": float(values[0]), "last": float(values[-1])} for name, values in ledger.items()}


def provenance_facts(trajectory: Trajectory) -> Facts:
    """Versions, host, command, clock times and mesh hashes; the scene texts stay in the file."""
    facts = {
        name: value.item() if hasattr(value, "item") else value
        for name, value in trajectory.provenance.items()
    }
    for name in ("scene", "scene_resolved"):
        facts.pop(name)
    return facts | {name: parsed(facts[name]) for name in ("versions", "mesh_sha256")}


def parsed(text: str) -> Any:
    """What a JSON text of the file says; the text itself where a damaged file holds none."""
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        return text


def as_text(facts: Facts) -> str:
    """The whole answer for people."""
    from physsim.cli import info_connections

    parts = [head_text(facts), bodies_text(facts["bodies"])]
    if facts["joints"]:
        parts.append(info_connections.joints_text(facts["joints"]))
    if facts["springs"]:
        parts.append(info_connections.springs_text(facts["springs"]))
    return "\n\n".join([*parts, energy_text(facts["energy"]), provenance_text(facts["provenance"])])


def head_text(facts: Facts) -> str:
    """Title, status, frames and time range."""
    run = facts["trajectory"]
    status = run["status"] + (f" ({run['status_detail']})" if run["status_detail"] else "")
    if run["status"] == "running":
        status = "running, being written now" if run["being_written"] else "ended without a word (killed?)"
    span = f"{number(run['first_time'])} s to {number(run['last_time'])} s"
    return (
        f"{click.style(facts['file'], bold=True)}: {run['title']}\n"
        f"{status}; {run['frames']} frames from {span}, "
        f"{run['steps']} steps, {run['impacts']} impacts"
    )


def bodies_text(bodies: list[Facts]) -> str:
    """The first bodies, one in a line."""
    rows = [
        [body["name"], "fixed" if body["fixed"] else "moves", body["material"], number(body["mass"], 6)]
        for body in bodies[:BODIES_SHOWN]
    ]
    more = (
        f"\n... and {len(bodies) - BODIES_SHOWN} more (--json shows all)"
        if len(bodies) > BODIES_SHOWN
        else ""
    )
    return table(("body", "", "material", "mass [kg]"), rows, right=(3,)) + more


def energy_text(energy: Facts | None) -> str:
    """The ledger at the first and the last frame."""
    if energy is None:
        return "Energy was not recorded."
    rows = [[name, number(row["first"], 6), number(row["last"], 6)] for name, row in energy.items()]
    return table(("energy [J]", "first", "last"), rows, right=(1, 2))


def provenance_text(provenance: Facts) -> str:
    """One line for each fact."""
    rows = [[name, flat(value)] for name, value in provenance.items() if value not in ("", {})]
    return table(("made by", ""), rows)


def flat(value: Any) -> str:
    """A value on one line."""
    if isinstance(value, dict):
        return ", ".join(f"{name} {part}" for name, part in value.items())
    return number(value) if isinstance(value, float) else str(value)

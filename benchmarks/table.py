"""Rows of measured cells as a table: medians over rounds, and ratios taken inside each round."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from statistics import median
from typing import Any

from benchmarks.rounds import Row

# name in a row -> heading, factor, format
QUALITY = {
    "depth_peak": ("peak depth mm", 1e3),
    "depth_rest": ("depth mm", 1e3),
    "drift": ("drift mm", 1e3),
    "speed_rest": ("speed mm/s", 1e3),
    "joint_error": ("joint mm", 1e3),
    "energy_error": ("energy", 1.0),
    "spin_error": ("|L|", 1.0),
    "escaped": ("escaped", 1.0),
}


def name_of(row: Row) -> str:
    """Engine, with its setting unless that is the default."""
    plain = row["peer"] if row["setting"] == "default" else f"{row['peer']}:{row['setting']}"
    return str(plain)


def overview(rows: Sequence[Row]) -> str:
    """All scenes in one table, in Markdown: milliseconds per step in the busy and the resting phase (worlds a
    second of batches), and our time over the fastest other engine's, round by round.
    """
    engines = list(dict.fromkeys(name_of(row) for row in rows))
    heads = ["scene", *engines, "physsim / fastest: busy", "rest"]
    lines = [_scene_line(place, engines, rows) for place in dict.fromkeys(map(_place, rows))]
    return "\n".join([_joined(heads), _joined(["---"] * len(heads)), *lines])


def _scene_line(place: tuple[str, int, bool], engines: Sequence[str], rows: Sequence[Row]) -> str:
    scene, threads, _ = place
    able = [row for row in rows if _place(row) == place and "unable" not in row]
    groups = {name: [row for row in able if name_of(row) == name] for name in engines}
    ratios = [_ratio_to_fastest(groups, phase) for phase in ("busy", "rest")]
    title = scene if threads == 1 else f"{scene}, {threads} threads"
    return _joined([title, *(_speed(group) if group else "-" for group in groups.values()), *ratios])


def _speed(group: Sequence[Row]) -> str:
    if "world_steps" in group[0]:
        return f"{median(row['world_steps'] for row in group):.0f}/s"
    return " / ".join(_milliseconds(group, phase) for phase in ("busy", "rest"))


def _ratio_to_fastest(groups: dict[str, list[Row]], phase: str) -> str:
    ours = groups["physsim"]
    others = [group for name, group in groups.items() if not name.startswith("physsim")]
    timed = [group for group in others if any(row.get(phase) for row in group)]
    if not timed or not ours:
        return ""
    return _ratios(ours, min(timed, key=lambda g: median(row[phase] for row in g if row.get(phase))), phase)


def tables(rows: Sequence[Row]) -> str:
    """One table per scene, in Markdown."""
    scenes = dict.fromkeys((row["scene"], row["threads"], row["batch"]) for row in rows)
    return "\n".join(_table(scene, [r for r in rows if _place(r) == scene]) for scene in scenes)


def _place(row: Row) -> tuple[str, int, bool]:
    return row["scene"], row["threads"], row["batch"]


def _table(place: tuple[str, int, bool], rows: Sequence[Row]) -> str:
    scene, threads, batch = place
    peers = dict.fromkeys(name_of(row) for row in rows)
    groups = {name: [row for row in rows if name_of(row) == name] for name in peers}
    qualities = [name for name in QUALITY if any(name in row for row in rows)]
    speeds = ["world-steps/s"] if batch else ["busy ms", "rest ms", "physsim / it: busy", "rest"]
    heads = ["engine", *speeds, *(QUALITY[name][0] for name in qualities)]
    title = f"\n### {scene}{' (batch)' if batch else ''}, {threads} thread{'s' if threads > 1 else ''}\n"
    lines = [
        _line(name, group, groups.get("physsim", []), qualities, batch) for name, group in groups.items()
    ]
    return "\n".join([title, _joined(heads), _joined(["---"] * len(heads)), *lines])


def _line(name: str, group: Sequence[Row], ours: Sequence[Row], qualities: list[str], batch: bool) -> str:
    able = [row for row in group if "unable" not in row]
    if not able:
        return _joined([name, str(group[0]["unable"])])
    if batch:
        return _joined([name, f"{median(row['world_steps'] for row in able):.0f}"])
    speeds = [_milliseconds(able, phase) for phase in ("busy", "rest")]
    ratios = [_ratios(ours, able, phase) for phase in ("busy", "rest")]
    found = [_quality(able, quality) for quality in qualities]
    return _joined([name, *speeds, *ratios, *found])


def _milliseconds(rows: Sequence[Row], phase: str) -> str:
    values = [row[phase] for row in rows if row.get(phase) is not None]
    if values:
        return f"{1e3 * median(values):.3g}"
    row = rows[-1]
    return f"> {1e3 * row['last']:.3g} (cut off at {row['reached']:.1f} s)"


def _ratios(ours: Sequence[Row], theirs: Sequence[Row], phase: str) -> str:
    """Median and range of our time over theirs, round by round."""
    other = {row["round"]: row.get(phase) for row in theirs}
    pairs = [(row.get(phase), other.get(row["round"])) for row in ours]
    ratios = [a / b for a, b in pairs if a and b]
    if not ratios or theirs[0]["peer"] == "physsim":
        return ""
    spread = f" ({min(ratios):.2f} - {max(ratios):.2f})" if len(ratios) > 1 else ""
    return f"{median(ratios):.2f}{spread}"


def _quality(rows: Sequence[Row], name: str) -> str:
    if any("blew_up" in row for row in rows):
        return "blew up"
    values = [row[name] for row in rows if name in row]
    return f"{QUALITY[name][1] * median(values):.2g}" if values else ""


def _joined(cells: Iterable[Any]) -> str:
    return "| " + " | ".join(map(str, cells)) + " |"

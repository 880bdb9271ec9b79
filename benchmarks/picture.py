"""Speed against quality, one panel per scene."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from statistics import median
from typing import Any

from benchmarks.rounds import Row
from benchmarks.table import name_of

# The quality that a scene is drawn by: the first of these that its rows have.
BY = (
    ("joint_error", "widest joint gap [m]"),
    ("depth_rest", "depth at rest [m]"),
    ("energy_error", "error of energy"),
)
LEAST = 1e-13


def drawn(rows: Sequence[Row], path: Path) -> None:
    """Milliseconds per step at rest across, the error upwards: better is down and to the left."""
    import matplotlib  # noqa: PLC0415

    matplotlib.use("Agg")
    from matplotlib import pyplot  # noqa: PLC0415

    usable = [row for row in rows if "unable" not in row and not row["batch"]]
    scenes = list(dict.fromkeys(row["scene"] for row in usable))
    across = min(3, len(scenes)) or 1
    down = -(-len(scenes) // across) or 1
    figure, axes = pyplot.subplots(down, across, figsize=(4.6 * across, 3.8 * down), squeeze=False)
    for axis, scene in zip(axes.flat, scenes, strict=False):
        _panel(axis, scene, [row for row in usable if row["scene"] == scene])
    for axis in list(axes.flat)[len(scenes) :]:
        axis.remove()
    figure.tight_layout()
    figure.savefig(path, dpi=120)
    pyplot.close(figure)


def _panel(axis: Any, scene: str, rows: Sequence[Row]) -> None:
    from matplotlib.ticker import FormatStrFormatter, LogLocator, NullFormatter  # noqa: PLC0415

    quality, label = next((q, text) for q, text in BY if any(q in row for row in rows))
    for name in dict.fromkeys(name_of(row) for row in rows):
        own = [row for row in rows if name_of(row) == name and quality in row]
        if not own:
            continue
        time = 1e3 * median(row["rest"] or row["last"] for row in own)
        error = max(LEAST, median(row[quality] for row in own))
        ours = name.startswith("physsim")
        axis.plot(time, error, "o" if ours else "s", color="tab:red" if ours else "tab:gray")
        axis.annotate(name, (time, error), textcoords="offset points", xytext=(5, 4), fontsize=8)
    axis.set(xscale="log", yscale="log", title=scene, xlabel="ms per step, at rest", ylabel=label)
    axis.margins(0.25)
    low, high = axis.get_xlim()
    axis.set_xlim(low / 1.2, high * 1.6)  # room for the names
    axis.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.xaxis.set_major_formatter(FormatStrFormatter("%g"))
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.grid(visible=True, alpha=0.3)

"""Pictures of a formula: what came over what should have come, and how the error falls with the timestep."""

from __future__ import annotations

import itertools
import textwrap
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from physsim.analysis.verify.case import Formula
from physsim.analysis.verify.judge import Verdict

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Draw = Callable[["Axes", Sequence[Verdict]], None]
WIDTH, HEIGHT = 5.0, 3.4
"""Of one panel [inch]."""
LETTERS = 70
"""Of one panel's width, in the title's type."""
MOST_CURVES = 3
"""Panels of a formula that is not refined."""
MARKERS = "osv^x+"


def draw_formula(formula: Formula, verdicts: Sequence[Verdict], file: Path) -> None:
    """The best curve and the convergence of a formula that is refined; else its first curves, or bars.

    file: its suffix says the format; the same verdicts give the same bytes of an SVG. Needs matplotlib
    (extra `plot`).
    """
    import matplotlib as mpl  # noqa: PLC0415, optional and slow to import
    from matplotlib.figure import Figure  # noqa: PLC0415

    panels = _panels(verdicts)
    with mpl.rc_context({"svg.hashsalt": formula.name, "svg.fonttype": "none", "font.size": 9}):
        figure = Figure(figsize=(WIDTH * len(panels), HEIGHT), layout="constrained")
        equation = textwrap.fill(formula.equation, LETTERS * len(panels))
        figure.suptitle(f"{formula.title}\n{equation}", fontsize=9)
        axes = np.atleast_1d(figure.subplots(1, len(panels)))
        for panel, (draw, drawn) in zip(axes, panels, strict=True):
            draw(panel, drawn)
        metadata: dict[str, Any] = {"Date": None} if file.suffix == ".svg" else {}
        figure.savefig(file, metadata=metadata)


def _panels(verdicts: Sequence[Verdict]) -> list[tuple[Draw, Sequence[Verdict]]]:
    """What is drawn side by side, and by whom."""
    curves = [v for v in verdicts if np.any(v.law) and len(v.law) == len(v.time)]
    refined = [verdict for verdict in verdicts if verdict.check.order is not None and len(verdict.errors) > 1]
    if refined and curves:
        best = min(curves, key=lambda verdict: verdict.error)
        return [(draw_curve, [best]), (draw_convergence, refined)]
    if refined:
        return [(draw_convergence, refined)]
    return [(draw_curve, [curve]) for curve in curves[:MOST_CURVES]] or [(draw_values, verdicts)]


def draw_curve(axes: Axes, verdicts: Sequence[Verdict]) -> None:
    """Of one verdict: theory as lines and measured values as dots, over time, every component in a colour
    of its own.
    """
    (verdict,) = verdicts
    rows = len(verdict.time)
    law, curve = verdict.law.reshape(rows, -1), verdict.curve.reshape(rows, -1)
    some = slice(None, None, max(1, rows // 40))
    for k in range(law.shape[1]):
        axes.plot(verdict.time, law[:, k], "-", color=f"C{k}", lw=1, label="theory" if k == 0 else None)
        axes.plot(
            verdict.time[some], curve[some, k], ".", color=f"C{k}", ms=5, label="measured" if k == 0 else None
        )
    axes.set(
        xlabel="time [s]", ylabel=f"{verdict.check.name} [{verdict.check.unit}]", title=verdict.case.name
    )
    axes.legend(frameon=False)


def draw_convergence(axes: Axes, verdicts: Sequence[Verdict]) -> None:
    """Error over timestep, both logarithmic, one line per case with its measured order."""
    for verdict, marker in zip(verdicts, itertools.cycle(MARKERS), strict=False):
        order = "-" if verdict.order is None else f"{verdict.order:.2f}"
        label = f"{verdict.case.name.rpartition('.')[2]}: {order}"
        axes.loglog(verdict.timesteps, verdict.errors, f"{marker}-", ms=5, lw=1, label=label)
    steps = sorted({timestep for verdict in verdicts for timestep in verdict.timesteps})
    axes.set_xticks(steps, [f"{1e3 * timestep:g}" for timestep in steps], minor=False)
    axes.set_xticks([], minor=True)
    axes.set(xlabel="timestep [ms]", ylabel="greatest error", title="measured order of convergence")
    axes.legend(frameon=False, fontsize=8)


def draw_values(axes: Axes, verdicts: Sequence[Verdict]) -> None:
    """Theory and measured values of every comparison as bars side by side."""
    places = np.arange(len(verdicts))
    axes.bar(places - 0.2, [verdict.theory for verdict in verdicts], 0.4, label="theory")
    axes.bar(places + 0.2, [verdict.measured for verdict in verdicts], 0.4, label="measured")
    labels = [f"{verdict.check.name} [{verdict.check.unit}]" for verdict in verdicts]
    axes.set_xticks(places, labels, rotation=20, ha="right")
    axes.axhline(0, color="k", lw=0.5)
    axes.legend(frameon=False)

"""Panels under each other: quantities of one unit share one, phase portraits and ledgers have their own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from physsim.analysis.plot.curves import Curve, Wish, curves_of, pretty
from physsim.analysis.plot.ledger import draw_ledger
from physsim.recording import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

STYLES = ("-", "--", ":", "-.")
MOST_IN_LEGEND = 12
# A picture with lines of more points than this keeps them as pixels, also in SVG and PDF.
MOST_POINTS = 20_000
WIDTH, HEIGHT = 7.5, 2.9
"""Of one panel [inch]."""


@dataclass
class Panel:
    """Curves that share their axes; `styles` has the number of the file of each."""

    key: str
    curves: list[Curve] = field(default_factory=list)
    styles: list[int] = field(default_factory=list)
    ledger: Trajectory | None = None

    @property
    def is_phase(self) -> bool:
        return self.key.startswith("vs")


def draw_trajectories(
    figure: Figure, trajectories: Sequence[Trajectory], wishes: Sequence[Wish], frames: Sequence[slice]
) -> None:
    """Draws every wish of every file into the figure, which is made as high as it needs.

    frames: of each file, those to draw. Raises NotInFile for what a file does not have.
    """
    panels = _panels(trajectories, wishes, frames)
    figure.set_size_inches(WIDTH, HEIGHT * len(panels) + 0.4)
    axes = np.atleast_1d(figure.subplots(len(panels), 1))
    names = _short_names(trajectories)
    for each, panel in zip(axes, panels, strict=True):
        if panel.ledger is not None:
            row = next(k for k, one in enumerate(trajectories) if one is panel.ledger)
            draw_ledger(each, panel.ledger, frames[row], names[row])
        else:
            _draw(each, panel, names)


def _panels(
    trajectories: Sequence[Trajectory], wishes: Sequence[Wish], frames: Sequence[slice]
) -> list[Panel]:
    panels: dict[str, Panel] = {}
    for wish in wishes:
        for row, trajectory in enumerate(trajectories):
            if wish.is_ledger:
                panels[f"ledger {row}"] = Panel("ledger", ledger=trajectory)
                continue
            for curve in curves_of(trajectory, wish, frames[row]):
                key = curve.kind if wish.over is None else f"vs {wish.quantity} {wish.over}"
                panel = panels.setdefault(key, Panel(key))
                panel.curves.append(curve)
                panel.styles.append(row)
    return list(panels.values())


def _draw(axes: Axes, panel: Panel, names: Sequence[str]) -> None:
    """One colour per quantity, one dash per file."""
    labels = list(dict.fromkeys(curve.label for curve in panel.curves))
    for curve, row in zip(panel.curves, panel.styles, strict=True):
        color = f"C{labels.index(curve.label) % 10}" if not panel.is_phase else f"C{row % 10}"
        style = STYLES[row % len(STYLES)] if not panel.is_phase else "-"
        axes.plot(
            curve.x,
            curve.y,
            style,
            color=color,
            lw=1.1,
            label=_label(curve, names[row], len(names), panel),
            rasterized=len(curve.x) > MOST_POINTS,
        )
        if panel.is_phase:
            axes.plot(curve.x[:1], curve.y[:1], "o", color=color, ms=4)
    _name_axes(axes, panel)
    count = len(panel.curves)
    if count > MOST_IN_LEGEND:
        axes.set_title(f"{count} curves, {labels[0]} to {labels[-1]}")
    elif count > 1:
        axes.legend(frameon=False, fontsize=8, ncols=1 + count // 7)
    axes.grid(alpha=0.25)


def _label(curve: Curve, file: str, files: int, panel: Panel) -> str:
    if panel.is_phase:
        return file
    return curve.label if files == 1 else f"{file}: {curve.label}"


def _name_axes(axes: Axes, panel: Panel) -> None:
    """The field where all curves are of one (`position [m]`), else what they measure (`length [m]`)."""
    first = panel.curves[0]
    if panel.is_phase:
        axes.set(xlabel=first.kind, ylabel=first.field)
        return
    fields = {curve.field for curve in panel.curves}
    word = first.field if len(fields) == 1 else first.kind.partition(" ")[2]
    owners = {curve.owner for curve in panel.curves}
    if len(panel.curves) == 1:
        word = first.label
    elif len(fields) == len(owners) == 1 and first.owner:
        word = f"{first.owner} {word}"
    axes.set(xlabel="time [s]", ylabel=f"{word} [{pretty(first.unit)}]" if first.unit else word)


def _short_names(trajectories: Sequence[Trajectory]) -> list[str]:
    """Names of the files, with their folders where the names alone are not different."""
    short = [trajectory.path.stem for trajectory in trajectories]
    return short if len(set(short)) == len(short) else [str(trajectory.path) for trajectory in trajectories]

"""A fit against its data: curves over points, and what is left between them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import NDArray

from physsim.analysis.plot.curves import axis_word, pretty
from physsim.analysis.plot.panels import HEIGHT, WIDTH

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Floats = NDArray[np.float64]


class Compared(Protocol):
    """A measured quantity and what the simulation makes of it: times [s], values and sigma in SI."""

    @property
    def file(self) -> str: ...
    @property
    def quantity(self) -> str: ...
    @property
    def unit(self) -> str: ...
    @property
    def time(self) -> Floats: ...
    @property
    def measured(self) -> Floats: ...
    @property
    def fitted(self) -> Floats: ...
    @property
    def sigma(self) -> float: ...


def draw_fit(figure: Figure, compared: Sequence[Compared], estimates: str) -> None:
    """For every measured quantity the data with the fit through them, and below the difference.

    estimates: a text above the panels.
    """
    figure.set_size_inches(WIDTH, 1.5 * HEIGHT * len(compared) + 0.4)
    figure.suptitle(estimates, fontsize=9)
    axes = figure.subplots(2 * len(compared), 1, height_ratios=[3, 1] * len(compared), squeeze=False)[:, 0]
    for one, above, below in zip(compared, axes[::2], axes[1::2], strict=True):
        order = np.argsort(one.time)
        unit = f" [{pretty(one.unit)}]" if one.unit else ""
        above.plot(one.time, one.measured, ".", color="0.5", ms=4, label=f"measured ({one.file})")
        above.plot(one.time[order], one.fitted[order], "-", color="C0", lw=1.2, label="fit")
        above.set(ylabel=f"{axis_word(one.quantity)}{unit}")
        above.legend(frameon=False, fontsize=8)
        below.axhspan(-one.sigma, one.sigma, color="C0", alpha=0.15, lw=0)
        below.plot(one.time, one.measured - one.fitted, ".", color="0.5", ms=3)
        below.axhline(0, color="C0", lw=0.8)
        below.set(xlabel="time [s]", ylabel=f"left{unit}")

"""The energy ledger as a stack: where every joule is, or went."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from physsim.recording import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Floats = NDArray[np.float64]
KINETIC = ("kinetic_translational", "kinetic_rotational")
POTENTIAL = ("gravitational", "gravitation", "spring")
LOST = ("lost_damping", "lost_friction", "lost_impact")
SUPPLIED = ("work_forces", "work_motors", "stabilization")
COLORS = {
    "kinetic_translational": "#1f77b4",
    "kinetic_rotational": "#6baed6",
    "gravitational": "#2ca02c",
    "gravitation": "#98df8a",
    "spring": "#bcbd22",
    "lost_damping": "#d9d9d9",
    "lost_friction": "#bdbdbd",
    "lost_impact": "#969696",
}


def stack(trajectory: Trajectory, frames: slice) -> tuple[dict[str, Floats], Floats]:
    """Layers by name (T) J, those that are 0 throughout left out, and what they should add up to.

    Potential energies have no natural zero: each is counted from its lowest value in these frames, so that
    no layer is negative. The sum of the layers is what was there at the first of them and what was supplied
    since; the difference of the two is the residual of the books.
    """
    energy = {name: column[frames] for name, column in trajectory.energy.items()}
    layers = {name: energy[name] for name in (*KINETIC, *POTENTIAL, *LOST) if name in energy}
    for name in POTENTIAL:
        if name in layers:
            layers[name] = layers[name] - layers[name].min(initial=np.inf)
    for name in LOST:
        layers[name] = layers[name] - layers[name][:1]
    start = sum(layer[:1] for layer in layers.values())
    supplied = sum(energy[name] - energy[name][:1] for name in SUPPLIED)
    shown = {name: layer for name, layer in layers.items() if np.any(layer)}
    return shown, np.asarray(start + supplied, np.float64)


def draw_ledger(axes: Axes, trajectory: Trajectory, frames: slice, name: str) -> None:
    """The stack over time, and as a line what should be there. Raises NotInFile without energies."""
    layers, supplied = stack(trajectory, frames)
    time = trajectory.time[frames]
    if layers:
        axes.stackplot(
            time,
            list(layers.values()),
            labels=[layer.replace("_", " ") for layer in layers],
            colors=[COLORS[layer] for layer in layers],
        )
    axes.plot(time, supplied, "k--", lw=1, label="at the start + supplied")
    axes.set(xlabel="time [s]", ylabel="energy [J]", title=name)
    axes.margins(x=0)
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(
        handles[::-1], labels[::-1], frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5)
    )

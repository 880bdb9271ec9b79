"""Writes docs/integrators.md and docs/images/integrators.svg: the sheet's table of integrators with
measured numbers.

    python docs/integrators.py

Runs scenes of `physsim verify` with every integrator; takes about half a minute.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from physsim.analysis.verify import Verdict, pick
from physsim.analysis.verify.orders import ORDERS
from physsim.analysis.verify.plot import MARKERS
from physsim.analysis.verify.sections.integration import relative_energy
from physsim.cli.verify_run import run, try_out
from physsim.errors import RunFailed

HERE = Path(__file__).resolve().parent
SYSTEMS = {
    "integrator": "oscillator",
    "spring_damper": "damped",
    "natural_frequency.coupled": "coupled",
    "torsional_spring": "torsional",
    "kepler": "Kepler",
    "free_rotation": "free body",
    "heavy_top": "heavy top",
    "pendulum": "pendulum",
    "double_pendulum": "double pendulum",
}
"""Cases with every integrator, and what the table calls them."""
SHEET = {
    "explicit_euler": ("1st", "gains energy"),
    "semi_implicit_euler": ("1st (symplectic)", "conserves (near)"),
    "verlet": ("2nd", "conserves well"),
    "velocity_verlet": ("2nd", "conserves well"),
    "leapfrog": ("2nd", "symplectic"),
    "rk4": ("4th", "slightly dissipative"),
}
"""What the sheet says: order, energy."""
TIMESTEP, STEPS_SHORT, STEPS_LONG = 5e-3, 1_000, 100_000
"""[s], with omega = 4 rad/s: omega dt = 0.02."""
HEAD = """# Integrators compared

The comparison table of the formula sheet with this engine's numbers, written by
[integrators.py](integrators.py). Orders are slopes of log(error) over log(timestep) at three timesteps
against closed forms (the double pendulum: against DOP853 at 1e-13); the systems are those of `physsim
verify`, with pictures in [formulas.md](formulas.md). Energy is that of an undamped oscillator with ω dt =
0.02, over its value at the start.
"""
TAIL = """
![Error over timestep, and energy over time, of every integrator](images/integrators.svg)

*Left: the oscillator after 1.6 s. The three rules of second order lie on one line: Störmer's rule,
velocity Verlet and the leapfrog run through the same positions, and all quantities of a frame are brought
to one instant. Right: energy over 400 steps with ω dt = 0.2, where the differences are plain to see.*

What the numbers say:

* Explicit Euler multiplies the energy of an oscillator by 1 + (ω dt)² in every step, whatever is done
afterwards. It is there to be compared with, not to be used.
* The symplectic rules keep a modified energy to rounding, so the true one swings within a band (of first
order for semi-implicit Euler, of second order for the others) and does not drift.
* RK4 loses (ω dt)⁶/72 of the energy per step. It is the most exact rule over times that are short compared
with that, and the only one here that reaches 1e-8 on jointed systems at 1 ms.
"""


def main() -> int:
    """Measure, write the page, draw the picture."""
    with TemporaryDirectory() as folder:
        orders = measured_orders(Path(folder))
        energies = {name: measured_energy(name, Path(folder)) for name in ORDERS}
        draw(Path(folder), HERE / "images" / "integrators.svg")
    page = "\n".join([HEAD, table_of_orders(orders), "", table_of_energies(energies), TAIL])
    (HERE / "integrators.md").write_text(page, encoding="utf-8")
    return 0


def measured_orders(folder: Path) -> dict[str, dict[str, float | None]]:
    """Order by system and integrator."""
    found: dict[str, dict[str, float | None]] = {}
    for system in SYSTEMS:
        verdicts = [
            v
            for formula in pick([f"{system}.{name}" for name in ORDERS])
            for v in try_out(formula, folder).verdicts
        ]
        found[system] = {last_word(verdict): verdict.order for verdict in verdicts}
    return found


def last_word(verdict: Verdict) -> str:
    """The integrator of a case."""
    return verdict.case.name.rpartition(".")[2]


def measured_energy(integrator: str, folder: Path) -> tuple[float, float, float]:
    """E / E_0 - 1 after the short and the long run, and the greatest size of it in the long run."""
    short = energy_change(integrator, STEPS_SHORT, folder)
    try:
        change = energy_change(integrator, STEPS_LONG, folder)
    except RunFailed:
        return float(short[-1]), np.inf, np.inf
    return float(short[-1]), float(change[-1]), float(np.abs(change).max())


def energy_change(integrator: str, steps: int, folder: Path) -> np.ndarray:
    """E / E_0 - 1 at every 20th step."""
    changes = {
        "simulation.integrator": integrator,
        "simulation.timestep": TIMESTEP,
        "simulation.duration": TIMESTEP * steps,
        "record.every": TIMESTEP * 20,
        "expect": [],
    }
    with run("oscillator", changes, folder) as trajectory:
        return relative_energy(trajectory) - 1


def table_of_orders(orders: dict[str, dict[str, float | None]]) -> str:
    """Methods down, systems across."""
    lines = [
        "| method | order in the sheet | " + " | ".join(SYSTEMS.values()) + " |",
        "|---" * (2 + len(SYSTEMS)) + "|",
    ]
    for name, (order, _) in SHEET.items():
        cells = [f"{orders[system][name]:.2f}" for system in SYSTEMS]
        lines.append(f"| {name} | {order} | {' | '.join(cells)} |")
    return "\n".join(lines)


def table_of_energies(energies: dict[str, tuple[float, float, float]]) -> str:
    """Methods down; the sheet's word, and what was measured."""
    lines = [
        "| method | energy in the sheet | E/E₀ − 1 after 1 000 steps | after 100 000 steps | greatest |",
        "|---|---|---|---|---|",
    ]
    for name, (_, word) in SHEET.items():
        lines.append(f"| {name} | {word} | {' | '.join(change(value) for value in energies[name])} |")
    return "\n".join(lines)


def change(value: float) -> str:
    """A number of the table of energies."""
    return f"{value:.2g}" if np.isfinite(value) else "the run blows up"


def draw(folder: Path, file: Path) -> None:
    """Error over timestep, and energy over time."""
    with mpl.rc_context({"svg.hashsalt": "integrators", "svg.fonttype": "none", "font.size": 9}):
        figure = Figure(figsize=(10, 4), layout="constrained")
        left, right = figure.subplots(1, 2)
        timesteps = (1e-3, 2e-3, 4e-3, 8e-3, 16e-3, 32e-3)
        for name, marker in zip(ORDERS, MARKERS, strict=True):
            left.loglog(timesteps, errors(name, timesteps, folder), f"{marker}-", lw=1, ms=5, label=name)
            steps, energy = energy_over_steps(name, folder)
            right.plot(steps, energy, lw=1, label=name)
        left.set_xticks(timesteps, [f"{1e3 * timestep:g}" for timestep in timesteps])
        left.set_xticks([], minor=True)
        left.set(xlabel="timestep [ms]", ylabel="greatest error, part of the amplitude", title="oscillator")
        left.legend(frameon=False, fontsize=8)
        right.set(xlabel="steps", ylabel="E / E₀", ylim=(0.7, 2.0), title="energy, ω dt = 0.2")
        right.legend(frameon=False, fontsize=8)
        figure.savefig(file, metadata={"Date": None})


def errors(integrator: str, timesteps: Sequence[float], folder: Path) -> list[float]:
    """Greatest error of the oscillator over 1.6 s by timestep, as a part of the amplitude."""
    found = []
    for timestep in timesteps:
        changes = {
            "simulation.integrator": integrator,
            "simulation.timestep": timestep,
            "record.every": 0.032,
            "expect": [],
        }
        with run("oscillator", changes, folder) as trajectory:
            x = trajectory.body("mass").position[:, 0] - 1.0
            found.append(float(np.abs(x - 0.1 * np.cos(4 * trajectory.time)).max() / 0.1))
    return found


def energy_over_steps(integrator: str, folder: Path) -> tuple[np.ndarray, np.ndarray]:
    """Steps, and energy over its first value, with omega dt = 0.2."""
    changes = {
        "simulation.integrator": integrator,
        "simulation.timestep": 0.05,
        "simulation.duration": 20.0,
        "record.every": 0.05,
        "expect": [],
    }
    with run("oscillator", changes, folder) as trajectory:
        return trajectory.step[:], relative_energy(trajectory)


if __name__ == "__main__":
    sys.exit(main())

"""Doubts about springs, servos and dampers: too stiff or too strong for the timestep."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import exp, log

from physsim.model import stability
from physsim.model.findings import Findings, Path
from physsim.model.joint_mobility import FREE, greatest_mobility, mobility
from physsim.model.joints import JointTable
from physsim.model.modes import fastest_mode
from physsim.model.oscillation import Oscillation
from physsim.model.springs import SpringTable

GROWTH = 1.01
"""Times that explicit Euler may make an amplitude grow over a run before it is told."""
ROUNDING = 1e-9
ALREADY_TOLD = 1.05
"""The fastest mode of all springs is told when it is faster than every single one by this factor."""


@dataclass(frozen=True)
class Stepping:
    """What the bounds depend on: the scheme, its timestep [s], and how many steps a run takes."""

    integrator: str
    timestep: float
    steps: int


def check_stiffness(springs: SpringTable, joints: JointTable, stepping: Stepping, findings: Findings) -> None:
    """Write what is too stiff or damped too strongly for the timestep into `findings`, with the numbers."""
    checker = _Checker(stepping, findings)
    for path, oscillation in (*_of_springs(springs), *_of_drives(joints), *_of_damped_turning(joints)):
        if oscillation.damping_ratio is None:
            checker.damper(path, oscillation.damping_rate)
        else:
            checker.swing(path, _Swing(oscillation.angular_frequency, oscillation.damping_ratio))
    mode = fastest_mode(springs.rows)
    if mode is not None and mode.angular_frequency > ALREADY_TOLD * _fastest_alone(springs):
        together = _Swing(mode.angular_frequency, mode.damping_ratio, "together with its neighbours ")
        checker.swing(("springs", springs.names[mode.spring]), together)


def _of_springs(springs: SpringTable) -> Iterator[tuple[Path, Oscillation]]:
    for name, row in zip(springs.names, springs.rows, strict=True):
        yield ("springs", name), Oscillation(row.largest_stiffness, row.largest_damping, row.mobility)


def _of_drives(joints: JointTable) -> Iterator[tuple[Path, Oscillation]]:
    """Springs, servos and damping of joint coordinates."""
    for drive in joints.drives:
        joint = joints.rows[drive.joint]
        if joint.kind in FREE and (drive.stiffness > 0 or drive.viscosity > 0):
            moved = mobility(joint, drive.coordinate)
            yield ("joints", joints.names[drive.joint]), Oscillation(drive.stiffness, drive.viscosity, moved)


def _of_damped_turning(joints: JointTable) -> Iterator[tuple[Path, Oscillation]]:
    """Damping of ball and cone joints; the rows of stops of springs, which come last, have no names."""
    for name, joint in zip(joints.names, joints.rows, strict=False):
        if joint.damping > 0:
            yield ("joints", name), Oscillation(0.0, joint.damping, greatest_mobility(joint))


def _fastest_alone(springs: SpringTable) -> float:
    """Springs that share bodies swing faster together than each does by itself."""
    return max(oscillation.angular_frequency for _, oscillation in _of_springs(springs))


@dataclass(frozen=True)
class _Swing:
    """omega [rad/s], damping ratio, and words for what swings."""

    omega: float
    zeta: float
    words: str = ""


class _Checker:
    """Compares what swings and what is damped with the bounds of the scheme."""

    def __init__(self, stepping: Stepping, findings: Findings) -> None:
        self._stepping = stepping
        self._findings = findings

    def swing(self, path: Path, swing: _Swing) -> None:
        integrator, omega_dt = self._stepping.integrator, swing.omega * self._stepping.timestep
        bound = stability.largest_step(integrator, swing.zeta)
        if omega_dt <= bound * (1 + ROUNDING):
            return
        numbers = (
            f"omega dt = {omega_dt:.3g} (omega = {swing.omega:.4g} rad/s, damping ratio {swing.zeta:.3g})"
        )
        if integrator == "explicit_euler" and swing.zeta < 1:
            growth = stability.explicit_euler_growth(omega_dt, swing.zeta)
            self._growth(
                path, growth, f"{swing.words}gains energy at every step of explicit_euler: {numbers}"
            )
            return
        self._findings.warn(
            path,
            f"{swing.words}is too stiff for the timestep: {numbers}, {integrator} grows beyond {bound:.3g}",
            hint=f"a timestep below {bound / swing.omega:.2g} s, or a softer spring",
        )

    def damper(self, path: Path, rate: float) -> None:
        """A damper without a spring: v' = -c v / m, rate = c / m [1/s]."""
        bound = stability.largest_damping_step(self._stepping.integrator)
        if rate * self._stepping.timestep > bound:
            self._findings.warn(
                path,
                f"damps too strongly for the timestep: c dt / m = {rate * self._stepping.timestep:.3g}, and "
                f"{self._stepping.integrator} blows up beyond {bound:.3g}",
                hint=f"a timestep below {bound / rate:.2g} s, or less damping",
            )

    def _growth(self, path: Path, growth: float, told: str) -> None:
        """Explicit Euler feeds every swing that is not damped enough: told when it shows within the run."""
        exponent = self._stepping.steps * log(growth)
        if exponent > log(GROWTH):
            times = f"{exp(exponent):.3g} times" if exponent < log(1e6) else "more than a million times"
            hint = "any other integrator keeps it; or a shorter timestep, or more damping"
            self._findings.warn(path, f"{told}, its swing grows {times} over the run", hint=hint)

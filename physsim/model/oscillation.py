"""What a spring does with the mass at its ends: frequency and damping, for `info` and for checks."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt


@dataclass(frozen=True)
class Oscillation:
    """A harmonic oscillator x'' + c/m x' + k/m x = 0, linear or torsional.

    stiffness k [N/m or N m/rad], damping c [N s/m or N m s/rad], mobility 1/m [1/kg or 1/(kg m^2)].
    Formula sheet, section 4.
    """

    stiffness: float
    damping: float
    mobility: float

    @property
    def angular_frequency(self) -> float:
        """Natural, undamped: sqrt(k / m) [rad/s]; 0 where nothing moves or nothing pulls back."""
        return sqrt(max(self.stiffness, 0.0) * self.mobility)

    @property
    def frequency(self) -> float:
        """Natural, undamped [Hz]."""
        return self.angular_frequency / (2 * pi)

    @property
    def critical_damping(self) -> float | None:
        """2 sqrt(k m) [N s/m or N m s/rad]; None without a frequency."""
        return 2 * self.stiffness / self.angular_frequency if self.angular_frequency > 0 else None

    @property
    def damping_ratio(self) -> float | None:
        """c / (2 sqrt(k m)); None without a frequency."""
        return self.damping / self.critical_damping if self.critical_damping else None

    @property
    def damping_rate(self) -> float:
        """c / m [1/s]."""
        return self.damping * self.mobility

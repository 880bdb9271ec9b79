"""What numbers in a scene measure: name, SI unit, dimension, usual units and the magnitudes that make sense.

The bounds are far outside of anything mechanical (from atoms to stars); they keep products such as density
times volume times length squared inside double precision.
"""

from __future__ import annotations

from dataclasses import dataclass

from physsim.scene.units import PLAIN, Dimension, parse_unit


@dataclass(frozen=True)
class Kind:
    """A kind of physical value; positive ones are at least `smallest`, magnitudes at most `largest`.

    any_unit: every dimension is taken.
    """

    name: str
    unit: str
    usual: tuple[str, ...]
    smallest: float
    largest: float
    any_unit: bool = False

    @property
    def dimension(self) -> Dimension:
        """Powers of kg, m, s and rad."""
        return parse_unit(self.unit).dimension if self.unit else PLAIN

    def wanted(self) -> str:
        """`a length (m, mm, cm, ...)`, for messages."""
        if not self.unit:
            return self.name if self.any_unit else f"{self.name} without a unit"
        return f"{self.name} in {self.unit}" + (f" (or {', '.join(self.usual)})" if self.usual else "")


ANYTHING = Kind("a number with any unit", "", (), 1e-300, 1e60, any_unit=True)
COORDINATE = Kind("an angle or a length", "", (), 1e-300, 1e60, any_unit=True)
NUMBER = Kind("a number", "", (), 1e-300, 1e30)
LENGTH = Kind("a length", "m", ("mm", "cm", "km", "in", "ft"), 1e-9, 1e15)
AREA = Kind("an area", "m^2", ("cm^2", "mm^2"), 1e-18, 1e30)
MASS = Kind("a mass", "kg", ("g", "t", "lb"), 1e-18, 1e35)
TIME = Kind("a time", "s", ("ms", "us", "min", "h"), 1e-12, 1e15)
ANGLE = Kind("an angle", "rad", ("deg", "turn"), 1e-12, 1e9)
SPEED = Kind("a speed", "m/s", ("cm/s", "km/h", "mph"), 1e-15, 1e12)
ANGULAR_SPEED = Kind("an angular speed", "rad/s", ("deg/s", "rpm"), 1e-15, 1e12)
ACCELERATION = Kind("an acceleration", "m/s^2", ("g0",), 1e-15, 1e15)
DENSITY = Kind("a density", "kg/m^3", ("g/cm^3",), 1e-12, 1e20)
INERTIA = Kind("a moment of inertia", "kg*m^2", ("g*cm^2",), 1e-45, 1e60)
FORCE = Kind("a force", "N", ("kN", "lbf"), 1e-30, 1e30)
TORQUE = Kind("a torque", "N*m", ("kN*m",), 1e-30, 1e30)
ENERGY = Kind("an energy", "J", ("kJ", "Wh"), 1e-30, 1e60)
STIFFNESS = Kind("a stiffness", "N/m", ("kN/m",), 1e-30, 1e20)
DAMPING = Kind("a damping coefficient", "N*s/m", (), 1e-30, 1e20)
TURNING_STIFFNESS = Kind("a torsional stiffness", "N*m/rad", ("N*m/deg",), 1e-30, 1e20)
TURNING_DAMPING = Kind("a torsional damping coefficient", "N*m*s/rad", (), 1e-30, 1e20)
FREQUENCY = Kind("a frequency", "Hz", ("kHz",), 1e-15, 1e12)
GRAVITATION = Kind("a constant of gravitation", "m^3/(kg*s^2)", (), 1e-30, 1e30)
LINEAR_MOMENTUM = Kind("a momentum", "kg*m/s", ("N*s",), 1e-60, 1e60)
ANGULAR_MOMENTUM = Kind("an angular momentum", "kg*m^2/s", ("N*m*s",), 1e-60, 1e60)

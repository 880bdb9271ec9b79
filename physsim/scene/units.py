"""Numbers with units: `5 cm`, `1200 rpm`, `7.85 g/cm^3` -> SI value and dimension.

Grammar: `NUMBER UNIT`, where UNIT is unit names joined by `*`, a middle dot or a space (product) and `/`
(divides the next factor only; parentheses group), each with a power written `^2`, `**2`, as a superscript, or
as a bare digit (`m/s2`). A number without a unit is SI. Radians are followed through, so that `5 Hz` is no
angular speed, but may be left out beside kilograms (`N*m` for `N*m/rad`).

Temperatures and other scales with an offset are not units of mechanics and are left out on purpose.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from physsim.scene.suggest import did_you_mean

Dimension = tuple[float, float, float, float]
"""Powers of kilogram, metre, second and radian."""

PLAIN: Dimension = (0.0, 0.0, 0.0, 0.0)
_BASE = ("kg", "m", "s", "rad")
_MAX_TEXT = 80
_MAX_POWER = 9
_MAX_NESTING = 4


class UnitError(ValueError):
    """The text is no number with a unit; `hint` names the likely slip."""

    def __init__(self, message: str, hint: str | None = None) -> None:
        super().__init__(message)
        self.hint = hint


@dataclass(frozen=True, slots=True)
class Measure:
    """A value in SI units with its dimension; `PLAIN` stands for a number without a unit."""

    value: float
    dimension: Dimension = PLAIN


@dataclass(frozen=True, slots=True)
class Unit:
    """One unit in SI: `factor * pi**turns`. The factor is exact, so that `57 cm` is 0.57 to the last bit."""

    factor: Fraction
    dimension: Dimension = PLAIN
    turns: int = 0

    def in_si(self, number: float) -> float:
        """That many of this unit in SI."""
        return number * float(self.factor.numerator) / float(self.factor.denominator) * math.pi**self.turns

    def times(self, other: Unit, power: int) -> Unit:
        """The unit self * other**power."""
        dimension = multiply(self.dimension, other.dimension, power)
        return Unit(self.factor * other.factor**power, dimension, self.turns + power * other.turns)


def _unit(
    factor: str | Fraction, kg: int = 0, m: int = 0, s: int = 0, *, rad: int = 0, turns: int = 0
) -> Unit:
    return Unit(Fraction(factor), (float(kg), float(m), float(s), float(rad)), turns)


# Exact by definition (BIPM, SI Brochure, 9th ed., 2019; international yard and pound agreement, 1959).
_INCH, _POUND, _GRAVITY = Fraction("0.0254"), Fraction("0.45359237"), Fraction("9.80665")
UNITS: dict[str, Unit] = {
    "%": _unit("0.01"),
    # length
    "m": _unit("1", m=1),
    "km": _unit("1e3", m=1),
    "dm": _unit("0.1", m=1),
    "cm": _unit("0.01", m=1),
    "mm": _unit("1e-3", m=1),
    "um": _unit("1e-6", m=1),
    "nm": _unit("1e-9", m=1),
    "in": _unit(_INCH, m=1),
    "inch": _unit(_INCH, m=1),
    "ft": _unit(12 * _INCH, m=1),
    "yd": _unit(36 * _INCH, m=1),
    "mi": _unit(63360 * _INCH, m=1),
    "mile": _unit(63360 * _INCH, m=1),
    # mass
    "kg": _unit("1", kg=1),
    "g": _unit("1e-3", kg=1),
    "mg": _unit("1e-6", kg=1),
    "t": _unit("1e3", kg=1),
    "lb": _unit(_POUND, kg=1),
    "oz": _unit(_POUND / 16, kg=1),
    # time and frequency
    "s": _unit("1", s=1),
    "ms": _unit("1e-3", s=1),
    "us": _unit("1e-6", s=1),
    "ns": _unit("1e-9", s=1),
    "min": _unit("60", s=1),
    "h": _unit("3600", s=1),
    "day": _unit("86400", s=1),
    "Hz": _unit("1", s=-1),
    "kHz": _unit("1e3", s=-1),
    # angle and angular speed
    "rad": _unit("1", rad=1),
    "mrad": _unit("1e-3", rad=1),
    "deg": _unit("1/180", rad=1, turns=1),
    "rev": _unit("2", rad=1, turns=1),
    "turn": _unit("2", rad=1, turns=1),
    "rpm": _unit("1/30", s=-1, rad=1, turns=1),
    # speed and acceleration
    "kph": _unit("5/18", m=1, s=-1),
    "mph": _unit(63360 * _INCH / 3600, m=1, s=-1),
    "knot": _unit("1852/3600", m=1, s=-1),
    "g0": _unit(_GRAVITY, m=1, s=-2),
    # force
    "N": _unit("1", 1, 1, -2),
    "mN": _unit("1e-3", 1, 1, -2),
    "kN": _unit("1e3", 1, 1, -2),
    "MN": _unit("1e6", 1, 1, -2),
    "lbf": _unit(_POUND * _GRAVITY, 1, 1, -2),
    "kgf": _unit(_GRAVITY, 1, 1, -2),
    # energy and power
    "J": _unit("1", 1, 2, -2),
    "mJ": _unit("1e-3", 1, 2, -2),
    "kJ": _unit("1e3", 1, 2, -2),
    "MJ": _unit("1e6", 1, 2, -2),
    "Wh": _unit("3600", 1, 2, -2),
    "kWh": _unit("3.6e6", 1, 2, -2),
    "W": _unit("1", 1, 2, -3),
    "mW": _unit("1e-3", 1, 2, -3),
    "kW": _unit("1e3", 1, 2, -3),
    "MW": _unit("1e6", 1, 2, -3),
    # pressure
    "Pa": _unit("1", 1, -1, -2),
    "kPa": _unit("1e3", 1, -1, -2),
    "MPa": _unit("1e6", 1, -1, -2),
    "GPa": _unit("1e9", 1, -1, -2),
    "bar": _unit("1e5", 1, -1, -2),
    "psi": _unit(_POUND * _GRAVITY / _INCH**2, 1, -1, -2),
    # volume
    "l": _unit("1e-3", m=3),
    "L": _unit("1e-3", m=3),
    "ml": _unit("1e-6", m=3),
    "mL": _unit("1e-6", m=3),
}
# The micro sign and the Greek letter look alike: both are read.
UNITS |= {sign + name: UNITS["u" + name] for sign in "µμ" for name in ("m", "s")} | {"°": UNITS["deg"]}

_NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)", re.ASCII)
_TOKEN = re.compile(
    r"\s*(?:(?P<name>[A-Za-zµμ°%]+0?)|(?P<power>(?:\^|\*\*)?\s*-?\d+|⁻?[¹²³⁴⁵⁶⁷⁸⁹]+)|(?P<sign>[*·⋅/()]))"
)
_SUPERSCRIPT = str.maketrans("⁻¹²³⁴⁵⁶⁷⁸⁹", "-123456789")


def multiply(a: Dimension, b: Dimension, power: float = 1.0) -> Dimension:
    """Dimension of a * b**power."""
    return (a[0] + power * b[0], a[1] + power * b[1], a[2] + power * b[2], a[3] + power * b[3])


def without_angle(dimension: Dimension) -> Dimension:
    """The dimension with the radian left out, as SI counts it."""
    return (*dimension[:3], 0.0)


def same(a: Dimension, b: Dimension) -> bool:
    """Whether two dimensions are equal; powers may be fractions, from roots."""
    return a == b or all(abs(x - y) < 1e-9 for x, y in zip(a, b, strict=True))


def fits(given: Dimension, wanted: Dimension) -> bool:
    """Whether a unit of dimension `given` may stand where `wanted` is asked for (N*m for N*m/rad is fine)."""
    return same(given, wanted) or (wanted[0] != 0 and same(without_angle(given), without_angle(wanted)))


def dimension_text(dimension: Dimension) -> str:
    """`kg m^2/s^2` for (1, 2, -2, 0); `no unit` for a plain number."""
    over = [_power(name, p) for name, p in zip(_BASE, dimension, strict=True) if p > 0]
    under = [_power(name, -p) for name, p in zip(_BASE, dimension, strict=True) if p < 0]
    if not over and not under:
        return "no unit"
    return " ".join(over or ["1"]) + "".join(f"/{factor}" for factor in under)


def _power(name: str, power: float) -> str:
    return name if power == 1 else f"{name}^{power:g}"


@lru_cache(maxsize=4096)
def parse_measure(text: str) -> Measure:
    """Read `NUMBER` or `NUMBER UNIT`.

    Raises UnitError when the text is anything else, when the unit is unknown, or when the SI value is not
    finite.
    """
    if len(text) > _MAX_TEXT:
        raise UnitError(f"is too long for a number with a unit (at most {_MAX_TEXT} characters)")
    match = _NUMBER.match(text)
    if not match:
        raise UnitError("is not a number", _slip(text))
    rest = text[match.end() :]
    if rest.startswith((",", "_")):
        raise UnitError("is not a number", "write the decimals after a point, and digits without separators")
    unit = parse_unit(rest.strip()) if rest.strip() else Unit(Fraction(1))
    try:
        value = unit.in_si(float(match[1]))
    except OverflowError:
        value = math.inf
    if not math.isfinite(value):
        raise UnitError("must be finite")
    return Measure(value, unit.dimension)


def _slip(text: str) -> str | None:
    if "," in text:
        return "write the decimals after a point"
    if text.strip().lower().lstrip("+-.").startswith(("inf", "nan")):
        return "every number in a scene is finite"
    return None


@lru_cache(maxsize=512)
def parse_unit(text: str) -> Unit:
    """Read a unit such as `kg*m^2/s^2`. Raises UnitError."""
    tokens = _tokens(text)
    unit = _Units(tokens).product(0)
    if tokens:
        raise UnitError(f"has '{tokens[0][1]}' too much in its unit")
    return unit


def _tokens(text: str) -> list[tuple[str, str]]:
    tokens, at = [], 0
    while at < len(text.rstrip()):
        match = _TOKEN.match(text, at)
        if not match:
            raise UnitError(f"has a unit that cannot be read at '{text[at:].strip()}'")
        tokens.append((str(match.lastgroup), match[0].strip()))
        at = match.end()
    return tokens


class _Units:
    """Recursive descent over the tokens of one unit; tokens are taken from the front."""

    def __init__(self, tokens: list[tuple[str, str]]) -> None:
        self.tokens = tokens

    def product(self, depth: int) -> Unit:
        total = self._first(depth)
        while self.tokens and self.tokens[0][1] != ")":
            sign = self._take() if self.tokens[0][1] in ("*", "·", "⋅", "/") else "*"
            total = total.times(self._factor(depth), -1 if sign == "/" else 1)
        return total

    def _first(self, depth: int) -> Unit:
        if self.tokens[:2] == [("power", "1"), ("sign", "/")]:
            self._take()
            return Unit(Fraction(1))
        return self._factor(depth)

    def _take(self) -> str:
        if not self.tokens:
            raise UnitError("has a unit that ends too early")
        return self.tokens.pop(0)[1]

    def _factor(self, depth: int) -> Unit:
        token = self._take()
        if token == "(" and depth < _MAX_NESTING:
            inner = self.product(depth + 1)
            if self._take() != ")":
                raise UnitError("has an open parenthesis in its unit")
        else:
            inner = _named(token)
        return Unit(Fraction(1)).times(inner, self._exponent())

    def _exponent(self) -> int:
        if not self.tokens or self.tokens[0][0] != "power":
            return 1
        power = int(self._take().lstrip("^* ").translate(_SUPERSCRIPT))
        if abs(power) > _MAX_POWER:
            raise UnitError(f"has a power of {power} in its unit, the most is {_MAX_POWER}")
        return power


def _named(name: str) -> Unit:
    if name in UNITS:
        return UNITS[name]
    if not name[0].isalpha():
        raise UnitError(f"has a unit that cannot be read at '{name}'")
    raise UnitError(f"has the unknown unit '{name}'", did_you_mean(name, UNITS))

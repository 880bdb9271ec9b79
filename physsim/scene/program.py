"""Expressions of time, compiled: `sin(2*pi*t)*exp(-t)` -> a short program in postfix order.

The grammar is that of `${...}`: parameters and constants may be used, and `t` is the one variable, the time
[s]. What does not depend on `t` is computed while compiling. Seconds and radians count as plain numbers
beside `t`, so that both `sin(2*pi*t)` and `sin(2*pi*t / period)` can be written; every other dimension is
checked, and the result is a plain number.

A program is a flat list [operation, operand, operation, operand, ...] for a machine with a stack: at most
MAX_OPERATIONS operations that need at most MAX_STACK values on the stack. CONSTANT pushes its operand, TIME
pushes t; the others take their arguments from the stack, the last one on top, push their value, and have the
operand 0. `engine/src/profile.rs` runs the same table.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from physsim.scene.expressions import (
    FUNCTIONS,
    Arithmetic,
    Lookup,
    common_dimension,
    demand_plain,
    function_of,
)
from physsim.scene.grammar import ExpressionError, Parser, tokens_of
from physsim.scene.units import PLAIN, Dimension, Measure, dimension_text, multiply, same, without_angle

MAX_OPERATIONS = 500
MAX_STACK = 64
VARIABLE = "t"

CONSTANT, TIME, ADD, SUBTRACT, MULTIPLY, DIVIDE, POWER, NEGATE = range(8)
FUNCTION_CODES: dict[str, int] = {
    "sin": 20,
    "cos": 21,
    "tan": 22,
    "asin": 23,
    "acos": 24,
    "atan": 25,
    "atan2": 26,
    "exp": 27,
    "log": 28,
    "log10": 29,
    "sqrt": 30,
    "abs": 31,
    "floor": 32,
    "ceil": 33,
    "min": 34,
    "max": 35,
    "hypot": 38,
    "sinh": 39,
    "cosh": 40,
    "tanh": 41,
    "round": 42,
}
"""Operation of each function; `round` takes halves to the even neighbour."""
_OF_TWO = ("atan2", "min", "max", "hypot")

Operation = tuple[int, float]


@dataclass(frozen=True, slots=True)
class Varying:
    """A part that depends on time.

    operations: its program; stack: values that it needs at most; dimension: with seconds left out.
    """

    operations: tuple[Operation, ...]
    stack: int
    dimension: Dimension


Part = Measure | Varying


def compiled(text: str, lookup: Lookup) -> tuple[float, ...]:
    """The program of the expression `text`.

    lookup: gives the value of a parameter, None when there is none of that name.
    Raises ExpressionError for what cannot be read, has a dimension, or is too long.
    """
    whole = _varying(Parser(tokens_of(text), _Compiler(lookup)).whole())
    if not same(without_angle(whole.dimension), PLAIN):
        raise ExpressionError(f"gives a value in {dimension_text(whole.dimension)}, not a plain number")
    if len(whole.operations) > MAX_OPERATIONS or whole.stack > MAX_STACK:
        raise ExpressionError("is too long for an expression of time")
    return tuple(float(part) for operation in whole.operations for part in operation)


class _Compiler:
    """The algebra of programs; parts without `t` stay numbers with dimensions."""

    def __init__(self, lookup: Lookup) -> None:
        self._lookup = lookup
        self._arithmetic = Arithmetic(lookup)

    def number(self, value: Measure) -> Part:
        return value

    def named(self, name: str) -> Part:
        if name != VARIABLE:
            return self._arithmetic.named(name)
        if self._lookup(name) is not None:
            raise ExpressionError(
                f"uses '{name}', which is the time here and a parameter of this scene",
                "give the parameter another name",
            )
        return Varying(((TIME, 0.0),), 1, PLAIN)

    def add(self, a: Part, b: Part, sign: float) -> Part:
        if isinstance(a, Measure) and isinstance(b, Measure):
            return self._arithmetic.add(a, b, sign)
        x, y = _varying(a), _varying(b)
        return _joined(ADD if sign > 0 else SUBTRACT, x, y, common_dimension(x.dimension, y.dimension))

    def multiply(self, a: Part, b: Part, power: int) -> Part:
        if isinstance(a, Measure) and isinstance(b, Measure):
            return self._arithmetic.multiply(a, b, power)
        if power < 0 and isinstance(b, Measure) and b.value == 0:
            raise ExpressionError("divides by zero")
        x, y = _varying(a), _varying(b)
        return _joined(
            MULTIPLY if power > 0 else DIVIDE, x, y, multiply(x.dimension, y.dimension, float(power))
        )

    def negate(self, a: Part) -> Part:
        if isinstance(a, Measure):
            return self._arithmetic.negate(a)
        return Varying((*a.operations, (NEGATE, 0.0)), a.stack, a.dimension)

    def power(self, base: Part, exponent: Part) -> Part:
        if isinstance(base, Measure) and isinstance(exponent, Measure):
            return self._arithmetic.power(base, exponent)
        x, y = _varying(base), _varying(exponent)
        demand_plain(y.dimension, "an exponent")
        if isinstance(exponent, Measure):
            return _joined(POWER, x, y, multiply(PLAIN, x.dimension, exponent.value))
        demand_plain(x.dimension, "a power of time")
        return _joined(POWER, x, y, PLAIN)

    def call(self, name: str, arguments: list[Part]) -> Part:
        constants = [argument for argument in arguments if isinstance(argument, Measure)]
        if len(constants) == len(arguments):
            return self._arithmetic.call(name, constants)
        function = function_of(name, len(arguments))
        parts = [_varying(argument) for argument in arguments]
        dimension = function.dimension([part.dimension for part in parts])
        return _called(name, parts, dimension)


def _varying(part: Part) -> Varying:
    """The part as a program; seconds are plain numbers from here on."""
    if isinstance(part, Varying):
        return part
    kg, m, _, rad = part.dimension
    return Varying(((CONSTANT, part.value),), 1, (kg, m, 0.0, rad))


def _joined(code: int, a: Varying, b: Varying, dimension: Dimension) -> Varying:
    """Both programs one after the other, then the operation on their two values."""
    return Varying((*a.operations, *b.operations, (code, 0.0)), max(a.stack, 1 + b.stack), dimension)


def _called(name: str, parts: Sequence[Varying], dimension: Dimension) -> Varying:
    """A function of one value, or of two; min, max and hypot of several are those of two in a row."""
    code = FUNCTION_CODES[name]
    first, *rest = parts
    if name not in _OF_TWO:
        return Varying((*first.operations, (code, 0.0)), first.stack, dimension)
    if not rest:
        return first if name != "hypot" else _called("abs", parts, dimension)
    for part in rest:
        first = _joined(code, first, part, dimension)
    return first


_BINARY: dict[int, Callable[[float, float], float]] = {
    ADD: lambda a, b: a + b,
    SUBTRACT: lambda a, b: a - b,
    MULTIPLY: lambda a, b: a * b,
    DIVIDE: lambda a, b: a / b,
    POWER: math.pow,
    **{FUNCTION_CODES[name]: FUNCTIONS[name].value for name in _OF_TWO},
}
_UNARY: dict[int, Callable[[float], float]] = {
    NEGATE: lambda a: -a,
    **{code: FUNCTIONS[name].value for name, code in FUNCTION_CODES.items() if name not in _OF_TWO},
}


def run(program: Sequence[float], t: float) -> float:
    """The value of a program at the time t [s]; NaN where it has none (a division by zero, a root of -1)."""
    stack: list[float] = []
    try:
        for code, operand in zip(program[::2], program[1::2], strict=True):
            _step(stack, int(code), operand, t)
    except (ValueError, OverflowError, ZeroDivisionError):
        return math.nan
    return stack.pop()


def _step(stack: list[float], code: int, operand: float, t: float) -> None:
    if code == CONSTANT:
        stack.append(operand)
    elif code == TIME:
        stack.append(t)
    elif code in _UNARY:
        stack.append(_UNARY[code](stack.pop()))
    else:
        b = stack.pop()
        stack.append(_BINARY[code](stack.pop(), b))

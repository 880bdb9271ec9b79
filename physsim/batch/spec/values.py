"""Values of a sweep as they stand in its file: measures of any dimension, and names."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import ValidationInfo

from physsim.scene.spec import kinds
from physsim.scene.spec.reader import ContextReader, Reader, Schema
from physsim.scene.spec.slip import slip
from physsim.scene.spec.values import Bounds, Text, measure, number_schema, within
from physsim.scene.units import PLAIN, Dimension, Measure, same

LONGEST_NAME = 60
_SI = ("kg", "m", "s", "rad")


class AnyMeasure(ContextReader):
    """A number with any unit, or none; after validation a `Measure` in SI."""

    def schema(self) -> Schema:
        return number_schema(kinds.ANYTHING, Bounds())

    def read(self, value: object, info: ValidationInfo) -> Measure:
        """The value with its dimension."""
        found = measure(value, info, kinds.ANYTHING).measure
        within(found.value, Bounds(), kinds.ANYTHING)
        return found


@dataclass(frozen=True)
class AnyValue(Reader):
    """Whatever may stand in a scene; it is judged there."""

    def schema(self) -> Schema:
        return {}

    def read(self, value: object) -> object:
        """The value itself."""
        return value


@dataclass(frozen=True)
class ColumnName(Text):
    """A name that a column of the table may have and an expression may use."""

    taken: tuple[str, ...] = ()

    def read(self, value: object) -> str:
        """The name itself."""
        name = super().read(value)
        if not name.isidentifier() or len(name) > LONGEST_NAME:
            raise slip(f"a name is letters, digits and underscores, at most {LONGEST_NAME}, no digit first")
        if name in self.taken:
            raise slip(f"the name '{name}' is that of a column which every table has")
        return name


Given = Annotated[Measure, AnyMeasure()]
Written = Annotated[Any, AnyValue()]
ScenePath = Annotated[str, Text(300)]


def common(measures: list[Measure]) -> Dimension | None:
    """The dimension that all of them have, plain numbers taking that of the others; None when they differ."""
    told = [one.dimension for one in measures if not same(one.dimension, PLAIN)]
    if any(not same(one, told[0]) for one in told):
        return None
    return told[0] if told else PLAIN


def unit_text(dimension: Dimension) -> str:
    """The SI unit of a dimension as scenes are written: `kg*m^2/s^2`; nothing for a plain number."""
    over = [_factor(name, power) for name, power in zip(_SI, dimension, strict=True) if power > 0]
    under = [_factor(name, -power) for name, power in zip(_SI, dimension, strict=True) if power < 0]
    if not over and not under:
        return ""
    return "*".join(over or ["1"]) + "".join(f"/{factor}" for factor in under)


def _factor(name: str, power: float) -> str:
    return name if power == 1 else f"{name}^{power:g}"

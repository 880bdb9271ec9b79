"""Materials and pairs of materials, and the rule for pairs that no table has."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from physsim.scene.spec import kinds
from physsim.scene.spec.base import Spec
from physsim.scene.spec.names import ItemName
from physsim.scene.spec.reader import Reader, Schema
from physsim.scene.spec.slip import slip
from physsim.scene.spec.values import Number

Restitution = Annotated[float, Number(at_least=0, at_most=1)]
Friction = Annotated[float, Number(at_least=0, at_most=1e6)]
Lever = Annotated[float, Number(kinds.LENGTH, at_least=0)]
Density = Annotated[float, Number(kinds.DENSITY, above=0)]
MixingRule = Literal["minimum", "maximum", "mean", "geometric_mean", "harmonic_mean", "product", "error"]


class Color(Reader):
    """A colour as `#rgb` or `#rrggbb`."""

    def schema(self) -> Schema:
        return {"type": "string", "pattern": "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"}

    def read(self, value: object) -> str:
        """The colour as `#rrggbb`."""
        digits = value[1:] if isinstance(value, str) and value.startswith("#") else ""
        if len(digits) not in (3, 6) or not all(c in "0123456789abcdefABCDEF" for c in digits):
            raise slip("must be a colour", allowed='"#rgb" or "#rrggbb" in hexadecimal digits')
        return "#" + "".join(c * 2 for c in digits) if len(digits) == 3 else f"#{digits}"


class MaterialSpec(Spec):
    """A material of the scene; what is left out comes from the built-in material of that name, if any."""

    density: Density | None = Field(
        default=None, description="Mass per volume [kg/m^3], greater than 0.", examples=["7.85 g/cm^3"]
    )
    restitution: Restitution | None = Field(
        default=None, description="Coefficient of restitution, 0 to 1, for pairs that no table has."
    )
    static_friction: Friction | None = Field(
        default=None, description="Coefficient mu_s at rest, at least 0, for pairs that no table has."
    )
    kinetic_friction: Friction | None = Field(
        default=None, description="Coefficient mu_k while sliding, 0 to mu_s, for pairs that no table has."
    )
    color: Annotated[str, Color()] | None = Field(
        default=None, description="Colour in pictures, in quotes.", examples=["#d33"]
    )


class PairSpec(Spec):
    """Coefficients of two materials, looked up first; what is left out comes from the next source."""

    between: tuple[ItemName, ItemName] = Field(
        description="Names of the two materials, in either order; the same twice for a material on itself."
    )
    restitution: Restitution | None = Field(default=None, description="Coefficient of restitution, 0 to 1.")
    static_friction: Friction | None = Field(
        default=None, description="Coefficient mu_s at rest, at least 0."
    )
    kinetic_friction: Friction | None = Field(
        default=None, description="Coefficient mu_k while sliding, 0 to mu_s."
    )
    rolling_friction: Lever = Field(
        default=0.0,
        description="Torque against rolling, at most this length times the normal force [m], at least 0.",
        examples=["0.5 mm"],
    )
    spinning_friction: Lever = Field(
        default=0.0,
        description="Torque against turning about the normal, at most this length times the normal force "
        "[m], at least 0.",
    )


class MixingSpec(Spec):
    """How coefficients of two materials are combined when no table has the pair; `error` refuses it."""

    restitution: MixingRule = Field(default="minimum", description="Rule for restitution.")
    friction: MixingRule = Field(default="geometric_mean", description="Rule for both friction coefficients.")

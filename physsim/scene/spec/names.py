"""Names that users give to bodies, materials, springs, joints and forces, and references to them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import Field

from physsim.scene.spec.reader import Reader, Schema
from physsim.scene.spec.schema_rules import ALL_DIFFERENT
from physsim.scene.spec.slip import slip

WORLD = "world"
LONGEST = 100


@dataclass(frozen=True)
class Name(Reader):
    """A name: 1 to 100 printable characters, no blank at either end, no `*`; `world` is taken for bodies.

    pattern: whether `*` may stand for any characters.
    """

    reserved: tuple[str, ...] = ()
    pattern: bool = False

    def schema(self) -> Schema:
        refused: list[dict[str, Any]] = [] if self.pattern else [{"pattern": r"\*"}]
        refused.append({"enum": list(self.reserved)})
        return {"type": "string", "minLength": 1, "maxLength": LONGEST, "not": {"anyOf": refused}}

    def read(self, value: object) -> str:
        """The name itself."""
        if not isinstance(value, str):
            raise slip("must be a name", hint=f'put it in quotes: "{str(value)[:40]}"')
        trouble = self._trouble(value)
        if trouble:
            raise slip(trouble)
        return value

    def _trouble(self, name: str) -> str | None:
        if not name:
            return "a name must not be empty"
        if len(name) > LONGEST:
            return f"a name must be at most {LONGEST} characters long"
        if name in self.reserved:
            return f"the name '{name}' is taken"
        starred = "*" in name and not self.pattern
        if starred or not all(c.isprintable() for c in name) or name != name.strip():
            return "a name must be printable, without '*', and without blanks at its ends"
        return None


BodyName = Annotated[str, Name(reserved=(WORLD,))]
BodyPattern = Annotated[str, Name(reserved=(WORLD,), pattern=True)]
BodyReference = Annotated[str, Name()]
ItemName = Annotated[str, Name()]
BodyPair = Annotated[tuple[BodyReference, BodyReference], Field(json_schema_extra=ALL_DIFFERENT)]

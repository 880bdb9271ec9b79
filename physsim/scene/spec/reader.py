"""What every type of the scene language does: it reads what was written, and says in JSON Schema what may be.

A type is put behind a Python type: `Annotated[float, Number(...)]`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler, ValidationInfo
from pydantic_core import core_schema

Schema = dict[str, Any]


class _Described(ABC):
    @abstractmethod
    def schema(self) -> Schema:
        """The JSON Schema of what may be written."""

    def __get_pydantic_json_schema__(
        self, core: core_schema.CoreSchema, handler: GetJsonSchemaHandler
    ) -> Schema:
        return self.schema()


class Reader(_Described):
    """A type that needs nothing but what was written."""

    @abstractmethod
    def read(self, value: Any) -> Any:
        """The value; raises a `slip` for what is none."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(self.read)


class ContextReader(_Described):
    """A type that needs the rest of the file besides: parameters, values that stand before it."""

    @abstractmethod
    def read(self, value: Any, info: ValidationInfo) -> Any:
        """The value; raises a `slip` for what is none."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        return core_schema.with_info_plain_validator_function(self.read)

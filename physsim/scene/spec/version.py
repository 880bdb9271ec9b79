"""The version that a file begins with: of the scene, the sweep or the fit language."""

from __future__ import annotations

from dataclasses import dataclass

from physsim.scene.spec.reader import Reader, Schema
from physsim.scene.spec.slip import slip


@dataclass(frozen=True)
class Version(Reader):
    """The version of a language, which must be the one that is known."""

    language: str
    known: int

    def schema(self) -> Schema:
        return {"const": self.known}

    def read(self, value: object) -> int:
        """The version itself."""
        if type(value) is not int or value != self.known:
            raise slip(
                f"is a version of the {self.language} language that is not known", allowed=str(self.known)
            )
        return value

"""Which materials a scene may name: its own and the built-in ones."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache


@lru_cache(maxsize=1)
def built_in_materials() -> frozenset[str]:
    """The names of the library, which is read when first asked for."""
    from physsim.materials import library  # noqa: PLC0415 (the library is read only by scenes that name materials)

    return library.material_names()


def known_materials(own: Iterable[str]) -> frozenset[str]:
    """Names of the scene's own materials and of the library."""
    return built_in_materials().union(own)

"""Materials and pairs of materials: numbers with sources, and the rules that choose among them."""

from __future__ import annotations

from physsim.materials import library
from physsim.materials.resolve import NUMBERS, ResolvedNumber, ResolvedPair, UnknownPair, resolve_pair

__all__ = ["NUMBERS", "ResolvedNumber", "ResolvedPair", "UnknownPair", "library", "resolve_pair"]

"""A triangle mesh ready to be drawn: vertices with their normals."""

from __future__ import annotations

from dataclasses import dataclass

from physsim.view.stage import FloatArray, IntArray


@dataclass(frozen=True)
class Mesh:
    """vertices (V, 3) [m, or units of a scale]; normals (V, 3), unit, outward, so vertices stand twice where
    an edge is sharp; triangles (T, 3) counter-clockwise seen from outside.
    """

    vertices: FloatArray
    normals: FloatArray
    triangles: IntArray

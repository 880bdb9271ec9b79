"""What is simulated: bodies with mass, centre and inertia, geoms and pairs of materials, as plain arrays."""

from __future__ import annotations

from physsim.model.compile import compile_scene
from physsim.model.geom import GeomKind
from physsim.model.mesh_form import MeshMemory
from physsim.model.model import GeomTable, Model
from physsim.model.pair_table import PairTable

__all__ = ["GeomKind", "GeomTable", "MeshMemory", "Model", "PairTable", "compile_scene"]

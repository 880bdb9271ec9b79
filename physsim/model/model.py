"""What is simulated: plain arrays, one row per body, geom or pair of materials."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from physsim.errors import Problem
from physsim.model import rotation
from physsim.model.geom import Surface
from physsim.model.hull import Hull
from physsim.model.look_table import LookTable
from physsim.model.mechanics import Mechanics
from physsim.model.pair_table import PairTable
from physsim.model.polyhedron import IntArray
from physsim.model.rotation import FloatArray

if TYPE_CHECKING:
    from physsim.scene.spec import SceneSpec


@dataclass(frozen=True)
class GeomTable:
    """The collision shapes of all bodies, G rows.

    body (G,) and material (G,) are numbers; kind (G,) of `GeomKind`, parameters (G, 4) as listed there;
    position (G, 3) [m] from the body's CENTRE OF MASS and orientation (G, 4), both in body axes. hulls and
    surfaces are shared: parameters[:, 0] of a hull or mesh geom is the index into them.
    """

    body: IntArray
    kind: IntArray
    parameters: FloatArray
    position: FloatArray
    orientation: FloatArray
    material: IntArray
    hulls: tuple[Hull, ...]
    surfaces: tuple[Surface, ...]


@dataclass(frozen=True)
class Model:
    """N bodies in scene order; `world` is not among them. SI, body axes unless said.

    inertia (N, 3, 3) about the centre of mass; center_of_mass (N, 3) from the body's origin; position (N,
    3) of the body's origin and orientation (N, 4) wxyz in the world; velocity (N, 3) of the centre of mass;
    angular_velocity (N, 3) in world axes. mass and inertia of a fixed body are what its shape gives,
    infinite where it gives none. surface_velocity (N, 3) of its surface against the body, body axes.
    material_names: those in use; body_material (N,) and the rows of `pairs` follow that order. no_contact
    (K, 2): bodies that never collide. mechanics: what acts on them besides contact. mesh_sha256: file as
    written in the scene -> hash.
    """

    spec: SceneSpec
    body_names: tuple[str, ...]
    fixed: npt.NDArray[np.bool_]
    mass: FloatArray
    inertia: FloatArray
    center_of_mass: FloatArray
    mass_method: tuple[str, ...]
    position: FloatArray
    orientation: FloatArray
    velocity: FloatArray
    angular_velocity: FloatArray
    surface_velocity: FloatArray
    material_names: tuple[str, ...]
    body_material: IntArray
    pairs: PairTable
    geoms: GeomTable
    looks: LookTable
    no_contact: IntArray
    mechanics: Mechanics
    mesh_sha256: Mapping[str, str]
    warnings: tuple[Problem, ...]

    def world_center_of_mass(self) -> FloatArray:
        """Centres of mass (N, 3) in the world at the start: x = p + R c."""
        turned = [rotation.matrix(q) @ c for q, c in zip(self.orientation, self.center_of_mass, strict=True)]
        centers: FloatArray = self.position + np.array(turned).reshape(-1, 3)
        return centers

    def engine_input(self) -> dict[str, object]:
        """The dictionary of plain arrays that the engine is built from."""
        parts = (
            self._settings(),
            self._bodies(),
            self._geoms(),
            self._pairs(),
            self.mechanics.engine_input(),
        )
        return {name: value for part in parts for name, value in part.items()}

    def _settings(self) -> dict[str, object]:
        simulation, world = self.spec.simulation, self.spec.world
        names = ("timestep", "integrator", "impacts", "collision", "iterations", "tolerance", "stabilization")
        more = ("baumgarte", "slip_speed", "bounce_speed", "threads")
        return {
            "gravity": np.array(world.gravity, dtype=np.float64),
            "gravitation": world.gravitation,
            **{name: getattr(simulation, name) for name in (*names, *more)},
        }

    def _bodies(self) -> dict[str, object]:
        return {
            "fixed": self.fixed.astype(np.int32),
            "mass": self.mass,
            "inertia": self.inertia,
            "position": self.world_center_of_mass(),
            "orientation": self.orientation,
            "velocity": self.velocity,
            "angular_velocity": self.angular_velocity,
            "surface_velocity": self.surface_velocity,
            "attracting_mass": np.where(np.isfinite(self.mass), self.mass, 0.0),
        }

    def _geoms(self) -> dict[str, object]:
        geoms = self.geoms
        return {
            "geom_body": geoms.body,
            "geom_kind": geoms.kind,
            "geom_parameters": geoms.parameters,
            "geom_position": geoms.position,
            "geom_orientation": geoms.orientation,
            "geom_material": geoms.material,
            "hull_vertices": [hull.vertices for hull in geoms.hulls],
            "hull_faces": [[list(face) for face in hull.faces] for hull in geoms.hulls],
            "mesh_vertices": [surface.vertices for surface in geoms.surfaces],
            "mesh_triangles": [surface.triangles for surface in geoms.surfaces],
        }

    def _pairs(self) -> dict[str, object]:
        return {
            "restitution": self.pairs.restitution,
            "static_friction": self.pairs.static_friction,
            "kinetic_friction": self.pairs.kinetic_friction,
            "rolling_friction": self.pairs.rolling_friction,
            "spinning_friction": self.pairs.spinning_friction,
            "no_contact": self.no_contact,
        }

"""Spec -> model: what needs numbers is computed and checked here, and all problems are told at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from physsim.errors import SceneError
from physsim.materials import library
from physsim.model import checks
from physsim.model.arrays import floats
from physsim.model.body import Body, BodyMaker
from physsim.model.findings import Findings, Path
from physsim.model.geom_table import geom_table
from physsim.model.look_table import look_table
from physsim.model.mechanics import mechanics
from physsim.model.mesh_form import MeshFiles, MeshMemory
from physsim.model.model import GeomTable, Model
from physsim.model.no_contact import Pairs, joined, no_contact_pairs
from physsim.model.pair_table import Complaints, PairTable, can_touch, pair_table
from physsim.model.placement import Placement, Stand
from physsim.uncollected import uncollected

if TYPE_CHECKING:
    from physsim.scene import Scene


@uncollected()
def compile_scene(scene: Scene, memory: MeshMemory | None = None) -> Model:
    """The model of a scene.

    memory: of meshes that were used before; what is in it is not read again.
    Raises SceneError with every problem, placed in the file: meshes that cannot be read or have no inside,
    masses that are not known, impossible inertia, pairs of materials without numbers. What is only doubtful
    (a timestep too long for a small fast body, a mesh a thousand times too large) is in `Model.warnings`.
    """
    return _Compiler(scene, memory or MeshMemory()).model()


def declared_name(name: str, declared: Mapping[str, object]) -> str:
    """The key under `bodies` that a body comes from: `brick` for `brick[0,0,0]`."""
    return name if name in declared else name.rpartition("[")[0]


class _Compiler:
    """The bodies of one scene on their way to a model; `paths` and `specs` follow the order of the bodies."""

    def __init__(self, scene: Scene, memory: MeshMemory) -> None:
        self.scene = scene
        self.findings = Findings()
        self.files = MeshFiles(scene.resolve_file, memory)
        self.specs = list(scene.bodies.values())
        self.declared = [declared_name(name, scene.spec.bodies) for name in scene.bodies]
        self.paths: list[Path] = [("bodies", name) for name in self.declared]

    def model(self) -> Model:
        """Raises SceneError with everything that was found."""
        bodies = self._bodies()
        spec, names = self.scene.spec, list(self.scene.bodies)
        no_contact = no_contact_pairs(spec.no_contact, joined(spec.joints), names, self.findings)
        model = None if bodies is None else self._assembled(bodies, no_contact)
        if model is not None and bodies is not None:
            checks.check_model(model, bodies, self.paths, self.findings)
        if model is None or self.findings.errors:
            raise SceneError([self.scene.place(problem) for problem in self.findings.errors], self.scene.name)
        return replace(model, warnings=tuple(self.scene.place(problem) for problem in self.findings.warnings))

    def _bodies(self) -> list[Body] | None:
        """Every declared body made once, however often it is repeated; None when one has an error."""
        maker = BodyMaker(self.scene.spec.materials, self.files, self.findings)
        made: dict[str, Body | None] = {}
        for name, spec in zip(self.declared, self.specs, strict=True):
            if name not in made:
                made[name] = maker.body(spec, ("bodies", name))
        bodies = [body for name in self.declared if (body := made[name]) is not None]
        return bodies if len(bodies) == len(self.specs) else None

    def _assembled(self, bodies: Sequence[Body], no_contact: Pairs) -> Model:
        specs, names = self.specs, _materials_in_use(bodies)
        numbers = {name: number for number, name in enumerate(names)}
        geoms = geom_table(bodies, numbers)
        stand = self._stand(bodies)
        fixed = stand.fixed
        return Model(
            spec=self.scene.spec,
            body_names=stand.names,
            fixed=fixed,
            mass=stand.mass,
            inertia=stand.inertia,
            center_of_mass=stand.center_of_mass,
            mass_method=tuple(body.method for body in bodies),
            position=stand.position,
            orientation=stand.orientation,
            velocity=floats([spec.velocity for spec in specs], 3),
            angular_velocity=floats([spec.angular_velocity for spec in specs], 3),
            surface_velocity=floats([spec.surface_velocity for spec in specs], 3),
            material_names=names,
            body_material=np.array([numbers[body.material] for body in bodies], dtype=np.int32),
            pairs=self._pairs(
                names, geoms, can_touch(_made_of(geoms, len(specs), len(names)), fixed, no_contact)
            ),
            geoms=geoms,
            looks=look_table(bodies, self._color),
            no_contact=no_contact,
            mechanics=mechanics(self.scene, Placement(stand), self.findings),
            mesh_sha256=dict(sorted(self.files.sha256.items())),
            warnings=(),
        )

    def _color(self, material: str) -> str:
        """The scene's colour of a material, else the library's, else ""."""
        declared = self.scene.spec.materials.get(material)
        if declared is not None and declared.color is not None:
            return declared.color
        return (material in library.material_names() and library.material(material).color) or ""

    def _stand(self, bodies: Sequence[Body]) -> Stand:
        specs = self.specs
        return Stand(
            names=tuple(self.scene.bodies),
            fixed=np.array([spec.fixed for spec in specs], dtype=bool),
            mass=floats([body.properties.mass for body in bodies]),
            inertia=floats([body.properties.inertia for body in bodies], 3, 3),
            center_of_mass=floats([body.properties.center for body in bodies], 3),
            position=floats([spec.position for spec in specs], 3),
            orientation=floats([spec.orientation.as_quaternion() for spec in specs], 4),
        )

    def _pairs(self, names: Sequence[str], geoms: GeomTable, needed: npt.NDArray[np.bool_]) -> PairTable:
        places: dict[str, Path] = {}
        for body, material in zip(geoms.body.tolist(), geoms.material.tolist(), strict=True):
            places.setdefault(names[material], (*self.paths[body], "material"))
        return pair_table(names, needed, self.scene.spec, Complaints(places, self.findings))


def _made_of(geoms: GeomTable, bodies: int, materials: int) -> npt.NDArray[np.bool_]:
    """Which bodies collide with which materials (N, M)."""
    made_of = np.zeros((bodies, materials), dtype=bool)
    made_of[geoms.body, geoms.material] = True
    return made_of


def _materials_in_use(bodies: Sequence[Body]) -> tuple[str, ...]:
    """Names in the order of first use."""
    used = [name for body in bodies for name in (body.material, *(geom.material for geom in body.geoms))]
    return tuple(dict.fromkeys(used))

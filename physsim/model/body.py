"""One declared body made ready: form, mass, and where its coefficients come from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import inf, isinf
from typing import TYPE_CHECKING

import numpy as np

from physsim.materials import library
from physsim.model import rotation
from physsim.model.findings import Findings, Path
from physsim.model.form import Form, primitive
from physsim.model.geom import Geom, Look
from physsim.model.inertia import MassProperties, composed, impossible
from physsim.model.mesh_form import MeshFiles, convex_form, mesh_form
from physsim.model.trouble import ShapeTrouble

if TYPE_CHECKING:
    from physsim.scene.spec.bodies import BodySpec
    from physsim.scene.spec.materials import MaterialSpec
    from physsim.scene.spec.shapes import PartSpec, ShapeSpec

NO_MATERIAL = ""
"""Name under which a body that never collides and has no material stands."""


@dataclass(frozen=True)
class Part:
    """A form with its material, placed in the body's frame."""

    form: Form
    material: str
    quaternion: rotation.FloatArray
    translation: rotation.FloatArray
    path: Path

    def looks(self, collides: bool) -> list[Look]:
        """What is seen of the part and what collides, in the body's frame."""
        return [
            replace(look, geom=look.geom.moved(self.quaternion, self.translation).of(self.material))
            for look in self.form.looks(collides)
        ]

    def weighing(self, mass: float) -> MassProperties:
        """The part's mass properties [kg] in the body's frame."""
        return self.form.unit.scaled(mass).moved(rotation.matrix(self.quaternion), self.translation)


@dataclass(frozen=True)
class Body:
    """A declared body, ready to be placed as often as it is repeated."""

    properties: MassProperties
    method: str
    looks: tuple[Look, ...]
    material: str
    thickness: float
    extent: float

    @property
    def geoms(self) -> tuple[Geom, ...]:
        """What collides, in the body's frame."""
        return tuple(look.geom for look in self.looks if look.collides)


class BodyMaker:
    """Makes bodies and writes down what is wrong with them."""

    def __init__(
        self, scene_materials: Mapping[str, MaterialSpec], files: MeshFiles, findings: Findings
    ) -> None:
        self.scene_materials = scene_materials
        self.files = files
        self.findings = findings

    def body(self, spec: BodySpec, path: Path) -> Body | None:
        """The body of one spec, or None when something is wrong with it (then the findings say what)."""
        parts = self._parts(spec, path)
        if parts is None:
            return None
        weighed = self._weighed(spec, parts, path)
        if weighed is None:
            return None
        properties, method = self._with_declared_inertia(spec, *weighed, path)
        looks = tuple(look for part in parts for look in part.looks(spec.collides))
        thickness = min(part.form.thickness for part in parts)
        extent = max(part.form.extent for part in parts)
        return Body(properties, method, looks, parts[0].material, thickness, extent)

    def density(self, material: str) -> float | None:
        """Density [kg/m^3] of a material: the scene's, else the library's, else None."""
        declared = self.scene_materials.get(material)
        if declared is not None and declared.density is not None:
            return float(declared.density)
        if material not in library.material_names():
            return None
        known = library.material(material).density
        return known.value if known is not None else None

    def _parts(self, spec: BodySpec, path: Path) -> list[Part] | None:
        if spec.shape.type != "compound":
            form = self._form(spec.shape, spec, (*path, "shape"))
            here = np.array(rotation.IDENTITY)
            return (
                None
                if form is None
                else [Part(form, spec.material or NO_MATERIAL, here, np.zeros(3), (*path, "shape"))]
            )
        found = [
            self._part(part, spec, (*path, "shape", "parts", index))
            for index, part in enumerate(spec.shape.parts)
        ]
        parts = [part for part in found if part is not None]
        return parts if len(parts) == len(found) else None

    def _part(self, part: PartSpec, spec: BodySpec, path: Path) -> Part | None:
        form = self._form(part.shape, spec, (*path, "shape"))
        if form is None:
            return None
        quaternion = np.array(part.orientation.as_quaternion(), dtype=np.float64)
        return Part(
            form,
            part.material or spec.material or NO_MATERIAL,
            quaternion,
            np.array(part.position, dtype=np.float64),
            path,
        )

    def _form(self, shape: ShapeSpec, spec: BodySpec, path: Path) -> Form | None:
        try:
            if shape.type == "mesh":
                return mesh_form(shape, self.files, spec.fixed, spec.collides)
            if shape.type == "convex":
                return convex_form(shape, self.files)
            return primitive(shape)
        except ShapeTrouble as trouble:
            self.findings.trouble(path, trouble)
            return None

    def _weighed(self, spec: BodySpec, parts: list[Part], path: Path) -> tuple[MassProperties, str] | None:
        """Mass properties in the body's frame, and how they were found."""
        if any(part.form.volume is not None and isinf(part.form.volume) for part in parts):
            return _immovable(), parts[0].form.method
        masses, origin = self._masses(spec, parts)
        if masses is None:
            if spec.fixed:
                return _immovable(), f"{_method(parts)}, mass not known and not needed"
            self._say_no_mass(spec, parts, path)
            return None
        whole = composed([part.weighing(mass) for part, mass in zip(parts, masses, strict=True)])
        if spec.mass is not None:
            whole = whole.scaled(spec.mass)
        return whole, f"{_method(parts)}, {origin}"

    def _masses(self, spec: BodySpec, parts: list[Part]) -> tuple[list[float] | None, str]:
        """Mass of every part [kg] (with a total given: shares of it), and where they come from."""
        volumes = [part.form.volume for part in parts]
        if spec.mass is not None and len(parts) == 1:
            return [spec.mass], "mass given"
        if any(volume is None for volume in volumes):
            return None, ""
        densities = [
            spec.density if spec.density is not None else self.density(part.material) for part in parts
        ]
        if all(density is None for density in densities) and spec.mass is not None:
            densities = [1.0 for _ in parts]
        if any(density is None for density in densities):
            return None, ""
        masses = [
            (density or 0.0) * (volume or 0.0) for density, volume in zip(densities, volumes, strict=True)
        ]
        return masses, _origin(spec, parts)

    def _say_no_mass(self, spec: BodySpec, parts: list[Part], path: Path) -> None:
        for part in parts:
            if part.form.volume is None and len(parts) == 1:
                self.findings.error(
                    path,
                    f"needs a mass: it has no volume that a density could fill ({part.form.method})",
                    hint="add mass: ...",
                )
            elif part.form.volume is None:
                self.findings.error(
                    part.path,
                    "has no volume, so its share of the compound's mass is not known",
                    hint="use a solid shape for this part",
                )
            elif spec.density is None and self.density(part.material) is None:
                self.findings.error(
                    path,
                    f"needs a mass: the material '{part.material}' has no density",
                    hint="add mass: ... or density: ... here, or density to the material",
                )

    def _with_declared_inertia(
        self, spec: BodySpec, properties: MassProperties, method: str, path: Path
    ) -> tuple[MassProperties, str]:
        """The declared tensor in place of the shape's; a surface that cuts itself can give an impossible
        one.
        """
        if spec.inertia is not None:
            i = spec.inertia
            tensor = np.array([[i.xx, i.xy, i.xz], [i.xy, i.yy, i.yz], [i.xz, i.yz, i.zz]], dtype=np.float64)
            declared = MassProperties(properties.mass, properties.center, tensor)
            return declared, f"{method}, inertia given in the scene"
        why = None if isinf(properties.mass) else impossible(properties.inertia)
        if why is not None:
            hint = "its surface may cut itself; repair it, or give the inertia"
            self.findings.error((*path, "shape"), f"has an inertia that {why}", hint=hint)
        return properties, method


def _immovable() -> MassProperties:
    return MassProperties(inf, np.zeros(3), np.diag(np.full(3, inf)))


def _method(parts: list[Part]) -> str:
    if len(parts) == 1:
        return parts[0].form.method
    return f"compound of {len(parts)} parts: " + "; ".join(part.form.method for part in parts)


def _origin(spec: BodySpec, parts: list[Part]) -> str:
    if spec.mass is not None:
        return "mass given"
    if spec.density is not None:
        return "density given"
    return "density of " + ", ".join(dict.fromkeys(part.material for part in parts))

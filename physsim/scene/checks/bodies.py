"""Bodies: names, mass and its sources, shapes that only fixed bodies may have, files, inertia."""

from __future__ import annotations

from collections.abc import Iterator

from physsim.errors import FileTrouble, PathPart, Problem
from physsim.scene.checks.inertia import inertia_trouble
from physsim.scene.checks.materials import unknown_material
from physsim.scene.draft import Draft
from physsim.scene.files import resolve_file
from physsim.scene.materials_known import built_in_materials
from physsim.scene.repeat import MAX_BODIES
from physsim.scene.spec.bodies import BodySpec
from physsim.scene.spec.shapes import CompoundShape, HalfspaceShape, MeshShape, PartSpec, RodShape, files_of

Path = tuple[PathPart, ...]


def check(draft: Draft) -> Iterator[Problem]:
    """Problems of `bodies`."""
    if draft.body_names.total > MAX_BODIES:
        yield Problem(("bodies",), f"must be at most {MAX_BODIES} bodies in all", str(draft.body_names.total))
        return
    yield from _clashes(draft)
    for name, body in draft.bodies.items():
        if body is not None:
            yield from _body(("bodies", name), body, draft)


def _clashes(draft: Draft) -> Iterator[Problem]:
    """A body may be called like a copy of another: only bodies with brackets in their names can be."""
    for name in draft.bodies:
        stem, bracket, _ = name.rpartition("[")
        other = draft.bodies.get(stem) if bracket else None
        if other is not None and other.repeat is not None and draft.body_names.is_copy(name):
            yield Problem(("bodies", name), f"is the name of a copy of '{stem}', which is repeated")


def _body(path: Path, body: BodySpec, draft: Draft) -> Iterator[Problem]:
    yield from _mass(path, body, draft)
    yield from _materials(path, body, draft)
    yield from _fixed_only(path, body)
    yield from _motion(path, body)
    yield from _files(path, body, draft)
    trouble = inertia_trouble(body.inertia) if body.inertia is not None else None
    if trouble:
        yield Problem((*path, "inertia"), trouble)


def _mass(path: Path, body: BodySpec, draft: Draft) -> Iterator[Problem]:
    if body.mass is not None and body.density is not None:
        yield Problem((*path, "density"), "cannot be given together with mass")
    if isinstance(body.shape, HalfspaceShape):
        yield from _half_space_has_no_mass(path, body)
        return
    if body.fixed or body.mass is not None:
        return
    if isinstance(body.shape, RodShape):
        yield Problem((*path, "mass"), "is required: a rod has no volume that a density could fill")
    elif body.density is None:
        yield from _density_of_material(path, body, draft)


def _half_space_has_no_mass(path: Path, body: BodySpec) -> Iterator[Problem]:
    for key in ("mass", "density", "inertia"):
        if getattr(body, key) is not None:
            yield Problem((*path, key), "does not apply to a halfspace, which has no end")


def _density_of_material(path: Path, body: BodySpec, draft: Draft) -> Iterator[Problem]:
    """Each part takes the density of its own material, else of the body's."""
    parts = body.shape.parts if isinstance(body.shape, CompoundShape) else ()
    names = [part.material or body.material for part in parts] or [body.material]
    if None in names:
        yield Problem((*path, "mass"), "is required: neither mass, nor density, nor a material is given")
        return
    for name in dict.fromkeys(names):
        own = draft.materials.get(str(name))
        if own is not None and own.density is None and name not in built_in_materials():
            yield Problem(
                (*path, "mass"), f"is required: neither density nor the density of '{name}' is given"
            )


def _materials(path: Path, body: BodySpec, draft: Draft) -> Iterator[Problem]:
    parts: tuple[PartSpec, ...] = body.shape.parts if isinstance(body.shape, CompoundShape) else ()
    if body.material is not None:
        yield from unknown_material((*path, "material"), body.material, draft)
    elif body.collides and not (parts and all(part.material for part in parts)):
        yield Problem((*path, "material"), "is required for a body that collides")
    for i, part in enumerate(parts):
        if part.material is not None:
            yield from unknown_material((*path, "shape", "parts", i, "material"), part.material, draft)


def _fixed_only(path: Path, body: BodySpec) -> Iterator[Problem]:
    if body.fixed:
        return
    if isinstance(body.shape, HalfspaceShape):
        yield Problem((*path, "shape", "type"), "is for fixed bodies only; add fixed: true", "halfspace")
    parts = body.shape.parts if isinstance(body.shape, CompoundShape) else ()
    shapes = [
        (("shape",), body.shape),
        *((("shape", "parts", i, "shape"), p.shape) for i, p in enumerate(parts)),
    ]
    for below, shape in shapes:
        if isinstance(shape, MeshShape) and shape.collision == "exact":
            yield Problem(
                (*path, *below, "collision"),
                "is for fixed bodies only",
                "exact",
                "hull or pieces, or fixed: true",
            )


def _motion(path: Path, body: BodySpec) -> Iterator[Problem]:
    for key in ("velocity", "angular_velocity"):
        if body.fixed and any(getattr(body, key)):
            yield Problem((*path, key), "must be zero: the body is fixed", hint="give motion to move it")


def _files(path: Path, body: BodySpec, draft: Draft) -> Iterator[Problem]:
    if draft.folder is None:
        return
    for below, file in files_of(body.shape):
        try:
            resolve_file(draft.folder, file)
        except FileTrouble as error:
            yield Problem((*path, "shape", *below), str(error), file)

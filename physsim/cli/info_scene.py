"""What `physsim info` says of a scene: masses, springs, joints, forces, pairs of materials, overlaps."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations_with_replacement
from typing import TYPE_CHECKING, Any

import click

from physsim.cli import info_mechanics, output, problems
from physsim.cli.table import direction, number, place, table, vector

if TYPE_CHECKING:
    from physsim.model import Model
    from physsim.scene import Scene
    from physsim.simulation.overlaps import Overlap

Facts = dict[str, Any]
Picture = Callable[["Scene", "Model", Sequence["Overlap"]], None]


def show(file: str, overrides: Sequence[str], as_json: bool, picture: Picture | None = None) -> None:
    """Load, compile, describe and draw; raises SceneError and FileTrouble as those do."""
    from physsim.model import compile_scene
    from physsim.scene import load_scene
    from physsim.simulation.overlaps import find_overlaps

    scene = load_scene(file, overrides=overrides)
    model = compile_scene(scene)
    overlaps = find_overlaps(model)
    if picture is not None:
        picture(scene, model, overlaps)
    warnings = (*scene.warnings, *model.warnings)
    facts = {
        "file": file,
        "scene": scene_facts(scene, model),
        "bodies": [body_facts(model, index) for index in range(len(model.body_names))],
        "springs": info_mechanics.spring_facts(model),
        "joints": info_mechanics.joint_facts(model),
        "forces": info_mechanics.force_facts(model),
        "pairs": pair_facts(model),
        "overlaps": [overlap_facts(overlap) for overlap in overlaps],
    }
    if as_json:
        output.document("info", 0, **facts, problems=problems.as_data(warnings, file))
        return
    output.result(as_text(facts))
    if warnings:
        output.message(problems.as_text(warnings, file))


def scene_facts(scene: Scene, model: Model) -> Facts:
    """Title, times and method."""
    simulation = model.spec.simulation
    names = (
        "duration",
        "timestep",
        "steps",
        "integrator",
        "impacts",
        "collision",
        "iterations",
        "stabilization",
    )
    chosen = {name: getattr(simulation, name) for name in names}
    return {
        "title": scene.title,
        **chosen,
        "record_every": model.spec.record.every,
        "meshes": dict(model.mesh_sha256),
    }


def body_facts(model: Model, index: int) -> Facts:
    """Mass, centre and principal moments [kg m^2] with their axes (unit vectors, body axes) of one body."""
    import numpy as np

    inertia = model.inertia[index]
    finite = bool(np.isfinite(inertia).all())
    moments, axes = np.linalg.eigh(inertia) if finite else (np.full(3, np.inf), np.eye(3))
    return {
        "name": model.body_names[index],
        "fixed": bool(model.fixed[index]),
        "material": model.material_names[model.body_material[index]],
        "mass": float(model.mass[index]),
        "center_of_mass": model.center_of_mass[index].tolist(),
        "principal_moments": moments.tolist(),
        "principal_axes": axes.T.tolist() if finite else None,
        "method": model.mass_method[index],
    }


def pair_facts(model: Model) -> list[Facts]:
    """Every pair of the materials in use with the row or rule that its numbers came from."""
    names, pairs = model.material_names, model.pairs
    return [
        {
            "between": [names[i], names[j]],
            "restitution": float(pairs.restitution[i, j]),
            "static_friction": float(pairs.static_friction[i, j]),
            "kinetic_friction": float(pairs.kinetic_friction[i, j]),
            "rolling_friction": float(pairs.rolling_friction[i, j]),
            "spinning_friction": float(pairs.spinning_friction[i, j]),
            "source": pairs.source[i][j],
        }
        for i, j in combinations_with_replacement(range(len(names)), 2)
    ]


def overlap_facts(overlap: Overlap) -> Facts:
    """Two bodies, the depth [m] and where it is greatest [m]."""
    return {
        "between": [overlap.body_a, overlap.body_b],
        "depth": overlap.depth,
        "position": list(overlap.position),
    }


def as_text(facts: Facts) -> str:
    """The whole answer for people."""
    scene = facts["scene"]
    bodies = output.counted(len(facts["bodies"]), "body", "bodies")
    head = (
        f"{click.style(facts['file'], bold=True)}: {scene['title']}\n"
        f"{bodies}; {scene['duration']:g} s in {scene['steps']} steps of "
        f"{scene['timestep']:g} s, {scene['integrator']}; a frame every {scene['record_every']:g} s"
    )
    mechanics = {
        "springs": info_mechanics.springs_text,
        "joints": info_mechanics.joints_text,
        "forces": info_mechanics.forces_text,
    }
    there = [text(facts[name]) for name, text in mechanics.items() if facts[name]]
    contacts = [pairs_text(facts["pairs"]), overlaps_text(facts["overlaps"])]
    return "\n\n".join([head, bodies_text(facts["bodies"]), *there, *contacts])


def bodies_text(bodies: Sequence[Facts]) -> str:
    """Two tables: where the mass is, and how it is spread; copies of a repeated body are told once."""
    bodies = without_copies(bodies)
    masses = [
        [
            body["name"],
            "fixed" if body["fixed"] else "moves",
            body["material"],
            number(body["mass"], 6),
            place(body["center_of_mass"]),
            body["method"],
        ]
        for body in bodies
    ]
    inertias = [
        [
            body["name"],
            vector(body["principal_moments"]),
            "; ".join(direction(axis) for axis in body["principal_axes"]),
        ]
        for body in bodies
        if body["principal_axes"] is not None
    ]
    return "\n\n".join(
        [
            table(
                ("body", "", "material", "mass [kg]", "centre of mass [m]", "mass and inertia by"),
                masses,
                right=(3,),
            ),
            table(("body", "principal moments [kg m^2]", "principal axes (body axes)"), inertias),
        ]
    )


def without_copies(bodies: Sequence[Facts]) -> list[Facts]:
    """One entry for each declared body: `brick[0,0,0]` and its copies become `brick (50 copies)`."""
    copies: dict[str, list[Facts]] = {}
    for body in bodies:
        copies.setdefault(body["name"].partition("[")[0], []).append(body)
    return [
        group[0] | ({"name": f"{name} ({len(group)} copies)"} if len(group) > 1 else {})
        for name, group in copies.items()
    ]


def pairs_text(pairs: Sequence[Facts]) -> str:
    """The resolved matrix, one pair in a line; rolling and spinning friction where there is any."""
    columns = {"restitution": "restitution", "static_friction": "static", "kinetic_friction": "kinetic"}
    for lever, head in (("rolling_friction", "rolling [m]"), ("spinning_friction", "spinning [m]")):
        if any(pair[lever] for pair in pairs):
            columns[lever] = head
    rows = [
        [" - ".join(pair["between"]), *(number(pair[name]) for name in columns), pair["source"]]
        for pair in pairs
    ]
    return table(("pair", *columns.values(), "from"), rows, right=range(1, 1 + len(columns)))


def overlaps_text(overlaps: Sequence[Facts]) -> str:
    """Bodies that overlap at the start, deepest first."""
    if not overlaps:
        return "No bodies overlap at the start."
    rows = [
        [" - ".join(overlap["between"]), number(overlap["depth"]), place(overlap["position"])]
        for overlap in overlaps
    ]
    return table(("overlap at the start", "depth [m]", "at [m]"), rows, right=(1,))

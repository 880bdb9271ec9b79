"""The trajectory file, version 1: every dataset with its axes, type, unit and meaning.

This table is the only place where the file's names stand. The writer creates its datasets from it, the reader
checks a file against it, and `as_markdown` prints it for the documentation.

Groups that a run has nothing for are absent: `/joints` and `/springs` when the scene has none or says
`record: {joints: false}`, `/energy` when `record: {energy: false}`, `/contacts` when `record: {contacts:
false}`; `/geometry` in files of before shapes were kept. Impacts are always recorded; `/energy/spring` and
`/energy/work_motors` are 0 when nothing feeds them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Literal

from physsim.recording.column import Column
from physsim.recording.connections import JOINTS, SPRINGS

FORMAT = "physsim-trajectory"
FORMAT_VERSION = 1
CONVENTIONS = "CF-1.11"

Status = Literal["running", "complete", "failed", "interrupted"]
STATUSES: tuple[Status, ...] = ("running", "complete", "failed", "interrupted")

SLOTS = ("a", "b")

_LABELS = (
    Column(
        "time",
        ("time",),
        "f8",
        "s",
        "Time of each frame: the step number times the timestep, never summed up.",
    ),
    Column("body", ("body",), "str", "1", "Name of each body, as in the scene."),
    Column("axis", ("axis",), "str", "1", "World axes."),
    Column("axis_2", ("axis_2",), "str", "1", "World or body axes, as the second index of a matrix."),
    Column("quaternion", ("quaternion",), "str", "1", "Components of a unit quaternion, scalar part first."),
)

_STATE = (
    Column("step", ("time",), "i8", "1", "Number of steps done at each frame."),
    Column(
        "position", ("time", "body", "axis"), "f8", "m", "Position of the body's own origin, as declared."
    ),
    Column("orientation", ("time", "body", "quaternion"), "f8", "1", "Unit quaternion, body to world."),
    Column("velocity", ("time", "body", "axis"), "f8", "m s-1", "Velocity of the centre of mass."),
    Column("angular_velocity", ("time", "body", "axis"), "f8", "rad s-1", "Angular velocity, world axes."),
)

_BODIES = (
    Column("mass", ("body",), "f8", "kg", "Mass; infinite for a half-space."),
    Column(
        "inertia",
        ("body", "axis", "axis_2"),
        "f8",
        "kg m2",
        "Inertia tensor about the centre of mass, body axes.",
    ),
    Column(
        "center_of_mass", ("body", "axis"), "f8", "m", "Centre of mass from the body's origin, body axes."
    ),
    Column("material", ("body",), "str", "1", "Name of each body's material."),
    Column("fixed", ("body",), "i1", "1", "1 for a body that never moves, else 0."),
)

ENERGY_STATE = ("kinetic_translational", "kinetic_rotational", "gravitational", "gravitation", "spring")
ENERGY_SUMS = (
    "work_forces",
    "work_motors",
    "lost_damping",
    "lost_friction",
    "lost_impact",
    "stabilization",
    "residual",
)
_ENERGY_WORDS = {
    "kinetic_translational": "Kinetic energy of translation, all moving bodies.",
    "kinetic_rotational": "Kinetic energy of rotation, all moving bodies.",
    "gravitational": "Potential energy in gravity, zero at the world's origin.",
    "gravitation": "Potential energy of the attraction between bodies, zero far apart.",
    "spring": "Energy stored in springs.",
    "work_forces": "Work done by declared forces and torques, since the start.",
    "work_motors": "Work done by motors, since the start.",
    "lost_damping": "Energy taken out by dampers, since the start.",
    "lost_friction": "Energy taken out by friction, since the start.",
    "lost_impact": "Energy taken out by impacts, since the start.",
    "stabilization": "Energy put in by correcting positions, since the start.",
    "residual": "What the books do not explain, since the start.",
}
_ENERGY = tuple(
    Column(f"energy/{name}", ("time",), "f8", "J", _ENERGY_WORDS[name], later=name == "gravitation")
    for name in (*ENERGY_STATE, *ENERGY_SUMS)
)

_MOMENTUM = (
    Column("momentum/linear", ("time", "axis"), "f8", "kg m s-1", "Sum of m v over all moving bodies."),
    Column(
        "momentum/angular",
        ("time", "axis"),
        "f8",
        "kg m2 s-1",
        "Sum of m x × v + I ω over all moving bodies, about the world's origin.",
    ),
)

_GEOMETRY = (
    Column("geometry/body", ("geometry",), "i4", "1", "The body it belongs to, as a row of /body."),
    Column(
        "geometry/kind",
        ("geometry",),
        "str",
        "1",
        "sphere, capsule, box, cylinder, cone, ellipsoid, rod, halfspace or surface.",
    ),
    Column(
        "geometry/parameters",
        ("geometry", "parameter"),
        "f8",
        "m",
        "sphere: radius; capsule and cylinder: radius, half height (axis z); box: half edges; cone: radius, "
        "height (axis z, origin a quarter of the height above the base); ellipsoid: half axes; rod: half "
        "length (axis z); halfspace: none (solid where z is below 0).",
    ),
    Column(
        "geometry/position",
        ("geometry", "axis"),
        "f8",
        "m",
        "Of its frame from the body's origin, body axes.",
    ),
    Column(
        "geometry/orientation",
        ("geometry", "quaternion"),
        "f8",
        "1",
        "Unit quaternion, its frame to body axes.",
    ),
    Column("geometry/material", ("geometry",), "str", "1", "Name of its material."),
    Column("geometry/color", ("geometry",), "str", "1", "#rrggbb, empty where nobody declares one."),
    Column("geometry/shown", ("geometry",), "i1", "1", "1 for what the scene draws, else 0."),
    Column("geometry/collides", ("geometry",), "i1", "1", "1 for what collides, else 0."),
    Column("geometry/surface", ("geometry",), "i4", "1", "Its surface; -1 for kinds without one."),
    Column(
        "geometry/vertex_offset",
        ("surface_boundary",),
        "i8",
        "1",
        "Vertices of surface k are offset[k] to offset[k + 1], the last not included.",
    ),
    Column(
        "geometry/triangle_offset",
        ("surface_boundary",),
        "i8",
        "1",
        "Triangles of surface k are offset[k] to offset[k + 1], the last not included.",
    ),
    Column("geometry/vertices", ("vertex", "axis"), "f8", "m", "Vertices of all surfaces, geometry's frame."),
    Column(
        "geometry/triangles",
        ("triangle", "corner"),
        "i4",
        "1",
        "Corners as vertices of the own surface, counted from 0, counter-clockwise seen from outside.",
    ),
)

_CONTACTS = (
    Column("contacts/frame", ("contact",), "i8", "1", "Frame that the contact belongs to."),
    Column("contacts/body_a", ("contact",), "i4", "1", "Body A, as a row of /body."),
    Column("contacts/body_b", ("contact",), "i4", "1", "Body B, as a row of /body."),
    Column("contacts/position", ("contact", "axis"), "f8", "m", "Point midway between the two surfaces."),
    Column("contacts/normal", ("contact", "axis"), "f8", "1", "Unit vector from B to A."),
    Column("contacts/depth", ("contact",), "f8", "m", "Positive where the bodies overlap."),
    Column(
        "contacts/impulse",
        ("contact", "axis"),
        "f8",
        "N s",
        "Impulse on A in the step that ends at the frame.",
    ),
    Column(
        "contacts/normal_impulse", ("contact",), "f8", "N s", "Its part along the normal, never negative."
    ),
    Column(
        "contacts/tangential_impulse",
        ("contact", "axis"),
        "f8",
        "N s",
        "Its part along the surface: friction.",
    ),
    Column("contacts/force", ("contact", "axis"), "f8", "N", "Impulse divided by the timestep, on A."),
    Column(
        "contacts/relative_velocity_before",
        ("contact", "axis"),
        "f8",
        "m s-1",
        "Velocity of A at the point minus that of B, before the step's impulses.",
    ),
    Column(
        "contacts/relative_velocity_after",
        ("contact", "axis"),
        "f8",
        "m s-1",
        "Velocity of A at the point minus that of B, after the step's impulses.",
    ),
    Column("contacts/pair", ("contact",), "i4", "1", "Pair of materials, as a row of /pairs."),
    Column("contacts/sliding", ("contact",), "i1", "1", "1 where the surfaces slide, 0 where they stick."),
    Column(
        "contacts/offset",
        ("boundary",),
        "i8",
        "1",
        "Rows of frame k are offset[k] to offset[k + 1], the last not included.",
    ),
)

_EVENTS = (
    Column("events/time", ("event",), "f8", "s", "Time of the impact."),
    Column("events/body_a", ("event",), "i4", "1", "Body A, as a row of /body."),
    Column("events/body_b", ("event",), "i4", "1", "Body B, as a row of /body."),
    Column("events/position", ("event", "axis"), "f8", "m", "Point of impact."),
    Column("events/normal", ("event", "axis"), "f8", "1", "Unit vector from B to A."),
    Column("events/speed_before", ("event",), "f8", "m s-1", "Speed of approach along the normal."),
    Column("events/speed_after", ("event",), "f8", "m s-1", "Speed of separation along the normal."),
    Column("events/impulse", ("event",), "f8", "N s", "Impulse along the normal, on A."),
    Column("events/restitution_declared", ("event",), "f8", "1", "Coefficient of restitution of the pair."),
    Column("events/restitution_measured", ("event",), "f8", "1", "Speed after divided by speed before."),
)

_SOLVER = (
    Column(
        "solver/residual", ("time",), "f8", "m s-1", "Largest velocity error left by the last step's solve."
    ),
    Column("solver/iterations", ("time",), "i8", "1", "Sweeps that the last step's solve took."),
    Column("solver/contact_count", ("time",), "i8", "1", "Contact points in the last step."),
    Column(
        "solver/fallbacks",
        ("time",),
        "i8",
        "1",
        "Steps since the start in which located impacts were given up and done as stepped ones.",
        later=True,
    ),
)

_PAIRS = (
    Column("pairs/pair", ("pair",), "str", "1", "The two materials of each row."),
    Column("pairs/material_a", ("pair",), "str", "1", "One material of the pair."),
    Column("pairs/material_b", ("pair",), "str", "1", "The other material of the pair."),
    Column("pairs/restitution", ("pair",), "f8", "1", "Coefficient of restitution."),
    Column("pairs/static_friction", ("pair",), "f8", "1", "Coefficient of static friction."),
    Column("pairs/kinetic_friction", ("pair",), "f8", "1", "Coefficient of kinetic friction."),
    Column("pairs/rolling_friction", ("pair",), "f8", "m", "Lever of rolling friction.", later=True),
    Column("pairs/spinning_friction", ("pair",), "f8", "m", "Lever of spinning friction.", later=True),
    Column(
        "pairs/source",
        ("pair",),
        "str",
        "1",
        "Row of the scene or library, or the mixing rule, that gave it.",
    ),
)

_PROVENANCE = (
    Column("provenance/scene", (), "str", "1", "The scene as it was given, YAML text."),
    Column("provenance/scene_resolved", (), "str", "1", "The scene with every default filled in, SI units."),
    Column("provenance/mesh_sha256", (), "str", "1", "JSON: SHA-256 of every mesh file, by name."),
    Column("provenance/versions", (), "str", "1", "JSON: versions of physsim and of what it stands on."),
    Column("provenance/host", (), "str", "1", "The machine that ran it."),
    Column("provenance/command", (), "str", "1", "The command line that ran it."),
    Column("provenance/started", (), "str", "1", "Clock time of the start, ISO 8601, UTC."),
    Column("provenance/finished", (), "str", "1", "Clock time of the end, empty until then."),
    Column(
        "provenance/wall_time", (), "f8", "s", "Seconds that the run took by the clock, resumes included."
    ),
)

_CHECKPOINT = tuple(
    column
    for slot in SLOTS
    for column in (
        Column(f"checkpoint/{slot}/engine", ("byte",), "u1", "1", "State of the engine, its own format."),
        Column(f"checkpoint/{slot}/step", (), "i8", "1", "Steps done; -1 for an empty slot."),
        Column(f"checkpoint/{slot}/frames", (), "i8", "1", "Whole frames in the file at that step."),
        Column(f"checkpoint/{slot}/events", (), "i8", "1", "Rows of /events at that step."),
        Column(
            f"checkpoint/{slot}/digest", (), "i8", "1", "First 8 bytes of the SHA-256 of the slot's content."
        ),
    )
)

_ALWAYS = (*_LABELS, *_STATE, *_BODIES, *_MOMENTUM, *_EVENTS, *_SOLVER, *_PAIRS, *_PROVENANCE, *_CHECKPOINT)

EVERYTHING: tuple[Column, ...] = (*_ALWAYS, *_GEOMETRY, *_ENERGY, *_CONTACTS, *JOINTS, *SPRINGS)
BY_PATH = {column.path: column for column in EVERYTHING}
_OPTIONAL = {
    "geometry": _GEOMETRY,
    "energy": _ENERGY,
    "contacts": _CONTACTS,
    "joints": JOINTS,
    "springs": SPRINGS,
}
OPTIONAL_GROUPS = tuple(_OPTIONAL)


def recorded(groups: Iterable[str]) -> tuple[Column, ...]:
    """The datasets of a run that records these of `OPTIONAL_GROUPS`."""
    chosen = set(groups)
    return (*_ALWAYS, *(column for name in OPTIONAL_GROUPS if name in chosen for column in _OPTIONAL[name]))


def bare_axes(columns: tuple[Column, ...]) -> Iterator[tuple[str, str]]:
    """`(group, axis)` for every axis without labels of its own: contact, boundary, event."""
    labelled = {column.name for column in columns if column.is_scale}
    seen = set()
    for column in columns:
        for dim in column.dims:
            if dim not in labelled and (column.group, dim) not in seen:
                seen.add((column.group, dim))
                yield column.group, dim


def as_markdown() -> str:
    """The whole file as a Markdown table, for the documentation."""
    lines = ["| dataset | axes | type | unit | meaning |", "|---|---|---|---|---|"]
    for column in EVERYTHING:
        axes = ", ".join(column.dims) or "single value"
        unit = "" if column.units == "1" else column.units
        lines.append(f"| `/{column.path}` | {axes} | {column.kind} | {unit} | {column.description} |")
    return "\n".join(lines) + "\n"

"""The datasets of joints and springs."""

from __future__ import annotations

from physsim.recording.column import Column


def _who(group: str, axis: str, word: str) -> tuple[Column, ...]:
    """Names, types, ends: what is the same in every frame."""
    ends = (
        column
        for end in ("a", "b")
        for column in (
            Column(
                f"{group}/body_{end}",
                (axis,),
                "i4",
                "1",
                f"Body {end.upper()}, as a row of /body; -1 for the world.",
            ),
            Column(
                f"{group}/anchor_{end}",
                (axis, "axis"),
                "f8",
                "m",
                f"Where the {word} is tied to body {end.upper()}, in that body's own frame.",
            ),
        )
    )
    return (
        Column(f"{group}/{axis}", (axis,), "str", "1", f"Name of each {word}, as in the scene."),
        Column(f"{group}/type", (axis,), "str", "1", f"Type of each {word}, as in the scene."),
        *ends,
        Column(
            f"{group}/axis_a",
            (axis, "axis"),
            "f8",
            "1",
            f"Axis of the {word}, a unit vector in body A's own axes; NaN for types without one.",
            later=True,
        ),
    )


def _coordinate(name: str, ordinal: str) -> tuple[Column, Column]:
    meaning = f"Its {ordinal} coordinate, B seen from A, 0 as placed, turns counted; NaN where it has none."
    unit = f"Unit of {name}: rad or m, empty where it has none."
    return (
        Column(f"joints/{name}", ("time", "joint"), "f8", "1", meaning),
        Column(f"joints/{name}_unit", ("joint",), "str", "1", unit),
    )


JOINTS: tuple[Column, ...] = (
    *_who("joints", "joint", "joint"),
    Column("joints/force", ("time", "joint", "axis"), "f8", "N", "Reaction force on A, world axes."),
    Column(
        "joints/torque",
        ("time", "joint", "axis"),
        "f8",
        "N m",
        "Reaction torque on A about its anchor, world axes.",
    ),
    *_coordinate("coordinate", "first"),
    *_coordinate("coordinate_2", "second"),
    *_coordinate("coordinate_3", "third"),
    Column("joints/violation", ("time", "joint"), "f8", "m", "How far apart what it holds together is."),
    Column(
        "joints/angular_violation",
        ("time", "joint"),
        "f8",
        "rad",
        "How far turned what it holds parallel is.",
    ),
    Column("joints/broken", ("time", "joint"), "i1", "1", "1 once the joint has broken, else 0."),
)

SPRINGS: tuple[Column, ...] = (
    *_who("springs", "spring", "spring"),
    Column(
        "springs/length",
        ("time", "spring"),
        "f8",
        "1",
        "Length; of a torsional spring its angle, 0 as placed, turns counted.",
    ),
    Column(
        "springs/length_unit", ("spring",), "str", "1", "Unit of length: m, or rad for torsional springs."
    ),
    Column(
        "springs/force",
        ("time", "spring"),
        "f8",
        "1",
        "Tension, positive where it pulls the ends together; of a torsional spring the torque on A about its "
        "axis.",
    ),
    Column("springs/force_unit", ("spring",), "str", "1", "Unit of force: N, or N m for torsional springs."),
)

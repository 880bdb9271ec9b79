"""What `physsim info` says of a scene's springs, joints and forces."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from physsim.cli.table import number, table, vector

if TYPE_CHECKING:
    from physsim.model import Model
    from physsim.model.springs import Spring
    from physsim.scene.spec.drives import DriveSpec
    from physsim.scene.spec.forces import ForceSpec
    from physsim.scene.spec.joints import JointSpec

Facts = dict[str, Any]


def spring_facts(model: Model) -> list[Facts]:
    """Each spring with what it does with the mass at its ends; SI, None for what it does not have."""
    springs = model.mechanics.springs
    return [
        {
            "name": name,
            "type": kind,
            "between": list(model.spec.springs[name].between),
            "rest": row.rest,
            "placed": row.placed,
            **_oscillation_facts(row),
        }
        for name, kind, row in zip(springs.names, springs.types, springs.rows, strict=True)
    ]


def _oscillation_facts(row: Spring) -> Facts:
    swing = row.oscillation
    swings = swing.angular_frequency > 0
    return {
        "stiffness": swing.stiffness,
        "damping": swing.damping,
        "effective_mass": 1 / swing.mobility if swing.mobility > 0 else None,
        "angular_frequency": swing.angular_frequency if swings else None,
        "frequency": swing.frequency if swings else None,
        "damping_ratio": swing.damping_ratio,
        "critical_damping": swing.critical_damping,
    }


def joint_facts(model: Model) -> list[Facts]:
    """Each joint with the degrees of freedom that it takes away and what acts along those that it leaves."""
    from physsim.model.joints import DEGREES_REMOVED

    joints = model.mechanics.joints
    return [
        {
            "name": name,
            "type": spec.type,
            "between": list(spec.joints if spec.type == "gear" else spec.between),
            "degrees_removed": DEGREES_REMOVED[row.kind],
            "drives": list(_drives(spec)),
        }
        for (name, spec), row in zip(model.spec.joints.items(), joints.rows, strict=False)
    ]


def _drives(joint: JointSpec) -> Iterator[str]:
    """One phrase for each coordinate along which something acts."""
    from physsim.scene.spec.joints import COORDINATES, drives_of, is_angle

    for coordinate, _, drive in drives_of(joint):
        name = COORDINATES[joint.type][coordinate]
        units = ("rad", "N m") if is_angle(name) else ("m", "N")
        phrases = list(_drive_phrases(drive, *units))
        if phrases:
            yield f"{name}: {', '.join(phrases)}"
    if joint.type == "distance" and joint.limits is not None:
        yield f"length: {_limits(joint.limits, 'm')}"
    if joint.type == "gear":
        yield f"angle_2 = {joint.ratio:g} angle_1"


def _drive_phrases(drive: DriveSpec, unit: str, force: str) -> Iterator[str]:
    if drive.limits is not None:
        yield _limits(drive.limits, unit)
    if drive.friction:
        yield f"dry friction {drive.friction:.4g} {force}"
    if drive.damping:
        yield f"damping {drive.damping:.4g} {force} s/{unit}"
    if drive.spring is not None:
        yield f"spring {drive.spring.stiffness:.4g} {force}/{unit} to {drive.spring.rest:.4g} {unit}"
    if drive.motor is not None:
        yield _motor_phrase(drive.motor, unit, force)


def _motor_phrase(motor: Any, unit: str, force: str) -> str:
    is_angle = unit == "rad"
    largest = motor.max_torque if is_angle else motor.max_force
    bound = "" if largest is None else f", at most {largest:.4g} {force}"
    course = "" if motor.profile is None else f" ({motor.profile.type})"
    if motor.speed is not None:
        return f"motor to {motor.speed:.4g} {unit}/s{course}{bound}"
    target = motor.angle if is_angle else motor.travel
    return f"servo to {target:.4g} {unit}{course} with {motor.stiffness:.4g} {force}/{unit}{bound}"


def _limits(limits: Sequence[float], unit: str) -> str:
    return f"limits {limits[0]:.4g} to {limits[1]:.4g} {unit}"


def force_facts(model: Model) -> list[Facts]:
    """Each force with the bodies it acts on, what it is, and when."""
    from physsim.scene.patterns import matches

    moving = [name for name, fixed in zip(model.body_names, model.fixed, strict=True) if not fixed]
    return [
        {
            "name": name,
            "bodies": [body for body in moving if matches(spec.body, body)],
            "acts": ", ".join(_force_phrases(spec)),
            "from": spec.from_,
            "until": spec.until,
            "profile": None if spec.profile is None else spec.profile.type,
        }
        for name, spec in model.spec.forces.items()
    ]


def _force_phrases(spec: ForceSpec) -> Iterator[str]:
    axes = " in body axes" if spec.frame == "body" else ""
    if spec.force is not None:
        yield f"force {vector(spec.force)} N{axes}"
    if spec.torque is not None:
        yield f"torque {vector(spec.torque)} N m{axes}"
    if spec.acceleration is not None:
        where = "" if spec.region is None else f" from {vector(spec.region[0])} to {vector(spec.region[1])} m"
        yield f"acceleration {vector(spec.acceleration)} m/s^2{where}"
    drag = spec.drag
    if drag is not None and drag.linear:
        yield f"drag {drag.linear:.4g} N s/m"
    if drag is not None and drag.angular:
        yield f"drag {drag.angular:.4g} N m s/rad"
    if drag is not None and drag.density is not None:
        yield f"drag C = {drag.coefficient:.4g} on {drag.area:.4g} m^2 in {drag.density:.4g} kg/m^3"


def springs_text(springs: Sequence[Facts]) -> str:
    """One line for each spring; its units are those of its type."""
    head = ("spring", "type", "between", "k", "c", "omega [rad/s]", "f [Hz]", "damping ratio", "critical c")
    rows = [
        [
            spring["name"],
            spring["type"],
            " - ".join(spring["between"]),
            *_numbers(
                spring,
                (
                    "stiffness",
                    "damping",
                    "angular_frequency",
                    "frequency",
                    "damping_ratio",
                    "critical_damping",
                ),
            ),
        ]
        for spring in springs
    ]
    units = "k in N/m, c in N s/m; of torsional springs in N m/rad and N m s/rad"
    return table(head, rows, right=range(3, 9)) + f"\n{units}"


def joints_text(joints: Sequence[Facts]) -> str:
    """One line for each joint."""
    rows = [
        [
            joint["name"],
            joint["type"],
            " - ".join(joint["between"]),
            str(joint["degrees_removed"]),
            "; ".join(joint["drives"]),
        ]
        for joint in joints
    ]
    return table(("joint", "type", "between", "degrees removed", "along what it leaves"), rows, right=(3,))


def forces_text(forces: Sequence[Facts]) -> str:
    """One line for each force."""
    rows = [[force["name"], _bodies(force["bodies"]), force["acts"], _when(force)] for force in forces]
    return table(("force", "on", "is", "when"), rows)


def _numbers(facts: Facts, names: Sequence[str]) -> list[str]:
    return [number(facts[name], 4) for name in names]


def _bodies(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{len(names)} bodies"


def _when(force: Facts) -> str:
    end = "" if force["until"] is None else f" until {force['until']:g} s"
    course = "" if force["profile"] is None else f", {force['profile']}"
    return f"from {force['from']:g} s{end}{course}"

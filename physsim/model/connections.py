"""Doubts about springs and joints as they were placed."""

from __future__ import annotations

from physsim.model.findings import Findings
from physsim.model.joints import Joint, JointKind, JointTable
from physsim.model.springs import COINCIDING, SpringKind, SpringTable

PLACED = 1e-6
"""Part of its length by which a distance joint may be off as placed, and metres for short ones."""


def check_placement(springs: SpringTable, joints: JointTable, findings: Findings) -> None:
    """Write into `findings` what does not fit where the bodies stand at the start."""
    for name, spring in zip(springs.names, springs.rows, strict=True):
        if spring.kind is SpringKind.LINEAR and spring.placed < COINCIDING:
            findings.warn(
                ("springs", name, "anchors"),
                "coincide at the start, so that the spring has no direction until they part",
                hint="each anchor is in its body's own frame",
            )
    stops = {drive.joint: drive.limits for drive in joints.drives}
    for number, (name, joint) in enumerate(zip(joints.names, joints.rows, strict=False)):
        if joint.kind is JointKind.DISTANCE:
            _check_length(name, joint, joint.parameters[0], findings)
        elif joint.kind is JointKind.STOPS:
            _check_limits(name, joint, stops[number], findings)


def _check_length(name: str, joint: Joint, length: float, findings: Findings) -> None:
    if abs(joint.placed - length) > PLACED * max(length, 1.0):
        findings.warn(
            ("joints", name, "length"),
            f"is not the distance as placed, {joint.placed:.6g} m: it will be pulled there at once",
            given=f"{length:.6g} m",
            hint="move a body or an anchor; without length the distance as placed is kept",
        )


def _check_limits(name: str, joint: Joint, limits: tuple[float, float], findings: Findings) -> None:
    low, high = limits
    slack = PLACED * max(high, 1.0)
    if not low - slack <= joint.placed <= high + slack:
        findings.warn(
            ("joints", name, "limits"),
            f"leave out the distance as placed, {joint.placed:.6g} m: it will be pulled into them at once",
            given=f"{low:.6g} m to {high:.6g} m",
        )

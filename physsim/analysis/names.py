"""Names of quantities with patterns: `bodies.brick*.speed`."""

from __future__ import annotations

import re
from collections.abc import Iterator

from physsim.recording import NotInFile, Trajectory

_GROUPED = re.compile(r"(bodies|joints|springs)\.(.*)", re.DOTALL)
_NAMES = {"bodies": "body_names", "joints": "joint_names", "springs": "spring_names"}


def expanded(trajectory: Trajectory, name: str) -> list[str]:
    """The names that a pattern stands for (`bodies.brick*.speed`); a name without `*` is itself."""
    match = _GROUPED.match(name)
    if "*" not in name or not match:
        return [name]
    found = list(_fitting(trajectory, match[1], match[2]))
    if not found:
        raise NotInFile(f"{trajectory.path}: nothing fits {name}")
    return found


def _fitting(trajectory: Trajectory, group: str, rest: str) -> Iterator[str]:
    """`brick*.position.z`: the field is what follows the last `*`-free dot that makes it a quantity."""
    from physsim.scene.patterns import matches  # noqa: PLC0415, slow to import

    pattern, field = _split(trajectory, group, rest)
    for owner in getattr(trajectory, _NAMES[group]):
        if matches(pattern, owner):
            yield f"{group}.{owner}.{field}"


def _split(trajectory: Trajectory, group: str, rest: str) -> tuple[str, str]:
    quantity = trajectory.find_quantity(f"{group}.{rest}")
    field = quantity.field if quantity.component is None else f"{quantity.field}.{quantity.component}"
    return str(quantity.name), field

"""Whether an inertia tensor can belong to a body."""

from __future__ import annotations

import math

from physsim.scene.spec.bodies import InertiaSpec

# Share of the largest moment by which the triangle inequality may be missed: thin plates reach equality, and
# published tensors are rounded.
ROUNDING = 1e-9
# Share of the largest moment below which the smallest counts as zero: what rounding makes of an exact zero.
NOTHING = 1e-12


def inertia_trouble(inertia: InertiaSpec) -> str | None:
    """What is impossible about the tensor, None when a body can have it.

    Principal moments are positive, and none exceeds the sum of the other two, since each is an integral of
    the squared distance from an axis (Goldstein, Classical Mechanics, 3rd ed., 2002, section 5.3).
    """
    low, middle, high = principal_moments(inertia)
    told = f"principal moments {low:g}, {middle:g}, {high:g} kg m^2"
    if low <= NOTHING * high:
        return f"is not positive definite ({told})"
    if low + middle < high * (1 - ROUNDING):
        return f"breaks the triangle inequality: no body turns so hard about one axis ({told})"
    return None


def principal_moments(inertia: InertiaSpec) -> tuple[float, float, float]:
    """Eigenvalues of the tensor [kg m^2], rising: closed form for symmetric 3x3 (Smith 1961, CACM 4:168)."""
    scale = max(inertia.xx, inertia.yy, inertia.zz, abs(inertia.xy), abs(inertia.xz), abs(inertia.yz))
    xx, yy, zz = inertia.xx / scale, inertia.yy / scale, inertia.zz / scale
    xy, xz, yz = inertia.xy / scale, inertia.xz / scale, inertia.yz / scale
    mean = (xx + yy + zz) / 3
    a, b, c = xx - mean, yy - mean, zz - mean
    spread = math.sqrt((a * a + b * b + c * c + 2 * (xy * xy + xz * xz + yz * yz)) / 6)
    if spread < 1e-15:
        return (mean * scale,) * 3
    determinant = a * (b * c - yz * yz) - xy * (xy * c - yz * xz) + xz * (xy * yz - b * xz)
    angle = math.acos(max(-1.0, min(1.0, determinant / (2 * spread**3)))) / 3
    high = mean + 2 * spread * math.cos(angle)
    low = mean + 2 * spread * math.cos(angle + 2 * math.pi / 3)
    return low * scale, (3 * mean - high - low) * scale, high * scale

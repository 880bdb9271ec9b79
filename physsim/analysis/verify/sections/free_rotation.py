"""The torque-free asymmetric body in closed form (Landau & Lifshitz, Mechanics, 3rd ed., sec. 37).

Moments I1 < I2 < I3, started with omega = (w1, 0, w3) in body axes and the attitude 1, with M^2 > 2 E I2.
"""

from __future__ import annotations

import numpy as np

from physsim.analysis.verify.case import Array, Values

GAUSS_POINTS = 12


def euler_top(p: Values, t: Array) -> Array:
    """(T, 3): omega in body axes, (w1 cn, W2 sn, w3 dn) of tau = rate t (eqs. 37.10 to 37.12) [rad/s]."""
    from scipy.special import ellipj  # noqa: PLC0415, slow to import

    i1, i2, i3, w1, w3 = (p[name] for name in ("I1", "I2", "I3", "w1", "w3"))
    twice_energy, square = i1 * w1**2 + i3 * w3**2, (i1 * w1) ** 2 + (i3 * w3) ** 2
    if square <= twice_energy * i2:
        raise ValueError("this form of the solution needs M^2 > 2 E I2")
    rate = np.sqrt((i3 - i2) * (square - twice_energy * i1) / (i1 * i2 * i3))
    modulus = (i2 - i1) * (twice_energy * i3 - square) / ((i3 - i2) * (square - twice_energy * i1))
    amplitude = np.sqrt((twice_energy * i3 - square) / (i2 * (i3 - i2)))
    sn, cn, dn, _ = ellipj(rate * t, modulus)
    return np.column_stack([w1 * cn, amplitude * sn, w3 * dn])


def euler_top_attitude(p: Values, t: Array) -> Array:
    """(T, 3, 3): rotation matrices, body to world.

    With Z along L: cos theta = I3 W3 / M, tan psi = I1 W1 / (I2 W2) (eq. 37.15), and phi by quadrature
    (eq. 37.17).
    """
    moments = np.array([p["I1"], p["I2"], p["I3"]])
    l1, l2, l3 = (moments * euler_top(p, t)).T
    theta = np.arccos(l3 / np.sqrt(l1**2 + l2**2 + l3**2))
    about_l = _euler_angles(azimuth(p, t), theta, np.arctan2(l1, l2))
    return np.asarray(about_l[0].T @ about_l)


def azimuth(p: Values, t: Array) -> Array:
    """(T): phi' = M (I1 W1^2 + I2 W2^2) / (I1^2 W1^2 + I2^2 W2^2), by Gauss-Legendre between the times
    [rad].
    """
    nodes, weights = np.polynomial.legendre.leggauss(GAUSS_POINTS)
    half, middle = np.diff(t) / 2, (t[1:] + t[:-1]) / 2
    rates = _azimuth_rate(p, (middle[:, None] + half[:, None] * nodes).ravel()).reshape(len(half), -1)
    return np.concatenate([[0.0], np.cumsum(half * (rates @ weights))])


def _azimuth_rate(p: Values, t: Array) -> Array:
    moments = np.array([p["I1"], p["I2"], p["I3"]])
    momentum = moments * euler_top(p, t)
    size = np.linalg.norm(momentum, axis=1)
    two = momentum[:, :2]
    return np.asarray(size * (two**2 / moments[:2]).sum(axis=1) / (two**2).sum(axis=1))


def _euler_angles(phi: Array, theta: Array, psi: Array) -> Array:
    """(T, 3, 3): R_z(phi) R_x(theta) R_z(psi) (Landau & Lifshitz, sec. 35)."""
    return _about(2, phi) @ _about(0, theta) @ _about(2, psi)


def _about(axis: int, angle: Array) -> Array:
    first, second = (axis + 1) % 3, (axis + 2) % 3
    turn = np.zeros((len(angle), 3, 3))
    turn[:, axis, axis] = 1
    turn[:, first, first] = turn[:, second, second] = np.cos(angle)
    turn[:, second, first] = np.sin(angle)
    turn[:, first, second] = -turn[:, second, first]
    return turn

"""Quaternions and matrices."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from physsim.model import rotation

parts = st.floats(-1, 1)
quaternions = (
    st.tuples(parts, parts, parts, parts)
    .filter(lambda q: np.linalg.norm(q) > 0.1)
    .map(lambda q: np.array(q) / np.linalg.norm(q))
)


@given(quaternions, quaternions)
def test_matrices_and_products_agree_with_scipy(p: np.ndarray, q: np.ndarray) -> None:
    """scipy keeps the scalar last; entries agree to 1e-14."""
    ours = rotation.matrix(rotation.product(p, q))
    theirs = (Rotation.from_quat(np.roll(p, -1)) * Rotation.from_quat(np.roll(q, -1))).as_matrix()
    assert ours == pytest.approx(theirs, abs=1e-14)


@given(st.tuples(parts, parts, parts).filter(lambda d: np.linalg.norm(d) > 1e-100))
def test_the_z_axis_is_taken_into_any_direction(direction: tuple[float, float, float]) -> None:
    unit = np.array(direction) / np.linalg.norm(direction)
    turned = rotation.matrix(rotation.from_z_to(direction)) @ [0, 0, 1]
    assert turned == pytest.approx(unit, abs=1e-14)


def test_down_is_half_a_turn_about_x() -> None:
    assert rotation.from_z_to((0, 0, -2)) == pytest.approx([0, 1, 0, 0], abs=1e-16)

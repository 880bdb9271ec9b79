"""The small formulas between the engine and the file, against other routes to the same numbers."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from physsim.model import rotation
from physsim.simulation.measure import origins, pair_rows, rotation_matrices

COMPONENT = st.floats(-1, 1)


@given(st.tuples(COMPONENT, COMPONENT, COMPONENT, COMPONENT).filter(lambda q: np.linalg.norm(q) > 0.1))
def test_rotation_matrices_are_those_of_the_model(q: tuple[float, ...]) -> None:
    """Two ways to write the same matrix; measured difference 3e-16."""
    unit = np.array(q) / np.linalg.norm(q)
    np.testing.assert_allclose(rotation_matrices(unit[None])[0], rotation.matrix(unit), rtol=0, atol=1e-15)


def test_origins_lead_back_from_the_centre_of_mass() -> None:
    """A quarter turn about z takes the offset (1, 2, 3) to (-2, 1, 3)."""
    quarter = np.array([[np.sqrt(0.5), 0, 0, np.sqrt(0.5)]])
    found = origins(np.array([[10.0, 10, 10]]), quarter, np.array([[1.0, 2, 3]]))
    np.testing.assert_allclose(found, [[12, 9, 7]], rtol=0, atol=1e-14)


def test_pair_rows_follow_the_table_of_pairs() -> None:
    assert pair_rows(3).tolist() == [[0, 1, 2], [1, 3, 4], [2, 4, 5]]

"""The small formulas between the engine and the file, against other routes to the same numbers."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from physsim.model import compile_scene, rotation
from physsim.recording.orientation import rotation_matrices
from physsim.scene.loader import load_scene_text
from physsim.simulation.measure import origins
from physsim.simulation.world import build

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


def test_momenta_are_sums_over_what_moves() -> None:
    """L = sum (m x × v + R I R^T ω) from what the engine hands out of bodies; measured difference 4e-16."""
    text = """
    physsim: 1
    simulation: {duration: 1 s, timestep: 1 ms}
    bodies:
      floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: steel}
      brick:
        repeat: {count: [2, 2, 1], spacing: [50 cm, 40 cm, 0]}
        shape: {type: box, size: [10 cm, 20 cm, 30 cm]}
        mass: 2 kg
        material: steel
        position: [0, 0, 2]
        velocity: [1, 2, 3]
        angular_velocity: [3, 1, -2]
    """
    model = compile_scene(load_scene_text(text))
    world = build(model).world
    world.advance(300, None)
    state, moves = world.state(), ~model.fixed
    turn = rotation_matrices(state["orientation"])[moves]
    spin = np.einsum("nij,njk,nlk,nl->ni", turn, model.inertia[moves], turn, state["angular_velocity"][moves])
    p = model.mass[moves, None] * state["velocity"][moves]
    whole = (np.cross(state["position"][moves], p) + spin).sum(axis=0)
    found = world.momentum()
    np.testing.assert_allclose(found["linear"], p.sum(axis=0), rtol=1e-14)
    np.testing.assert_allclose(found["angular"], whole, rtol=1e-13)

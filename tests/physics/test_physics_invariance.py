"""What must not matter: where one looks from, names, order, how often one runs."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from laboratory import Lab, body, lab, rotation

TURN = np.array([0.8, 0.1, -0.5, 0.3]) / np.linalg.norm([0.8, 0.1, -0.5, 0.3])
SHIFT = np.array([3.0, -1.0, 2.0])


def times(a, b):
    """Product of two quaternions (w, x, y, z)."""
    (w, u), (s, v) = (a[0], np.array(a[1:])), (b[0], np.array(b[1:]))
    return np.array([w * s - u @ v, *(w * v + s * u + np.cross(u, v))])


def collision(turn=(1.0, 0, 0, 0), shift=(0.0, 0, 0), *, names="abc", order=(0, 1, 2), timestep=1e-3) -> Lab:
    """Three free bodies meet, off centre and spinning; everything turned by `turn`, then shifted."""
    what = [
        ("type: sphere, radius: 0.1", (0, 0, 0), (2, 0.1, 0), (1, 0, 0, 0), (0, 9, 0)),
        ("type: box, size: [0.2, 0.3, 0.1]", (0.5, 0.05, 0), (-1, 0, 0), (0.9, 0.2, 0.3, 0.1), (1, 2, 3)),
        ("type: box, size: [0.1, 0.1, 0.4]", (0.9, 0, 0.1), (-2, 0, -0.2), (0.7, 0, 0.7, 0), (0, 0, -4)),
    ]
    q, r = np.array(turn), rotation(turn)
    entries = [
        body(
            names[k],
            shape,
            position=r @ np.array(x) + shift,
            velocity=r @ np.array(v),
            orientation={"quaternion": times(q, np.array(o) / np.linalg.norm(o))},
            angular_velocity=r @ np.array(w),
        )
        for k, (shape, x, v, o, w) in enumerate(what)
    ]
    return lab("".join(entries[k] for k in order), gravity=0.0, e=0.6, mu=0.3, timestep=timestep)


def motion(scene: Lab, names: str = "abc"):
    """Positions and velocities (3, 6) by name, in the order of `names`."""
    return np.array([[*scene.get("position", n), *scene.get("velocity", n)] for n in names])


def test_the_collision_happens():
    scene = collision().run(0.5)
    assert len(scene.events()["time"]) >= 2


@pytest.mark.parametrize("shift", [np.zeros(3), SHIFT])
@pytest.mark.parametrize("turn", [(1.0, 0, 0, 0), TURN])
def test_turning_and_shifting_the_scene_turns_and_shifts_what_happens(turn, shift):
    """Free impacts, gravity off. Measured 2e-13 m, what rounding grows to in half a second."""
    plain, moved = motion(collision().run(0.5)), motion(collision(turn, shift).run(0.5))
    r = rotation(turn)
    assert moved[:, :3] == pytest.approx(plain[:, :3] @ r.T + shift, abs=1e-9)
    assert moved[:, 3:] == pytest.approx(plain[:, 3:] @ r.T, abs=1e-9)


def test_names_do_not_matter():
    """To the last bit."""
    assert np.array_equal(motion(collision().run(0.5)), motion(collision(names="zyx").run(0.5), "zyx"))


@pytest.mark.parametrize("order", list(itertools.permutations(range(3)))[1:])
def test_the_order_of_bodies_does_not_matter(order):
    """Contacts turn round and sums are made in another order: rounding only, measured 1e-13."""
    plain, other = motion(collision().run(0.5)), motion(collision(order=order).run(0.5))
    assert other == pytest.approx(plain, abs=1e-9)


def test_galilei():
    """The same collision seen from a train: velocities differ by its own. Measured 1e-13."""
    u = np.array([1.5, -0.5, 0.25])
    pair = [("a", (0, 0, 0), (2, 0, 0)), ("b", (0.5, 0.1, 0), (0, 0, 0))]

    def meet(drift):
        bodies = "".join(
            body(n, "type: sphere, radius: 0.1", position=x, velocity=np.array(v) + drift) for n, x, v in pair
        )
        return lab(bodies, gravity=0.0, e=0.7, mu=0.2).run(0.4)

    rest, train = meet(np.zeros(3)), meet(u)
    assert train.all("velocity") == pytest.approx(rest.all("velocity") + u, abs=1e-9)
    assert train.all("angular_velocity") == pytest.approx(rest.all("angular_velocity"), abs=1e-8)


def heap() -> Lab:
    floor = "  floor: {fixed: true, shape: {type: halfspace}, material: stuff}\n"
    boxes = "".join(
        body(
            f"b{n}",
            "type: box, size: [0.1, 0.08, 0.06]",
            position=(0.02 * (n % 3), 0.015 * (n % 2), 0.1 + 0.12 * n),
            orientation={"euler_xyz": (0.3 * n, 0.2, 0.5)},
        )
        for n in range(8)
    )
    return lab(floor + boxes, e=0.4, mu=0.5)


def test_the_same_scene_gives_the_same_bits():
    first, second = heap().run(1.5), heap().run(1.5)
    for what, found in first.world.state().items():
        assert np.array_equal(found, second.world.state()[what])
    for what, found in first.world.contacts().items():
        assert np.array_equal(found, second.world.contacts()[what])


def test_how_the_steps_are_cut_does_not_matter():
    """One call or many, or saved and gone on from in another world: the same bits."""
    whole, cut, resumed = heap().step(900), heap(), heap()
    for _ in range(300):
        cut.step(3)
    resumed.world.restore(heap().step(421).world.save())
    resumed.step(900 - 421)
    for what, found in whole.world.state().items():
        assert np.array_equal(found, cut.world.state()[what])
        assert np.array_equal(found, resumed.world.state()[what])


def test_a_falling_body_is_the_same_anywhere_under_gravity():
    """Gravity has no place: turned about the vertical, the bounces are turned about the vertical."""
    quarter = (np.cos(0.3), 0.0, 0.0, np.sin(0.3))
    floor = "  floor: {fixed: true, shape: {type: halfspace}, material: stuff}\n"

    def thrown(turn):
        r = rotation(turn)
        box = body(
            "box",
            "type: box, size: [0.3, 0.2, 0.1]",
            position=r @ np.array([0.1, 0.2, 0.4]),
            velocity=r @ np.array([1.0, 0.5, 0]),
            orientation={"quaternion": times(np.array(turn), np.array([0.9, 0.3, 0.1, 0.2]) / 0.95**0.5)},
            angular_velocity=r @ np.array([3.0, 2.0, 1.0]),
        )
        return lab(floor + box, e=0.5, mu=0.4).run(0.6).get("position", "box")

    plain = thrown((1.0, 0, 0, 0))
    # measured 2e-14
    assert thrown(quarter) == pytest.approx(rotation(quarter) @ plain, abs=1e-8)

"""Nothing that can be asked ends the interpreter, hangs it, or depends on what was asked before."""

from __future__ import annotations

import subprocess
import sys
from itertools import combinations_with_replacement
from pathlib import Path

import numpy as np
import pytest
from collision_asking import Asker
from collision_shapes import THINGS, Floats, Thing, random_quaternion

import physsim

PACKAGE = Path(physsim.__file__).parent

ODD = {
    "needle": Thing("cylinder", (1e-3, 1.0)),
    "disc": Thing("cylinder", (1.0, 1e-4)),
    "pan": Thing("ellipsoid", (1.0, 1.0, 1e-3)),
    "pin": Thing("ellipsoid", (1e-3, 1e-3, 1.0)),
    "spike": Thing("cone", (1e-3, 2.0)),
    "round ellipsoid": Thing("ellipsoid", (0.5, 0.5, 0.5)),
    "slab": Thing("box", (20.0, 20.0, 0.05)),
    "dust": Thing("box", (1e-7, 1e-7, 1e-7)),
    "moon": Thing("sphere", (1e4,)),
}
EVERYTHING = THINGS | ODD


def aligned_pose(rng: np.random.Generator) -> Floats:
    """Poses where faces, edges and corners fall together, exactly or by a hair."""
    steps = np.array([0.0, 0.0, 0.0, 0.1, 0.2, 0.3, 0.5, 1.0, 1e-3, 1e-9, 1e-12])
    half = 0.5 * (rng.integers(0, 8) * np.pi / 4 + rng.choice([0.0, 0.0, 1e-12, 1e-6]))
    axis = np.eye(3)[rng.integers(0, 3)]
    return np.r_[rng.choice(steps, 3) * rng.choice([-1.0, 1.0], 3), np.cos(half), np.sin(half) * axis]


@pytest.mark.parametrize(
    ("a", "b"), [pair for pair in combinations_with_replacement(EVERYTHING, 2) if pair != ("halfspace",) * 2]
)
def test_aligned_poses_and_odd_shapes_get_an_answer(a: str, b: str) -> None:
    """Where FCL's signed distance aborts the process (touching boxes) or never ends (spheres in one
    place)."""
    ask = Asker([EVERYTHING[a], EVERYTHING[b]])
    rng = np.random.default_rng(21)
    for _ in range(12):
        answer = ask(0, aligned_pose(rng), 1, aligned_pose(rng), margin=1.0)
        if answer.found:
            assert np.linalg.norm(answer.normal) == pytest.approx(1.0, abs=1e-9)
            assert np.isfinite(answer.position).all()
            assert answer.depth >= -1.0


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e300])
@pytest.mark.parametrize("name", THINGS)
def test_wild_poses_are_not_found(name: str, value: float) -> None:
    ask = Asker([THINGS[name], THINGS["box"]])
    usual = np.array([0.0, 0.0, 0.1, 1.0, 0.0, 0.0, 0.0])
    for entry in range(7):
        wild = usual.copy()
        wild[entry] = value
        assert not ask(0, wild, 1, usual).found
        assert not ask(1, usual, 0, wild).found
    assert not ask(0, np.zeros(7), 1, usual).found
    assert not ask(0, usual, 1, usual, margin=np.nan).found


def test_an_answer_does_not_depend_on_earlier_questions() -> None:
    """Otherwise a resumed run, which has asked less, would part from one that ran through."""
    things = list(THINGS.values())
    rng = np.random.default_rng(22)
    poses = [np.r_[0.3 * rng.normal(size=3), random_quaternion(rng)] for _ in things]
    old, seen = Asker(things), []
    for a in range(len(things) - 1):
        for b in range(a + 1, len(things) - 1):
            seen.append((a, b, old(a, poses[a], b, poses[b])))
    for a, b, earlier in reversed(seen):
        for answer in (old(a, poses[a], b, poses[b]), Asker(things)(a, poses[a], b, poses[b])):
            assert answer.depth == earlier.depth
            assert (answer.normal == earlier.normal).all()
            assert (answer.position == earlier.position).all()


def test_many_questions_at_once_are_answered_as_one_by_one() -> None:
    things = [THINGS["cylinder"], THINGS["cone"]]
    ask = Asker(things)
    rng = np.random.default_rng(23)
    poses = np.array([np.r_[0.5 * rng.normal(size=3), random_quaternion(rng)] for _ in range(20)])
    a, b, none = (np.full(10, k, dtype=np.int32) for k in (0, 1, -1))
    found, normal, depth, position = ask.answers(a, b, none, none, poses[:10], poses[10:], np.full(10, 0.2))
    for i in range(10):
        single = ask(0, poses[i], 1, poses[10 + i], margin=0.2)
        assert (single.found, single.depth) == (found[i], depth[i])
        assert (single.normal == normal[i]).all()
        assert (single.position == position[i]).all()


def test_no_questions_no_answers() -> None:
    none = np.zeros(0, dtype=np.int32)
    found, normal, depth, position = Asker([THINGS["box"]]).answers(
        none, none, none, none, np.zeros((0, 7)), np.zeros((0, 7)), np.zeros(0)
    )
    assert (len(found), normal.shape, len(depth), position.shape) == (0, (0, 3), 0, (0, 3))


def test_fcl_is_imported_only_when_it_is_asked_for() -> None:
    code = "import sys, physsim.collision; assert 'fcl' not in sys.modules and 'numpy' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_one_file_imports_fcl() -> None:
    importers = [
        path.name for path in PACKAGE.rglob("*.py") if "import fcl" in path.read_text(encoding="utf-8")
    ]
    assert importers == ["fcl_solids.py"]


def test_the_package_has_nothing_else() -> None:
    with pytest.raises(AttributeError, match="no attribute 'FclQuestions'"):
        _ = physsim.collision.FclQuestions

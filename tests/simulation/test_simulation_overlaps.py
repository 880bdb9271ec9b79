"""Overlaps in the declared state: how deep is too deep, and where it is told."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import physsim
from physsim.model import compile_scene
from physsim.simulation import Overlap, find_overlaps, overlap_problems

Scene = Callable[..., Path]
TWO = """\
physsim: 1
simulation: {duration: 1 s, timestep: 1 ms}
bodies:
  left: {shape: {type: sphere, radius: R}, material: steel, position: [0, 0, 0]}
  right: {shape: {type: sphere, radius: R}, material: steel, position: [D, 0, 0]}
"""


def overlaps(scene: Scene, radius: float, distance: float) -> list[Overlap]:
    path = scene(("R}", f"{radius}}}"), ("[D,", f"[{distance},"), text=TWO)
    return find_overlaps(compile_scene(physsim.load(path)))


@pytest.mark.parametrize(
    ("radius", "depth", "told"),
    [(0.1, 1.1e-4, True), (0.1, 0.9e-4, False), (0.1, -1e-3, False), (1e-3, 9e-6, True), (1e-3, 7e-6, False)],
)
def test_told_beyond_a_tenth_of_a_millimetre_or_a_hundredth_of_the_size(
    scene: Scene, radius: float, depth: float, told: bool
) -> None:
    """The radius of gyration of a ball is sqrt(3/5) R: for R = 1 mm the limit is 7.7 um."""
    found = overlaps(scene, radius, 2 * radius - depth)
    assert bool(found) is told
    if told:
        assert {found[0].body_a, found[0].body_b} == {"left", "right"}
        assert found[0].depth == pytest.approx(depth, rel=1e-9)
        assert found[0].position[0] == pytest.approx(radius - depth / 2)


def test_one_line_for_each_pair_deepest_first(scene: Scene) -> None:
    """A brick has four contact points on the floor, and is told once."""
    path = scene(("[40 cm, 0, 35 mm]", "[40 cm, 0, 30 mm]"), ("[0, 0, 7 cm]", "[0, 0, 69 mm]"))
    found = find_overlaps(compile_scene(physsim.load(path)))
    assert [{overlap.body_a, overlap.body_b} for overlap in found] == [
        {"floor", "brick[0,0,0]"},
        {"brick[0,0,0]", "brick[0,0,1]"},
    ]
    assert [overlap.depth for overlap in found] == pytest.approx([5e-3, 1e-3], abs=1e-9)


def test_warnings_stand_at_the_body(scene: Scene) -> None:
    path = scene(("[40 cm, 0, 35 mm]", "[40 cm, 0, 30 mm]"))
    loaded = physsim.load(path)
    problem = overlap_problems(loaded, find_overlaps(compile_scene(loaded)))[0]
    assert problem.severity == "warning"
    assert problem.message == "overlaps floor by 0.005 m at the start"
    assert problem.source_line is not None
    assert "brick" in problem.source_line


def test_fcl_is_not_imported_without_need(scene: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "fcl", None)
    find_overlaps(compile_scene(physsim.load(scene())))

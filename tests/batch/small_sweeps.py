"""A small scene that bounces and collides, and sweeps of it."""

from __future__ import annotations

from typing import Any

from physsim.batch import SweepResult

DROP = """\
physsim: 1
title: A ball that bounces against a post
parameters: {drop: 30 cm, e: 0.6}
simulation: {duration: 400 ms, timestep: 1 ms}
pairs: [{between: [steel, concrete], restitution: "${e}", static_friction: 0.5, kinetic_friction: 0.4}]
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  post:
    fixed: true
    shape: {type: box, size: [10 cm, 1 m, 1 m]}
    material: concrete
    position: [30 cm, 0, 50 cm]
  ball:
    shape: {type: sphere, radius: 5 cm}
    material: steel
    position: [0, 0, "${drop}"]
    velocity: [1, 0, 0]
expect: [{quantity: bodies.ball.position.x, max: 10 cm}]
"""
METRICS = {
    "x": {"type": "final", "quantity": "bodies.ball.position.x"},
    "top": {"type": "max", "quantity": "bodies.ball.position.z", "from": "0.25 s"},
    "hit": {"type": "first_contact", "between": ["ball", "post"]},
    "hits": {"type": "impacts"},
    "lost": {"type": "energy_lost"},
    "share": {"type": "expression", "value": "top / drop"},
}
GRID = {"parameters.drop": {"type": "range", "from": "20 cm", "to": "1 m", "count": 5}}


def bits(result: SweepResult) -> list[tuple[Any, ...]]:
    """All cells but the wall time, in a form in which NaN equals NaN and -0.0 does not equal 0.0."""
    assert result.table.columns[-1].name == "wall_time"
    return [
        tuple(cell.hex() if isinstance(cell, float) else cell for cell in row[:-1])
        for row in result.table.rows
    ]

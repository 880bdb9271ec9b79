"""What is typed but not simulated yet is refused at its line."""

from __future__ import annotations

from collections.abc import Callable

from physsim.scene.not_yet import NOT_YET


def test_threads_are_refused_and_nothing_else_is(minimal: str, headlines: Callable[..., list[str]]) -> None:
    assert headlines(minimal, overrides=["simulation.threads=2"]) == [
        "--set simulation.threads=2: simulation.threads: not supported yet: more than one thread (allowed: 1)"
    ]
    works = ["simulation.integrator=rk4", "simulation.impacts=located", "world.gravitation=6.674e-11"]
    assert headlines(minimal, overrides=works) == []
    assert [row.path for row in NOT_YET] == [("simulation", "threads")]

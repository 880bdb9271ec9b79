"""Progress: facts and speed in words, a line every ten seconds in a pipe, a bar on a terminal only."""

from __future__ import annotations

from dataclasses import replace

import pytest

from physsim.cli import progress
from physsim.simulation import Progress

START = Progress(time=2.0, duration=10.0, step=2000, steps=10000, wall_time=0.5, contacts=0, status="running")


def test_speed_is_that_since_the_first_report_of_this_call() -> None:
    """A resumed run begins in the middle: 2 s that an earlier call simulated are no speed of this one."""
    speed = progress.Speed()
    assert speed.at(START) == 0
    assert speed.at(replace(START, time=5.0, wall_time=2.5)) == pytest.approx(1.5, rel=1e-12)


def test_a_pipe_gets_a_line_every_ten_seconds(capsys: pytest.CaptureFixture[str]) -> None:
    with progress.shown("Crates", quiet=False) as report:
        report(START)
        for second in range(1, 26):
            report(replace(START, time=2.0 + second / 5, wall_time=0.5 + second, contacts=12))
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.splitlines() == [
        "Crates: 4 of 10 s, 0.2x real time, 12 contacts, 30 s left",
        "Crates: 6 of 10 s, 0.2x real time, 12 contacts, 20 s left",
    ]


def test_a_short_run_is_silent_in_a_pipe_and_a_quiet_one_everywhere(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with progress.shown("Crates", quiet=False) as report:
        report(START)
    with progress.shown("Crates", quiet=True) as report:
        assert report is None
    assert capsys.readouterr().err == ""

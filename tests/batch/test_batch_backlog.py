"""Blocks: sizes that fit the runs, and what becomes of those over which a worker died."""

from __future__ import annotations

from physsim.batch.backlog import SECONDS_PER_BLOCK, Backlog
from physsim.batch.design import Run
from physsim.batch.workshop import CRASHED, Result


def backlog_of(count: int, slots: int = 2) -> Backlog:
    return Backlog((Run(number, 0, (), ()) for number in range(count)), count, slots)


def answered(block: tuple[Run, ...], seconds: float) -> list[Result]:
    return [Result(run.key, "complete", wall_time=seconds) for run in block]


def test_every_run_is_handed_out_once_in_blocks_of_about_half_a_second() -> None:
    backlog, sizes, numbers = backlog_of(2000), [], []
    while (block := backlog.take()) is not None:
        backlog.done(block, answered(block, 0.01))
        sizes.append(len(block))
        numbers += [run.number for run in block]
    assert numbers == list(range(2000))
    assert backlog.is_done
    assert sizes[0] == sizes[-1] == 1
    assert max(sizes) == SECONDS_PER_BLOCK / 0.01


def test_long_runs_go_one_by_one() -> None:
    backlog = backlog_of(10)
    while (block := backlog.take()) is not None:
        assert len(block) == 1
        backlog.done(block, answered(block, 3.0))


def test_a_large_cluster_gets_longer_blocks() -> None:
    backlog, sizes = backlog_of(100_000, slots=2000), []
    for _ in range(12):
        block = backlog.take()
        assert block is not None
        backlog.done(block, answered(block, 0.5))
        sizes.append(len(block))
    assert max(sizes) == 10


def test_a_block_that_was_lost_is_tried_run_by_run_and_the_culprit_given_up() -> None:
    lost = backlog_of(4, slots=1)
    first = lost.take()
    assert first is not None
    lost.done(first, answered(first, 0.1))
    block = lost.take()
    assert block is not None
    assert len(block) == 2
    assert lost.lost(block, "killed") == []
    seen = []
    while (single := lost.take()) is not None:
        seen.append([run.number for run in single])
        if single[0].number == 1:
            given_up = lost.lost(single, "killed by SIGKILL")
            if given_up:
                assert [(result.status, result.error) for result in given_up] == [
                    (CRASHED, "killed by SIGKILL")
                ]
        else:
            lost.done(single, answered(single, 9.0))
    assert seen[:3] == [[1], [2], [1]]
    assert sorted(number for numbers in seen for number in numbers) == [1, 1, 2, 3]
    assert lost.is_done

"""`open_trajectory`: by name, lazily, whole frames only."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import h5py
import made_up_run
import numpy as np
import pytest

from physsim.errors import FileTrouble
from physsim.recording import NotInFile, Trajectory, open_trajectory, series
from physsim.recording.create import block_frames, chunk_items, part_frames

FRAMES, BODIES = 40, 3


@pytest.fixture
def trajectory(recorded: Callable[..., Path]) -> Trajectory:
    with open_trajectory(recorded(frames=FRAMES, bodies=BODIES)) as opened:
        yield opened


@pytest.fixture
def everything() -> np.ndarray:
    return np.array([made_up_run.frame(k, BODIES)["position"] for k in range(FRAMES)])


KEYS = [
    5,
    -1,
    np.int64(4),
    slice(None),
    slice(3, 9),
    slice(None, None, 7),
    slice(30, 10, -3),
    slice(8, 8),
    slice(-5, None),
    (slice(2, 4), 2),
    (slice(None), slice(0, 2)),
    (3, 1),
    ...,
    [1, 5, 2],
    np.arange(FRAMES) % 2 == 0,
]


@pytest.mark.parametrize("key", KEYS, ids=str)
def test_a_slice_is_what_numpy_gives(trajectory: Trajectory, everything: np.ndarray, key: object) -> None:
    np.testing.assert_array_equal(trajectory.position[key], everything[key])
    np.testing.assert_array_equal(trajectory.body("ball[1,0,0]").position[key], everything[:, 2][key])


def test_past_the_end_is_an_index_error(trajectory: Trajectory) -> None:
    with pytest.raises(IndexError):
        trajectory.position[FRAMES]


def test_after_closing(recorded: Callable[..., Path]) -> None:
    with open_trajectory(recorded()) as trajectory:
        position = trajectory.position
    with pytest.raises(ValueError, match="the trajectory is closed"):
        position[0]


def test_a_slice_reads_only_what_it_needs(trajectory: Trajectory, monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []
    monkeypatch.setattr(series, "check_memory", lambda path, needed: asked.append(needed))
    trajectory.body("floor").velocity[10:12]
    assert asked == [2 * 3 * 8]


def test_what_is_larger_than_the_memory_is_refused(
    trajectory: Trajectory, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(series.os, "sysconf", lambda name: 10)
    with pytest.raises(FileTrouble, match="read it in slices"):
        trajectory.position[:]


def test_numpy_takes_a_series(trajectory: Trajectory, everything: np.ndarray) -> None:
    np.testing.assert_array_equal(np.asarray(trajectory.position), everything)
    assert len(trajectory.position) == FRAMES
    assert trajectory.position.units == "m"
    assert trajectory.body("floor").orientation.shape == (FRAMES, 4)


def test_one_body(trajectory: Trajectory) -> None:
    ball = trajectory.body("ball[0,0,0]")
    assert (ball.mass, ball.material, ball.fixed) == (2.0, "steel", False)
    np.testing.assert_array_equal(ball.inertia, 1.5 * np.eye(3))
    assert trajectory.body("floor").fixed


def test_a_body_that_is_not_there(trajectory: Trajectory) -> None:
    with pytest.raises(NotInFile, match="did you mean 'floor'"):
        trajectory.body("flor")


def test_contacts_of_a_frame(trajectory: Trajectory) -> None:
    for frame in (0, 1, 2, 38, -1):
        found = trajectory.contacts(frame)
        number = frame % FRAMES
        assert found.rows == number % 3
        assert set(found.frame) <= {number}
        assert set(found.body_a) <= {"ball[0,0,0]"}
        assert found.force.shape == (number % 3, 3)


def test_contacts_of_all_frames_follow_the_offsets(trajectory: Trajectory) -> None:
    everything = trajectory.contacts()
    np.testing.assert_array_equal(everything.frame, np.repeat(np.arange(FRAMES), np.arange(FRAMES) % 3))


def test_a_frame_past_the_end_has_no_contacts(trajectory: Trajectory) -> None:
    with pytest.raises(NotInFile, match="it has 40 frames"):
        trajectory.contacts(FRAMES)


def test_events_in_the_order_of_time(trajectory: Trajectory) -> None:
    np.testing.assert_allclose(trajectory.events.time, np.arange(3, FRAMES, 4) * 0.01, rtol=0, atol=1e-15)
    assert set(trajectory.events.body_b) == {"floor"}


def test_energy_momentum_solver_pairs(trajectory: Trajectory) -> None:
    np.testing.assert_array_equal(trajectory.energy.lost_impact, np.arange(FRAMES))
    assert trajectory.momentum["angular"].shape == (FRAMES, 3)
    assert trajectory.solver.iterations.dtype == np.int64
    assert list(trajectory.pairs.source) == ["library"]
    with pytest.raises(AttributeError, match="lost_friction"):
        _ = trajectory.energy.lost_to_friction


def test_attributes(trajectory: Trajectory) -> None:
    assert (trajectory.title, trajectory.seed, trajectory.status) == ("Made up", 7, "complete")
    assert trajectory.body_names == ("floor", "ball[0,0,0]", "ball[1,0,0]")
    assert trajectory.provenance["finished"] == "now"
    assert trajectory.frame_at(0.1049) == 10
    assert not trajectory.being_written


def test_frames_end_where_the_shortest_dataset_ends(recorded: Callable[..., Path]) -> None:
    path = recorded(frames=FRAMES)
    with h5py.File(path, "r+") as file:
        file["velocity"].resize(31, axis=0)
    with open_trajectory(path) as trajectory:
        assert trajectory.frames == 31
        assert trajectory.time[-1] == pytest.approx(0.3, abs=1e-15)
        assert trajectory.events.time[-1] <= 0.3
        assert set(trajectory.contacts().frame) <= set(range(31))


def test_frames_end_where_a_time_was_never_written(recorded: Callable[..., Path]) -> None:
    path = recorded(frames=FRAMES)
    with h5py.File(path, "r+") as file:
        for name in ("time", "position"):
            file[name].resize(FRAMES + 5, axis=0)
    with open_trajectory(path) as trajectory:
        assert trajectory.frames == FRAMES


def test_a_group_that_was_not_recorded_is_told(recorded: Callable[..., Path]) -> None:
    path = recorded()
    with h5py.File(path, "r+") as file:
        for group in ("energy", "contacts"):
            del file[group]
    with open_trajectory(path) as trajectory:
        with pytest.raises(NotInFile, match="energy"):
            _ = trajectory.energy
        with pytest.raises(NotInFile, match="contacts"):
            trajectory.contacts(0)
        assert trajectory.events.rows == FRAMES // 4


def test_a_part_stands_in_for_its_file(recorded: Callable[..., Path], tmp_path: Path) -> None:
    recorded().rename(tmp_path / "gone.h5.part")
    with open_trajectory(tmp_path / "gone.h5") as trajectory:
        assert trajectory.path.name == "gone.h5.part"


def test_reading_while_it_is_written(tmp_path: Path) -> None:
    recorder = made_up_run.start(tmp_path / "live.h5", BODIES)
    for number in range(10):
        made_up_run.feed(recorder, number, BODIES)
    recorder.write_block()
    recorder.settle()
    with open_trajectory(tmp_path / "live.h5") as trajectory:
        assert (trajectory.frames, trajectory.status, trajectory.being_written) == (10, "running", True)
        assert trajectory.position[9, 2, 1] == 9021.0
    recorder.finish("complete", "", None, 0, {})
    with open_trajectory(tmp_path / "live.h5") as trajectory:
        assert not trajectory.being_written


@pytest.mark.parametrize(
    ("bodies", "frames"), [(1, 1024), (10, 512), (64, 64), (1000, 64), (5000, 32), (30_000, 16)]
)
def test_chunks_hold_some_hundred_kilobytes(bodies: int, frames: int) -> None:
    """Measured for files of 1000 and of 10 bodies: fewer frames make one body slow, more make one frame
    slow.
    """
    assert block_frames(bodies) == frames
    assert frames * min(bodies, chunk_items(bodies)) * 4 * 8 <= 192 * 1024


@pytest.mark.parametrize(
    ("bodies", "frames"), [(1, 1024), (64, 64), (1000, 16), (5000, 2), (10_000, 1), (30_000, 1)]
)
def test_parts_hold_some_thousand_bodies(bodies: int, frames: int) -> None:
    assert part_frames(bodies) == frames
    assert block_frames(bodies) % frames == 0


def test_parts_count_when_they_end_a_chunk(tmp_path: Path) -> None:
    bodies = 1000
    part, block = part_frames(bodies), block_frames(bodies)
    recorder = made_up_run.start(tmp_path / "live.h5", bodies)
    made_up_run.feed(recorder, 0, bodies)
    recorder.write_block()
    for number in range(1, block + 3):
        made_up_run.feed(recorder, number, bodies)
        if recorder.room == 0:
            assert (number + 1) % part == 0
            recorder.write_part()
            recorder.settle()
            assert recorder.frames == (1 if number + 1 < block else block)
            with open_trajectory(tmp_path / "live.h5") as trajectory:
                assert trajectory.frames == recorder.frames
    with open_trajectory(recorder.finish("complete", "", None, 0, {})) as trajectory:
        assert trajectory.frames == block + 3
        np.testing.assert_array_equal(
            trajectory.position[:, 7, 2],
            [made_up_run.frame(k, bodies)["position"][7, 2] for k in range(block + 3)],
        )
        np.testing.assert_array_equal(
            trajectory.contacts().frame, np.repeat(np.arange(block + 3), np.arange(block + 3) % 3)
        )

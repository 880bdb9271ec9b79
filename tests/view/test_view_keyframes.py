"""Key frames: lines and arcs between them reproduce every sample, and few are kept where few are needed."""

from __future__ import annotations

from tempfile import TemporaryFile

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation, Slerp

from physsim.view.gltf import spool as spool_room
from physsim.view.gltf.keyframes import Keys, Thinner, in_one_hemisphere, shift, turn
from physsim.view.gltf.spool import Spool


def thinned(
    times: np.ndarray, values: np.ndarray, difference, *, tolerance: float, reach: float, block: int = 7
):
    """Of each row: which samples were kept, and their values."""
    rows = values.shape[1]
    thinner = Thinner(difference, np.full(rows, tolerance), np.full(rows, reach))
    parts = [slice(start, start + block) for start in range(0, len(times), block)]
    found = [key for part in parts for key in thinner.add(times[part], values[part])] + list(thinner.last())
    samples: list[list[int]] = [[] for _ in range(rows)]
    kept: list[list[np.ndarray]] = [[] for _ in range(rows)]
    for keys in found:
        for row, sample, value in zip(keys.rows, keys.samples, keys.values, strict=True):
            samples[row].append(int(sample))
            kept[row].append(value)
    return [(np.array(some), np.array(own)) for some, own in zip(samples, kept, strict=True)]


def walk(seed: int, frames: int, rows: int) -> tuple[np.ndarray, np.ndarray]:
    """Times at uneven steps, and positions that rest, fly and jump."""
    random = np.random.default_rng(seed)
    times = np.cumsum(random.uniform(0.001, 0.1, frames))
    accelerations = random.normal(size=(frames, rows, 3)) * random.choice(
        [0, 0, 0, 0.1, 10], (frames, rows, 1)
    )
    return times, np.cumsum(np.cumsum(accelerations, axis=0) * 0.01, axis=0)


@given(st.integers(0, 10**6), st.integers(1, 60), st.sampled_from([0.0, 1e-4, 1e-2, 1.0]), st.integers(1, 80))
def test_lines_pass_every_sample(seed: int, frames: int, tolerance: float, block: int) -> None:
    times, positions = walk(seed, frames, 3)
    for row, (samples, values) in enumerate(
        thinned(times, positions, shift, tolerance=tolerance, reach=np.inf, block=block)
    ):
        assert samples[0] == 0
        assert samples[-1] == frames - 1
        assert (np.diff(samples) > 0).all()
        np.testing.assert_array_equal(values, positions[samples, row])
        drawn = np.stack([np.interp(times, times[samples], values[:, axis]) for axis in range(3)], axis=1)
        errors = np.linalg.norm(drawn - positions[:, row], axis=1)
        assert errors.max() <= tolerance * (1 + 1e-9) + 1e-12  # measured: never above it


def spins(seed: int, frames: int, rows: int, step: float) -> tuple[np.ndarray, np.ndarray]:
    """Orientations w, x, y, z that turn by up to `step` [rad] from one to the next, with signs at random."""
    random = np.random.default_rng(seed)
    steps = random.normal(size=(frames, rows, 3)) * random.choice([0, 0.001, 1], (frames, rows, 1))
    steps *= step / np.maximum(np.linalg.norm(steps, axis=2, keepdims=True), step)
    turned = np.empty((frames, rows, 4))
    for row in range(rows):
        now = Rotation.identity()
        for frame in range(frames):
            now *= Rotation.from_rotvec(steps[frame, row])
            turned[frame, row] = now.as_quat(scalar_first=True) * random.choice([-1, 1])
    return np.arange(frames) * 0.01, turned


@given(st.integers(0, 10**6), st.sampled_from([0.0, 1e-3, 1e-2]), st.floats(0.01, 2.5))
def test_arcs_pass_every_sample(seed: int, tolerance: float, step: float) -> None:
    times, signed = spins(seed, 25, 2, step)
    orientations = in_one_hemisphere(signed, None)
    for row, (samples, values) in enumerate(
        thinned(times, orientations, turn, tolerance=tolerance, reach=0.4)
    ):
        true = Rotation.from_quat(orientations[:, row], scalar_first=True)
        kept = Rotation.from_quat(values, scalar_first=True)
        errors = (Slerp(times[samples], kept)(times).inv() * true).magnitude()
        assert errors.max() <= tolerance * (1 + 1e-6) + 1e-12  # rounding: measured 9e-16
        skipping = np.diff(samples) > 1
        turns = (kept[:-1].inv() * kept[1:]).magnitude()
        assert (turns[skipping] <= 0.4 + 1e-9).all()


def test_few_are_kept_where_few_are_needed() -> None:
    """A line: both ends. A body that waits, flies and waits: four. A spin: one every `reach`."""
    times = np.linspace(0, 10, 1001)
    line = times[:, None, None] * [[[1.0, 2, 3]]]
    assert len(thinned(times, line, shift, tolerance=1e-9, reach=np.inf)[0][0]) == 2
    flight = np.clip(times, 3, 5)[:, None, None] * [[[1.0, 2, 3]]]
    assert thinned(times, flight, shift, tolerance=1e-9, reach=np.inf)[0][0].tolist() == [0, 300, 500, 1000]
    half = times * 10 / 2  # 10 rad/s
    spin = np.stack([np.cos(half), 0 * half, np.sin(half) * 0.6, np.sin(half) * 0.8], axis=1)[:, None]
    samples, _ = thinned(times, spin, turn, tolerance=1e-9, reach=0.35)[0]
    assert np.diff(samples)[:-1].tolist() == [3] * 333  # 0.3 rad


@given(st.integers(0, 10**6), st.integers(1, 10))
def test_signs_of_neighbours_agree(seed: int, block: int) -> None:
    _, signed = spins(seed, 20, 3, 2.5)
    before, found = None, []
    for start in range(0, 20, block):
        found.append(in_one_hemisphere(signed[start : start + block], before))
        before = found[-1][-1]
    orientations = np.concatenate(found)
    assert (np.einsum("mri,mri->mr", orientations[1:], orientations[:-1]) >= 0).all()
    np.testing.assert_array_equal(np.abs(orientations), np.abs(signed))


def test_turns_are_rotation_vectors() -> None:
    random = np.random.default_rng(5)
    first = Rotation.random(200, rng=random)
    size = np.concatenate([np.zeros(20), np.geomspace(1e-12, 3.1, 180)])
    axes = random.normal(size=(200, 3))
    vectors = size[:, None] * axes / np.linalg.norm(axes, axis=1, keepdims=True)
    second = first * Rotation.from_rotvec(vectors)
    found = turn(first.as_quat(scalar_first=True), -second.as_quat(scalar_first=True))
    np.testing.assert_allclose(found, vectors, atol=2e-15)  # measured 4e-16


@pytest.mark.parametrize("spill", [1, 5, 10**6])
def test_the_spool_gives_back_what_it_was_given(spill: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(spool_room, "SPILL_ROWS", spill)
    random = np.random.default_rng(1)
    expected: list[list[tuple[int, list[float]]]] = [[] for _ in range(4)]
    with TemporaryFile() as file:
        spool = Spool(file, 4, 3)
        for sample in range(30):
            rows = np.flatnonzero(random.random(4) < [0.9, 0.1, 0.5, 0])
            values = random.normal(size=(len(rows), 3)).astype(np.float32).astype(float)
            spool.add(Keys(rows, np.full(len(rows), sample), values))
            for row, value in zip(rows, values, strict=True):
                expected[row].append((sample, value.tolist()))
        found = [
            list(zip(samples.tolist(), values.tolist(), strict=True)) for samples, values in spool.motions()
        ]
    assert found == expected
    assert spool.kept == sum(map(len, expected))

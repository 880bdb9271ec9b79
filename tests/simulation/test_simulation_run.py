"""`run`: what the file says against closed forms, and what becomes of the file when something is wrong."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from contents import differing

import physsim
from physsim.errors import ExpectationFailed, FileTrouble, Problem, RunFailed, SceneError
from physsim.recording import Block, NotInFile
from physsim.simulation import Progress
from physsim.simulation.loop import Schedule
from physsim.simulation.measure import Measure

Scene = Callable[..., Path]

SPINNING = """\
physsim: 1
simulation: {duration: 500 ms, timestep: 1 ms}
bodies:
  hammer:
    shape:
      type: compound
      parts:
        - {shape: {type: cylinder, radius: 1 cm, height: 30 cm}}
        - {shape: {type: box, size: [10 cm, 4 cm, 4 cm]}, position: [0, 0, 15 cm]}
    material: steel
    position: [1, 2, 3]
    velocity: [0.5, 0, 4]
    angular_velocity: [3, 5, 1]
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [5, 0, 1], velocity: [0, 1, 0]}
"""


def test_frames_at_multiples_and_at_the_end(scene: Scene, tmp_path: Path) -> None:
    with physsim.run(scene(), output=tmp_path / "run.h5", duration="123 ms") as trajectory:
        steps = [*range(0, 121, 10), 123]
        assert trajectory.step.tolist() == steps
        assert trajectory.time.tolist() == [step * 0.001 for step in steps]
        assert trajectory.status == "complete"


@pytest.mark.parametrize(
    ("steps_per_frame", "steps", "frames"),
    [(1, 3, [1, 2, 3]), (2, 5, [2, 4, 5]), (7, 3, [3]), (5, 10, [5, 10])],
)
def test_schedule(steps_per_frame: int, steps: int, frames: list[int]) -> None:
    schedule = Schedule(0.1, steps_per_frame, steps, until_rest=False)
    found, step = [], 0
    while step < steps:
        step += schedule.steps_to_frame(step, 1)
        assert schedule.has_frame(step)
        found.append(step)
    assert found == frames


def test_a_small_run_imports_nothing_heavy(scene: Scene, tmp_path: Path) -> None:
    """So that it steps at once."""
    script = (
        "import sys, physsim\n"
        "physsim.run(sys.argv[1], output=sys.argv[2]).close()\n"
        "heavy = {'trimesh', 'fcl', 'scipy', 'rich', 'jsonschema', 'pandas', 'xarray'}\n"
        "print(*sorted(heavy & set(sys.modules)))"
    )
    command = [sys.executable, "-c", script, str(scene()), str(tmp_path / "run.h5")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.strip() == ""


def test_frames_leave_the_engine_in_blocks(
    scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Not one by one: 60 frames fit in a chunk, so they come together, after frame 0 and before the end."""
    taken: list[int] = []
    take = Measure.take

    def counted(self: Measure, world: Any) -> Block:
        block = take(self, world)
        taken.append(block.frames)
        return block

    monkeypatch.setattr(Measure, "take", counted)
    with physsim.run(scene(), output=tmp_path / "run.h5") as trajectory:
        assert trajectory.frames == 61
    assert [count for count in taken if count] == [1, 60]


def test_frame_0_is_the_declared_state(scene: Scene, tmp_path: Path) -> None:
    with physsim.run(scene(), output=tmp_path / "run.h5", duration="10 ms") as trajectory:
        ball = trajectory.body("ball")
        assert ball.position[0].tolist() == [0, 0, 0.3]
        assert ball.orientation[0].tolist() == [1, 0, 0, 0]
        assert ball.velocity[0].tolist() == [1, 0, 0]
        np.testing.assert_allclose(ball.angular_velocity[0], [0, 3, 1], rtol=1e-15)
        assert trajectory.contacts(0).rows == 0
        assert trajectory.contacts(1).rows > 0


def test_positions_are_of_the_origin_and_velocities_of_the_centre(scene: Scene, tmp_path: Path) -> None:
    """In flight the centre of mass x + R c follows the parabola; semi-implicit Euler is off by g t dt / 2."""
    with physsim.run(scene(text=SPINNING), output=tmp_path / "run.h5") as trajectory:
        hammer, t = trajectory.body("hammer"), trajectory.time[:, None]
        offset = hammer.center_of_mass
        assert offset[2] > 0.05
        center = hammer.position[:] + rotated(hammer.orientation[:], offset)
        start, velocity, g = hammer.position[0] + offset, np.array([0.5, 0, 4]), np.array([0, 0, -9.81])
        np.testing.assert_allclose(center, start + velocity * t + g * t * (t + 1e-3) / 2, rtol=0, atol=1e-12)
        np.testing.assert_allclose(hammer.velocity[:], velocity + g * t, rtol=0, atol=1e-12)


def rotated(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Each q v q*, by the quaternion product: another route than the matrices of the code."""
    w, u = q[:, :1], q[:, 1:]
    t = 2 * np.cross(u, v)
    return v + w * t + np.cross(u, t)


def test_momentum_is_the_sum_over_moving_bodies(scene: Scene, tmp_path: Path) -> None:
    """P falls by m g t; L about the origin changes by the moment of gravity; both to rounding of 60 kg
    m2/s.
    """
    with physsim.run(scene(text=SPINNING), output=tmp_path / "run.h5") as trajectory:
        bodies = [trajectory.body(name) for name in trajectory.body_names]
        masses = np.array([body.mass for body in bodies])
        linear = np.einsum("b,tbk->tk", masses, trajectory.velocity[:])
        np.testing.assert_allclose(trajectory.momentum.linear, linear, rtol=0, atol=1e-11)
        weight = masses[:, None] * np.array([0, 0, -9.81])
        centers = trajectory.position[:] + np.stack(
            [rotated(body.orientation[:], body.center_of_mass) for body in bodies], axis=1
        )
        moment = np.cross(centers, weight).sum(axis=1)
        gained = np.diff(trajectory.momentum.angular, axis=0)
        # The moment is linear in time, so its mean over a frame is that of the ends, but semi-implicit Euler
        # takes it at the start of each step: half a step earlier.
        mean = (moment[1:] + moment[:-1]) / 2 - np.diff(moment, axis=0) / 20
        np.testing.assert_allclose(gained, 0.01 * mean, rtol=0, atol=1e-10)


def test_contact_forces_carry_the_weight(scene: Scene, tmp_path: Path) -> None:
    """Two bricks at rest: the floor carries both, the lower one carries the upper; to 0.1 %."""
    aside = ("velocity: [1, 0, 0]", "velocity: [-1, 0, 0]")
    with physsim.run(scene(aside), output=tmp_path / "run.h5") as trajectory:
        contacts = trajectory.contacts(-1)
        upper = trajectory.body("brick[0,0,1]").mass * 9.81
        carried = dict.fromkeys([("floor", "brick[0,0,0]"), ("brick[0,0,0]", "brick[0,0,1]")], 0.0)
        for a, b, force in zip(contacts.body_a, contacts.body_b, contacts.force, strict=True):
            for lower, higher in carried:
                if {a, b} == {lower, higher}:
                    carried[lower, higher] += force[2] if a == higher else -force[2]
        assert list(carried.values()) == pytest.approx([2 * upper, upper], rel=1e-3)
        np.testing.assert_allclose(contacts.force * 0.001, contacts.impulse, rtol=1e-15)
        along = np.einsum("ij,ij->i", contacts.impulse, contacts.normal)
        np.testing.assert_allclose(along, contacts.normal_impulse, rtol=1e-12)


def test_pairs_of_contacts_are_rows_of_the_table(scene: Scene, tmp_path: Path) -> None:
    with physsim.run(scene(), output=tmp_path / "run.h5") as trajectory:
        contacts, pairs = trajectory.contacts(), trajectory.pairs
        material = {name: trajectory.body(name).material for name in trajectory.body_names}
        for a, b, row in zip(contacts.body_a, contacts.body_b, contacts.pair, strict=True):
            assert {material[a], material[b]} == {pairs.material_a[row], pairs.material_b[row]}
        assert pairs.rows == 3
        assert all(pairs.source)


def test_events_match_the_bounce(scene: Scene, tmp_path: Path) -> None:
    """The ball falls 25 cm: first impact at sqrt(2 h / g) = 226 ms with 2.215 m/s, within one step."""
    with physsim.run(scene(), output=tmp_path / "run.h5") as trajectory:
        events = trajectory.events
        first = next(k for k in range(events.rows) if "ball" in {events.body_a[k], events.body_b[k]})
        assert events.time[first] == pytest.approx(0.2258, abs=1.1e-3)
        assert events.speed_before[first] == pytest.approx(2.2147, abs=0.02)
        measured = events.speed_after[first] / events.speed_before[first]
        assert measured == pytest.approx(events.restitution_declared[first], abs=1e-6)


def test_two_runs_differ_in_provenance_only(scene: Scene, tmp_path: Path) -> None:
    path = scene()
    for name in ("a.h5", "b.h5"):
        physsim.run(path, output=tmp_path / name).close()
    assert differing(tmp_path / "a.h5", tmp_path / "b.h5") == []


def test_provenance(scene: Scene, tmp_path: Path) -> None:
    path = scene()
    with physsim.run(path, set={"bodies.ball.mass": "2 kg"}, output=tmp_path / "run.h5") as trajectory:
        provenance = trajectory.provenance
        assert provenance["scene"] == path.read_text()
        assert "mass: 2.0" in provenance["scene_resolved"]
        assert json.loads(provenance["versions"])["physsim"] == physsim.__version__
        assert provenance["finished"] >= provenance["started"]
        assert trajectory.body("ball").mass == 2
        assert trajectory.title == "A ball and two bricks"


def test_default_output_is_in_the_current_folder(
    scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    path = scene()
    monkeypatch.chdir(elsewhere)
    with physsim.run(path, duration="10 ms") as trajectory:
        assert trajectory.path.resolve() == elsewhere / "scene.h5"


def test_a_loaded_scene_runs_as_it_is(scene: Scene, tmp_path: Path) -> None:
    loaded = physsim.load(scene(), {"simulation.duration": "20 ms"})
    with physsim.run(loaded, output=tmp_path / "run.h5") as trajectory:
        assert trajectory.time[-1] == 0.02
    with pytest.raises(TypeError, match="load the scene with these overrides"):
        physsim.run(loaded, duration="1 s", output=tmp_path / "other.h5")


def test_what_is_not_recorded_is_absent(scene: Scene, tmp_path: Path) -> None:
    nothing = ("record: {every: 10 ms}", "record: {every: 20 ms, contacts: false, energy: false}")
    with physsim.run(scene(nothing), output=tmp_path / "run.h5") as trajectory:
        assert trajectory.frames == 31
        with pytest.raises(NotInFile):
            trajectory.contacts(3)
        assert trajectory.events.rows > 0
    with h5py.File(tmp_path / "run.h5") as file:
        assert not {"contacts", "energy"} & set(file)


def test_until_at_rest(scene: Scene, tmp_path: Path) -> None:
    """The bricks lie still from the start: after a quarter of a second at rest the run ends, at a frame."""
    at_rest = ("timestep: 1 ms", "timestep: 1 ms, until: at_rest")
    no_ball = ("position: [0, 0, 30 cm]\n    velocity: [1, 0, 0]", "position: [0, 0, 5 cm]")
    no_spin = ("angular_velocity: [0, 3, 1]", "angular_velocity: [0, 0, 0]")
    with physsim.run(scene(at_rest, no_ball, no_spin), output=tmp_path / "run.h5") as trajectory:
        assert trajectory.status == "complete"
        assert trajectory.status_detail.startswith("at rest at")
        assert 0.25 <= trajectory.time[-1] < 0.6
        assert trajectory.step[-1] % 10 == 0


def test_progress(scene: Scene, tmp_path: Path) -> None:
    reports: list[Progress] = []
    physsim.run(scene(), output=tmp_path / "run.h5", progress=reports.append).close()
    assert [report.step for report in reports] == sorted({report.step for report in reports})
    last = reports[-1]
    assert (last.step, last.steps, last.status, last.duration) == (600, 600, "complete", 0.6)
    assert last.time == 0.6
    assert last.contacts > 0


def test_progress_is_told_ten_times_a_second_at_most(
    scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = iter(np.arange(0, 1e4, 0.03))
    monkeypatch.setattr("physsim.simulation.progress.time.monotonic", lambda: next(clock))
    reports: list[Progress] = []
    physsim.run(scene(), output=tmp_path / "run.h5", progress=reports.append).close()
    assert len(reports) > 3
    assert all(later.wall_time - report.wall_time > 0.1 for report, later in pairwise(reports[:-1]))


def test_an_invalid_scene_leaves_an_old_file_alone(scene: Scene, tmp_path: Path) -> None:
    output = tmp_path / "run.h5"
    physsim.run(scene(), output=output, duration="10 ms").close()
    before = output.read_bytes()
    with pytest.raises(SceneError):
        physsim.run(scene(("radius: 5 cm", "radius: -5 cm")), output=output, force=True)
    with pytest.raises(FileTrouble, match="exists already"):
        physsim.run(scene(), output=output)
    assert output.read_bytes() == before


def test_force_replaces(scene: Scene, tmp_path: Path) -> None:
    output = tmp_path / "run.h5"
    physsim.run(scene(), output=output, duration="10 ms").close()
    with physsim.run(scene(), output=output, duration="20 ms", force=True) as trajectory:
        assert trajectory.frames == 3
    assert {path.name for path in tmp_path.iterdir()} == {"scene.yaml", "run.h5"}


def test_a_blow_up_is_told_with_body_and_time(scene: Scene, tmp_path: Path) -> None:
    """Gravity of 1e9 m/s2 takes the ball past every speed that can be meant; the frames before are kept."""
    wild = ("bodies:", "world: {gravity: [0, 0, 1.0e+9]}\nbodies:")
    output = tmp_path / "run.h5"
    with pytest.raises(RunFailed, match=r"bodies\.\S+: its motion blew up at [\d.]+ s .* is in .*run.h5"):
        physsim.run(scene(wild), output=output)
    with physsim.open_trajectory(output) as trajectory:
        assert trajectory.status == "failed"
        assert "blew up" in trajectory.status_detail
        assert np.isfinite(trajectory.position[:]).all()


def test_an_error_in_the_callers_own_code_passes_through(scene: Scene, tmp_path: Path) -> None:
    def faulty(progress: Progress) -> None:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        physsim.run(scene(), output=tmp_path / "run.h5", progress=faulty)
    with physsim.open_trajectory(tmp_path / "run.h5") as trajectory:
        assert trajectory.status == "failed"
        assert "ZeroDivisionError" in trajectory.status_detail


def test_warnings_reach_the_caller(scene: Scene, tmp_path: Path) -> None:
    problems: list[Problem] = []
    sunk = ("position: [40 cm, 0, 35 mm]", "position: [40 cm, 0, 30 mm]")
    physsim.run(scene(sunk), output=tmp_path / "run.h5", duration="10 ms", warn=problems.append).close()
    assert any("overlaps floor by 0.005 m" in problem.message for problem in problems)


def test_check_raises_and_keeps_the_file(scene: Scene, tmp_path: Path) -> None:
    expect = (
        "record:",
        "expect: [{quantity: bodies.ball.position.z, at: 0 s, value: 1, within: 1 mm}]\nrecord:",
    )
    path = scene(expect)
    with pytest.raises(
        ExpectationFailed, match=r"bodies.ball.position.z at 0 s: wanted 1 within 0.001, got 0.3 m"
    ):
        physsim.run(path, output=tmp_path / "run.h5", check=True)
    assert (tmp_path / "run.h5").exists()
    physsim.run(path, output=tmp_path / "unchecked.h5").close()


def test_handlers_are_restored_and_threads_can_run(scene: Scene, tmp_path: Path) -> None:
    """Python sets signal handlers in the main thread only; a run elsewhere does without."""
    before = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)]
    path, done = scene(), []

    def elsewhere() -> None:
        with physsim.run(path, output=tmp_path / "thread.h5", duration="50 ms") as trajectory:
            done.append(trajectory.status)

    thread = threading.Thread(target=elsewhere)
    thread.start()
    thread.join()
    physsim.run(path, output=tmp_path / "main.h5", duration="50 ms").close()
    assert done == ["complete"]
    assert [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)] == before
    assert differing(tmp_path / "thread.h5", tmp_path / "main.h5") == []

"""`physsim plot`: what is drawn, with which labels, and which files come of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pandas
import pytest
from matplotlib.figure import Figure

import physsim
from physsim.analysis.plot import draw_table, draw_trajectories, read_table, read_wishes, units_beside
from physsim.analysis.plot.ledger import stack
from physsim.analysis.plot.tables import means
from physsim.cli.app import answer
from physsim.recording import NotInFile, Trajectory

SCENE = """
physsim: 1
title: A box slides, a pendulum swings on a spring
simulation: {duration: 400 ms, timestep: 1 ms, integrator: velocity_verlet}
pairs: [{between: [steel, concrete], restitution: 0.3, static_friction: 0.4, kinetic_friction: 0.3}]
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  box: {shape: {type: box, size: [20 cm, 20 cm, 10 cm]}, material: steel, position: [0, 0, 6 cm],
        velocity: [1, 0, 0]}
  bob: {shape: {type: sphere, radius: 5 cm}, mass: 1, collides: false, position: [3, 0, 1]}
springs:
  tether: {type: linear, between: [world, bob], anchors: [[3, 1, 1], [0, 0, 0]], stiffness: 50, damping: 1}
joints: {arm: {type: hinge, between: [world, bob], anchor: [2.5, 0, 1], axis: [0, 1, 0]}}
forces: {push: {body: bob, force: [0, 0, 3]}}
record: {every: 5 ms}
"""
Draw = Callable[..., list]


@pytest.fixture(scope="module")
def run_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("plot")
    (folder / "scene.yaml").write_text(SCENE)
    physsim.run(folder / "scene.yaml", output=folder / "run.h5").close()
    physsim.run(
        folder / "scene.yaml", output=folder / "slow.h5", set={"bodies.box.velocity": [0.5, 0, 0]}
    ).close()
    return folder / "run.h5"


@pytest.fixture
def trajectory(run_file: Path) -> Iterator[Trajectory]:
    with physsim.open_trajectory(run_file) as opened:
        yield opened


def drawn(trajectories: list[Trajectory], *words: str, frames: slice = slice(None)) -> list:
    figure = Figure()
    draw_trajectories(figure, trajectories, read_wishes(words), [frames] * len(trajectories))
    return figure.axes


def test_curves_hold_the_recorded_numbers(trajectory: Trajectory) -> None:
    (axes,) = drawn([trajectory], "bodies.box.position.x")
    (line,) = axes.lines
    np.testing.assert_array_equal(line.get_xdata(), trajectory.time)
    np.testing.assert_array_equal(line.get_ydata(), trajectory.body("box").position[:, 0])
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("time [s]", "box position x [m]")


@pytest.mark.parametrize(
    ("word", "label", "curves"),
    [
        ("bodies.box.velocity", "box velocity [m/s]", 3),
        ("bodies.*.speed", "speed [m/s]", 3),
        ("bodies.b*.kinetic_energy", "kinetic energy [J]", 2),
        ("bodies.box.contact_force.z", "box contact force z [N]", 1),
        ("bodies.box.momentum.x", "box momentum x [kg·m/s]", 1),
        ("joints.arm.coordinate", "arm coordinate [rad]", 1),
        ("joints.*.reaction", "arm reaction [N]", 1),
        ("springs.tether.force", "tether force [N]", 1),
        ("contacts.count", "count", 1),
        ("momentum.angular.y", "angular y [kg·m²/s]", 1),
    ],
)
def test_labels_have_units(trajectory: Trajectory, word: str, label: str, curves: int) -> None:
    (axes,) = drawn([trajectory], word)
    assert axes.get_ylabel() == label
    assert len(axes.lines) == curves


def test_equal_units_share_a_panel(trajectory: Trajectory) -> None:
    panels = drawn([trajectory], "bodies.box.position.x", "springs.tether.length", "bodies.box.speed")
    assert [axes.get_ylabel() for axes in panels] == ["length [m]", "box speed [m/s]"]
    assert [text.get_text() for text in panels[0].get_legend().texts] == ["box position x", "tether length"]


def test_phase_portrait(trajectory: Trajectory) -> None:
    for words in (
        ["joints.arm.coordinate vs bodies.bob.speed"],
        ["joints.arm.coordinate", "vs", "bodies.bob.speed"],
    ):
        (axes,) = drawn([trajectory], *words, frames=slice(10, 30))
        assert (axes.get_xlabel(), axes.get_ylabel()) == ("bob speed [m/s]", "arm coordinate [rad]")
        np.testing.assert_array_equal(axes.lines[0].get_ydata(), trajectory.joint("arm").coordinate[10:30])
        np.testing.assert_array_equal(
            axes.lines[0].get_xdata(), trajectory.quantity("bodies.bob.speed")[10:30]
        )


def test_several_files_overlaid(trajectory: Trajectory, run_file: Path) -> None:
    with physsim.open_trajectory(run_file.with_name("slow.h5")) as slow:
        (axes,) = drawn([trajectory, slow], "bodies.box.position.x", "bodies.bob.position.x")
        assert [line.get_linestyle() for line in axes.lines] == ["-", "--"] * 2
        assert [line.get_color() for line in axes.lines] == ["C0", "C0", "C1", "C1"]
        told = [text.get_text() for text in axes.get_legend().texts]
        assert told[:2] == ["run: box position x", "slow: box position x"]
        assert len(drawn([trajectory, slow], "energy")) == 2


def test_the_ledger_adds_up(trajectory: Trajectory) -> None:
    """Layers are not negative, and their sum differs from what was there by the residual alone."""
    layers, supplied = stack(trajectory, slice(None))
    assert set(layers) >= {
        "kinetic_translational",
        "gravitational",
        "spring",
        "lost_friction",
        "lost_damping",
    }
    assert all(layer.min() > -1e-9 for layer in layers.values())
    np.testing.assert_allclose(
        sum(layers.values()) - supplied, trajectory.energy.residual, rtol=0, atol=1e-12
    )
    (axes,) = drawn([trajectory], "energy")
    assert axes.get_ylabel() == "energy [J]"
    assert len(axes.collections) == len(layers)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["bodies.bx.speed"], "did you mean 'bob'|did you mean 'box'"),
        (["bodies.c*.speed"], "nothing fits"),
        (["bodies.box.position", "vs", "time"], r"vs needs one number on each side \(one of"),
        (["bodies.box.speed", "vs"], "one quantity on each side"),
        (["vs"], "one quantity on each side"),
        (["time vs time vs time"], "one quantity on each side"),
        (["bodies.*.speed vs time"], "one number on each side"),
    ],
)
def test_what_cannot_be_drawn(trajectory: Trajectory, words: list[str], told: str) -> None:
    with pytest.raises(NotInFile, match=told):
        drawn([trajectory], *words)


def grid() -> pandas.DataFrame:
    angle, speed, seed = (
        part.ravel() for part in np.meshgrid([10.0, 20, 30], [1.0, 2], [0, 1], indexing="ij")
    )
    reach = angle * speed + seed
    return pandas.DataFrame({"angle": angle, "speed": speed, "reach": reach, "status": "complete"})


def test_a_metric_over_a_parameter() -> None:
    figure = Figure()
    draw_table(figure, grid(), ["reach", "angle"])
    (axes,) = figure.axes
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("angle", "reach")
    x, mean, spread = means(np.array([1.0, 1, 2]), np.array([3.0, 5, 7]))
    assert (x.tolist(), mean.tolist()) == ([1, 2], [4, 7])
    np.testing.assert_allclose(spread, [np.std([3, 5], ddof=1), 0])


def test_a_metric_over_two_parameters_is_a_map() -> None:
    figure = Figure()
    draw_table(figure, grid(), ["reach", "angle", "speed"])
    mesh = figure.axes[0].collections[0]
    np.testing.assert_array_equal(np.asarray(mesh.get_array()), [[10.5, 20.5, 30.5], [20.5, 40.5, 60.5]])
    assert [axes.get_ylabel() for axes in figure.axes] == ["speed", "reach"]


def test_units_of_a_sweep(tmp_path: Path) -> None:
    """Real sweep, real table: its manifest says what the columns measure."""
    (tmp_path / "scene.yaml").write_text(SCENE)
    result = physsim.sweep(
        {
            "physsim_sweep": 1,
            "scene": str(tmp_path / "scene.yaml"),
            "set": {"simulation.duration": "20 ms"},
            "grid": {"bodies.box.velocity[0]": ["1 m/s", "2 m/s"]},
            "metrics": {"reach": {"type": "final", "quantity": "bodies.box.position.x"}},
        },
        output=tmp_path / "sweep",
        workers=1,
    )
    table = next(path for path in result.files if path.suffix == ".csv")
    figure = Figure()
    draw_table(figure, read_table(table), ["reach", "bodies.box.velocity[0]"], units_beside(table))
    (axes,) = figure.axes
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("bodies.box.velocity[0] [m/s]", "reach [m]")
    picture = tmp_path / "sweep.png"
    assert answer(["plot", str(table), "reach vs bodies.box.velocity[0]", "-o", str(picture)]) == 0


def test_points_that_fill_no_grid_are_points() -> None:
    figure = Figure()
    draw_table(figure, grid().iloc[:-3], ["reach", "angle", "speed"])
    assert len(figure.axes[0].collections[0].get_offsets()) == 9


@pytest.mark.parametrize(
    ("columns", "told"),
    [
        (["reach", "angel"], "did you mean 'angle'"),
        (["reach", "status"], "does not hold numbers"),
        (["reach"], "METRIC vs"),
    ],
)
def test_what_a_table_does_not_have(columns: list[str], told: str) -> None:
    with pytest.raises(NotInFile, match=told):
        draw_table(Figure(), grid(), columns)


@pytest.mark.parametrize("suffix", [".png", ".svg", ".pdf"])
def test_files(run_file: Path, tmp_path: Path, suffix: str, capsys: pytest.CaptureFixture[str]) -> None:
    heads = {".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF"}
    pictures = [tmp_path / f"{name}{suffix}" for name in "ab"]
    for picture in pictures:
        told = ["energy", "bodies.box.speed", "--from", "0.1", "--until", "0.3", "--title", "Both"]
        assert answer(["plot", str(run_file), *told, "-o", str(picture)]) == 0
        assert capsys.readouterr().out.strip() == str(picture)
    assert pictures[0].read_bytes().startswith(heads[suffix])
    assert pictures[0].read_bytes() == pictures[1].read_bytes()


def test_tables_by_the_command(tmp_path: Path) -> None:
    grid().to_csv(tmp_path / "sweep.csv", index=False)
    for words in (["reach vs angle"], ["reach", "vs", "angle", "speed"], ["reach", "angle"]):
        assert answer(["plot", str(tmp_path / "sweep.csv"), *words, "-o", str(tmp_path / "map.png")]) == 0


@pytest.fixture
def in_folder(run_file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The trajectory, from an empty folder without a display."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "agg")
    return run_file


@pytest.mark.parametrize(
    ("arguments", "code", "told"),
    [
        (["none.h5", "energy", "-o", "a.png"], 3, "none.h5: no such file"),
        (["none.csv", "a", "b", "-o", "a.png"], 3, "none.csv: there is no such file"),
        (["RUN", "-o", "a.png"], 2, "name what to draw"),
        (["energy", "-o", "a.png"], 2, "name a trajectory"),
        (["RUN", "energy", "-o", "a.bmp"], 3, "must end in .png, .svg, .pdf"),
        (["RUN", "energy", "-o", "nowhere/a.png"], 3, "nowhere/a.png: cannot be written"),
        (["RUN", "bodies.bx.speed", "-o", "a.png"], 2, "did you mean"),
        (["RUN", "energy", "--from", "9", "-o", "a.png"], 3, "no frames in that span"),
        (["RUN", "energy"], 3, "there is no display"),
    ],
)
def test_trouble(
    in_folder: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], code: int, told: str
) -> None:
    assert answer(["plot", *(str(in_folder) if word == "RUN" else word for word in arguments)]) == code
    assert told in capsys.readouterr().err
    assert not Path("a.png").exists()

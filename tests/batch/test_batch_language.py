"""The sweep language: one mistake per case, its words and its place; and what is allowed."""

from __future__ import annotations

from pathlib import Path

import pytest
from small_sweeps import DROP

from physsim.batch import load_sweep
from physsim.errors import SceneError
from physsim.scene import format_problem

HEAD = """\
physsim_sweep: 1
scene: drop.yaml
metrics: {x: {type: final, quantity: bodies.ball.position.x}}
"""
MISTAKES = {
    "misspelt key": (
        HEAD + "gird: {parameters.drop: [1, 2]}\n",
        "4:1: gird: unknown key; did you mean 'grid'?",
    ),
    "scene that is not there": (
        HEAD.replace("drop.yaml", "dorp.yaml"),
        "2:8: scene: there is no such file; did you mean 'drop.yaml'?, got dorp.yaml",
    ),
    "unknown body in a path": (
        HEAD + "grid: {bodies.bal.mass: [1 kg, 2 kg]}\n",
        "4:8: grid.bodies.bal.mass: there is no 'bal' in bodies; did you mean 'ball'?",
    ),
    "unknown key in a path": (
        HEAD + "grid:\n  bodies.ball.masss: [1 kg]\n",
        "5:3: grid.bodies.ball.masss: bodies.ball.masss: unknown key; did you mean 'mass'?",
    ),
    "parameter that the scene does not have": (
        HEAD + "zip: {parameters.dorp: [1 m]}\n",
        "4:7: zip.parameters.dorp: the scene has no parameter 'dorp'; did you mean 'drop'?",
    ),
    "values of the wrong dimension": (
        HEAD + "grid: {bodies.ball.mass: [1 m, 2 m]}\n",
        "4:26: grid.bodies.ball.mass: bodies.ball.mass: must be a mass, not a value in m, got 1 m",
    ),
    "range of two dimensions": (
        HEAD + "grid: {parameters.drop: {type: range, from: 1 m, to: 1 kg, count: 3}}\n",
        "4:8: grid.parameters.drop: start and stop must be of one dimension",
    ),
    "log range through zero": (
        HEAD + "grid: {parameters.drop: {type: log_range, from: 0 m, to: 1 m, count: 3}}\n",
        "4:8: grid.parameters.drop: both ends of a log_range must be of one sign and not 0",
    ),
    "unknown kind of axis": (
        HEAD + "grid: {parameters.drop: {type: rang, from: 0 m, to: 1 m, count: 3}}\n",
        "4:32: grid.parameters.drop.type: unknown type, got rang; did you mean 'range'?",
    ),
    "pairs of unequal length": (
        HEAD + "zip: {parameters.drop: [1 m, 2 m], parameters.e: [0.5]}\n",
        "4:36: zip.parameters.e: has 1 values, the first of zip has 2",
    ),
    "path that varies twice": (
        HEAD + "grid: {parameters.e: [0.5]}\nzip: {parameters.e: [0.5]}\n",
        "5:7: zip.parameters.e: is set by another part of the sweep already",
    ),
    "seed beside replicates": (
        HEAD + "grid: {simulation.seed: [1, 2]}\nreplicates: 2\n",
        "4:8: grid.simulation.seed: is set by replicates already",
    ),
    "negative deviation": (
        HEAD + "sample: {count: 2, values: {parameters.e: {type: normal, mean: 1, deviation: -1}}}\n",
        "4:78: sample.values.parameters.e.deviation: must be greater than 0, got -1",
    ),
    "metric of an unknown body": (
        HEAD.replace("ball.", "bal."),
        "3:38: metrics.x.quantity: there is no body 'bal', got bodies.bal.position.x; did you mean 'ball'?",
    ),
    "metric of a vector": (
        HEAD.replace("position.x", "position"),
        "3:38: metrics.x.quantity: names a vector, an expectation needs one number",
    ),
    "metric that takes a column's name": (
        HEAD.replace("{x:", "{status:"),
        "3:11: metrics.status: the name 'status' is that of a column which every table has",
    ),
    "contact with nobody": (
        HEAD.replace(
            "{type: final, quantity: bodies.ball.position.x}", "{type: impacts, between: [bll, '*']}"
        ),
        "3:40: metrics.x.between[0]: fits no body, got bll; did you mean 'ball'?",
    ),
    "expression of an unknown name": (
        HEAD.replace("{type: final, quantity: bodies.ball.position.x}", "{type: expression, value: tpo / 2}"),
        "3:40: metrics.x.value: uses 'tpo', which is no metric above this one and no parameter",
    ),
    "nothing to keep": (
        "physsim_sweep: 1\nscene: drop.yaml\n",
        "1:1: nothing is kept of any run; give metrics, or keep: all",
    ),
    "gathering what is not kept": (
        HEAD + "gather: true\n",
        "4:9: gather: needs keep: all, got true",
    ),
    "shared change that cannot be": (
        HEAD + "set: {simulation.duration: 2 kg}\n",
        "4:28: set.simulation.duration: must be a time, not a value in kg, got 2 kg",
    ),
    "too many runs": (
        HEAD + "replicates: 1000000\ngrid: {parameters.e: [0.1, 0.2]}\n",
        "1:1: asks for 2000000 runs, the most is 1000000",
    ),
    "another version": (
        HEAD.replace("sweep: 1", "sweep: 2"),
        "1:16: physsim_sweep: is a version of the sweep language that is not known, got 2",
    ),
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "drop.yaml").write_text(DROP)
    return tmp_path


def told(path: Path) -> list[str]:
    """What is wrong with a sweep, as people read it, without the name of the file."""
    with pytest.raises(SceneError) as caught:
        load_sweep(path)
    texts = [format_problem(problem, caught.value.file) for problem in caught.value.problems]
    return [text.removeprefix(f"{path}:") for text in texts]


@pytest.mark.parametrize("name", MISTAKES)
def test_mistake_is_told_with_its_place(folder: Path, name: str) -> None:
    text, wanted = MISTAKES[name]
    path = folder / "trial.yaml"
    path.write_text(text)
    found = told(path)
    assert len(found) == 1, found
    assert found[0].replace(f" in {folder}", "").startswith(wanted), found[0]


def test_all_mistakes_at_once_in_the_order_of_the_file(folder: Path) -> None:
    path = folder / "trial.yaml"
    path.write_text(HEAD + "keep: al\nsample: {count: 0, values: {}}\ngird: 1\n")
    assert [text.partition(": ")[0] for text in told(path)] == ["4:7", "5:17", "5:20", "6:1"]


def test_a_scene_that_is_wrong_is_told_as_such(folder: Path) -> None:
    (folder / "drop.yaml").write_text(DROP.replace("radius: 5 cm", "radius: -5 cm"))
    (folder / "trial.yaml").write_text(HEAD)
    with pytest.raises(SceneError) as caught:
        load_sweep(folder / "trial.yaml")
    assert caught.value.file == str(folder / "drop.yaml")


def test_sobol_points_that_are_no_power_of_two_are_warned_of(folder: Path) -> None:
    path = folder / "trial.yaml"
    path.write_text(
        HEAD + "sample: {method: sobol, count: 6, values: {parameters.e: {type: uniform, from: 0, to: 1}}}\n"
    )
    (warning,) = load_sweep(path).warnings
    assert (warning.line, warning.column, warning.severity) == (4, 32, "warning")
    assert "4 or 8" in warning.message


def test_a_value_that_the_scene_refuses_is_no_mistake_of_the_sweep(folder: Path) -> None:
    path = folder / "trial.yaml"
    path.write_text(HEAD + "grid: {bodies.ball.mass: [-1 kg, 1 kg]}\n")
    assert len(load_sweep(path).design) == 2


def test_a_dictionary_is_a_sweep(folder: Path) -> None:
    content = {
        "physsim_sweep": 1,
        "scene": str(folder / "drop.yaml"),
        "grid": {"parameters.e": [0.5]},
        "keep": "all",
    }
    assert len(load_sweep(content).design) == 1

"""`physsim fit` finds the values that noisy data of closed forms were made with, within its own errors."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

import h5py
import numpy as np
import pytest
import yaml
from jsonschema import Draft202012Validator
from scipy.optimize import least_squares

import physsim
from physsim.batch.fit import cost_of, search
from physsim.batch.fit_load import load_fit
from physsim.batch.fit_result import Found
from physsim.batch.fit_schema import schema_text
from physsim.cli.app import answer
from physsim.errors import RunFailed, SceneError

GRAVITY = 9.81
BOUNCE = """
physsim: 1
parameters: {e: 0.8, drop: 1 m}
simulation: {duration: 1.6 s, timestep: 2 ms, impacts: located, integrator: velocity_verlet}
pairs: [{between: [rubber, concrete], restitution: "${e}"}]
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  ball: {shape: {type: sphere, radius: 3 cm}, material: rubber, position: [0, 0, "${drop + 3 cm}"]}
"""
OSCILLATOR = """
physsim: 1
parameters: {pull: 10 cm}
world: {gravity: [0, 0, 0]}
simulation: {duration: 2 s, timestep: 2 ms, integrator: rk4}
bodies:
  mass: {shape: {type: sphere, radius: 5 cm}, mass: 2, collides: false, position: ["${1 m + pull}", 0, 0]}
springs:
  coil: {type: linear, between: [world, mass], anchors: [[0, 0, 0], [0, 0, 0]], rest_length: 1,
         stiffness: 100, damping: 1}
"""
COARSE = OSCILLATOR.replace("2 ms", "20 ms")
FLIGHT = """
physsim: 1
simulation: {duration: 1 s, timestep: 5 ms, integrator: rk4}
bodies: {stone: {shape: {type: sphere, radius: 1 cm}, mass: 1, collides: false}}
"""


def height(t: np.ndarray, e: float, drop: float) -> np.ndarray:
    """Of the lowest point of a ball that falls from `drop` and bounces with restitution e."""
    found = np.empty_like(t)
    for k, moment in enumerate(t):
        fall = np.sqrt(2 * drop / GRAVITY)
        left, speed = moment - fall, e * GRAVITY * fall
        while left > 2 * speed / GRAVITY:
            left, speed = left - 2 * speed / GRAVITY, speed * e
        found[k] = drop - GRAVITY * moment**2 / 2 if moment < fall else speed * left - GRAVITY * left**2 / 2
    return found


def swing(t: np.ndarray, k: float, c: float, pull: float, m: float = 2.0) -> np.ndarray:
    """Damped oscillation from rest at `pull`."""
    decay = c / (2 * m)
    w = np.sqrt(k / m - decay**2)
    return pull * np.exp(-decay * t) * (np.cos(w * t) + decay / w * np.sin(w * t))


def csv(path: Path, **columns: np.ndarray) -> None:
    rows = zip(*columns.values(), strict=True)
    path.write_text(
        "\n".join([",".join(columns), *(",".join(map(repr, map(float, row))) for row in rows)]) + "\n"
    )


def fit_file(folder: Path, scene: str, **content: object) -> Path:
    (folder / "scene.yaml").write_text(scene)
    (folder / "fit.yaml").write_text(
        yaml.safe_dump({"physsim_fit": 1, "scene": "scene.yaml", **content}, sort_keys=False)
    )
    return folder / "fit.yaml"


def check(found: Found, truth: Mapping[str, float], within: float = 4.0) -> None:
    """Every estimate is within so many of its own standard deviations of the truth."""
    assert found.success
    for each in found.estimates:
        assert abs(each.value - truth[each.path]) < within * each.deviation, each


def test_restitution_and_height_of_a_bounce(tmp_path: Path) -> None:
    """3 mm of noise; in units that are not SI, with cells that are empty and a comment."""
    t, noise = np.arange(0, 1.6, 0.02), np.random.default_rng(1)
    z = height(t, 0.7, 0.8) + 0.03 + noise.normal(0, 0.003, len(t))
    csv(tmp_path / "ball.csv", t_ms=1e3 * t, z_cm=1e2 * z)
    text = (tmp_path / "ball.csv").read_text().splitlines()
    text[5] = text[5].split(",")[0] + ","
    (tmp_path / "ball.csv").write_text("# by camera\n" + "\n".join(text).replace(",", ";") + "\n")
    fit = fit_file(
        tmp_path,
        BOUNCE,
        parameters={
            "parameters.e": {"start": 0.6, "min": 0.1, "max": 1},
            "parameters.drop": {"start": "90 cm", "min": "10 cm", "max": "2 m"},
        },
        data=[
            {
                "file": "ball.csv",
                "time": "t_ms",
                "time_unit": "ms",
                "quantities": {"bodies.ball.position.z": {"column": "z_cm", "unit": "cm", "sigma": "3 mm"}},
            }
        ],
    )
    found = search(load_fit(fit))
    check(found, {"parameters.e": 0.7, "parameters.drop": 0.8})
    assert found.estimates[0].deviation < 1e-3  # measured 3.4e-4
    assert len(found.compared[0].time) == len(t) - 1
    assert 0.5 < found.reduced < 1.6  # chi-squared of 77 degrees of freedom: 1 +- 0.16
    assert found.compared[0].rms == pytest.approx(0.003, rel=0.3)


@pytest.mark.parametrize("method", ["least_squares", "nelder_mead"])
def test_stiffness_and_damping_from_two_experiments(tmp_path: Path, method: str) -> None:
    """Two pulls, each in a file of its own; the noise is not told, so it is estimated from what is left."""
    t, noise = np.arange(0, 2, 0.04), np.random.default_rng(2)
    data = []
    for pull in (0.1, -0.2):
        name = f"pull{pull:g}.csv"
        csv(tmp_path / name, time=t, x=1 + swing(t, 130.0, 2.5, pull) + noise.normal(0, 0.002, len(t)))
        data.append(
            {
                "file": name,
                "set": {"parameters.pull": pull},
                "quantities": {"bodies.mass.position.x": {"column": "x"}},
            }
        )
    fit = fit_file(
        tmp_path,
        COARSE,
        method=method,
        parameters={
            "springs.coil.stiffness": {"start": "100 N/m", "min": 10, "max": 1000, "scale": "log"},
            "springs.coil.damping": {"start": 1, "min": 0.1, "max": 10},
        },
        data=data,
    )
    found = search(load_fit(fit))
    check(found, {"springs.coil.stiffness": 130.0, "springs.coil.damping": 2.5})
    assert found.reduced is None
    assert [one.sigma for one in found.compared] == pytest.approx([0.002] * 2, rel=0.5)
    assert 0.05 < found.estimates[0].deviation < 1


def test_velocity_from_a_flight_has_the_error_of_a_straight_line(tmp_path: Path) -> None:
    """x = v t is linear in v: its standard deviation is sigma / sqrt(sum of t^2), exactly."""
    t = np.linspace(0.05, 1, 20)
    x = 3 * t + np.random.default_rng(3).normal(0, 0.01, len(t))
    csv(tmp_path / "x.csv", time=t, x=x)
    fit = fit_file(
        tmp_path,
        FLIGHT,
        parameters={"bodies.stone.velocity[0]": {"start": "1 m/s"}},
        data=[{"file": "x.csv", "quantities": {"bodies.stone.position.x": {"column": "x", "sigma": "1 cm"}}}],
    )
    found = search(load_fit(fit))
    (estimate,) = found.estimates
    assert estimate.value == pytest.approx((x @ t) / (t @ t), rel=1e-9)
    assert estimate.deviation == pytest.approx(0.01 / np.sqrt(t @ t), rel=1e-6)
    assert found.reduced == pytest.approx(((x - estimate.value * t) ** 2).sum() / 0.01**2 / 19, rel=1e-6)


def test_data_of_a_trajectory_and_of_any_hdf5(tmp_path: Path) -> None:
    """A run as data gives its own values back; so does a file of plain datasets, its clock 2 s off."""
    (tmp_path / "truth.yaml").write_text(FLIGHT)
    truth = {"bodies.stone.velocity": [3, 0, 5], "record.every": "50 ms"}
    with (
        physsim.run(tmp_path / "truth.yaml", set=truth, output=tmp_path / "run.h5") as run,
        h5py.File(tmp_path / "lab.h5", "w") as file,
    ):
        file["camera/t"], file["camera/z"] = run.time + 2, run.body("stone").position[:, 2]
    fit = fit_file(
        tmp_path,
        FLIGHT,
        parameters={"bodies.stone.velocity[0]": {"start": 1.0}, "bodies.stone.velocity[2]": {"start": 1.0}},
        data=[
            {"file": "run.h5", "quantities": {"bodies.stone.position.x": {}}},
            {
                "file": "lab.h5",
                "time": "camera/t",
                "start": "2 s",
                "quantities": {"bodies.stone.position.z": {"column": "camera/z"}},
            },
        ],
    )
    found = search(load_fit(fit))
    assert [each.value for each in found.estimates] == pytest.approx([3, 5], rel=1e-9)


def test_all_of_the_bounds_are_searched(tmp_path: Path) -> None:
    """From a stiffness of 900 the phase is wrong by several turns: one descent gets stuck, many do not."""
    t = np.arange(0, 2, 0.04)
    csv(tmp_path / "x.csv", time=t, x=1 + swing(t, 130.0, 1.0, 0.1))
    found: dict[str, float] = {}
    for name, how in {
        "one": {},
        "many": {"starts": 6},
        "all": {"method": "differential_evolution"},
    }.items():
        fit = fit_file(
            tmp_path,
            COARSE,
            parameters={"springs.coil.stiffness": {"start": 900, "min": 10, "max": 1000, "scale": "log"}},
            data=[
                {"file": "x.csv", "quantities": {"bodies.mass.position.x": {"column": "x", "sigma": 0.001}}}
            ],
            seed=1,
            **how,
        )
        found[name] = search(load_fit(fit)).estimates[0].value
    assert found["many"] == pytest.approx(130, rel=1e-3)
    assert found["all"] == pytest.approx(130, rel=1e-3)
    assert abs(found["one"] - 130) > 10


def test_outliers_count_less(tmp_path: Path) -> None:
    t = np.linspace(0.05, 1, 20)
    x = 3 * t + np.random.default_rng(3).normal(0, 0.01, len(t))
    x[[4, 11]] += 1.5
    csv(tmp_path / "x.csv", time=t, x=x)
    values = {}
    for loss in ("linear", "soft_l1"):
        fit = fit_file(
            tmp_path,
            FLIGHT,
            loss=loss,
            parameters={"bodies.stone.velocity[0]": {"start": 1}},
            data=[
                {"file": "x.csv", "quantities": {"bodies.stone.position.x": {"column": "x", "sigma": 0.01}}}
            ],
        )
        values[loss] = search(load_fit(fit)).estimates[0].value
    assert abs(values["soft_l1"] - 3) < 0.02
    assert abs(values["linear"] - 3) > 0.1


def test_what_the_data_do_not_determine(tmp_path: Path) -> None:
    """In a free flight x says nothing about the mass."""
    t = np.linspace(0, 1, 20)
    csv(tmp_path / "x.csv", time=t, x=3 * t)
    fit = fit_file(
        tmp_path,
        FLIGHT,
        parameters={
            "bodies.stone.velocity[0]": {"start": 1},
            "bodies.stone.mass": {"start": "1 kg", "min": 0.1, "max": 9},
        },
        data=[{"file": "x.csv", "quantities": {"bodies.stone.position.x": {"column": "x", "sigma": 0.01}}}],
    )
    speed, mass = search(load_fit(fit)).estimates
    assert speed.value == pytest.approx(3, rel=1e-6)
    assert (mass.value, mass.deviation) == (1, np.inf)


def test_losses_are_those_of_scipy() -> None:
    r = np.array([-3.0, 0.2, 1.0, 8.0])
    for loss in ("linear", "soft_l1", "huber", "cauchy"):
        done = least_squares(lambda x: r + 0 * x, 0.0, loss=loss)
        assert cost_of(r, loss) == pytest.approx(done.cost, rel=1e-12)


def test_a_start_that_blows_up_is_told(tmp_path: Path) -> None:
    csv(tmp_path / "x.csv", time=np.linspace(0, 1, 5), x=np.ones(5))
    scene = OSCILLATOR.replace("rk4", "explicit_euler").replace("2 ms", "20 ms")
    fit = fit_file(
        tmp_path,
        scene,
        parameters={"springs.coil.stiffness": {"start": 1e12}},
        data=[{"file": "x.csv", "quantities": {"bodies.mass.position.x": {"column": "x"}}}],
    )
    with pytest.raises(RunFailed, match=r"x\.csv: .*blew up"):
        search(load_fit(fit))


def test_the_command(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    t = np.linspace(0.05, 1, 20)
    csv(tmp_path / "x.csv", time=t, x=3 * t)
    fit_file(
        tmp_path,
        FLIGHT,
        title="A stone",
        parameters={"bodies.stone.velocity[0]": {"start": "1 m/s"}},
        data=[{"file": "x.csv", "quantities": {"bodies.stone.position.x": {"column": "x", "sigma": "1 cm"}}}],
    )
    assert answer(["fit", "fit.yaml", "--plot", "fit.svg"]) == 0
    told = capsys.readouterr().out
    assert "3.0000 ± 0.0037 m/s" in told
    assert "--set bodies.stone.velocity[0]='3 m/s'" in told
    assert (tmp_path / "fit.svg").read_bytes().startswith(b"<?xml")
    assert answer(["fit", "fit.yaml", "--json", "--quiet"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["estimates"][0]["value"] == pytest.approx(3)
    assert found["compared"][0]["values"] == 20
    assert answer(["fit", "none.yaml"]) == 3
    assert "none.yaml: there is no such file" in capsys.readouterr().err


GOOD = """\
physsim_fit: 1
scene: scene.yaml
parameters:
  bodies.stone.velocity[0]: {start: 1 m/s, min: 0, max: 9}
data:
  - file: x.csv
    quantities: {bodies.stone.position.x: {column: x, unit: cm, sigma: 1 mm}}
"""


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (
            ("physsim_fit: 1", "physsim_fit: 2"),
            ["fit.yaml:1:14: physsim_fit: is a version of the fit language"],
        ),
        (
            ("scene.yaml", "scenery.yaml"),
            ["fit.yaml:2:8: scene: there is no such file; did you mean 'scene.yaml'?"],
        ),
        (
            ("start: 1 m/s", "start: 1 kg"),
            ["fit.yaml:4:37: parameters.bodies.stone.velocity[0].start: must be a speed"],
        ),
        (
            ("{start: 1 m/s, min: 0, max: 9}", "{start: 1 kg}"),
            ["fit.yaml:4:", "must be a speed, not a value in kg"],
        ),
        (("min: 0", "min: 2"), ["fit.yaml:4:", "must be less than start"]),
        (("stone.velocity[0]", "stine.velocity[0]"), ["fit.yaml:4:", "there is no 'stine' in bodies"]),
        (("column: x", "column: y"), ["fit.yaml:7:52:", "the file has no column 'y'"]),
        (("unit: cm", "unit: kg"), ["fit.yaml:7:61:", "must be a length"]),
        (("unit: cm", "unit: cmm"), ["fit.yaml:7:61:", "unknown unit 'cmm'"]),
        (("sigma: 1 mm", "sigma: -1 mm"), ["fit.yaml:7:", "must be greater than 0"]),
        (("file: x.csv", "file: y.csv"), ["fit.yaml:6:11: data[0].file: no such file"]),
        (("stone.position.x", "stine.position.x"), ["fit.yaml:7:", "the scene has no bodies 'stine'"]),
        (("stone.position.x", "stone.positon.x"), ["fit.yaml:7:18:", "names no quantity of a body"]),
        (("data:", "dota:"), ["fit.yaml:5:1: dota: unknown key; did you mean 'data'?"]),
        (
            ("data:", "set: {simulation.duration: 10 ms}\ndata:"),
            ["was measured until 1 s, but the simulation ends"],
        ),
        (
            ("data:", "set: {simulation.duratoin: 2 s}\ndata:"),
            ["fit.yaml:5:", "set.simulation.duratoin: unknown key"],
        ),
        (("data:", "starts: 3\ndata:"), []),
        ((", max: 9}", "}"), []),
    ],
)
def test_mistakes_have_their_place(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    change,
    told: Sequence[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("scene.yaml").write_text(FLIGHT)
    csv(Path("x.csv"), time=np.linspace(0, 1, 5), x=np.ones(5))
    assert change[0] in GOOD
    Path("fit.yaml").write_text(GOOD.replace(*change))
    if not told:
        load_fit("fit.yaml")
        return
    assert answer(["fit", "fit.yaml"]) == 2
    err = capsys.readouterr().err
    for part in told:
        assert part in err, err


def test_a_scene_that_is_wrong_itself_is_told_in_the_scene(tmp_path: Path) -> None:
    fit = fit_file(
        tmp_path,
        FLIGHT.replace("mass: 1,", "mass: -1,"),
        parameters={"bodies.stone.velocity[0]": {"start": 1}},
        data=[{"file": "x.csv", "quantities": {"bodies.stone.position.x": {"column": "x"}}}],
    )
    with pytest.raises(SceneError) as caught:
        load_fit(fit)
    assert caught.value.file.endswith("scene.yaml")
    assert caught.value.problems[0].line == 4


def test_the_schema_is_fresh_and_takes_a_fit() -> None:
    """Editors check with it what the command checks: it refuses what has no place in a fit."""
    path = Path(__file__).parents[2] / "schemas" / "fit.schema.json"
    assert path.read_text() == schema_text(), (
        "renew it: python -m physsim.batch.fit_schema > schemas/fit.schema.json"
    )
    schema = Draft202012Validator(json.loads(path.read_text()))
    good = yaml.safe_load(GOOD)
    assert list(schema.iter_errors(good)) == []
    for wrong in ({"dota": []}, {"method": "guess"}, {"data": []}, {"starts": 0}, {"parameters": {"a": {}}}):
        assert list(schema.iter_errors(good | wrong)), wrong

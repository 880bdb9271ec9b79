"""The formula sheet as a whole, and how cases are judged."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from physsim.analysis.verify import FORMULAS, Case, Check, Verdict, pick, scene_file
from physsim.analysis.verify.judge import order_of
from physsim.cli import verify_ahead as ahead
from physsim.cli.app import answer
from physsim.cli.verify_run import file_name, runs_of, try_out
from physsim.scene import load_scene

REPOSITORY = Path(__file__).resolve().parents[2]
BEYOND_THE_SHEET = 9
SCENES = sorted({scene for formula in FORMULAS for scene in formula.scenes})
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")


@pytest.mark.parametrize("formula", FORMULAS, ids=lambda formula: formula.name)
def test_a_formula_holds(formula, tmp_path):
    tried = try_out(formula, tmp_path)
    assert tried.troubles == []
    assert [
        f"{v.case.name}: {v.check.name}: {v.error}, {v.order}" for v in tried.verdicts if not v.passed
    ] == []


@pytest.mark.parametrize("scene", SCENES)
def test_a_scene_tells_its_theory_and_expects_something(scene):
    text = scene_file(scene).read_text(encoding="utf-8")
    loaded = load_scene(scene_file(scene))
    assert text.startswith("# ")
    assert "\n# Theory: " in text
    assert len(loaded.spec.expect) >= 1
    assert loaded.warnings == ()


def test_no_scene_is_left_over():
    assert sorted(file.stem for file in scene_file("x").parent.glob("*.yaml")) == SCENES


def test_every_section_of_the_sheet_has_formulas():
    assert {formula.section for formula in FORMULAS} == {*range(1, 9), BEYOND_THE_SHEET}


def test_names_are_unique_and_lead_to_their_formula():
    names = [case.name for formula in FORMULAS for case in formula.cases]
    assert len(set(names)) == len(names)
    for formula in FORMULAS:
        assert all(case.name.split(".")[0] == formula.name for case in formula.cases)


def test_picking():
    assert pick([]) == list(FORMULAS)
    assert [formula.name for formula in pick(["force"])] == ["force"]
    (one,) = pick(["free_fall.rk4"])
    assert [case.name for case in one.cases] == ["free_fall.rk4"]
    with pytest.raises(KeyError, match="nonesuch"):
        pick(["force", "nonesuch"])


def test_order_is_the_slope_of_the_logarithms():
    assert order_of((0.4, 0.2, 0.1), (16.0, 4.0, 1.0)) == pytest.approx(2)
    assert order_of((0.1,), (1.0,)) is None
    assert order_of((0.2, 0.1), (1.0, 0.0)) is None
    assert order_of((0.2, 0.1), (1.0, np.inf)) is None


def verdict(error: float, order: float | None, wanted: float | None) -> Verdict:
    check = Check("x", "m", "time", lambda p, t: t, 1e-3, wanted)
    one = np.zeros(1)
    return Verdict(Case("c", "s", (check,)), check, 1.0, 1.0, (0.1,), (error,), order, one, one, one)


@pytest.mark.parametrize(
    ("error", "order", "wanted", "passed"),
    [
        (1e-4, None, None, True),
        (2e-3, None, None, False),
        (float("inf"), None, None, False),
        (float("nan"), None, None, False),
        (1e-4, 2.05, 2, True),
        (1e-4, 1.85, 2, False),
        (1e-4, None, 2, False),
    ],
)
def test_a_verdict(error, order, wanted, passed):
    assert verdict(error, order, wanted).passed is passed


def test_a_wrong_theory_fails_with_exit_code_1(monkeypatch, capsys):
    """The verb can fail: the same scene against half the truth."""
    import physsim.analysis.verify as room  # noqa: PLC0415, patched

    right = pick(["force"])[0]
    check = right.cases[0].checks[0]
    wrong = Check("velocity", "m/s", check.measure, lambda p, t: check.theory(p, t) / 2, 1e-3)
    broken = type(right)(**{**vars(right), "cases": (Case("force", "force", (wrong,)),)})
    monkeypatch.setattr(room, "pick", lambda _: [broken])
    assert answer(["verify", "--json"]) == 1
    told = json.loads(capsys.readouterr().out)
    assert told["passed"] is False
    assert told["formulas"][0]["comparisons"][0]["error"] == pytest.approx(1)


def test_a_broken_scene_is_told_and_fails(monkeypatch, capsys):
    import physsim.analysis.verify as room  # noqa: PLC0415, patched

    right = pick(["force"])[0]
    case = Case("force", "force", right.cases[0].checks, {"bodies.crate.mass": "-1 kg"})
    monkeypatch.setattr(room, "pick", lambda _: [type(right)(**{**vars(right), "cases": (case,)})])
    assert answer(["verify"]) == 1
    assert "must be greater than 0" in capsys.readouterr().out


def test_pictures_are_the_same_bytes_again(tmp_path, capsys):
    for folder in ("a", "b"):
        assert answer(["verify", "--case", "force", "--plot", str(tmp_path / folder)]) == 0
    first, second = ((tmp_path / folder / "force.svg").read_bytes() for folder in ("a", "b"))
    assert first == second
    assert b"<svg" in first


def test_runs_that_are_done_ahead_are_those_that_are_needed(tmp_path, monkeypatch):
    """In other processes, all of them, and the broken one left to be told later."""
    monkeypatch.setattr(ahead, "WORTH_IT", 1)
    monkeypatch.setattr(os, "cpu_count", lambda: 2)
    jobs = [(scene, changes, tmp_path) for scene, changes in runs_of(pick(["force", "torque"]))]
    advanced: list[None] = []
    ahead.run_ahead(
        [*jobs, ("force", {"bodies.crate.mass": "-1 kg"}, tmp_path)], lambda: advanced.append(None)
    )
    assert len(advanced) == len(jobs) + 1
    assert {file.name for file in tmp_path.iterdir()} == {
        file_name(scene, changes) for scene, changes, _ in jobs
    }


def test_unknown_cases_are_refused_with_the_nearest_name(capsys):
    assert answer(["verify", "--case", "free_fal"]) == 2
    assert "did you mean 'free_fall'" in capsys.readouterr().err


def test_every_formula_has_its_page():
    overview = (REPOSITORY / "docs" / "formulas.md").read_text(encoding="utf-8")
    for formula in FORMULAS:
        assert f"(formulas/{formula.name}.md)" in overview
        page = REPOSITORY / "docs" / "formulas" / f"{formula.name}.md"
        text = page.read_text(encoding="utf-8")
        for target in LINK.findall(text):
            assert (page.parent / target).exists(), target
        for scene in formula.scenes:
            assert scene_file(scene).read_text(encoding="utf-8").rstrip() in text, (
                f"{scene}: python docs/formulas.py"
            )
        assert all(case.name in text for case in formula.cases)


def test_no_page_is_left_over():
    pages = {file.stem for file in (REPOSITORY / "docs" / "formulas").glob("*.md")}
    assert pages == {formula.name for formula in FORMULAS}


def test_importing_the_command_line_does_not_import_the_cases():
    script = "import sys, physsim.cli.verify; sys.exit('physsim.analysis' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", script], timeout=60, check=False).returncode == 0


def test_analysis_never_imports_the_simulation():
    """It reads files through `physsim.recording`."""
    never = ("physsim.simulation", "physsim._engine", "physsim.model")
    script = (
        "import sys, physsim.analysis.verify, physsim.analysis.verify.plot; "
        f"sys.exit(any(name in sys.modules for name in {never}))"
    )
    assert subprocess.run([sys.executable, "-c", script], timeout=60, check=False).returncode == 0

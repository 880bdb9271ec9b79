"""Streams and colours, and the JSON document."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest
from shell import on_a_terminal

from physsim.cli import output, problems
from physsim.errors import Problem

ESCAPE = "\x1b["
TITLED = """
physsim: 1
title: Σίσυφος
simulation: {duration: 1 s, timestep: 1 ms}
bodies:
  stone: {shape: {type: sphere, radius: 1}, mass: 1 kg, material: granite}
"""


def test_colours_on_a_terminal_unless_refused(tmp_path: Path) -> None:
    """stderr is the terminal; a broken scene is told there in bold and red."""
    (tmp_path / "a.yaml").write_text("physsim: 2\n")

    def seen(**environment: str) -> str:
        return on_a_terminal(["validate", "a.yaml"], tmp_path, **environment)[1]

    assert ESCAPE in seen()
    assert ESCAPE not in seen(NO_COLOR="1")
    assert ESCAPE not in seen(TERM="dumb")
    assert ESCAPE not in seen(NO_COLOR="1", FORCE_COLOR="1")


def test_no_colours_in_a_pipe_unless_wanted(process) -> None:
    assert ESCAPE not in process("materials", "steel").stdout
    assert ESCAPE in process("materials", "steel", FORCE_COLOR="1").stdout


def test_a_stream_that_cannot_write_a_character_writes_its_number(process, tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text(TITLED, encoding="utf-8")
    done = process("info", "a.yaml", PYTHONIOENCODING="latin-1")
    assert done.returncode == 0
    assert "a.yaml: \\u03a3\\u03af\\u03c3\\u03c5\\u03c6\\u03bf\\u03c2" in done.stdout


def test_the_document_holds_only_what_json_has_words_for(capsys: pytest.CaptureFixture[str]) -> None:
    output.document(
        "info",
        0,
        mass=math.inf,
        nan=np.float64("nan"),
        matrix=np.arange(4.0).reshape(2, 2),
        count=np.int64(3),
        fixed=np.bool_(True),
        between=("a", "b"),
        nested={"x": [np.float64(0.5), None, "text"]},
    )
    document = json.loads(capsys.readouterr().out, parse_constant=pytest.fail)
    assert document["mass"] is None
    assert document["nan"] is None
    assert document["matrix"] == [[0, 1], [2, 3]]
    assert document["count"] == 3
    assert document["fixed"] is True
    assert document["between"] == ["a", "b"]
    assert document["nested"] == {"x": [0.5, None, "text"]}


def test_a_problem_has_a_bold_headline_and_a_red_caret() -> None:
    problem = Problem(("a",), "is wrong", line=14, column=4, source_line="a: -1")
    assert problems.as_text([problem], "scene.yaml") == (
        f"{ESCAPE}1mscene.yaml:14:4: a: is wrong{ESCAPE}0m\n   14 | a: -1\n{ESCAPE}31m      |    ^{ESCAPE}0m"
    )


def test_a_warning_is_yellow_and_a_problem_without_a_place_is_one_line() -> None:
    doubt = Problem(("a",), "is doubtful", severity="warning", line=1, column=1, source_line="a: 1")
    assert f"{ESCAPE}33m" in problems.as_text([doubt], "f")
    assert problems.as_text([Problem((), "is empty")], "f").count("\n") == 0

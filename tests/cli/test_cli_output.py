"""Streams and colours, and the JSON document."""

from __future__ import annotations

import json
import math
import os
import pty
import subprocess
import sys

import numpy as np
import pytest

from physsim.cli import output, problems
from physsim.errors import Problem

ESCAPE = "\x1b["


def on_a_terminal(arguments: list[str], **environment: str) -> str:
    """What a command writes when stdout and stderr are a terminal."""
    kept = {
        name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "FORCE_COLOR", "TERM")
    }
    master, slave = pty.openpty()
    child = subprocess.Popen(
        [sys.executable, "-m", "physsim", *arguments],
        stdin=subprocess.DEVNULL,
        stdout=slave,
        stderr=slave,
        env=kept | {"TERM": "xterm-256color"} | environment,
    )
    os.close(slave)
    said = b""
    try:
        while chunk := os.read(master, 65536):
            said += chunk
    except OSError:  # the other end has closed: Linux says EIO
        pass
    os.close(master)
    child.wait(timeout=60)
    return said.decode()


def test_colours_on_a_terminal_unless_refused() -> None:
    assert ESCAPE in on_a_terminal(["materials", "steel"])
    assert ESCAPE not in on_a_terminal(["materials", "steel"], NO_COLOR="1")
    assert ESCAPE not in on_a_terminal(["materials", "steel"], TERM="dumb")
    assert ESCAPE not in on_a_terminal(["materials", "steel"], NO_COLOR="1", FORCE_COLOR="1")


def test_no_colours_in_a_pipe_unless_wanted(process) -> None:
    assert ESCAPE not in process("materials", "steel").stdout
    assert ESCAPE in process("materials", "steel", FORCE_COLOR="1").stdout


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
    document = json.loads(capsys.readouterr().out, parse_constant=lambda word: pytest.fail(word))
    assert document["mass"] is None
    assert document["nan"] is None
    assert document["matrix"] == [[0, 1], [2, 3]]
    assert document["count"] == 3
    assert document["fixed"] is True
    assert document["between"] == ["a", "b"]
    assert document["nested"] == {"x": [0.5, None, "text"]}


def test_a_problem_is_shown_with_its_line_and_a_caret() -> None:
    problem = Problem(
        ("bodies", "ball", "shape", "size", 2),
        "must be greater than 0",
        given="-1",
        hint="did you mean 1?",
        line=14,
        column=7,
        source_line="\tsize: [1, 1, -1]\n",
    )
    shown = problems.as_text([problem], "scene.yaml")
    for code in (ESCAPE + "0m", ESCAPE + "1m", ESCAPE + "31m"):
        shown = shown.replace(code, "")
    assert shown == (
        "scene.yaml:14:7: error: bodies.ball.shape.size[2]: must be greater than 0, got -1; did you mean 1?\n"
        "   14 |  size: [1, 1, -1]\n"
        "      |       ^"
    )


def test_a_long_line_is_cut_and_a_problem_without_a_place_is_one_line() -> None:
    far = Problem(("a",), "is wrong", line=1, column=900, source_line="x" * 1000)
    assert max(len(line) for line in problems.as_text([far], "f").splitlines()) <= 210
    assert "^" not in problems.as_text([far], "f")
    assert problems.as_text([Problem((), "is empty")], "f").count("\n") == 0

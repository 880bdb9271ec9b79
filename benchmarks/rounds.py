"""Cells run in rounds, engine after engine in each, so that a slow minute of the machine meets them all."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.cell import Request
from benchmarks.judge import Judge, Sample
from benchmarks.scenes import SCENES

ONE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "RAYON_NUM_THREADS")
Row = dict[str, Any]


def played(requests: Sequence[Request], rounds: int) -> Iterator[Row]:
    """One row per request and round, as they come."""
    for number in range(rounds):
        for request in requests:
            yield {"round": number, **measured(request)}


def measured(request: Request) -> Row:
    """The speed of one cell, and the quality of what it left."""
    with tempfile.TemporaryDirectory() as folder:
        states = Path(folder) / "states.npz"
        row = _child(request, states)
        if states.exists():
            row |= _judged(request.scene, states)
        return row


def _child(request: Request, states: Path) -> Row:
    told = json.dumps(asdict(request))
    command = [sys.executable, "-W", "ignore", "-m", "benchmarks.cell", told, str(states)]
    environment = os.environ | dict.fromkeys(ONE_THREAD, str(request.threads))
    try:
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            env=environment,
            timeout=5 * request.limit + 120,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return asdict(request) | {"unable": "did not come to an end"}
    last = done.stdout.strip().rsplit("\n", 1)[-1]
    if not last.startswith("{"):
        why = (done.stderr.strip().splitlines() or [f"ended by {done.returncode}"])[-1]
        return asdict(request) | {"unable": why[:200]}
    row: Row = json.loads(last)
    return row


def _judged(scene: str, states: Path) -> Row:
    with np.load(states) as file:
        columns = [file[name] for name in ("time", *"xqvw")]
    samples = [Sample(float(t), (x, q, v, w)) for t, x, q, v, w in zip(*columns, strict=True)]
    return dict(Judge(SCENES[scene]()).verdict(samples))

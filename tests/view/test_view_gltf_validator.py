"""The validator of Khronos finds nothing to say about exported files: no error, no warning, no remark."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any, NoReturn

import h5py
import pytest

import physsim
from physsim.cli.app import answer

HERE = Path(__file__).parent
SCENES = HERE.parents[1] / "scenes"

Validate = Callable[..., list[dict[str, Any]]]


@pytest.fixture(scope="module")
def validate(tmp_path_factory: pytest.TempPathFactory) -> Validate:
    """`validate(file, ...)`: what the validator says. It comes from npm, as the lock file names it.

    Skips where there is no node, or no way to the registry, or fails when PHYSSIM_NEED_BROWSER=1.
    """
    if shutil.which("node") is None or shutil.which("npm") is None:
        give_up("no node and npm here")
    folder = tmp_path_factory.mktemp("validator") / "gltf_validator"
    shutil.copytree(HERE / "gltf_validator", folder, ignore=shutil.ignore_patterns("node_modules"))
    quiet = ("--ignore-scripts", "--prefer-offline", "--no-audit", "--no-fund", "--loglevel=error")
    done = ran("npm", "ci", *quiet, folder=folder)
    if done.returncode:
        give_up(f"npm could not install the validator: {done.stderr}")

    def call(*files: Path) -> list[dict[str, Any]]:
        done = ran("node", "validate.mjs", *map(str, files), folder=folder)
        assert done.returncode == 0, done.stderr
        reports: list[dict[str, Any]] = json.loads(done.stdout)
        return reports

    return call


def give_up(reason: str) -> NoReturn:
    if os.environ.get("PHYSSIM_NEED_BROWSER") == "1":
        pytest.fail(reason)
    pytest.skip(reason)


def ran(*command: str, folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        command,
        cwd=folder,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


def exported(scene: Path, folder: Path, duration: str, *words: str) -> Path:
    recording, target = folder / f"{scene.stem}.h5", folder / f"{scene.stem}{len(words)}.glb"
    if not recording.exists():
        physsim.run(scene, set=["expect=[]"], output=recording, duration=duration).close()
    assert answer(["export", str(recording), "--to", "glb", "-o", str(target), *words]) == 0
    return target


def test_scenes_are_valid(validate: Validate, tmp_path: Path) -> None:
    """Every kind of shape, compounds, springs, a string that breaks, hostile names, no motion, nothing."""
    names = (
        "nuts_and_brackets",
        "marbles_in_a_funnel",
        "dominoes",
        "mobile",
        "rolling_race",
        "spinning_body",
    )
    files = [
        *(exported(SCENES / f"{name}.yaml", tmp_path, "30 ms", "--camera") for name in names),
        exported(SCENES / "breaking_string.yaml", tmp_path, "0.6 s"),
        *(exported(scene, tmp_path, "30 ms") for scene in sorted((HERE / "scenes").glob("*.yaml"))),
        exported(SCENES / "dominoes.yaml", tmp_path, "30 ms", "--until", "0"),
        exported(SCENES / "dominoes.yaml", tmp_path, "30 ms", "--fps", "240", "--tolerance", "0"),
    ]
    with h5py.File(tmp_path / "dominoes.h5", "r+") as file:
        file["geometry/shown"][:] = 0
    files.append(exported(SCENES / "dominoes.yaml", tmp_path, "30 ms", "--until", "0", "--camera"))
    reports = validate(*files)
    assert len(reports) == len(files) > 10
    for report in reports:
        counts = {
            name: report["issues"][name] for name in ("numErrors", "numWarnings", "numInfos", "numHints")
        }
        assert not any(counts.values()), (report["file"], counts, report["issues"]["messages"])
    assert sum(report["info"]["animationCount"] for report in reports) == len(files) - 2


def test_the_validator_sees_what_is_wrong(validate: Validate, tmp_path: Path) -> None:
    target = exported(SCENES / "dominoes.yaml", tmp_path, "0.1 s")
    target.write_bytes(target.read_bytes().replace(b'"type":"VEC3"', b'"type":"VEC2"', 1))
    (report,) = validate(target)
    assert report["issues"]["numErrors"] > 0

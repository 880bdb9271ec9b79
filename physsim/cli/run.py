"""`physsim run`: a scene in, a trajectory out, and a summary of how it went."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from physsim.cli import output, problems, progress, summary, watching
from physsim.cli.verb import Example, Verb, debug_option, json_option, set_option, settings
from physsim.errors import ExpectationFailed, Problem
from physsim.uncollected import imported_for_good


@click.command(
    cls=Verb,
    exits=(0, 1, 2, 3, 4, 130),
    arguments=[("SCENE", "the scene file (YAML)")],
    examples=[
        Example("run my_scene.yaml; the trajectory is my_scene.h5", "physsim run my_scene.yaml"),
        Example(
            "go on where a run was interrupted or killed, or simply longer",
            "physsim run my_scene.yaml --resume --duration '4 s'",
        ),
        Example(
            "another file, another value",
            "physsim run my_scene.yaml -o higher.h5 --set parameters.drop='1 m'",
        ),
        Example(
            "half the timestep, in place of the older file",
            "physsim run my_scene.yaml --set simulation.timestep='0.5 ms' --force",
        ),
        Example("see it in a browser while it computes", "physsim run my_scene.yaml -o seen.h5 --watch"),
        Example("for a script: one JSON document", "physsim run my_scene.yaml -o trial.h5 --json --quiet"),
    ],
)
@click.argument("scene", type=click.Path())
@click.option(
    "-o",
    "--output",
    "target",
    type=click.Path(),
    metavar="FILE.h5",
    help="The trajectory file. Default: the scene's name with .h5, in the current folder.",
)
@set_option
@click.option("--duration", metavar="D", help="Simulated time instead of the scene's, with its unit: '2 s'.")
@click.option(
    "--resume", is_flag=True, help="Go on from what the file holds, bit for bit as if never stopped."
)
@click.option(
    "--force", is_flag=True, help="Replace an existing file, once the new run has something to keep."
)
@click.option(
    "--watch", is_flag=True, help="Show the run in a browser while it computes; it is hardly slower for that."
)
@click.option(
    "--port",
    type=click.IntRange(1, 65535),
    metavar="N",
    help="Port of the page of --watch, on this machine only. Default: any that is free.",
)
@click.option("--quiet", is_flag=True, help="Errors and failed expectations only.")
@json_option
@debug_option
@click.pass_context
def command(
    ctx: click.Context,
    *,
    scene: str,
    target: str | None,
    overrides: tuple[str, ...],
    duration: str | None,
    resume: bool,
    force: bool,
    watch: bool,
    port: int | None,
    quiet: bool,
    as_json: bool,
) -> None:
    """Simulate SCENE and write its trajectory to an HDF5 file.

    The scene is checked first: every mistake is told with its line, and nothing is written. Then the world
    is stepped, with a bar on the terminal, and frames are appended to the file as they come; a kill at any
    moment loses at most the last block. At the end the expectations of the scene are checked.

    Ctrl-C and SIGTERM end a run in good order: the file is kept and marked, and --resume goes on.
    """
    import logging

    with imported_for_good():
        from physsim.scene import load_scene
        from physsim.simulation import check_expectations, run

    logging.getLogger("physsim").setLevel(logging.ERROR if quiet else logging.WARNING)
    file = Path(target) if target is not None else Path(f"{Path(scene).stem}.h5")
    warnings = Warnings(scene, told=not quiet and not as_json)
    settings(ctx).known = {"scene": scene, "file": str(file), "warnings": warnings.data}
    with watching.offered(watch, port) as feed:
        loaded = load_scene(scene, [*overrides, *duration_override(duration)], warnings)
        with progress.shown(loaded.title, quiet=quiet) as report:
            trajectory = run(
                loaded,
                output=file,
                resume=resume,
                force=force,
                progress=report,
                warn=warnings,
                onlooker=feed,
            )
        with trajectory:
            results = check_expectations(trajectory, loaded.spec.expect)
            facts = summary.facts(trajectory, results)
        code = 0 if all(result.held for result in results) else ExpectationFailed.exit_code
        if as_json:
            output.document("run", code, **settings(ctx).known | facts, error=None, problems=[])
        else:
            _tell(facts, code, len(warnings.data), quiet)
        if feed is not None and not (quiet or as_json):
            watching.stay(feed)
    ctx.exit(code)


def _tell(facts: dict[str, Any], code: int, warnings: int, quiet: bool) -> None:
    if not quiet:
        output.result(summary.as_text(facts, warnings))
    elif code:
        output.message(summary.failures(facts))


def duration_override(duration: str | None) -> list[str]:
    """`--duration D` is another way to write `--set simulation.duration=D`."""
    return [] if duration is None else [f"simulation.duration={duration}"]


class Warnings:
    """Takes the warnings of a run: shows each at once, and keeps it for the JSON document."""

    def __init__(self, file: str, *, told: bool) -> None:
        self._file = file
        self._told = told
        self.data: list[dict[str, Any]] = []

    def __call__(self, problem: Problem) -> None:
        self.data += problems.as_data([problem], self._file)
        if self._told:
            output.message(problems.as_text([problem], self._file))

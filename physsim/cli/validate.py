"""`physsim validate`: everything that is wrong with scenes, without running them."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import click

from physsim.cli import output, problems
from physsim.cli.verb import Example, Verb, debug_option, json_option, set_option
from physsim.errors import FileTrouble, Problem, SceneError


@dataclass
class Verdict:
    """What was found out about one file."""

    file: str
    exit_code: int = 0
    title: str | None = None
    bodies: int | None = None
    error: str | None = None
    problems: tuple[Problem, ...] = field(default=())


@click.command(
    cls=Verb,
    arguments=[("SCENE...", "scene files (YAML)")],
    examples=[
        Example("check one scene", "physsim validate my_scene.yaml"),
        Example("check all of them, for a program", "physsim validate --json *.yaml"),
        Example("would this value be allowed?", "physsim validate my_scene.yaml --set parameters.drop='2 m'"),
    ],
)
@click.argument("scenes", metavar="SCENE...", nargs=-1, required=True, type=click.Path())
@set_option
@json_option
@debug_option
@click.pass_context
def command(ctx: click.Context, scenes: tuple[str, ...], overrides: tuple[str, ...], as_json: bool) -> None:
    """Check scenes and tell every mistake at once, each with its line and column.

    Names, types, units, ranges, references between bodies and materials, meshes, inertias and overlaps at the
    start are checked: a scene that passes can be run. Warnings do not make a scene invalid. With several
    files the exit status is the highest of them.
    """
    verdicts = [judge(scene, overrides) for scene in scenes]
    worst = max(verdict.exit_code for verdict in verdicts)
    if as_json:
        output.document("validate", worst, scenes=[as_data(verdict) for verdict in verdicts])
    else:
        for verdict in verdicts:
            tell(verdict)
    ctx.exit(worst)


def judge(scene: str, overrides: tuple[str, ...]) -> Verdict:
    """Load and compile one scene; errors become part of the verdict, so that the next file gets its turn."""
    from physsim.model import compile_scene
    from physsim.scene import load_scene
    from physsim.simulation.overlaps import find_overlaps, overlap_problems

    try:
        loaded = load_scene(scene, overrides=overrides)
        model = compile_scene(loaded)
        overlaps = overlap_problems(loaded, find_overlaps(model))
    except SceneError as error:
        return Verdict(scene, error.exit_code, problems=error.problems)
    except FileTrouble as error:
        return Verdict(scene, error.exit_code, error=str(error))
    warnings = (*loaded.warnings, *model.warnings, *overlaps)
    return Verdict(scene, title=loaded.title, bodies=len(model.body_names), problems=warnings)


def tell(verdict: Verdict) -> None:
    """Problems to stderr; one line for a valid scene to stdout."""
    if verdict.problems:
        output.message(problems.as_text(verdict.problems, verdict.file))
    if verdict.error is not None:
        output.message(verdict.error)
    if verdict.exit_code == 0:
        facts = [output.counted(verdict.bodies or 0, "body", "bodies")]
        if verdict.problems:
            facts.append(output.counted(len(verdict.problems), "warning", "warnings"))
        output.result(f"{verdict.file}: valid ({', '.join(facts)})")


def as_data(verdict: Verdict) -> dict[str, Any]:
    """One entry of the JSON document."""
    return {
        "file": verdict.file,
        "valid": verdict.exit_code == 0,
        "title": verdict.title,
        "bodies": verdict.bodies,
        "error": verdict.error,
        "problems": problems.as_data(verdict.problems, verdict.file),
    }

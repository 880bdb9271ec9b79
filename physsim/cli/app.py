"""The `physsim` command: finds the verb, runs it, and leaves with the promised exit code."""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Sequence
from difflib import get_close_matches
from typing import NoReturn

import click

import physsim
from physsim import one_thread
from physsim.cli import outcome, output
from physsim.cli.verb import ENVIRONMENT, EXIT_CODES, Settings, debug_option, definitions

# Every verb lives in the module of its name and is called `command` there.
VERBS = (
    *("run", "sweep", "validate", "info", "materials", "schema", "new"),
    *("view", "diff", "plot", "export", "fit"),
    *("verify", "completion"),
)


class Verbs(click.Group):
    """The group of verbs; each module is imported when its verb is asked for, and not before."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """The verbs in the order of a working day, not of the alphabet."""
        return list(VERBS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The verb of that name, or None."""
        if cmd_name not in VERBS:
            return None
        command = importlib.import_module(f"physsim.cli.{cmd_name}").command
        assert isinstance(command, click.Command)
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Refuse an unknown verb with the nearest known one."""
        name = args[0]
        if name not in VERBS and not name.startswith("-") and not ctx.resilient_parsing:
            near = get_close_matches(name, VERBS, n=1)
            hint = f" Did you mean '{near[0]}'?" if near else f" Commands: {', '.join(VERBS)}."
            raise click.UsageError(f"No such command '{name}'.{hint}", ctx)
        return super().resolve_command(ctx, args)

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Exit codes and environment: what no single verb can say."""
        definitions(formatter, "Exit status", [(str(code), text) for code, text in EXIT_CODES.items()])
        definitions(formatter, "Environment", ENVIRONMENT)
        with formatter.section("First steps"):
            formatter.write_text("physsim new my_scene && physsim run my_scene.yaml")


@click.group(cls=Verbs, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(
    physsim.__version__, "-V", "--version", prog_name="physsim", message="%(prog)s %(version)s"
)
@debug_option
def group() -> None:
    """Simulate rigid bodies: one YAML scene in, one HDF5 trajectory out.

    A scene declares bodies, materials and meshes; `physsim run scene.yaml` checks it, computes masses and
    inertias, steps it with contacts and friction, and writes scene.h5, which h5py, xarray, MATLAB and R open
    as it is.

    Each command has its own help: physsim COMMAND --help.
    """


def answer(arguments: Sequence[str] | None = None) -> int:
    """Run one command line and return its exit code; everything that goes wrong has been told by then."""
    wishes = Settings(debug=bool(os.environ.get("PHYSSIM_DEBUG")))
    try:
        code = group.main(
            args=None if arguments is None else list(arguments),
            prog_name="physsim",
            standalone_mode=False,
            obj=wishes,
            color=output.colour_wanted(),
        )
    except (SystemExit, GeneratorExit):
        raise
    except BaseException as error:  # the engine's panics are no Exceptions; no traceback reaches a user
        return outcome.tell(error, wishes)
    return code if isinstance(code, int) else 0


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Entry point of the console script."""
    output.forgive_encodings()
    one_thread.hold_back()
    code = answer(arguments)
    outcome.leave(code)
    sys.exit(code)

"""What all verbs share: the shape of their help, the options every one has, and the exit codes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import click

EXIT_CODES = {
    0: "done",
    1: "the run failed (blow-up, NaN), a formula of `verify` is off, `diff` found a difference, or an "
    "internal error",
    2: "wrong usage, or the scene is not valid",
    3: "file trouble: missing, exists without --force, not readable, disk full",
    4: "the run is complete, but an expectation of the scene failed",
    130: "interrupted; what was computed is kept, and `physsim run --resume` goes on",
}

ENVIRONMENT = [
    ("NO_COLOR", "no colours (no-color.org)"),
    ("FORCE_COLOR", "colours also where the output is not a terminal"),
    ("PHYSSIM_DEBUG", "show the traceback of an unexpected error, as --debug does"),
    ("XDG_CACHE_HOME", "where the convex pieces of meshes are kept (physsim/pieces); else ~/.cache"),
]

F = TypeVar("F", bound=Callable[..., Any])


@dataclass
class Settings:
    """What the user asked of the command as a whole; one object per call, reachable from every context.

    known: what a verb has found out already; it goes into the JSON document also when an error ends the call.
    """

    command: str = "physsim"
    debug: bool = False
    json: bool = False
    known: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Example:
    """One line of the examples section: what it shows, and a command that a test runs as it stands."""

    says: str
    command: str


class Verb(click.Command):
    """A sub-command whose help reads like a manual page: arguments, options, exit status, examples."""

    def __init__(
        self,
        *args: Any,
        arguments: Sequence[tuple[str, str]] = (),
        examples: Sequence[Example] = (),
        exits: Sequence[int] = (0, 2, 3),
        **kwargs: Any,
    ) -> None:
        super().__init__(*args, **kwargs)
        self.arguments = list(arguments)
        self.examples = list(examples)
        self.exits = list(exits)

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Arguments first, then the options."""
        definitions(formatter, "Arguments", self.arguments)
        super().format_options(ctx, formatter)

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Exit status and examples."""
        definitions(formatter, "Exit status", [(str(code), EXIT_CODES[code]) for code in self.exits])
        with formatter.section("Examples"):
            indent = " " * formatter.current_indent
            for example in self.examples:
                formatter.write(f"{indent}# {example.says}\n{indent}{example.command}\n")


def definitions(formatter: click.HelpFormatter, title: str, rows: Sequence[tuple[str, str]]) -> None:
    """A titled list of terms and what they mean; nothing at all when there are no rows."""
    if rows:
        with formatter.section(title):
            formatter.write_dl(rows)


def settings(ctx: click.Context) -> Settings:
    """The one Settings object of this call."""
    found = ctx.find_root().obj
    assert isinstance(found, Settings)
    return found


def debug_option(function: F) -> F:
    """`--debug`, accepted before and after the verb."""

    def remember(ctx: click.Context, _: click.Parameter, value: bool) -> None:
        settings(ctx).debug |= value

    return click.option(
        "--debug",
        is_flag=True,
        expose_value=False,
        is_eager=True,
        callback=remember,
        help="Show the traceback of an unexpected error.",
    )(function)


def json_option(function: F) -> F:
    """`--json`: one JSON document on stdout, errors included; passed on as `as_json`."""

    def remember(ctx: click.Context, _: click.Parameter, value: bool) -> bool:
        settings(ctx).json |= value
        settings(ctx).command = ctx.info_name or ""
        return value

    return click.option(
        "--json",
        "as_json",
        is_flag=True,
        is_eager=True,
        callback=remember,
        help="Print one JSON document on stdout, errors included.",
    )(function)


def set_option(function: F) -> F:
    """`--set path=value`, as often as wanted; passed on as `overrides`."""
    return click.option(
        "--set",
        "overrides",
        metavar="PATH=VALUE",
        multiple=True,
        help="Change a value of the scene, with its unit: bodies.ball.mass='2 kg'. May be repeated; "
        "checked like the file.",
    )(function)

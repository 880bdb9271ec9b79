"""`physsim completion`: the script that makes a shell complete commands, options and files."""

from __future__ import annotations

import click
from click.shell_completion import get_completion_class

from physsim.cli import output
from physsim.cli.verb import Example, Verb, debug_option

SHELLS = ("bash", "zsh", "fish")


@click.command(
    cls=Verb,
    exits=(0, 2),
    arguments=[("SHELL", "bash, zsh or fish")],
    examples=[
        Example("bash, for every new shell", "physsim completion bash > physsim-complete.bash"),
        Example("... then source it from ~/.bashrc", "source ./physsim-complete.bash"),
        Example("zsh: put the file into a folder of $fpath", "physsim completion zsh > _physsim"),
        Example(
            "fish: put the file into ~/.config/fish/completions", "physsim completion fish > physsim.fish"
        ),
    ],
)
@click.argument("shell", metavar="SHELL", type=click.Choice(SHELLS))
@debug_option
@click.pass_context
def command(ctx: click.Context, shell: str) -> None:
    """Print the shell completion script for SHELL."""
    completer = get_completion_class(shell)
    assert completer is not None
    script = completer(ctx.find_root().command, {}, "physsim", "_PHYSSIM_COMPLETE")
    output.result(script.source().strip())

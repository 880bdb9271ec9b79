"""Every command with its arguments, options, exit codes and examples, from the commands themselves."""

from __future__ import annotations

import inspect

import click

from physsim.cli.app import VERBS, group
from physsim.cli.verb import EXIT_CODES, Verb


def as_markdown() -> str:
    """One section per verb."""
    return "\n".join(section(name) for name in VERBS)


def section(name: str) -> str:
    """The manual page of one verb."""
    verb = group.get_command(click.Context(group), name)
    assert isinstance(verb, Verb)
    usage = " ".join(f"[{argument}]" if not required else argument for argument, required in arguments(verb))
    lines = [f"## {name}", "", f"`physsim {name} [OPTIONS] {usage}`".replace(" `", "`"), "", prose(verb), ""]
    rows = [(f"`{argument}`", says) for argument, says in verb.arguments] + options(verb)
    lines += [
        "| argument or option | meaning |",
        "|---|---|",
        *(f"| {term} | {says} |" for term, says in rows),
        "",
    ]
    lines += ["Exit status: " + "; ".join(f"**{code}** {EXIT_CODES[code]}" for code in verb.exits) + ".", ""]
    for example in verb.examples:
        lines += [f"*{example.says[0].upper()}{example.says[1:]}*", "", "```bash", example.command, "```", ""]
    return "\n".join(lines)


def arguments(verb: Verb) -> list[tuple[str, bool]]:
    """Name and whether it must be there."""
    required = [parameter.required for parameter in verb.params if isinstance(parameter, click.Argument)]
    return [(name, needed) for (name, _), needed in zip(verb.arguments, required, strict=True)]


def options(verb: Verb) -> list[tuple[str, str]]:
    """Spelling and help of each option."""
    found = []
    for parameter in verb.params:
        if isinstance(parameter, click.Option):
            value = f" {parameter.metavar}" if parameter.metavar else ""
            found.append((f"`{', '.join(parameter.opts)}{value}`", str(parameter.help)))
    return found


def prose(verb: Verb) -> str:
    """The help text; click marks paragraphs that keep their lines with a backspace character."""
    paragraphs = inspect.cleandoc(verb.help or "").split("\n\n")
    return "\n\n".join(
        "```text\n" + inspect.cleandoc(paragraph.removeprefix("\b\n")) + "\n```"
        if paragraph.startswith("\b")
        else paragraph
        for paragraph in paragraphs
    )

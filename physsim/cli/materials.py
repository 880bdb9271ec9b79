"""`physsim materials`: the built-in library, with a source for each number."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from itertools import combinations
from typing import TYPE_CHECKING, Any

import click
from click.shell_completion import CompletionItem

from physsim.cli import output
from physsim.cli.table import number, table
from physsim.cli.verb import Example, Verb, debug_option, json_option
from physsim.materials import NUMBERS, library, resolve_pair

if TYPE_CHECKING:
    from physsim.materials import ResolvedPair
    from physsim.materials.library import Material, Number, Pair

UNITS = {"density": " kg/m^3"}


def complete_name(_: click.Context, __: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """Names of the library that begin as typed, for the shell."""
    return [CompletionItem(name) for name in sorted(library.material_names()) if name.startswith(incomplete)]


@click.command(
    cls=Verb,
    exits=(0, 2),
    arguments=[
        ("NAME...", "none: the whole library; one: its numbers and sources; more: what holds between them")
    ],
    examples=[
        Example("the whole library", "physsim materials"),
        Example("every number of steel, its range and its source", "physsim materials steel"),
        Example("what holds between two materials, and why", "physsim materials steel rubber"),
    ],
)
@click.argument("names", metavar="NAME...", nargs=-1, shell_complete=complete_name)
@json_option
@debug_option
def command(names: tuple[str, ...], as_json: bool) -> None:
    """List the built-in materials, show one, or show the pair of two.

    Restitution and friction belong to a pair of materials. A scene looks them up in its own `pairs`, then in
    the library's pairs, and then mixes the numbers of the two materials by its `mixing` rule. The pairs shown
    here are those of a scene that declares nothing: `physsim info SCENE` shows the pairs of a scene.
    """
    known = [found(name) for name in names]
    if not known:
        show_library(as_json)
    elif len(known) == 1:
        show_material(known[0], as_json)
    else:
        show_pairs([material.name for material in known], as_json)


def found(name: str) -> Material:
    """The material of that name; click.BadParameter, with the nearest name, when there is none."""
    try:
        return library.material(name)
    except KeyError as error:
        raise click.BadParameter(str(error.args[0]), param_hint="NAME") from None


def show_library(as_json: bool) -> None:
    """Every material in one line, then every pair."""
    materials = [library.material(name) for name in sorted(library.material_names())]
    if as_json:
        output.document(
            "materials",
            0,
            materials=[asdict(material) for material in materials],
            pairs=[asdict(pair) for pair in library.pairs()],
        )
        return
    output.result(
        table(
            ("material", "density", *NUMBERS, "notes"),
            [material_row(material) for material in materials],
            right=(1, 2, 3, 4),
        )
    )
    output.result("")
    output.result(table(("pair", *NUMBERS), [pair_row(pair) for pair in library.pairs()], right=(1, 2, 3)))
    output.message(
        "\nDensity in kg/m^3. Sources: physsim materials NAME. Between two: physsim materials NAME NAME."
    )


def show_material(material: Material, as_json: bool) -> None:
    """Every number of one material with its range, conditions and sources; then its pairs."""
    pairs = [pair for pair in library.pairs() if material.name in pair.between]
    if as_json:
        output.document("materials", 0, materials=[asdict(material)], pairs=[asdict(pair) for pair in pairs])
        return
    output.result(click.style(material.name, bold=True) + f": {material.notes}")
    for name in ("density", *NUMBERS):
        output.result(number_lines(name, getattr(material, name)))
    for pair in pairs:
        output.result(
            click.style(f"\n{' - '.join(pair.between)}", bold=True)
            + (f": {pair.notes}" if pair.notes else "")
        )
        for name in NUMBERS:
            if getattr(pair, name) is not None:
                output.result(number_lines(name, getattr(pair, name)))


def show_pairs(names: Sequence[str], as_json: bool) -> None:
    """What holds between each two of the names in a scene that declares nothing."""
    resolved = [resolve(a, b) for a, b in combinations(names, 2)]
    if as_json:
        output.document("materials", 0, pairs=[resolved_data(pair) for pair in resolved])
        return
    for pair in resolved:
        output.result(click.style(" - ".join(pair.between), bold=True))
        for name in NUMBERS:
            known = getattr(pair, name)
            output.result(f"  {name}: {number(known.value)}\n    {known.source}")
        if pair.assumed:
            output.message(pair.hint)


def resolve(a: str, b: str) -> ResolvedPair:
    """The pair under the scene language's default mixing rules."""
    from physsim.scene.spec.materials import MixingSpec

    return resolve_pair(a, b, {}, (), MixingSpec())


def material_row(material: Material) -> list[str]:
    """One line of the list."""
    return [
        material.name,
        *(shown(getattr(material, name)) for name in ("density", *NUMBERS)),
        material.notes,
    ]


def pair_row(pair: Pair) -> list[str]:
    """One line of the list of pairs."""
    return [" - ".join(pair.between), *(shown(getattr(pair, name)) for name in NUMBERS)]


def shown(value: Number | None) -> str:
    """The bare value."""
    return number(value.value if value else None)


def number_lines(name: str, value: Number | None) -> str:
    """`restitution: 0.6 (0.5 to 0.8)` and below it the conditions and sources."""
    if value is None:
        return f"  {name}: not known"
    spread = f" ({value.low:g} to {value.high:g})" if value.low != value.high else ""
    below = [value.conditions] if value.conditions else []
    return "\n    ".join([f"  {name}: {value.value:g}{UNITS.get(name, '')}{spread}", *below, *value.sources])


def resolved_data(pair: ResolvedPair) -> dict[str, Any]:
    """A resolved pair for the JSON document: each number with its source."""
    numbers = {
        name: {"value": getattr(pair, name).value, "source": getattr(pair, name).source} for name in NUMBERS
    }
    return {"between": list(pair.between), **numbers, "assumed": list(pair.assumed)}

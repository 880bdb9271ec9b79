"""The library of materials and pairs as tables, each number with its range and its source."""

from __future__ import annotations

from physsim.materials import NUMBERS, library
from physsim.materials.library import Material, Number, Pair


def as_markdown() -> str:
    """Materials, pairs, and the numbered list of sources."""
    sources = numbered_sources()
    materials = [library.material(name) for name in sorted(library.material_names())]
    words = [name.replace("_", " ") for name in NUMBERS]
    lines = ["## Materials", "", head(["material", "density [kg/m³]", *words, "notes"])]
    lines += [material_row(material, sources) for material in materials]
    lines += ["", "## Pairs", "", head(["pair", *words, "conditions"])]
    lines += [pair_row(pair, sources) for pair in library.pairs()]
    lines += ["", "## Sources", "", *(f"{number}. {source}" for source, number in sources.items())]
    return "\n".join(lines)


def numbered_sources() -> dict[str, int]:
    """Every citation with its number, in the order in which the tables name them."""
    found: dict[str, int] = {}
    for row in (*(library.material(name) for name in sorted(library.material_names())), *library.pairs()):
        for value in numbers(row):
            for source in value.sources:
                found.setdefault(source, len(found) + 1)
    return found


def numbers(row: Material | Pair) -> list[Number]:
    """The numbers of a row that are known."""
    values = [getattr(row, name, None) for name in ("density", *NUMBERS)]
    return [value for value in values if value is not None]


def material_row(material: Material, sources: dict[str, int]) -> str:
    """One line of the first table."""
    cells = [cell(getattr(material, name), sources) for name in ("density", *NUMBERS)]
    return line([f"`{material.name}`", *cells, material.notes])


def pair_row(pair: Pair, sources: dict[str, int]) -> str:
    """One line of the second table."""
    conditions = dict.fromkeys(value.conditions for value in numbers(pair) if value.conditions)
    told = "; ".join([*([pair.notes] if pair.notes else []), *conditions])
    return line(
        [
            " - ".join(f"`{name}`" for name in pair.between),
            *(cell(getattr(pair, n), sources) for n in NUMBERS),
            told,
        ]
    )


def cell(value: Number | None, sources: dict[str, int]) -> str:
    """`0.6 (0.5 to 0.8) [3, 7]`; a dash for what no source gives."""
    if value is None:
        return "-"
    spread = f" ({value.low:g} to {value.high:g})" if value.low != value.high else ""
    cited = ", ".join(str(sources[source]) for source in value.sources)
    return f"{value.value:g}{spread} [{cited}]"


def head(cells: list[str]) -> str:
    """The head of a table and the rule below it."""
    return line(cells) + "\n" + line(["---"] * len(cells))


def line(cells: list[str]) -> str:
    """One line of a table; a bar in a text would end its cell."""
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"

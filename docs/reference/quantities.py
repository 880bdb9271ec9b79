"""Every quantity that expectations and plots can name, from the tables that read their names."""

from __future__ import annotations

from physsim.scene.quantity import NAMED_FIELDS, SCENE_FIELDS, Described
from physsim.scene.spec import kinds


def as_markdown() -> str:
    """One line for each field."""
    rows = ["| quantity | unit | parts |", "|---|---|---|", "| `time` | s |  |"]
    for group, fields in NAMED_FIELDS.items():
        rows += [row(f"{group}.NAME.{name}", described) for name, described in fields.items()]
    for group, fields in SCENE_FIELDS.items():
        rows += [row(f"{group}.{name}", described) for name, described in fields.items()]
    return "\n".join(rows)


def row(name: str, described: Described) -> str:
    """The name, its unit, and the parts of a vector."""
    kind, components = described
    unit = "rad or m" if kind is kinds.COORDINATE else kind.unit
    return f"| `{name}` | {unit} | {' '.join(f'`.{part}`' for part in components)} |"

"""What the language has and this version refuses, from the table that refuses it."""

from __future__ import annotations

from physsim.scene.not_yet import NOT_YET


def as_markdown() -> str:
    """One line for each feature."""
    lines = ["| key | not supported yet | what works |", "|---|---|---|"]
    for row in NOT_YET:
        works = ", ".join(f"`{value:g}`" if isinstance(value, float) else f"`{value}`" for value in row.works)
        lines.append(f"| `{'.'.join(row.path)}` | {row.feature} | {works} |")
    return "\n".join(lines)

"""Broken scenes with a mark: » stands before the character that the caret must point at."""

from __future__ import annotations

from pathlib import Path

import pytest

from physsim.errors import SceneError
from physsim.scene import format_problems, load_scene_text


def marked(text: str) -> tuple[str, tuple[int, int]]:
    """The text without its mark, and the line and column of the mark."""
    before = text[: text.index("»")]
    return text.replace("»", ""), (before.count("\n") + 1, len(before) - before.rfind("\n"))


def assert_told(marked_text: str, expected: str, folder: Path) -> None:
    """The scene has exactly this one mistake, told at its mark, with its line and the caret."""
    text, (line, column) = marked(marked_text)
    with pytest.raises(SceneError) as caught:
        load_scene_text(text, name="s.yaml", folder=folder)
    assert caught.value.exit_code == 2
    source = text.split("\n")[line - 1]
    excerpt = f"{line:>5} | {source}\n      | {' ' * (column - 1)}^"
    assert (
        format_problems(caught.value.problems, "s.yaml") == f"s.yaml:{line}:{column}: {expected}\n{excerpt}"
    )

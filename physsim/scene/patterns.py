"""Patterns of `no_contact` and `forces`: a name in which `*` stands for any characters, none included."""

from __future__ import annotations


def matches(pattern: str, name: str) -> bool:
    """Whether the whole name fits the pattern. Each piece is sought once, from the left: linear time."""
    first, *rest = pattern.split("*")
    if not rest:
        return pattern == name
    last = rest.pop()
    if len(name) < len(first) + len(last) or not name.startswith(first) or not name.endswith(last):
        return False
    at, end = len(first), len(name) - len(last)
    for piece in rest:
        found = name.find(piece, at, end)
        if found < 0:
            return False
        at = found + len(piece)
    return True

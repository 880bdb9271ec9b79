"""What a plain (unquoted) YAML scalar means: YAML 1.2, core schema (section 10.3.2 of the specification).

So `1e-3` is a number and `no`, `on`, `12:30` and `2026-01-01` are words, unlike in YAML 1.1.
"""

from __future__ import annotations

import re

MAX_DIGITS = 20
_WORDS: dict[str, bool | None] = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL"), None),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
}
_INT = re.compile(r"[-+]?[0-9]+\Z")
_FLOAT = re.compile(r"[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?\Z")
_OTHER_BASE = re.compile(r"0o[0-7]+\Z|0x[0-9a-fA-F]+\Z")
_NOT_FINITE = re.compile(r"[-+]?\.(?:inf|Inf|INF)\Z|\.(?:nan|NaN|NAN)\Z")


def meaning(text: str) -> bool | int | float | str | None:
    """The value of a plain scalar. Raises ValueError for integers of more digits than any quantity has."""
    if text in _WORDS:
        return _WORDS[text]
    return _number(text) if text[0].isdigit() or text[0] in "+-." else text


def _number(text: str) -> int | float | str:
    if _INT.match(text):
        return int(_bounded(text))
    if _FLOAT.match(text):
        return float(text)
    if _OTHER_BASE.match(text):
        return int(_bounded(text), 0)
    return float(text.replace(".", "", 1)) if _NOT_FINITE.match(text) else text


def _bounded(text: str) -> str:
    if len(text) > MAX_DIGITS + 2:
        raise ValueError(f"is an integer of more than {MAX_DIGITS} digits")
    return text

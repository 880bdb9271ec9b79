"""The likely slip: which known word comes nearest to what was written."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

MAX_WORD = 60
MAX_WORDS = 2000


def nearest(word: str, known: Iterable[str]) -> str | None:
    """The known word nearest to `word`, None when none is near; long words are not compared."""
    if len(word) > MAX_WORD:
        return None
    candidates = [name for _, name in zip(range(MAX_WORDS), known, strict=False) if len(name) <= MAX_WORD]
    lowered = {name.lower(): name for name in candidates}
    near = get_close_matches(word.lower(), lowered, n=1, cutoff=0.6)
    return lowered[near[0]] if near else None


def did_you_mean(word: str, known: Iterable[str]) -> str | None:
    """The hint `did you mean 'radius'?`, None when nothing is near."""
    near = nearest(word, known)
    return f"did you mean '{near}'?" if near is not None else None

"""`python -m physsim` is `physsim`."""

from __future__ import annotations

from physsim.cli import main

main()

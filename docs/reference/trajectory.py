"""Every dataset of the trajectory file, from the table that the writer uses."""

from __future__ import annotations

from physsim.recording.layout import as_markdown

__all__ = ["as_markdown"]

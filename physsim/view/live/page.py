"""The page of a run that is watched: that of a trajectory, with a stream in place of all that moves.

When the run is over and pages have not seen every frame, they are sent the page of the whole trajectory, and
take from it what they lack.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import physsim
from physsim.errors import FileTrouble
from physsim.recording import open_trajectory
from physsim.recording.column import FIXED_AXES
from physsim.recording.layout import EVERYTHING
from physsim.view.live.wire import Message, encoded
from physsim.view.page.head import still_part
from physsim.view.page.page import assembled, page_of
from physsim.view.page.sections import Sections
from physsim.view.stage import staged

_UNIT = "_unit"
_EXACT = "Numbers are those of the file, bit for bit."
_SAMPLED = "Frames are those that were the newest when they were sent; all come at the end, if they fit."


def live_page(begin: Message) -> bytes:
    """The page for the message that begins a run. Raises ValueError when its parts do not fit together."""
    facts, texts = begin.facts, begin.facts["texts"]
    file = Path(facts["file"])

    def value(path: str) -> Any:
        return texts.get(path, begin.arrays.get(path))

    sections = Sections()
    head = {
        "about": {
            "title": facts["title"],
            "file": file.name,
            "status": "running",
            "detail": "",
            "physsim_version": physsim.__version__,
            "frames_in_file": 0,
            "notes": [_EXACT, _SAMPLED],
        },
        **still_part(staged(facts["title"], value), sections),
        "units": {path.removesuffix(_UNIT): some for path, some in texts.items() if path.endswith(_UNIT)},
        "live": {"frames": "frames", "duration": facts["duration"], "tracks": _tracks()},
        "sections": sections.heads,
    }
    return b"".join(assembled(facts["title"] or file.name, head, sections.data, "'self'"))


def whole_page(file: Path, frames: int) -> bytes:
    """A message with the page of the whole trajectory; nothing when the file cannot be shown, or is another
    one by now.
    """
    try:
        with open_trajectory(file) as trajectory:
            if trajectory.frames != frames:
                return b""
            page = b"".join(page_of(trajectory).parts)
    except FileTrouble:
        return b""
    return encoded(Message("whole", {}, {"page": np.frombuffer(page, np.uint8)}))


def _tracks() -> list[dict[str, Any]]:
    """Every dataset that a frame may have, with its unit and the numbers of a row."""
    return [
        {
            "name": column.path,
            "unit": "" if column.units == "1" else column.units,
            "components": len(FIXED_AXES.get(column.dims[-1], ("",))),
        }
        for column in EVERYTHING
        if column.grows_along == "time"
    ]

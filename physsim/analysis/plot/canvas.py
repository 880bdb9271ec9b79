"""A figure, and where it goes: a file of the format that its name says, or a window."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from physsim.errors import FileTrouble

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMATS = (".png", ".svg", ".pdf")
DPI = 150
_STYLE: dict[Any, Any] = {
    "svg.hashsalt": "physsim",
    "svg.fonttype": "none",
    "font.size": 9,
    "axes.titlesize": 9,
}


def check_target(path: Path | None) -> None:
    """Raises FileTrouble when there is no matplotlib, or the file's name has no known format."""
    try:
        import matplotlib  # noqa: F401, PLC0415, optional and slow to import
    except ImportError:
        raise FileTrouble("pictures need matplotlib: pip install 'physsim[plot]'") from None
    if path is not None and path.suffix.lower() not in FORMATS:
        raise FileTrouble(f"{path}: the name must end in {', '.join(FORMATS)}")


@contextmanager
def canvas(path: Path | None, title: str | None = None) -> Iterator[Figure]:
    """An empty figure, saved under `path` or shown in a window when the block ends well.

    The same drawing gives the same bytes of a file. Raises FileTrouble when the file cannot be written, or
    there is no display for a window.
    """
    import matplotlib as mpl  # noqa: PLC0415, optional and slow to import
    from matplotlib.figure import Figure  # noqa: PLC0415

    with mpl.rc_context(_STYLE):
        figure = Figure(layout="constrained") if path is not None else _window()
        if title:
            figure.suptitle(title, fontsize=10)
        yield figure
        if path is None:
            _show()
        else:
            _save(figure, path)


def _save(figure: Figure, path: Path) -> None:
    nothing: dict[str, dict[str, Any]] = {
        ".svg": {"Date": None},
        ".pdf": {"CreationDate": None},
        ".png": {"Software": None},
    }
    try:
        figure.savefig(path, dpi=DPI, metadata=nothing[path.suffix.lower()])
    except OSError as error:
        raise FileTrouble(f"{path}: cannot be written: {error.strerror or error}") from None


def _window() -> Figure:
    import matplotlib.pyplot as plt  # noqa: PLC0415, needs a display

    if plt.get_backend().lower() in {"agg", "pdf", "svg", "ps", "cairo", "template"}:
        raise FileTrouble("there is no display for a window; -o FILE.png draws into a file")
    return plt.figure(layout="constrained")


def _show() -> None:
    import matplotlib.pyplot as plt  # noqa: PLC0415, needs a display

    plt.show()

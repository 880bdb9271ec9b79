"""Tables of many runs: a metric over one parameter, or as a map over two."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from physsim.analysis.plot.curves import pretty
from physsim.errors import FileTrouble
from physsim.recording import NotInFile

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SIZE = (6.5, 4.2)
SUFFIXES = (".csv", ".parquet")


def read_table(path: Path) -> pandas.DataFrame:
    """A CSV or Parquet file. Raises FileTrouble when it cannot be read, or pandas is not there."""
    try:
        import pandas  # noqa: PLC0415, optional and slow to import
    except ImportError:
        raise FileTrouble(f"{path}: tables need pandas: pip install 'physsim[analysis]'") from None
    try:
        return pandas.read_parquet(path) if path.suffix == ".parquet" else pandas.read_csv(path)
    except FileNotFoundError:
        raise FileTrouble(f"{path}: there is no such file") from None
    except ImportError:
        raise FileTrouble(f"{path}: Parquet needs pyarrow: pip install 'physsim[parquet]'") from None
    except (OSError, ValueError) as error:
        raise FileTrouble(f"{path}: cannot be read as a table: {error}") from None


def units_beside(path: Path) -> dict[str, str]:
    """Units of the columns, from the manifest that a sweep leaves beside its table, if any."""
    try:
        told = json.loads(path.with_name("manifest.json").read_text(encoding="utf-8"))
        return {str(column["name"]): str(column["unit"]) for column in told["columns"]}
    except (OSError, ValueError, LookupError, TypeError, RecursionError):
        return {}


def draw_table(
    figure: Figure, table: pandas.DataFrame, columns: Sequence[str], units: Mapping[str, str] | None = None
) -> None:
    """columns: the metric, then one parameter (points, and the mean of equal ones) or two (a map).

    Rows in which one of them is no finite number are left out. Raises NotInFile for columns that are not
    there, or no numbers.
    """
    if len(columns) not in {2, 3}:
        raise NotInFile(
            "of a table a metric and one or two parameters are drawn: METRIC vs PARAMETER [PARAMETER]"
        )
    metric, *parameters = (_numbers(table, name) for name in columns)
    good = np.isfinite(np.stack([metric, *parameters])).all(axis=0)
    if not good.any():
        raise NotInFile(f"no row has numbers in all of {', '.join(columns)}")
    labels = [_label(name, units or {}) for name in columns]
    figure.set_size_inches(*SIZE)
    axes = figure.subplots()
    drawn = [values[good] for values in (metric, *parameters)]
    if len(parameters) == 1:
        _draw_curve(axes, drawn[1], drawn[0])
        axes.set(xlabel=labels[1], ylabel=labels[0])
    else:
        colors = _draw_map(axes, *drawn)
        figure.colorbar(colors, ax=axes, label=labels[0])
        axes.set(xlabel=labels[1], ylabel=labels[2])


def _label(name: str, units: Mapping[str, str]) -> str:
    unit = pretty(units.get(name, ""))
    return f"{name} [{unit}]" if unit not in {"", "1"} else name


def means(x: Any, y: Any) -> tuple[Any, Any, Any]:
    """Of the rows with equal x: x, the mean of y, and its standard deviation (0 for a single one)."""
    values, where = np.unique(x, return_inverse=True)
    count = np.bincount(where)
    mean = np.bincount(where, y) / count
    spread = np.bincount(where, (y - mean[where]) ** 2) / np.maximum(count - 1, 1)
    return values, mean, np.sqrt(spread)


def _draw_curve(axes: Axes, x: Any, y: Any) -> None:
    values, mean, spread = means(x, y)
    axes.plot(x, y, ".", color="C0", ms=4, alpha=0.6, label="runs")
    if len(values) < len(x):
        axes.errorbar(values, mean, spread, color="C1", lw=1.2, capsize=2, label="mean, standard deviation")
        axes.legend(frameon=False)
    axes.grid(alpha=0.25)


def _draw_map(axes: Axes, z: Any, x: Any, y: Any) -> Any:
    """A full grid as coloured fields (the mean of equal runs), anything else as coloured points."""
    across, up = np.unique(x), np.unique(y)
    cells, where = np.unique(np.stack([x, y]), axis=1, return_inverse=True)
    if len(across) < 2 or len(up) < 2 or cells.shape[1] != len(across) * len(up):
        return axes.scatter(x, y, c=z, s=18)
    mean = np.bincount(where.ravel(), z) / np.bincount(where.ravel())
    return axes.pcolormesh(across, up, mean.reshape(len(across), len(up)).T, shading="nearest")


def _numbers(table: pandas.DataFrame, name: str) -> Any:
    from difflib import get_close_matches  # noqa: PLC0415, only in trouble

    if name not in table:
        near = get_close_matches(name, [str(column) for column in table], n=1)
        hint = f"; did you mean {near[0]!r}?" if near else f"; there are {', '.join(map(str, table))}"
        raise NotInFile(f"the table has no column {name!r}{hint}")
    try:
        return table[name].to_numpy(dtype=np.float64, na_value=np.nan)
    except (TypeError, ValueError):
        raise NotInFile(f"the column {name!r} does not hold numbers") from None

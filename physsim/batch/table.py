"""The table of a sweep: one row per run, as CSV always and as Parquet where pyarrow is installed.

Columns: run, replicate, the varied values, the metrics, status, error, expectations_failed, file, wall_time.
All but wall_time are the same however, wherever and in whatever order the runs were done. Empty is what a
run has no value for because it did not complete; nan is a metric that has none (a contact that never was).
"""

from __future__ import annotations

import csv
import importlib.util
import io
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from physsim.batch.design import Design, Run
from physsim.batch.spec import SweepSpec
from physsim.batch.spec.metrics import CrossingMetric, ImpactsMetric
from physsim.batch.workshop import Result
from physsim.recording.whole_file import written

Role = Literal["identity", "input", "metric", "outcome"]
_TIMES = ("time_of_min", "time_of_max", "first_contact", "rest_time")
_UNITS = {"impacts": "1", "hardest_impact": "N*s", "energy_lost": "J", "expression": ""}


@dataclass(frozen=True)
class Column:
    """One column: kind is int, float or text; unit in SI as in scenes, "" for plain numbers and text."""

    name: str
    role: Role
    kind: Literal["int", "float", "text"]
    unit: str = ""


@dataclass(frozen=True)
class Table:
    """Rows of cells in the order of the columns; None where there is no value."""

    columns: tuple[Column, ...]
    rows: list[tuple[Any, ...]] = field(repr=False)

    def column(self, name: str) -> list[Any]:
        """The cells of one column. Raises KeyError."""
        for k, column in enumerate(self.columns):
            if column.name == name:
                return [row[k] for row in self.rows]
        raise KeyError(name)


def columns_of(design: Design) -> tuple[Column, ...]:
    """The columns of a sweep's table."""
    inputs = (
        Column(axis.path, "input", "float" if axis.is_number else "text", axis.unit)
        for axis in design.columns
    )
    metrics = (Column(name, "metric", "float", _unit(metric)) for name, metric in design.spec.metrics.items())
    return (
        Column("run", "identity", "int"),
        Column("replicate", "identity", "int"),
        *inputs,
        *metrics,
        Column("status", "outcome", "text"),
        Column("error", "outcome", "text"),
        Column("expectations_failed", "outcome", "int"),
        Column("file", "outcome", "text"),
        Column("wall_time", "outcome", "float", "s"),
    )


def table_of(design: Design, done: Iterable[tuple[Run, Result]]) -> Table:
    """The table of the runs that are done, in their order."""
    return Table(columns_of(design), [_row(design.spec, run, result) for run, result in done])


def _row(spec: SweepSpec, run: Run, result: Result) -> tuple[Any, ...]:
    return (
        run.number,
        run.replicate,
        *run.cells,
        *(result.metrics.get(name) for name in spec.metrics),
        result.status,
        result.error or None,
        result.expectations_failed,
        result.file or None,
        result.wall_time,
    )


def _unit(metric: Any) -> str:
    if metric.type in _TIMES or isinstance(metric, CrossingMetric):
        return "s"
    if hasattr(metric, "parsed") and not isinstance(metric, ImpactsMetric):
        return str(metric.parsed.kind.unit)
    return _UNITS.get(metric.type, "")


def write_tables(table: Table, folder: Path) -> list[Path]:
    """`table.csv`, and `table.parquet` when pyarrow is there. Each takes its name when it is whole."""
    files = [written(folder / "table.csv", as_csv(table).encode())]
    if importlib.util.find_spec("pyarrow") is not None:
        files.append(written(folder / "table.parquet", as_parquet(table)))
    return files


def as_csv(table: Table) -> str:
    """Comma-separated, a head line, every digit of every number."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([column.name for column in table.columns])
    writer.writerows([_shown(cell) for cell in row] for row in table.rows)
    return text.getvalue()


def _shown(cell: Any) -> str:
    if cell is None:
        return ""
    return repr(cell) if isinstance(cell, float) else str(cell)


def as_parquet(table: Table) -> bytes:
    """Parquet; every field says its role and its unit in its metadata."""
    import pyarrow as pa  # noqa: PLC0415, optional and slow to import
    import pyarrow.parquet as pq  # noqa: PLC0415

    kinds = {"int": pa.int64(), "float": pa.float64(), "text": pa.string()}
    fields = [
        pa.field(column.name, kinds[column.kind], metadata={"role": column.role, "unit": column.unit})
        for column in table.columns
    ]
    cells: Sequence[Sequence[Any]] = list(zip(*table.rows, strict=True)) or [()] * len(fields)
    arrays = [pa.array(list(part), field.type) for part, field in zip(cells, fields, strict=True)]
    sink = io.BytesIO()
    pq.write_table(pa.Table.from_arrays(arrays, schema=pa.schema(fields)), sink)
    return sink.getvalue()

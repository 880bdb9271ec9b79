"""Batches of rows into a file: CSV with the standard library, Parquet with pyarrow."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

import numpy as np

from physsim.analysis.export.rows import Batch, Units
from physsim.errors import FileTrouble
from physsim.recording.whole_file import check_name, whole_file

# Parquet is read fastest in groups of some ten thousand rows.
ROWS_PER_GROUP = 1 << 15


def check_writer(format: str, path: Path, *, force: bool) -> None:
    """Raises FileTrouble when the file is there already, or a package is missing that the format needs."""
    check_name(path, force=force)
    if format == "parquet":
        try:
            import pyarrow.parquet  # noqa: F401, PLC0415, optional and slow to import
        except ImportError:
            raise FileTrouble("Parquet needs pyarrow: pip install 'physsim[parquet]'") from None


def write(format: str, path: Path, batches: Iterable[Batch], units: Units) -> int:
    """Writes all rows and returns their number; the file takes its name when it is whole.

    format: a key of WRITERS. Raises FileTrouble when it cannot be written.
    """
    with whole_file(path) as part:
        return WRITERS[format](part, batches, units)


def _write_csv(path: Path, batches: Iterable[Batch], units: Units) -> int:
    """Numbers in the fewest digits that give the same bits back; a value that is no number stays empty."""
    count = 0
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        for batch in batches:
            if count == 0 and file.tell() == 0:
                writer.writerow(batch)
            rows = list(zip(*(_cells(column) for column in batch.values()), strict=True))
            writer.writerows(rows)
            count += len(rows)
    return count


def _cells(column: np.ndarray) -> list[object]:
    values: list[object] = column.tolist()
    if column.dtype.kind == "f" and not np.isfinite(column).all():
        return ["" if isinstance(value, float) and np.isnan(value) else value for value in values]
    return values


def _write_parquet(path: Path, batches: Iterable[Batch], units: Units) -> int:
    """Units stand in the metadata of the columns, under `units`."""
    import pyarrow  # noqa: PLC0415, optional and slow to import
    import pyarrow.parquet  # noqa: PLC0415

    writer, count = None, 0
    try:
        for batch in _gathered(batches):
            arrays = [pyarrow.array(_as_text_or_numbers(column)) for column in batch.values()]
            fields = [
                pyarrow.field(name, array.type, metadata={"units": units.get(name, "")})
                for name, array in zip(batch, arrays, strict=True)
            ]
            schema = pyarrow.schema(fields)
            writer = writer or pyarrow.parquet.ParquetWriter(path, schema, compression="zstd")
            writer.write_table(pyarrow.Table.from_arrays(arrays, schema=schema))
            count += len(arrays[0])
    finally:
        if writer is not None:
            writer.close()
    return count


def _as_text_or_numbers(column: np.ndarray) -> np.ndarray | list[object]:
    values: list[object] = column.tolist()
    return column if column.dtype.kind in "fiu" else values


def _gathered(batches: Iterable[Batch]) -> Iterator[Batch]:
    """The same rows in fewer, larger batches; at least one, so that an empty table has its columns."""
    waiting: list[Batch] = []
    given = False
    for batch in batches:
        waiting.append(batch)
        if sum(len(next(iter(each.values()))) for each in waiting) >= ROWS_PER_GROUP:
            yield _joined(waiting)
            waiting, given = [], True
    if waiting and (not given or any(len(next(iter(each.values()))) for each in waiting)):
        yield _joined(waiting)


def _joined(batches: list[Batch]) -> Batch:
    return {name: np.concatenate([batch[name] for batch in batches]) for name in batches[0]}


WRITERS: dict[str, Callable[[Path, Iterable[Batch], Units], int]] = {
    "csv": _write_csv,
    "parquet": _write_parquet,
}

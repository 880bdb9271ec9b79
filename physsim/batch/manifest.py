"""manifest.json: what was asked for, word by word, and with what it was done, to do it again."""

from __future__ import annotations

import json
import platform
import shlex
import sys
from collections import Counter
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import physsim
from physsim.batch.table import columns_of
from physsim.errors import FileTrouble
from physsim.recording.whole_file import written
from physsim.simulation.about import now, versions

if TYPE_CHECKING:
    from physsim.batch.job import Job
    from physsim.batch.load import Sweep
    from physsim.batch.workshop import Result

NAME = "manifest.json"
FORMAT, FORMAT_VERSION = "physsim-sweep", 1


def manifest_of(sweep: Sweep, job: Job, where: str) -> dict[str, Any]:
    """The manifest of a sweep that begins. where: `4 local workers`, or the address of the cluster."""
    design = sweep.design
    return {
        "format": FORMAT,
        "format_version": FORMAT_VERSION,
        "status": "running",
        "title": sweep.title,
        "sweep": {"file": sweep.name, "text": sweep.text, "resolved": _plain(sweep)},
        "scene": {"file": job.name, "text": job.text},
        "mesh_sha256": job.facts()["mesh_sha256"],
        "digest": job.digest,
        "facts": job.facts(),
        "seed": sweep.spec.seed,
        "runs": len(design),
        "columns": [asdict(column) for column in columns_of(design)],
        "physsim_version": physsim.__version__,
        "versions": versions(),
        "host": f"{platform.node()}, {platform.platform()}",
        "command": shlex.join(sys.argv),
        "where": where,
        "started": now(),
    }


def ended(manifest: dict[str, Any], status: str, results: list[Result], wall_time: float) -> dict[str, Any]:
    """The manifest of a sweep that has come to its end, or was interrupted. wall_time: of this call [s]."""
    counts = Counter(result.status for result in results)
    return {
        **manifest,
        "status": status,
        "finished": now(),
        "wall_time": wall_time,
        "done": len(results),
        "by_status": dict(sorted(counts.items())),
    }


def write(folder: Path, manifest: dict[str, Any]) -> None:
    """Raises FileTrouble."""
    text = json.dumps(manifest, indent=2, ensure_ascii=False) + "\n"
    written(folder / NAME, text.encode())


def read(folder: Path) -> dict[str, Any] | None:
    """The manifest in a folder, None when there is none. Raises FileTrouble when it cannot be read."""
    path = folder / NAME
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as error:
        raise FileTrouble(f"{path}: cannot be read: {error}") from None
    if not isinstance(found, dict) or found.get("format") != FORMAT:
        raise FileTrouble(f"{path}: is no manifest of a sweep")
    return found


def differing(before: dict[str, Any], job: Job) -> list[str]:
    """Which of the facts are not what they were."""
    old, new = before.get("facts", {}), job.facts()
    return [name for name in new if old.get(name) != new[name]]


def _plain(sweep: Sweep) -> dict[str, Any]:
    return sweep.spec.model_dump(mode="json", by_alias=True, exclude_defaults=True)

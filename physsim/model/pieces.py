"""Convex pieces of a concave mesh by CoACD (Wei et al., "Approximate Convex Decomposition for 3D Meshes with
Collision-Aware Concavity and Tree Search", ACM Trans. Graph. 41 (2022)), remembered between runs.

CoACD takes seconds to minutes and is native code fed with foreign meshes: it works in a process of its own,
with a time limit, and its answer is kept under the hash of mesh, parameters and version. The seed is fixed,
so that the same mesh gives the same pieces.
"""

from __future__ import annotations

import hashlib
import importlib.metadata
import importlib.util
import json
import logging
import os
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

import numpy as np

from physsim.model.polyhedron import IntArray
from physsim.model.rotation import FloatArray
from physsim.model.trouble import ShapeTrouble

THRESHOLD = 0.05
"""CoACD's concavity bound, relative to the mesh's size; 0.02 gives twice the pieces in twice the time."""

SEED = 0
TIME_LIMIT = 600.0
"""Seconds after which a decomposition is given up."""

log = logging.getLogger(__name__)


def convex_pieces(vertices: FloatArray, triangles: IntArray) -> list[FloatArray]:
    """Point sets (V_i, 3) whose convex hulls together stand for a closed mesh.

    Raises ShapeTrouble when CoACD is not installed, fails, or does not finish in `TIME_LIMIT` seconds.
    """
    kept = cache_file(vertices, triangles)
    known = _load(kept)
    if known is not None:
        return known
    _require_coacd()
    log.warning(
        "cutting a mesh of %d triangles into convex pieces (once; this can take minutes)", len(triangles)
    )
    started = time.perf_counter()
    pieces = _decompose(vertices, triangles)
    log.warning("cut into %d convex pieces in %.1f s", len(pieces), time.perf_counter() - started)
    _store(kept, pieces)
    return pieces


def cache_file(vertices: FloatArray, triangles: IntArray) -> Path:
    """Where the pieces of this mesh are kept: the user's cache folder (XDG_CACHE_HOME, LOCALAPPDATA)."""
    asked = {"threshold": THRESHOLD, "seed": SEED, "coacd": _version()}
    digest = hashlib.sha256(json.dumps(asked, sort_keys=True).encode())
    digest.update(np.ascontiguousarray(vertices).tobytes())
    digest.update(np.ascontiguousarray(triangles).tobytes())
    return _cache_folder() / f"{digest.hexdigest()}.npz"


def _cache_folder() -> Path:
    given = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA")
    return (Path(given) if given else Path.home() / ".cache") / "physsim" / "pieces"


def _version() -> str:
    try:
        return importlib.metadata.version("coacd")
    except importlib.metadata.PackageNotFoundError:
        return "none"


def _require_coacd() -> None:
    if importlib.util.find_spec("coacd") is None:
        raise ShapeTrouble(
            "needs CoACD, which is not installed",
            key="collision",
            given="pieces",
            hint="pip install coacd, or use collision: hull",
        )


def _decompose(vertices: FloatArray, triangles: IntArray) -> list[FloatArray]:
    with tempfile.TemporaryDirectory(prefix="physsim-") as folder:
        asked, answered = Path(folder) / "mesh.npz", Path(folder) / "pieces.npz"
        np.savez(asked, vertices=vertices, triangles=triangles)
        command = [sys.executable, "-P", "-m", "physsim.model.pieces", str(asked), str(answered)]
        try:
            done = subprocess.run(
                command, env=_environment(), capture_output=True, timeout=TIME_LIMIT, check=False
            )
        except subprocess.TimeoutExpired:
            raise ShapeTrouble(
                f"could not be cut into convex pieces in {TIME_LIMIT:g} s",
                key="collision",
                given="pieces",
                hint="simplify the mesh, or use collision: hull",
            ) from None
        pieces = _load(answered)
    if done.returncode != 0 or not pieces:
        raise ShapeTrouble(
            "could not be cut into convex pieces: CoACD failed on it",
            key="collision",
            given="pieces",
            hint="use collision: hull",
        )
    return pieces


def _environment() -> dict[str, str]:
    """Ours, with the folder of this package first: `-P` keeps the working directory out of the search."""
    here = str(Path(__file__).resolve().parents[2])
    return {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, [here, os.environ.get("PYTHONPATH")]))}


def _load(path: Path) -> list[FloatArray] | None:
    """The pieces in a file, or None when there is none or it is damaged."""
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as kept:
            return [
                np.asarray(kept[f"piece{i}"], dtype=np.float64).reshape(-1, 3) for i in range(len(kept.files))
            ]
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
        return None


def _store(path: Path, pieces: list[FloatArray]) -> None:
    """Written beside and renamed, so that two runs at once never see half a file; a full disk costs the
    cache only.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile(dir=path.parent, suffix=".npz", delete=False) as file:
            _save(Path(file.name), pieces)
        Path(file.name).replace(path)
    except OSError as error:
        log.warning("the pieces could not be kept in %s: %s", path.parent, error)


def _save(path: Path, pieces: list[FloatArray]) -> None:
    np.savez(path, **{f"piece{i}": piece for i, piece in enumerate(pieces)})  # type: ignore[arg-type]


def _work(asked: Path, answered: Path) -> None:
    """What the process of its own does."""
    import coacd  # noqa: PLC0415

    coacd.set_log_level("error")
    with np.load(asked, allow_pickle=False) as mesh:
        given = coacd.Mesh(mesh["vertices"], mesh["triangles"])
    parts = coacd.run_coacd(given, threshold=THRESHOLD, seed=SEED)
    _save(answered, [np.asarray(vertices, dtype=np.float64) for vertices, _ in parts])


if __name__ == "__main__":
    _work(Path(sys.argv[1]), Path(sys.argv[2]))

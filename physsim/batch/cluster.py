"""Workers of a Dask cluster that is there already.

The job (scene, meshes, metrics) is a task of its own, so that a worker that has lost it gets it again from
the scheduler; blocks refer to it. A worker that dies takes its blocks with it, and the scheduler gives them
to another one. Trajectories come back with the results: no file system needs to be shared.
"""

from __future__ import annotations

import pickle
import tempfile
import threading
import time
import uuid
from pathlib import Path
from queue import SimpleQueue
from typing import Any

from physsim.batch.backlog import Block
from physsim.batch.job import Job, unpack
from physsim.batch.place import Answer
from physsim.batch.workshop import Result, Workshop
from physsim.errors import PhyssimError

SECONDS_TO_CONNECT = 20
SECONDS_BETWEEN_COUNTS = 1.0


class ClusterPlace:
    """The workers behind a scheduler's address, `tcp://host:8786`."""

    def __init__(self, job: Job, address: str, answers: SimpleQueue[Answer]) -> None:
        self._client = _connected(address)
        self._answers = answers
        self._out: dict[str, Any] = {}
        self._counted, self._slots = 0.0, 0
        blob = pickle.dumps(job)
        self._job = self._client.submit(pickle.loads, blob, key=f"physsim-job-{uuid.uuid4()}")

    @property
    def slots(self) -> int:
        """Two blocks per thread of the cluster, so that no worker waits for the next one."""
        now = time.monotonic()
        if now - self._counted > SECONDS_BETWEEN_COUNTS:
            self._counted = now
            self._slots = max(1, 2 * sum(self._client.nthreads().values()))
        return self._slots

    def submit(self, block: Block) -> None:
        """The scheduler chooses the worker."""
        key = f"physsim-block-{uuid.uuid4()}"
        future = self._client.submit(work_on, self._job, block, key=key, pure=False)
        self._out[key] = future
        future.add_done_callback(lambda done: self._answers.put(self._answer(block, done)))

    def close(self) -> None:
        """Takes back what is out; what a worker has begun it ends, and nobody asks for it."""
        out, self._out = list(self._out.values()), {}
        self._client.cancel([*out, self._job], force=True)
        self._client.close()

    def _answer(self, block: Block, future: Any) -> Answer:
        from distributed.scheduler import KilledWorker  # noqa: PLC0415, optional and slow to import

        self._out.pop(future.key, None)
        try:
            results, files = future.result()
        except KilledWorker:
            return Answer(block, reason="its worker was lost again and again")
        except PhyssimError as error:
            return Answer(block, trouble=error)
        except Exception as error:
            told = f"{type(error).__name__}: {error}"
            return Answer(block, trouble=PhyssimError(f"the cluster cannot do the work: {told}"))
        return Answer(block, results, files=files)


def work_on(job: Job, block: Block) -> tuple[list[Result], dict[str, bytes]]:
    """What a worker of the cluster does: the results, and the content of the trajectories that were kept."""
    bench = _bench(job)
    results = [bench.workshop.do(task) for task in block]
    return results, {result.file: bench.fetch(result.file) for result in results if result.file}


class _Bench:
    """The workshop of a job on this worker, with a folder of its own that goes with the process."""

    def __init__(self, job: Job) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="physsim-sweep-")
        self._results = Path(self._folder.name) / "results"
        (self._results / "runs").mkdir(parents=True)
        scenes = unpack(job.meshes, Path(self._folder.name) / "scenes")
        self.workshop = Workshop(job, scenes, self._results)

    def fetch(self, file: str) -> bytes:
        """The content of a trajectory, which is gone afterwards."""
        path = self._results / file
        data = path.read_bytes()
        path.unlink()
        return data


_benches: dict[str, _Bench] = {}
_lock = threading.Lock()


def _bench(job: Job) -> _Bench:
    """Prepared once per process and job; the last one only is kept."""
    with _lock:
        if job.digest not in _benches:
            _benches.clear()
            _benches[job.digest] = _Bench(job)
        return _benches[job.digest]


def _connected(address: str) -> Any:
    try:
        import distributed  # noqa: PLC0415, optional and slow to import
    except ImportError:
        raise PhyssimError("--cluster needs Dask: pip install 'physsim[cluster]'") from None
    client: Any = distributed.Client
    try:
        return client(address, timeout=SECONDS_TO_CONNECT, set_as_default=False)
    except (OSError, TimeoutError, ValueError) as error:
        first = (str(error).splitlines() or [type(error).__name__])[0]
        raise PhyssimError(f"no Dask scheduler answers at {address}: {first}") from None

"""Libraries that share small work out over all processors, whose threads wait without sleeping, held back."""

from __future__ import annotations

import os

_NAMES = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")


def environment() -> dict[str, str]:
    """That of this process, with one thread for each library; what the user has set stays."""
    return {**dict.fromkeys(_NAMES, "1"), **os.environ}


def hold_back() -> None:
    """For this process, if numpy is not imported yet, and for those that it starts."""
    os.environ.update(environment())

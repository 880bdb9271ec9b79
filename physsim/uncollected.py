"""Work that makes many objects, all of which stay."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def uncollected() -> Iterator[None]:
    """No search for cyclic garbage meanwhile.

    The collector looks through all objects again whenever their number has grown by some part. While a scene
    of 10 000 bodies is read it finds nothing, and takes half of the time.
    """
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()


@contextmanager
def imported_for_good() -> Iterator[None]:
    """No search meanwhile, and later none in what is there by then: for a command that imports what it needs.

    Modules and classes stay to the end of the process, whose last search is through all of them once more.
    """
    with uncollected():
        yield
    if gc.get_freeze_count() == 0:
        gc.freeze()

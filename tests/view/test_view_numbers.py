"""What the page says of a body equals what the file says, to the error that the page itself states."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np
import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Page

Visit = Callable[..., "Page"]
CHANNELS = ("position", "orientation", "velocity", "angular_velocity")


def numbers_of(page: Page, body: str, time: float) -> dict[str, Any]:
    page.evaluate("([body, time]) => { physsim.select(body); physsim.seek(time) }", [body, time])
    found: dict[str, Any] = page.evaluate("window.physsim.state()")
    assert found["selected"] == body
    return found["numbers"]


@pytest.mark.parametrize("scene", ["balls", "offset", "machine"])
def test_numbers_of_every_body_equal_the_file(visit: Visit, show: Callable[[str], Any], scene: str) -> None:
    """At frames from the first to the last. Small pages hold 32-bit numbers: errors of 1e-9 of the range."""
    page = visit(scene)
    with h5py.File(show(scene).recording) as file:
        times = file["time"][:]
        for frame in np.linspace(0, len(times) - 1, 5).astype(int):
            for row, body in enumerate(file["body"].asstr()[:]):
                numbers = numbers_of(page, body, times[frame])
                for channel in CHANNELS:
                    column = file[channel][:, row]
                    off = np.abs(np.array(numbers[channel]) - column[frame])
                    stated = np.array(numbers["error"][channel])
                    assert (off <= stated).all(), (body, channel, frame, off, stated)
                    assert (stated <= 2.0**-33 * np.ptp(column, axis=0) + 2e-15 * np.abs(column).max()).all()
                assert numbers["mass"] == file["mass"][row]
                assert numbers["material"] == file["material"].asstr()[row]
                assert numbers["fixed"] == bool(file["fixed"][row])

"""The page in a real browser: it opens from a file without a word, plays, stops, steps, goes to a time."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import h5py
import pytest
from view_chromium import press, state, until

if TYPE_CHECKING:
    from playwright.sync_api import Page

Visit = Callable[..., "Page"]

END = 0.6
"""Of `balls`, in seconds; 61 frames, one every 10 ms."""


def slowly(page: Page) -> None:
    """So that a busy machine finds the page still playing: the run takes a minute then."""
    page.get_by_role("combobox", name="Speed").select_option("0.01")


@pytest.mark.parametrize("scene", ["balls", "offset", "machine"])
def test_a_page_opens_from_a_file_and_asks_for_nothing(visit: Visit, scene: str) -> None:
    """What it asked for and complained of is judged by `visit`; here it also plays and shows everything."""
    page = visit(scene)
    slowly(page)
    page.evaluate("window.physsim.play()")
    until(page, "window.physsim.state().time > 0.002")
    assert state(page)["playing"]


def test_time_goes_on_while_it_plays_and_stands_when_paused(visit: Visit) -> None:
    page = visit("balls")
    assert (state(page)["time"], state(page)["frame"], state(page)["playing"]) == (0, 0, False)
    slowly(page)
    press(page, "Play")
    until(page, "window.physsim.state().time > 0.002")
    press(page, "Pause")
    paused = state(page)
    page.wait_for_timeout(200)
    assert not paused["playing"]
    assert state(page)["time"] == paused["time"]


def test_it_stops_at_the_end_and_starts_over(visit: Visit) -> None:
    page = visit("balls")
    page.evaluate("window.physsim.seek(0.55)")
    press(page, "Play")
    until(page, "!window.physsim.state().playing")
    assert state(page)["time"] == pytest.approx(END, abs=1e-12)
    slowly(page)
    press(page, "Play")
    until(page, f"window.physsim.state().time < {END}")


def test_loop(visit: Visit) -> None:
    page = visit("balls")
    press(page, "Loop")
    page.evaluate("window.physsim.seek(0.5)")
    press(page, "Play")
    until(page, "window.physsim.state().time < 0.4")
    assert state(page)["playing"]


@pytest.mark.parametrize("time", [0.0, 0.25, 0.253, 0.6, 0.13])
def test_seek_shows_the_frame_at_or_before_a_time(visit: Visit, time: float) -> None:
    page = visit("balls")
    page.evaluate("time => window.physsim.seek(time)", time)
    assert state(page)["time"] == time
    assert state(page)["frame"] == int(time / 0.01 + 1e-9)


@pytest.mark.parametrize(("time", "kept"), [(-1, 0), (99, END)])
def test_times_outside_are_kept_inside(visit: Visit, time: float, kept: float) -> None:
    page = visit("balls")
    page.evaluate("time => window.physsim.seek(time)", time)
    assert state(page)["time"] == pytest.approx(kept, abs=1e-12)


def test_steps_go_from_frame_to_frame(visit: Visit, show: Callable[[str], Any]) -> None:
    with h5py.File(show("balls").recording) as file:
        times = file["time"][:]
    page = visit("balls")
    frames = []
    for n in (1, 1, 5, -2, -100, 1000, -1):
        page.evaluate("n => window.physsim.step(n)", n)
        frames.append((state(page)["frame"], state(page)["time"]))
    assert frames == [(k, times[k]) for k in (1, 2, 7, 5, 0, 60, 59)]


def test_a_step_from_between_two_frames_lands_on_a_frame(visit: Visit) -> None:
    page = visit("balls")
    for n, frame in ((1, 26), (-1, 25)):
        page.evaluate("window.physsim.seek(0.2534)")
        page.evaluate("n => window.physsim.step(n)", n)
        assert (state(page)["frame"], state(page)["time"]) == (frame, pytest.approx(frame / 100, abs=1e-12))


def test_buttons_step_and_go_to_the_ends(visit: Visit) -> None:
    page = visit("balls")
    seen = []
    for name in ("One frame forward", "One frame forward", "One frame back", "Last frame", "First frame"):
        press(page, name)
        seen.append(state(page)["frame"])
    assert seen == [1, 2, 1, 60, 0]


def test_the_slider_scrubs(visit: Visit) -> None:
    """A press in the middle of the slider goes to the middle of time; dragging goes on from there."""
    page = visit("balls")
    slider = page.get_by_role("slider", name="Time")
    box = slider.bounding_box()
    assert box is not None
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(*middle)
    page.mouse.down()
    # A thumb is about 16 pixels wide, the slider about 850: 2 % of the time.
    assert state(page)["time"] == pytest.approx(END / 2, abs=0.02 * END)
    page.mouse.move(middle[0] + box["width"] / 4, middle[1], steps=5)
    page.mouse.up()
    assert state(page)["time"] == pytest.approx(0.75 * END, abs=0.03 * END)
    assert not state(page)["playing"]


KEYS = [("ArrowRight", 1), ("ArrowRight", 2), ("ArrowLeft", 1), ("End", 60), ("Home", 0)]


def test_keys(visit: Visit) -> None:
    page = visit("balls")
    for key, frame in KEYS:
        page.keyboard.press(key)
        assert state(page)["frame"] == frame, key
    page.keyboard.press("Space")
    assert state(page)["playing"]
    page.keyboard.press("Space")
    assert not state(page)["playing"]


def test_speed(visit: Visit) -> None:
    """With a clock that only the test moves, a second at speed 0.2 is 0.2 s of the run."""
    page = visit("balls")
    page.get_by_role("combobox", name="Speed").select_option("0.2")
    assert state(page)["speed"] == 0.2
    page.clock.install(time=0)
    page.clock.pause_at(1_000_000)
    page.evaluate("window.physsim.play()")
    # The picture that was asked for before the clock stood still comes by the browser's own clock.
    while state(page)["time"] == 0:
        page.wait_for_timeout(20)
        page.clock.run_for(20)
    before = state(page)["time"]
    page.clock.run_for(1000)
    # A picture comes every 16 ms, so the two ends are uncertain by one each: 2 x 0.016 x 0.2 s.
    assert state(page)["time"] - before == pytest.approx(0.2, abs=0.0065)


def test_the_page_can_be_moved_anywhere(
    visit: Visit, show: Callable[[str], Any], tmp_path: Path, browser: Any
) -> None:
    """One file is all there is: a copy alone in a folder whose name needs escaping opens as well."""
    folder = tmp_path / "a folder #1 & ü%20"
    folder.mkdir()
    copy = folder / "shared.html"
    copy.write_bytes(show("balls").page.read_bytes())
    page = browser.new_page()
    page.goto(copy.as_uri())
    page.evaluate("window.physsim.ready")
    assert page.title().startswith("Three balls on a floor")
    page.close()

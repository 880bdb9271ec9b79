"""A run that is watched, in a real browser: the page grows with it, follows it, and knows how it ended."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from view_chromium import PATIENCE, Witness
from view_watcher import HeldUp, Offer, begun, offers

import physsim

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

HOSTILE = "<img src=x onerror=alert(1)></script>"
SCENE = """
physsim: 1
title: A ball falls on a floor
simulation: {duration: 400 ms, timestep: 1 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, 20 cm], velocity: [1, 0, 0]}
record: {every: 1 ms}
"""


@pytest.fixture
def offer() -> Iterator[Callable[..., Offer]]:
    with offers() as make:
        yield make


@pytest.fixture
def look(browser: Browser) -> Iterator[Callable[[str], Page]]:
    """Opens the page at an address, which asks for itself and its frames only, and complains of nothing."""
    contexts, witness, allowed = [], Witness(), []

    def go(address: str) -> Page:
        context = browser.new_context(viewport={"width": 900, "height": 600})
        contexts.append(context)
        context.set_default_timeout(PATIENCE)
        witness.watch(context)
        allowed.append(address)
        page = context.new_page()
        page.goto(address)
        page.evaluate("physsim.ready")
        return page

    yield go
    for context in contexts:
        context.close()
    # A browser writes down that a server is gone, whatever the page makes of it.
    assert [said for said in witness.complaints if "ERR_CONNECTION_REFUSED" not in said] == []
    (address,) = allowed
    assert [url for url in witness.requests if not url.startswith(address)] == []


def tell(offered: Offer, number: int) -> None:
    """A frame of the ball at a place of its own."""
    state = {
        "position": np.array([[0.1 * number, 0.0, 1.0]]),
        "orientation": np.array([[1.0, 0, 0, 0]]),
        "velocity": np.array([[1.0, 0, 0]]),
        "angular_velocity": np.zeros((1, 3)),
    }
    offered.feed.frame(number, 10 * number, 0.1 * number, state, None)


def wait(page: Page, condition: str) -> None:
    """Until a condition holds in the page, whose policy allows no `eval`, as Playwright would want it."""
    look = f"const look = () => {condition} ? done() : setTimeout(look, 20); look();"
    page.evaluate(f"new Promise((done) => {{ {look} }})")


def await_frames(page: Page, count: int) -> dict[str, Any]:
    """The page's state once it has so many frames and has shown them."""
    wait(page, f"physsim.state().frames === {count}")
    state: dict[str, Any] = page.evaluate("physsim.state()")
    return state


def pill(page: Page, text: str) -> None:
    """Waits until the pill says so."""
    wait(page, f"document.querySelector('.live-pill').textContent.includes({text!r})")


def test_the_page_follows_the_run_until_somebody_looks_back(offer, look) -> None:
    offered = offer()
    begun(offered.feed, body=[HOSTILE])
    tell(offered, 0)
    page = look(offered.address())
    pill(page, "Live, 0 %")
    for number in (1, 2):
        tell(offered, number)
        wait(page, f"physsim.state().time === {0.1 * number!r}")
        assert page.evaluate("physsim.state().frames") == number + 1
    page.evaluate("(physsim.pause(), physsim.seek(0.1))")
    pill(page, "Back to live")
    tell(offered, 3)
    assert await_frames(page, 4)["time"] == 0.1
    page.click(".live-pill")
    wait(page, f"physsim.state().time === {0.1 * 3!r}")
    pill(page, "Live, 30 %")
    tell(offered, 4)
    wait(page, "physsim.state().time === 0.4")
    page.evaluate("(name) => physsim.select(name)", HOSTILE)
    assert page.evaluate("physsim.state().numbers.position") == [0.4, 0.0, 1.0]
    assert page.locator("img").count() == 0
    offered.feed.end("failed", "it blew up")
    pill(page, "The run failed")
    wait(page, "!physsim.state().playing")
    page.evaluate("(physsim.seek(0), physsim.play())")
    wait(page, "physsim.state().time > 0.2")


def test_a_page_opened_again_has_what_came_before(offer, look) -> None:
    offered = offer()
    begun(offered.feed)
    tell(offered, 0)
    page = look(offered.address())
    tell(offered, 1)
    await_frames(page, 2)
    page.reload()
    page.evaluate("physsim.ready")
    assert await_frames(page, 2)["time"] == 0.1


def test_a_server_that_dies_leaves_what_there_is(offer, look) -> None:
    offered = offer()
    begun(offered.feed)
    tell(offered, 0)
    page = look(offered.address())
    tell(offered, 1)
    await_frames(page, 2)
    offered.feed._process.kill()
    pill(page, "connection to the run was lost")
    assert page.evaluate("physsim.state().frames") == 2


def test_at_the_end_the_page_has_the_whole_recording(offer, look, tmp_path: Path) -> None:
    (tmp_path / "scene.yaml").write_text(SCENE)
    offered, pages = offer(), []
    held_up = HeldUp(offered, lambda address: pages.append(look(address)))
    with physsim.run(tmp_path / "scene.yaml", output=tmp_path / "run.h5", onlooker=held_up) as trajectory:
        (page,) = pages
        pill(page, "The run is complete")
        await_frames(page, 401)
        wait(page, "!physsim.state().playing")
        page.evaluate("(physsim.select('ball'), physsim.seek(0.123))")
        state = page.evaluate("physsim.state()")
        ball = trajectory.body("ball")
        assert state["frame"] == 123
        for name in ("position", "velocity"):
            there = getattr(ball, name)[123]
            error = np.array(state["numbers"]["error"][name])
            assert (error < 1e-8).all()
            assert (np.abs(np.array(state["numbers"][name]) - there) <= error).all()

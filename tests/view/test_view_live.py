"""A run that is watched: what pages get is what the file has, and nothing that they do reaches the run."""

from __future__ import annotations

import socket
from collections.abc import Callable, Iterator
from pathlib import Path
from urllib.parse import urlsplit

import h5py
import numpy as np
import pytest
from view_watcher import PATIENCE, HeldUp, Offer, Watcher, begun, frames, get, messages, offers

import physsim
from physsim import open_trajectory
from physsim.view.live.wire import Message
from physsim.view.page.page import page_of

SCENE = """
physsim: 1
title: "<b>A ball</b> & more"
simulation: {duration: 400 ms, timestep: 1 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, 20 cm], velocity: [1, 0, 0]}
  brick:
    repeat: {count: [1, 1, 2], spacing: [0, 0, 7 cm]}
    shape: {type: box, size: [20 cm, 10 cm, 7 cm]}
    material: concrete
    position: [40 cm, 0, 35 mm]
  bob: {shape: {type: box, size: [5 cm, 5 cm, 5 cm]}, material: steel, position: [0, 1, 1]}
joints:
  hinge: {type: hinge, between: [world, bob], anchor: [0, 1, 1.5], axis: [0, 1, 0]}
springs:
  tether:
    {type: linear, between: [world, ball], anchors: [[0, 0, 1], [0, 0, 0]], rest_length: 0.5, stiffness: 10}
record: {every: 1 ms}
"""


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    path = tmp_path / "scene.yaml"
    path.write_text(SCENE, encoding="utf-8")
    return path


@pytest.fixture
def offer() -> Iterator[Callable[..., Offer]]:
    with offers() as make:
        yield make


def page_bytes(path: Path) -> bytes:
    """The page of a trajectory, as `physsim view` makes it."""
    with open_trajectory(path) as trajectory:
        return b"".join(page_of(trajectory).parts)


def assert_same_bits(message: Message, file: h5py.File) -> None:
    """The frame is the file's."""
    row = message.facts["frame"]
    assert (message.facts["step"], message.facts["time"]) == (file["step"][row], file["time"][row])
    first, last = file["contacts/offset"][row : row + 2]
    for path, array in message.arrays.items():
        there = file[path][first:last] if path.startswith("contacts/") else file[path][row]
        assert np.asarray(there, array.dtype).tobytes() == array.tobytes(), path


class TestWhatPagesGet:
    def test_frames_have_the_bits_of_the_file_and_first_and_last_are_there(
        self, scene: Path, tmp_path: Path, offer
    ) -> None:
        offered, watchers = offer(), []
        held_up = HeldUp(offered, lambda address: watchers.extend(Watcher(address) for _ in range(2)))
        physsim.run(scene, output=tmp_path / "run.h5", onlooker=held_up).close()
        offered.feed.close()
        for watcher in watchers:
            *seen, end, whole = watcher.wait()
            assert (end.kind, end.facts) == (
                "end",
                {"status": "complete", "detail": "ran to its end at 0.4 s", "frames": 401},
            )
            assert whole.arrays["page"].tobytes() == page_bytes(tmp_path / "run.h5")
            numbers = [message.facts["frame"] for message in seen]
            assert numbers == sorted(set(numbers))
            assert (numbers[0], numbers[-1]) == (0, 400)
            with h5py.File(tmp_path / "run.h5") as file:
                for message in seen:
                    assert_same_bits(message, file)
            assert {
                "position",
                "energy/residual",
                "joints/torque",
                "springs/length",
                "contacts/force",
            } <= {*seen[-1].arrays}
        assert offered.troubles == []

    def test_a_page_that_comes_late_or_comes_back_gets_what_it_has_not(self, offer) -> None:
        offered = offer()
        begun(offered.feed)
        address = offered.address()
        for number in range(3):
            offered.feed.frame(
                number, 10 * number, float(number), {"position": np.full((1, 3), number)}, None
            )
            stream = frames(address, number - 1)
            assert next(stream).facts == {"frame": number, "step": 10 * number, "time": number}
        offered.feed.end("failed", "it blew up")
        assert [message.facts.get("frame", message.kind) for message in frames(address)] == [0, 1, 2, "end"]
        assert [message.facts.get("frame", message.kind) for message in frames(address, 1)] == [2, "end"]

    def test_a_run_that_dies_has_an_end_too(self, offer) -> None:
        offered = offer()
        begun(offered.feed)
        with get(offered.address(), "frames?after=-1") as answer:  # the stream has begun
            offered.feed.close()
            (end,) = messages(answer)
        assert (end.kind, end.facts["status"]) == ("end", "failed")

    def test_the_page_stands_alone_but_for_its_frames(self, offer) -> None:
        offered = offer()
        begun(offered.feed, body=["<img src=x onerror=alert(1)></script>"])
        address = offered.address()
        with get(address) as answer:
            text = answer.read().decode()
        assert (answer.status, answer.headers["Content-Type"]) == (200, "text/html; charset=utf-8")
        assert "connect-src &#x27;self&#x27;" in text
        assert "default-src &#x27;none&#x27;" in text
        assert "<img" not in text
        assert "\\u003cimg src=x" in text
        assert "secret" not in text


class TestWhoIsLetIn:
    @pytest.fixture
    def address(self, offer) -> str:
        offered = offer()
        begun(offered.feed)
        return offered.address()

    @pytest.mark.parametrize("host", ["evil.example", "evil.example:80", "127.0.0.1", "127.0.0.1.evil", ""])
    @pytest.mark.parametrize("path", ["", "frames"])
    def test_other_host_names_are_refused(self, address: str, host: str, path: str) -> None:
        with get(address, path, Host=host) as answer:
            assert answer.status == 403
            assert answer.read() == b"403 Forbidden\n"

    def test_localhost_is_a_name_of_this_machine(self, address: str) -> None:
        with get(address, Host=f"localhost:{urlsplit(address).port}") as answer:
            assert answer.status == 200

    @pytest.mark.parametrize("path", ["/", "/favicon.ico", "/frames", "/guess/", "/guess/frames", "//"])
    def test_without_the_token_there_is_nothing(self, address: str, path: str) -> None:
        parts = urlsplit(address)
        with get(f"http://{parts.netloc}{path}") as answer:
            assert answer.status == 404

    @pytest.mark.parametrize("path", ["../", "frames/", "..%2f..%2fetc/passwd", "viewer.js"])
    def test_beside_the_page_there_is_nothing(self, address: str, path: str) -> None:
        with get(address, path) as answer:
            assert answer.status == 404

    def test_other_sites_cannot_read_it(self, address: str) -> None:
        with get(address, Origin="https://evil.example") as answer:
            assert not [name for name in answer.headers if name.lower().startswith("access-control")]
            assert answer.headers["Cross-Origin-Resource-Policy"] == "same-origin"
            assert answer.headers["X-Frame-Options"] == "DENY"

    def test_nothing_can_be_sent(self, address: str) -> None:
        parts = urlsplit(address)
        with socket.create_connection((parts.hostname, parts.port), PATIENCE) as line:
            line.sendall(f"POST {parts.path} HTTP/1.1\r\nHost: {parts.netloc}\r\n\r\n".encode())
            assert line.makefile("rb").readline().split()[1] == b"501"

    def test_nobody_else_on_the_network_can_connect(self, address: str) -> None:
        assert urlsplit(address).hostname == "127.0.0.1"

    def test_each_has_its_own_path(self, offer) -> None:
        paths = set()
        for _ in range(2):
            offered = offer()
            begun(offered.feed)
            paths.add(urlsplit(offered.address()).path)
        assert len(paths) == 2
        assert min(map(len, paths)) >= 22


class TestTheRunGoesOn:
    def test_a_reader_that_takes_nothing_holds_up_nobody(self, offer) -> None:
        offered = offer(expected=True)
        begun(offered.feed)
        address = offered.address()
        with get(address, "frames"):  # reads the head of the answer and no more
            watcher = Watcher(address)
            for number in range(40):
                offered.feed.frame(
                    number, 10 * number, float(number), {"position": np.zeros((50_000, 3))}, None
                )
                next(frames(address, number - 1))
            offered.feed.end("complete", "")
            assert [message.facts.get("frame") for message in watcher.wait()] == [*range(40), None]
        assert offered.troubles == []

    def test_browsers_that_leave_are_no_trouble(self, offer) -> None:
        offered = offer()
        begun(offered.feed)
        address = offered.address()
        for number in range(3):
            offered.feed.frame(number, 10 * number, float(number), {"position": np.zeros((50_000, 3))}, None)
            get(address, "frames").close()
        offered.feed.end("complete", "")
        assert [message.kind for message in frames(address)][-1] == "end"
        assert offered.troubles == []

    def test_a_server_that_dies_is_told_once(self, scene: Path, tmp_path: Path, offer) -> None:
        offered = offer()
        server = offered.feed._process
        held_up = HeldUp(offered, lambda _: (server.kill(), server.wait()))
        with physsim.run(scene, output=tmp_path / "run.h5", onlooker=held_up) as trajectory:
            assert (trajectory.status, trajectory.frames) == ("complete", 401)
        offered.feed.close()
        assert offered.troubles == ["the server of the page has ended"]

    def test_shapes_that_cannot_be_shown_are_told_and_no_trouble_for_the_run(self, offer) -> None:
        offered = offer()
        begun(offered.feed, geometry__kind=["tesseract"])
        offered.feed.frame(0, 0, 0.0, {"position": np.zeros((1, 3))}, None)
        offered.feed.end("complete", "")
        offered.feed.close()
        assert offered.troubles == ["the server of the page failed: no kind 'tesseract'"]

    def test_a_run_that_never_begins_needs_no_address(self, offer) -> None:
        offered = offer()
        offered.feed.close()
        assert offered.troubles == []
        assert offered.feed._process.returncode is not None

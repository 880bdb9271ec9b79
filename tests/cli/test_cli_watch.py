"""`physsim run --watch`: the page is there while the run computes, and changes nothing about the run."""

from __future__ import annotations

import json
import os
import pty
import re
import signal
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path

import pytest
from shell import PHYSSIM, deaf_to_ctrl_c, running

from physsim import open_trajectory
from physsim.view.live import process as live_process
from physsim.view.live.wire import Message, read

SCENE = """
physsim: 1
title: A ball falls freely
simulation: {duration: 200 ms, timestep: 1 ms}
bodies:
  ball: {shape: {type: sphere, radius: 5 cm}, material: steel, position: [0, 0, 1]}
expect:
  - {quantity: bodies.ball.position.z, at: 200 ms, value: 0.8038, within: 1 mm}
"""
ENDLESS = SCENE.replace("duration: 200 ms", "duration: 100000 s").partition("expect")[0]
ADDRESS = re.compile(r"watch it at (http://127\.0\.0\.1:(\d+)/[\w-]{22}/)\r?\n")
PATIENCE = 60
RUN = [*PHYSSIM, "run"]


@pytest.fixture(autouse=True)
def scenes(tmp_path: Path) -> None:
    (tmp_path / "fall.yaml").write_text(SCENE)
    (tmp_path / "endless.yaml").write_text(ENDLESS)


def stream(address: str) -> Iterator[Message]:
    """Frames as they come, and the end."""
    with urllib.request.urlopen(address + "frames", timeout=PATIENCE) as answer:
        while (got := read(answer)) is not None:
            if got[0].kind in {"frame", "end"}:
                yield got[0]


def is_gone(address: str) -> bool:
    """Whether nobody answers there."""
    try:
        urllib.request.urlopen(address, timeout=PATIENCE).close()
    except urllib.error.URLError as error:
        return isinstance(error.reason, ConnectionError)
    return False


def address_of(process: subprocess.Popen[str]) -> str:
    """The page's address, once it is told."""
    assert process.stderr is not None
    found = ADDRESS.fullmatch(process.stderr.readline())
    assert found
    return found[1]


class TestWhatIsSaid:
    def test_the_address_is_told_and_all_else_is_as_without(self, physsim, tmp_path: Path) -> None:
        said = physsim("run", "fall.yaml", "--watch")
        assert said.code == 0
        assert said.out.startswith("fall.h5: complete, ran to its end at 0.2 s\n21 frames, 200 steps in ")
        found = ADDRESS.fullmatch(said.err)
        assert found
        assert is_gone(found[1])
        with open_trajectory(tmp_path / "fall.h5") as trajectory:
            assert (trajectory.status, trajectory.frames) == ("complete", 21)

    def test_quiet_still_tells_the_address(self, physsim) -> None:
        said = physsim("run", "fall.yaml", "--watch", "--quiet")
        assert (said.code, said.out) == (0, "")
        assert ADDRESS.fullmatch(said.err)

    def test_json_is_alone_on_stdout(self, physsim) -> None:
        said = physsim("run", "fall.yaml", "--watch", "--json", "--quiet")
        assert (said.code, json.loads(said.out)["status"]) == (0, "complete")
        assert ADDRESS.fullmatch(said.err)

    def test_a_failed_expectation_is_exit_4(self, physsim) -> None:
        said = physsim("run", "fall.yaml", "--watch", "--set", "bodies.ball.position[2]=2 m")
        assert said.code == 4

    def test_a_broken_scene_has_no_page(self, physsim, tmp_path: Path) -> None:
        said = physsim("run", "fall.yaml", "--watch", "--set", "bodies.ball.mass=-1")
        assert said.code == 2
        assert "watch it" not in said.err
        assert not (tmp_path / "fall.h5").exists()

    def test_a_file_in_the_way_has_no_page(self, physsim, tmp_path: Path) -> None:
        (tmp_path / "fall.h5").write_bytes(b"precious")
        said = physsim("run", "fall.yaml", "--watch")
        assert said.code == 3
        assert "watch it" not in said.err

    def test_where_nothing_is_left_to_do_there_is_nothing_to_see(self, physsim) -> None:
        assert physsim("run", "fall.yaml").code == 0
        said = physsim("run", "fall.yaml", "--watch", "--resume")
        assert (said.code, said.err) == (0, "")

    def test_help_names_it(self, physsim) -> None:
        assert "--watch" in physsim("run", "--help").out


class TestPort:
    def test_the_one_that_is_asked_for(self, physsim) -> None:
        with socket.create_server(("127.0.0.1", 0)) as free:
            port = free.getsockname()[1]
        said = physsim("run", "fall.yaml", "--watch", "--port", str(port))
        found = ADDRESS.fullmatch(said.err)
        assert found
        assert int(found[2]) == port

    def test_one_that_is_taken_is_refused_before_anything_is_done(self, physsim, tmp_path: Path) -> None:
        with socket.create_server(("127.0.0.1", 0)) as taken:
            port = taken.getsockname()[1]
            said = physsim("run", "fall.yaml", "--watch", "--port", str(port))
        assert said.code == 2
        assert f"--port {port}: cannot be used: Address already in use." in said.err
        assert not (tmp_path / "fall.h5").exists()

    def test_without_a_page_it_has_no_meaning(self, physsim) -> None:
        said = physsim("run", "fall.yaml", "--port", "8000")
        assert said.code == 2
        assert "add --watch" in said.err

    @pytest.mark.parametrize("port", ["0", "65536", "http"])
    def test_it_is_a_port(self, physsim, port: str) -> None:
        assert physsim("run", "fall.yaml", "--watch", "--port", port).code == 2


class TestTroubles:
    def test_a_server_that_does_not_start(self, physsim, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(live_process, "MODULE", "physsim.view.no_such_module")
        said = physsim("run", "fall.yaml", "--watch")
        assert said.code == 0
        assert said.err == (
            "physsim: --watch: the server of the page did not start; the run goes on without it\n"
        )

    def test_an_interpreter_that_does_not_start(self, physsim, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(sys, "executable", "/no/such/python")
        said = physsim("run", "fall.yaml", "--watch")
        assert said.code == 0
        assert said.err == "physsim: --watch: No such file or directory; the run goes on without it\n"


class TestEnds:
    def test_ctrl_c_keeps_what_was_computed_and_pages_know(self, tmp_path: Path) -> None:
        with running([*RUN, "endless.yaml", "--watch", "--quiet"], tmp_path) as process:
            address = address_of(process)
            messages = stream(address)
            assert next(messages).kind == "frame"
            process.send_signal(signal.SIGINT)
            *_, last, end = messages
            _, said = process.communicate(timeout=PATIENCE)
        assert process.returncode == 130
        assert "stopped by SIGINT" in said
        assert (end.kind, end.facts["status"]) == ("end", "interrupted")
        assert is_gone(address)
        with open_trajectory(tmp_path / "endless.h5") as trajectory:
            assert trajectory.status == "interrupted"
            assert trajectory.frames == last.facts["frame"] + 1

    def test_it_goes_on_with_resume(self, tmp_path: Path) -> None:
        with running([*RUN, "fall.yaml", "--duration", "100 ms", "--set", "expect=[]"], tmp_path) as process:
            assert process.wait(PATIENCE) == 0
        command = [*RUN, "fall.yaml", "--resume", "--duration", "100000 s", "--watch"]
        with running(command, tmp_path) as process:
            assert next(stream(address_of(process))).facts["frame"] == 11
            process.send_signal(signal.SIGTERM)
            assert process.wait(PATIENCE) == 130

    def test_the_server_of_a_run_that_is_killed_leaves(self, tmp_path: Path) -> None:
        with running([*RUN, "endless.yaml", "--watch", "--quiet"], tmp_path) as process:
            address = address_of(process)
            messages = stream(address)
            next(messages)
            process.kill()
            *_, end = messages
        assert (end.kind, end.facts["status"]) == ("end", "failed")

    @pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
    def test_on_a_terminal_the_page_stays_until_ctrl_c(self, tmp_path: Path, number: signal.Signals) -> None:
        """Also where a shell has started it with SIGINT ignored."""
        master, slave = pty.openpty()
        command = deaf_to_ctrl_c([*RUN, "fall.yaml", "--watch"])
        silent = subprocess.DEVNULL
        with running(command, tmp_path, stdout=silent, stderr=slave, TERM="xterm-256color") as process:
            os.close(slave)
            seen = ""
            while "until Ctrl-C" not in seen:
                seen += os.read(master, 65536).decode()
            found = ADDRESS.search(seen)
            assert found
            *_, last, end = stream(found[1])
            process.send_signal(number)
            assert process.wait(PATIENCE) == 0
        os.close(master)
        assert (last.facts["frame"], end.facts["status"]) == (20, "complete")
        assert is_gone(found[1])


def test_a_browser_is_opened_where_there_is_a_display(tmp_path: Path) -> None:
    """The browser is a script that fetches the page and all frames, and says what it got."""
    browser = tmp_path / "browser.py"
    browser.write_text(
        "import sys, urllib.request as web\n"
        "page = web.urlopen(sys.argv[1]).read()\n"
        "frames = web.urlopen(sys.argv[1] + 'frames').read()\n"
        "open('seen.part', 'w').write(f'{sys.argv[1]} {page[:15].decode()} {b\"complete\" in frames}')\n"
        "import os; os.rename('seen.part', 'seen.txt')\n"
    )
    opening = f"{sys.executable} {browser} %s"
    command = [*RUN, "fall.yaml", "--watch", "--quiet"]
    with running(command, tmp_path, DISPLAY=":99", BROWSER=opening) as process:
        address = address_of(process)
        assert process.wait(PATIENCE) == 0
        for _ in range(600):
            if (tmp_path / "seen.txt").exists():
                break
            time.sleep(0.1)
    assert (tmp_path / "seen.txt").read_text() == f"{address} <!doctype html> True"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_served_page_ends_when_it_is_told_to(physsim, tmp_path: Path, number: signal.Signals) -> None:
    """Also where a shell has started it with SIGINT ignored."""
    assert physsim("run", "fall.yaml").code == 0
    with running(deaf_to_ctrl_c([*PHYSSIM, "view", "fall.h5", "--serve"]), tmp_path) as process:
        assert process.stdout is not None
        address = process.stdout.readline().strip()
        assert process.stderr is not None
        assert process.stderr.readline() == "The page stays until Ctrl-C.\n"
        assert not is_gone(address)
        process.send_signal(number)
        assert process.wait(PATIENCE) == 0
    assert is_gone(address)

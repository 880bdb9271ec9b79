"""The page as a file and as a server's answer: whole, closed to everything, refused where it must be."""

from __future__ import annotations

import base64
import hashlib
import http.client
import json
import re
import threading
from collections.abc import Iterator
from html.parser import HTMLParser
from importlib.resources import files
from pathlib import Path
from typing import Any

import h5py
import pytest
from view_unpacked import opened_page

from physsim import open_trajectory
from physsim.cli.app import answer
from physsim.view.loopback import HOST
from physsim.view.page.page import as_json, assembled, page_of
from physsim.view.page.serve import Server

SCENE = """
physsim: 1
title: "</title><script>alert(1)</script><img src=x onerror=alert(2)> {{script}} & 한글"
simulation: {duration: 100 ms, timestep: 1 ms}
materials:
  "--><script>alert(3)</script>":
    {density: 1000 kg/m^3, restitution: 0.5, static_friction: 0.5, kinetic_friction: 0.4}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  "<img src=x onerror=alert(4)>":
    shape: {type: sphere, radius: 5 cm}
    material: "--><script>alert(3)</script>"
    position: [0, 0, 20 cm]
"""


class Tags(HTMLParser):
    """What a browser makes of a page: its elements, the text of each kind, and the policy."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.names: list[str] = []
        self.texts: dict[str, list[str]] = {}
        self.policy = ""
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.names.append(tag)
        self.open.append(tag)
        self.texts.setdefault(tag, []).append("")
        if dict(attrs).get("http-equiv") == "Content-Security-Policy":
            self.policy = str(dict(attrs)["content"])

    def handle_endtag(self, tag: str) -> None:
        while self.open and self.open.pop() != tag:
            pass

    def handle_data(self, data: str) -> None:
        if self.open:
            self.texts[self.open[-1]][-1] += data


@pytest.fixture
def trajectory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The trajectory of a scene with hostile names; the folder it is in is the current one."""
    monkeypatch.chdir(tmp_path)
    Path("run.yaml").write_text(SCENE, encoding="utf-8")
    assert answer(["run", "run.yaml", "-o", "run.h5", "--quiet"]) == 0
    return Path("run.h5")


def view(*words: str) -> int:
    return answer(["view", "run.h5", *words])


def test_texts_of_a_scene_are_text_in_the_page(trajectory: Path) -> None:
    assert view() == 0
    tags = Tags(Path("run.html").read_text(encoding="utf-8"))
    with open_trajectory(trajectory) as known:
        title = known.title
        sections = len(opened_page(Path("run.html")).head["sections"])
    assert "{{script}}" in title
    assert tags.texts["title"] == [title]
    assert "img" not in tags.names
    assert tags.names.count("script") == 2 + sections
    head = opened_page(Path("run.html")).head
    assert head["about"]["title"] == title
    assert head["bodies"]["name"] == ["floor", "<img src=x onerror=alert(4)>"]
    assert head["bodies"]["material"]["words"] == ["concrete", "--><script>alert(3)</script>"]


def test_the_head_can_begin_and_end_no_tag() -> None:
    hostile = {"<script>": "</script><!--", "é\ud800\u2028": "&lt;"}
    text = as_json(hostile)
    assert not set("<>&") & set(text)
    assert json.loads(text) == hostile


def test_the_policy_allows_this_script_and_style_and_nothing_else(trajectory: Path) -> None:
    assert view() == 0
    tags = Tags(Path("run.html").read_text(encoding="utf-8"))
    rules = dict(rule.split(" ", 1) for rule in tags.policy.split("; "))
    hashes = {
        kind: base64.b64encode(hashlib.sha256(tags.texts[kind][-1].encode()).digest()).decode()
        for kind in ("script", "style")
    }
    assert rules == {
        "default-src": "'none'",
        "script-src": f"'sha256-{hashes['script']}'",
        "style-src": f"'sha256-{hashes['style']}'",
        "img-src": "data: blob:",
        "connect-src": "'none'",
        "base-uri": "'none'",
        "form-action": "'none'",
    }


def test_script_and_style_end_where_they_should() -> None:
    """Their own texts hold nothing that a browser takes for an end, or for the start of a comment."""
    for name, end in (("viewer.js", r"</script|<!--|\r"), ("viewer.css", r"</style|\r")):
        text = (files("physsim.view") / "assets" / name).read_text(encoding="utf-8")
        assert not re.search(end, text, re.IGNORECASE)


def test_half_a_surrogate_in_a_title_is_no_trouble() -> None:
    page = b"".join(assembled("\ud800 title", {}, []))
    assert "<title>? title</title>" in page.decode("utf-8")


def test_the_same_file_gives_the_same_page(trajectory: Path) -> None:
    assert view("-o", "a.html") == view("-o", "b.html") == 0
    assert answer(["export", "run.h5", "--to", "html", "-o", "c.html"]) == 0
    assert Path("a.html").read_bytes() == Path("b.html").read_bytes() == Path("c.html").read_bytes()


def test_an_old_page_stays_without_force(trajectory: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Path("run.html").write_text("old")
    assert view() == 3
    assert "run.html: exists already; --force" in capsys.readouterr().err
    assert Path("run.html").read_text() == "old"
    assert view("--force") == 0
    assert Path("run.html").stat().st_size > 100_000
    assert not list(Path().glob("*.part"))


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["--port", "80"], 2, "--port is for --serve"),
        (["--serve", "-o", "a.html"], 2, "--serve writes no file"),
        (["--max-size", "0"], 2, "--max-size"),
        (["--max-size", "0.1"], 3, "too few for a page; --max-size allows more"),
        (["-o", "nowhere/a.html"], 3, "folder nowhere does not exist"),
    ],
)
def test_what_cannot_be_done_is_said(
    trajectory: Path, capsys: pytest.CaptureFixture[str], words: list[str], code: int, said: str
) -> None:
    assert view(*words) == code
    assert said in " ".join(capsys.readouterr().err.split())
    assert not list(Path().glob("*.html*"))


def test_files_that_cannot_be_shown(trajectory: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert answer(["view", "none.h5"]) == 3
    assert answer(["view", "run.yaml"]) == 3
    with h5py.File(trajectory, "r+") as file:
        del file["geometry"]
    assert view() == 3
    assert (
        "was written before physsim kept shapes in its files; run the scene again" in capsys.readouterr().err
    )


def test_json_says_what_was_made(trajectory: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert view("--json") == 0
    said = json.loads(capsys.readouterr().out)
    assert said["output"] == "run.html"
    assert said["bytes"] == Path("run.html").stat().st_size
    assert said["page"]["bits"] == 32
    assert said["page"]["frames"] == said["page"]["frames_in_file"] == 11
    assert 0 < said["page"]["errors"]["position"] < 1e-10
    assert "32-bit" in said["notes"][0]


def test_pages_are_no_larger_than_wished(trajectory: Path) -> None:
    with open_trajectory(trajectory) as run:
        smallest = sum(map(len, assembled(run.title, {}, [])))
        for room in (25_000, 40_000, 100_000):
            page = page_of(run, smallest + room)
            assert page.size <= smallest + room
            assert page.size == sum(map(len, page.parts))


def test_a_run_that_has_hardly_begun(trajectory: Path) -> None:
    """A file that was killed while it was written has as many frames as its shortest dataset."""
    with h5py.File(trajectory, "r+") as file:
        file["velocity"].resize(1, axis=0)
        file.attrs["status"] = "running"
    assert view() == 0
    head = opened_page(Path("run.html")).head
    assert (head["frames"], head["about"]["status"]) == (1, "running")


@pytest.fixture
def server(trajectory: Path) -> Iterator[Server]:
    with open_trajectory(trajectory) as run:
        page = page_of(run)
    with Server(page) as running:
        thread = threading.Thread(target=running.serve_forever)
        thread.start()
        yield running
        running.shutdown()
        thread.join()


def asked(server: Server, path: str, host: str) -> tuple[int, bytes, Any]:
    connection = http.client.HTTPConnection(HOST, server.server_port, timeout=30)
    connection.putrequest("GET", path, skip_host=True)
    connection.putheader("Host", host.format(port=server.server_port))
    connection.endheaders()
    reply = connection.getresponse()
    body = reply.read()
    connection.close()
    return reply.status, body, reply.headers


def test_the_server_gives_the_page_and_nothing_else(server: Server) -> None:
    whole = b"".join(server.page.parts)
    for host in ("127.0.0.1:{port}", "localhost:{port}"):
        status, body, headers = asked(server, "/", host)
        assert (status, body) == (200, whole)
        assert headers["Content-Type"] == "text/html; charset=utf-8"
        assert headers["X-Content-Type-Options"] == "nosniff"
    assert asked(server, "/?t=1", "localhost:{port}")[0] == 200
    assert asked(server, "/run.h5", "localhost:{port}")[0] == 404
    assert asked(server, "/../run.h5", "localhost:{port}")[0] == 404


@pytest.mark.parametrize("host", ["evil.example", "evil.example:{port}", "localhost", "127.0.0.1:1", ""])
def test_the_server_answers_to_no_other_name(server: Server, host: str) -> None:
    """Another web site that lets its name point to this machine gets nothing (DNS rebinding)."""
    status, body, _ = asked(server, "/", host)
    assert (status, body) == (403, b"403 Forbidden\n")


def test_the_server_listens_on_this_machine_only(server: Server) -> None:
    assert server.server_address[0] == "127.0.0.1"


def test_a_port_that_is_taken(server: Server, trajectory: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert answer(["view", str(trajectory), "--serve", "--port", str(server.server_port)]) == 2
    assert "cannot be used" in capsys.readouterr().err

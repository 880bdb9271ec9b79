"""`physsim view`: a trajectory as one HTML page that plays it."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from physsim.cli import output, serving
from physsim.cli.verb import Example, Verb, debug_option, json_option

if TYPE_CHECKING:
    from physsim.view.page.page import Page

MEGABYTE = 1_000_000
MAX_SIZE = click.Option(
    ["--max-size"],
    type=click.FloatRange(min=0, min_open=True),
    default=24.0,
    metavar="MB",
    help="How large the page may be (default 24). To fit, numbers are kept less exactly, then only the "
    "strongest contacts, then fewer frames; what was done is said.",
)


@click.command(
    cls=Verb,
    arguments=[("FILE", "a trajectory (HDF5), also one whose run still goes on")],
    examples=[
        Example("one page that any browser plays, offline: my_scene.html", "physsim view my_scene.h5"),
        Example(
            "small enough for an e-mail, and how exact it still is",
            "physsim view my_scene.h5 -o mail.html --max-size 2 --json",
        ),
    ],
)
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "-o",
    "--output",
    "target",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Default: FILE's name with .html, here.",
)
@click.option("--force", is_flag=True, help="Replace an existing page.")
@click.option(
    "--serve",
    is_flag=True,
    help="Show the page to browsers of this machine until Ctrl-C; nothing is written.",
)
@click.option("--port", type=click.IntRange(0, 65535), metavar="N", help="With --serve. Default: a free one.")
@click.option("--open", "show", is_flag=True, help="Open the page in the browser.")
@json_option
@debug_option
def command(
    *,
    file: Path,
    target: Path | None,
    force: bool,
    serve: bool,
    port: int | None,
    show: bool,
    max_size: float,
    as_json: bool,
) -> None:
    """Make a page that plays a trajectory: one HTML file without a server, a network or anything beside it.

    It turns, zooms, plays, steps and follows bodies, shows the numbers of a body that is picked, contact
    forces, joints, springs and plots. Add #t=1.5 to its address to open it at that time.

    The file has all numbers in full; the page rounds them, and says by how much.
    """
    if serve and (target is not None or force):
        raise click.UsageError("--serve writes no file; leave out -o and --force, or --serve.")
    if port is not None and not serve:
        raise click.UsageError("--port is for --serve.")
    if serve:
        _serve(made(file, max_size), port or 0, show=show, as_json=as_json)
        return
    target = target or Path(f"{file.stem}.html")
    page = written(file, target, max_size, force=force)
    if as_json:
        output.document("view", 0, output=str(target), **facts(page))
    else:
        output.result(said(target, page))
    if show:
        _open(target.resolve().as_uri())


command.params.insert(-2, MAX_SIZE)


def written(file: Path, target: Path, max_size: float, *, force: bool) -> Page:
    """The page, and it is in the file `target`. max_size in MB. Raises FileTrouble."""
    from physsim.recording.whole_file import check_name
    from physsim.view.page.page import write_page

    check_name(target, force=force)
    page = made(file, max_size)
    write_page(page, target)
    return page


def made(file: Path, max_size: float) -> Page:
    """The page; on stderr what was left out. Raises FileTrouble."""
    from physsim.recording import open_trajectory
    from physsim.view.page.notes import left_out
    from physsim.view.page.page import page_of

    with open_trajectory(file) as trajectory:
        page = page_of(trajectory, int(max_size * MEGABYTE))
    for note in left_out(page.report):
        output.message(note)
    return page


def said(target: Path, page: Page) -> str:
    """One line: where it is, how large, how exact."""
    from physsim.recording.target import in_words

    report = page.report
    bodies = output.counted(report.bodies, "body", "bodies")
    frames = output.counted(report.frames, "frame", "frames")
    return f"{target}: {bodies}, {frames}, {in_words(page.size)}; {report.bits}-bit numbers"


def facts(page: Page) -> dict[str, Any]:
    """For a JSON document."""
    from physsim.view.page.notes import notes_of

    return {"bytes": page.size, "page": page.report.as_data(), "notes": notes_of(page.report)}


def _serve(page: Page, port: int, *, show: bool, as_json: bool) -> None:
    from physsim.view.page.serve import Server

    try:
        server = Server(page, port)
    except OSError as error:
        raise click.UsageError(f"--port {port}: cannot be used: {error.strerror}.") from error
    with server:
        if as_json:
            output.document("view", 0, address=server.address, **facts(page))
        else:
            output.result(server.address)
        if show:
            _open(server.address)
        serving.stay(server.serve_forever, told=not as_json)


def _open(address: str) -> None:
    import webbrowser

    if not webbrowser.open(address):
        output.message(f"no browser could be opened; open {address} in one")

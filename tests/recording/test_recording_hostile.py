"""Files that somebody else made, or broke: FileTrouble with one sentence, whatever is in them."""

from __future__ import annotations

import os
import random
import re
import resource
import signal
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import h5py
import made_up_run
import numpy as np
import pytest

from physsim.errors import FileTrouble
from physsim.recording import open_trajectory
from physsim.recording.heaps import broken_heap


def read_everything(path: Path) -> None:
    with open_trajectory(path) as trajectory:
        for name in trajectory.body_names[:3]:
            _ = trajectory.body(name).position[:]
        for name in ("position", "orientation", "velocity", "angular_velocity"):
            _ = getattr(trajectory, name)[:]
        for name in ("time", "step", "energy", "momentum", "solver", "events", "pairs", "provenance"):
            _ = getattr(trajectory, name)
        for name in ("mass", "inertia", "material", "fixed"):
            trajectory.values(name)
        trajectory.contacts()
        trajectory.checkpoint()


def refused(path: Path, words: str) -> None:
    with pytest.raises(FileTrouble, match=re.escape(words)) as caught:
        read_everything(path)
    assert str(caught.value).startswith(str(path))
    assert "\n" not in str(caught.value)


def test_missing_empty_folder_text(tmp_path: Path) -> None:
    refused(tmp_path / "none.h5", "no such file")
    refused(tmp_path, "is not a regular file")
    (tmp_path / "empty.h5").touch()
    refused(tmp_path / "empty.h5", "is empty")
    (tmp_path / "text.h5").write_text("physsim: 1\n")
    refused(tmp_path / "text.h5", "is not an HDF5 file")


def test_an_hdf5_file_of_another_kind(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "other.h5", "w") as file:
        file["data"] = [1, 2]
    refused(tmp_path / "other.h5", "is an HDF5 file, but not a physsim trajectory")


def test_a_truncated_file(recorded: Callable[..., Path]) -> None:
    path = recorded()
    path.write_bytes(path.read_bytes()[:-5000])
    refused(path, "truncated file")


@pytest.fixture
def edited(recorded: Callable[..., Path]) -> Callable[[Callable[[h5py.File], None]], Path]:
    def edit(change: Callable[[h5py.File], None]) -> Path:
        path = recorded()
        with h5py.File(path, "r+") as file:
            change(file)
        return path

    return edit


Edited = Callable[[Callable[[h5py.File], None]], Path]


def replaced(name: str, **options: object) -> Callable[[h5py.File], None]:
    def change(file: h5py.File) -> None:
        del file[name]
        file.create_dataset(name, **options)

    return change


def linked(name: str, link: object) -> Callable[[h5py.File], None]:
    def change(file: h5py.File) -> None:
        del file[name]
        file[name] = link

    return change


def attribute(name: str, value: object) -> Callable[[h5py.File], None]:
    return lambda file: file.attrs.__setitem__(name, value)


def group_instead(file: h5py.File) -> None:
    del file["mass"]
    file.create_group("mass")


def ragged_title(file: h5py.File) -> None:
    del file.attrs["title"]
    kind = h5py.h5t.vlen_create(h5py.h5t.NATIVE_INT64)
    h5py.h5a.create(file.id, b"title", kind, h5py.h5s.create(h5py.h5s.SCALAR))


HUGE = 1 << 40
CASES = {
    "newer version": (attribute("format_version", np.int64(2)), "has format version 2; this physsim reads"),
    "version is a text": (attribute("format_version", "1"), "format_version is not an integer"),
    "status unknown": (attribute("status", "fine"), "has the status 'fine'"),
    "title is a list": (attribute("title", np.arange(5)), "title is not a single value"),
    "title is a number": (attribute("title", 5), "title is not a text"),
    # Reading such an attribute crashes h5py 3.16 when its numbers are where a text was.
    "title is a series": (ragged_title, "title is neither a text nor an integer"),
    "a dataset is missing": (lambda file: file.__delitem__("velocity"), "has no dataset /velocity"),
    "half a group": (lambda file: file.__delitem__("energy/spring"), "/energy is not whole"),
    "a group in its place": (group_instead, "/mass: is not a dataset"),
    "external link": (linked("mass", h5py.ExternalLink("/etc/passwd", "/")), "/mass: is a link to elsewhere"),
    "soft link": (linked("mass", h5py.SoftLink("/inertia")), "/mass: is a link to elsewhere"),
    "linked group": (linked("energy", h5py.SoftLink("/momentum")), "is a link to elsewhere"),
    "wrong type": (replaced("mass", data=np.zeros(3, "f4")), "/mass: is of type float32 instead of f8"),
    "object references": (replaced("mass", shape=(3,), dtype=h5py.ref_dtype), "/mass: is of type object"),
    "wrong axes": (replaced("mass", data=np.zeros((3, 3))), "/mass: has 2 axes instead of 1"),
    "wrong length": (replaced("mass", data=np.zeros(4)), "/mass: has length 4 along body instead of 3"),
    "terabytes": (
        replaced("position", shape=(HUGE, 3, 3), chunks=(64, 3, 3), dtype="f8"),
        "/position: declares 79164837199872 bytes, more than the whole file can hold",
    ),
    "more bytes than 64 bits count": (
        replaced("position", shape=(1 << 62, 3, 3), maxshape=(None, 3, 3), chunks=(64, 3, 3), dtype="f8"),
        "/position: declares",
    ),
    "terabytes of names": (
        replaced("body", shape=(HUGE,), maxshape=(None,), dtype=h5py.string_dtype()),
        "/body: declares",
    ),
    "huge chunks": (
        replaced("position", shape=(1, 3, 3), maxshape=(None, 3, 3), chunks=(1 << 20, 3, 3), dtype="f8"),
        "/position: has chunks of",
    ),
    "unknown filter": (
        replaced("position", shape=(9, 3, 3), chunks=(3, 3, 3), dtype="f8", compression="lzf"),
        "/position: is compressed in a way that physsim does not use",
    ),
    "other file": (
        replaced("mass", shape=(3,), dtype="f8", external=[("/etc/passwd", 0, 24)]),
        "/mass: keeps its numbers in another file",
    ),
    "offsets out of range": (
        lambda file: file["contacts/offset"].__setitem__(slice(None), HUGE),
        "is shorter than /contacts says",
    ),
    "bodies out of range": (
        lambda file: file["contacts/body_a"].__setitem__(slice(None), 77),
        "the file is damaged and cannot be read",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_made_by_an_enemy(edited: Edited, case: str) -> None:
    change, words = CASES[case]
    refused(edited(change), words)


def test_a_virtual_dataset_is_not_followed(edited: Edited, tmp_path: Path) -> None:
    def change(file: h5py.File) -> None:
        plan = h5py.VirtualLayout(shape=(3,), dtype="f8")
        plan[:] = h5py.VirtualSource(tmp_path / "elsewhere.h5", "mass", shape=(3,))
        del file["mass"]
        file.create_virtual_dataset("mass", plan)

    refused(edited(change), "/mass: keeps its numbers in another file")


def test_a_heap_that_runs_in_a_circle(recorded: Callable[..., Path]) -> None:
    """HDF5 2.0 hangs on a free-space object of size 0 in a heap of texts: opening the file never returned."""
    path = recorded()
    data = bytearray(path.read_bytes())
    assert broken_heap(path) is None
    heap, free_space = next(found for found in heaps_with_free_space(data))
    data[free_space + 8 : free_space + 16] = bytes(8)
    path.write_bytes(data)
    assert broken_heap(path) == heap
    refused(path, "the texts in the file are damaged")


def heaps_with_free_space(data: bytearray) -> Iterator[tuple[int, int]]:
    """Where each heap begins, and where its free space does."""
    for match in re.finditer(rb"GCOL\x01", data):
        here = match.start() + 16
        end = match.start() + int.from_bytes(data[match.start() + 8 : here], "little")
        while here < end:
            if data[here : here + 2] == b"\0\0":
                yield match.start(), here
                break
            here += 16 + (int.from_bytes(data[here + 8 : here + 16], "little") + 7) // 8 * 8


MUTANTS = 250


@pytest.mark.skipif(sys.platform == "win32", reason="needs fork")
def test_random_damage_never_crashes_or_hangs(tmp_path: Path) -> None:
    """In a process of its own, with 4 GB of memory and an alarm. Seen clean over 30000 mutants."""
    data = made_up_run.record(tmp_path / "run.h5", frames=6).read_bytes()
    child = os.fork()
    if child == 0:
        os._exit(read_mutants(data, tmp_path / "mutant.h5"))
    _, status = os.waitpid(child, 0)
    assert not os.WIFSIGNALED(status), f"killed by signal {os.WTERMSIG(status)}"
    assert os.WEXITSTATUS(status) == 0


def read_mutants(data: bytes, path: Path) -> int:
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    for seed in range(MUTANTS):
        path.write_bytes(mutant(data, random.Random(seed)))
        signal.alarm(20)
        try:
            read_everything(path)
        except FileTrouble:
            continue
        except BaseException as error:
            os.write(2, f"seed {seed}: {error!r}\n".encode())
            return 1
    return 0


def mutant(data: bytes, dice: random.Random) -> bytes:
    """A few bytes changed, cut out or copied elsewhere, more often near the start where the structure is."""
    changed = bytearray(data)
    for _ in range(dice.choice([1, 1, 2, 4, 16])):
        at = dice.randrange(dice.choice([20_000, len(changed)]))
        kind = dice.randrange(5)
        if kind == 0:
            changed[at] = dice.randrange(256)
        elif kind == 1:
            changed[at] ^= 1 << dice.randrange(8)
        elif kind == 2:
            changed[at : at + 8] = dice.choice([b"\xff" * 8, bytes(8), dice.randbytes(8)])
        elif kind == 3:
            del changed[at : at + dice.randrange(1, 200)]
        else:
            source, length = dice.randrange(len(changed)), dice.randrange(1, 200)
            changed[at : at + length] = changed[source : source + length]
    return bytes(changed[: dice.randrange(len(changed))] if dice.random() < 0.05 else changed)

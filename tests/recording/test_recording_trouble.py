"""What stands in the way of writing is told in one sentence, and never costs what is on disk already."""

from __future__ import annotations

import errno
import resource
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import made_up_run
import pytest

from physsim.errors import FileTrouble
from physsim.recording import Recorder, Target, disk, open_trajectory, target


def check(path: Path, force: bool = False) -> None:
    Target(path).check(force=force)


def test_a_file_that_exists_needs_force(recorded: Callable[..., Path]) -> None:
    path = recorded()
    with pytest.raises(FileTrouble, match="exists already; --force replaces it"):
        check(path)
    check(path, force=True)


def test_a_folder_is_no_file(tmp_path: Path) -> None:
    with pytest.raises(FileTrouble, match="is a folder"):
        check(tmp_path, force=True)


def test_a_folder_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(FileTrouble, match=r"the folder .*nowhere does not exist"):
        check(tmp_path / "nowhere" / "run.h5")


def test_a_device_is_no_file() -> None:
    with pytest.raises(FileTrouble, match="is not a regular file"):
        check(Path("/dev/null"), force=True)


def test_a_place_that_takes_no_files() -> None:
    """/proc, since the tests may run as root, to whom every ordinary folder is open."""
    with pytest.raises(FileTrouble, match="cannot be written"):
        made_up_run.start(Path("/proc/run.h5"), 3)


def test_a_run_that_cannot_fit_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FileTrouble, match="not enough room on the disk: at least 100 TB are needed"):
        Target(tmp_path / "run.h5").check_space(10**15)
    Target(tmp_path / "run.h5").check_space(10**6)


def test_another_run_on_the_same_file(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    recorder = made_up_run.start(path, 3)
    made_up_run.feed(recorder, 0, 3)
    recorder.write_block()
    recorder.settle()
    with pytest.raises(FileTrouble, match="another run is writing to it"):
        check(path, force=True)
    recorder.finish("complete", "", None, 0, {})
    check(path, force=True)


def test_a_new_file_has_its_name_from_the_first_block_on(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    recorder = made_up_run.start(path, 3)
    assert not path.exists()
    made_up_run.feed(recorder, 0, 3)
    recorder.write_block()
    recorder.settle()
    assert path.exists()
    assert recorder.finish("complete", "", None, 0, {}) == path
    assert sorted(tmp_path.iterdir()) == [path]


def test_an_old_file_stays_until_the_new_one_is_whole(recorded: Callable[..., Path], tmp_path: Path) -> None:
    path = recorded(frames=5)
    before = path.read_bytes()
    recorder = made_up_run.start(path, 3)
    for number in range(9):
        made_up_run.feed(recorder, number, 3)
        recorder.write_block()
        recorder.settle()
        assert path.read_bytes() == before
    recorder.finish("interrupted", "", None, 0, {})
    with open_trajectory(path) as trajectory:
        assert trajectory.frames == 9
    assert sorted(tmp_path.iterdir()) == [path]


def test_a_run_that_fails_at_once_does_not_replace_an_old_file(recorded: Callable[..., Path]) -> None:
    path = recorded(frames=5)
    recorder = made_up_run.start(path, 3)
    made_up_run.feed(recorder, 0, 3)
    kept = recorder.finish("failed", "blew up", None, 0, {})
    assert kept.name == "run.h5.part"
    with open_trajectory(path) as trajectory:
        assert (trajectory.frames, trajectory.status) == (5, "complete")
    with open_trajectory(kept) as trajectory:
        assert (trajectory.frames, trajectory.status_detail) == (1, "blew up")


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (OSError(errno.ENOSPC, "x"), "no space left on device"),
        (RuntimeError("Unable to flush (errno = 27, error message = 'File too large')"), "size limit"),
        (OSError("unable to lock file, errno = 11"), "another program"),
        (ValueError("first line\nsecond"), "first line"),
        (KeyError(), "KeyError"),
    ],
)
def test_reasons_in_words(error: Exception, words: str) -> None:
    assert words in target.plain(error)


FILL = f"""
import sys
sys.path.insert(0, {str(Path(made_up_run.__file__).parent)!r})
from pathlib import Path
import made_up_run
from physsim.errors import FileTrouble
recorder = made_up_run.start(Path(sys.argv[1]), 5)
try:
    for number in range(10**5):
        made_up_run.feed(recorder, number, 5)
        if number % 7 == 0:
            recorder.write_checkpoint(b"x" * 1000, number)
            recorder.settle()
            print(recorder.frames, flush=True)
except FileTrouble as error:
    print(error)
    sys.exit(error.exit_code)
"""


def fill(path: Path, preexec: Callable[[], None] | None = None) -> list[str]:
    """Writes until nothing fits any more. The process must end by itself, with the exit code of
    FileTrouble.
    """
    command = [sys.executable, "-c", FILL, str(path)]
    done = subprocess.run(
        command, capture_output=True, text=True, timeout=60, preexec_fn=preexec, check=False
    )
    assert (done.returncode, done.stderr) == (3, "")
    return done.stdout.splitlines()


def check_full(path: Path, said: list[str]) -> None:
    with open_trajectory(path) as trajectory:
        assert trajectory.frames == int(said[-2])
        assert trajectory.position[-1, 3, 2] == 1000.0 * (trajectory.frames - 1) + 32
        assert trajectory.checkpoint() is not None
        assert trajectory.status in {"interrupted", "running"}


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=4m", "tmpfs", str(folder)]
    if subprocess.run(mount, capture_output=True, check=False).returncode:
        pytest.skip("a small disk can only be mounted by root")
    yield folder
    subprocess.run(["umount", str(folder)], check=True)


def test_a_full_disk(small_disk: Path) -> None:
    """Without claiming the room first, h5py leaves a file that cannot be opened, and Python crashes at its
    end.
    """
    said = fill(small_disk / "run.h5")
    assert "no space left on device; the frames written before are kept" in said[-1]
    check_full(small_disk / "run.h5", said)


def test_a_full_disk_can_be_resumed_once_there_is_room(small_disk: Path) -> None:
    ballast = small_disk / "ballast"
    ballast.write_bytes(b"x" * (1 << 20))
    path = small_disk / "run.h5"
    fill(path)
    ballast.unlink()
    with open_trajectory(path) as trajectory:
        frames = trajectory.frames
    recorder = Recorder.resume(path, Target(path), made_up_run.COLUMNS, frames, frames // 4)
    made_up_run.feed(recorder, frames, 5)
    recorder.finish("complete", "", None, 0, {})
    with open_trajectory(path) as trajectory:
        assert (trajectory.frames, trajectory.status) == (frames + 1, "complete")


def test_a_size_limit(tmp_path: Path) -> None:
    limit = 4 << 20
    said = fill(tmp_path / "run.h5", lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
    assert "file too large; the frames written before are kept" in said[-1]
    check_full(tmp_path / "run.h5", said)


def test_a_failing_disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The file is left as the last flush left it, can be closed, and says why it ends."""
    path = tmp_path / "run.h5"
    recorder = made_up_run.start(path, 3)
    made_up_run.feed(recorder, 0, 3)
    recorder.write_block()
    recorder.settle()
    made_up_run.feed(recorder, 1, 3)

    def fail(handle: int, data: bytes, at: int) -> int:
        raise OSError(errno.EIO, "x")

    with monkeypatch.context() as broken:
        broken.setattr(disk.os, "pwrite", fail)
        recorder.write_block()
        with pytest.raises(FileTrouble, match="input/output error"):
            recorder.settle()
    with open_trajectory(path) as trajectory:
        assert (trajectory.frames, trajectory.status) == (1, "running")

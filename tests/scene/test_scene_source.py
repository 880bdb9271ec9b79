"""Files that are no scenes: each kind of trouble in plain words, with the right exit status."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from physsim.errors import FileTrouble, PhyssimError, SceneError
from physsim.scene import format_problems, load_scene


def told(path: Path) -> str:
    """What loading the file says."""
    with pytest.raises(PhyssimError) as caught:
        load_scene(path)
    error = caught.value
    assert error.exit_code == (2 if isinstance(error, SceneError) else 3)
    text = format_problems(error.problems, error.file) if isinstance(error, SceneError) else str(error)
    return text.replace(str(path.parent), "DIR")


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        (b"", "DIR/s.yaml:1:1: the file is empty\n    1 |\n      | ^"),
        (b"\xef\xbb\xbf", "DIR/s.yaml:1:1: the file is empty\n    1 |\n      | ^"),
        ("a: 1".encode("utf-16"), "DIR/s.yaml: is written in UTF-16; save it as UTF-8"),
        (
            "a: 1".encode("utf-16-be"),
            "DIR/s.yaml:1:1: is a binary file (it holds a NUL byte), not a scene in YAML",
        ),
        (b"a: 1\nb: \x00", "DIR/s.yaml:2:4: is a binary file (it holds a NUL byte), not a scene in YAML"),
        (
            "a: 1\nb: ö".encode("latin-1"),
            "DIR/s.yaml:2:4: is not UTF-8 (byte 0xf6 cannot be read); save it as UTF-8",
        ),
        (b"#" + b" " * 2**24, "DIR/s.yaml: is larger than 16 MiB, the most for a scene"),
    ],
    ids=["empty", "only a mark", "UTF-16", "UTF-16 without mark", "NUL", "Latin-1", "huge"],
)
def test_content_that_is_no_scene(content: bytes, expected: str, tmp_path: Path) -> None:
    path = tmp_path / "s.yaml"
    path.write_bytes(content)
    assert told(path) == expected


def test_a_binary_file(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    path.write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(range(256)))
    assert "is a binary file (it holds a NUL byte), not a scene in YAML" in told(path)


def test_a_missing_file_names_its_neighbour(tmp_path: Path) -> None:
    (tmp_path / "bounce.yaml").touch()
    assert (
        told(tmp_path / "bounse.yaml")
        == "DIR/bounse.yaml: there is no such file; did you mean 'bounce.yaml'?"
    )
    assert told(tmp_path / "nowhere" / "s.yaml").endswith("there is no such file")


def test_a_directory_names_its_scenes(tmp_path: Path) -> None:
    folder = tmp_path / "scenes"
    folder.mkdir()
    (folder / "a.yaml").touch()
    assert told(folder) == "DIR/scenes: is a directory, not a scene file; it holds a.yaml"


def test_an_unreadable_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "s.yaml"
    path.touch()

    def refuse(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "open", refuse)
    assert told(path) == "DIR/s.yaml: cannot be read: Permission denied"


def test_a_pipe_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    assert told(tmp_path / "pipe") == "DIR/pipe: is not a regular file"


@pytest.mark.parametrize("name", ["a\0b", "x" * 5000])
def test_a_name_that_no_file_can_have(name: str) -> None:
    with pytest.raises(FileTrouble, match="cannot be read"):
        load_scene(name)


def test_a_byte_order_mark_is_no_part_of_the_scene(tmp_path: Path, minimal: str) -> None:
    path = tmp_path / "s.yaml"
    path.write_bytes(b"\xef\xbb\xbf" + minimal.encode())
    scene = load_scene(path)
    assert scene.text == minimal
    assert (scene.path, scene.folder, scene.title) == (path, tmp_path, "s")

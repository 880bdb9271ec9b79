"""`physsim new`: a valid scene under a safe name, never over an old file by accident."""

from __future__ import annotations

from pathlib import Path

import pytest


@pytest.mark.parametrize("given", ["my_scene", "my_scene.yaml", "my_scene.yml"])
def test_new_writes_a_scene_that_is_valid(physsim, tmp_path: Path, given: str) -> None:
    said = physsim("new", given)
    assert (said.code, said.out) == (0, "my_scene.yaml\n")
    assert "physsim run my_scene.yaml" in said.err
    text = (tmp_path / "my_scene.yaml").read_text()
    assert 'title: "my_scene"' in text
    assert "NAME" not in text
    checked = physsim("validate", "my_scene.yaml")
    assert (checked.code, checked.err) == (0, "")


def test_a_name_that_yaml_would_read_as_a_number_is_a_title(physsim) -> None:
    assert physsim("new", "1e3").code == 0
    assert physsim("validate", "1e3.yaml").code == 0


def test_new_leaves_an_existing_file_alone(physsim, tmp_path: Path) -> None:
    old = tmp_path / "mine.yaml"
    old.write_text("precious")
    said = physsim("new", "mine")
    assert said.code == 3
    assert said.err == "physsim: mine.yaml exists already; --force overwrites it\n"
    assert old.read_text() == "precious"
    assert physsim("new", "mine", "--force").code == 0
    assert old.read_text() != "precious"


@pytest.mark.parametrize(
    "name",
    [
        "../x",
        "/tmp/x",
        "a/b",
        "a\\b",
        "",
        ".",
        "..",
        ".hidden",
        "-x.yaml",
        "a b",
        "a\nb",
        "a;b",
        "$(x)",
        "x" * 200,
        "con",
    ],
)
def test_new_refuses_names_that_are_unsafe(physsim, tmp_path: Path, name: str) -> None:
    said = physsim("new", "--", name)
    assert said.code == 2
    assert "Traceback" not in said.err
    assert list(tmp_path.iterdir()) == []


def test_new_in_a_folder_that_cannot_be_written_is_file_trouble(
    physsim, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied", "a.yaml")

    monkeypatch.setattr(Path, "open", refused)
    said = physsim("new", "a")
    assert (said.code, said.err) == (3, "physsim: a.yaml: Permission denied\n")

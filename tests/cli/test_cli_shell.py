"""What holds for every verb: start-up, exit codes, streams, colours, and calm when things go wrong."""

from __future__ import annotations

import subprocess
import sys

import pytest
from shell import clean_environment

from physsim import __version__ as package_version
from physsim.cli import outcome
from physsim.cli.app import VERBS, group
from physsim.cli.verb import EXIT_CODES, Settings
from physsim.errors import ExpectationFailed, FileTrouble, Problem, RunFailed, SceneError

HEAVY = ("numpy", "pydantic", "yaml", "h5py", "trimesh", "scipy", "fcl", "rich", "pandas", "xarray")


def modules_after(*arguments: str) -> set[str]:
    """Top-level modules that are loaded once `physsim ARGUMENTS` has been answered."""
    script = (
        "import sys\n"
        "from physsim.cli.app import answer\n"
        f"code = answer({list(arguments)!r})\n"
        "print('MODULES', *sorted({name.partition('.')[0] for name in sys.modules}))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=True
    )
    return set(done.stdout.rpartition("MODULES")[2].split())


@pytest.mark.parametrize(("given", "used"), [(None, "1"), ("3", "3")])
def test_linear_algebra_keeps_to_one_thread_unless_told(given: str | None, used: str) -> None:
    script = (
        "import os\n"
        "from physsim.cli import main\n"
        "try: main(['--version'])\n"
        "finally: print(os.environ['OPENBLAS_NUM_THREADS'])\n"
    )
    environment = clean_environment()
    environment.pop("OPENBLAS_NUM_THREADS", None)
    if given:
        environment["OPENBLAS_NUM_THREADS"] = given
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, env=environment, check=True
    )
    assert done.stdout.split()[-1] == used


@pytest.mark.parametrize(
    "arguments",
    [["--help"], ["--version"], *([verb, "--help"] for verb in VERBS), ["new", "x/y"], ["completion", "zsh"]],
)
def test_help_and_small_talk_import_nothing_heavy(arguments: list[str]) -> None:
    assert modules_after(*arguments).isdisjoint(HEAVY)


def test_help_names_every_verb_and_every_exit_code(physsim) -> None:
    said = physsim("--help")
    assert said.code == 0
    assert said.err == ""
    for word in (*VERBS, *map(str, EXIT_CODES), "NO_COLOR", "PHYSSIM_DEBUG"):
        assert word in said.out


@pytest.mark.parametrize("verb", VERBS)
def test_every_verb_has_a_manual_page(physsim, verb: str) -> None:
    said = physsim(verb, "--help")
    assert said.code == 0
    assert said.out.startswith(f"Usage: physsim {verb}")
    assert "Exit status:" in said.out
    assert "Examples:" in said.out
    assert f"physsim {verb}" in said.out.partition("Examples:")[2]


@pytest.mark.parametrize("verb", VERBS)
def test_manual_pages_explain_every_argument_and_option(verb: str) -> None:
    command = group.get_command(None, verb)
    described = {name for name, _ in command.arguments}
    for parameter in command.params:
        if parameter.param_type_name == "argument":
            assert (
                parameter.make_metavar(command.make_context(verb, [], resilient_parsing=True)).strip("[]")
                in described
            )
        else:
            assert parameter.help


def test_version(physsim) -> None:
    assert physsim("--version").out == f"physsim {package_version}\n"


@pytest.mark.parametrize(
    ("given", "expected"),
    [("rum", "Did you mean 'run'?"), ("valid", "Did you mean 'validate'?"), ("xyzzy", "Commands: run")],
)
def test_unknown_verb_is_refused_with_the_nearest(physsim, given: str, expected: str) -> None:
    said = physsim(given)
    assert said.code == 2
    assert said.out == ""
    assert f"No such command '{given}'" in said.err
    assert expected in said.err


PLANNED = ("plot", "export", "view", "sweep", "diff")


@pytest.mark.parametrize("verb", [verb for verb in PLANNED if verb not in VERBS])
def test_verbs_that_are_not_there_are_not_there(physsim, verb: str) -> None:
    said = physsim(verb)
    assert said.code == 2
    assert "No such command" in said.err


@pytest.mark.parametrize(
    "arguments", [["run"], ["validate"], ["info"], ["new"], ["completion"], ["run", "a", "--wrong"]]
)
def test_wrong_usage_exits_2_and_names_the_help(physsim, arguments: list[str]) -> None:
    said = physsim(*arguments)
    assert said.code == 2
    assert said.out == ""
    assert f"Try 'physsim {arguments[0]} --help'" in said.err


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (RunFailed("body 'ball' flew apart at 0.3 s"), 1),
        (SceneError([Problem(("bodies", "ball"), "is wrong")], "a.yaml"), 2),
        (FileTrouble("a.h5: exists already"), 3),
        (ExpectationFailed("1 of 2"), 4),
        (KeyboardInterrupt(), 130),
        (PermissionError(13, "Permission denied", "a.h5"), 3),
        (MemoryError(), 1),
        (ZeroDivisionError("division by zero"), 1),
        (RecursionError("too deep"), 1),
        (BaseException("a panic of the engine"), 1),
    ],
)
def test_every_error_is_a_message_and_a_code(
    capsys: pytest.CaptureFixture[str], error: BaseException, code: int
) -> None:
    assert outcome.tell(error, Settings()) == code
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1
    assert "Traceback" not in said.err


def test_unexpected_error_is_one_line_and_a_traceback_only_on_wish(
    physsim, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(shell: str) -> None:
        raise ZeroDivisionError("division by zero")

    monkeypatch.setattr("physsim.cli.completion.get_completion_class", broken)
    said = physsim("completion", "bash")
    assert said.code == 1
    assert said.err == (
        "physsim: internal error, a mistake in physsim and not in your scene: ZeroDivisionError: "
        "division by zero (--debug shows the traceback)\n"
    )
    for arguments in (["--debug", "completion", "bash"], ["completion", "bash", "--debug"]):
        assert "Traceback (most recent call last)" in physsim(*arguments).err
    monkeypatch.setenv("PHYSSIM_DEBUG", "1")
    assert "Traceback (most recent call last)" in physsim("completion", "bash").err


def test_a_reader_that_leaves_early_is_no_error() -> None:
    script = f"set -o pipefail; {sys.executable} -m physsim completion bash | true"
    for _ in range(3):
        done = subprocess.run(["bash", "-c", script], capture_output=True, text=True, timeout=60, check=False)
        assert (done.returncode, done.stderr) == (0, "")


def test_a_full_disk_under_stdout_is_file_trouble() -> None:
    script = f"{sys.executable} -m physsim completion bash > /dev/full"
    done = subprocess.run(["bash", "-c", script], capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 3
    assert done.stderr == "physsim: No space left on device\n"


def test_a_failed_write_leaves_without_the_interpreters_clean_up() -> None:
    """h5py crashes at interpreter exit after a failed write: with code 3 nothing may run at exit."""
    script = (
        "import atexit, sys, types\n"
        "from physsim.cli import outcome\n"
        "sys.modules['h5py'] = types.ModuleType('h5py')\n"
        "atexit.register(print, 'clean-up has run')\n"
        "print('told')\n"
        "outcome.leave(3)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=False
    )
    assert (done.returncode, done.stdout, done.stderr) == (3, "told\n", "")

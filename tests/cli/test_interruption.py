"""Ctrl-C ends the process without a traceback, wherever it is: here while each of these modules is imported."""

import signal
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
INTERRUPTED_AT = """
import os, signal, sys
interrupted = sys.argv.pop(1)
class Finder:
    def find_spec(self, name, path=None, target=None):
        if name == interrupted:
            os.kill(os.getpid(), signal.SIGINT)
sys.meta_path.insert(0, Finder())
from understudy.cli.interruption import start
start()
"""
ENDED = {130, -signal.SIGINT}


def _ended(code: str, module: str, target: Path) -> tuple[int, str]:
    line = ["perform", str(EXAMPLES / "example.flac"), "--text-file", str(EXAMPLES / "example.txt")]
    command = [sys.executable, "-c", code, module, *line, "-o", str(target)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stderr


@pytest.mark.parametrize(
    "module",
    [
        "understudy.cli.main",
        "pydantic",
        "spacy",
        "understudy.rules.mapping",
    ],
)
def test_without_a_traceback_while_it_is_imported(module: str, tmp_path: Path) -> None:
    ended, told = _ended(INTERRUPTED_AT, module, tmp_path / "a.bml")
    assert ended in ENDED
    assert told == ""
    assert list(tmp_path.iterdir()) == []


def test_a_command_that_is_done_leaves_with_its_exit_code_after_what_its_modules_do_last() -> None:
    """Nothing is taken apart object by object any more."""
    code = INTERRUPTED_AT.replace(
        "os.kill(os.getpid(), signal.SIGINT)", "import atexit; atexit.register(print, 'done last')"
    ).replace("\nclass", "\nclass Kept:\n    def __del__(self): print('taken apart')\nsys.kept = Kept()\nclass")
    command = [sys.executable, "-c", code, "understudy.cli.main", "gestures", "lost"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (2, "done last\n")
    assert "lost" in done.stderr


def test_what_an_import_makes_of_it_is_not_told(tmp_path: Path) -> None:
    """As numpy does, which turns every error of its first import into an ImportError that tells how to install it."""
    turned = INTERRUPTED_AT.replace(
        "os.kill(os.getpid(), signal.SIGINT)",
        "\n            try: os.kill(os.getpid(), signal.SIGINT)"
        "\n            except BaseException: raise ImportError('install it properly')",
    )
    ended, told = _ended(turned, "understudy.performance", tmp_path / "a.bml")
    assert ended in ENDED
    assert told == ""

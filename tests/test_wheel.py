"""A wheel carries what authors edit and what was trained: the installed package performs without the checkout."""

import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from tests.support.python_page import ROOT, run_page


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder into which the wheel was unpacked."""
    folder = tmp_path_factory.mktemp("wheel")
    build = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder)]
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
    (wheel,) = folder.glob("*.whl")
    zipfile.ZipFile(wheel).extractall(folder / "installed")
    return folder / "installed"


def test_it_is_one_typed_package_with_all_it_needs_and_nothing_called_app(installed: Path) -> None:
    assert {path.name.partition("-")[0] for path in installed.iterdir()} == {"understudy"}
    inside = {path.name for path in (installed / "understudy").iterdir()}
    assert inside >= {"py.typed", "library", "lexicon", "models", "examples"}
    assert (installed / "understudy/api/description/swagger/swagger-ui-bundle.js.gz").exists()
    assert inside.isdisjoint({"app", "tests", "benchmarks", "training"})


def test_the_examples_of_the_python_page_run_away_from_the_checkout(installed: Path, tmp_path: Path) -> None:
    run_page(tmp_path, installed)

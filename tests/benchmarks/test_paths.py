"""Every benchmark finds its files: those of the checkout exist, the others are in ../shared."""

import importlib
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = sorted(path for path in (ROOT / "benchmarks").rglob("*.py") if path.name != "__init__.py")


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_files_named_by_a_script_are_where_it_says(script: Path) -> None:
    name = ".".join(script.relative_to(ROOT).with_suffix("").parts)
    module = importlib.import_module(name)
    named = [value for value in vars(module).values() if isinstance(value, Path) and value.is_absolute()]
    for path in named:
        in_checkout = path.is_relative_to(ROOT) and not path.is_relative_to(ROOT / "out")
        assert path.exists() if in_checkout else _lies_elsewhere(path), path


def _lies_elsewhere(path: Path) -> bool:
    """In ../shared, in the environment that runs this, or in the folder for what scripts write."""
    return any(path.is_relative_to(folder) for folder in (ROOT.parent / "shared", Path(sys.prefix), ROOT / "out"))

"""Every script that measures finds its files: those of the checkout are there, the others lie in ../shared."""

import importlib
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
        in_checkout = path.is_relative_to(ROOT)
        assert path.exists() if in_checkout else path.is_relative_to(ROOT.parent / "shared"), path

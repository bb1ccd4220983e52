"""The examples of docs/python.md do what the page says, as installed from the checkout; tests/test_wheel.py has them
from a wheel."""

from pathlib import Path

from tests.support.python_page import EXAMPLES, PAGE, ROOT, run_page


def test_the_examples_print_what_the_page_says(tmp_path: Path) -> None:
    run_page(tmp_path, ROOT / "src")


def test_every_example_is_run() -> None:
    assert len(EXAMPLES) == PAGE.count("```python") > 5
    assert sum(bool(said) for _, said in EXAMPLES) == PAGE.count("```text")

"""Every example of docs/python.md is run: from a wheel, by tests/test_wheel.py."""

from tests.support.python_page import EXAMPLES, PAGE


def test_every_example_is_run() -> None:
    assert len(EXAMPLES) == PAGE.count("```python") > 5
    assert sum(bool(said) for _, said in EXAMPLES) == PAGE.count("```text")

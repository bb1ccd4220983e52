"""The examples of docs/authoring.md, run in order in a copy of the checkout, give the printed results."""

from pathlib import Path

from tests.support.authored_pages import ROOT, examples_of, failed_commands

PAGE = ROOT / "docs" / "authoring.md"


def test_every_command_answers_what_the_page_says(tmp_path: Path) -> None:
    assert failed_commands(PAGE, tmp_path, at_least=9) == []


def test_every_example_is_run() -> None:
    examples = examples_of(PAGE)
    assert PAGE.read_text(encoding="utf-8").count("```") == 2 * len(examples)
    assert {kind for kind, *_ in examples} == {"yaml", "rules", "gesture", "console"}

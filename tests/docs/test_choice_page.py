"""The examples of docs/choice.md, run in order in a copy of the checkout, give the printed results."""

from pathlib import Path

from tests.support.authored_pages import ROOT, examples_of, failed_commands


def test_every_command_answers_what_the_page_says(tmp_path: Path) -> None:
    page = ROOT / "docs" / "choice.md"
    assert {kind for kind, *_ in examples_of(page)} == {"yaml", "rules", "console"}
    assert failed_commands(page, tmp_path, at_least=7) == []

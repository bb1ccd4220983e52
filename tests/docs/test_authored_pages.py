"""The examples of docs/authoring.md and docs/choice.md, run in order in a copy of the checkout, give the printed
results."""

from pathlib import Path

from tests.support.authored_pages import ROOT, examples_of, failed_commands

AUTHORING, CHOICE = (ROOT / "docs" / name for name in ("authoring.md", "choice.md"))


def test_every_command_answers_what_its_page_says(tmp_path: Path) -> None:
    assert failed_commands({AUTHORING: 9, CHOICE: 7}, tmp_path) == []


def test_every_example_is_run() -> None:
    examples = examples_of(AUTHORING)
    assert AUTHORING.read_text(encoding="utf-8").count("```") == 2 * len(examples)
    assert {kind for kind, *_ in examples} == {"yaml", "rules", "gesture", "console"}
    assert {kind for kind, *_ in examples_of(CHOICE)} == {"yaml", "rules", "console"}

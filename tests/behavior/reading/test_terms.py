"""The terms of words: from facts of the rules by the authors' table, and from functions, syntax and position."""

from pathlib import Path

import pytest

from understudy.behavior.reading.terms import TermTable, terms_of
from understudy.errors import AuthoringError
from understudy.models import Understudy
from understudy.rules.stage import find_functions

PREDICATES = {"mood": 4, "negated": 2}


def written(folder: Path, content: str) -> Path:
    path = folder / "terms.yaml"
    path.write_text(content)
    return path


def test_a_fact_gives_its_words_a_term_named_by_its_arguments(tmp_path: Path) -> None:
    path = written(
        tmp_path, 'terms:\n  mood: {name: "mood({0})", span: [1, 2]}\n  negated: {name: negated, span: [0]}\n'
    )
    table = TermTable.load(path, PREDICATES)
    facts = [("mood", ("wh", 2, 5, 3)), ("negated", (4, 1)), ("of no interest", ("x",))]
    assert list(table.of_facts(facts)) == [("mood(wh)", 2, 4), ("negated", 4, 4)]


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("moode: {name: mood, span: [1, 2]}", "'moode' is not a predicate of the rules; did you mean 'mood'?"),
        ("mood: {name: mood, span: [3, 4]}", "mood has the arguments 0 to 3, none called '4'"),
        ('mood: {name: "mood({kind})", span: [1, 2]}', "mood has the arguments 0 to 3, none called 'kind'"),
    ],
)
def test_what_the_rules_do_not_have_is_told_with_its_place(tmp_path: Path, line: str, told: str) -> None:
    with pytest.raises(AuthoringError) as raised:
        TermTable.load(written(tmp_path, f"terms:\n  {line}\n"), PREDICATES)
    assert [(mistake.line, mistake.message) for mistake in raised.value.mistakes] == [(2, told)]


def test_words_have_terms_of_function_person_mood_and_place(understudy: Understudy) -> None:
    analysis = find_functions(understudy.language, "You never listened!")
    first, never, last = terms_of(analysis.utterance, analysis.functions)
    assert {"line(first word)", "sentence(exclamation)", "part_of_speech(PRON)"} <= first
    assert "function(negation)" in never
    assert {"subject(second person)", "line(last word)"} <= last

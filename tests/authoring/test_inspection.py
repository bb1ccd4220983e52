"""Explaining the interpretation of a text, and finding what a corpus never uses: the functions, and their commands."""

import json
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from understudy.authoring.inspection import find_unused, trace, trace_one
from understudy.cli.inputs.function_lines import read_corpus
from understudy.cli.main import main
from understudy.cli.outputs.listings import MOST_NEAR_MISSES, trace_lines
from understudy.errors import InputError
from understudy.models import Understudy
from understudy.rules.mapping import offer_movements
from understudy.rules.stage import find_functions
from understudy.text.transcript import MAX_CHARACTERS

TEXT = "No, that is a lot more important."


def test_a_trace_has_every_rule_behind_functions_and_movements(understudy: Understudy) -> None:
    traced = trace(understudy, TEXT)
    analysis = find_functions(understudy.language, TEXT)
    fired = {firing.rule.name for firing in traced.functions.firings}
    assert {function.rule for function in analysis.functions} <= fired
    candidates = offer_movements(
        understudy.behavior.rules, analysis.utterance, analysis.functions, seed=0, facts=analysis.facts
    )
    offering = {
        movement.rule
        for offer in candidates
        for alternative in offer.alternatives
        for movement in alternative.movements
    }
    assert offering
    assert offering <= {firing.rule.name for firing in traced.mappings.firings}


def test_a_trace_is_told_with_places_and_words_and_is_not_endless(understudy: Understudy) -> None:
    lines = list(trace_lines(trace(understudy, TEXT)))
    place = lines.index(next(line for line in lines if line.startswith("  negation_word  app/rules/functions/")))
    joined, found = (line.split() for line in lines[place + 1 : place + 3])
    assert joined == ["lexical(negation,", "plain,", "0,", "1)", "No,"]
    assert found == ["→", "fcn(negation,", "plain,", "0,", "1)", "No,"]
    near = lines.index("function rules that nearly fired")
    assert sum(line.startswith("    missing: ") for line in lines[near:]) <= 2 * MOST_NEAR_MISSES
    assert any("with fewer conditions met" in line for line in lines[near:])


def test_one_rule_is_told_and_an_unknown_one_refused(understudy: Understudy) -> None:
    traced = trace_one(understudy, TEXT, rule="show_negation")
    assert traced.functions.firings == ()
    assert {firing.rule.name for firing in traced.mappings.firings} == {"show_negation"}
    with pytest.raises(InputError) as caught:
        trace_one(understudy, TEXT, rule="negation_wrod")
    assert (caught.value.code, "negation_word" in caught.value.message) == ("unknown_name", True)


def test_what_a_corpus_uses_is_not_unused(understudy: Understudy) -> None:
    language, body = understudy.language, understudy.behavior
    of_one, of_two = (find_unused(language, body, texts) for texts in ([TEXT], [TEXT, "Well, they must have left!"]))
    traced = trace(understudy, TEXT)
    fired = {firing.rule.name for firing in (*traced.functions.firings, *traced.mappings.firings)}
    asserting = {rule.name for rule in of_one.rules if rule.kind == "assert"}
    assert asserting == {rule.name for rule in language.rules.program.rules if rule.name not in fired} | {
        rule.name for rule in body.rules.program.rules if rule.kind == "assert" and rule.name not in fired
    }
    assert set(of_two.rules) < set(of_one.rules)
    assert {entry.phrase for entry in of_one.words} - {entry.phrase for entry in of_two.words} >= {"must have"}
    listed = {(entry.class_name, entry.phrase) for entry in of_one.words}
    assert ("negation", "no") not in listed
    assert ("negation", "never") in listed


def test_a_corpus_is_text_or_json_lines(tmp_path: Path) -> None:
    corpus = tmp_path / "corpus.txt"
    corpus.write_text('No.\n\n{"id": 3, "text": "Not me."}\n  Yes. \n', encoding="utf-8")
    assert list(read_corpus(str(corpus))) == ["No.", "Not me.", "Yes."]


@pytest.mark.parametrize(
    ("line", "code"),
    [
        (b'{"text": 3}', "value_wrong"),
        (b'{"text": "no"', "not_json"),
        (b"caf\xe9", "text_not_utf8"),
        (b"a\x07b", "text_control_character"),
        (b"x" * (MAX_CHARACTERS + 1), "text_too_long"),
    ],
)
def test_a_line_that_is_no_text_is_named(tmp_path: Path, line: bytes, code: str) -> None:
    corpus = tmp_path / "corpus.txt"
    corpus.write_bytes(b"No.\n" + line + b"\n")
    with pytest.raises(InputError) as caught:
        list(read_corpus(str(corpus)))
    assert caught.value.code == code
    assert f"{corpus}, line 2: " in caught.value.message


def test_the_commands(tmp_path: Path, capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    corpus = tmp_path / "corpus.txt"
    corpus.write_text("No.\n")
    assert main(["rules", "unused", str(corpus)]) == 0
    out = capfdbinary.readouterr().out.decode()
    assert "negation plain  never\n" in out
    assert "negation_word" not in out
    assert main(["rules", "trace", "--text", "No.", "--rule", "negation_word"]) == 0
    assert "→ fcn(negation, plain, 0, 1)" in capfdbinary.readouterr().out.decode()
    for argv, code in (
        (["unused", "/nowhere"], "file_unreadable"),
        (["unused", "/"], "file_unreadable"),
        (["trace", "--text", " "], "text_empty"),
    ):
        assert main(["--json-log", "rules", *argv]) == 2
        assert json.loads(capfdbinary.readouterr().err)["code"] == code


def test_watching_checks_at_each_save(tmp_path: Path) -> None:
    file = tmp_path / "some.rules"
    right = "rule some\nforeach\n  word(spoon, $s, $e)\nassert\n  fcn(negation, plain, $s, $e)\n"
    file.write_text(right)
    command = [sys.executable, "-m", "understudy.cli", "rules", "check", "--watch", str(file)]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as watcher:
        assert watcher.stderr is not None
        assert watcher.stderr.readline() == "no mistake in 1 files\n"
        file.write_text(right.replace("fcn", "fnc"))
        while not (line := watcher.stderr.readline()).startswith(f"{file}:5:3: "):
            assert line, "it ended"
        file.write_text(right)
        while (line := watcher.stderr.readline()) != "no mistake in 1 files\n":
            assert line, "it ended"
        watcher.send_signal(signal.SIGINT)
        assert watcher.wait(timeout=60) == 130

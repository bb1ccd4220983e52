"""What is kept is what the files say: from the cache, everything is as it is without."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from understudy import models as loading
from understudy.behavior.characters.overlays import Characters
from understudy.errors import AuthoringError
from understudy.files import RULES, resource_folder
from understudy.models import Understudy
from understudy.realizer.gestures.library import Library
from understudy.rules.derivation import FunctionRules
from understudy.rules.mapping import MappingRules
from understudy.rules.stage import find_functions

SPOON = "rule spoon\nforeach\n  word(spoon, $s, $e)\nassert\n  fcn(negation, plain, $s, $e)\n"
LEXICON = resource_folder("lexicon")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("UNDERSTUDY_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def test_kept_function_rules_find_what_read_ones_find(understudy: Understudy) -> None:
    read = FunctionRules.load(RULES, LEXICON / "en")
    loading.load_function_rules()
    kept = loading.load_function_rules()
    assert kept.program.rules == read.program.rules
    assert kept.lexicon.entries == read.lexicon.entries
    assert (kept.conflicts, kept.priorities, kept.tables) == (read.conflicts, read.priorities, read.tables)
    for text in ("No, I have never seen that many people before.", "Maybe you should go home, but not now!"):
        from_read, from_kept = (
            find_functions(replace(understudy.language, rules=rules), text).functions for rules in (read, kept)
        )
        assert from_read == from_kept != ()


def test_kept_characters_mappings_and_gestures_are_those_read() -> None:
    for _ in range(2):
        characters = loading.load_characters()
        mappings = loading.load_mapping_rules(characters.callable_names)
        gestures = loading.load_gestures()
    assert characters == Characters.load(LEXICON)
    assert mappings.program.rules == MappingRules.load(RULES, characters.callable_names).program.rules
    read = Library.load(LEXICON / "gestures")
    assert (gestures.definitions, gestures.aliases) == (read.definitions, read.aliases)


def test_mapping_rules_are_read_again_when_a_behaviour_is_gone() -> None:
    names = loading.load_characters().callable_names
    loading.load_mapping_rules(names)
    with pytest.raises(AuthoringError):
        loading.load_mapping_rules(replace(names, behaviors=frozenset(sorted(names.behaviors)[1:])))


def test_a_saved_rule_is_in_use_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    copy = tmp_path / "rules"
    shutil.copytree(RULES, copy, ignore=shutil.ignore_patterns("*.py", "__pycache__"))
    monkeypatch.setattr("understudy.models.RULES", copy)
    before = loading.load_function_rules()
    saved = copy / "functions" / "comparison.rules"
    saved.write_text(f"{saved.read_text()}\n{SPOON}")
    after = loading.load_function_rules()
    assert {rule.name for rule in after.program.rules} - {rule.name for rule in before.program.rules} == {"spoon"}
    (copy / "functions" / "comparison.rules").write_text("rule")
    with pytest.raises(AuthoringError):
        loading.load_function_rules()

"""The examples of docs/rule-language.md derive exactly what the page says."""

import re
from pathlib import Path

import pytest

from understudy.model import Fact
from understudy.rules.chaining.chainer import Argument, Limits, derive
from understudy.rules.language.arithmetic import BUILTINS
from understudy.rules.program.loading import load_program

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "rule-language.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"```rules\n(.*?)```\n\n```facts\n(.*?)```", PAGE, flags=re.DOTALL)
DECLARATIONS = """
predicate word(text, start, end)
predicate pair(one, other, distance)
predicate stressed_ratio(ratio, start, end)
predicate agitation(level)
predicate fcn(class, subtype, start, end, priority max)
"""
FACT = re.compile(r"(\w+)\((.*)\)(?:\s+priority (\d+))?")


@pytest.mark.parametrize(("rules", "told"), EXAMPLES)
def test_examples_derive_what_the_page_says(tmp_path: Path, rules: str, told: str) -> None:
    path = tmp_path / "page.rules"
    path.write_text(DECLARATIONS + rules, encoding="utf-8")
    said: dict[str, list[str]] = {"given": [], "derives": [], "offers": []}
    for line in told.splitlines():
        kind, rest = line.split(maxsplit=1)
        said[kind].append(rest)
    given = dict(map(_fact, said["given"]))
    derivation = derive(load_program([path]), given, annotations={fact: p for fact, p in given.items() if p})
    found = {fact: derivation.annotation(fact) for fact in derivation.facts if derivation.reason(fact)}
    assert found == dict(map(_fact, said["derives"]))
    offers = [
        f"{offered.weight:g} "
        + " ".join(f"{call.name}({', '.join(map(str, call.arguments))})" for call in offered.calls)
        for choice in derivation.choices
        for offered in choice.alternatives
    ]
    assert offers == said["offers"]


def test_every_example_is_run() -> None:
    assert len(EXAMPLES) == PAGE.count("```rules") == 5


def test_every_function_and_limit_is_on_the_page() -> None:
    assert [name for name in BUILTINS if f"`{name}(" not in PAGE] == []
    for limit in (Limits().facts, Limits().rounds):
        assert f"{limit:,}".replace(",", " ") in PAGE


def _fact(text: str) -> tuple[Fact, float | None]:
    match = FACT.fullmatch(text.strip())
    assert match is not None, text
    name, arguments, priority = match.groups()
    return Fact(name, tuple(map(_argument, arguments.split(", ")))), float(priority) if priority else None


def _argument(text: str) -> Argument:
    if text.isdigit():
        return int(text)
    return float(text) if text[0].isdigit() else text

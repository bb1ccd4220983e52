"""docs/errors.md lists every code that the program can give, with the HTTP status that tells it, and no other."""

import ast
import re
from collections import defaultdict
from collections.abc import Iterator
from functools import cache, partial
from pathlib import Path

import pytest

from understudy import errors
from understudy.api.problems import status_of
from understudy.errors import (
    MOST_COMPARED,
    AuthoringError,
    Mistake,
    UnderstudyError,
    all_loaded,
    did_you_mean,
    nearest_names,
)

ROOT = Path(__file__).resolve().parents[1]
DOCUMENTED = dict(re.findall(r"^\| `(\w+)` \| (\w+) \|", (ROOT / "docs/errors.md").read_text(), re.MULTILINE))
OF_THE_FRAMEWORK = {"not_found", "method_not_allowed", "not_acceptable", "http_error"}


@cache
def _codes() -> dict[str, set[str]]:
    """Every code that stands in the source, with the statuses (or "warning") of the calls that it stands in, or that
    such a call says."""
    found: dict[str, set[str]] = defaultdict(set)
    for path in (ROOT / "app").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef):
                for code, status in _of_class(node):
                    found[code].add(status)
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                if node.func.id == "problem" and all(isinstance(argument, ast.Constant) for argument in node.args[:2]):
                    status, code = (ast.literal_eval(argument) for argument in node.args[:2])
                    found[code].add(str(status))
                literals = [a.value for a in node.args[:2] if isinstance(a, ast.Constant) and isinstance(a.value, str)]
                if literals and (told := _told_by(node.func.id)):
                    found[literals[0]].add(told)
    return found


def _of_class(kind: ast.ClassDef) -> Iterator[tuple[str, str]]:
    """The code that a kind of error with a code of its own gives to the kind that it is one of."""
    for node in ast.walk(kind):
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "super().__init__" and node.args:
            told = _told_by(ast.unparse(kind.bases[0]))
            if told and isinstance(node.args[0], ast.Constant) and isinstance(node.args[0].value, str):
                yield node.args[0].value, told


def _told_by(name: str) -> str | None:
    """How the code that is given to a call of `name` is told; None when it takes no code."""
    if name == "Notice":
        return "warning"
    if name == "_wrong":
        return "422"
    kind = getattr(errors, name, None)
    if isinstance(kind, type) and issubclass(kind, UnderstudyError) and kind is not AuthoringError:
        return "service" if kind is errors.ServiceError else str(status_of(kind("", "")))
    return None


def test_the_page_lists_every_code_and_no_other() -> None:
    assert set(DOCUMENTED) == _codes().keys() | OF_THE_FRAMEWORK | {"authoring"}


def test_the_page_tells_each_code_as_the_service_does() -> None:
    assert {code: told for code, told in DOCUMENTED.items() if not _is_told(code, told)} == {}


def _is_told(code: str, documented: str) -> bool:
    """Whether the service tells the code with the status that the page has; the framework's own codes are not ours."""
    statuses = _codes().get(code, {documented})
    if statuses == {"service"}:
        return documented == str(status_of(errors.ServiceError(code, "")))
    if documented == "4XX":
        return all(status.startswith("4") for status in statuses)
    return documented in statuses


def test_a_mistake_shows_its_place_under_its_line() -> None:
    mistake = Mistake(Path("a.rules"), 3, 5, "unknown predicate", "    fcnn(a)")
    assert str(mistake).splitlines() == ["a.rules:3:5: unknown predicate", "        fcnn(a)", "        ^"]
    assert str(AuthoringError((mistake, Mistake(Path("b"), 1, 1, "empty")))).endswith("^\nb:1:1: empty")


def _wrong(name: str) -> int:
    raise AuthoringError((Mistake(Path(name), 1, 1, "wrong"),))


def test_the_mistakes_of_several_files_come_together() -> None:
    with pytest.raises(AuthoringError) as caught:
        all_loaded([partial(_wrong, "a"), partial(_wrong, "b")])
    assert [mistake.path.name for mistake in caught.value.mistakes] == ["a", "b"]
    assert all_loaded([int, int]) == (0, 0)


def test_the_nearest_name_is_suggested_and_nothing_where_none_is_near() -> None:
    assert did_you_mean("negaton", ("affirmation", "negation")) == "; did you mean 'negation'?"
    assert did_you_mean("zzz", ("affirmation", "negation")) == ""
    assert did_you_mean("zzz", ("negation",), otherwise="; see rules list") == "; see rules list"


def test_several_names_are_suggested_where_asked_for() -> None:
    assert did_you_mean("nodd", ("nod", "nods", "shake"), most=3) == "; did you mean 'nod' or 'nods'?"


def test_a_very_long_name_or_list_costs_no_more() -> None:
    assert nearest_names("x" * 1_000_000, ("x" * 200,)) == ("x" * 200,)
    assert nearest_names("near", (f"name{number}" for number in range(MOST_COMPARED * 2)), most=1) == ()

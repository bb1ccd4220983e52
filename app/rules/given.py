"""Functions that the author or an agent gives with a line, in addition to those the rules derive (paper §3.3).

They take part in the derivation as facts, keep their own priority, and win every conflict with derived ones.
"""

from collections.abc import Mapping, Sequence

from ..errors import InputError
from ..model import Because, Fact, GivenFunction
from .priorities import Priorities

GIVEN_PRIORITY = 10.0
"""The default priority, above all that rules derive, so that the movements for them win as well."""

GIVEN_RULE = "given"
GIVEN = Because(fact="given with the line")
"""The support of a given function; `GIVEN_RULE` stands in place of its rule."""

FIELD = "functions"


def given_facts(given: Sequence[GivenFunction], priorities: Priorities, *, words: int) -> Mapping[Fact, float]:
    """The functions as facts with their priorities; if a function is given twice the higher priority counts.

    Raises InputError `functions_class` for an unknown class or subtype, `functions_span` for words that are not among
    the line's `words`.
    """
    facts: dict[Fact, float] = {}
    for number, function in enumerate(given):
        _check(number, function, priorities, words)
        fact = Fact("fcn", (function.class_name, function.subtype, function.first, function.last + 1))
        priority = GIVEN_PRIORITY if function.priority is None else function.priority
        facts[fact] = max(priority, facts.get(fact, priority))
    return facts


def _check(number: int, function: GivenFunction, priorities: Priorities, words: int) -> None:
    where = f"functions[{number}]"
    reason = priorities.unknown(function.class_name, function.subtype)
    if reason:
        raise InputError("functions_class", f"{where}: {reason}", field=FIELD)
    if not 0 <= function.first <= function.last < words:
        span = f"first {function.first}, last {function.last}"
        limits = f"the line's words are 0 to {words - 1}, and first comes before last"
        raise InputError("functions_span", f"{where}: {span}: {limits}", field=FIELD)

"""Computes annotations when all facts are known, independently of the order in which rules ran.

Every match of a rule *claims* an annotation for the fact it asserts; the highest claim counts. A claim that depends on
other facts' annotations is evaluated when these are final: facts are processed in order of dependence. Facts whose
claims depend on each other cyclically (a *knot*; the smallest is a fact raised by a rule that joins it) have no such
order. In a knot, claims that do not depend on the knot are evaluated first; then, in rounds, every claim whose facts
have values by then, each claim once, all claims of a round with the values before the round. So a rule that raises the
annotation of a fact it joins does so once, from the value without that rule; two such rules on one fact raise it to the
higher of both, not twice.
"""

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from ...model import Fact
from ..knowledge import Claim


def annotate(claims: Sequence[Claim], annotations: dict[Fact, float]) -> None:
    """Add to `annotations`, which contains given values and unconditional claims, the values that result from
    `claims`."""
    claims_on: defaultdict[Fact, list[Claim]] = defaultdict(list)
    for claim in claims:
        claims_on[claim.fact].append(claim)
    for knot in _knots(claims_on):
        _settle(set(knot), [claim for fact in knot for claim in claims_on[fact]], annotations)


def _settle(knot: set[Fact], claims: Sequence[Claim], annotations: dict[Fact, float]) -> None:
    entering, waiting = _parted(claims, lambda claim: knot.isdisjoint(claim.reads))
    _make(entering, annotations)
    while waiting:
        ready, waiting = _parted(waiting, lambda claim: all(fact in annotations for fact in claim.reads))
        _make(ready, annotations)


def _parted(claims: Sequence[Claim], holds: Callable[[Claim], bool]) -> tuple[list[Claim], list[Claim]]:
    """The claims that satisfy the condition, and the others."""
    parts: tuple[list[Claim], list[Claim]] = ([], [])
    for claim in claims:
        parts[not holds(claim)].append(claim)
    return parts


def _make(claims: Sequence[Claim], annotations: dict[Fact, float]) -> None:
    """Evaluate these claims at once: none sees the result of another."""
    claimed = [(claim.fact, claim.value(annotations)) for claim in claims]
    for fact, value in claimed:
        if fact not in annotations or value > annotations[fact]:
            annotations[fact] = value


def _knots(claims_on: Mapping[Fact, Sequence[Claim]]) -> Iterator[list[Fact]]:
    """The strongly connected components of the dependence between facts, dependencies first (Tarjan's algorithm)."""
    search = _Search(claims_on)
    for root in claims_on:
        if root in search.number:
            continue
        ways = [(root, search.enter(root))]
        while ways:
            fact, reads = ways[-1]
            onward = next(reads, None)
            if onward is None:
                ways.pop()
                if ways:
                    search.lower(ways[-1][0], search.low[fact])
                if search.low[fact] == search.number[fact]:
                    yield search.leave(fact)
            elif onward not in search.number:
                ways.append((onward, search.enter(onward)))
            elif onward in search.open:
                search.lower(fact, search.number[onward])


@dataclass(slots=True)
class _Search:
    """The state of Tarjan's search: visit numbers, lowest number reachable from each, and the stack of open facts."""

    claims_on: Mapping[Fact, Sequence[Claim]]
    number: dict[Fact, int] = field(default_factory=dict)
    low: dict[Fact, int] = field(default_factory=dict)
    open: dict[Fact, None] = field(default_factory=dict)

    def enter(self, fact: Fact) -> Iterator[Fact]:
        """Number the fact; yields the facts it depends on that have claims and are still to be visited."""
        self.number[fact] = self.low[fact] = len(self.number)
        self.open[fact] = None
        return iter([read for claim in self.claims_on[fact] for read in claim.reads if read in self.claims_on])

    def lower(self, fact: Fact, number: int) -> None:
        self.low[fact] = min(self.low[fact], number)

    def leave(self, root: Fact) -> list[Fact]:
        """The knot whose first fact is `root`."""
        knot = []
        while root in self.open:
            knot.append(self.open.popitem()[0])
        return knot

"""Computes annotations when all facts are known, so that the order in which rules ran cannot matter.

Every match of a rule *claims* an annotation for the fact it asserts; the highest claim counts. A claim that reads
other facts' annotations reads them when they are final: facts are taken in order of dependence. Facts whose claims
read each other in a circle (a *knot*; the smallest is a fact raised by a rule that joins it) have no such order. In a
knot, the claims that read nothing of the knot come first; then, in turns, every claim whose facts have values by then
is made, all claims of a turn on the values before the turn, and each claim once. So a rule that raises what it joins
raises each fact once, from the value it has without that rule; two such rules on one fact raise it to the higher of
both, not twice.
"""

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from ..knowledge import Claim, Fact


def annotate(claims: Sequence[Claim], annotations: dict[Fact, float]) -> None:
    """Adds to `annotations`, which holds what was given and what was claimed outright, what `claims` make of it."""
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
    """The claims for which something holds, and the others."""
    parts: tuple[list[Claim], list[Claim]] = ([], [])
    for claim in claims:
        parts[not holds(claim)].append(claim)
    return parts


def _make(claims: Sequence[Claim], annotations: dict[Fact, float]) -> None:
    """Make these claims at once: none sees what another claims."""
    claimed = [(claim.fact, claim.value(annotations)) for claim in claims]
    for fact, value in claimed:
        if fact not in annotations or value > annotations[fact]:
            annotations[fact] = value


def _knots(claims_on: Mapping[Fact, Sequence[Claim]]) -> Iterator[list[Fact]]:
    """The strongly connected components of "reads", what is read before what reads it (Tarjan's algorithm)."""
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
    """Where Tarjan's search stands: numbers by first visit, the lowest reached from each, what is not settled yet."""

    claims_on: Mapping[Fact, Sequence[Claim]]
    number: dict[Fact, int] = field(default_factory=dict)
    low: dict[Fact, int] = field(default_factory=dict)
    open: dict[Fact, None] = field(default_factory=dict)

    def enter(self, fact: Fact) -> Iterator[Fact]:
        """Number the fact; the facts it reads, as far as there are claims on them, are still to be visited."""
        self.number[fact] = self.low[fact] = len(self.number)
        self.open[fact] = None
        return iter([read for claim in self.claims_on[fact] for read in claim.reads if read in self.claims_on])

    def lower(self, fact: Fact, number: int) -> None:
        self.low[fact] = min(self.low[fact], number)

    def leave(self, root: Fact) -> list[Fact]:
        """The knot that `root` was the first of."""
        knot = []
        while root in self.open:
            knot.append(self.open.popitem()[0])
        return knot

"""What a mapping rule's offer adds to the worth of a movement, in log-odds (paper §3.4).

The paper decides by priority alone. Here a function's priority and an alternative's weight are two parts of one sum: an
offer adds `OFFERED`, `PRIORITY_SCALE` for each unit of priority above the usual and `WEIGHT_SCALE` for the logarithm of
the weight, and never speaks against a movement. The scales are those with
which held-out directed lines are planned best (`python -m training.acting.constants`).
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import log

from ...model import BehaviorCandidates, Function, Term

OFFERED = 0.0
PRIORITY_SCALE, USUAL_PRIORITY = 0.1, 3.0
WEIGHT_SCALE, USUAL_WEIGHT = 0.5, 1.0
GREAT_WEIGHT, GREAT_SCALE = 20.0, 3.6
"""From the heaviest of our own rules on a weight counts by another scale. Nothing could fit it; it is set so that a
weight of 100 is seen on most words, whatever the reading says, and 20 hardly (docs/choice.md)."""


@dataclass(frozen=True, slots=True)
class Support:
    """The offer of rule `rule` to show `function` with the behaviour `name`, as one alternative of this weight."""

    name: str
    rule: str
    function: Function
    weight: float

    @property
    def log_odds(self) -> float:
        """What the offer adds."""
        return max(0.0, OFFERED + self._of_priority + self._of_weight)

    @property
    def parts(self) -> tuple[Term, ...]:
        """The named parts of that."""
        if self.log_odds == 0:
            return ()
        kind = self.function.class_name
        parts = (
            Term(f"rule {self.rule}, weight {self.weight:g}", round(OFFERED + self._of_weight, 2)),
            Term(f"priority {self.function.priority:g} of {kind}", round(self._of_priority, 2)),
        )
        return tuple(part for part in parts if part.weight)

    @property
    def _of_priority(self) -> float:
        return PRIORITY_SCALE * (self.function.priority - USUAL_PRIORITY)

    @property
    def _of_weight(self) -> float:
        usual, great = min(self.weight, GREAT_WEIGHT), max(self.weight, GREAT_WEIGHT)
        return WEIGHT_SCALE * log(usual / USUAL_WEIGHT) + GREAT_SCALE * log(great / GREAT_WEIGHT)


def supports_of(offers: Iterable[BehaviorCandidates]) -> Iterator[Support]:
    """The support that each alternative gives to each of its movements."""
    for offer in offers:
        if offer.function is not None:
            for alternative in offer.alternatives:
                for movement in alternative.movements:
                    if alternative.weight > 0:
                        yield Support(movement.name, movement.rule, offer.function, alternative.weight)


def strongest(supports: Iterable[Support]) -> dict[str, Support]:
    """The strongest support of each behaviour, by its name; of equal ones the first."""
    best: dict[str, Support] = {}
    for support in supports:
        if support.name not in best or support.log_odds > best[support.name].log_odds:
            best[support.name] = support
    return best

"""Reports behaviours that are played at other times than the schedule asks for.

Of what a document states, each sync point is looked at. Of a schedule of ours start and end are, and what a decision
tells already, a blend or a longer hold, is not told twice.
"""

from collections.abc import Iterable, Iterator, Mapping

from ...model import Behavior, SyncPoints
from ..body.motion import Decision

NOTICEABLE_S = 0.05
"""Three frames at 60 a second."""

_STARTS_TOLD = frozenset({"blended", "shortened", "late", "dropped"})
_ENDS_TOLD = frozenset({"held", "cut", "dropped"})
_WORDS: Mapping[str, str] = {
    "start": "begins",
    "ready": "is ready",
    "stroke_start": "begins its stroke",
    "stroke": "strokes",
    "stroke_end": "ends its stroke",
    "relax": "relaxes",
    "end": "ends",
}


def timing_deviations(
    behaviors: Iterable[Behavior],
    realized: Mapping[str, SyncPoints],
    decisions: Iterable[Decision],
    asked: Mapping[str, frozenset[str]],
) -> Iterator[Decision]:
    """A decision `timed` for each kept behaviour of which a point that is `asked` for comes `NOTICEABLE_S` or more from
    its time; of behaviours that are not in it, start and end are."""
    told: dict[str, set[str]] = {}
    for decision in decisions:
        told.setdefault(decision.behavior, set()).add(decision.action)
    for behavior in behaviors:
        made = realized.get(behavior.id)
        if behavior.kept and made is not None:
            points = asked.get(behavior.id, _untold(told.get(behavior.id, set())))
            reason = "; ".join(_apart(behavior.sync, made, points))
            if reason:
                yield Decision(behavior.id, "timed", reason)


def _untold(told: set[str]) -> frozenset[str]:
    """The points of a behaviour of ours of which no decision tells."""
    starts, ends = {"start"} if not told & _STARTS_TOLD else set(), {"end"} if not told & _ENDS_TOLD else set()
    return frozenset(starts | ends)


def _apart(asked: SyncPoints, made: SyncPoints, points: frozenset[str]) -> Iterator[str]:
    made_s = dict(made.in_order())
    for name, asked_s in asked.in_order():
        if name in points and name in made_s and abs(made_s[name] - asked_s) >= NOTICEABLE_S:
            yield f"{_WORDS[name]} at {made_s[name]:.2f} s, not at {asked_s:.2f} s"

"""Reports behaviours that begin or end at other times than the schedule asks for.

A gesture is never stretched: its stroke is at its time, and its preparation and retraction take what they take, so that
one for which more or less time was asked begins or ends at another. What a decision tells already, a blend or a longer
hold, is not told twice.
"""

from collections.abc import Iterable, Iterator, Mapping

from ...model import Behavior, SyncPoints
from ..body.motion import Decision

NOTICEABLE_S = 0.05
"""Three frames at 60 a second."""

_STARTS_TOLD = frozenset({"blended", "shortened", "late", "dropped"})
_ENDS_TOLD = frozenset({"held", "cut", "dropped"})


def timing_deviations(
    behaviors: Iterable[Behavior], realized: Mapping[str, SyncPoints], decisions: Iterable[Decision]
) -> Iterator[Decision]:
    """A decision `timed` for each kept behaviour that begins or ends `NOTICEABLE_S` or more from its time."""
    told: dict[str, set[str]] = {}
    for decision in decisions:
        told.setdefault(decision.behavior, set()).add(decision.action)
    for behavior in behaviors:
        made = realized.get(behavior.id)
        if behavior.kept and made is not None:
            reason = "; ".join(_apart(behavior.sync, made, told.get(behavior.id, set())))
            if reason:
                yield Decision(behavior.id, "timed", reason)


def _apart(asked: SyncPoints, made: SyncPoints, told: set[str]) -> Iterator[str]:
    if abs(made.start - asked.start) >= NOTICEABLE_S and not told & _STARTS_TOLD:
        yield f"begins at {made.start:.2f} s, not at {asked.start:.2f} s"
    if abs(made.end - asked.end) >= NOTICEABLE_S and not told & _ENDS_TOLD:
        yield f"ends at {made.end:.2f} s, not at {asked.end:.2f} s"

"""Behaviours that overlap on a channel, or are too close to be played: the higher priority stays (paper §3.5).

Gestures compete hand by hand, everything else channel by channel. Candidates are taken in order of priority, the
earlier first among equals. One that does not fit beside those taken before is shortened to what its phases need at
least; if that is not enough, the retraction of its predecessor gives way to its preparation, which joins the two into
one gesture unit (§3.8); if that is not enough either, it is dropped. What is dropped stays, with the winner's id and
the reason. Gestures also share a budget, the most that the character makes in the time.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from app.bml.phases import Placing, Window, placed
from app.model import Behavior, Channel, Hand


@dataclass(frozen=True, slots=True)
class Candidate:
    """A behaviour with what it is timed by."""

    behavior: Behavior
    placing: Placing

    @property
    def firm_end_s(self) -> float:
        """The earliest it can be over without loss of stroke or hold."""
        sync = self.behavior.sync
        return min(sync.end, (sync.relax or sync.end) + self.placing.timing.retraction.shortest_s)

    def within(self, window: Window, neighbour: Behavior) -> "Candidate | None":
        """The candidate in a window that a neighbour leaves; None when it does not fit."""
        sync = placed(self.placing, window)
        if sync is None:
            return None
        reason = self.behavior.reason or _shortened_beside(neighbour)
        return replace(self, behavior=replace(self.behavior, sync=sync, reason=reason))


def resolve(candidates: Iterable[Candidate], *, most_gestures: int) -> tuple[Behavior, ...]:
    """Every candidate's behaviour, kept or not; the kept ones do not overlap on any channel or hand."""
    kept: tuple[Candidate, ...] = ()
    lost: list[Behavior] = []
    for candidate in sorted(candidates, key=_rank):
        if _spent(candidate, kept, most_gestures):
            reason = f"beyond the character's gesture rate, which gives this line {most_gestures}"
            lost.append(replace(candidate.behavior, kept=False, reason=reason))
            continue
        outcome = _taken(candidate, kept)
        if isinstance(outcome, Behavior):
            lost.append(outcome)
        else:
            kept = outcome
    return (*(candidate.behavior for candidate in kept), *lost)


def _rank(candidate: Candidate) -> tuple[float, float, str]:
    behavior = candidate.behavior
    return -behavior.priority, candidate.placing.at_s, behavior.id


def _spent(candidate: Candidate, kept: Sequence[Candidate], most_gestures: int) -> bool:
    if candidate.behavior.kind is not Channel.GESTURE:
        return False
    return sum(other.behavior.kind is Channel.GESTURE for other in kept) >= most_gestures


def _taken(candidate: Candidate, kept: tuple[Candidate, ...]) -> tuple[Candidate, ...] | Behavior:
    """What is kept with the candidate, or the candidate's behaviour as a loser."""
    rivals = [other for other in kept if _compete(other.behavior, candidate.behavior)]
    earlier = [other for other in rivals if other.placing.at_s <= candidate.placing.at_s]
    later = [other for other in rivals if other.placing.at_s > candidate.placing.at_s]
    begin_s = max((other.behavior.sync.end for other in earlier), default=0.0)
    firm_begin_s = max((other.firm_end_s for other in earlier), default=0.0)
    finish_s = min((other.behavior.sync.start for other in later), default=Window().to_s)
    sync = candidate.behavior.sync
    if begin_s <= sync.start and sync.end <= finish_s:
        return (*kept, candidate)
    neighbour = _neighbour(candidate, earlier, later)
    fitted = candidate.within(Window(begin_s, finish_s), neighbour)
    if fitted is not None:
        return (*kept, fitted)
    fitted = candidate.within(Window(firm_begin_s, finish_s), neighbour)
    if fitted is None:
        return _beaten(candidate.behavior, neighbour)
    return (*(_making_way(other, fitted) if other in earlier else other for other in kept), fitted)


def _making_way(earlier: Candidate, later: Candidate) -> Candidate:
    """The earlier one, its retraction over where the later begins."""
    start_s = later.behavior.sync.start
    if earlier.behavior.sync.end <= start_s:
        return earlier
    reason = earlier.behavior.reason or _shortened_beside(later.behavior)
    sync = replace(earlier.behavior.sync, end=start_s)
    return replace(earlier, behavior=replace(earlier.behavior, sync=sync, reason=reason))


def _shortened_beside(neighbour: Behavior) -> str:
    return f"shortened beside {neighbour.id} ({neighbour.lexeme})"


def _neighbour(candidate: Candidate, earlier: Sequence[Candidate], later: Sequence[Candidate]) -> Behavior:
    """The rival that leaves the candidate too little time: the one before it, unless it fits behind that."""
    if earlier:
        before = max(earlier, key=lambda other: other.firm_end_s)
        if not later or placed(candidate.placing, Window(before.firm_end_s)) is None:
            return before.behavior
    return min(later, key=lambda other: other.behavior.sync.start).behavior


def _beaten(behavior: Behavior, winner: Behavior) -> Behavior:
    standing = "also has" if winner.priority == behavior.priority else "has"
    against = "" if winner.priority == behavior.priority else f", not {behavior.priority:g}"
    reason = f"too close to {winner.id} ({winner.lexeme}), which {standing} priority {winner.priority:g}{against}"
    return replace(behavior, kept=False, lost_to=winner.id, reason=reason)


def _compete(one: Behavior, other: Behavior) -> bool:
    if one.kind is not other.kind:
        return False
    return one.kind is not Channel.GESTURE or one.hand is other.hand or Hand.BOTH in (one.hand, other.hand)

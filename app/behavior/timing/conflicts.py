"""Resolves conflicts between behaviours that overlap on a channel, or are too close to be played: the first one stays
(paper §3.5).

Candidates come in the order of their priority. Gestures compete hand by hand, faces by the half of the face that they
move, everything else channel by channel; a look aside, which turns the head, competes with head movements. A candidate
that does not fit beside those taken before is shortened to the least durations of its phases; a look whose head is
taken is made with the eyes alone. If that is not enough, the retraction of its predecessor is cut, and then its hold,
which joins the two into one gesture unit (§3.8); a gesture may then come `EARLY_S` before its word, or its successor
may begin later, or its stroke, and then its successor's, is made smaller and shorter. A planned head movement or face,
which is meant for all of its words, may come on another of them. If that is not enough either, the candidate loses,
with the winner's id and the reason.

Between two gestures of a hand there is at least the time for the transition (`understudy.model.limits`),
by which the realizer judges them too: what is kept can be played.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from ...model import Behavior, Channel, Hand
from ...model.limits import TransitionTimes, transition_times
from ...model.tables import GLANCE, LIDS_AND_CHEEKS, LOOK, LOWER_FACE
from ..table.behavior_table import PhaseDuration
from .anchoring import PlacedBehavior
from .phases import Window, placed
from .time_index import TimeIndex

Kept = tuple[PlacedBehavior, ...]
"""The candidates taken so far, without overlaps on a channel or hand."""


@dataclass(frozen=True, slots=True)
class FittedBehavior:
    """A candidate as it fits, and everything kept with it."""

    candidate: PlacedBehavior
    kept: TimeIndex

    @property
    def shortened(self) -> bool:
        return self.candidate.behavior.reason is not None


EARLY_S = 0.1
"""How much earlier than its word a gesture may be made to fit: a syllable."""

BRIEFLY = "smaller and shorter than usual: there is too little time"

ELSEWHERE = "on another of its words, to have time beside its neighbour"

REACH_S = 5.0
"""Behaviours farther apart than this cannot affect each other: no transition takes half as long."""

NEAR_S = 1.0
"""If a gesture ends this long before another begins, the hand has time to return."""


def resolve(candidates: Iterable[PlacedBehavior], kept: Kept = ()) -> tuple[Kept, tuple[Behavior, ...]]:
    """The candidates that fit beside those kept, by priority, and those that do not."""
    by_time, lost = TimeIndex(kept), list[Behavior]()
    for candidate in sorted(candidates, key=_rank):
        outcome = fitted(candidate, by_time)
        if isinstance(outcome, FittedBehavior):
            by_time = outcome.kept
        else:
            lost.append(outcome)
    return tuple(by_time), tuple(lost)


def fitted(candidate: PlacedBehavior, kept: TimeIndex) -> FittedBehavior | Behavior:
    """The candidate among the kept; its behaviour as a loser if it does not fit."""
    rivals = [other for other in _near(candidate, kept) if compete(other.behavior, candidate.behavior)]
    earlier = [other for other in rivals if other.basis.at_s <= candidate.basis.at_s]
    later = [other for other in rivals if other.basis.at_s > candidate.basis.at_s]
    candidate = _with_way(candidate, earlier)
    (_, window), sync = next(_in_windows(candidate, earlier, later, _latest_end_s)), candidate.behavior.sync
    if window.from_s <= sync.start and sync.end <= window.to_s:
        return FittedBehavior(candidate, kept.with_one_more(candidate))
    heads = [other.behavior for other in rivals if other.behavior.kind is Channel.HEAD and _overlap(candidate, other)]
    if candidate.behavior.kind is Channel.GAZE and heads:
        return fitted(_with_the_eyes_alone(candidate, heads[0]), kept)
    neighbour = _neighbour(candidate, earlier, later)
    for moved, window in _ways_to_fit(candidate, earlier, later):
        within = _within(moved, window, neighbour)
        if within is not None:
            changed = [(each, _making_way(each, within)) for each in earlier]
            changed += [(each, _waiting(each, within)) for each in later]
            return FittedBehavior(within, kept.with_one_more(within, changed))
    return _elsewhere(candidate, kept) or beaten(candidate.behavior, neighbour)


def _elsewhere(candidate: PlacedBehavior, kept: TimeIndex) -> FittedBehavior | None:
    """The candidate on the nearest other of its words on which it fits; None where it fits on none or has none."""
    for at_s in candidate.elsewhere_s:
        basis = replace(candidate.basis, at_s=at_s)
        sync = placed(basis, Window())
        if sync is not None:
            behavior = replace(candidate.behavior, sync=sync, reason=ELSEWHERE)
            outcome = fitted(replace(candidate, behavior=behavior, basis=basis, elsewhere_s=()), kept)
            if isinstance(outcome, FittedBehavior):
                return outcome
    return None


def _near(candidate: PlacedBehavior, kept: TimeIndex) -> Kept:
    """Those kept that may affect the candidate, with a margin; in a long line these are few."""
    sync = candidate.behavior.sync
    return kept.near(sync.start - REACH_S, sync.end + REACH_S) or tuple(kept)


def _ways_to_fit(
    candidate: PlacedBehavior, earlier: Sequence[PlacedBehavior], later: Sequence[PlacedBehavior]
) -> Iterator[tuple[PlacedBehavior, Window]]:
    """Variants of the candidate with the windows that its neighbours leave it, the least changed first."""
    yield from _in_windows(candidate, earlier, later, _latest_end_s)
    if candidate.brief is None:
        return
    made = (candidate, _with_way(_made_brief(candidate), earlier))
    for latest_end_s in (_end_before_stroke_s, _end_before_brief_stroke_s):
        for each in made:
            yield from _in_windows(each, earlier, later, latest_end_s)


def _in_windows(
    candidate: PlacedBehavior,
    earlier: Sequence[PlacedBehavior],
    later: Sequence[PlacedBehavior],
    latest_end_s: Callable[[PlacedBehavior, PlacedBehavior], float],
) -> Iterator[tuple[PlacedBehavior, Window]]:
    """Windows for the candidate at its word and then a little before it (a stroke cannot be shorter): with the
    neighbours as they are, then without the predecessor's retraction, then without its hold."""
    for moved in _moved(candidate):
        to_s = min((latest_end_s(moved, each) for each in later), default=Window().to_s)
        yield moved, Window(max((each.behavior.sync.end for each in earlier), default=0.0), to_s)
        yield moved, Window(max((each.firm_end_s for each in earlier), default=0.0), to_s)
        yield moved, Window(max((each.stroke_end_s for each in earlier), default=0.0), to_s)


def _moved(candidate: PlacedBehavior) -> Iterator[PlacedBehavior]:
    yield candidate
    if candidate.own_forms:
        basis = replace(candidate.basis, at_s=candidate.basis.at_s - EARLY_S)
        reason = f"{EARLY_S:g} s before its word, to be in time for its neighbour"
        yield replace(candidate, basis=basis, behavior=replace(candidate.behavior, reason=reason))


def _with_way(candidate: PlacedBehavior, earlier: Sequence[PlacedBehavior]) -> PlacedBehavior:
    """The candidate with a preparation no shorter than its hand's transition from the gesture before it."""
    sync, basis = candidate.behavior.sync, candidate.basis
    near = [each for each in earlier if sync.start - each.behavior.sync.end < NEAR_S]
    shortest_s = max((transition(each, candidate).shortest_s for each in near), default=0.0)
    if not shortest_s:
        return candidate
    usual = basis.timing.preparation
    preparation = PhaseDuration(shortest_s, max(usual.usual_s, shortest_s))
    return replace(candidate, basis=replace(basis, timing=replace(basis.timing, preparation=preparation)))


def _latest_end_s(candidate: PlacedBehavior, later: PlacedBehavior) -> float:
    """When a candidate must end for the later one to begin, and for its stroke to be in time."""
    sync = later.behavior.sync
    start_s = sync.start if sync.stroke_start is None else sync.stroke_start
    return min(sync.start, start_s - transition(candidate, later).shortest_s)


def _end_before_stroke_s(candidate: PlacedBehavior, later: PlacedBehavior) -> float:
    """The same if the later one's preparation may begin later."""
    sync = later.behavior.sync
    start_s = sync.start if sync.stroke_start is None else sync.stroke_start
    return start_s - transition(candidate, later).shortest_s


def _end_before_brief_stroke_s(candidate: PlacedBehavior, later: PlacedBehavior) -> float:
    """The same if the later one's stroke may be brief as well."""
    return _end_before_stroke_s(candidate, _made_brief(later))


def transition(first: PlacedBehavior, second: PlacedBehavior) -> TransitionTimes:
    """The transition times from a gesture to the next; 0 for other behaviours."""
    amounts = first.behavior.amount, second.behavior.amount
    return transition_times(first.own_forms, second.own_forms, amounts=amounts)


def beaten(behavior: Behavior, winner: Behavior) -> Behavior:
    """The behaviour as the loser to one that leaves it too little time."""
    standing = "also has" if winner.priority == behavior.priority else "has"
    against = "" if winner.priority == behavior.priority else f", not {behavior.priority:g}"
    reason = f"too close to {winner.lexeme}, which {standing} priority {winner.priority:g}{against}"
    return replace(behavior, kept=False, lost_to=winner.id, reason=reason)


def compete(one: Behavior, other: Behavior) -> bool:
    """Whether two behaviours move the same part of the body."""
    if one.kind is not other.kind:
        return _turns_the_head(one, other) or _turns_the_head(other, one)
    if one.kind is Channel.FACE:
        return _part_of_face(one) == _part_of_face(other)
    return one.kind is not Channel.GESTURE or one.hand is other.hand or Hand.BOTH in (one.hand, other.hand)


def _part_of_face(face: Behavior) -> tuple[bool, bool]:
    """Mouth and nose, lids and cheeks, or brows: what moves by itself."""
    return face.lexeme in LOWER_FACE, face.lexeme in LIDS_AND_CHEEKS


def _turns_the_head(gaze: Behavior, head: Behavior) -> bool:
    """Whether `gaze` is a look aside with the head and `head` a head movement."""
    return gaze.lexeme == LOOK and gaze.direction is not None and head.kind is Channel.HEAD


def _overlap(one: PlacedBehavior, other: PlacedBehavior) -> bool:
    return one.behavior.sync.start < other.behavior.sync.end and other.behavior.sync.start < one.behavior.sync.end


def _with_the_eyes_alone(look: PlacedBehavior, head: Behavior) -> PlacedBehavior:
    reason = f"with the eyes alone: the head makes a {head.lexeme}"
    return replace(look, behavior=replace(look.behavior, lexeme=GLANCE, reason=reason))


def _rank(candidate: PlacedBehavior) -> tuple[float, float, str]:
    behavior = candidate.behavior
    return -behavior.priority, candidate.basis.at_s, behavior.id


def _within(candidate: PlacedBehavior, window: Window, neighbour: Behavior) -> PlacedBehavior | None:
    """The candidate in a window that a neighbour leaves; None if it does not fit."""
    sync = placed(candidate.basis, window)
    if sync is None:
        return None
    reason = candidate.behavior.reason or _shortened_beside(neighbour)
    return replace(candidate, behavior=replace(candidate.behavior, sync=sync, reason=reason))


def _making_way(earlier: PlacedBehavior, later: PlacedBehavior) -> PlacedBehavior:
    """The earlier one, ended where the later begins: its retraction and if necessary its hold are cut."""
    start_s = later.behavior.sync.start
    if earlier.behavior.sync.end <= start_s:
        return earlier
    reason = earlier.behavior.reason or _shortened_beside(later.behavior)
    sync = earlier.behavior.sync
    relax_s = None if sync.relax is None else min(sync.relax, start_s)
    sync = replace(sync, relax=relax_s, end=start_s)
    return replace(earlier, behavior=replace(earlier.behavior, sync=sync, reason=reason))


def _waiting(later: PlacedBehavior, earlier: PlacedBehavior) -> PlacedBehavior:
    """The later one, begun when the earlier one ends; its stroke is brief if the transition requires that."""
    if not compete(later.behavior, earlier.behavior) or later.behavior.sync.start >= earlier.behavior.sync.end:
        return later
    if earlier.behavior.sync.end > _end_before_stroke_s(earlier, later):
        later = _made_brief(later)
    reason = later.behavior.reason or _shortened_beside(earlier.behavior)
    sync = replace(later.behavior.sync, start=earlier.behavior.sync.end)
    return replace(later, behavior=replace(later.behavior, sync=sync, reason=reason))


def _made_brief(gesture: PlacedBehavior) -> PlacedBehavior:
    """A gesture with its brief stroke, which ends when the whole one would; unchanged if it has none."""
    brief, sync = gesture.brief, gesture.behavior.sync
    if brief is None or sync.stroke_end is None:
        return gesture
    timing = replace(brief.timing, preparation=gesture.basis.timing.preparation)
    start_s = round(sync.stroke_end - timing.stroke.usual_s, 3)
    stroke_s = round(start_s + timing.emphasis * timing.stroke.usual_s, 3)
    sync = replace(sync, ready=start_s, stroke_start=start_s, stroke=stroke_s)
    behavior = replace(gesture.behavior, sync=sync, reason=BRIEFLY)
    return PlacedBehavior(behavior, replace(gesture.basis, timing=timing), brief.forms, brief)


def _shortened_beside(neighbour: Behavior) -> str:
    return f"shortened to make room for {neighbour.lexeme}"


def _neighbour(
    candidate: PlacedBehavior, earlier: Sequence[PlacedBehavior], later: Sequence[PlacedBehavior]
) -> Behavior:
    """The rival that leaves the candidate too little time: the one before it, unless the candidate fits after that."""
    if earlier:
        before = max(earlier, key=lambda other: other.firm_end_s)
        if not later or placed(candidate.basis, Window(before.firm_end_s)) is None:
            return before.behavior
    return min(later, key=lambda other: other.behavior.sync.start).behavior

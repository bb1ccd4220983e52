"""Chooses which alternative shows each function, over the whole line (paper §3.4, §3.5).

The functions choose in order of priority, so that time, hands and the character's gesture rate go to the most important
first. Each takes the alternative with the smallest lot / (weight × suitability): a random draw by the rules' weights,
modified by how well the alternative suits what is already kept (`suitability.py`). A function with other means leaves
the hands to nearby functions that need them. How an alternative is tried is in `attempts.py`.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from math import inf

from ...model import Alternative, Behavior, BehaviorCandidates, Channel
from ..timing.anchoring import asked, interval_of, words_before
from ..timing.conflicts import Kept
from ..timing.time_index import KeptByTime
from .attempts import Attempt, Line, attempted, count_made, is_planned
from .suitability import form, has_idle_hands, most_suitable, suitability

HANDS_WANTED = 0.01
"""The factor on the suitability of an alternative that takes the hands from functions that can only use the hands."""

EASILY_S = 1.0
"""Words this long after the performance begins leave time to prepare any gesture."""

NEAR_WORDS = 3
"""Offers that begin within this many words of each other may need the hands at the same time."""


def choose(candidates: Iterable[BehaviorCandidates], line: Line) -> tuple[Kept, tuple[Behavior, ...]]:
    """What is kept, and what was asked for and is not, with the reasons; at most one alternative for each function."""
    kept = KeptByTime()
    lost: list[Behavior] = []
    offers = sorted(candidates, key=partial(_rank, line=line))
    manual: dict[int, dict[int, BehaviorCandidates]] = {}
    for turn, offer in enumerate(offers):
        if not is_planned(offer) and _is_manual(offer, line):
            manual.setdefault(offer.rank[1], {})[turn] = offer
    for turn, offer in enumerate(offers):
        manual.get(offer.rank[1], {}).pop(turn, None)
        attempt = _best(offer, kept, line, () if is_planned(offer) else _near(offer, manual))
        kept = attempt.kept
        lost += attempt.lost
    return tuple(kept), tuple(lost)


def _is_manual(offer: BehaviorCandidates, line: Line) -> bool:
    """Whether only the hands can show it."""
    return all(
        any(line.character.entries[movement.name].channel is Channel.GESTURE for movement in alternative.movements)
        for alternative in offer.alternatives
    )


def _rank(offer: BehaviorCandidates, line: Line) -> tuple[float, bool, tuple[float, int, int, str]]:
    """Sort key: by priority; of equal ones, those choose first for whose gestures there is time."""
    return -offer.priority, _is_hurried(offer, line), offer.rank


def _is_hurried(offer: BehaviorCandidates, line: Line) -> bool:
    """Whether one of its strokes would begin at 0 for lack of time."""
    _priority, first, _last, _id = offer.rank
    begun = words_before(line.timed, first + 1)
    if begun and interval_of(line.timed[begun - 1]).start_s >= EASILY_S:
        return False
    movements = (movement for alternative in offer.alternatives for movement in alternative.movements)
    entries = ((movement, line.character.entries[movement.name]) for movement in movements)
    placed = (asked(movement, entry, line.timed, "") for movement, entry in entries if entry.channel is Channel.GESTURE)
    return any(each.behavior.sync.stroke_start == 0 for each in placed)


def _best(offer: BehaviorCandidates, kept: KeptByTime, line: Line, waiting: Sequence[BehaviorCandidates]) -> Attempt:
    """The attempt that wins; what the luckiest alternative lost is reported with it. `waiting` are the offers
    nearby that are yet to choose and can only use the hands."""
    lucky = sorted(offer.alternatives, key=_luck)
    attempt_at = partial(attempted, offer, kept=kept, line=line)
    possible = count_made(waiting, kept, line)
    scored = partial(_score, line=line, waiting=waiting, possible=possible)
    first = best = attempt_at(lucky[0], 0)
    score, hands_idle = scored(lucky[0], first), has_idle_hands(kept, line)
    for number, alternative in enumerate(lucky[1:], start=1):
        if _luck(alternative) >= score:
            break
        if _luck(alternative) / most_suitable(alternative, line, hands_idle=hands_idle) >= score:
            continue
        attempt = attempt_at(alternative, number)
        attempt_score = scored(alternative, attempt)
        if attempt_score < score:
            best, score = attempt, attempt_score
    if best is first:
        return best
    told = {form(behavior) for behavior in (*best.lost, *(each.candidate.behavior for each in best.own))}
    # A loser to a part of the alternative that is not made after all would name a winner that does not exist.
    unmade = {each.candidate.behavior.id for each in first.own}
    missed = (each for each in first.lost if form(each) not in told and each.lost_to not in unmade)
    return replace(best, lost=(*best.lost, *missed))


def _luck(alternative: Alternative) -> float:
    return alternative.lot / alternative.weight


def _score(
    alternative: Alternative,
    attempt: Attempt,
    *,
    line: Line,
    waiting: Sequence[BehaviorCandidates],
    possible: int,
) -> float:
    """The score of an attempt, the smaller the better; `possible` of the `waiting` could be made without it."""
    suits = suitability(attempt, line)
    if suits and count_made(waiting, attempt.kept, line) < possible:
        suits *= HANDS_WANTED
    return _luck(alternative) / suits if suits else inf


def _near(
    offer: BehaviorCandidates, waiting: Mapping[int, Mapping[int, BehaviorCandidates]]
) -> Sequence[BehaviorCandidates]:
    """Those that wait, by their first word and their turn, and may need the hands at the same time; by their turns."""
    first = offer.rank[1]
    words = range(first - NEAR_WORDS, first + NEAR_WORDS + 1)
    near = {turn: each for word in words for turn, each in waiting.get(word, {}).items()}
    return [near[turn] for turn in sorted(near)]

"""Resolves sync points to times: from absolute and relative points to seconds from the start of the block.

A behaviour without any times begins at 0. Missing points are placed at typical distances (`usual_s`) from known ones,
proportionally between two of them. No time is negative: if relative times would be, the whole block is delayed.
"""

from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from types import MappingProxyType

from ..markup.documents import Reference, Time

Points = dict[str, float]
"""The times in seconds of a behaviour's sync points, by name, in order."""

_STROKED_FACE = (0.17, 0.0, 0.0, 0.0, 0.60, 0.30)
_USUAL_S: Mapping[tuple[str, int], tuple[float, ...]] = MappingProxyType(
    {
        ("gesture", 7): (0.45, 0.0, 0.30, 0.20, 0.10, 0.53),
        ("pointing", 7): (0.45, 0.0, 0.21, 0.14, 0.30, 0.53),
        ("head", 7): (0.15, 0.0, 0.18, 0.12, 0.0, 0.20),
        ("gaze", 4): (0.15, 0.60, 0.15),
        ("gaze", 7): (0.15, 0.0, 0.0, 0.0, 0.60, 0.15),
        ("gazeShift", 2): (0.30,),
        ("headDirectionShift", 2): (0.40,),
        ("faceLexeme", 4): (0.17, 0.60, 0.30),
        ("faceFacs", 4): (0.17, 0.60, 0.30),
        ("face", 7): _STROKED_FACE,
        ("posture", 4): (0.70, 2.00, 0.70),
        ("postureShift", 2): (0.70,),
        ("body", 7): (0.70, 0.0, 0.0, 0.0, 0.0, 0.0),
        ("lips", 4): (0.03, 0.06, 0.03),
    }
)
"""The time between successive sync points, by element and number of points: phases as in lexicon/behaviors.yaml."""


def usual_s(name: str, points: int) -> tuple[float, ...]:
    """The typical times between an element's successive sync points."""
    return _USUAL_S.get((name, points), (0.5,) * (points - 1))


@dataclass(frozen=True, slots=True)
class StatedPoints:
    """The sync points of one behaviour: `names` in order, typical distances `usual_s`, and the `times` stated in the
    document."""

    id: str
    names: tuple[str, ...]
    usual_s: tuple[float, ...]
    times: Mapping[str, Time]


def resolve_times(
    stated: Sequence[StatedPoints], known: Mapping[tuple[str, str], float]
) -> tuple[Mapping[str, Points], tuple[str, ...]]:
    """The points of every behaviour by its id, and the ids of behaviours that cannot be resolved, because they refer to
    unknown points or to each other in a cycle. `known` are points that are no behaviour's, by its id and their
    names."""
    found = relative_times(stated, known)
    return _from_zero(found, stated), tuple(each.id for each in stated if each.id not in found)


def relative_times(stated: Sequence[StatedPoints], known: Mapping[tuple[str, str], float]) -> dict[str, Points]:
    """The points of those behaviours that can be resolved, of which some may be before 0."""
    known_times: dict[tuple[str, str], float] = dict(known)
    found: dict[str, Points] = {}
    following: dict[str, list[StatedPoints]] = {}
    for each in stated:
        for name in references_of(each):
            following.setdefault(name, []).append(each)
    ready = deque(stated)
    while ready:
        each = ready.popleft()
        if each.id not in found and all(_is_told(time, known_times) for time in each.times.values()):
            found[each.id] = complete(each, {name: _seconds(time, known_times) for name, time in each.times.items()})
            known_times |= {(each.id, name): time_s for name, time_s in found[each.id].items()}
            ready.extend(following.get(each.id, ()))
    return found


def references_of(stated: StatedPoints) -> tuple[str, ...]:
    """The ids of the behaviours to which a behaviour's times refer, each once."""
    refs = (time.behavior for time in stated.times.values() if isinstance(time, Reference))
    return tuple(dict.fromkeys(refs))


def _from_zero(found: Mapping[str, Points], stated: Sequence[StatedPoints]) -> Mapping[str, Points]:
    """If the first point is before 0: all later, if no time is absolute; else negative times set to 0."""
    first_s = min((time_s for points in found.values() for time_s in points.values()), default=0.0)
    if first_s >= 0:
        return found
    fixed = any(not isinstance(time, Reference) for each in stated for time in each.times.values())
    delay_s = 0.0 if fixed else -first_s
    return {
        name: {point: max(0.0, round(time_s + delay_s, 3)) for point, time_s in points.items()}
        for name, points in found.items()
    }


def later(time: Time, by_s: float) -> Time:
    """The time so many seconds later."""
    return replace(time, offset_s=time.offset_s + by_s) if isinstance(time, Reference) else float(time) + by_s


def complete(stated: StatedPoints, times_s: Mapping[str, float]) -> Points:
    """All points of a behaviour from those known; a point before its predecessor is moved to it."""
    fixed: dict[int, float] = {}
    for place, name in enumerate(stated.names):
        if name in times_s:
            fixed[place] = max(times_s[name], *fixed.values()) if fixed else times_s[name]
    if not fixed:
        fixed = {0: 0.0}
    places = sorted(fixed)
    points = _before(fixed[places[0]], stated.usual_s[: places[0]])
    for left, right in pairwise(places):
        points += _between(fixed[left], fixed[right], stated.usual_s[left:right])
    points.append(fixed[places[-1]])
    for usual_s in stated.usual_s[places[-1] :]:
        points.append(points[-1] + usual_s)
    return {name: round(time_s, 3) + 0.0 for name, time_s in zip(stated.names, points, strict=True)}


def _before(time_s: float, usual_s: Sequence[float]) -> list[float]:
    """The points before the first known one, compressed if 0 is near."""
    whole_s = sum(usual_s)
    share = min(1.0, max(0.0, time_s) / whole_s) if whole_s else 0.0
    return [time_s - share * sum(usual_s[place:]) for place in range(len(usual_s))]


def _between(from_s: float, to_s: float, usual_s: Sequence[float]) -> list[float]:
    """The first of two known points, and the points between them."""
    whole_s = sum(usual_s)
    shares = [length_s / whole_s for length_s in usual_s] if whole_s else [1 / len(usual_s)] * len(usual_s)
    return [from_s + (to_s - from_s) * sum(shares[:place]) for place in range(len(usual_s))]


def _is_told(time: Time, known_times: Iterable[tuple[str, str]]) -> bool:
    return not isinstance(time, Reference) or (time.behavior, time.point) in known_times


def _seconds(time: Time, known_times: Mapping[tuple[str, str], float]) -> float:
    if isinstance(time, Reference):
        return known_times[time.behavior, time.point] + time.offset_s
    return float(time)

"""Constraints of a BML block: points that coincide, and points that precede others.

A `synchronize` determines what was not stated, whatever the order of its points: they are anchored at a time in
seconds, or else at a point of a behaviour that is timed, by itself or through others to which it refers. A point
without a time is set; a behaviour that would begin at 0 for want of any moves with all that refer to it. Where one
anchor does not bring all points together, the next is tried. `before` and `after` move nothing. Every constraint that
is not met is reported.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from ...model import Notice
from ..markup.documents import Document, Element, Reference, Time, Value
from ..markup.speech import behaviors_of
from ..markup.values import text_of
from .phase_completion import Points, StatedPoints, later, references_of, relative_times

KnownPoints = Mapping[tuple[str, str], float]
"""Times of points that are no behaviour's, such as the start of the block."""

Tie = tuple[Time, ...]
"""The points of a `synchronize`."""

APART_S = 0.0015
"""Points nearer to each other coincide: each is rounded to a millisecond."""

_MOST_RESOLVED = 50_000
"""How many behaviours may be resolved anew for the points of all ties; what is left then is only checked."""


@dataclass(frozen=True, slots=True)
class _Scene:
    """The behaviours of a block by id, in order, of which `rigid`, a speech that is heard, moves only as a whole.
    `points` are the times of those that have any, `roots` the behaviours without stated times on which they depend."""

    by_id: Mapping[str, StatedPoints]
    known: KnownPoints
    rigid: str | None
    points: Mapping[str, Points]
    roots: Mapping[str, frozenset[str]]

    @classmethod
    def of(cls, stated: Iterable[StatedPoints], known: KnownPoints, rigid: str | None) -> "_Scene":
        by_id = {each.id: each for each in stated}
        points = relative_times(tuple(by_id.values()), known)
        roots: dict[str, frozenset[str]] = {}
        for name in points:  # in the order in which they were resolved
            found = [roots[other] for other in references_of(by_id[name]) if other in roots]
            roots[name] = frozenset().union(*found) if by_id[name].times else frozenset({name})
        return cls(by_id, known, rigid, points, roots)

    def time_s(self, time: Time) -> float | None:
        """When a point is, if that is known."""
        return time_of(time, self.points, self.known)

    def tied(self, tie: Tie) -> "_Scene":
        """With as many points of the tie together as can be."""
        anchors = sorted((time for time in tie if self.time_s(time) is not None), key=self._rank)
        found = [self._tied_to(anchor, tie) for anchor in anchors]
        return min(found, key=lambda each: each[0], default=(0, self))[1]

    def _rank(self, anchor: Time) -> tuple[int, int]:
        """Times in seconds come first, then stated points of what is timed, then its other points, then any."""
        if not isinstance(anchor, Reference) or anchor.behavior not in self.by_id:
            return 0, 0
        is_stated = anchor.point in self.by_id[anchor.behavior].times
        floats = bool(self.roots[anchor.behavior])
        return 3 if floats else 2 - is_stated, list(self.by_id).index(anchor.behavior)

    def _tied_to(self, anchor: Time, tie: Tie) -> tuple[int, "_Scene"]:
        """The number of points that do not coincide with the anchor after all have been moved that can, and the scene
        then."""
        scene, apart = self, 0
        for time in tie:
            if not scene._coincide(time, anchor):
                moved = (each for each in scene._moved(time, anchor) if each._follows(scene, time, anchor))
                found = next(moved, None)
                scene, apart = found or scene, apart + (found is None)
        return apart, scene

    def _moved(self, time: Time, anchor: Time) -> Iterator["_Scene"]:
        """The scenes in which the point may come to the anchor: set itself, or moved with what it depends on."""
        if not isinstance(time, Reference) or time.point not in self.points.get(time.behavior, {}):
            return
        each = self.by_id[time.behavior]
        if time.point not in each.times and each.id != self.rigid:
            yield self._with(each.id, {**each.times, time.point: later(anchor, -time.offset_s)})
        for root in sorted(self.roots[each.id], key=list(self.by_id).index):
            first = self.by_id[root].names[0]
            way_s = self.points[root][first] - self.points[each.id][time.point] - time.offset_s
            yield self._with(root, {first: later(anchor, way_s)})

    def _with(self, name: str, times: Mapping[str, Time]) -> "_Scene":
        changed = {**self.by_id, name: replace(self.by_id[name], times=times)}
        return _Scene.of(changed.values(), self.known, self.rigid)

    def _follows(self, before: "_Scene", time: Time, anchor: Time) -> bool:
        """Whether the points coincide now, and nothing is lost for it nor begins before 0."""
        stated = (time for each in self.by_id.values() for time in each.times.values())
        is_fixed = any(not isinstance(time, Reference) for time in stated)
        first_s = min((time_s for points in self.points.values() for time_s in points.values()), default=0.0)
        is_whole = before.points.keys() <= self.points.keys() and (first_s >= 0 or not is_fixed)
        return is_whole and self._coincide(time, anchor)

    def _coincide(self, time: Time, anchor: Time) -> bool:
        time_s, anchor_s = self.time_s(time), self.time_s(anchor)
        return time_s is not None and anchor_s is not None and abs(time_s - anchor_s) < APART_S


def synchronized(
    stated: Sequence[StatedPoints], document: Document, *, known: KnownPoints, rigid: str | None = None
) -> list[StatedPoints]:
    """The behaviours with the times that the block's `synchronize` give them; `rigid` is the id of a speech that is
    heard."""
    scene = _Scene.of(stated, known, rigid)
    pending = list(_within(_MOST_RESOLVED // max(1, len(stated)), _ties(document)))
    while pending:
        anchored = (tie for tie in pending if any(_is_anchored(time, scene) for time in tie))
        tie = next(anchored, pending[0])
        pending.remove(tie)
        scene = scene.tied(tie)
    return list(scene.by_id.values())


def _is_anchored(time: Time, scene: _Scene) -> bool:
    is_known = scene.time_s(time) is not None
    return is_known and not (isinstance(time, Reference) and scene.roots.get(time.behavior))


def _within(most: int, ties: Iterable[Tie]) -> Iterator[Tie]:
    """The ties until they have more points than `most`, each to be tried with each."""
    for tie in ties:
        most -= len(tie) ** 2
        if most < 0:
            return
        yield tie


def _ties(document: Document) -> Iterator[Tie]:
    for constraint in behaviors_of(document):
        for tie in constraint.children if constraint.name == "constraint" else ():
            if tie.name == "synchronize":
                yield tuple(_refs(tie))


def tied_points(document: Document) -> Iterator[Time]:
    """Every point of the block's `synchronize`."""
    for tie in _ties(document):
        yield from tie


def _refs(element: Element) -> list[Time]:
    found = (part.attributes.get("ref") for part in element.children if part.name == "sync")
    return [ref for ref in found if isinstance(ref, float | Reference)]


def violated_constraints(document: Document, points: Mapping[str, Points], known: KnownPoints) -> Iterator[Notice]:
    """Notices about the constraints that the times violate."""
    for tie in _ties(document):
        yield from _apart(tie, points, known)
    for constraint in behaviors_of(document):
        for offer in constraint.children if constraint.name == "constraint" else ():
            if offer.name in ("before", "after"):
                yield from _out_of_order(offer, points, known)


def _apart(tie: Tie, points: Mapping[str, Points], known: KnownPoints) -> Iterator[Notice]:
    """Of points that do not coincide; a time in seconds is what was asked, or else the first point that has one."""
    times_s = [
        (time, time_of(time, points, known)) for time in sorted(tie, key=lambda each: isinstance(each, Reference))
    ]
    anchor, anchor_s = next(((time, time_s) for time, time_s in times_s if time_s is not None), (None, None))
    if anchor is None or anchor_s is None:
        yield from (_untimed(time) for time in tie)
        return
    for time, time_s in times_s:
        if time_s is None or abs(time_s - anchor_s) >= APART_S:
            comes = "has no time" if time_s is None else f"comes at {time_s:.3f} s"
            message = f"{text_of(time)} {comes}, not at {anchor_s:.3f} s together with {text_of(anchor)} as asked"
            yield Notice("bml_constraint_missed", message)


def _out_of_order(offer: Element, points: Mapping[str, Points], known: KnownPoints) -> Iterator[Notice]:
    other = offer.attributes.get("ref")
    at_s = time_of(other, points, known)
    if at_s is None:
        if isinstance(other, Reference):
            yield _untimed(other)
        return
    sign = 1 if offer.name == "after" else -1
    for ref in _refs(offer):
        time_s = time_of(ref, points, known)
        if time_s is None:
            yield _untimed(ref)
        elif sign * (time_s - at_s) < 0:
            message = f"{text_of(ref)} comes at {time_s:.3f} s, which is not {offer.name} {at_s:.3f} s as asked"
            yield Notice("bml_constraint_missed", message)


def _untimed(point: Time) -> Notice:
    return Notice("bml_constraint_missed", f"{text_of(point)} has no time here, so that its constraint cannot be met")


def time_of(time: Value | None, points: Mapping[str, Points], known: KnownPoints) -> float | None:
    """When a point is in the block, if that is known."""
    if isinstance(time, Reference):
        at_s = points.get(time.behavior, {}).get(time.point, known.get((time.behavior, time.point)))
        return None if at_s is None else at_s + time.offset_s
    return float(time) if isinstance(time, int | float) else None

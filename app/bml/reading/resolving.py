"""Resolves a BML document to behaviours with absolute times for a realizer, the inverse of
`understudy.bml.writing.writer`.

Times are seconds from the start of the block. The sync marks of the speech are at the times of its words in the audio,
which keeps its length; without audio or stated times, words share the time from the start to the end of the speech, or
last `GUESSED_WORD_S` each, with a Notice if that matters. Behaviours that are not
body movements, or have no time, are left out with a Notice. SmartBody's gazes last until the next.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import TypeGuard

from ...model import Behavior, Channel, Interval, Level, Notice, SyncPoints, Target, Viseme, Word
from ...model.formats import DialectName
from ...model.lead_in import later_word
from ...model.tables import GLANCE, OPENINGS, SHIFT
from ..markup.documents import (
    Document,
    Element,
    Reference,
    Time,
    Value,
)
from ..markup.elements import DIALECTS, SBM, ElementKind
from ..markup.speech import Speech, behaviors_of, block_of, mark_s, speech_of
from .constraints import APART_S, synchronized, tied_points, time_of, violated_constraints
from .element_behaviors import SHIFTS, passed_over, to_behavior
from .pawns import pawns_of, placed_by_coordinates, recorded_targets
from .phase_completion import Points, StatedPoints, later, resolve_times, usual_s

GUESSED_WORD_S = 0.35
"""About 170 words per minute."""

_NAMES: Mapping[str, str] = {"strokeStart": "stroke_start", "strokeEnd": "stroke_end", "attackPeak": "ready"}
_STYLES: Mapping[str, Level] = {"low": Level.LOW, "mid": Level.MEDIUM, "medium": Level.MEDIUM, "high": Level.HIGH}
_STYLE = f"{{{SBM}}}style"
_STROKED = frozenset({Channel.GESTURE, Channel.HEAD})
_UNPLAYED = ("a body alone cannot play it", "a recording has one speech; the first is played")


@dataclass(frozen=True, slots=True)
class ResolvedDocument:
    """A document's behaviours in order of time, and the words of its speech at times of the block, in which the speech
    starts at `speech_start_s`. Visemes, agitation and character are set if the document states them, as SmartBody's
    dialect may. `places` are the targets that behaviours name by their coordinates, `stated` the sync points that are
    no estimates, by behaviour."""

    behaviors: tuple[Behavior, ...]
    words: tuple[Word, ...]
    visemes: tuple[Viseme, ...]
    agitation: Level | None
    character: str | None
    notices: tuple[Notice, ...]
    speech_start_s: float = 0.0
    targets: tuple[Target, ...] = ()
    places: tuple[Target, ...] = ()
    stated: Mapping[str, frozenset[str]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class _TimedElement:
    """A behaviour element with its sync points."""

    element: Element
    stated: StatedPoints


def resolve(document: Document, words: tuple[Word, ...] = ()) -> ResolvedDocument:
    """The behaviours of a document; `words` are those of its speech, timed from the start of the recording."""
    document = _with_blocks_in_names(document)
    speech = speech_of(document)
    spoken = _spoken(speech, words) if speech else None
    heard = speech is not None and _is_heard(speech, words)
    asked = list(_asked(document))
    every = [*([spoken] if spoken else []), *(each.stated for each in asked)]
    known = {(block_of(document).id or "", "start"): 0.0}
    stated = synchronized(every, document, known=known, rigid=spoken.id if spoken and heard else None)
    points, lost = resolve_times(stated, known)
    elements = {each.stated.id: each.element for each in asked}
    aimed = recorded_targets(document.root)
    played = (replace(each, target=each.target or aimed.get(each.id)) for each in _behaviors(elements, points))
    behaviors, places = placed_by_coordinates(_lasting(list(played), document.dialect))
    start_s = points[spoken.id]["start"] if spoken and spoken.id in points else 0.0
    notices = (
        *_guessed([*tied_points(document), *(time for each in stated for time in each.times.values())], speech, words),
        *(Notice("bml_untimed", f"{name}: refers to a behaviour without times; it is not played") for name in lost),
        *_not_played(document, elements, behaviors, lost),
        *_passed_over(elements, behaviors),
        *violated_constraints(document, points, known),
        *(_missed_end(speech, points, known) if speech else ()),
    )
    return ResolvedDocument(
        behaviors=tuple(sorted((_worded(each, words, start_s) for each in behaviors), key=_start_s)),
        words=tuple(later_word(word, start_s) for word in words),
        visemes=tuple(_visemes(elements, points)),
        agitation=_agitation(elements.values()),
        character=_character(document.root),
        notices=notices,
        speech_start_s=start_s,
        targets=pawns_of(document.root),
        places=places,
        stated={each.id: frozenset(_NAMES.get(name, name) for name in each.times) for each in stated},
    )


def _with_blocks_in_names(document: Document) -> Document:
    """The document with every behaviour of another block called by both names, as no behaviour of this one is."""
    own = block_of(document).id

    def renamed(value: Value) -> Value:
        if not isinstance(value, Reference) or value.block in (None, own):
            return value
        return Reference(f"{value.block}:{value.behavior}", value.point, value.offset_s)

    def of(element: Element) -> Element:
        attributes = {name: renamed(value) for name, value in element.attributes.items()}
        content = tuple(part if isinstance(part, str) else of(part) for part in element.content)
        return replace(element, attributes=attributes, content=content)

    return replace(document, root=of(document.root))


def _spoken(speech: Speech, words: tuple[Word, ...]) -> StatedPoints:
    """The sync points of the speech: start, marks and end, with times from the audio or estimates."""
    times_s = {mark: _heard_or_guessed_s(mark, speech, words) for mark in [*speech.marks]}
    intervals = [word.interval.end_s for word in words if word.interval]
    guessed_s = GUESSED_WORD_S * len(speech.text.split())
    length_s = max([intervals[-1] if intervals else guessed_s, *times_s.values()])
    heard = _is_heard(speech, words)
    if heard and isinstance(speech.start, float) and isinstance(speech.end, float):
        length_s = max(length_s, speech.end - speech.start)
    times_s["end"] = length_s
    ordered = sorted(times_s.items(), key=lambda found: found[1])
    gaps_s = [later_s - earlier_s for earlier_s, later_s in pairwise([0.0, *(time_s for _name, time_s in ordered)])]
    stated = _placed(speech, length_s) if heard else _stated_ends(speech)
    return StatedPoints(speech.id, ("start", *(name for name, _time_s in ordered)), tuple(gaps_s), stated)


def _stated_ends(speech: Speech) -> dict[str, Time]:
    return {name: time for name, time in (("start", speech.start), ("end", speech.end)) if time is not None}


def _placed(speech: Speech, length_s: float) -> dict[str, Time]:
    """The start of a speech that is heard: as stated, or so long before its end."""
    if speech.start is None and speech.end is not None:
        start = later(speech.end, -length_s)
        return {"start": start if isinstance(start, Reference) else max(0.0, start)}
    return {} if speech.start is None else {"start": speech.start}


def _is_heard(speech: Speech, words: tuple[Word, ...]) -> bool:
    return bool(speech.mark_times_s) or any(word.interval for word in words)


def _heard_or_guessed_s(mark: str, speech: Speech, words: tuple[Word, ...]) -> float:
    heard_s = mark_s(mark, speech, words)
    return GUESSED_WORD_S * speech.marks[mark] if heard_s is None else heard_s


def _asked(document: Document) -> Iterator[_TimedElement]:
    kinds = _kinds(document.dialect)
    for number, element in enumerate(behaviors_of(document), start=1):
        kind = kinds.get(element.name)
        if kind is None or not kind.syncs or element.name == "speech":
            continue
        times: dict[str, Time] = {}
        for name in kind.syncs:
            time = element.attributes.get(name)
            if isinstance(time, float | Reference):
                times[name] = time
        name = element.id or f"{element.name}.{number}"
        yield _TimedElement(element, StatedPoints(name, kind.syncs, _usual_s(element, len(kind.syncs)), times))


def _usual_s(element: Element, points: int) -> tuple[float, ...]:
    """The typical times between an element's points; a `wait` lasts as long as it may, for nothing ends it before."""
    most_s = element.attributes.get("max-wait")
    return (float(most_s),) if isinstance(most_s, float | int) else usual_s(element.name, points)


def _kinds(dialect: DialectName) -> dict[str, ElementKind]:
    """The types of all behaviours of the dialect by name."""
    roots = DIALECTS[dialect].roots
    parts = dict(roots["bml"].parts)
    if "required" in parts:
        parts |= parts["required"].parts
    return parts


def _behaviors(elements: Mapping[str, Element], points: Mapping[str, Points]) -> Iterator[Behavior]:
    for name, element in elements.items():
        if name in points:
            behavior = to_behavior(element, name, _sync(element, points[name]))
            if behavior:
                yield behavior if behavior.kind in _STROKED else replace(behavior, sync=_reached(behavior.sync))


def _sync(element: Element, points: Points) -> SyncPoints:
    if element.name in SHIFTS:
        end_s = points["end"] if "ready" not in points else points["ready"]
        return SyncPoints(start=points["start"], ready=end_s, relax=end_s, end=end_s)
    return SyncPoints(**{_NAMES.get(name, name): time_s for name, time_s in points.items()})


def _reached(sync: SyncPoints) -> SyncPoints:
    """Without stroke points, which faces, gazes and postures do not have."""
    return SyncPoints(start=sync.start, ready=sync.ready, relax=sync.relax, end=sync.end)


def _lasting(behaviors: list[Behavior], dialect: DialectName) -> list[Behavior]:
    """SmartBody's gazes last until the next one begins."""
    if dialect is not DialectName.SMARTBODY:
        return behaviors
    gazes = sorted((each for each in behaviors if each.kind is Channel.GAZE), key=lambda each: each.sync.start)
    until_s = {each.id: later.sync.start for each, later in pairwise(gazes)}
    return [_until(each, until_s.get(each.id)) if each.kind is Channel.GAZE else each for each in behaviors]


def _until(gaze: Behavior, end_s: float | None) -> Behavior:
    """A gaze that lasts until another begins, if one does."""
    if gaze.lexeme != GLANCE or end_s is None:
        reached_s = gaze.sync.ready if gaze.sync.ready is not None else gaze.sync.end
        reached_s = reached_s if end_s is None else min(reached_s, end_s)
        return replace(gaze, lexeme=SHIFT, sync=SyncPoints(gaze.sync.start, reached_s, reached_s, relax=reached_s))
    ready_s = min(gaze.sync.ready if gaze.sync.ready is not None else end_s, end_s)
    return replace(gaze, sync=SyncPoints(start=gaze.sync.start, ready=ready_s, relax=end_s, end=end_s))


def _start_s(behavior: Behavior) -> float:
    return behavior.sync.start


def _worded(behavior: Behavior, words: Sequence[Word], start_s: float) -> Behavior:
    """The behaviour with the index of the word during which it happens."""
    at_s = behavior.sync.start if behavior.sync.stroke is None else behavior.sync.stroke
    begun = [word.index for word in words if word.interval and word.interval.start_s + start_s <= at_s]
    return replace(behavior, first=begun[-1], last=begun[-1]) if begun else behavior


def _passed_over(elements: Mapping[str, Element], behaviors: Iterable[Behavior]) -> Iterator[Notice]:
    """A notice of each gesture whose `type` nobody knows, so that its `lexeme` is played."""
    for each in behaviors:
        named = passed_over(elements[each.id], each)
        if named:
            yield Notice("gesture_unknown", f"{each.id} is played as a {each.lexeme}: no gesture is called {named!r}")


def _visemes(elements: Mapping[str, Element], points: Mapping[str, Points]) -> Iterator[Viseme]:
    """The visemes stated in the document."""
    for name, element in elements.items():
        label = element.attributes.get("viseme")
        if element.name == "lips" and label in OPENINGS and name in points:
            articulation = element.attributes.get("articulation", 1.0)
            share = float(articulation) if isinstance(articulation, int | float) else 1.0
            interval = Interval(points[name]["start"], points[name]["end"])
            yield Viseme(str(label), interval, share, OPENINGS[str(label)] * share)


def _agitation(elements: Iterable[Element]) -> Level | None:
    """The level that most gestures of the document have as style."""
    gestures = (each.attributes for each in elements if each.name == "gesture")
    styles = Counter(_STYLES.get(str(each.get(_STYLE) or each.get("style"))) for each in gestures)
    del styles[None]
    return styles.most_common(1)[0][0] if styles else None


def _character(root: Element) -> str | None:
    """The name of the character: BML's `characterId`, SmartBody's participant."""
    participants = (part.id for part in root.children if part.name == "participant")
    named = root.attributes.get("characterId") or next(participants, None)
    return named if isinstance(named, str) else None


def _guessed(times: Iterable[Time], speech: Speech | None, words: tuple[Word, ...]) -> Iterator[Notice]:
    """A notice if any time depends on words with estimated times."""
    if speech is None or _is_heard(speech, words):
        return
    refs = {ref.point for ref in times if _is_of(ref, speech.id)}
    if refs - {"start"}:
        each = f"each lasts {GUESSED_WORD_S} s" if speech.end is None else "they share its time evenly"
        yield Notice("speech_untimed", f"there is no recording to time the words by: {each}; send the audio")


def _missed_end(
    speech: Speech, points: Mapping[str, Points], known: Mapping[tuple[str, str], float]
) -> Iterator[Notice]:
    """A notice if the speech does not end when it was asked to."""
    asked_s, end_s = time_of(speech.end, points, known), points.get(speech.id, {}).get("end")
    if asked_s is not None and end_s is not None and abs(end_s - asked_s) >= APART_S:
        message = f"{speech.id}:end comes at {end_s:.3f} s, not at {asked_s:.3f} s as asked: its words keep their times"
        yield Notice("bml_constraint_missed", message)


def _is_of(time: Time, speech: str) -> TypeGuard[Reference]:
    return isinstance(time, Reference) and time.behavior == speech


def _not_played(
    document: Document, elements: Mapping[str, Element], behaviors: Sequence[Behavior], lost: Sequence[str]
) -> Iterator[Notice]:
    """A notice for each kind of element that is left out."""
    every = Counter(each.name for each in behaviors_of(document) if "max-wait" not in each.attributes)
    told = (*(behavior.id for behavior in behaviors), *lost)
    every -= Counter(elements[name].name for name in told if name in elements)
    every -= Counter({"speech": 1, "constraint": every["constraint"], "lips": every["lips"]})
    for name, count in every.items():
        yield Notice("bml_not_played", f"<{name}> ({count} in all) is not played: {_UNPLAYED[name == 'speech']}")
    for name in (behavior.id for behavior in behaviors):
        yield from (Notice("bml_not_played", told) for told in _unplayed_parts(name, elements.get(name)))


def _unplayed_parts(name: str, element: Element | None) -> Iterator[str]:
    """What of a posture is not played: bodies always stand, and take one pose at a time."""
    parts = () if element is None or not element.name.startswith("posture") else tuple(element.children)
    stances = (part.attributes.get("type") for part in parts if part.name == "stance")
    yield from (
        f"the stance {stance} of {name} is not played: bodies always stand"
        for stance in stances
        if stance != "STANDING"
    )
    poses = [part for part in parts if part.name == "pose"]
    for pose in poses[1:]:
        message = f"the pose {pose.attributes.get('lexeme')} of {name} is not played"
        yield f"{message}: a body takes one pose at a time, here {poses[0].attributes.get('lexeme')}"

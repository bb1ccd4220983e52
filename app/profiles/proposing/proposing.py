"""Proposed phases, phrases and units as tracks of an annotation, beside the words if they are known.

A lexeme cannot be told from speeds: every phrase is called `UNKNOWN`, which learning refuses until somebody has named
it. Its affiliate is proposed as the word in whose time its main stroke ends.
"""

from collections.abc import Iterable, Iterator

from ...model import Interval
from ..annotation.model import PhaseKind
from ..annotation.tracks import Track, TrackSpan
from .phases import ProposedPhrase, ProposedUnit

UNKNOWN = "UNKNOWN"


def proposed_tracks(units: Iterable[ProposedUnit], others: Iterable[Track] = ()) -> tuple[Track, ...]:
    """The tracks of an annotation; `others`, such as words and tags, stand before what is proposed."""
    found, known = tuple(units), tuple(others)
    words = next((track.spans for track in known if track.name == "words"), ())
    phrases = [phrase for unit in found for phrase in unit.phrases]
    phases = sorted(_phases(found), key=lambda span: span.start_s)
    return (
        *(known or (Track("words", ()),)),
        Track("phases", tuple(phases)),
        Track("phrases", tuple(_phrase(phrase, words) for phrase in phrases)),
        Track("units", tuple(_unit(unit) for unit in found)),
    )


def _phases(units: Iterable[ProposedUnit]) -> Iterator[TrackSpan]:
    for unit in units:
        for phase in (*(each for phrase in unit.phrases for each in phrase.phases), unit.retraction):
            yield TrackSpan(phase.interval.start_s, phase.interval.end_s, phase.kind.value)


def _phrase(phrase: ProposedPhrase, words: tuple[TrackSpan, ...]) -> TrackSpan:
    hand = "2H" if phrase.left and phrase.right else "LH" if phrase.left else "RH"
    main = next(phase.interval for phase in phrase.phases if phase.kind is PhaseKind.STROKE)
    meant = [number for number, word in enumerate(words) if word.start_s <= main.end_s]
    affiliate = {"affiliate": str(meant[-1])} if meant else {}
    span = _around(phase.interval for phase in phrase.phases)
    return TrackSpan(span.start_s, span.end_s, UNKNOWN, {"hand": hand, **affiliate})


def _unit(unit: ProposedUnit) -> TrackSpan:
    phases = [phase.interval for phrase in unit.phrases for phase in phrase.phases]
    span = _around([*phases, unit.retraction.interval])
    return TrackSpan(span.start_s, span.end_s, "")


def _around(intervals: Iterable[Interval]) -> Interval:
    found = list(intervals)
    return Interval(min(each.start_s for each in found), max(each.end_s for each in found))

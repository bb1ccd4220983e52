"""The events of a performance for editorial tools: the functions of its words and all movements, with times and
reasons.

Conventions: seconds of the performance, on whose clock the recording starts at its lead-in. Movements have the times at
which the motion shows them; those it does not show are left out. A function lasts as long as its words.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from ..model import Behavior, Channel, Function, Schedule, SyncPoints, Word
from ..profiles.annotation.tracks import Track, TrackSpan, with_attribute_tracks

FUNCTIONS = "functions"
TIERS: tuple[str, ...] = (FUNCTIONS, *(channel.value for channel in Channel))
"""The tiers in their order: the functions, then every channel of movement."""


@dataclass(frozen=True, slots=True)
class TimelineEvent:
    """An event of a tier. `points` are the sync points in order; `function` is what a movement shows, `rule` why it is
    made or the function found; `text` are the words it belongs to."""

    tier: str
    id: str
    label: str
    start_s: float
    end_s: float
    first: int
    last: int
    text: str = ""
    function: str = ""
    rule: str = ""
    hand: str = ""
    points: Mapping[str, float] = field(default_factory=dict)

    @property
    def reasons(self) -> Mapping[str, str]:
        """The event's attributes besides its label, by their names in files."""
        said = {"id": self.id, "function": self.function, "rule": self.rule, "hand": self.hand, "words": self.text}
        return {name: value for name, value in said.items() if value}


def timeline_events(schedule: Schedule, realized: Mapping[str, SyncPoints]) -> tuple[TimelineEvent, ...]:
    """The events by tier and time; `realized` are the sync points of the motion, by BML id."""
    names = {each.id: f"{each.class_name}/{each.subtype}" for each in schedule.functions}
    events = [
        *_functions(schedule.functions, schedule.words),
        *(_movement(each, realized[each.id], names, schedule) for each in schedule.behaviors if each.id in realized),
    ]
    return tuple(sorted(events, key=lambda event: (TIERS.index(event.tier), event.start_s, event.id)))


def tracks_of(
    events: tuple[TimelineEvent, ...], *, clock_starts_s: float, words: tuple[Word, ...]
) -> tuple[Track, ...]:
    """The words and the events as annotation tracks, with function, rule and hand as tracks of their own.

    Times count from `clock_starts_s`, the start of the recording; annotation tools have no earlier times, so what
    begins earlier is cut there.
    """
    said = tuple(
        TrackSpan(*_cut(word.interval.start_s, word.interval.end_s, clock_starts_s), word.text)
        for word in words
        if word.interval
    )
    tracks = [Track("words", said)] if said else []
    for tier in TIERS:
        shown = [event for event in events if event.tier == tier and event.end_s > clock_starts_s]
        spans = (TrackSpan(*_cut(each.start_s, each.end_s, clock_starts_s), each.label, each.reasons) for each in shown)
        tracks.append(Track(tier, tuple(spans)))
    return tuple(with_attribute_tracks(tracks))


def _cut(start_s: float, end_s: float, clock_starts_s: float) -> tuple[float, float]:
    return max(start_s - clock_starts_s, 0.0), end_s - clock_starts_s


def _functions(functions: tuple[Function, ...], words: tuple[Word, ...]) -> Iterator[TimelineEvent]:
    for each in functions:
        timed = [word.interval for word in words[each.first : each.last + 1] if word.interval]
        if timed:
            yield TimelineEvent(
                FUNCTIONS,
                each.id,
                f"{each.class_name}/{each.subtype}",
                timed[0].start_s,
                timed[-1].end_s,
                each.first,
                each.last,
                text=_text(words, each.first, each.last),
                rule=each.rule,
            )


def _movement(behavior: Behavior, sync: SyncPoints, names: Mapping[str, str], schedule: Schedule) -> TimelineEvent:
    function = behavior.function or ""
    return TimelineEvent(
        behavior.kind.value,
        behavior.id,
        behavior.lexeme,
        sync.start,
        sync.end,
        behavior.first,
        behavior.last,
        text=_text(schedule.words, behavior.first, behavior.last) if function else "",
        function=names.get(function, function),
        rule=behavior.rule or "",
        hand=behavior.hand.value if behavior.hand else "",
        points=MappingProxyType(dict(sync.in_order())),
    )


def _text(words: tuple[Word, ...], first: int, last: int) -> str:
    return " ".join(word.text for word in words[first : last + 1])

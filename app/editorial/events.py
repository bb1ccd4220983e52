"""The events of a performance for editorial tools: the functions of its words and all movements, with times and
reasons; exported for annotation tools, Praat's TextGrid and ELAN's .eaf, and as a table (CSV), a row each.

Conventions: seconds of the performance, on whose clock the recording starts at its lead-in. Movements have the times at
which the motion shows them; those it does not show are left out. A function lasts as long as its words.

Exports are on the clock of the recording. Tiers: the words, the functions, every channel of movement, and beside each
its reasons (`gesture.function`, `gesture.rule`, …). Events that overlap are split into several tiers, `face`, `face_2`.
The tools have no times before the recording, so what begins in a lead-in is cut there; in the table its times are
negative. Points that a movement does not have are empty in the table.
"""

import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields
from types import MappingProxyType

from ..model import Behavior, Channel, Function, Schedule, SyncPoints, Word
from ..profiles.annotation.elan import write_elan
from ..profiles.annotation.tracks import Track, TrackSpan, rows_of, with_attribute_tracks

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


POINTS = ("ready", "stroke_start", "stroke", "stroke_end", "relax")
COLUMNS = ("tier", "id", "label", "start_s", *(f"{point}_s" for point in POINTS), "end_s", "hand", "first", "last")
REASONS = ("words", "function", "rule")
assert {*POINTS, "start", "end"} == {field.name for field in fields(SyncPoints)}


def to_textgrid(tracks: Sequence[Track], duration_s: float) -> bytes:
    """The TextGrid (long format), as long as the recording or its last event."""
    from praatio.utilities import textgrid_io  # type: ignore[import-untyped]

    rows = [row for track in tracks for row in rows_of(track) if track.spans]
    end_s = max([duration_s, *(span.end_s for row in rows for span in row.spans)])
    grid = {"xmin": 0, "xmax": end_s, "tiers": [_tier(row, end_s) for row in rows]}
    return str(textgrid_io.getTextgridAsStr(grid, "long_textgrid", includeBlankSpaces=True)).encode()


def to_elan(tracks: Sequence[Track], media: str = "") -> bytes:
    """The .eaf; `media` is the recording's file."""
    return write_elan([row for track in tracks if track.spans for row in rows_of(track)], media=media)


def _tier(row: Track, end_s: float) -> dict[str, object]:
    entries = [(span.start_s, span.end_s, span.label) for span in _apart(row.spans)]
    return {"class": "IntervalTier", "name": row.name, "xmin": 0, "xmax": end_s, "entries": entries}


def _apart(spans: Sequence[TrackSpan]) -> list[TrackSpan]:
    """The spans with a duration: Praat has no intervals of length 0."""
    return [span for span in spans if span.end_s > span.start_s]


def to_event_table(events: Sequence[TimelineEvent], *, clock_starts_s: float) -> bytes:
    """The table; `clock_starts_s` is when the recording starts."""
    content = io.StringIO()
    writer = csv.writer(content, lineterminator="\n")
    writer.writerow((*COLUMNS, *REASONS))
    for event in events:
        times_s = [event.start_s, *(event.points.get(point) for point in POINTS), event.end_s]
        times = ["" if time_s is None else f"{time_s - clock_starts_s:.3f}" for time_s in times_s]
        named = (event.tier, event.id, event.label)
        writer.writerow((*named, *times, event.hand, event.first, event.last, event.text, event.function, event.rule))
    return content.getvalue().encode()

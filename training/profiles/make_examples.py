"""Makes the two example annotations of examples/speakers/: our own performances, varied by two opposite styles.

    python -m training.profiles.make_examples [--lines FOLDER] [--target FOLDER] [--takes N]

A session is the lines of a folder with recordings (public domain: LibriVox, a speech; aligned) and our own `lines.txt`
(timed by `clock`), three at a time. The understudy performs each; its gestures say on which words one gestures, and
`styles.yaml` how: which lexeme, hand, how many strokes, when, and how far units reach. So whoever learns a profile of
the result can be held against the style that made it. The audio itself is not kept.
"""

import argparse
import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from pydantic import RootModel

from training.profiles.clock import spoken
from understudy.behavior.reading.player import Player
from understudy.behavior.speaker_profiles import repertoire_of
from understudy.model import Analysis, Behavior, Channel, Function, Interval, Level, Line, Word
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import analyze, perform_analysis
from understudy.profiles.annotation.elan import write_elan
from understudy.profiles.annotation.tables import write_json_tracks
from understudy.profiles.annotation.tracks import Track, TrackSpan, rows_of, with_attribute_tracks
from understudy.profiles.generation.candidates import PlayableGesture
from understudy.profiles.profile import tag_of
from understudy.profiles.segments import time_of
from understudy.rules.stage import find_functions_in_all
from understudy.settings import Settings
from understudy.text.transcript import read_transcript
from understudy.yaml_files import Entry, Source

HERE = Path(__file__).resolve().parent
LINES = HERE.parents[2] / "shared" / "data" / "speech" / "lines"
TARGET = HERE.parents[1] / "examples" / "speakers"

GROUP = 3
BETWEEN_LINES_S, BETWEEN_GROUPS_S = 0.35, 1.5
SHORTEST_GAP_S = 0.9
"""Gestures that are nearer leave no time to rest between them."""
LONGEST_JOINED_S = 3.0
AFTER_STROKE_S, AFTER_SPACING_S = 0.3, 0.4
LEAST_S = 0.12


class Style(Entry):
    """A way to gesture, as styles.yaml has it."""

    gestures_per_minute: float
    hands: dict[str, float]
    hand_kept: float
    strokes: tuple[float, float]
    offset_s: tuple[float, float]
    joined: float
    preparation_s: tuple[float, float]
    retraction_s: tuple[float, float]
    places: tuple[str, ...]
    curved: float
    rests: dict[str, str]
    head_kept: float
    at_listener: float
    posture: str
    usual: dict[str, float]
    lexemes: dict[str, dict[str, float]]


class Styles(RootModel[dict[str, Style]]):
    """The styles by name."""


def main() -> None:
    """Writes sweeping.json and sparing.eaf."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--lines", type=Path, default=LINES)
    parser.add_argument("--target", type=Path, default=TARGET)
    parser.add_argument("--takes", type=int, default=2)
    options = parser.parse_args()
    styles = Source(HERE / "styles.yaml").validated(Styles).root
    with Understudy.load(Settings()) as understudy:
        performed = list(performed_lines(understudy, options.lines, options.takes))
        offered = offered_gestures(understudy)
    options.target.mkdir(parents=True, exist_ok=True)
    for name, style in styles.items():
        tracks = tuple(Session(style, offered, random.Random(name)).tracks(performed))
        if name == "sparing":
            rows = (row for track in with_attribute_tracks(tracks) for row in rows_of(track))
            (options.target / f"{name}.eaf").write_bytes(write_elan(tuple(rows)))
        else:
            (options.target / f"{name}.json").write_bytes(write_json_tracks(tracks))


@dataclass(frozen=True, slots=True)
class PerformedLine:
    """A line in its own time: its words, functions, and what we do with it."""

    words: tuple[Word, ...]
    functions: tuple[Function, ...]
    behaviors: tuple[Behavior, ...]

    @property
    def end_s(self) -> float:
        return time_of(self.words[-1]).end_s


def performed_lines(understudy: Understudy, folder: Path, takes: int) -> Iterator[PerformedLine]:
    """Every line, once for each take, performed with the take's number for seed."""
    analyses = [analyze(understudy, Line(path.read_bytes(), _text(path))) for path in sorted(folder.glob("*.flac"))]
    analyses += unspoken_analyses(understudy, (HERE / "lines.txt").read_text(encoding="utf-8").splitlines())
    for take in range(takes):
        for analysis in analyses:
            performance = perform_analysis(understudy, analysis, Options(seed=take))
            timed = tuple(word for word in analysis.utterance.words if word.interval)
            yield PerformedLine(timed, analysis.functions, performance.behaviors)


def unspoken_analyses(understudy: Understudy, texts: Sequence[str]) -> list[Analysis]:
    """What lines say and do that nobody has spoken, in the time of the clock."""
    lines = [spoken(read_transcript(text)) for text in texts]
    return [
        replace(each, utterance=replace(each.utterance, duration_s=time_of(each.utterance.words[-1]).end_s + 0.5))
        for each in find_functions_in_all(understudy.language, lines)
    ]


def offered_gestures(understudy: Understudy) -> Mapping[str, PlayableGesture]:
    """How long the stroke of each lexeme lasts in the library, and with which hands the table offers it."""
    character = understudy.behavior.performers.named("default", Level.MEDIUM)
    return repertoire_of(Player(understudy.behavior.families, character.entries), character).gestures


def _text(recording: Path) -> str:
    return recording.with_suffix(".txt").read_text(encoding="utf-8").strip()


@dataclass(slots=True)
class Gesture:
    """A gesture of the session: its strokes in order, and the word that it means."""

    lexeme: str
    hand: str
    word: int
    strokes: list[Interval]
    joined: bool
    group: int


class Session:
    """One speaker's session: everything that is drawn is drawn by his style, in order."""

    def __init__(self, style: Style, offered: Mapping[str, PlayableGesture], rng: random.Random) -> None:
        self.style = style
        self.offered = offered
        self.rng = rng
        self.owed = 0.0
        self.hand = ""

    def tracks(self, lines: Sequence[PerformedLine]) -> Iterator[Track]:
        """The tracks of the session."""
        words: list[TrackSpan] = []
        tags: list[TrackSpan] = []
        heads: list[TrackSpan] = []
        segments: list[TrackSpan] = []
        planned: list[tuple[int, str, int]] = []
        start_s = 0.5
        for number, line in enumerate(lines):
            first = len(words)
            start_s += (BETWEEN_GROUPS_S if number % GROUP == 0 else BETWEEN_LINES_S) if number else 0.0
            shift_s = start_s - time_of(line.words[0]).start_s
            words += (_shifted(time_of(word), shift_s, word.text) for word in line.words)
            places = {word.index: first + place for place, word in enumerate(line.words)}
            tags += _tags(line, places, words)
            planned += [(places[word], tag, number // GROUP) for word, tag in self._planned(line)]
            heads += self._heads(line, shift_s)
            start_s = words[-1].end_s
            if number % GROUP == 0:
                segments.append(words[first])
            segments[-1] = replace(segments[-1], end_s=start_s, label="utterance", attributes={})
        gestures = self._gestures(sorted(set(planned)), words)
        yield Track("words", tuple(words))
        yield Track("segments", tuple(segments))
        yield Track("tags", tuple(tags))
        yield from self._rows(gestures, start_s)
        yield Track("head", tuple(_apart(heads)))
        yield Track("gaze", tuple(self._gaze(start_s)))
        yield Track("posture", (TrackSpan(0.0, round(start_s, 3), self.style.posture),))

    def _planned(self, line: PerformedLine) -> list[tuple[int, str]]:
        """The words with a gesture, as many as the style makes: those of our performance, the more important first,
        then those of other functions."""
        self.owed += self.style.gestures_per_minute * (line.end_s + 0.4) / 60
        made = sorted(_strokes(line), key=lambda each: -each[2])
        others = [(each.last, tag_of(each), each.priority) for each in line.functions if each.kept]
        self.rng.shuffle(others)
        taken: dict[int, str] = {}
        for word, tag, _priority in (*made, *others):
            if self.owed >= 1 and all(abs(word - other) > 1 for other in taken):
                taken[word] = tag
                self.owed -= 1
        return list(taken.items())

    def _gestures(self, planned: Sequence[tuple[int, str, int]], words: Sequence[TrackSpan]) -> list[Gesture]:
        made: list[Gesture] = []
        for place, (word, tag, group) in enumerate(planned):
            before = made[-1] if made else None
            lexeme = self._drawn(self._lexemes(tag))
            stroke_s = self.offered[lexeme].stroke_s
            end_s = words[word].end_s + self.rng.gauss(*self.style.offset_s)
            start_s = end_s - stroke_s
            free_s = before.strokes[-1].end_s + LEAST_S if before else 0.3
            if start_s < free_s:
                start_s, end_s = free_s, free_s + stroke_s
            until_s = words[planned[place + 1][0]].end_s - 1.0 if place + 1 < len(planned) else words[-1].end_s
            strokes = [Interval(start_s, end_s), *self._after(word, end_s, until_s, words)]
            gap_s = start_s - before.strokes[-1].end_s if before else 99.0
            same = before is not None and before.group == group
            joined = gap_s < SHORTEST_GAP_S or (
                same and gap_s < LONGEST_JOINED_S and self.rng.random() < self.style.joined
            )
            made.append(Gesture(lexeme, self._hand(lexeme), word, strokes, joined, group))
        return made

    def _after(self, word: int, end_s: float, until_s: float, words: Sequence[TrackSpan]) -> Iterator[Interval]:
        """After-strokes, each ending with one of the words that follow."""
        left = max(1, round(self.rng.gauss(*self.style.strokes))) - 1
        for following in words[word + 1 :]:
            if left and following.end_s - end_s >= AFTER_SPACING_S and following.end_s < until_s:
                left -= 1
                end_s = following.end_s
                yield Interval(end_s - AFTER_STROKE_S, end_s)

    def _rows(self, gestures: Sequence[Gesture], end_s: float) -> Iterator[Track]:
        """Phases, phrases and units."""
        phases: list[TrackSpan] = []
        phrases: list[TrackSpan] = []
        units: list[TrackSpan] = []
        for place, gesture in enumerate(gestures):
            following = gestures[place + 1] if place + 1 < len(gestures) else None
            first, last = gesture.strokes[0], gesture.strokes[-1]
            free_s = phases[-1].end_s if phases else 0.0
            start_s = free_s if gesture.joined else max(free_s, first.start_s - self._lasting(self.style.preparation_s))
            to_s = last.end_s
            if following and following.joined:
                to_s = max(last.end_s, following.strokes[0].start_s - self._lasting(self.style.preparation_s))
            if first.start_s - start_s > 0.02:
                phases.append(_span(start_s, first.start_s, "preparation"))
            phases += _strokes_and_holds(gesture.strokes, to_s)
            phrases.append(self._phrase(gesture, start_s, to_s))
            if not gesture.joined:
                units.append(_span(start_s, to_s, ""))
            units[-1] = replace(units[-1], end_s=round(to_s, 3))
            if following is None or not following.joined:
                next_s = following.strokes[0].start_s if following else end_s + 3
                back_s = min(self._lasting(self.style.retraction_s), max(0.2, (next_s - to_s) * 0.55))
                phases.append(_span(to_s, to_s + back_s, "retraction"))
                rest = self.style.rests["near" if next_s - to_s < 3 else "medium" if next_s - to_s < 10 else "far"]
                units[-1] = replace(units[-1], end_s=round(to_s + back_s, 3), label=rest)
        yield Track("phases", tuple(phases))
        yield Track("phrases", tuple(phrases))
        yield Track("units", tuple(units))

    def _phrase(self, gesture: Gesture, start_s: float, end_s: float) -> TrackSpan:
        path = "curved" if self.rng.random() < self.style.curved else "straight"
        places = self.style.places
        attributes = {"hand": {"right": "RH", "left": "LH", "both": "2H"}[gesture.hand], "path": path}
        where = {"from": self.rng.choice(places), "to": self.rng.choice(places), "affiliate": str(gesture.word)}
        return replace(_span(start_s, end_s, gesture.lexeme), attributes={**attributes, **where})

    def _lasting(self, spread: tuple[float, float]) -> float:
        return max(0.15, self.rng.gauss(*spread))

    def _hand(self, lexeme: str) -> str:
        """The hand in use, or another of the style's; one that the table does not offer is never taken."""
        offered = {hand: weight for hand, weight in self.style.hands.items() if hand in self.offered[lexeme].forms}
        if self.hand not in offered or self.rng.random() > self.style.hand_kept:
            self.hand = self._drawn(offered)
        return self.hand

    def _lexemes(self, tag: str) -> Mapping[str, float]:
        return self.style.lexemes.get(tag.partition(".")[0], self.style.usual)

    def _drawn(self, weights: Mapping[str, float]) -> str:
        return self.rng.choices(list(weights), list(weights.values()))[0]

    def _heads(self, line: PerformedLine, shift_s: float) -> Iterator[TrackSpan]:
        for each in line.behaviors:
            if each.kind is Channel.HEAD and each.kept and each.priority and self.rng.random() < self.style.head_kept:
                yield _span(each.sync.start + shift_s, each.sync.end + shift_s, each.lexeme.lower())

    def _gaze(self, end_s: float) -> Iterator[TrackSpan]:
        """Looks at the listener and away in turns, by the style's share."""
        now_s, share = 0.0, self.style.at_listener
        while now_s < end_s:
            away_s = self.rng.uniform(0.4, 1.2)
            at_s = away_s * share / (1 - share)
            yield _span(now_s, now_s + at_s, "listener")
            yield _span(now_s + at_s, now_s + at_s + away_s, "away")
            now_s = round(now_s + at_s + away_s, 3)


def _strokes(line: PerformedLine) -> Iterator[tuple[int, str, float]]:
    """The words on which our own gestures strike, with the tag of what they show and their priority."""
    by_id = {each.id: each for each in line.functions}
    for each in line.behaviors:
        if each.kind is Channel.GESTURE and each.kept and each.sync.stroke_end is not None:
            begun = [word.index for word in line.words if time_of(word).start_s <= each.sync.stroke_end]
            function = by_id.get(each.function or "")
            if begun and function is not None:
                yield begun[-1], tag_of(function), each.priority


def _tags(line: PerformedLine, places: Mapping[int, int], words: Sequence[TrackSpan]) -> Iterator[TrackSpan]:
    for each in line.functions:
        own = [places[word] for word in range(each.first, each.last + 1) if word in places]
        if each.kept and own:
            yield _span(words[own[0]].start_s, words[own[-1]].end_s, tag_of(each))


def _strokes_and_holds(strokes: Sequence[Interval], to_s: float) -> Iterator[TrackSpan]:
    at_s = strokes[0].start_s
    for stroke in strokes:
        if stroke.start_s - at_s > 0.02:
            yield _span(at_s, stroke.start_s, "hold")
        yield _span(stroke.start_s, stroke.end_s, "stroke")
        at_s = stroke.end_s
    if to_s - at_s > 0.02:
        yield _span(at_s, to_s, "hold")


def _apart(spans: Sequence[TrackSpan]) -> Iterator[TrackSpan]:
    end_s = 0.0
    for span in sorted(spans, key=lambda each: each.start_s):
        if span.start_s >= end_s:
            yield span
            end_s = span.end_s


def _span(start_s: float, end_s: float, label: str) -> TrackSpan:
    return TrackSpan(round(start_s, 3), round(end_s, 3), label)


def _shifted(interval: Interval, shift_s: float, label: str) -> TrackSpan:
    return _span(interval.start_s + shift_s, interval.end_s + shift_s, label)


if __name__ == "__main__":
    main()
